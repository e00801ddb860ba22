/* order.h - what is in the pool, put in order: the stages between runs and drawing (path.h).
 *
 *     placed (chain.h) -> paired (chain.h; meet.h if very many) -> closed strokes opened (loop.h) -> dots dropped
 *                      -> in order (tour.h; match.h if very many)
 *
 * How far that is, and then drawing, is told in hundredths; a stage counts as much as it takes when there are a million
 * runs. */
#ifndef ORDER_H
#define ORDER_H

#include "path/path.h"
#include "path/tour.h"

enum { TOLD_PLACED = 15, TOLD_PAIRED = 35, TOLD_CLOSED = 38, TOLD_ORDERED = 65, TOLD_ALL = 100 };

static inline void order_tell(const path_t *p, bool all, int32_t done) {
#if CONFIG_TELL_ORDER
    if (all && p->config.tell) p->config.tell(p->config.tell_ctx, done, TOLD_ALL);
#else
    (void)p, (void)all, (void)done;
#endif
}

/* Puts the strokes of the pool in order. all: nothing can come that continues a stroke. improve: there is time for it.
 */
void order_strokes(path_t *p, tour_t *tour, bool all, bool improve);
/* If the stroke that starts at an end is a dot, it is counted and done with. point: as for emit_stroke. */
bool order_drop_dot(path_t *p, const page_point_t *point, int32_t start);

#endif
