/* strip.h - one strip of the abscissa at a time, so that horizons take a part of their memory.
 *
 * What is visible in a vertical plane through the eye depends on that plane alone, so a scene may be hidden strip by
 * strip: a sweep over the surface for each, in which lines are cut at its borders. The horizons reach a little beyond
 * the strip, so that its borders are places like any other; the ink ends exactly there, at a fraction of the whole
 * line, and so the next strip's begins where it ended. */
#ifndef STRIP_H
#define STRIP_H

#include "hidden/hidden.h"
#include "hidden/surface/envelope.h"

#define STRIP_MARGIN 16 /* units by which the horizons reach beyond it */

typedef struct strip {
    int32_t from, to; /* [from, to) is drawn */
    bool first;       /* also draws what has no abscissa */
    /* Of the line at hand, in fractions of it from p0 to p1: what was clipped, and what of it is to be drawn. */
    int32_t cut_q30[2], keep_q30[2];
} strip_t;

/* From `from` to `to` of the HIDDEN_STRIPS (hidden.h) between abscissae lo and hi; the first and the last one go on for
 * ever. */
void strip_init(strip_t *s, int32_t lo, int32_t hi, int from, int to);

/* Cuts the line p0-p1 off a little beyond the strip. False if nothing is left. */
bool strip_cut(strip_t *s, pencil_t *p0, pencil_t *p1);

/* What is to be drawn of a part of the line that was cut, in fractions of the line before. False if nothing is. */
bool strip_keep(const strip_t *s, envelope_part_t *part);

/* Is all from abscissa a0 to a1 drawn in this strip? Or nothing, and no horizon of it feels it? */
static inline bool strip_has(const strip_t *s, int32_t a0, int32_t a1) {
    return a0 >= s->from && a1 < s->to;
}
static inline bool strip_lacks(const strip_t *s, int32_t a0, int32_t a1) {
    return a1 < s->from - STRIP_MARGIN || a0 > s->to + STRIP_MARGIN;
}

#endif
