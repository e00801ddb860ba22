/* ink.c - see ink.h. */
#include "hidden/ink.h"

int64_t ink_next(uint8_t family, int64_t t, int64_t to) {
    const int bits = ink_bits(family);
    if (t < to) {
        const int64_t next = ((t >> bits) + 1) << bits;
        return next < to ? next : to;
    }
    const int64_t next = ((t - 1) >> bits) * ((int64_t)1 << bits);
    return next > to ? next : to;
}
