/* hatch.h - hatching: two families of parallel lines over the page, square to each other, of which polygons show parts.
 *
 * A hatch line is implicit: number k of a family lies k pitches from the middle of the page, and a place on it is a
 * parameter, so nothing is stored but the visible parts (intervals.h), and polygons side by side with one tone are
 * hatched by the same lines, drawn through. Six tones are made of them, by brightness (what light a place gets, as a
 * share of the most): none from .85 on, every fourth line from .65, every second from .45, every line from .25, then
 * every second line of the other family too, and where there is no light every line of both.
 *
 * Numbers: places along (u) and across (w) a family count 2^-30 units of the polygons' lattice; |u|, |w| < 2^62. A
 * crossing with an edge is exact but for one rounding to 2^-30 of the line, 2^-6 lat on A4. */
#ifndef HATCH_H
#define HATCH_H

#include "hidden/intervals.h"
#include "num/num.h"
#include "poly/poly.h"
#include "view/line_space.h"

/* The last is for what is translucent: every fourth line of the other family, over the tone of what is behind. */
enum hatch_tone { HATCH_NONE, HATCH_FAINT, HATCH_LIGHT, HATCH_MIDDLE, HATCH_DEEP, HATCH_DARK, HATCH_CLEAR };

/* The tone of a brightness. */
static inline enum hatch_tone hatch_tone_of(int64_t bright_q30) {
    const int64_t percent = INK_ONE / 100;
    return bright_q30 >= 85 * percent   ? HATCH_NONE
           : bright_q30 >= 65 * percent ? HATCH_FAINT
           : bright_q30 >= 45 * percent ? HATCH_LIGHT
           : bright_q30 >= 25 * percent ? HATCH_MIDDLE
           : bright_q30 > 0             ? HATCH_DEEP
                                        : HATCH_DARK;
}

#define HATCH_MIN_LAT (LAT_PER_MM / 10) /* least pitch */

typedef struct hatch {
    line_space_t lines; /* of family INK_CURVE, line = number of a hatch line */
    page_point_t middle;
    int32_t cos_q30, sin_q30;
    int32_t pitch_lat;
    int32_t reach_lat; /* lines reach so far to either side of the middle, and lines lie so far from it */
    int32_t half;      /* lines of a family are numbered -half .. half */
    int bits;          /* 1 lat is 2^bits units of the polygons */
} hatch_t;

/* A family of lines at `degrees` from the x axis (the other square to it), pitch_lat >= HATCH_MIN_LAT apart. The window
 * outlives h. */
void hatch_setup(hatch_t *h, const page_window_t *window, num_t degrees, int32_t pitch_lat);
/* How many lines there are, both families. */
int32_t hatch_lines(const hatch_t *h);
/* Which lines of a family a tone has: every so-manieth, a power of two; 0: none. */
static inline int32_t hatch_step(enum hatch_tone tone, bool second) {
    static const uint8_t step[2][HATCH_CLEAR + 1] = {{0, 4, 2, 1, 1, 1, 0}, {0, 0, 0, 0, 2, 1, 4}};
    return step[second][tone];
}

/* A place along (u) and across (w) a family. */
typedef struct hatch_place {
    int64_t u, w;
} hatch_place_t;

hatch_place_t hatch_place(const hatch_t *h, bool second, poly_point_t p);
/* The w of line k. */
int64_t hatch_line_at(const hatch_t *h, int32_t k);
/* The lines that places with these least and greatest w may lie around: *lo to *hi. */
void hatch_range(const hatch_t *h, int64_t low, int64_t high, int32_t *lo, int32_t *hi);
/* The number of line k of a family in h->lines. */
int32_t hatch_number(const hatch_t *h, bool second, int32_t k);
/* Where line `at` crosses an edge from a to b: its parameter there. *part: of the way from a to b. False: nowhere. A
 * vertex on the line belongs to the side below it. */
bool hatch_cross(const hatch_t *h, hatch_place_t a, hatch_place_t b, int64_t at, int32_t *t_q30, int32_t *part_q30);
/* Adds the parts of hatch lines inside a polygon (even-odd) that give it this tone; line numbers count from `first`.
 * Returns 0 or ERR_FULL. Cost: lines across the polygon times its edges. */
int hatch_polygon(const hatch_t *h, const poly_t *p, enum hatch_tone tone, int32_t first, intervals_t *to);

#endif
