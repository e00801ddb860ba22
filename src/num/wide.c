/* The one operation of wide.h that is too long to be inline: schoolbook division in base 2^32
 * (Knuth, The Art of Computer Programming, volume 2, algorithm 4.3.1 D). */
#include "num/wide.h"

#ifdef __SIZEOF_INT128__

uint64_t wide_div_u64(uint64_t hi, uint64_t lo, uint64_t d, uint64_t *rem) {
    wide_native_u_t n = (wide_native_u_t)hi << 64 | lo;
    *rem = (uint64_t)(n % d);
    return (uint64_t)(n / d);
}

#else

/* One digit: floor((u * 2^32 + next) / d) for u < d, d >= 2^63; the remainder replaces *u. */
static uint32_t digit(uint64_t *u, uint32_t next, uint64_t d) {
    uint32_t dh = (uint32_t)(d >> 32), dl = (uint32_t)d;
    uint64_t q = *u / dh, r = *u % dh;
    while (q >> 32 || q * dl > (r << 32 | next)) {
        q--;
        r += dh;
        if (r >> 32) break;
    }
    *u = (*u << 32 | next) - q * d;
    return (uint32_t)q;
}

uint64_t wide_div_u64(uint64_t hi, uint64_t lo, uint64_t d, uint64_t *rem) {
    int s = __builtin_clzll(d);
    uint64_t u = hi;
    if (s != 0) {
        d <<= s;
        u = hi << s | lo >> (64 - s);
        lo <<= s;
    }
    uint32_t q1 = digit(&u, (uint32_t)(lo >> 32), d);
    uint32_t q0 = digit(&u, (uint32_t)lo, d);
    *rem = u >> s;
    return (uint64_t)q1 << 32 | q0;
}

#endif
