/* num_double.h - arithmetic that rounds where an IEEE double does: to 53 bits, ties to even.
 *
 * The expression language computes with these, so that it agrees with gnuplot not only to some digits but where it
 * shows: 4.35*100 truncates to 434, log(8)/log(2) is 3, 0.1 + 0.2 == 0.3 is false, floor(x) steps at the same grid
 * lines. The extra bits of num.h would be more accurate and now and then on the other side of a step.
 *
 * Operands are any num_t; sums, products, quotients and roots of doubles are the doubles that IEEE 754 asks for. What
 * functions return is rounded twice, to their 63 bits and by num_double: wrong in the last bit about once in 500, as
 * libm is. Overflow (from 2^1024 on) is undefined, below 2^-1074 is zero; in between, subnormal results keep all
 * 53 bits. No negative zero. Context: any. */
#ifndef NUM_DOUBLE_H
#define NUM_DOUBLE_H

#include "config.h"
#include "num/num_fast.h"
#include "num/words.h"

/* The exponents e for which m * 2^e, |m| in [2^62, 2^63), is in the range of doubles. */
#define NUM_DOUBLE_E_MIN (-1074 - 62)
#define NUM_DOUBLE_E_MAX (1024 - 63)

/* The way of adding that suits a core of 32 bits; the sums are the same. */
#ifndef NUM_DOUBLE_NARROW
#define NUM_DOUBLE_NARROW (sizeof(void *) < 8)
#endif

_Static_assert(NUM_FAST_E_MIN <= NUM_DOUBLE_E_MIN && NUM_FAST_E_MAX >= NUM_DOUBLE_E_MAX, "num.h reaches further");

static inline num_t num_double_make(int64_t m, int32_t e) {
    if (NUM_FAST_RARE((uint32_t)(e - NUM_DOUBLE_E_MIN) > (uint32_t)(NUM_DOUBLE_E_MAX - NUM_DOUBLE_E_MIN)))
        return (num_t){0, 0, e > 0};
    return (num_t){m, e, false};
}

/* u * 2^e rounded, u in [2^62, 2^63), whose lowest bit also stands for everything below it; with the sign s, 0 or ~0.
 */
static inline num_t num_double_round_words(words_t u, int32_t e, uint32_t s) {
    u = words_round(u);
    if (NUM_FAST_RARE((int32_t)words_hi(u) < 0)) {
        u = words(0x40000000, 0);
        e++;
    }
    return num_double_make((int64_t)words_join(words_with_sign(u, s)), e);
}

/* The same for u below 2^64 and what was lost below it, not 0 if it was anything. */
static inline num_t num_double_round_lost(words_t u, uint32_t lost, int32_t e, uint32_t s) {
    if ((int32_t)words_hi(u) < 0) {
        lost |= words_lo(u) & 1;
        u = words_shr(u, 1);
        e++;
    }
    if (lost) u = words(words_hi(u), words_lo(u) | 1);
    return num_double_round_words(u, e, s);
}

/* The same of twice that size, u in [2^63, 2^64), with the sign of s. */
static inline num_t num_double_round(uint64_t u, int32_t e, int64_t s) {
    if (NUM_DOUBLE_NARROW) return num_double_round_words(words_of(u >> 1 | (u & 1)), e + 1, (uint32_t)(s >> 63));
    uint64_t r = (u + 0x3FF + (u >> 11 & 1)) & ~(uint64_t)0x7FF; /* wraps to 0 when it carries into 2^64 */
    if (NUM_FAST_RARE(r == 0)) return num_double_make(ints_with_sign((uint64_t)1 << 62, s), e + 2);
    return num_double_make(ints_with_sign(r >> 1, s), e + 1);
}

/* The nearest double. */
static inline num_t num_double(num_t a) {
    if (a.m == 0) return a;
    const words_t m = words_of((uint64_t)a.m);
    const uint32_t sign = words_sign(m);
    return num_double_round_words(words_with_sign(m, sign), a.e, sign);
}

/* Is there nothing but zero or undefined: a normalised significand shows it in its upper word. */
static inline bool num_double_rare(num_t a, num_t b) {
    if (NUM_DOUBLE_NARROW) return NUM_FAST_RARE((int32_t)(a.m >> 32) == 0 || (int32_t)(b.m >> 32) == 0);
    return NUM_FAST_RARE(a.m == 0 || b.m == 0);
}

/* The significands of two by their exponents, the larger of which is *e. Returns how far these are apart. */
static inline __attribute__((always_inline)) int32_t num_double_by_size(num_t a, num_t b, words_t *big, words_t *small,
                                                                        int32_t *e) {
    int32_t d = a.e - b.e;
    *e = a.e;
    *big = words_of((uint64_t)a.m);
    *small = words_of((uint64_t)b.m);
    if (d < 0) {
        const words_t other = *big;
        *big = *small;
        *small = other;
        d = -d;
        *e = b.e;
    }
    return d;
}

/* A sum of two of one sign, neither of them zero, for a core of 32 bits: nothing cancels, the top is where it was or
 * one higher. Branches cost it little, words on the stack much: a third of the time of the general way. */
