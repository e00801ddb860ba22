/* tour.h - the order of the strokes: a closed tour from where the pen is, past every stroke, to home.
 *
 * Stroke k has the items 2k and 2k+1, its two ends. The order is an array of items: the end at which each stroke is
 * entered. One more stroke stands for the pen: entered at home, left where the pen is; so the tour is a circle that may
 * be turned and mirrored at will, and is put right at the end. tour_improve is 2-opt and Or-opt over near ends, then
 * rounds of a random exchange of two neighbouring stretches that are kept if repair makes them shorter (Johnson and
 * McGeoch 1997 call it iterated local search; the generator is seeded, so the order is the same everywhere). Its work
 * is counted, not timed. */
#ifndef TOUR_H
#define TOUR_H

#include "path/chain.h"
#include "path/near.h"

#define TOUR_QUIET (1 << 30) /* in tour.end: nothing around this stroke can be improved at the moment */
#define TOUR_PLAIN (1 << 30) /* in tour.order */

#define TOUR_FETCH 6         /* strokes that memory is asked for ahead, three times */
#define TOUR_FETCH_WINDING 3 /* and of those that are not plain, twice */
#define TOUR_FETCH_VERTICES 4

typedef struct tour {
    int32_t n;      /* strokes, without the pen's */
    int32_t *order; /* n + 1 items: the end at which the stroke at this place is entered. Or, if `end` is NULL, n ends
                       of runs (match.h), and TOUR_PLAIN */
    int32_t *place; /* n + 1: the stroke's place in order, for tour_improve */
    int32_t *end;   /* n: n + 1: a free end of the stroke (pool.h), that item 2k stands for; and TOUR_QUIET */
    spot_t *spot;   /* 2 (n + 1) items */
    const page_point_t *point; /* of every end of a run, if there was memory to keep them; or NULL */
#if CONFIG_MANY_STROKES
    int32_t *winding; /* if `end` is NULL: the places of those that are not TOUR_PLAIN, in order */
    int32_t windings, wound;
#endif
    near_t near;
    int64_t budget;          /* operations left: a distance computed, or four places moved, is one */
    void (*tick)(void *ctx); /* called now and then by tour_improve, or NULL */
    void *tick_ctx;
} tour_t;

/* Takes the free ends out of the chain, whose arrays end with this (they share memory). `at` is where the pen is,
 * `home` where it is wanted afterwards. */
void tour_collect(tour_t *t, const chain_t *c, page_point_t at, page_point_t home);
/* Always to the nearest end. Cost near-linear. */
void tour_greedy(tour_t *t);
/* Shortens the tour within so many operations. */
void tour_improve(tour_t *t, int64_t operations);
/* Turns the circle so that the pen's stroke is last, and everything is entered as said. */
void tour_settle(tour_t *t);
/* Is the stroke in place k known to be a single run without a vertex between its ends? */
static inline bool tour_is_plain(const tour_t *t, int32_t k) {
    return CONFIG_MANY_STROKES && !t->end && (t->order[k] & TOUR_PLAIN);
}
/* The end from which the stroke in place k is to be drawn, 0 <= k < n. */
int32_t tour_stroke(const tour_t *t, const pool_t *pool, int32_t k);
#if CONFIG_FETCH
/* The stroke to be drawn is the next that is not TOUR_PLAIN: asks for what those read that come soon. */
void tour_fetch_winding(tour_t *t, const pool_t *pool, ink_fetch_t fetch, void *ctx);
/* To be called before the stroke in place k is drawn: asks the cache for those that come soon, and `fetch` (or NULL)
 * for the vertices between their ends. */
void tour_fetch(const tour_t *t, const pool_t *pool, int32_t k, ink_fetch_t fetch, void *ctx);
#endif

#endif
