/* emit.c - see emit.h. */
#include "lang/emit.h"
#include "lang/expr.h"

size_t emit_room(const emit_t *e) {
    const uint8_t *names = e->l->pool + e->l->names_start;
    bool lent = e->buf >= e->l->pool && e->buf <= names;
    return lent && (size_t)(names - e->buf) < e->size ? (size_t)(names - e->buf) : e->size;
}

void emit_byte(emit_t *e, int byte) {
    if (e->len < emit_room(e)) e->buf[e->len] = (uint8_t)byte;
    e->len++;
}

void emit_byte2(emit_t *e, int op, int a) {
    emit_byte(e, op);
    emit_byte(e, a);
}

void emit_byte3(emit_t *e, int op, int a, int b) {
    emit_byte2(e, op, a);
    emit_byte(e, b);
}

static void put_bytes(emit_t *e, const void *bytes, size_t n) {
    for (size_t i = 0; i < n; i++) emit_byte(e, ((const uint8_t *)bytes)[i]);
}

/* Declares that code from start to the end pushes one operand. */
static void pushed(emit_t *e, uint32_t start, bool constant, bool real) {
    if (e->depth < EMIT_TRACKED) {
        e->operand[e->depth].start = (uint16_t)start;
        e->operand[e->depth].constant = constant;
        e->operand[e->depth].real = real;
    }
    e->depth++;
    if (e->depth > e->deepest) e->deepest = e->depth;
}

static bool is_constant(const emit_t *e, int from_top) {
    int i = e->depth - 1 - from_top;
    return i < EMIT_TRACKED && e->operand[i].constant;
}

static bool is_real(const emit_t *e, int from_top) {
    int i = e->depth - 1 - from_top;
    return i < EMIT_TRACKED && e->operand[i].real;
}

static void put_constant(emit_t *e, value_t v) {
    if (v.kind == VALUE_INT && v.m >= -128 && v.m < 128) {
        emit_byte2(e, OP_INT8, (int)v.m & 255);
    } else if (v.kind == VALUE_INT) {
        emit_byte(e, OP_INT64);
        put_bytes(e, &v.m, 8);
    } else if (((uint64_t)v.m & 0xFFFFFFFFFFFF) == 0 && v.e >= -128 && v.e < 128) {
        emit_byte2(e, OP_REAL_SHORT, (int)(v.m >> 48) & 255);
        emit_byte2(e, (int)(v.m >> 56) & 255, v.e & 255);
    } else {
        int16_t exponent = (int16_t)v.e;
        emit_byte(e, OP_REAL);
        put_bytes(e, &v.m, 8);
        put_bytes(e, &exponent, 2);
    }
}

void emit_constant(emit_t *e, value_t v) {
    uint32_t start = e->len;
    put_constant(e, v);
    pushed(e, start, true, v.kind == VALUE_REAL);
}

/* If one of the two topmost operands is an integer constant and the other surely real, makes the constant real now
 * and not at each evaluation. */
static void meet_real(emit_t *e) {
    int which = is_constant(e, 0) ? 0 : 1;
    if (!is_constant(e, which) || is_real(e, which) || !is_real(e, 1 - which)) return;
    uint8_t fresh[CODE_CONSTANT_MAX];
    if (e->len + sizeof fresh > emit_room(e)) return;
    uint32_t start = e->operand[e->depth - 1 - which].start;
    uint32_t end = which == 0 ? e->len : e->operand[e->depth - 1].start;
    uint32_t behind = e->len - end;
    const uint8_t *code = e->buf + start;
    value_t v = code[0] == OP_INT8 ? value_int(code_int8(code + 1)) : code_int64(code + 1);
    uint32_t scratch = e->len;
    put_constant(e, value_real(value_num(v)));
    uint32_t len = e->len - scratch;
    memcpy(fresh, e->buf + scratch, len);
    memmove(e->buf + start + len, e->buf + end, behind);
    memcpy(e->buf + start, fresh, len);
    e->len = start + len + behind;
    if (which == 1) e->operand[e->depth - 1].start = (uint16_t)(start + len);
}

