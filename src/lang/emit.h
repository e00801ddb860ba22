/* emit.h - writes stack code, and makes it better while it is still at hand; internal to the compiler.
 *
 * An operand that is known when the text is compiled is marked as constant; an operation whose operands all are
 * is evaluated by the evaluator itself, and its code replaced by the result. Integers that will meet a real
 * become real, x*x becomes x**2, and a division by 2, 4, ... a multiplication.
 *
 * Code that does not fit is counted and not written: emit_is_full says so, and the caller gives up. */
#ifndef LANG_EMIT_H
#define LANG_EMIT_H

#include "lang/code.h"
#include "lang/names.h"

/* Operands that can still be folded; deeper ones just are not. */
#define EMIT_TRACKED 16

typedef struct emit {
    lang_t *l;
    uint8_t *buf;
    size_t size;
    uint32_t len; /* bytes of code, also those that did not fit */
    /* Operands on the evaluator's stack; a left side that a jump or comma has dropped keeps its place here until
     * the whole is known, so that the whole starts where the left side did. */
    int depth, deepest;
    struct {
        uint16_t start; /* where its code starts */
        bool constant;
        bool real;           /* cannot be an integer */
    } operand[EMIT_TRACKED]; /* operand[i] for depth i + 1 */
} emit_t;

/* Bytes that may be written: size, or less when buf is the free part of the pool, which shrinks as names are made. */
size_t emit_room(const emit_t *e);
static inline bool emit_is_full(const emit_t *e) {
    return e->len > emit_room(e);
}

/* An operation that does not change which operands there are, with 0, 1 or 2 bytes behind it. */
void emit_byte(emit_t *e, int op);
void emit_byte2(emit_t *e, int op, int a);
void emit_byte3(emit_t *e, int op, int a, int b);
/* Pushes a constant. */
void emit_constant(emit_t *e, value_t v);
/* Says that the code from start on pushes one operand that is not constant; real: it cannot be an integer. */
void emit_pushed(emit_t *e, uint32_t start, bool real);
/* Says that the operation just written takes the topmost n operands and leaves one. pure: if they are constant, so is
 * the result. */
void emit_operated(emit_t *e, int n, bool pure, bool real);
/* OP_ADD .. OP_BOR and OP_NEG .. OP_FACT, with all that can be known about their operands. */
void emit_binary(emit_t *e, uint8_t op);
void emit_unary(emit_t *e, uint8_t op);
/* A jump whose distance is not yet known; emit_patch makes it lead to the end of the code. */
uint16_t emit_jump(emit_t *e, int op);
void emit_patch(emit_t *e, uint16_t at);

#endif
