/* cut.h - cuts ink to the printable part of the paper, and off what is behind the eye.
 *
 * An ink sink that hands on what is inside, in grid parameters again: the planes of the window are clipped
 * against each cell of a piece in homogeneous space (Liang and Barsky's parametric clip), so nothing is ever divided by
 * a depth near zero. Crossings are rounded inward by at most 2^-30 of a cell. If the whole grid is inside, use the next
 * sink directly. */
#ifndef CUT_H
#define CUT_H

#include "hidden/ink.h"
#include "view/line_space.h"

typedef struct cut {
    const line_space_t *lines; /* one per surface of the scene: lines[p->surface] */
    ink_sink_t next;
} cut_t;

/* The part of [*from, *to], a line between h0 and h1, that is inside of w (|w| < 2^25) and in front of the eye; false
 * if there is none. */
bool cut_between(const line_space_t *s, const page_window_t *w, const page_h_t *h0, const page_h_t *h1, int64_t *from,
                 int64_t *to);
/* c must outlive the sink. */
ink_sink_t cut_sink(cut_t *c);

#endif
