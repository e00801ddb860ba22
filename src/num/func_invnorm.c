/* The inverse of the normal distribution's integral.
 *
 * Abramowitz and Stegun 26.2.23 gives three digits; two steps of Halley's method on func_norm, which is accurate
 * relative to its value in the lower tail, make them nine and then all: with e = (norm(x) - p) / norm'(x) a step is
 * x - e / (1 + x e / 2), and its error grows with the third power. */
#include "num/func.h"
#include "num/func_inner.h"

/* x <= 0 for p <= 1/2, t = sqrt(-2 log p). */
static __attribute__((noinline)) num_t first_guess(num_t t) {
    num_t top = num_from_decimal(10328, -6), bottom = num_from_decimal(1308, -6);
    top = num_add(num_mul(top, t), num_from_decimal(802853, -6));
    top = num_add(num_mul(top, t), num_from_decimal(2515517, -6));
    bottom = num_add(num_mul(bottom, t), num_from_decimal(189269, -6));
    bottom = num_add(num_mul(bottom, t), num_from_decimal(1432788, -6));
    bottom = num_add(num_mul(bottom, t), num_from_i64(1));
    return num_sub(num_div(top, bottom), t);
}

/* x - e / (1 + x e / 2), where norm is that of x and e2 is exp(x^2 / 2). */
static __attribute__((noinline)) num_t step(num_t x, num_t p, const num_t *norm, const num_t *e2) {
    const num_t root = num_sqrt(num_ldexp(func_pi(), 1));
    const num_t e = num_mul(num_sub(*norm, p), num_mul(root, *e2));
    return num_sub(x, num_div(e, num_add(num_from_i64(1), num_ldexp(num_mul(x, e), -1))));
}

/* In small functions, as they have the largest frames of all that expressions call. */
static __attribute__((noinline)) void improve(num_t *x, const num_t *p) {
    const num_t norm = func_norm(*x), e2 = func_exp_half_square(*x, false);
    *x = step(*x, *p, &norm, &e2);
}

static __attribute__((noinline)) num_t root_of_log(num_t p) {
    return num_sqrt(num_ldexp(num_neg(func_log(p)), 1));
}

static __attribute__((noinline)) num_t start(num_t p) {
    return first_guess(root_of_log(p));
}

static __attribute__((noinline)) num_t lower_half(num_t p) {
    num_t x = start(p);
    improve(&x, &p);
    improve(&x, &p);
    return x;
}

/* Above (1), on (0) or below (-1) the middle of the range; 2 outside. */
static __attribute__((noinline)) int side_of(num_t a) {
    if (a.undef || a.m <= 0 || num_cmp(a, num_from_i64(1)) >= 0) return 2;
    return num_cmp(a, num_from_fixed(1, 1));
}

static __attribute__((noinline)) num_t one_less(num_t a) {
    return num_sub(num_from_i64(1), a);
}

num_t func_invnorm(num_t a) {
    const int side = side_of(a);
    if (side == 2) return num_undef();
    if (side == 0) return num_from_i64(0);
    if (side > 0) a = one_less(a);
    a = lower_half(a);
    return side > 0 ? num_neg(a) : a;
}
