/* value.h - what an expression yields: an integer, a real, a text, or nothing.
 *
 * As in gnuplot, integers are 64 bits wide and stay integers under + - * / % ** and the bit operators; a
 * result that does not fit becomes real. Reals are what a double can hold, see
 * num_double.h. VALUE_UNDEF stands for gnuplot's NaN and for every undefined result.
 *
 * 16 bytes. A real value holds its num_t field for field (VALUE_UNDEF being num_t's undef).
 */
#ifndef VALUE_H
#define VALUE_H

#include "num/num.h"
#include <stddef.h>
#include <string.h>

enum value_kind {
    VALUE_REAL = 0,
    VALUE_UNDEF = 1,
    VALUE_INT = 2,
    VALUE_TEXT = 4, /* CONFIG_CONTROL: m is where it is (texts.h), ended by a zero, e how many bytes it has */
};

typedef struct value {
    wide_s64_t m; /* the integer, or the significand of the real */
    int32_t e;    /* 0, or the exponent of the real */
    uint8_t kind; /* enum value_kind */
} value_t;

static inline value_t value_int(int64_t i) {
    return (value_t){i, 0, VALUE_INT};
}
static inline value_t value_undef(void) {
    return (value_t){0, 0, VALUE_UNDEF};
}
/* An undefined number becomes VALUE_UNDEF. */
static inline value_t value_real(num_t n) {
    return (value_t){n.m, n.e, n.undef};
}
static inline value_t value_text(const char *text, size_t len) {
    return (value_t){(int64_t)(intptr_t)text, (int32_t)len, VALUE_TEXT};
}
static inline const char *value_chars(value_t text) {
    return (const char *)(intptr_t)text.m;
}
/* The double nearest to i. */
num_t value_from_integer(int64_t i);
/* The real number that v stands for: an integer becomes the nearest double, nothing stays
 * undefined, and so does a text. */
static inline num_t value_num(value_t v) {
    if (v.kind == VALUE_INT) return value_from_integer(v.m);
    return (num_t){v.m, v.e, v.kind != VALUE_REAL};
}

/* Writes v as gnuplot's `print` does, ended by a zero: integers in decimal, reals by %.15g with ".0" added when there
 * is neither a point nor an exponent, VALUE_UNDEF as NaN. buf holds VALUE_TEXT_MAX bytes or more.
 * Returns the number of bytes before the zero. */
#define VALUE_TEXT_MAX 26
size_t value_format(value_t v, char buf[VALUE_TEXT_MAX]);

#endif
