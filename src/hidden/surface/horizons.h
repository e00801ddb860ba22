/* horizons.h - the upper and the lower horizon of a scene as one: what lies between them is hidden.
 *
 * A line is clipped against the upper horizon, and against the lower one unless all of it was above; what rises
 * from bare ground starts both. Views from above or below a surface need only one. */
#ifndef HORIZONS_H
#define HORIZONS_H

#include "hidden/surface/lowest.h"

typedef struct horizons {
    envelope_t upper, lower;
    bool has_upper, has_lower;
    bool in_plane; /* the vertical line at hand is in the eye's own plane, not only nearly */
    envelope_count_t count;
    envelope_take_t take; /* gets visible parts as fractions from p0 to p1, in no particular order */
    void *ctx;
    bool skip_upper, skip_lower;         /* the caller knows that nothing rises above it (falls below it) */
    bool flip, whole;                    /* of the line being clipped: p0 is on the right; all of it was above */
    lowest_t lowest_upper, lowest_lower; /* what is known of the horizons without looking */
} horizons_t;

/* Empty horizons in pool[0..count). Returns 0 or ERR_FULL. */
int horizons_init(horizons_t *h, bool upper, bool lower, pencil_t *pool, size_t count, envelope_take_t take, void *ctx);

/* Lends memory to remember how low the horizons are, 2^bits entries for each of the two: worth it where they have many
 * vertices. */
void horizons_lend(horizons_t *h, uint16_t *mem, int bits);

/* Is all from abscissa a0 to a1 that is no higher than top hidden by h? Rather no than wrongly yes. What l did not
 * know, it learns. */
static inline bool horizons_see(envelope_t *h, lowest_t *l, int32_t a0, int32_t a1, int32_t top) {
    if (!CONFIG_LOWEST || l->w == NULL) return envelope_hides(h, a0, a1, top);
    const int32_t w = envelope_lowest(h, a0, a1, top);
    if (w < top) return false;
    lowest_learn(l, a0, a1, w);
    return true;
}

/* Clips the line p0-p1 and raises the horizons. Lines that are vertical (envelope_vertical) are clipped at their
 * abscissa: in the eye's own plane they are hidden where either side hides them, so that edges that all lie on one line
 * of the page are drawn once; otherwise where both sides do. Returns 0, ERR_FULL, or take's error. */
int horizons_clip(horizons_t *h, pencil_t p0, pencil_t p1);

/* Takes what is visible of a line; the horizons stay as they are. */
int horizons_look(horizons_t *h, pencil_t p0, pencil_t p1);

/* Raises the horizons by a line, l.a < r.a, whose visible parts are known. */
int horizons_raise(horizons_t *h, pencil_t l, pencil_t r);

#endif
