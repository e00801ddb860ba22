/* chain.h - pairs the ends of runs that meet, so that strokes go on through nodes.
 *
 * Ends within near_lat of each other on the page form a cluster: a node of the grid, a silhouette's corner, two curves
 * that touch. Within a cluster the straightest pairs are taken first (two runs of one line are straighter than
 * anything), so no run is ever cut to turn, and at most one end of a cluster stays free. That gives half as many
 * strokes as there are nodes of odd degree, Euler's minimum, up to closed strokes, which loop.h then opens. Memory: the
 * pool's work area. Cost: linear; a hash over page cells of those that have neighbours (census.h), and directions only
 * where three or more ends meet. */
#ifndef CHAIN_H
#define CHAIN_H

#include "path/near.h"
#include "path/pool.h"

#define CHAIN_CLUSTER 8  /* ends that are paired together: a grid node has four */
#define CHAIN_MANY 65536 /* runs whose ends are sorted by their places (places.h), if there is memory */
#define CHAIN_BEHIND_WORDS(runs) (7 * (2 * (runs) + 2) + 3)

typedef struct chain {
    pool_t *pool;
    const ink_map_t *map;
    int32_t near_lat;
    int32_t room;        /* runs that there is memory for */
    int32_t free;        /* ends of open strokes, after chain_close */
    page_point_t *point; /* of every end */
    int32_t *next;       /* next end in the same bucket, or -1 */
    int32_t *head;       /* buckets */
    uint32_t mask;       /* buckets - 1 */
    int shift;           /* page cells are 2^shift lat wide */
#if CONFIG_MANY_STROKES
    near_extent_t box;           /* of all ends; of very many only, as the next two */
    uint32_t *plain;             /* a bit for each run: it has no vertex between its ends; or NULL */
    int32_t *behind;             /* CHAIN_BEHIND_WORDS or more for what sorts them */
    const struct places *places; /* where free ends are looked for, or NULL */
#endif
} chain_t;

/* Finds the page points of all ends, and changes nothing else: runs keep their order of arrival. But those that the map
 * does not find are removed, and counted in the result. */
int32_t chain_place(chain_t *c, pool_t *pool, const ink_map_t *map, int32_t near_lat);
/* Pairs ends: fills pool->mate; free ends are negative until chain_close says more. */
void chain_pair(chain_t *c);
/* Links the two free ends of every stroke, and marks the runs of open strokes RUN_SEEN that have no free end. Returns
 * the number of open strokes. */
int32_t chain_close(chain_t *c);
/* Is the run r part of a closed stroke, and not marked RUN_SEEN since? */
static inline bool chain_is_closed(const pool_t *p, int32_t r) {
    return p->mate[2 * r] >= 0 && p->mate[2 * r + 1] >= 0 && !(p->run[r].to_hi & RUN_SEEN);
}

static inline bool chain_is_near(const chain_t *c, page_point_t a, page_point_t b) {
    int64_t dx = (int64_t)a.x_lat - b.x_lat, dy = (int64_t)a.y_lat - b.y_lat;
    if (dx > c->near_lat || dx < -c->near_lat || dy > c->near_lat || dy < -c->near_lat) return false;
    return dx * dx + dy * dy <= (int64_t)c->near_lat * c->near_lat;
}

#if CONFIG_MANY_STROKES
static inline bool chain_is_plain(const chain_t *c, int32_t r) {
    return c->plain[r / 32] >> r % 32 & 1;
}
#endif

/* Free ends within near_lat of p: up to max of them into out. Returns how many. Ends met on the way that are no longer
 * free are forgotten. */
int chain_free_ends(const chain_t *c, page_point_t p, int32_t *out, int max);
/* Enters the free ends near the places asked for in between, and a few others, for chain_free_ends to find. A rough
 * surface has few closed strokes, and hundreds of thousands of free ends that need not be entered. */
void chain_ask_begin(chain_t *c, int32_t places);
void chain_ask(chain_t *c, page_point_t p);
void chain_ask_end(chain_t *c);
/* Enters the end e, at p and not entered yet, for chain_free_ends to find. */
void chain_enter(chain_t *c, int32_t e, page_point_t p);

#endif
