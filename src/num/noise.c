/* noise.c - see noise.h. */
#include "num/noise.h"
#include "num/num_double.h"

/* factor * s modulo 2^31 - less, for s below that. */
static inline uint32_t step(uint32_t s, uint32_t factor, uint32_t less) {
    const uint64_t p = wide_mul_u32(s, factor); /* below 2^48 */
    const uint32_t r = ((uint32_t)p & 0x7fffffff) + (uint32_t)(p >> 31) * less, m = 0x80000000u - less;
    return r >= m ? r - m : r; /* r is below 2^31 + 2^25 */
}

num_t noise_next(int32_t seed[2]) {
    /* gnuplot's factor, the double 4.656613057e-10, a little less than 1 / M1: the result is inside ]0, 1[. */
    static const uint64_t FACTOR = 0x4000002a68dfdc00;
    enum { FACTOR_E = -93 };
    seed[0] = (int32_t)step((uint32_t)seed[0], 40014, 0x80000000u - NOISE_M1);
    seed[1] = (int32_t)step((uint32_t)seed[1], 40692, 0x80000000u - NOISE_M2);
    int32_t z = (int32_t)((uint32_t)seed[0] - (uint32_t)seed[1]);
    if (z < 1) z += NOISE_M1 - 1;
    /* z * FACTOR rounded as a double is. The product of 32 and 63 bits is in [2^93, 2^95). */
    const int n = ints_clz32((uint32_t)z | 1);
    const wide_u_t p = wide_mul_u64_u32(FACTOR, (uint32_t)z << n);
    const words_t u = words((uint32_t)p.hi << 1 | (uint32_t)(p.lo >> 63), (uint32_t)(p.lo >> 31));
    return num_double_round_lost(u, (uint32_t)p.lo << 1, FACTOR_E + 31 - n, 0);
}

/* One copy: it is long where a core multiplies 32 bits. */
static __attribute__((noinline)) uint64_t scramble(uint64_t hash, uint64_t factor) {
    return wide_mul_low_u64(hash, factor);
}

uint64_t noise_at(uint64_t hash, num_t a) {
    /* splitmix64's finaliser over the bits of the number */
    hash += (uint64_t)a.m + ((uint64_t)(uint16_t)a.e << 1);
    hash = scramble(hash ^ hash >> 30, 0xbf58476d1ce4e5b9u);
    hash = scramble(hash ^ hash >> 27, 0x94d049bb133111ebu);
    return hash ^ hash >> 31;
}