static inline __attribute__((always_inline)) num_t num_double_sum_narrow(num_t a, num_t b) {
    int32_t e;
    words_t big, small;
    int32_t d = num_double_by_size(a, b, &big, &small, &e);
    if (NUM_FAST_RARE(d > 63)) return (num_t){(int64_t)words_join(big), e, false};
    const uint32_t sign = words_sign(big);
    big = words_with_sign(big, sign);
    small = words_with_sign(small, sign);
    uint32_t lost = 0;
    if (d >= 32) {
        lost = words_lo(small);
        small = words(0, words_hi(small));
        d -= 32;
    }
    if (d > 0) {
        lost |= words_lo(small) << (32 - d);
        small = words_shr(small, d);
    }
    return num_double_round_lost(words_add(big, small), lost, e, sign);
}

/* A sum of two of opposite signs, neither of them zero. Two bits below the lowest of the larger one and whether
 * anything is below them decide its rounding, unless the tops are next to one another: then it is exact before it is
 * rounded. */
static inline num_t num_double_difference_narrow(num_t a, num_t b) {
    int32_t e;
    words_t big, small;
    int32_t d = num_double_by_size(a, b, &big, &small, &e);
    if (NUM_FAST_RARE(d > 63)) return (num_t){(int64_t)words_join(big), e, false};
    uint32_t sign = words_sign(big);
    big = words_with_sign(big, sign);
    small = words_with_sign(small, ~sign);
    if (d >= 2) {
        uint32_t lost = 0;
        if (d > 32) {
            lost = words_lo(small);
            small = words(0, words_hi(small));
            d -= 32;
        }
        if (d > 1) {
            lost |= words_lo(small) << (33 - d);
            small = words_shr(small, d - 1);
        }
        words_t u = words_sub(words_shl(big, 1), small); /* from 2^62 on */
        if (lost) u = words_sub(u, words(0, 1));
        return num_double_round_lost(u, lost, e - 1, sign);
    }
    words_t u = words_sub(d ? words_shl(big, 1) : big, small);
    e -= d;
    if (d == 0 && words_sign(u)) {
        u = words_with_sign(u, ~0u);
        sign = ~sign;
    }
    if (words_hi(u) == 0) {
        if (words_lo(u) == 0) return (num_t){0, 0, false};
        u = words(words_lo(u), 0);
        e -= 32;
    }
    const int n = ints_clz32(words_hi(u)) - 1;
    if (n > 0) u = words_shl(u, n);
    return num_double_round_lost(u, 0, n > 0 ? e - n : e, sign);
}

/* Where they need not be inline. */
static inline num_t num_double_add_narrow(num_t a, num_t b) {
    return (a.m ^ b.m) >= 0 ? num_double_sum_narrow(a, b) : num_double_difference_narrow(a, b);
}

/* As num_fast_add, which has the reasons, but for the rounding. */
static inline num_t num_double_add(num_t a, num_t b) {
    if (num_double_rare(a, b)) return num_fast_add_rare(a, b);
    if (NUM_DOUBLE_NARROW) return num_double_add_narrow(a, b);
    int32_t d = a.e - b.e;
    /* Of a choice between them compilers make a branch, which would be guessed wrong. */
    const int64_t other = (a.m ^ b.m) & (d >> 31), big = a.m ^ other, small = b.m ^ other;
    const int32_t e = a.e - (d & d >> 31);
    d = d < 0 ? -d : d;
    if (NUM_FAST_RARE(d > 63)) return (num_t){big, e, false};
    int64_t sign = big >> 63, S = (small ^ sign) - sign;
    uint64_t u = ints_abs64(big) + (uint64_t)(S >> d), lo = ((uint64_t)S << 1) << (63 - d);
    int64_t flip = (S & (int64_t)u) >> 63;
    u = (u ^ (uint64_t)flip) - (uint64_t)flip;
    sign ^= flip;
    if (NUM_FAST_RARE(u == 0)) return num_double(num_fast_normal(lo, e - 64, sign)); /* cancelled: d <= 1 */
    int n = ints_clz64(u);
    u = u << n | (lo >> 1) >> (63 - n);
    u |= lo << n != 0;
    return num_double_round(u, e - n, sign);
}

static inline num_t num_double_mul(num_t a, num_t b) {
    if (num_double_rare(a, b)) return num_fast_mul_rare(a, b);
    wide_u_t p = wide_mul_u64(ints_abs64(a.m) << 1, ints_abs64(b.m) << 1); /* its top is at bit 126 or 127 */
    int32_t e = a.e + b.e + 62;
    if (NUM_DOUBLE_NARROW) {
        uint32_t lost = (uint32_t)p.lo | (uint32_t)(p.lo >> 32);
        return num_double_round_lost(words_of(p.hi), lost, e, words_sign(words_of((uint64_t)(a.m ^ b.m))));
    }
    int t = (int)(p.hi >> 63) ^ 1;
    uint64_t u = p.hi << t | (p.lo >> 63 & (uint64_t)t);
    u |= p.lo << t != 0;
    return num_double_round(u, e - t, a.m ^ b.m);
}

/* As num_div and num_sqrt. */
num_t num_double_div(num_t a, num_t b);
num_t num_double_sqrt(num_t a);

#endif
