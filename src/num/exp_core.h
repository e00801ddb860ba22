/* exp_core.h - exp of what is neither rare nor rounded, for func_exp.c and for rows of heights; private to them.
 *
 * exp(a) = 2^n * 2^(j/64) * e^r with 64 n + j the nearest integer to 64 a / ln 2, so |r| <= ln2/128 = 2^-7.5.
 * (P. T. P. Tang, "Table-driven implementation of the exponential function in IEEE floating-point
 * arithmetic", ACM TOMS 15, 1989.) The table leaves so short a polynomial that most of it needs no more than
 * 32x32->32 products, and the rest 32x32->64. */
#ifndef EXP_CORE_H
#define EXP_CORE_H

#include "num/func_tables.h"
#include "num/ints.h"
#include "num/words.h"

#define LN2_64_Q70 0xb17217f7d1cf79abu /* ln 2 / 64 in Q70 ... */
#define LN2_64_Q70_NEXT 12920          /* ... and its next 14 bits */
#define INV_LN2_64_Q24 1549082005      /* 64 / ln 2 */

/* m * 2^e with m in [2^62, 2^63); any e. */
typedef struct exp_core {
    words_t m;
    int32_t e;
} exp_core_t;

/* a * b / 2^31, b's 16 upper bits only; up to 2^16 off. */
static inline int32_t exp_scaled_short(int32_t a, int32_t b) {
    b >>= 16;
    return (a >> 16) * b * 2 + (((a & 0xffff) * b) >> 15);
}

/* a / 2^30, to nearest. */
static inline int32_t exp_from_q30(words_t a) {
    a = words_add(a, words(0, 1u << 29));
    if (WORDS_WIDE) return (int32_t)(words_join(a) >> 30);
    return (int32_t)(words_hi(a) << 2 | words_lo(a) >> 30);
}

/* 2^(k/64) * e^r, r in Q70 with |r| < 0.00545 (2^62.5). Worst error 2^-55: that of the cubic term. */
static inline __attribute__((always_inline)) exp_core_t exp_reduced(int32_t k, words_t r) {
    const int32_t high = words_upper(r), low = (int32_t)words_lo(r); /* Q38, 31 bits */
    words_t square = words_square_s32(high);                         /* Q76, below 2^61, to 2^-60 */
    square = words_add(square, words_of_s32(exp_scaled_short(high, low)));
    /* 1/6 + r/24 + r^2/120 + r^3/720, Q33; the next term is below 2^-58. The inner ones count for little: a product of
     * 32 bits has enough. */
    const int32_t s = high >> 15;                                 /* Q23, 17 bits */
    int32_t q = 17476 + (s * 1456 >> 22);                         /* Q21 */
    q = 44739243 + ((s * q + (1 << 13)) >> 14);                   /* Q30 */
    q = 1431655765 + ((words_mulhi_s32(high, q) + 4) >> 3);       /* Q33 */
    const int32_t rq = exp_from_q30(words_mul_s32(high, q));      /* Q41, 31 bits */
    const words_t cube = words_mul_s32(rq, exp_from_q30(square)); /* Q87, 62 bits */
    /* e^r - 1, Q70, below 2^62.5 */
    const words_t p = words_add(words_add(r, words_sar(square, 7)), words_sar(cube, 17));
    words_t u = words_of(func_tables_exp2[k & 63]); /* Q62 */
    const words_t tp = words_scaled(u, p, 32);      /* Q68, to 3 units */
    u = words_add(u, words_sar(tp, 6));             /* Q62, in [0.994, 2) */
    const int32_t e = (k >> 6) - 62;
    return words_hi(u) >> 30 ? (exp_core_t){u, e} : (exp_core_t){words_shl(u, 1), e - 1};
}

/* The integer nearest to 64 a / ln 2, a in Q21. */
static inline int32_t exp_steps_q21(int32_t a) {
    return (words_mulhi_s32(a, INV_LN2_64_Q24) + (1 << 12)) >> 13;
}
static inline int32_t exp_steps(int64_t m, int32_t e) {
    const int n = -(e + 53);
    return n < 31 ? exp_steps_q21((int32_t)(m >> 32) >> ints_count(n)) : 0;
}

/* What is left of m * 2^e, |m| in [2^62, 2^63), e <= -53 without k steps. */
static inline __attribute__((always_inline)) words_t exp_rest(int64_t m, int32_t e, int32_t k) {
    /* a - k ln2/64 modulo 2^64 in Q70: only the difference has to fit */
    const int s = e + 70; /* at most 17 */
    const words_t a = words_of((uint64_t)m), r = s > 0 ? words_shl(a, ints_count(s)) : words_sar_far(a, -s);
    if (WORDS_WIDE) return words_of(words_join(r) - (uint64_t)k * LN2_64_Q70 - (uint64_t)((k * LN2_64_Q70_NEXT) >> 14));
    /* The lower word of ln2/64 counts as negative. */
    words_t step = words_mul_s32(k, (int32_t)(uint32_t)LN2_64_Q70);
    step = words(words_hi(step) + (uint32_t)k * (uint32_t)((LN2_64_Q70 >> 32) + 1), words_lo(step));
    return words_sub(words_sub(r, step), words_of_s32((k * LN2_64_Q70_NEXT) >> 14)); /* 17 + 14 bits */
}

#endif
