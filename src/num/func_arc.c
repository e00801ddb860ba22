/* atan2, atan, asin, acos.
 *
 * With 0 <= y <= x, j the nearest integer to 64 y/x and c = j/64:
 *     atan(y/x) = atan(c) + atan(u),   u = (y - c x) / (x + c y),   |u| <= 2^-7:
 * one division, whatever the quadrant. asin and acos go through atan2, with sqrt(1 - x^2) from the exact
 * factors 1 - x and 1 + x, so that nothing cancels near +-1. */
#include "num/func.h"
#include "num/func_inner.h"
#include "num/func_tables.h"
#include "num/num_fast.h"
#include <stddef.h>

#define PI_Q61 0x6487ed5110b4611a

num_t func_pi(void) {
    return (num_t){PI_Q61, -61, false};
}

/* atan(u) = u - u w for |u| < 2^-6.9; w in Q74. u in Q69. */
static uint64_t atan_correction(int64_t u) {
    uint64_t z = func_square(u);       /* Q74, below 2^60.2 */
    uint32_t zh = (uint32_t)(z >> 29); /* Q45, 32 bits */
    /* z/3 - z^2 (1/5 - z (1/7 - z/9)), the inner coefficients in Q34 */
    uint32_t q = 2454267026u - (uint32_t)(wide_mul_u32(zh, 1908874354) >> 45);
    q = 3435973837u - (uint32_t)(wide_mul_u32(zh, q) >> 45);
    uint64_t t = wide_mul_u32((uint32_t)(wide_mul_u32(zh, q) >> 32), zh); /* Q47 * Q45 */
    return wide_mulhi_u64(z, 0x5555555555555555u) - (t >> 18);
}

/* atan(y/x) for 0 < y <= x. */
static num_t first_octant(num_t y, num_t x) {
    int32_t d = x.e - y.e; /* at least 0 */
    uint64_t xm = (uint64_t)x.m, ym = d < 64 ? (uint64_t)y.m >> d : 0;
    uint32_t x32 = (uint32_t)(xm >> 32), y32 = (uint32_t)(ym >> 32); /* 31 bits */
    uint32_t j = (y32 + x32 / 128) / (x32 / 64 + 1); /* 64 y/x, within 0.51; x32 >= 2^30, so 1 more is nothing */
    if (j == 0) {
        num_t u = num_div(y, x);
        if (u.e + 62 < -32) return u;
        return num_sub(u, num_mul(u, num_from_fixed((int64_t)atan_correction(num_to_fixed(u, 69, NULL)), 74)));
    }
    if (j > 64) j = 64;
    /* 64 y - j x, |n| < 2^63, so modulo 2^64 is enough; d <= 7 here */
    int64_t n = (int64_t)((d <= 6 ? (uint64_t)y.m << (6 - d) : (uint64_t)y.m >> 1) - j * xm);
    uint64_t den = xm + ((ym >> 6) * j + (((ym & 63) * j) >> 6));
    num_t quotient = num_div(num_from_fixed(n, 6), num_fast_normal(den, 0, 0));
    int64_t u = num_to_fixed(quotient, 69, NULL);
    u -= wide_mulhi_s64(u, (int64_t)atan_correction(u)) >> 10;                       /* atan u, Q69 */
    return num_fast_normal(func_tables_atan[j] + (uint64_t)((u + 16) >> 5), -64, 0); /* below 0.8 */
}

num_t func_atan2(num_t y, num_t x) {
    if (y.undef || x.undef) return num_undef();
    num_t pi = func_pi(), half = num_ldexp(pi, -1), r;
    num_t ay = num_abs(y), ax = num_abs(x);
    if (y.m == 0)
        r = x.m < 0 ? pi : y;
    else if (x.m == 0)
        r = half;
    else if (num_cmp(ay, ax) <= 0) {
        r = first_octant(ay, ax);
        if (x.m < 0) r = num_sub(pi, r);
    } else {
        r = first_octant(ax, ay);
        r = x.m < 0 ? num_add(half, r) : num_sub(half, r);
    }
    return y.m < 0 ? num_neg(r) : r;
}

num_t func_atan(num_t a) {
    return func_atan2(a, num_from_i64(1));
}

/* sqrt(1 - a^2), undefined for |a| > 1. */
static num_t cofactor(num_t a) {
    num_t one = num_from_i64(1);
    return num_sqrt(num_mul(num_sub(one, a), num_add(one, a)));
}

num_t func_asin(num_t a) {
    return func_atan2(a, cofactor(a));
}

num_t func_acos(num_t a) {
    return func_atan2(cofactor(a), a);
}
