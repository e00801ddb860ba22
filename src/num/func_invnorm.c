/* The inverse of the normal distribution's integral.
 *
 * Abramowitz and Stegun 26.2.23 gives three digits; two steps of Halley's method on func_norm, which is accurate
 * relative to its value in the lower tail, make them nine and then all: with e = (norm(x) - p) / norm'(x) a step is
 * x - e / (1 + x e / 2), and its error grows with the third power. */
#include "num/func.h"

/* For 0 < p <= 1/2: x <= 0. */
static num_t lower_half(num_t p) {
    num_t one = num_from_i64(1);
    num_t t = num_sqrt(num_ldexp(num_neg(func_log(p)), 1));
    num_t top = num_from_decimal(10328, -6), bottom = num_from_decimal(1308, -6);
    top = num_add(num_mul(top, t), num_from_decimal(802853, -6));
    top = num_add(num_mul(top, t), num_from_decimal(2515517, -6));
    bottom = num_add(num_mul(bottom, t), num_from_decimal(189269, -6));
    bottom = num_add(num_mul(bottom, t), num_from_decimal(1432788, -6));
    bottom = num_add(num_mul(bottom, t), one);
    num_t x = num_sub(num_div(top, bottom), t);
    num_t root = num_sqrt(num_ldexp(func_pi(), 1));
    for (int i = 0; i < 2; i++) {
        num_t slope_inverse = num_mul(root, func_exp(num_ldexp(num_mul(x, x), -1)));
        num_t e = num_mul(num_sub(func_norm(x), p), slope_inverse);
        x = num_sub(x, num_div(e, num_add(one, num_ldexp(num_mul(x, e), -1))));
    }
    return x;
}

num_t func_invnorm(num_t a) {
    num_t one = num_from_i64(1), half = num_from_fixed(1, 1);
    if (a.undef || num_sign(a) <= 0 || num_cmp(a, one) >= 0) return num_undef();
    int side = num_cmp(a, half);
    if (side == 0) return num_from_i64(0);
    return side < 0 ? lower_half(a) : num_neg(lower_half(num_sub(one, a)));
}
