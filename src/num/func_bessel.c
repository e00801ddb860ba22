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

/* Hankel's P and x Q belong to s + c and s - c because chi is a multiple of pi/4 off the argument; these are turned
 * round for J1. Apart from outer(), so that its frame is not on the stack while sines are computed. */
static __attribute__((noinline)) num_t outer_sum(num_t x, const num_t *sine, const num_t *cosine, bool one) {
    num_t part = num_div(num_from_i64(8), x);
    const int64_t t = num_to_fixed(num_mul(part, part), 63, NULL) - ((int64_t)1 << 62);
    const num_t plus = num_add(*sine, *cosine), minus = num_sub(*sine, *cosine);
    num_t q = num_div(one ? FUNC_CHEBYSHEV(func_tables_q1, t) : FUNC_CHEBYSHEV(func_tables_q0, t), x);
    q = num_mul(q, one ? plus : num_neg(minus));
    part = num_mul(one ? FUNC_CHEBYSHEV(func_tables_p1, t) : FUNC_CHEBYSHEV(func_tables_p0, t), one ? minus : plus);
    part = num_add(part, q);
    q = num_div(num_from_i64(1), num_sqrt(num_mul(func_pi(), x)));
    return num_mul(q, part);
}

static __attribute__((noinline)) num_t outer(num_t x, bool one) {
    num_t s, c;
    func_sincos(x, &s, &c);
    return outer_sum(x, &s, &c, one);
}

static bool is_inner(num_t x) {
    return num_cmp(x, num_from_i64(8)) <= 0;
}

num_t func_besj0(num_t a) {
    if (a.m == 0) return a.undef ? a : num_from_i64(1);
    const num_t x = num_abs(a);
    return is_inner(x) ? FUNC_CHEBYSHEV(func_tables_j0, inner_argument(x)) : outer(x, false);
}

static __attribute__((noinline)) num_t inner_j1(num_t x) {
    return num_mul(x, FUNC_CHEBYSHEV(func_tables_j1, inner_argument(x)));
}

num_t func_besj1(num_t a) {
    if (a.m == 0) return a;
    num_t r = num_abs(a);
    r = is_inner(r) ? inner_j1(r) : outer(r, true);
    return a.m < 0 ? num_neg(r) : r;
}
