/* decimal_scan.h - the characters of a plain decimal, eight at a time.
 *
 * Eight digits in a register become a number by three products (as in D. Lemire, "Number parsing at a gigabyte per
 * second", 2021, section 5). Where a number ends is found by one sum. Registers of 64 bits only; field.c is what all
 * targets have, and what is asked about everything that is not plain. */
#ifndef DECIMAL_SCAN_H
#define DECIMAL_SCAN_H

#include "scene/packed_decimal.h"
#include <string.h>

#if CONFIG_64BIT
#define DECIMAL_SCAN_MARGIN 48 /* characters that are at hand from the first of a number: its own, 8, and one more */
#define DECIMAL_DIGITS 19      /* more of them can overflow the mantissa */

/* May c be in the middle of a plain decimal? */
static inline bool decimal_has(char c) {
    return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+' || (c | 32) == 'e' || (c | 32) == 'd';
}

/* The next 8 characters less '0', the first in the lowest byte. */
static inline uint64_t decimal_eight(const char *p) {
    uint64_t w;
    memcpy(&w, p, 8);
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
    w = __builtin_bswap64(w);
#endif
    return w ^ 0x3030303030303030u;
}

/* How many of them are digits, before the first that is none. A sum that carries is above a byte that is none. */
static inline int decimal_count(uint64_t w) {
    const uint64_t others = ((w + 0x7676767676767676u) | w) & 0x8080808080808080u;
    return others ? __builtin_ctzll(others) >> 3 : 8;
}

/* The value of the first n of them, 1 to 8. */
static inline uint64_t decimal_value(uint64_t w, int n) {
    w <<= 64 - 8 * n;
    w = w * 10 + (w >> 8);
    const uint64_t mask = 0x000000ff000000ffu;
    return (((w & mask) * 0x000f424000000064u) + ((w >> 16 & mask) * 0x0000271000000001u)) >> 32;
}

/* Digits from p on are added to *mantissa, and how many there were to *digits, up to DECIMAL_DIGITS. */
static inline const char *decimal_run(const char *p, uint64_t *mantissa, int *digits) {
    static const uint32_t TEN[9] = {1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000};
    for (int n = 8; n == 8 && *digits <= DECIMAL_DIGITS;) {
        const uint64_t w = decimal_eight(p);
        n = decimal_count(w);
        if (n) *mantissa = *mantissa * TEN[n] + decimal_value(w, n);
        *digits += n;
        p += n;
    }
    return p;
}

/* e+12: adds to *exp10. NULL if it is none, or of more digits than a number needs. */
static inline const char *decimal_exponent(const char *p, int32_t *exp10) {
    p++;
    const bool negative = *p == '-';
    if (negative || *p == '+') p++;
    const uint64_t w = decimal_eight(p);
    const int n = decimal_count(w);
    if (n < 1 || n > 4) return NULL;
    const int32_t value = (int32_t)decimal_value(w, n);
    *exp10 += negative ? -value : value;
    return p + n;
}

/* Any decimal of at most 19 digits. p: behind the sign. */
static inline const char *decimal_scan_long(const char *p, decimal_t *d) {
    int digits = 0;
    d->mantissa = 0;
    d->exp10 = 0;
    p = decimal_run(p, &d->mantissa, &digits);
    if (digits <= DECIMAL_DIGITS && *p == '.') {
        const int whole = digits;
        p = decimal_run(p + 1, &d->mantissa, &digits);
        d->exp10 = whole - digits;
    }
    if (digits == 0 || digits > DECIMAL_DIGITS) return NULL;
    const char letter = (char)(*p | 32);
    return letter == 'e' || letter == 'd' ? decimal_exponent(p, &d->exp10) : p;
}

/* The decimal at p, of which DECIMAL_SCAN_MARGIN characters are at hand. Returns the character behind it, or NULL if
 * there is none, or one of more digits. The value is what field.h makes of it. */
static inline const char *decimal_scan(const char *p, decimal_t *d) {
    d->negative = *p == '-';
    p += d->negative | (*p == '+');
    const uint64_t w = decimal_eight(p);
    const int whole = decimal_count(w);
    if (NUM_FAST_RARE(whole == 8 || p[whole] != '.')) {
        const bool ends = (p[whole] | 32) != 'e' && (p[whole] | 32) != 'd';
        if (whole == 8 || whole == 0 || !ends) return decimal_scan_long(p, d);
        d->mantissa = decimal_value(w, whole);
        d->exp10 = 0;
        return p + whole;
    }
    const uint64_t v = decimal_eight(p + whole + 1);
    const int part = decimal_count(v), n = whole + part;
    const char *end = p + n + 1;
    if (NUM_FAST_RARE(n > 8 || part == 8 || n == 0 || (*end | 32) == 'e' || (*end | 32) == 'd'))
        return decimal_scan_long(p, d);
    /* Both runs of digits, without the point between them. */
    d->mantissa = decimal_value((w & (((uint64_t)1 << 8 * whole) - 1)) | v << 8 * whole, n);
    d->exp10 = -part;
    return end;
}
#endif

#endif
