/* hoist.h - an expression of x and y on a grid: what depends on only one of them is evaluated once for each column and
 * once for each row.
 *
 *     exp(-x**2-y**2)  ->  column: -x**2    row: y**2    point: exp(column - row)
 *
 * The values are those of expr_eval, bit for bit: the same operations with the same operands, done elsewhere. Only
 * straight code (parts.h) is taken apart; other expressions, and parts beyond HOIST_MAX, are evaluated as they are,
 * and still find the abscissae of the grid in the table. Random numbers start anew at every point, from a hash of x
 * and y (num/noise.h), of which the column's half is in the table, too. */
#ifndef HOIST_H
#define HOIST_H

#include "lang/eval_row.h"

#define HOIST_MAX (CONFIG_PARTS / 8 < 120 ? CONFIG_PARTS / 8 : 120) /* values of a column and a row together */

typedef struct hoist {
    lang_t *lang;
    expr_t column, row, point; /* column and row leave their values on the evaluator's stack, behind x and y */
    uint8_t per_column, per_row;
    uint8_t stride; /* of the table: x, and what belongs to it */
    bool random;
    bool anywhere;    /* the owner's: the only column is that of the place asked for last */
    bool row_dead;    /* the row's part is undefined, so are all its points */
    bool column_dead; /* so is one of the columns' */
    uint8_t width;    /* points that can be evaluated at once, 0: one by one */
    int32_t seed[2];  /* of all random numbers */
    value_t *table;   /* of each column: x, its values, and a hash as an integer where numbers are random */
    value_t of_row[1 + HOIST_MAX]; /* y, and the row's values */
} hoist_t;

/* Takes x apart for so many columns. seed: NULL if the expression's value depends on its arguments only
 * (expr_is_impure); it stays whole otherwise. Everything lies in mem (aligned to 8; lang, x and mem are used as long as
 * the result is). Returns the bytes used, the result being at mem, or 0 when bytes are too few. */
size_t hoist_init(lang_t *lang, const expr_t *x, const int32_t seed[2], int32_t columns, void *mem, size_t bytes);
/* Evaluates a column's or a row's part; each point's must have been. Returns as expr_eval does. */
int hoist_column(hoist_t *h, int32_t i, num_t x);
int hoist_row(hoist_t *h, num_t y);
/* The expression at column i of the last row. */
int hoist_point(const hoist_t *h, int32_t i, value_t *out);
/* Heights of columns i to i + n - 1 in the last row; each as hoist_point gives it. */
int hoist_points(const hoist_t *h, int32_t i, int n, num_t *out);

/* Has this column, or row, been evaluated last? An undefined one has not, and all are undefined at first. */
static inline bool hoist_is(const value_t *last, num_t v) {
    return last->kind == VALUE_REAL && last->m == v.m && last->e == v.e && !v.undef;
}
static inline bool hoist_has_column(const hoist_t *h, int32_t i, num_t x) {
    return hoist_is(&h->table[i * h->stride], x);
}
static inline bool hoist_has_row(const hoist_t *h, num_t y) {
    return hoist_is(&h->of_row[0], y);
}

static inline num_t hoist_x(const hoist_t *h, int32_t i) {
    const value_t *x = &h->table[i * h->stride];
    return (num_t){x->m, x->e, false};
}

#endif
