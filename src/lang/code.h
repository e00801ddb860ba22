/* code.h - the stack code that expressions are compiled to; internal to compile.c and eval.c.
 *
 * One byte of operation, then its operands, unaligned. Jumps are forward and relative to the byte behind them, so
 * code may be moved. `top` is the value pushed last. */
#ifndef CODE_H
#define CODE_H

#include "lang/value.h"

enum code_op {
    OP_RET,              /* the call, or the expression, is done; its value is top */
    OP_ARG,              /* OP_ARG + i pushes argument i, i < EXPR_PARAMS */
    OP_VAR = OP_ARG + 8, /* symbol: pushes a variable */
    OP_SET,              /* symbol: a variable becomes top, which stays */
    OP_INT8,             /* value: pushes a small integer */
    OP_INT64,            /* 8 bytes */
    OP_REAL,             /* significand in 8 bytes, exponent in 2 */
    OP_REAL_SHORT, /* the upper 16 bits of the significand, the others being 0, and the exponent in 1 byte: 2.0, 0.25 */
    OP_ADD,        /* from here to OP_BOR: two operands, one result; the order is that of arith.c */
    OP_SUB,
    OP_MUL,
    OP_DIV,
    OP_MOD,
    OP_POW,
    OP_SHL,
    OP_SHR,
    OP_LT,
    OP_LE,
    OP_GT,
    OP_GE,
    OP_EQ,
    OP_NE,
    OP_BAND,
    OP_XOR,
    OP_BOR,
    OP_NEG, /* from here to OP_SQUARE: one operand */
    OP_NOT,
    OP_BNOT,
    OP_FACT,
    OP_SQUARE,
    OP_POWI,  /* exponent in 1 byte: a power known when the text was compiled */
    OP_POP,   /* drops top */
    OP_JUMP,  /* distance in 2 bytes */
    OP_JZ,    /* distance: drops top and jumps if it was 0 */
    OP_AND,   /* distance: jumps over the right side if top is 0, leaving 0; drops top otherwise */
    OP_OR,    /* distance: likewise if it is not 0, leaving 1 */
    OP_BOOL,  /* top becomes 0 or 1 */
    OP_REAL1, /* builtin: a function of one real number */
    OP_FUNC,  /* builtin, count of arguments: any other */
    OP_FRAME, /* count: makes room for that many values kept; stands first */
    OP_KEEP,  /* index: keeps top, which stays, as base[index] */
    OP_LOCAL, /* index: pushes base[index] */
    OP_CALL,  /* symbol, count of arguments: a user's function */
};

enum { CODE_JUMP_LEN = 3, CODE_CONSTANT_MAX = 11 };

/* Bytes of operands behind an operation. */
static inline int code_operands(uint8_t op) {
    switch (op) {
    case OP_INT64:
        return 8;
    case OP_REAL:
        return 10;
    case OP_REAL_SHORT:
        return 3;
    case OP_JUMP:
    case OP_JZ:
    case OP_AND:
    case OP_OR:
    case OP_FUNC:
    case OP_CALL:
        return 2;
    case OP_VAR:
    case OP_SET:
    case OP_INT8:
    case OP_POWI:
    case OP_REAL1:
    case OP_FRAME:
    case OP_KEEP:
    case OP_LOCAL:
        return 1;
    default:
        return 0;
    }
}

static inline int code_int8(const uint8_t *p) {
    return *p < 128 ? *p : *p - 256;
}
static inline uint16_t code_u16(const uint8_t *p) {
    return (uint16_t)(p[0] | p[1] << 8);
}

/* The constant behind OP_INT64 or OP_REAL. Host and boards are little-endian or not: code never leaves the machine. */
static inline value_t code_int64(const uint8_t *p) {
    value_t v = {0, 0, VALUE_INT};
    memcpy(&v.m, p, 8);
    return v;
}
static inline value_t code_real(const uint8_t *p) {
    value_t v = {0, 0, VALUE_REAL};
    int16_t e; /* |e| < NUM_EXP_LIMIT + 64 */
    memcpy(&v.m, p, 8);
    memcpy(&e, p + 8, 2);
    v.e = e;
    return v;
}
static inline num_t code_real_short(const uint8_t *p) {
    return (num_t){(int64_t)((uint64_t)code_u16(p) << 48), code_int8(p + 2), false};
}

#endif
