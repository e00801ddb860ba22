/* func_inner.h - what the elementary functions share with one another; private to src/num/func_*.c.
 *
 * A "Q116" is a wide_t with 116 fractional bits: exponents of the power function need 10 bits in front of the
 * point and, so that exp() of them is good to 2^-50, 60 bits behind it even after a multiplication by 2^40. */
#ifndef FUNC_INNER_H
#define FUNC_INNER_H

#include "num/ints.h"
#include "num/num.h"
#include "num/wide.h"

/* log(a) in Q116 for a > 0, within 2^-67 + 2^-61 |a - 1|. */
wide_t func_log_wide(num_t a);
/* exp(a) for a in Q116. */
num_t func_exp_wide(wide_t a);
/* sin and cos of a defined a with one reduction. */
void func_sincos(num_t a, num_t *sine, num_t *cosine);

/* The Chebyshev sum of n coefficients in Q60 at t in Q62, |t| <= 1; |result| < 4 in Q60, within n 2^-60. */
int64_t func_chebyshev(const int64_t *c, int n, int64_t t);
#define FUNC_CHEBYSHEV(table, t) num_from_fixed(func_chebyshev(table, (int)(sizeof(table) / sizeof *(table)), t), 60)

/* r^2 / 2^64 from two 32-bit products, up to 2 units low but never negative. */
static inline uint64_t func_square(int64_t r) {
    uint64_t u = ints_abs64(r);
    uint32_t h = (uint32_t)(u >> 32);
    return wide_mul_u32(h, h) + (wide_mul_u32(h, (uint32_t)u) >> 31);
}

/* exp(a^2 / 2), or exp(-a^2 / 2). */
num_t func_exp_half_square(num_t a, bool negative);

#endif
