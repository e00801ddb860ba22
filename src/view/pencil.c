/* pencil.c - a division for cores that have none. See pencil.h. */
#include "view/pencil.h"

#include "num/ints.h"

#define DIGIT_BITS 10 /* of the quotient at a time */
#define TOP_SHIFT 18  /* leaves 16 bits of 34 */

/* 2^31 / (d + 1), or at most 1 part in 6,500 less, for d in [2^15, 2^16): a straight line and two steps of Newton's. */
static uint32_t inverse(uint32_t d) {
    int32_t r = 95493 - (int32_t)d;
    for (int k = 0; k < 2; k++) {
        const int32_t off = (int32_t)((UINT32_C(1) << 31) - (uint32_t)r * d);
        r += ((off >> 15) * r) >> 16;
    }
    return (uint32_t)r - 2;
}

/* Three digits of the quotient, each taken from the upper 16 bits of the remainder and put right by one at the most: it
 * is low by 2^10 (1 / 6,500 + 2^-15), no more than 0.2, before it is rounded down. Products are of 32 bits. */
uint32_t pencil_divide(uint64_t num, uint64_t den) {
    const int up = ints_clz64(den) - 30; /* to 34 bits */
    if (up > 0) {
        den <<= up;
        num <<= up;
    } else {
        den >>= -up;
        num >>= -up;
    }
    const uint32_t per_top = inverse((uint32_t)(den >> TOP_SHIFT));
    const uint32_t low = (uint32_t)den & 0xffff, high = (uint32_t)(den >> 16);
    uint32_t quotient = 0;
    for (int k = 0; k < 3; k++) {
        uint32_t digit = ((uint32_t)(num >> TOP_SHIFT) * per_top) >> 21;
        num = (num << DIGIT_BITS) - ((uint64_t)(digit * high) << 16) - digit * low;
        if (num >= den) {
            num -= den;
            digit++;
        }
        quotient = (quotient << DIGIT_BITS) + digit;
    }
    return quotient;
}
