/* dice.h - the random numbers of a unit test: the same in every run, from the file's own DICE_SEED (not 0). */
#ifndef DICE_H
#define DICE_H

#include <stdint.h>

static inline uint64_t dice(void) { /* Marsaglia's xorshift */
    static uint64_t state = DICE_SEED;
    state ^= state << 13, state ^= state >> 7, state ^= state << 17;
    return state;
}

/* In [0, 1). */
static inline double uniform(void) {
    return (double)(dice() >> 11) * 0x1p-53;
}

/* From 0 to n - 1. */
static inline int32_t below(int32_t n) {
    return (int32_t)((dice() >> 11) % (uint64_t)n);
}

#endif
