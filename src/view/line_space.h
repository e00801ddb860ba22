/* line_space.h - places on the lines of a scene, in homogeneous page coordinates.
 *
 * The stages after the hidden-line kernels know a point as (line, parameter) only (hidden/ink.h). A line space says
 * where that is: H = (X, Y, E) with page = (X / E, Y / E) in lat, all int64_t in units of 2^-frac_bits, |X|, |Y| < 2^60
 * and 0 < E < 2^35 in front of the eye, linear in the parameter between two vertices. Grids, profiles and flat curves
 * each have their own; cutting and drawing are the same for all. */
#ifndef LINE_SPACE_H
#define LINE_SPACE_H

#include "config.h"
#include "hidden/ink.h"
#include "num/num.h"
#include "view/page.h"

/* The part of the paper that may be drawn on, in lat. */
typedef struct page_window {
    int32_t x0_lat, y0_lat, x1_lat, y1_lat;
} page_window_t;

typedef struct page_h {
    int64_t x, y, e;
} page_h_t;

typedef struct line_space {
    void *ctx;
    /* False where there is no such point (a hole). */
    bool (*at)(void *ctx, uint8_t family, int32_t line, int64_t t, page_h_t *h);
    /* The same as at, in scaled integers, or NULL: for points so close (line_space_is_close) that lat would be lost in
     * these units. No point in front of the eye is too close then. */
    bool (*exact)(void *ctx, uint8_t family, int32_t line, int64_t t, num_t h[3]);
#if CONFIG_FETCH
    /* The same as at for from < to between two vertices next to each other, sooner; false if they are not, or if it
     * does not know. Or NULL. */
    bool (*span)(void *ctx, uint8_t family, int32_t line, int64_t from, int64_t to, page_h_t h[2]);
#endif
    const page_window_t *window;
    bool perspective;
    bool all_inside; /* no point is outside of the window: nothing needs cutting */
    int frac_bits;   /* parallel: E == 2^frac_bits everywhere, frac_bits > 0 */
    int64_t near_e;  /* with less E a point is behind the eye or too close to it to be drawn */
} line_space_t;

/* Is a point so close that its place wants `exact`? near_e is 2^-20 of the most. */
static inline bool line_space_is_close(const line_space_t *s, int64_t e) {
    return s->exact != 0 && e < s->near_e << 5;
}

/* a + (b - a) * s / 2^30 (2^46) in each coordinate, |a|, |b| < 2^61: how `at` interpolates between vertices. */
page_h_t line_space_mix(const page_h_t *a, const page_h_t *b, int32_t s_q30);
page_h_t line_space_mix_fine(const page_h_t *a, const page_h_t *b, int64_t s_q46);
/* The one of the two that a family's parameters want. */
static inline page_h_t line_space_between(uint8_t family, const page_h_t *a, const page_h_t *b, int64_t s) {
    return ink_bits(family) == INK_ONE_BITS ? line_space_mix(a, b, (int32_t)s) : line_space_mix_fine(a, b, s);
}
/* Where a line's picture is divided as u to w, u + w <= 2^31: how far along it that is in space, of `way`, if its ends
 * have e0 and e1, neither negative: way u e0 / (u e0 + w e1). */
int64_t line_space_share(int64_t u, int64_t w, int64_t e0, int64_t e1, int64_t way);
/* Divides homogeneous coordinates out, to the nearest lat. h->e > 0. */
page_point_t line_space_divide(const line_space_t *s, const page_h_t *h);
/* The page point of a parameter, clamped to the window where a rounded cut fell outside by a hair; false if it is
 * not on the paper. */
bool line_space_point(const line_space_t *s, uint8_t family, int32_t line, int64_t t, page_point_t *out);
#if CONFIG_FETCH
/* The same of two, from <= to. */
bool line_space_span(const line_space_t *s, uint8_t family, int32_t line, int64_t from, int64_t to,
                     page_point_t out[2]);
#endif

#endif
