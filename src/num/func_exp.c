/* exp, and its even and odd parts.
 *
 * exp(a) = 2^n * 2^(j/64) * e^r with 64 n + j the nearest integer to 64 a / ln 2, so |r| <= ln2/128 = 2^-7.5.
 * (P. T. P. Tang, "Table-driven implementation of the exponential function in IEEE floating-point
 * arithmetic", ACM TOMS 15, 1989.) The table leaves so short a polynomial that most of it needs no more than
 * 32x32->32 products, and the rest 32x32->64. */
#include "num/func.h"
#include "num/func_inner.h"
#include "num/func_tables.h"
#include "num/num_fast.h"
#include <stddef.h>

#define LN2_64_Q70 0xb17217f7d1cf79abu /* ln 2 / 64 in Q70 ... */
#define LN2_64_Q70_NEXT 12920          /* ... and its next 14 bits */
#define INV_LN2_64_Q24 1549082005      /* 64 / ln 2 */

/* The upper word of a, rounded, and the lower one that is left, with a sign: two 32-bit numbers whose products need no
 * correction. */
typedef struct halves {
    int32_t high, low;
} halves_t;

static inline halves_t halves(uint64_t a) {
    const uint32_t low = (uint32_t)a;
    return (halves_t){(int32_t)((uint32_t)(a >> 32) + (low >> 31)), (int32_t)low};
}

/* a * b / 2^31, b's 16 upper bits only; up to 2^16 off. */
static inline int32_t scaled_short(int32_t a, int32_t b) {
    b >>= 16;
    return (a >> 16) * b * 2 + (((a & 0xffff) * b) >> 15);
}

/* 2^(k/64) * e^r, r in Q70 with |r| < 0.00545 (2^62.5). Worst error 2^-55: that of the cubic term. */
static num_t exp_reduced(int32_t k, int64_t r) {
    const halves_t h = halves((uint64_t)r);                                      /* Q38, 31 bits */
    int64_t square = wide_mul_s32(h.high, h.high) + scaled_short(h.high, h.low); /* Q76, below 2^61, to 2^-60 */
    /* 1/6 + r/24 + r^2/120 + r^3/720, Q33; the next term is below 2^-58. The inner ones count for little: a product of
     * 32 bits has enough. */
    const int32_t s = h.high >> 15;                                          /* Q23, 17 bits */
    int32_t q = 17476 + (s * 1456 >> 22);                                    /* Q21 */
    q = 44739243 + ((s * q + (1 << 13)) >> 14);                              /* Q30 */
    q = 1431655765 + (((int32_t)(wide_mul_s32(h.high, q) >> 32) + 4) >> 3);  /* Q33 */
    int32_t rq = (int32_t)((wide_mul_s32(h.high, q) + (1 << 29)) >> 30);     /* Q41, 31 bits */
    int64_t cube = wide_mul_s32(rq, (int32_t)((square + (1 << 29)) >> 30));  /* Q87, 62 bits */
    const halves_t p = halves((uint64_t)(r + (square >> 7) + (cube >> 17))); /* e^r - 1, Q70, below 2^62.5 */
    const uint64_t table = func_tables_exp2[k & 63];                         /* Q62 */
    const halves_t t = halves(table);
    int64_t tp = wide_mul_s32(t.high, p.high) + (wide_mul_s32(t.high, p.low) >> 32);
    tp += wide_mul_s32(t.low, p.high) >> 32;         /* Q68, to 3 units */
    uint64_t u = table + (uint64_t)((tp + 32) >> 6); /* Q62, in [0.994, 2) */
    int low = (int)(u >> 62 ^ 1);
    return num_fast_make((int64_t)(u << low), (k >> 6) - 62 - low);
}

/* The integer nearest to 64 a / ln 2, a in Q21. */
static inline int32_t steps(int32_t a21) {
    return ((int32_t)(wide_mul_s32(a21, INV_LN2_64_Q24) >> 32) + (1 << 12)) >> 13;
}

