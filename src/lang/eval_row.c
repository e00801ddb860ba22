/* eval_row.c - see eval_row.h.
 *
 * An operand is not moved: it is where it stands, and how far apart those of neighbouring points are. So values of
 * columns and rows cost nothing to load. Results lie on the evaluator's stack, cut into areas of `width` values and one
 * for a constant: first an area for each value kept, then one for each place of the stack of operands. */
#include "lang/eval_row.h"
#include "lang/arith.h"
#include "lang/builtins.h"
#include "lang/eval_row_arith.h"
#include "num/noise.h"
#include "num/num_fast.h"

#if EVAL_ROW_MAX > 1

enum { DEPTH = 12, LEAST = 4, ARGS = 8 };

static bool is_binary(uint8_t op) {
    return op >= OP_ADD && op <= OP_BOR;
}
static bool is_unary(uint8_t op) {
    return (op >= OP_NEG && op <= OP_POWI) || op == OP_REAL1 || op == OP_KEEP;
}
static bool is_leaf(uint8_t op) {
    return op < OP_SET || (op > OP_SET && op < OP_ADD) || op == OP_LOCAL;
}

uint8_t eval_row_width(const uint8_t *code) {
    int kept = code[0] == OP_FRAME ? code[1] : 0, depth = 0, most = 1;
    const uint8_t *p = code + (kept ? 2 : 0);
    for (; *p != OP_RET; p += 1 + code_operands(*p)) {
        if (*p == OP_FUNC && (BUILTINS[p[1]].flags & BUILTIN_TEXTS)) return 0;
        if (*p == OP_FUNC && p[2] <= ARGS)
            depth += 1 - p[2];
        else if (is_binary(*p))
            depth--;
        else if (is_leaf(*p))
            depth++;
        else if (!is_unary(*p))
            return 0;
        if (depth > most) most = depth;
    }
    const int width = CONFIG_STACK / (kept + most) - 1;
    if (most > DEPTH || width < LEAST) return 0;
    return (uint8_t)(width < EVAL_ROW_MAX ? width : EVAL_ROW_MAX);
}

void eval_row_slow(eval_row_work_t *w, int k, uint8_t op, const value_t *a, const value_t *b, value_t *to) {
    value_t v = *a;
    eval_row_note(w, k, arith_binary(op, &v, *b));
    *to = v;
}

static void binary(eval_row_work_t *w, uint8_t op, eval_row_operand_t a, eval_row_operand_t b, value_t *to) {
    if (op == OP_ADD || op == OP_SUB)
        eval_row_sum(w, op, a, b, to);
    else if (op == OP_MUL)
        eval_row_product(w, a, b, to);
    else if (op == OP_DIV)
        eval_row_quotient(w, a, b, to);
    else
        for (int k = 0; k < w->n; k++, a.at += a.step, b.at += b.step) eval_row_slow(w, k, op, a.at, b.at, to++);
}

static const char *unary_of(const uint8_t *pc, value_t *v) {
    if (*pc == OP_KEEP) return NULL;
    return *pc == OP_POWI ? arith_power(v, code_int8(pc + 1)) : arith_unary(*pc, v);
}

static __attribute__((noinline)) void unary(eval_row_work_t *w, const uint8_t *pc, eval_row_operand_t a, value_t *to) {
    for (int k = 0; k < w->n; k++, a.at += a.step, to++) {
        value_t v = *a.at;
        eval_row_note(w, k, unary_of(pc, &v));
        *to = v;
    }
}

static __attribute__((noinline)) void any_function(eval_row_work_t *w, lang_t *l, const uint8_t *pc,
                                                   const eval_row_operand_t *a, value_t *to) {
    for (int k = 0; k < w->n; k++) {
        value_t args[ARGS];
        for (int i = 0; i < pc[2]; i++) args[i] = a[i].at[k * a[i].step];
        eval_row_note(w, k, builtin_call(&BUILTINS[pc[1]], l, args, pc[2]));
        to[k] = args[0];
    }
}

/* rand(), which is mostly asked for the next number. */
static __attribute__((noinline)) void random_function(eval_row_work_t *w, lang_t *l, const uint8_t *pc,
                                                      int32_t (*seed)[2], eval_row_operand_t a, value_t *to) {
    for (int k = 0; k < w->n; k++, a.at += a.step, to++) {
        if (a.at->m == 0 && a.at->kind != VALUE_UNDEF) {
            eval_row_put(to, noise_next(seed[k]));
            continue;
        }
        memcpy(l->seed, seed[k], sizeof l->seed);
        value_t v = *a.at;
        eval_row_note(w, k, builtin_call(&BUILTINS[pc[1]], l, &v, 1));
        *to = v;
        memcpy(seed[k], l->seed, sizeof l->seed);
    }
}

