/* arith.h - operators on values of any kind, as gnuplot has them; the cases that the evaluator's fast path does
 * not take.
 *
 * Integers wrap nowhere: what does not fit 64 bits is computed in reals. An undefined operand (NaN) makes an undefined
 * result and no complaint; comparisons with it are false. */
#ifndef ARITH_H
#define ARITH_H

#include "config.h"
#include "lang/code.h"

/* What a function below returns instead of NULL when operands that are defined have no result, as 1/0. Any other text
 * names a mistake. */
extern const char ARITH_UNDEFINED[];

/* A text becomes the number that it is; CONFIG_CONTROL. */
const char *arith_number_of_text(value_t *a);
/* Other values stay. */
static inline const char *arith_number(value_t *a) {
    return CONFIG_CONTROL && a->kind == VALUE_TEXT ? arith_number_of_text(a) : NULL;
}
/* *a = *a op b; op is OP_ADD .. OP_BOR. Returns NULL, ARITH_UNDEFINED, or what is wrong with an operand. */
const char *arith_binary(uint8_t op, value_t *a, value_t b);
/* *a = op *a; op is OP_NEG .. OP_SQUARE. */
const char *arith_unary(uint8_t op, value_t *a);
/* *a = *a ** k. */
const char *arith_power(value_t *a, int32_t k);
/* *truth = v != 0; a real is a mistake here, as in gnuplot. */
const char *arith_truth(value_t v, bool *truth);
/* Stores an integer result of a, which is a whole number; undefined (gnuplot's NaN) when 64 bits do not hold it. */
value_t arith_whole(num_t a);

#endif
