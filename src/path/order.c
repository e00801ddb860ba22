/* order.c - see order.h. */
#include "path/order.h"

#include "path/chain.h"
#include "path/dist.h"
#include "path/emit.h"
#include "path/loop.h"
#include "path/match.h"
#include "path/meet.h"

/* Operations per stroke below which the tour is left as it is: what they could save is one part in 10,000 of the time
 * that so many strokes take. */
#define EFFORT_LEAST 4

bool order_drop_dot(path_t *p, const page_point_t *point, int32_t start) {
    if (!emit_is_dot(&p->pool, p->map, point, start, p->config.step_lat)) return false;
    p->stats.dots++;
    emit_drop(&p->pool, start);
    return true;
}

static bool is_apart(page_point_t a, page_point_t b, int32_t by_lat) {
    int32_t dx = a.x_lat - b.x_lat, dy = a.y_lat - b.y_lat;
    if (dx >= by_lat || dx <= -by_lat || dy >= by_lat || dy <= -by_lat) return true; /* as most are */
    return dist_of(dx, dy) >= (uint32_t)by_lat;
}

/* Drops the stroke at the free end e, if it is a dot. */
static bool drop_dot(path_t *p, const chain_t *c, int32_t e) {
    const int32_t far = ~p->pool.mate[e];
    if (is_apart(c->point[e], c->point[far], p->config.step_lat) || !order_drop_dot(p, c->point, e)) return false;
    p->pool.mate[e] = far; /* free no more */
    p->pool.mate[far] = e;
    return true;
}

/* Dots need not be in the tour, once nothing can come that continues them. */
static void drop_dots(path_t *p, const chain_t *c) {
    for (int32_t e = 0; e < 2 * p->pool.n; e++) {
        if (~p->pool.mate[e] > e) drop_dot(p, c, e);
    }
}

#if CONFIG_MANY_STROKES
/* Pairs the ends of very many runs. */
static bool pair_many(path_t *p, places_t *places, chain_t *chain, bool all) {
    if (!places_sort(places, chain, p->leaves, p->config.home, p->config.step_lat)) return false;
    meet_pair(places);
    order_tell(p, all, TOLD_PAIRED);
    for (int32_t k = 0; all && k < 2 * places->briefs; k++) {
        const int32_t at = places->brief[k / 2][k % 2];
        if (!places_is_marked(places->now.spot[at]) && drop_dot(p, chain, places->now.place[at].end))
            places_drop(places, at);
    }
    return true;
}
#endif

static void pair(path_t *p, chain_t *chain, bool all) {
    chain_pair(chain);
    order_tell(p, all, TOLD_PAIRED);
    chain_close(chain);
    if (loop_find(chain)) loop_open(chain);
    if (all) drop_dots(p, chain);
}

void order_strokes(path_t *p, tour_t *tour, bool all, bool improve) {
    chain_t chain;
    pool_t *pool = &p->pool;
    p->stats.lost += chain_place(&chain, pool, p->map, p->config.step_lat / 4);
    order_tell(p, all, TOLD_PLACED);
#if CONFIG_MANY_STROKES
    places_t places;
    const bool many = pair_many(p, &places, &chain, all);
    if (!many) pair(p, &chain, all);
    if (many && match_order(&places, tour)) {
        order_tell(p, all, TOLD_ORDERED);
        return;
    }
#else
    pair(p, &chain, all);
#endif
    tour_collect(tour, &chain, p->leaves, p->config.home);
    pool_tick(pool);
    order_tell(p, all, TOLD_CLOSED);
    tour_greedy(tour);
    order_tell(p, all, TOLD_ORDERED);
    pool_tick(pool);
    int64_t operations = improve ? (int64_t)p->config.effort * tour->n : 0;
    if (operations > p->config.effort_max) operations = p->config.effort_max;
    if (operations < (int64_t)EFFORT_LEAST * tour->n) operations = 0;
    tour->tick = pool->tick;
    tour->tick_ctx = p;
    tour_improve(tour, operations);
    tour_settle(tour);
}
