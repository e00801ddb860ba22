/* format.h - sprintf's conversions of numbers, for titles and names of files. */
#ifndef FORMAT_H
#define FORMAT_H

#include "lang/text.h"

/* One conversion: %[-+ 0#][width][.precision] and d i u x X o c e E f F g G. */
typedef struct format {
    bool left, plus, blank, zero, sharp;
    int32_t width, precision; /* precision -1: none given */
    char type;
} format_t;

#define FORMAT_WIDTH_MAX 100
#define FORMAT_PRECISION_MAX 30

/* Reads a conversion behind its %. Returns how many bytes it takes, or 0 if it is none of these, or of s or %. */
size_t format_read(const char *spec, format_t *f);
/* Adds v so written. Integers are rounded towards 0 as gnuplot does; reals have 17 good digits, and zeros behind them.
 */
void format_number(text_t *t, const format_t *f, value_t v);
/* n bytes of text so padded and cut (%s). */
void format_text(text_t *t, const format_t *f, const char *text, size_t n);

#endif
