/* picture_pens.h - several pens for one picture: a pass for each, so that each is taken once.
 *
 * A pass does all the work again and lets only the lines of its pen through to the ordering of strokes: sorting them
 * into one pool would need memory for all, where a small one draws what comes first. A picture of one pen, which is
 * nearly every one, costs nothing more. */
#ifndef PICTURE_PENS_H
#define PICTURE_PENS_H

#include "hidden/line_class.h"
#include "view/page.h"

struct plot;          /* lang/plot.h */
struct picture_stats; /* picture.h */

typedef struct pens {
    const uint8_t *pen_of; /* by class: settings */
    uint8_t now;           /* the pen of this pass */
    bool announced;        /* it has drawn something */
    uint8_t of_space[32];  /* pen of each line space (ink_piece_t.surface) */
    ink_sink_t next_ink;
    pen_sink_t next_pen;
    int (*announce)(void *ctx, int number); /* may be NULL */
    void *ctx;
} pens_t;

/* A bit for each pen that may have something to draw; bit 1 is pen 1. */
uint32_t pens_wanted(const struct plot *plot);
/* Lets ink of this pass's pen through to next. */
ink_sink_t pens_ink(pens_t *p, ink_sink_t next);
/* Tells of the pen before its first stroke. */
pen_sink_t pens_sink(pens_t *p, const pen_sink_t *next);

/* Adds what a pass took to the sum of those before. */
void pens_add(struct picture_stats *sum, const struct picture_stats *pass);

#endif
