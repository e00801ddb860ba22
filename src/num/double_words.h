/* double_words.h - quotients and roots that round once, by words of 32 bits: num_double_div and num_double_sqrt, inline
 * for rows of heights; private to them.
 *
 * What is to be rounded to 53 bits needs no exact remainder of 126: a few units of 2^-63 more or less matter only next
 * to the middle between two doubles, and there the exact product decides, as it has to for 63 bits (num_double.c). */
#ifndef DOUBLE_WORDS_H
#define DOUBLE_WORDS_H

#include "num/num_double.h"

/* r, near a middle M, rounded: the result is larger than M exactly if a.m * 2^shift > M * with (or M * M, with being
 * 0). shift: 62 or 63. */
num_t double_words_decide(num_t r, int64_t am, int shift, uint64_t with);

/* May rounding r be wrong, which is too small by up to `below`, or too large by up to `above`? */
static inline bool double_words_close(words_t r, uint32_t below, uint32_t above) {
    return ((words_lo(r) & 0x3FF) - (0x200 - below)) <= below + above;
}

/* 2^95 / d for d in [2^63, 2^64), of which x is the upper word: from below, within 2^-29. Newton's v + v (1 - x v) from
 * 48/17 - 32/17 x on, which is within 1/17, with as many bits as each step is good for. */
static inline uint32_t double_words_reciprocal(uint32_t x) {
    const uint32_t t = x >> 16;
    uint32_t v = 46261 - (t * 30840 >> 16); /* Q14 */
    int32_t e = (int32_t)((1u << 30) - t * v);
    v += (uint32_t)((int32_t)v * (e >> 15) >> 15); /* 2^-8.1 */
    e = (int32_t)((1u << 30) - t * v - ((x & 0xFFFF) * v >> 16));
    v = (v << 16) + (uint32_t)((int32_t)v * (e >> 6) >> 8);                  /* Q30, 2^-16.2 */
    const words_t rest = words_sub(words(1u << 30, 0), words_mul_u32(x, v)); /* Q62, below 2^46 */
    e = (int32_t)(words_hi(rest) << 17 | words_lo(rest) >> 15);
    /* Q31; at d = 2^64 - 1 as at x = 2^32 - 1 */
    return (v << 1) + (uint32_t)(words_mulhi_s32((int32_t)v, e) >> 14) - 2;
}

static inline __attribute__((always_inline)) num_t double_words_div(num_t a, num_t b) {
    if (NUM_FAST_RARE(a.m == 0 || b.m == 0)) return a.undef || b.m == 0 ? num_undef() : a;
    const words_t am = words_of((uint64_t)a.m), bm = words_of((uint64_t)b.m);
    const uint32_t sign = words_sign(words(words_hi(am) ^ words_hi(bm), 0));
    const words_t n = words_with_sign(am, words_sign(am)), d = words_shl(words_with_sign(bm, words_sign(bm)), 1);
    const uint32_t v = double_words_reciprocal(words_hi(d));
    /* The first word of n / d, Q31 and within 2^-28.7, what is then left, 35 bits, and that by d again. */
    const uint32_t q = words_hi(words_mul_u32(words_hi(words_shl(n, 1)), v));
    words_t left = words_sub(n, words_mul_u32(q, words_hi(d)));
    left = words_shr(words_sub(left, words(0, words_hi(words_mul_u32(q, words_lo(d))))), 3);
    words_t u = words_add(words(q, 0), words_shr(words_mul_u32(words_lo(left), v), 28)); /* Q63, within 64 units */
    int32_t e = a.e - b.e - 63;
    if ((int32_t)words_hi(u) < 0) {
        u = words_shr(u, 1);
        e++;
    }
    if (NUM_FAST_RARE(double_words_close(u, 64, 8)))
        return double_words_decide((num_t){(int64_t)words_join(words_with_sign(u, sign)), e, false}, a.m, a.e - b.e - e,
                                   ints_abs64(b.m));
    return num_double_round_words(u, e, sign);
}

static inline __attribute__((always_inline)) num_t double_words_sqrt(num_t a) {
    if (NUM_FAST_RARE(a.m <= 0)) return a.m == 0 ? a : num_undef();
    /* As num_sqrt, but that the last correction starts from 32 bits. */
    words_t u = words_of((uint64_t)a.m);
    const int odd = a.e & 1;
    if (odd) u = words_shl(u, 1);
    const uint32_t x = words_hi(u), r = ints_rsqrt(x);
    const uint32_t first = words_hi(words_shl(words_mul_u32(x, r), 1));                                /* Q31 */
    words_t left = words_sub(u, words_shl(words_mul_u32(first, first), 2));                            /* Q64 */
    left = words_mul_s32((int32_t)words_lo(words_sar(left, 7)), (int32_t)r);                           /* Q88 */
    left = words_add(words(first, 0), words_add(words_sar(left, 25), words(0, 1u << 30)));             /* Q63 */
    const uint32_t s = words_hi(left) >> 31 ? UINT32_MAX : words_hi(left) << 1 | words_lo(left) >> 31; /* Q32 */
    left = words_sub(u, words_mul_u32(s, s));                                                          /* 2^33 */
    left = words_mul_s32((int32_t)words_lo(words_sar(left, 2)), (int32_t)r);                           /* Q93 */
    u = words_add(words(s >> 1, s << 31), words_sar(left, 30));                                        /* to 2^-60 */
    const int32_t e = (a.e - 62 - odd) / 2;
    if (NUM_FAST_RARE(double_words_close(u, 16, 16)))
        return double_words_decide((num_t){(int64_t)words_join(u), e, false}, a.m, a.e - 2 * e, 0);
    return num_double_round_lost(u, 0, e, 0);
}

/* a * b, b having no more than 31 bits: its lower word is 0. Neither is zero or undefined. */
static inline __attribute__((always_inline)) num_t double_words_mul_short(num_t a, num_t b) {
    const words_t am = words_of((uint64_t)a.m);
    const int32_t bh = (int32_t)words_hi(words_of((uint64_t)b.m));
    const uint32_t as = words_sign(am), bs = (uint32_t)(bh >> 31), factor = (((uint32_t)bh ^ bs) - bs) << 1;
    const words_t n = words_shl(words_with_sign(am, as), 1), low = words_mul_u32(words_lo(n), factor);
    const words_t u = words_add(words_mul_u32(words_hi(n), factor), words(0, words_hi(low)));
    return num_double_round_lost(u, words_lo(low), a.e + b.e + 62, as ^ bs);
}

#endif
