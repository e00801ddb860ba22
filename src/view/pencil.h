/* pencil.h - a point in pencil coordinates: what the chart makes and the horizons are built of.
 *
 * The pencil is that of the vertical planes through the eye. `a` says which plane, `w` how high in it the line of
 * sight passes; both are integers of a scale chosen per scene. Straight lines stay straight, vertical ones
 * vertical, and of two points with equal a the one with the greater w is seen higher. */
#ifndef PENCIL_H
#define PENCIL_H

#include "config.h"
#include <stdint.h>

#define PENCIL_LIMIT ((INT32_C(1) << 30) - 16) /* |a|, |w| of a scene's points */

typedef struct pencil {
    int32_t a, w;
} pencil_t;

static inline int32_t pencil_min(int32_t a, int32_t b) {
    return a < b ? a : b;
}
static inline int32_t pencil_max(int32_t a, int32_t b) {
    return a > b ? a : b;
}
static inline int32_t pencil_abs(int32_t v) {
    return v < 0 ? -v : v;
}

/* pencil_fraction without a division, in some 200 instructions of a core that has to make do with sums and 32-bit
 * products (the compiler's library takes 430 for the division alone). The same result. */
uint32_t pencil_divide(uint64_t num, uint64_t den);

/* num / den rounded down (q30); 0 <= num <= den. Good to 2^-32 at least; costs one 64-bit division. */
static inline uint32_t pencil_fraction(uint64_t num, uint64_t den) {
    if (den == 0) return 0;
    if (!CONFIG_DIVIDES) return pencil_divide(num, den);
    if (den >> 34 != 0) { /* num << 30 must fit */
        const int by = 30 - __builtin_clzll(den);
        num >>= by;
        den >>= by;
    }
    return (uint32_t)((num << 30) / den);
}

/* The ordinate at abscissa a of the line p-q, to nearest; p.a <= a <= q.a. One division unless a is at an end. */
static inline int32_t pencil_ordinate(pencil_t p, pencil_t q, int32_t a) {
    if (a == p.a || p.w == q.w) return p.w;
    if (a == q.a) return q.w;
    const uint32_t run = (uint32_t)(q.a - p.a), rise = (uint32_t)pencil_abs(q.w - p.w);
    const int32_t part = (int32_t)(((uint64_t)rise * (uint32_t)(a - p.a) + run / 2) / run);
    return q.w < p.w ? p.w - part : p.w + part;
}

#endif
