/* erf and the normal distribution.
 *
 * Below 1, erf(x) = x times a Chebyshev sum in x^2. From 1 on, erfc(x) = exp(-x^2) / (x + 5/2) times one in
 * 1 / (x + 5/2), so that the tail keeps its relative accuracy however small it is. (The variable is that of
 * J. L. Schonfelder, "Chebyshev expansions for the error and related functions", Math. Comp. 32, 1978.) */
#include <stddef.h>

#include "num/func.h"
#include "num/func_inner.h"
#include "num/func_tables.h"

/* erf(x) for |x| < 1. */
static num_t erf_inner(num_t x) {
    int64_t z = num_to_fixed(num_mul(x, x), 62, NULL);
    return num_mul(x, FUNC_CHEBYSHEV(func_tables_erf, 2 * z - ((int64_t)1 << 62)));
}

static __attribute__((noinline)) num_t outer_variable(num_t x) {
    return num_div(num_from_i64(1), num_add(x, num_from_fixed(5, 1)));
}

/* erfc(x) for x >= 1; w is its outer_variable and exp_x2 exp(-x^2), by the caller: exp() magnifies the rounding of
 * x^2, and both take stack. */
static __attribute__((noinline)) num_t erfc_outer(num_t w, const num_t *exp_x2) {
    int64_t t = ((int64_t)1 << 62) - num_to_fixed(num_mul(w, num_from_i64(7)), 62, NULL);
    return num_mul(num_mul(*exp_x2, w), FUNC_CHEBYSHEV(func_tables_erfc, t));
}

num_t func_erf(num_t a) {
    if (a.m == 0) return a;
    num_t x = num_abs(a), one = num_from_i64(1), r = one;
    if (x.e < -62) return erf_inner(a);
    if (x.e < -59) { /* from 8 on it is 1 to 2^-95 */
        r = func_exp(num_neg(num_mul(x, x)));
        r = num_sub(one, erfc_outer(outer_variable(x), &r));
    }
    return a.m < 0 ? num_neg(r) : r;
}

static __attribute__((noinline)) num_t root_of_half(num_t a) {
    return num_mul(num_abs(a), num_sqrt(num_from_fixed(1, 1)));
}

static __attribute__((noinline)) num_t erfc_inner(num_t x) {
    return num_sub(num_from_i64(1), erf_inner(x));
}

num_t func_exp_half_square(num_t a, bool negative) {
    a = num_ldexp(num_mul(a, a), -1);
    return func_exp(negative ? num_neg(a) : a);
}

/* The integral's tail beyond a. */
static __attribute__((noinline)) num_t tail(num_t a) {
    const num_t exp_x2 = func_exp_half_square(a, true), x = root_of_half(a);
    if (x.m == 0 || x.e < -62) return erfc_inner(x);
    if (x.e > -57) return num_from_i64(0); /* x >= 64: below 2^-5900 */
    return erfc_outer(outer_variable(x), &exp_x2);
}

num_t func_norm(num_t a) {
    if (a.undef) return a;
    const num_t r = num_ldexp(tail(a), -1);
    return a.m < 0 ? r : num_sub(num_from_i64(1), r);
}
