/* sin_core.h - sin and cos of what is neither rare nor near a zero, by words, for rows of heights; private to them.
 *
 * As func_trig.c, a = k pi/128 + r with sin and cos of r by short polynomials; but what decides nothing is left out,
 * and products of 64 bits are made of three of words. So a result is a few units of 2^-62 from that of func_sin: where
 * rounding to a double might show it, sin_core says that it is not sure. The doubles are the same. */
#ifndef SIN_CORE_H
#define SIN_CORE_H

#include "num/func_tables.h"
#include "num/words.h"

#define PI_128_Q69 0xC90FDAA22168C234u /* pi / 128 ... */
#define PI_128_Q69_NEXT 0xC4C6u        /* ... and its next 16 bits */
#define INV_PI_128_Q25 1367130551      /* 128 / pi */
#define SIN_CORE_OFF 4u                /* units of 2^-62 that the two are apart at most */

/* sign(s) m 2^e with m in [2^62, 2^63) */
typedef struct sin_core {
    words_t m;
    int32_t e;
    uint32_t sign; /* 0 or ~0 */
    bool sure;
} sin_core_t;

/* a - k pi/128 in Q69, for |a| = m 2^e; only the difference has to fit. */
static inline words_t sin_core_rest(words_t m, int32_t e, uint32_t k) {
    const int s = e + 69; /* at most 16 */
    const words_t a = s > 0 ? words_shl(m, s) : words_sar_far(m, -s);
    const words_t step = words_mul_u32(k, (uint32_t)PI_128_Q69);
    const words_t high = words(words_hi(step) + k * (uint32_t)(PI_128_Q69 >> 32), words_lo(step));
    return words_sub(words_sub(a, high), words(0, k * PI_128_Q69_NEXT >> 16));
}

/* sin(|a| + quarter pi/128), a = m 2^e, quarter being 0 or 64. */
static inline __attribute__((always_inline)) sin_core_t sin_core(words_t m, int32_t e, uint32_t quarter) {
    const int n = -(e + 53);
    if ((uint32_t)n > 20) return (sin_core_t){.sure = false}; /* |a| >= 1024, or tiny */
    uint32_t k = (uint32_t)(words_mulhi_s32((int32_t)(words_hi(m) >> n & ~0x3FFu), INV_PI_128_Q25) + (1 << 13)) >> 14;
    const words_t r = sin_core_rest(m, e, k); /* Q69, below 2^62.7 */
    k += quarter;
    if ((k & 127) == 0) return (sin_core_t){.sure = false}; /* a zero may be near */

    const int32_t rh = words_upper(r); /* Q37 */
    words_t z = words_square_s32(rh);  /* r^2, Q74, below 2^61.4 */
    z = words_add(z, words_of_s32(words_mulhi_s32(rh, (int32_t)words_lo(r)) * 2));
    const uint32_t zh = words_hi(z) << 2 | words_lo(z) >> 30, z16 = zh >> 16; /* Q44, Q28 */

    /* sin r = r - r u with u = z/6 - z^2 (1/120 - z/5040) */
    uint32_t q = words_hi(words_mul_u32(zh, 2290649225u - (z16 * 13315 >> 16))); /* Q50 */
    words_t u = words_shr(z, 3);                                                 /* z/8 ... */
    u = words_add(u, words_shr(u, 2));                                           /* ... 5/4 ... */
    u = words_add(u, words_shr(u, 4));
    u = words_add(u, words_shr(u, 8));
    u = words_add(u, words_shr(u, 16));
    u = words_add(u, words(0, words_hi(u)));
    u = words_sub(u, words_shr(words_mul_u32(q, zh), 20));
    const words_t sine = words_sub(r, words_sar(words_scaled(r, u, 0), 10)); /* Q69 */
    /* cos r = 1 - c with c = z/2 - z^2 (1/24 - z/720) */
    q = words_hi(words_mul_u32(zh, 2863311531u - (words_hi(words_mul_u32(zh, 95443718)) >> 12))); /* Q48 */
    const words_t c = words_sub(words_shr(z, 1), words_shr(words_mul_u32(q, zh), 18));            /* Q74 */

    const uint32_t j = k & 63, sign = k & 128 ? ~0u : 0;
    words_t a = words_of(func_tables_sin[j]), b = words_of(func_tables_sin[64 - j]);
    if (k & 64) {
        const words_t swap = a;
        a = b;
        b = words_with_sign(swap, ~0u);
    }
    words_t sum = words_sub(words_scaled(b, sine, 0), words_sar(words_scaled(a, c, 0), 5)); /* Q67 */
    sum = words_add(a, words_sar(words_add(sum, words(0, 16)), 5));                         /* Q62 */
    int shift = 0;
    while (words_hi(sum) >> 30 == 0) {
        sum = words_add(sum, sum);
        shift++;
    }
    const uint32_t off = SIN_CORE_OFF << shift;
    const bool sure = ((words_lo(sum) - (0x200 - off)) & 0x3FF) > 2 * off;
    return (sin_core_t){sum, -62 - shift, sign, sure};
}

#endif
