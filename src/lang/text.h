/* text.h - messages put together in a fixed buffer; what does not fit is cut, never overrun. */
#ifndef TEXT_H
#define TEXT_H

#include "lang/value.h"
#include "said.h"

typedef struct text {
    char *buf;
    size_t size, len; /* len < size; buf is always ended by a zero */
} text_t;

text_t text_start(char *buf, size_t size); /* size >= 1 */
void text_add(text_t *t, const char *s);
void text_add_bytes(text_t *t, const char *s, size_t n);
/* A text of the program, which may be packed (said.h). */
void text_add_said(text_t *t, const char *text);
/* What came from outside: a ? for each control character. */
void text_add_shown(text_t *t, const char *s, size_t n);
void text_add_int(text_t *t, int64_t v);
/* As `print` shows a real, but integers without ".0". */
void text_add_num(text_t *t, num_t v);
/* v / 10^decimals without trailing zeros: micrometres as millimetres with decimals = 3. */
void text_add_scaled(text_t *t, int64_t v, int decimals);

#endif