void emit_pushed(emit_t *e, uint32_t start, bool real) {
    pushed(e, start, false, real);
}

void emit_operated(emit_t *e, int n, bool pure, bool real) {
    for (int i = 0; i < n; i++) pure = pure && is_constant(e, i);
    e->depth -= n;
    uint32_t start = e->depth < EMIT_TRACKED ? e->operand[e->depth].start : 0;
    if (pure && e->len < emit_room(e)) {
        e->buf[e->len] = OP_RET;
        expr_t x = {.code = e->buf + start, .stack = EXPR_PARAMS + 1};
        value_t v;
        if (expr_eval(e->l, &x, NULL, &v) == 0 && v.kind != VALUE_UNDEF) {
            e->len = start;
            emit_constant(e, v);
            return;
        }
    }
    pushed(e, start, false, real);
}

/* A power whose exponent is a small constant needs no second operand. */
static bool small_power(emit_t *e) {
    int i = e->depth - 1;
    if (!is_constant(e, 0) || emit_is_full(e)) return false;
    const uint8_t *code = e->buf + e->operand[i].start;
    if (code[0] != OP_INT8) return false;
    int k = code_int8(code + 1);
    e->len = e->operand[i].start;
    if (k == 2)
        emit_byte(e, OP_SQUARE);
    else
        emit_byte2(e, OP_POWI, k & 255);
    e->depth--;
    emit_operated(e, 1, true, is_real(e, 0));
    return true;
}

/* Division by a power of two is multiplication by another, exactly and sooner. */
static bool invert_constant(emit_t *e) {
    if (!is_constant(e, 0) || emit_is_full(e)) return false;
    uint8_t *code = e->buf + e->operand[e->depth - 1].start;
    if (code[0] != OP_REAL_SHORT || code_u16(code + 1) != 0x4000) return false;
    int exponent = code_int8(code + 3); /* of 2^62 * 2^exponent */
    if (exponent > 4) return false;     /* the short form would not hold the other's */
    code[3] = (uint8_t)(-124 - exponent);
    return true;
}

/* x*x is x**2: one operand less to fetch. */
static bool square(emit_t *e) {
    if (e->depth < 2 || e->depth > EMIT_TRACKED || emit_is_full(e)) return false;
    uint16_t left = e->operand[e->depth - 2].start, right = e->operand[e->depth - 1].start;
    size_t len = e->len - right;
    const uint8_t *code = e->buf + left;
    bool name = (len == 1 && code[0] >= OP_ARG && code[0] < OP_VAR) || (len == 2 && code[0] == OP_VAR);
    if (!name || (size_t)(right - left) != len || memcmp(code, e->buf + right, len) != 0) return false;
    e->len = right;
    emit_byte(e, OP_SQUARE);
    e->depth--;
    emit_operated(e, 1, false, is_real(e, 0));
    return true;
}

void emit_binary(emit_t *e, uint8_t op) {
    if (op == OP_POW && small_power(e)) return;
    if (op == OP_MUL && square(e)) return;
    if (op <= OP_DIV || (op >= OP_LT && op <= OP_NE)) meet_real(e);
    if (op == OP_DIV && invert_constant(e)) op = OP_MUL;
    emit_byte(e, op);
    emit_operated(e, 2, true, (op <= OP_DIV || op == OP_POW) && (is_real(e, 0) || is_real(e, 1)));
}

void emit_unary(emit_t *e, uint8_t op) {
    emit_byte(e, op);
    emit_operated(e, 1, true, op == OP_NEG && is_real(e, 0));
}

uint16_t emit_jump(emit_t *e, int op) {
    uint16_t at = (uint16_t)e->len;
    emit_byte3(e, op, 0, 0);
    return at;
}

void emit_patch(emit_t *e, uint16_t at) {
    uint32_t distance = e->len - at - CODE_JUMP_LEN;
    if (emit_is_full(e)) return;
    e->buf[at + 1] = (uint8_t)distance;
    e->buf[at + 2] = (uint8_t)(distance >> 8);
}
