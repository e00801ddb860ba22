/* expr_surface.h - a compiled expression of x and y (or of x) as a surface (or a curve).
 *
 * Points lie at lo + i * step, step = (hi - lo) / (n - 1), rounded as doubles are, so that a hole or a step of the
 * function meets the same grid lines as in gnuplot; the ends are lo and hi exactly. Nothing is stored: a height is
 * computed whenever it is asked for. To give the same height each time, in any order, rand() inside the expression
 * starts anew at every point, from a hash of the plot's seed and of x and y: noise is a function of the place. The same
 * place has the same height on another grid too.
 *
 * An evaluation error that no compiler can see (a name that is defined nowhere, recursion that never ends) makes a hole
 * and is kept in `error` of the source: look at it after drawing. */
#ifndef EXPR_SURFACE_H
#define EXPR_SURFACE_H

#include "lang/hoist.h"
#include "scene/curve.h"
#include "scene/surface.h"

typedef struct expr_source {
    lang_t *lang;
    expr_t expr;     /* of 2 parameters for a surface, 1 for a curve */
    bool random;     /* uses rand() */
    int32_t seed[2]; /* of this plot */
    int error;       /* the first error of an evaluation, or 0; details: expr_fault() at once */
} expr_source_t;

/* One way of sampling a source. */
typedef struct expr_grid {
    expr_source_t *source;
    num_t lo[2], hi[2], step[2];
    int32_t n[2];
    int32_t row; /* whose y is row_y, or -1 */
    num_t row_y;
    hoist_t *hoist; /* in lent memory, or NULL */
} expr_grid_t;

/* expr, lang and its code are used as long as the source is. */
void expr_surface_source(expr_source_t *s, lang_t *lang, const expr_t *expr);
/* k = 0: x, 1: y; n[k] >= 2. Returns 0, or ERR_VALUE unless lo[k] < hi[k] are far enough apart for n[k] different
 * doubles. g and source outlive out. */
int expr_surface_grid(expr_grid_t *g, expr_source_t *source, const num_t lo[2], const num_t hi[2], const int32_t n[2],
                      surface_t *out);
/* The height anywhere; ctx is the expr_grid_t, as in the surface. With memory lent what depends on x or y alone is not
 * evaluated again while that stays. */
extern const surface_anywhere_t EXPR_SURFACE_ANYWHERE;
/* As expr_surface_grid for an expression of x. */
int expr_surface_curve(expr_grid_t *g, expr_source_t *source, num_t lo, num_t hi, int32_t n, curve_t *out);

#endif
