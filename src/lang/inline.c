/* inline.c - one call after the other, from the left, so that arguments contain no more calls. See inline.h. */
#include "lang/inline.h"
#include "lang/code.h"
#include "lang/hoist.h"
#include "lang/parts.h"

/* Values kept in all: with those that hoist.c adds they are numbered by a byte. */
#define KEPT_MAX 100
_Static_assert(EXPR_PARAMS + HOIST_MAX + KEPT_MAX + EXPR_PARAMS < 256, "slots are bytes");

typedef struct argument {
    const uint8_t *code;
    uint16_t len;
    bool leaf;
    uint8_t uses, used, slot;
} argument_t;

typedef struct call {
    uint16_t start, end; /* of the arguments and the call itself, in the code around it */
    const symbol_t *function;
    argument_t arg[EXPR_PARAMS];
    uint8_t slots; /* values that its body keeps, its arguments included */
} call_t;

static const uint8_t *body_of(const lang_t *l, const symbol_t *s) {
    return l->pool + s->u.code.start;
}

static bool is_argument(uint8_t op) {
    return op >= OP_ARG && op < OP_ARG + EXPR_PARAMS;
}

static bool keeps_value(const argument_t *a) {
    return !a->leaf && a->uses > 1;
}

static bool has_keep(const uint8_t *code, uint16_t len) {
    for (uint16_t at = 0; at < len; at = (uint16_t)(at + 1 + code_operands(code[at]))) {
        if (code[at] == OP_KEEP) return true;
    }
    return false;
}

/* The arguments of the call behind part `last`, from the last to the first; each ends where the next begins. */
static bool find_arguments(const uint8_t *code, const parts_t *p, int last, call_t *c) {
    uint16_t end = c->start;
    for (int k = c->function->params - 1; k >= 0; k--) {
        while (last >= 0 && p->end[last] != end) last--;
        if (last < 0) return false;
        uint16_t start = p->start[last];
        c->arg[k] = (argument_t){code + start, (uint16_t)(end - start), p->leaf[last], 0, 0, 0};
        /* What is kept in one argument may be used in another, and the body may have them in another order. */
        if (has_keep(code + start, (uint16_t)(end - start))) return false;
        end = start;
    }
    c->start = end;
    return true;
}

/* Counts how often each argument is used, and gives those that are kept their slots, from `slot` on. */
static bool count_uses(const lang_t *l, call_t *c, uint8_t slot) {
    const uint8_t *p = body_of(l, c->function), *end = p + c->function->u.code.len;
    c->slots = *p == OP_FRAME ? p[1] : 0;
    for (; p < end; p += 1 + code_operands(*p)) {
        if (!is_argument(*p)) continue;
        argument_t *a = &c->arg[*p - OP_ARG];
        if (a->uses < UINT8_MAX) a->uses++;
    }
    for (int k = 0; k < c->function->params; k++) {
        argument_t *a = &c->arg[k];
        if (a->uses == 0 && !(a->leaf && is_argument(a->code[0]))) return false; /* it might be undefined */
        if (keeps_value(a)) a->slot = (uint8_t)(slot + c->slots++);
    }
    return true;
}

/* Appends to the code at `to`; what does not fit is counted only. */
typedef struct writer {
    uint8_t *to;
    size_t len;
} writer_t;

static void put(writer_t *w, const uint8_t *from, size_t n) {
    if (w->len + n <= INLINE_CODE_MAX) memcpy(w->to + w->len, from, n);
    w->len += n;
}

static void put2(writer_t *w, int op, int operand) {
    put(w, (const uint8_t[]){(uint8_t)op, (uint8_t)operand}, 2);
}

static void put_argument(writer_t *w, argument_t *a) {
    if (keeps_value(a) && a->used) {
        put2(w, OP_LOCAL, a->slot);
        return;
    }
    put(w, a->code, a->len);
    if (keeps_value(a)) put2(w, OP_KEEP, a->slot);
    a->used = 1;
}

/* slot: where the values begin that the body itself keeps. */
static void put_body(writer_t *w, const lang_t *l, call_t *c, uint8_t slot) {
    const uint8_t *p = body_of(l, c->function), *end = p + c->function->u.code.len - 1; /* without OP_RET */
    if (*p == OP_FRAME) p += 2;
    while (p < end) {
        size_t n = 1u + (size_t)code_operands(*p);
        if (is_argument(*p))
            put_argument(w, &c->arg[*p - OP_ARG]);
        else if (*p == OP_KEEP || *p == OP_LOCAL)
            put2(w, *p, p[1] - c->function->params + slot);
        else
            put(w, p, n);
        p += n;
    }
}

/* Finds the first call; 0 if there is none, -1 if it cannot be replaced. */
static int find_call(const lang_t *l, const uint8_t *code, call_t *c) {
    parts_t p;
    if (!parts_find(code, true, &p)) return -1;
    for (int i = 0; i < p.n; i++) {
        uint16_t at = i ? p.end[i - 1] : 0;
        if (i == 0 || code[at] != OP_CALL) continue;
        const symbol_t *s = &l->symbol[code[at + 1]];
        if (!s->defined || s->kind != SYMBOL_FUNCTION || s->params != code[at + 2]) return -1;
        *c = (call_t){.start = at, .end = p.end[i], .function = s};
        return find_arguments(code, &p, i - 1, c) ? 1 : -1;
    }
    return 0;
}

bool inline_calls(const lang_t *l, expr_t *x, uint8_t *buf) {
    uint8_t *next = buf + INLINE_CODE_MAX;
    uint16_t stack = x->stack;
    call_t c;
    int found;
    writer_t w = {buf, 0};
    put(&w, x->code, x->len);
    while (w.len <= INLINE_CODE_MAX && (found = find_call(l, buf, &c)) > 0) {
        uint8_t kept = buf[0] == OP_FRAME ? buf[1] : 0, slot = (uint8_t)(x->params + kept);
        size_t head = buf[0] == OP_FRAME ? 2 : 0, old = w.len;
        uint32_t need = (uint32_t)stack + c.function->u.code.stack + EXPR_PARAMS;
        if (need > CONFIG_STACK || !count_uses(l, &c, slot) || kept + c.slots > KEPT_MAX) return false;
        stack = (uint16_t)need;
        w = (writer_t){next, 0};
        if (kept + c.slots) put2(&w, OP_FRAME, kept + c.slots);
        put(&w, buf + head, c.start - head);
        put_body(&w, l, &c, slot);
        put(&w, buf + c.end, old - c.end);
        if (w.len <= INLINE_CODE_MAX) memcpy(buf, next, w.len);
    }
    if (w.len > INLINE_CODE_MAX || found < 0) return false;
    x->code = buf;
    x->len = (uint16_t)w.len;
    x->stack = stack;
    return true;
}