num_t func_exp(num_t a) {
    if (NUM_FAST_RARE(a.m == 0)) return a.undef ? a : num_from_i64(1);
    if (NUM_FAST_RARE(a.e > -53)) return a.m > 0 ? num_undef() : num_from_i64(0); /* |a| >= 1024 */
    int n = -(a.e + 21);                                                          /* at least 32 */
    int32_t k = n < 63 ? steps((int32_t)((int32_t)(a.m >> 32) >> (n - 32))) : 0;
    /* a - k ln2/64 modulo 2^64 in Q70: only the difference has to fit */
    int s = a.e + 70; /* at most 17 */
    uint64_t x = s >= 0 ? (uint64_t)a.m << s : (uint64_t)(a.m >> (s > -63 ? -s : 63));
    uint64_t step = wide_mul_u32((uint32_t)k, (uint32_t)LN2_64_Q70);
    step += (uint64_t)((uint32_t)k * (uint32_t)(LN2_64_Q70 >> 32) - ((uint32_t)(k >> 31) & (uint32_t)LN2_64_Q70)) << 32;
    return exp_reduced(k, (int64_t)(x - step) - ((k * LN2_64_Q70_NEXT) >> 14)); /* 17 + 14 bits */
}

num_t func_exp_wide(wide_t a) {
    if (a.hi >> 62 != a.hi >> 63) return a.hi > 0 ? num_undef() : num_from_i64(0);
    int32_t k = steps((int32_t)(a.hi >> 31));
    /* ln2/64 in Q116 is 0x00002c5c85fdf473'de6af278ece600fd; its lower word counts as negative here */
    wide_t step = wide_mul_s64(k, (int64_t)0xde6af278ece600fdu);
    step.hi += k * (int64_t)0x00002c5c85fdf474;
    return exp_reduced(k, (int64_t)wide_sar(wide_sub(a, step), 46).lo);
}

/* sinh(a) / a - 1 for |a| < 1: the series in a^2, coefficients 1/(2i+1)! in Q64. */
static num_t sinh_series(num_t a) {
    static const uint64_t inverse_factorial[] = {0x0000000000000098u, 0x000000000000ca96u, 0x0000000000d73f9fu,
                                                 0x00000000b092309du, 0x0000006b99159fd5u, 0x00002e3bc74aad8eu,
                                                 0x000d00d00d00d00du, 0x0222222222222222u, 0x2aaaaaaaaaaaaaabu};
    int64_t f = num_to_fixed(a, 62, NULL);
    uint64_t z = wide_mulhi_u64(ints_abs64(f) << 1, ints_abs64(f) << 1); /* Q62 */
    uint64_t p = 0;
    for (int i = 0; i < 9; i++) p = inverse_factorial[i] + (wide_mulhi_u64(p, z) << 2);
    return num_from_fixed((int64_t)(wide_mulhi_u64(p, z)), 62);
}

num_t func_sinh(num_t a) {
    if (a.m == 0) return a;
    if (a.e < -62) return num_add(a, num_mul(a, sinh_series(a)));
    num_t t = func_exp(num_abs(a)), s = num_ldexp(num_sub(t, num_div(num_from_i64(1), t)), -1);
    return a.m < 0 ? num_neg(s) : s;
}

num_t func_cosh(num_t a) {
    num_t t = func_exp(num_abs(a));
    return num_ldexp(num_add(t, num_div(num_from_i64(1), t)), -1);
}

num_t func_tanh(num_t a) {
    if (a.m == 0) return a;
    if (a.e < -62) return num_div(func_sinh(a), func_cosh(a));
    num_t one = num_from_i64(1), t = one;
    if (a.e < -57) t = num_sub(one, num_div(num_from_i64(2), num_add(func_exp(num_ldexp(num_abs(a), 1)), one)));
    return a.m < 0 ? num_neg(t) : t;
}
