/* eval_row.h - an expression at several points of a row at once: each operation is decoded once and done for all.
 *
 * For straight code (parts.h) as hoist.c makes it: what depends on the column or on the row alone is there already.
 * The values are those of expr_run, bit for bit, where each point's random numbers have seeds of their own; what is
 * rare is left to it. */
#ifndef EVAL_ROW_H
#define EVAL_ROW_H

#include "config.h"
#include "lang/expr.h"

#define EVAL_ROW_MAX CONFIG_ROW_POINTS
_Static_assert(EVAL_ROW_MAX >= 1 && EVAL_ROW_MAX <= 64, "one bit a point");

/* The values that code numbers 0, 1, 2 ...: x, y, those of the column, those of the row. */
typedef struct eval_row {
    const uint8_t *code;
    const value_t *column; /* of the first point: x and what depends on it; `stride` further on those of the next */
    int32_t stride;
    uint8_t per_column, per_row;
    const value_t *row; /* y and what depends on it */
    int32_t (*seed)[2]; /* of each point's random numbers; they go on */
} eval_row_t;

/* How many points at once, EVAL_ROW_MAX at the most; 0 if the code is not of that kind or the evaluator's stack, which
 * is used for values under way, is too small. */
uint8_t eval_row_width(const uint8_t *code);
/* Heights of n points, n within the width. False, and nothing is known: something is rare, an undefined variable or a
 * mistake; expr_run has to look at every point. */
bool eval_row(lang_t *l, const eval_row_t *r, int width, int n, num_t *out);

#endif
