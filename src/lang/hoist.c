/* hoist.c - see hoist.h.
 *
 * The largest parts that mention only one variable are found in the code from its end to its start, and moved. All
 * three pieces of code number the evaluator's stack alike: x, y, values of the column, of the row, then those that
 * share.c keeps, so a part that keeps a value takes it along. A kept value that several pieces need becomes a value of
 * the column or row itself. */
#include "lang/hoist.h"
#include "lang/code.h"
#include "lang/inline.h"
#include "lang/parts.h"
#include "num/noise.h"

enum { OF_X = 1, OF_Y = 2, OF_BOTH = 3, FIRST = 2 /* slot behind x and y */ };

typedef struct moved {
    uint16_t start, end;
    uint8_t of;   /* OF_X or OF_Y */
    uint8_t slot; /* where its value will be */
    bool keeps;   /* its last operation is OP_KEEP */
} moved_t;

typedef struct plan {
    const uint8_t *code;
    parts_t parts;
    uint8_t of[PARTS_MAX]; /* what each part depends on; 0: nothing, as a*2 with a variable a */
    moved_t moved[HOIST_MAX * 2];
    int n; /* from the end of the code to its start */
    uint8_t per_column, per_row;
} plan_t;

static bool keeps(const plan_t *p, int i) {
    const uint8_t *op = p->code + p->parts.end[i] - 2;
    return !p->parts.leaf[i] && *op == OP_KEEP && p->parts.end[i] - p->parts.end[i - 1] == 2;
}

/* What part i depends on: all that stands in it. */
static uint8_t depends(const plan_t *p, int i) {
    const uint8_t *op = p->code + p->parts.start[i];
    uint8_t of = 0;
    if (p->parts.leaf[i]) {
        if (*op == OP_ARG || *op == OP_ARG + 1) of = *op == OP_ARG ? OF_X : OF_Y;
        for (int k = 0; *op == OP_LOCAL && k < i; k++) { /* as what it loads */
            if (keeps(p, k) && p->code[p->parts.end[k] - 1] == op[1]) of = p->of[k];
        }
        return of;
    }
    for (int k = i - 1; k >= 0 && p->parts.start[k] >= p->parts.start[i]; k--) of |= p->of[k];
    return keeps(p, i) && of == 0 ? OF_Y : of; /* so that it is known where a kept value is */
}

static size_t length(const moved_t *m) {
    return (size_t)(m->end - m->start);
}

/* Has `later` the value of a: does it load what a keeps, or read alike? */
static bool same(const plan_t *p, const moved_t *a, const moved_t *later) {
    const uint8_t *code = p->code + a->start, *other = p->code + later->start;
    if (a->of != later->of) return false;
    if (a->keeps && length(later) == 2 && other[0] == OP_LOCAL) return p->code[a->end - 1] == other[1];
    return length(a) == length(later) && memcmp(code, other, length(a)) == 0;
}

/* False if there are too many. */
static bool find_moved(plan_t *p) {
    uint8_t count[OF_BOTH] = {0};
    for (int i = 0; i < p->parts.n; i++) p->of[i] = depends(p, i);
    for (int i = p->parts.n - 1; i >= 0;) {
        uint16_t start = p->parts.start[i];
        bool moves = p->of[i] != OF_BOTH && (!p->parts.leaf[i] || p->code[start] == OP_LOCAL);
        if (!moves) {
            i--;
            continue;
        }
        if (p->n == HOIST_MAX * 2) return false;
        moved_t *m = &p->moved[p->n];
        *m = (moved_t){start, p->parts.end[i], p->of[i] == OF_X ? OF_X : OF_Y, UINT8_MAX, keeps(p, i)};
        for (int k = 0; k < p->n && m->slot == UINT8_MAX; k++) {
            if (same(p, m, &p->moved[k])) m->slot = p->moved[k].slot;
        }
        if (m->slot == UINT8_MAX) m->slot = count[m->of]++;
        p->n++;
        while (i >= 0 && p->parts.start[i] >= start) i--;
    }
    p->per_column = count[OF_X];
    p->per_row = count[OF_Y];
    for (int k = 0; k < p->n; k++)
        p->moved[k].slot = (uint8_t)(p->moved[k].slot + FIRST + (p->moved[k].of == OF_Y ? p->per_column : 0));
    return p->per_column + p->per_row <= HOIST_MAX;
}

