/* trig_core.h - sin(k pi/128 + r), |r| <= pi/256, of a table and short polynomials: what func_trig.c and rows of
 * heights have in common; private to them. */
#ifndef TRIG_CORE_H
#define TRIG_CORE_H

#include "num/func_inner.h"
#include "num/func_tables.h"
#include "num/num_fast.h"

/* k pi/128 in Q126, modulo 2^128; pi/128 in Q158 is 0x01921fb54442d184'69898cc51701b839'a252049c. */
static inline wide_t trig_steps(uint32_t k) {
    const wide_u_t low = wide_mul_u64_u32(0x69898cc51701b839, k);
    const wide_t step = {(int64_t)(low.hi + k * 0x01921fb54442d184u), low.lo};
    return wide_add(step, wide_from_s64((int64_t)(wide_mul_u32(k, 0xa252049c) >> 32)));
}

/* The nearest k of m * 2^e, m in [2^62, 2^63), e < -42. */
static inline uint32_t trig_nearest(uint64_t m, int32_t e) {
    const int n = -(e + 43);                                                        /* at least 0 */
    const uint32_t a11 = n < 31 ? (uint32_t)(m >> 32) >> ints_count(n) : 0;         /* Q11 */
    return (uint32_t)((wide_mul_u32(a11, 1367130551) + ((uint64_t)1 << 35)) >> 36); /* 128/pi in Q25 */
}

/* Of what is a whole number of 2^-69, as all from 2^-7 on are, and below 2^20: what is left of it, in Q69, rounded
 * down, bit for bit what the difference in Q126 has (test_trig_core.c asks every k). All of it modulo 2^64, as what is
 * left has 63 bits. */
#define TRIG_WHOLE(e) ((uint32_t)((e) + 69) <= 69 - 43)
static inline int64_t trig_rest_q69(uint64_t m, int32_t e, uint32_t k) {
    const uint64_t steps = k * 0xc90fdaa22168c234u + wide_mulhi_u64(k, 0xc4c6628b80dc1cd1u); /* pi in Q62 and Q126 */
    return (int64_t)((m << (ints_count(e + 69) & 63)) - steps - (k != 0));
}

/* sin r = r - r * u and cos r = 1 - c; u, c in Q74. */
typedef struct trig_small {
    int64_t r; /* Q69, below 2^62.7 */
    uint64_t u, c;
} trig_small_t;

static inline trig_small_t trig_small(int64_t r_q69) {
    trig_small_t s;
    s.r = r_q69;
    uint64_t z = func_square(s.r);     /* Q74, below 2^61.4 */
    uint32_t zh = (uint32_t)(z >> 30); /* Q44, 32 bits */
    /* u = z/6 - z^2 (1/120 - z/5040) */
    uint32_t q = 2290649225u - (uint32_t)(wide_mul_u32(zh, 54539267) >> 44); /* Q38 */
    uint64_t t = wide_mul_u32((uint32_t)(wide_mul_u32(zh, q) >> 32), zh);    /* Q94 */
    s.u = wide_mulhi_u64(z, 0x2aaaaaaaaaaaaaabu) - (t >> 20);
    /* c = z/2 - z^2 (1/24 - z/720) */
    q = 2863311531u - (uint32_t)(wide_mul_u32(zh, 95443718) >> 44); /* Q36 */
    t = wide_mul_u32((uint32_t)(wide_mul_u32(zh, q) >> 32), zh);    /* Q92 */
    s.c = (z >> 1) - (t >> 18);
    return s;
}

/* |sin(k pi/128 + r)| in Q62 for a k that is not a multiple of 128. */
static inline uint64_t trig_sine_q62(uint32_t k, trig_small_t s) {
    int64_t sr = s.r - (wide_mulhi_s64(s.r, (int64_t)s.u) >> 10); /* sin r, Q69 */
    /* In the second quadrant, which cannot be guessed, it is cos(j pi/128 + r). */
    const int32_t second = -(int32_t)(k >> 6 & 1), j = ((int32_t)(k & 63) ^ second) - second + (second & 64);
    const int64_t a = (int64_t)func_tables_sin[j], b = ints_with_sign(func_tables_sin[64 - j], second);
    int64_t small = wide_mulhi_s64(b, sr) - (wide_mulhi_s64(a, (int64_t)s.c) >> 5); /* Q67 */
    return (uint64_t)(a + ((small + 16) >> 5));
}

#endif
