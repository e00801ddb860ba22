/* spans.h - sets of real numbers as sorted lists of disjoint intervals.
 *
 * The oracle and its judge say everything as such sets: what of a grid line is hidden, what is drawn, and what is
 * left when one is taken from the other. Lists grow on the heap; a zeroed struct is the empty set. */
#ifndef SPANS_H
#define SPANS_H

#include <stddef.h>

typedef struct span {
    long double a, b; /* a < b */
} span_t;

typedef struct spans {
    span_t *s;
    size_t n, cap;
} spans_t;

/* Keeps of *v where the linear function with values f0 at 0 and f1 at 1 is positive; empty is a > b. */
void span_keep_positive(span_t *v, long double f0, long double f1);

void spans_free(spans_t *s);
/* Makes s empty and keeps its memory. */
void spans_clear(spans_t *s);
/* Appends [a, b] without looking at the rest; nothing happens unless a < b. Call spans_tidy before any other use. */
void spans_add(spans_t *s, long double a, long double b);
/* Sorts, and merges what touches or overlaps. */
void spans_tidy(spans_t *s);
/* The results below go to out (not an argument at the same time); arguments are tidy and so is the result. */
void spans_complement(const spans_t *s, long double lo, long double hi, spans_t *out);
void spans_intersect(const spans_t *p, const spans_t *q, spans_t *out);
void spans_subtract(const spans_t *p, const spans_t *q, spans_t *out); /* p without q */
void spans_copy(const spans_t *s, spans_t *out);

#endif