/* The operand behind OP_LOCAL or OP_ARG. */
static eval_row_operand_t local(const eval_row_t *r, const value_t *area, int width, int i) {
    if (i == 0) return (eval_row_operand_t){r->column, r->stride};
    if (i == 1) return (eval_row_operand_t){r->row, 0};
    i -= 1; /* x and y are counted, the first of a column stands behind x */
    if (i <= r->per_column) return (eval_row_operand_t){r->column + i, r->stride};
    i -= r->per_column;
    if (i <= r->per_row) return (eval_row_operand_t){r->row + i, 0};
    return (eval_row_operand_t){area + (i - 1 - r->per_row) * (width + 1), 1};
}

/* A constant or a variable; false if that is not defined. */
static bool constant(const lang_t *l, const uint8_t *pc, value_t *to) {
    switch (*pc) {
    case OP_VAR:
        *to = l->symbol[pc[1]].u.value;
        return l->symbol[pc[1]].defined;
    case OP_INT8:
        *to = value_int(code_int8(pc + 1));
        return true;
    case OP_INT64:
        *to = code_int64(pc + 1);
        return true;
    case OP_REAL:
        *to = code_real(pc + 1);
        return true;
    default:
        *to = value_real(code_real_short(pc + 1));
        return true;
    }
}

bool eval_row(lang_t *l, const eval_row_t *r, int width, int n, num_t *out) {
    const uint8_t *pc = r->code;
    const int kept = pc[0] == OP_FRAME ? pc[1] : 0;
    if (kept) pc += 2;
    value_t *area = l->stack + kept * (width + 1); /* of the next operand */
    eval_row_operand_t stack[DEPTH], *top = stack; /* one behind the last */
    stack[0] = (eval_row_operand_t){area, 0};      /* the result is there, whatever the analyser thinks of code */
    eval_row_work_t w = {.n = n};
    for (; *pc != OP_RET && !w.failed; pc += 1 + code_operands(*pc)) {
        const uint8_t op = *pc;
        if (op == OP_LOCAL || op < OP_VAR) {
            *top++ = local(r, l->stack, width, op == OP_LOCAL ? pc[1] : op - OP_ARG);
            area += width + 1;
            continue;
        }
        if (is_leaf(op)) {
            if (!constant(l, pc, area + width)) return false;
            *top++ = (eval_row_operand_t){area + width, 0};
            area += width + 1;
            continue;
        }
        const int takes = is_binary(op) ? 2 : op == OP_FUNC ? pc[2] : 1;
        value_t *to = area - takes * (width + 1);
        top -= takes;
        if (op == OP_REAL1)
            eval_row_real(&w, BUILTINS[pc[1]].real1, top[0], to);
        else if (op == OP_FUNC && BUILTINS[pc[1]].flags & BUILTIN_IMPURE)
            random_function(&w, l, pc, r->seed, top[0], to);
        else if (op == OP_FUNC)
            any_function(&w, l, pc, top, to);
        else if (takes == 2)
            binary(&w, op, top[0], top[1], to);
        else if (op == OP_SQUARE)
            eval_row_product(&w, top[0], top[0], to);
        else if (op != OP_KEEP)
            unary(&w, pc, top[0], to);
        else { /* on the stack it stays where it was */
            unary(&w, pc, top[0], l->stack + (pc[1] - 2 - r->per_column - r->per_row) * (width + 1));
            top++;
            continue;
        }
        *top++ = (eval_row_operand_t){to, 1};
        area = to + width + 1;
    }
    if (w.failed) return false;
    const value_t *v = stack[0].at;
    for (int k = 0; k < n; k++, v += stack[0].step) {
        if (NUM_FAST_RARE(v->kind != VALUE_REAL || w.dead >> k & 1)) {
            if (CONFIG_CONTROL && v->kind == VALUE_TEXT) return false;
            out[k] = w.dead >> k & 1 ? num_undef() : value_num(*v);
        } else {
            out[k].m = v->m, out[k].e = v->e, out[k].undef = false;
        }
    }
    return true;
}

#endif
