/* bands.h - a cover with gaps: for several surfaces, where two horizons are not enough.
 *
 * Over each abscissa the cover is a sorted list of disjoint bands [lo, hi]. It is kept as strips: between two abscissae
 * the bands are trapezoids, bounded by straight lines that do not cross.
 *
 *      w |   ____----~~~~|          a strip: a, n, n times (lo, lo', hi, hi'), n - from its left end to its right;
 *        |   |####|######|          the next strip's a is where it ends
 *        |   ----____    |
 *        |   |   |   ~~~~|          Strips lie in a gap buffer, in words, readable from both ends.
 *        +---|---|-------|---- a
 *
 * Two operations: clip a line (what is in no band is visible; the cover stays as it is), and add the region that a few
 * lines bound. Neighbouring strips that continue each other straight are joined, so strips are as many as the cover has
 * corners. The bit budget is that of envelope.h. Error: a boundary cut at an abscissa is rounded once, half a unit;
 * lines closer than ENVELOPE_NOISE coincide, and what coincides with a boundary is hidden. Cost per facet: a few
 * divisions for each band of the strips it touches; three to ten times that of the horizons. */
#ifndef BANDS_H
#define BANDS_H

#include "hidden/envelope.h"

typedef struct bands {
    int32_t *base, *l, *r, *end; /* [base, l) strips, gap, [r, end) strips, in words */
    int32_t narrow;              /* see envelope_vertical */
    int32_t peak;                /* most words used */
    envelope_count_t count;
    envelope_take_t take; /* gets visible parts as fractions from p0 to p1 */
    void *ctx;
} bands_t;

/* What bounds a region from one abscissa on: a line of the chart. */
typedef struct bands_line {
    pencil_t p, q; /* p.a < q.a */
} bands_line_t;

/* An empty cover in pool[0..words). Returns 0, or ERR_FULL for less than 32 words. */
int bands_init(bands_t *b, int32_t narrow, int32_t *pool, size_t words, envelope_take_t take, void *ctx);

/* Gives the visible parts of the line p0-p1 to take. A vertical line has cover to its left and right: `right` says
 * which counts. Returns 0 or take's error. */
int bands_clip(bands_t *b, pencil_t p0, pencil_t p1, bool right);

/* Is all that lies within [a0, a1] x [low, high] covered, by one band in each strip? (Rather no than wrongly yes.) */
bool bands_hide(bands_t *b, int32_t a0, int32_t a1, int32_t low, int32_t high);

/* Adds the region between `n` lines, n <= BANDS_LINES: over each abscissa from the lowest to the highest of the lines
 * there; where there is only one, from it down to the floor (below > 0), up to the ceiling (below < 0), or nothing (0).
 * `inset` units at the top and the bottom are left out. Returns 0, or ERR_FULL, and the cover is then useless. */
#define BANDS_LINES 32
int bands_add(bands_t *b, const bands_line_t *line, int32_t n, int below, int32_t inset);

#endif