/* Copies code; values kept move behind those of column and row. */
static uint8_t *copy(uint8_t *to, const uint8_t *from, const uint8_t *end, int by) {
    while (from < end) {
        size_t n = 1u + (size_t)code_operands(*from);
        memcpy(to, from, n);
        if (*from == OP_KEEP || *from == OP_LOCAL) to[1] = (uint8_t)(to[1] + by);
        to += n;
        from += n;
    }
    return to;
}

static uint8_t *put2(uint8_t *to, int op, int operand) {
    *to++ = (uint8_t)op;
    *to++ = (uint8_t)operand;
    return to;
}

/* The code of all that depends on `of`: each value goes to its slot. */
static uint8_t *write_moved(const plan_t *p, uint8_t of, int kept, uint8_t *to) {
    int values = p->per_column + p->per_row;
    to = put2(to, OP_FRAME, values + kept);
    for (int k = p->n - 1; k >= 0; k--) {
        if (p->moved[k].of != of) continue;
        bool again = false; /* of equal ones the first keeps what others load */
        for (int i = p->n - 1; i > k; i--) again = again || p->moved[i].slot == p->moved[k].slot;
        if (again) continue;
        to = copy(to, p->code + p->moved[k].start, p->code + p->moved[k].end, values);
        to = put2(to, OP_KEEP, p->moved[k].slot);
        *to++ = OP_POP;
    }
    *to++ = OP_RET;
    return to;
}

static uint8_t *write_point(const plan_t *p, int kept, uint16_t len, uint8_t *to) {
    int values = p->per_column + p->per_row;
    const uint8_t *from = p->code + (kept ? 2 : 0);
    if (kept) to = put2(to, OP_FRAME, kept);
    for (int k = p->n - 1; k >= 0; k--) {
        to = copy(to, from, p->code + p->moved[k].start, values);
        to = put2(to, OP_LOCAL, p->moved[k].slot);
        from = p->code + p->moved[k].end;
    }
    return copy(to, from, p->code + len, values);
}

/* Frames and ends of the two new pieces; and for each part moved a load, and that it is kept and dropped. */
static size_t code_bytes(const plan_t *p, uint16_t len) {
    return (size_t)len + 2 * 4 + (size_t)p->n * 5;
}

static void take_apart(hoist_t *h, const plan_t *p, const expr_t *x, uint8_t *code) {
    int kept = x->code[0] == OP_FRAME ? x->code[1] : 0, values = p->per_column + p->per_row;
    expr_t *piece[3] = {&h->column, &h->row, &h->point};
    for (int k = 0; k < 3; k++) {
        uint8_t *end = k == 2 ? write_point(p, kept, x->len, code) : write_moved(p, k == 0 ? OF_X : OF_Y, kept, code);
        *piece[k] = (expr_t){.code = code, .len = (uint16_t)(end - code), .params = FIRST};
        piece[k]->stack = (uint16_t)(x->stack + values);
        code = end;
    }
    h->point.params = (uint8_t)(FIRST + values);
    h->per_column = p->per_column;
    h->per_row = p->per_row;
}

#define INLINE_WORTH (8 * INLINE_CODE_MAX) /* bytes lent below which calls are not replaced: most are for the table */

/* The memory of hoist_init: the result, code with its calls replaced, the three pieces' code, the table. */
size_t hoist_init(lang_t *lang, const expr_t *x, const int32_t seed[2], int32_t columns, void *mem, size_t bytes) {
    hoist_t *h = mem;
    const bool pure = seed == NULL;
    expr_t flat = *x;
    size_t used = sizeof *h;
    if (INLINE_CALLS && pure && inline_is_call(x) && bytes >= INLINE_WORTH &&
        inline_calls(lang, &flat, (uint8_t *)mem + used))
        used += (flat.len + 7u) / 8 * 8;
    plan_t p = {.code = flat.code};
    bool apart = pure && parts_find(flat.code, true, &p.parts) && find_moved(&p) && p.n > 0 &&
                 flat.stack + p.per_column + p.per_row <= CONFIG_STACK;
    size_t code = apart ? (code_bytes(&p, flat.len) + 7) / 8 * 8 : 0;
    const int stride = 1 + (apart ? p.per_column : 0) + (pure ? 0 : 1);
    size_t table = (size_t)columns * (size_t)stride * sizeof(value_t);
    if (used + code + table > bytes) return 0;
    *h = (hoist_t){.lang = lang, .point = *x, .table = (value_t *)(void *)((uint8_t *)mem + used + code)};
    h->stride = (uint8_t)stride;
    h->random = !pure;
    if (!pure) memcpy(h->seed, seed, sizeof h->seed);
    for (int32_t i = 0; i < columns; i++) h->table[i * stride].kind = VALUE_UNDEF;
    h->of_row[0].kind = VALUE_UNDEF;
    if (apart) take_apart(h, &p, &flat, (uint8_t *)mem + used);
    if (EVAL_ROW_MAX > 1) h->width = eval_row_width(h->point.code);
    return used + code + table;
}

