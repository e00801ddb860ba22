/* bands_strip.h - how the strips of bands.h lie in memory: for bands.c and bands_add.c only. */
#ifndef BANDS_STRIP_H
#define BANDS_STRIP_H

#include "hidden/bands.h"

#define BANDS_HEAD 2 /* words before a strip's bands */
#define BANDS_WORDS(n) (BANDS_HEAD + 4 * (n) + 1)

/* A band between the left and right end of a strip. */
typedef struct band {
    int32_t lo0, lo1, hi0, hi1;
} band_t;

_Static_assert(sizeof(band_t) == 4 * sizeof(int32_t), "a band is four words of a strip");

/* The strip at r: */
static inline int32_t bands_of(const int32_t *r) {
    return r[1];
}
static inline int32_t bands_end(const int32_t *r) {
    return r[BANDS_WORDS(r[1])];
}
static inline band_t bands_at(const int32_t *r, int32_t k) {
    const int32_t *v = r + BANDS_HEAD + 4 * k;
    return (band_t){v[0], v[1], v[2], v[3]};
}

static inline void bands_move_right(bands_t *b) {
    for (int32_t n = BANDS_WORDS(bands_of(b->r)); n > 0; n--) *b->l++ = *b->r++;
}

static inline void bands_move_left(bands_t *b) {
    for (int32_t n = BANDS_WORDS(b->l[-1]); n > 0; n--) *--b->r = *--b->l;
}

/* Moves the gap before the strip that begins at or before a and ends after it. */
static inline void bands_seek(bands_t *b, int32_t a) {
    while (b->r[0] > a) bands_move_left(b);
    while (bands_end(b->r) <= a) bands_move_right(b);
}

/* The ordinate at x of the line from (x0, v0) to (x1, v1), to nearest. */
static inline int32_t bands_ordinate(int32_t x0, int32_t v0, int32_t x1, int32_t v1, int32_t x) {
    return pencil_ordinate((pencil_t){x0, v0}, (pencil_t){x1, v1}, x);
}

/* The part [x0, x1] of the strip at r with its band k. */
static inline band_t bands_between(const int32_t *r, int32_t k, int32_t x0, int32_t x1) {
    const int32_t s0 = r[0], s1 = bands_end(r);
    band_t v = bands_at(r, k);
    return (band_t){bands_ordinate(s0, v.lo0, s1, v.lo1, x0), bands_ordinate(s0, v.lo0, s1, v.lo1, x1),
                    bands_ordinate(s0, v.hi0, s1, v.hi1, x0), bands_ordinate(s0, v.hi0, s1, v.hi1, x1)};
}

#endif
