/* The Bessel functions J0 and J1.
 *
 * Up to 8, Chebyshev sums in x^2; from there amplitude and phase, Hankel's expansion in its Chebyshev form,
 * where the phase is the argument itself: sin and cos are exact to 2^-55 at any size. Errors are relative
 * to the amplitude, so at a zero of the function the absolute error is what is small. */
#include <stddef.h>

#include "num/func.h"
#include "num/func_inner.h"
#include "num/func_tables.h"

/* x^2/32 - 1 in Q62 for 0 <= x <= 8. */
static int64_t inner_argument(num_t x) {
    return num_to_fixed(num_mul(x, x), 57, NULL) - ((int64_t)1 << 62);
}

/* Hankel's P and x Q belong to s + c and s - c because chi is a multiple of pi/4 off the argument. */
typedef struct outer {
    num_t plus, minus; /* sin x + cos x, sin x - cos x */
    num_t scale;       /* 1 / sqrt(pi x) */
    int64_t t;         /* 2 (8/x)^2 - 1 in Q62 */
} outer_t;

static outer_t outer_argument(num_t x) {
    num_t s, c, w = num_div(num_from_i64(8), x);
    func_sincos(x, &s, &c);
    return (outer_t){num_add(s, c), num_sub(s, c), num_div(num_from_i64(1), num_sqrt(num_mul(func_pi(), x))),
                     num_to_fixed(num_mul(w, w), 63, NULL) - ((int64_t)1 << 62)};
}

static bool is_inner(num_t x) {
    return num_cmp(x, num_from_i64(8)) <= 0;
}

num_t func_besj0(num_t a) {
    if (a.m == 0) return a.undef ? a : num_from_i64(1);
    num_t x = num_abs(a);
    if (is_inner(x)) return FUNC_CHEBYSHEV(func_tables_j0, inner_argument(x));
    outer_t o = outer_argument(x);
    num_t q = num_div(FUNC_CHEBYSHEV(func_tables_q0, o.t), x);
    return num_mul(o.scale, num_sub(num_mul(FUNC_CHEBYSHEV(func_tables_p0, o.t), o.plus), num_mul(q, o.minus)));
}

num_t func_besj1(num_t a) {
    if (a.m == 0) return a;
    num_t x = num_abs(a);
    if (is_inner(x)) return num_mul(a, FUNC_CHEBYSHEV(func_tables_j1, inner_argument(x)));
    outer_t o = outer_argument(x);
    num_t q = num_div(FUNC_CHEBYSHEV(func_tables_q1, o.t), x);
    num_t r = num_mul(o.scale, num_add(num_mul(FUNC_CHEBYSHEV(func_tables_p1, o.t), o.minus), num_mul(q, o.plus)));
    return a.m < 0 ? num_neg(r) : r;
}
