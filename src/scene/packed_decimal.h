/* packed_decimal.h - a decimal of a file to the word it waits in, sooner than through num.h.
 *
 * One product of the digits with the power of five, of 64 by 64 bits, says how most decimals round to 53 bits (D.
 * Lemire, "Number parsing at a gigabyte per second", 2021). Where it does not, one in 300, num_from_decimal() and
 * packed_from_num() are asked. The words are theirs in every case, bit for bit: so a board, which has no room for the
 * table, reads the same heights. */
#ifndef PACKED_DECIMAL_H
#define PACKED_DECIMAL_H

#include "config.h"
#include "num/num_fast.h"
#include "scene/packed.h"

/* Digits as they were read: mantissa * 10^exp10. */
typedef struct decimal {
    uint64_t mantissa;
    int32_t exp10;
    bool negative;
} decimal_t;

static inline num_t decimal_num(decimal_t d) {
    const num_t a = num_from_decimal(d.mantissa, d.exp10);
    return d.negative ? num_fast_neg(a) : a;
}

#if CONFIG_64BIT
#define DECIMAL_POWER_MIN (-40)
#define DECIMAL_POWER_MAX 27
/* 5^e, the leading 64 bits, rounded down; exact from 0 on. */
extern const uint64_t decimal_power5[DECIMAL_POWER_MAX - DECIMAL_POWER_MIN + 1];

/* packed_from_num(decimal_num(d)). */
static inline packed_t decimal_packed(decimal_t d) {
    const uint32_t row = (uint32_t)(d.exp10 - DECIMAL_POWER_MIN);
    if (NUM_FAST_RARE(d.mantissa == 0)) return 0;
    if (NUM_FAST_RARE(row > DECIMAL_POWER_MAX - DECIMAL_POWER_MIN)) return packed_from_num(decimal_num(d));
    const int zeros = ints_clz64(d.mantissa);
    /* The true product is in [h, h + 2), once its top bit is at 63 in [h, h + 4). */
    uint64_t h = wide_mulhi_u64(d.mantissa << zeros, decimal_power5[row]);
    const int up = (int)(~h >> 63);
    h <<= up;
    /* num.h rounds to 63 bits before packed.h does to 53, so half an ulp is in doubt by 1 more on either side. */
    if (NUM_FAST_RARE((h & 0x7ff) - 0x3fa < 9)) return packed_from_num(decimal_num(d));
    const uint64_t q = (h >> 11) + (h >> 10 & 1); /* 2^53 counts into the exponent, as it should */
    /* floor(log2(5^exp10)) is exp10 * 152170 / 2^16 in this range. */
    const int32_t exponent = (d.exp10 * 152170 >> 16) + d.exp10 + 64 - zeros - up;
    return (uint64_t)d.negative << 63 | (((uint64_t)(uint32_t)(exponent + 1023 - 1) << 52) + q);
}
#endif

#endif
