/* packed.h - a number in 8 bytes: how heights of data wait in memory.
 *
 * The layout is IEEE 754 binary64, done with integers: sign, 11 bits of exponent, 52 of fraction. So a file's
 * decimals round to what gnuplot reads from it (53 bits, ties to even), a host may look at the pool as doubles,
 * and a NaN is a hole. Beyond +-1.8e308 a value is a hole too; below 2.2e-308 it is zero (no subnormals). */
#ifndef PACKED_H
#define PACKED_H

#include "num/num.h"

typedef uint64_t packed_t;
#define PACKED_HOLE ((packed_t)0x7ff8000000000000u)

/* Nearest packed value: relative error at most 2^-53. */
packed_t packed_from_num(num_t a);
/* Exact. */
num_t packed_num(packed_t p);

#endif