/* Runs a column's or row's part for v, x or y; its values, from `slot` on, and v go to out. */
static int run(hoist_t *h, const expr_t *part, num_t v, int slot, int n, value_t *out) {
    out[0] = (value_t){v.m, v.e, VALUE_REAL};
    if (n == 0) return 0;
    h->lang->stack[0] = h->lang->stack[1] = out[0];
    value_t last;
    int err = expr_run(h->lang, part, &last);
    if (err || h->lang->fault.code) out[0].kind = VALUE_UNDEF;
    for (int k = 0; k < n; k++) out[1 + k] = h->lang->stack[slot + k];
    return err;
}

int hoist_column(hoist_t *h, int32_t i, num_t x) {
    value_t *column = &h->table[i * h->stride];
    if (h->random) column[1 + h->per_column] = value_int((int64_t)noise_at(noise_hash(h->seed), x));
    int err = run(h, &h->column, x, FIRST, h->per_column, column);
    if (EVAL_ROW_MAX > 1) h->column_dead |= column->kind == VALUE_UNDEF;
    return err;
}

int hoist_row(hoist_t *h, num_t y) {
    int err = run(h, &h->row, y, FIRST + h->per_column, h->per_row, h->of_row);
    h->row_dead = h->of_row[0].kind == VALUE_UNDEF;
    return err;
}

/* The hash of a point in the last row. */
static uint64_t hash_of(const hoist_t *h, const value_t *column) {
    const value_t *y = &h->of_row[0];
    return noise_at((uint64_t)column[1 + h->per_column].m, (num_t){y->m, y->e, false});
}

/* Done before an expression is run, so that nothing of it is on the stack then. */
static __attribute__((noinline)) void seed_point(const hoist_t *h, const value_t *column) {
    noise_seeds(hash_of(h, column), h->lang->seed);
}

int hoist_point(const hoist_t *h, int32_t i, value_t *out) {
    const value_t *column = &h->table[i * h->stride];
    if (h->row_dead || column->kind == VALUE_UNDEF) {
        *out = value_undef();
        return 0;
    }
    value_t *to = h->lang->stack;
    if (h->random) seed_point(h, column);
    to[0] = *column++;
    to[1] = h->of_row[0];
    to += FIRST;
    for (int k = 0; k < h->per_column; k++) *to++ = *column++;
    for (int k = 1; k <= h->per_row; k++) *to++ = h->of_row[k];
    return expr_run(h->lang, &h->point, out);
}

int hoist_points(const hoist_t *h, int32_t i, int n, num_t *out) {
    const bool at_once = EVAL_ROW_MAX > 1 && h->width > 0 && !h->row_dead && !h->column_dead;
    int err = 0;
    for (int done = 0, some; done < n; done += some) {
        some = !at_once ? 1 : n - done < h->width ? n - done : h->width;
        const value_t *column = &h->table[(i + done) * h->stride];
        int32_t seed[EVAL_ROW_MAX][2];
        for (int k = 0; at_once && h->random && k < some; k++) noise_seeds(hash_of(h, column + k * h->stride), seed[k]);
        const eval_row_t row = {h->point.code, column, h->stride, h->per_column, h->per_row, h->of_row, seed};
        if (at_once && eval_row(h->lang, &row, h->width, some, out + done)) continue;
        for (int k = done; k < done + some; k++) {
            value_t v;
            int failed = hoist_point(h, i + k, &v);
            if (CONFIG_CONTROL && v.kind == VALUE_TEXT) failed = ERR_VALUE; /* as of a point alone */
            if (!err) err = failed;
            out[k] = value_num(v);
        }
    }
    return err;
}
