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
    uint16_t *w; /* above LOWEST_LEAST, and bit 15, by which four are compared at once; NULL: nothing is known */
    int shift;
} lowest_t;

#define LOWEST_UNIT_BITS 16
#define LOWEST_LEAST (ENVELOPE_FLOOR >> LOWEST_UNIT_BITS)
#define LOWEST_BIT 0x8000
#define LOWEST_LANES 8 /* that many are looked at in one go, and read: mem has as many beyond its last */
#define LOWEST_MANY 16 /* a line over more stretches is looked for in the horizon */

/* Of a horizon of width 2^31, in 2^bits stretches: mem has as many entries. */
static inline lowest_t lowest_make(uint16_t *mem, int bits) {
    for (int32_t k = 0; k < INT32_C(1) << bits; k++) mem[k] = LOWEST_BIT;
    return (lowest_t){mem, 31 - bits};
}

static inline size_t lowest_bytes(const lowest_t *l) {
    return !CONFIG_LOWEST || l->w == NULL ? 0 : sizeof *l->w << (31 - l->shift);
}

static inline uint32_t lowest_place(const lowest_t *l, int32_t a) {
    return ((uint32_t)a + (UINT32_C(1) << 30)) >> l->shift;
}

/* What a stretch must have, without bit 15, for what is no higher than `top` to be hidden. */
static inline uint32_t lowest_wanted(int32_t top) {
    return (uint32_t)((top >> LOWEST_UNIT_BITS) + 1 - LOWEST_LEAST);
}

/* Four stretches: those that have what is wanted have bit 15 set. */
static inline uint64_t lowest_lanes(const uint16_t *w, uint32_t wanted) {
    uint64_t lanes;
    memcpy(&lanes, w, sizeof lanes);
    return lanes - UINT64_C(0x0001000100010001) * wanted;
}

/* lowest_hides for up to eight stretches without a branch: how many there are, and which of them is too low, is as good
 * as random, and guessing wrong costs more than all of it. What is read beyond `to` is masked. Both l and m, of the
 * same stretches, have to hide; they may be one. */
static inline bool lowest_hide_few(const lowest_t *l, const lowest_t *m, uint32_t from, uint32_t to, int32_t top_l,
                                   int32_t top_m) {
    static const uint16_t BEYOND[2 * LOWEST_LANES] = {
        [LOWEST_LANES] = 0xffff, 0xffff, 0xffff, 0xffff, 0xffff, 0xffff, 0xffff, 0xffff};
    const uint16_t *masks = BEYOND + LOWEST_LANES - 1 - (to - from);
    const uint32_t wanted_l = lowest_wanted(top_l), wanted_m = lowest_wanted(top_m);
    uint64_t m0, m1;
    memcpy(&m0, masks, sizeof m0);
    memcpy(&m1, masks + 4, sizeof m1);
    m0 |= lowest_lanes(l->w + from, wanted_l) & lowest_lanes(m->w + from, wanted_m);
    m1 |= lowest_lanes(l->w + from + 4, wanted_l) & lowest_lanes(m->w + from + 4, wanted_m);
    return ((m0 & m1) | ~(UINT64_C(0x8000800080008000))) == UINT64_MAX;
}

/* Is all from abscissa a0 to a1 that is no higher than `top` hidden for sure? Beside the ends, too. */
static inline bool lowest_hides(const lowest_t *l, int32_t a0, int32_t a1, int32_t top) {
    if (!CONFIG_LOWEST || l->w == NULL) return false;
    const uint32_t from = lowest_place(l, a0 - 1), to = lowest_place(l, a1 + 1);
    if (CONFIG_64BIT && to - from < LOWEST_LANES) return lowest_hide_few(l, l, from, to, top, top);
    if (to - from > LOWEST_MANY) return false;
    uint32_t least = UINT16_MAX;
    for (uint32_t k = from; k <= to; k++) least = l->w[k] < least ? l->w[k] : least;
    return LOWEST_BIT + lowest_wanted(top) <= least;
}

/* The horizon is nowhere below w from a0 to a1. */
static inline void lowest_learn(lowest_t *l, int32_t a0, int32_t a1, int32_t w) {
    const uint32_t from = lowest_place(l, a0 - 1) + 1, to = lowest_place(l, a1);
    const uint32_t least = (uint32_t)(LOWEST_BIT + (w >> LOWEST_UNIT_BITS) - 1 - LOWEST_LEAST);
    for (uint32_t k = from; k < to && k - from < LOWEST_MANY; k++) {
        if (l->w[k] < least) l->w[k] = (uint16_t)least;
    }
}

#endif
