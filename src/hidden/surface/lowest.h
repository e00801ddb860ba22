/* lowest.h - a height that a horizon is nowhere below, for each of many stretches of the abscissa.
 *
 * A horizon only rises. So how low it is over a stretch, once looked up, holds for good, and most of what lies behind a
 * rough surface can be told to be hidden without going to the horizon, whose vertices are many there: 18 over each
 * column of a random 1000 x 1000. Stretches are 2^shift wide; a height is kept in units of 2^16, rounded down by one to
 * two of them, which is far more than what rounding its vertices can lower a horizon by. So the answer "hidden" is the
 * same as clipping would give, and a kernel without memory for this finds the same ink. */
#ifndef LOWEST_H
#define LOWEST_H

#include "config.h"
#include "hidden/surface/envelope.h"

typedef struct lowest {
    int16_t *w; /* NULL: nothing is known */
    int shift;
} lowest_t;

#define LOWEST_UNIT_BITS 16
#define LOWEST_LEAST (ENVELOPE_FLOOR >> LOWEST_UNIT_BITS)
#define LOWEST_MANY 16 /* a line over more stretches is looked for in the horizon */

/* Of a horizon of width 2^31, in 2^bits stretches: mem has as many entries. */
static inline lowest_t lowest_make(int16_t *mem, int bits) {
    for (int32_t k = 0; k < INT32_C(1) << bits; k++) mem[k] = LOWEST_LEAST;
    return (lowest_t){mem, 31 - bits};
}

static inline size_t lowest_bytes(const lowest_t *l) {
    return !CONFIG_LOWEST || l->w == NULL ? 0 : sizeof *l->w << (31 - l->shift);
}

static inline uint32_t lowest_place(const lowest_t *l, int32_t a) {
    return ((uint32_t)a + (UINT32_C(1) << 30)) >> l->shift;
}

/* Is all from abscissa a0 to a1 that is no higher than `top` hidden for sure? Beside the ends, too. */
static inline bool lowest_hides(const lowest_t *l, int32_t a0, int32_t a1, int32_t top) {
    if (!CONFIG_LOWEST || l->w == NULL) return false;
    const uint32_t from = lowest_place(l, a0 - 1), to = lowest_place(l, a1 + 1);
    if (to - from > LOWEST_MANY) return false;
    int32_t least = INT16_MAX;
    for (uint32_t k = from; k <= to; k++) least = pencil_min(least, l->w[k]);
    return (top >> LOWEST_UNIT_BITS) < least;
}

/* The horizon is nowhere below w from a0 to a1. */
static inline void lowest_learn(lowest_t *l, int32_t a0, int32_t a1, int32_t w) {
    const uint32_t from = lowest_place(l, a0 - 1) + 1, to = lowest_place(l, a1);
    const int32_t least = (w >> LOWEST_UNIT_BITS) - 1;
    for (uint32_t k = from; k < to && k - from < LOWEST_MANY; k++) l->w[k] = (int16_t)pencil_max(l->w[k], least);
}

#endif
