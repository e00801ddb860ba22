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
#include <string.h>

typedef struct lowest {
    int16_t *w; /* above LOWEST_LEAST; NULL: nothing is known */
    int shift;
} lowest_t;

#define LOWEST_UNIT_BITS 16
#define LOWEST_LEAST (ENVELOPE_FLOOR >> LOWEST_UNIT_BITS)
#define LOWEST_LANES 8 /* that many are looked at in one go, and read: mem has as many beyond its last */
#define LOWEST_MANY 16 /* a line over more stretches is looked for in the horizon */

/* Of a horizon of width 2^31, in 2^bits stretches: mem has as many entries. */
static inline lowest_t lowest_make(int16_t *mem, int bits) {
    for (int32_t k = 0; k < INT32_C(1) << bits; k++) mem[k] = 0;
    return (lowest_t){mem, 31 - bits};
}

static inline size_t lowest_bytes(const lowest_t *l) {
    return !CONFIG_LOWEST || l->w == NULL ? 0 : sizeof *l->w << (31 - l->shift);
}

static inline uint32_t lowest_place(const lowest_t *l, int32_t a) {
    return ((uint32_t)a + (UINT32_C(1) << 30)) >> l->shift;
}

/* Four heights in a word, none negative: those that are at least `least` have bit 15 set. */
static inline uint64_t lowest_lanes(const int16_t *w, uint32_t least) {
    const uint64_t ONES = UINT64_C(0x0001000100010001), TOPS = ONES << 15;
    uint64_t lanes;
    memcpy(&lanes, w, sizeof lanes);
    return (lanes | TOPS) - ONES * least;
}

/* lowest_hides for up to eight stretches without a branch: how many there are, and which of them is too low, is as good
 * as random, and guessing wrong costs more than all of it. What is read beyond `to` is masked. */
static inline bool lowest_hides_few(const lowest_t *l, uint32_t from, uint32_t to, int32_t top) {
    static const uint16_t BEYOND[2 * LOWEST_LANES] = {
        [LOWEST_LANES] = 0xffff, 0xffff, 0xffff, 0xffff, 0xffff, 0xffff, 0xffff, 0xffff};
    const uint16_t *masks = BEYOND + LOWEST_LANES - 1 - (to - from);
    const uint32_t least = (uint32_t)((top >> LOWEST_UNIT_BITS) + 1 - LOWEST_LEAST);
    uint64_t m0, m1;
    memcpy(&m0, masks, sizeof m0);
    memcpy(&m1, masks + 4, sizeof m1);
    m0 |= lowest_lanes(l->w + from, least);
    m1 |= lowest_lanes(l->w + from + 4, least);
    return ((m0 & m1) | ~(UINT64_C(0x8000800080008000))) == UINT64_MAX;
}

/* Is all from abscissa a0 to a1 that is no higher than `top` hidden for sure? Beside the ends, too. */
static inline bool lowest_hides(const lowest_t *l, int32_t a0, int32_t a1, int32_t top) {
    if (!CONFIG_LOWEST || l->w == NULL) return false;
    const uint32_t from = lowest_place(l, a0 - 1), to = lowest_place(l, a1 + 1);
    if (CONFIG_64BIT && to - from < LOWEST_LANES) return lowest_hides_few(l, from, to, top);
    if (to - from > LOWEST_MANY) return false;
    int32_t least = INT16_MAX;
    for (uint32_t k = from; k <= to; k++) least = pencil_min(least, l->w[k]);
    return (top >> LOWEST_UNIT_BITS) - LOWEST_LEAST < least;
}

/* The horizon is nowhere below w from a0 to a1. */
static inline void lowest_learn(lowest_t *l, int32_t a0, int32_t a1, int32_t w) {
    const uint32_t from = lowest_place(l, a0 - 1) + 1, to = lowest_place(l, a1);
    const int32_t least = (w >> LOWEST_UNIT_BITS) - 1 - LOWEST_LEAST;
    for (uint32_t k = from; k < to && k - from < LOWEST_MANY; k++) l->w[k] = (int16_t)pencil_max(l->w[k], least);
}

#endif
