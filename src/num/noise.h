/* noise.h - random numbers, and where they begin at a place.
 *
 * The generator is that of gnuplot's specfun.c with the same seeds (P. L'Ecuyer, "Efficient and portable combined
 * random number generators", CACM 31, 1988, fig. 3), so that a script draws the same picture here and there, and on
 * every target. Its two moduli are a little less than 2^31, so that it goes without division: what is above 31 bits of
 * a product counts 85 (249) times below.
 *
 * Seeds of a place are a hash of the numbers that say where it is: noise is then a function of the place, in whatever
 * order places are looked at. Cost on a Cortex-M0+: 180 cycles a number, 110 a coordinate. */
#ifndef NOISE_H
#define NOISE_H

#include "num/num.h"

enum { NOISE_M1 = 2147483563, NOISE_M2 = 2147483399, NOISE_START = 1234567890 };

/* The next number, in ]0, 1[. Seeds are from 1 to NOISE_M1 - 1 and NOISE_M2 - 1; with others it is some number. */
num_t noise_next(int32_t seed[2]);

/* The hash of no coordinate yet; that with another one; the seeds that belong to it. */
static inline uint64_t noise_hash(const int32_t seed[2]) {
    return (uint64_t)(uint32_t)seed[0] << 32 | (uint32_t)seed[1];
}
uint64_t noise_at(uint64_t hash, num_t a);
static inline void noise_seeds(uint64_t hash, int32_t seed[2]) {
    enum { MASK = 0x3fffffff };
    seed[0] = (int32_t)((uint32_t)hash & MASK) + 1;
    seed[1] = (int32_t)((uint32_t)(hash >> 32) & MASK) + 1;
}

#endif
