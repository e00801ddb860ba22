/* packed.c - rounding a 63-bit significand to binary64's 53 bits and back, in integers. */
#include "scene/packed.h"

#define FRACTION_BITS 52
#define EXPONENT_MAX 2047
#define BIAS 1023

packed_t packed_from_num(num_t a) {
    if (a.undef) return PACKED_HOLE;
    if (a.m == 0) return 0;
    uint64_t sign = a.m < 0 ? 1 : 0;
    uint64_t mag = sign ? 0 - (uint64_t)a.m : (uint64_t)a.m; /* [2^62, 2^63) */
    int32_t exponent = a.e + 62 + BIAS;
    uint64_t q = (mag + 0x1ff + ((mag >> 10) & 1)) >> 10; /* 53 bits, ties to even */
    if (q >> (FRACTION_BITS + 1)) {
        q >>= 1;
        exponent++;
    }
    if (exponent >= EXPONENT_MAX) return PACKED_HOLE;
    if (exponent <= 0) return 0;
    return sign << 63 | (uint64_t)exponent << FRACTION_BITS | (q & (((uint64_t)1 << FRACTION_BITS) - 1));
}

num_t packed_num(packed_t p) {
    num_t a = {0, 0, false};
    int32_t exponent = (int32_t)(p >> FRACTION_BITS) & EXPONENT_MAX;
    if (exponent == EXPONENT_MAX) {
        a.undef = true;
        return a;
    }
    if (exponent == 0) return a;
    uint64_t q = ((uint64_t)1 << FRACTION_BITS) | (p & (((uint64_t)1 << FRACTION_BITS) - 1));
    int64_t m = (int64_t)(q << 10);
    a.m = p >> 63 ? -m : m;
    a.e = (int16_t)(exponent - BIAS - 62);
    return a;
}
