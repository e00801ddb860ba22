/* tour.c - collects strokes, orders them greedily. See tour.h; improvement is in improve.c. */
#include "path/tour.h"

#define CROWD 1 /* items to a cell: the search looks at the fewest */

_Static_assert(POOL_WORK_PER_RUN >= 4 * (2 + 1 + 1 + 1 + 2 + 1), "items, order, place, end, spots, cells");
_Static_assert(sizeof(near_cell_t) == 8 && sizeof(spot_t) == 4, "the layout below");

/* With a third of the pool unused the tour lies behind the chain's points, which drawing then need not compute again.
 * Otherwise over them: items, order and place are set up after the points are read, and the rest was links and buckets,
 * which are no longer needed. */
static void lay_out(tour_t *t, const chain_t *c) {
    size_t m = (size_t)c->pool->n + 1, all = ((size_t)c->pool->cap + 1) * (POOL_WORK_PER_RUN / 4);
    size_t points = 4 * m, used = 2 * m + m + m + m + 2 * m;
    bool keep = points + used + m <= all;
    if (!keep) points = 0;
    int32_t *w = (int32_t *)(void *)c->pool->work + points;
#if CONFIG_MANY_STROKES
    if (c->plain) {
        keep = true;
        w = c->behind;
        points = 0;
        all = (size_t)((int32_t *)(void *)pool_end(c->pool) - w);
    }
#endif
    t->point = keep ? c->point : NULL;
    t->near.item = w;
    t->order = w + 2 * m;
    t->place = w + 3 * m;
    t->end = w + 4 * m;
    t->spot = (spot_t *)(void *)(w + 5 * m);
    t->near.cell = (near_cell_t *)(void *)(w + 7 * m);
    size_t cells = (all - points - used) / 2;
    t->near.cells_max = cells < 8 * m ? (int32_t)cells : (int32_t)(8 * m);
    t->near.spot = t->spot;
}

void tour_collect(tour_t *t, const chain_t *c, page_point_t at, page_point_t home) {
    const int32_t *mate = c->pool->mate;
    near_extent_t box = {at.x_lat, at.y_lat, at.x_lat, at.y_lat, 0};
    int32_t ends = 2 * c->pool->n;
    lay_out(t, c);
    near_include(&box, home);
    for (int32_t e = 0; e < ends; e++) {
        if (mate[e] < 0) near_include(&box, c->point[e]);
    }
    near_fit(&box);
    t->n = 0;
    for (int32_t e = 0; e < ends; e++) {
        if (mate[e] >= 0 || ~mate[e] < e) continue;
        t->end[t->n] = e;
        t->spot[2 * t->n] = near_spot(&box, c->point[e]);
        t->spot[2 * t->n + 1] = near_spot(&box, c->point[~mate[e]]);
        t->n++;
    }
    t->end[t->n] = 0;
    t->spot[2 * t->n] = near_spot(&box, home);
    t->spot[2 * t->n + 1] = near_spot(&box, at);
}

void tour_greedy(tour_t *t) {
    int32_t left = t->n, built = t->n;
    int32_t from = 2 * t->n + 1;
    spot_t at = t->spot[from];
    near_build(&t->near, t->n, CROWD);
    while (left > 0) {
        if (left <= built / 4) { /* keep the grid as coarse as what is left is sparse */
            near_thin(&t->near, CROWD);
            built = left;
        }
        int32_t item = near_take(&t->near, at, from);
        from = item ^ 1;
        at = t->spot[from]; /* before it is marked: read as a whole what is written in parts, it would have to wait */
        near_mark(t->spot, item >> 1);
        t->order[t->n - left--] = item;
    }
    t->order[t->n] = 2 * t->n;
}

static inline bool is_of_ends(const tour_t *t) {
    return CONFIG_MANY_STROKES && !t->end;
}

static void turn_back(int32_t *item, int32_t from, int32_t to) {
    for (; from < to; from++, to--) {
        int32_t keep = item[from];
        item[from] = item[to];
        item[to] = keep;
    }
}

void tour_settle(tour_t *t) {
    int32_t n = t->n, pen = n;
    if (t->order[n] == 2 * n) return; /* as tour_greedy leaves it */
    while (t->order[pen] >> 1 != n) pen--;
    if (t->order[pen] != 2 * n) { /* the pen's stroke is entered where it should be left: mirror the circle */
        turn_back(t->order, 0, n);
        for (int32_t k = 0; k <= n; k++) t->order[k] ^= 1;
        pen = n - pen;
    }
    turn_back(t->order, 0, pen); /* rotate by three reversals */
    turn_back(t->order, pen + 1, n);
    turn_back(t->order, 0, n);
}

int32_t tour_stroke(const tour_t *t, const pool_t *pool, int32_t k) {
    if (is_of_ends(t)) return t->order[k] & ~TOUR_PLAIN;
    int32_t item = t->order[k], e = t->end[item >> 1] & ~TOUR_QUIET;
    return item & 1 ? ~pool->mate[e] : e;
}

#if CONFIG_FETCH
static int32_t end_at(const tour_t *t, int32_t k) {
    if (is_of_ends(t)) return t->order[k] & ~TOUR_PLAIN;
    return t->end[t->order[k] >> 1] & ~TOUR_QUIET;
}

/* The vertices of a run between its ends. */
static void fetch_between(const run_t *r, ink_fetch_t fetch, void *ctx) {
    const uint8_t family = run_family(r);
    const int64_t to = run_t_of(r, 1);
    int64_t t = ink_next(family, run_t_of(r, 0), to);
    for (int n = 0; t != to && n < TOUR_FETCH_VERTICES; n++, t = ink_next(family, t, to))
        fetch(ctx, family, run_surface(r), run_line(r), t);
}

/* What emitting a run reads. */
static void fetch_run(const tour_t *t, const pool_t *pool, int32_t e) {
    __builtin_prefetch(&pool->run[e >> 1]);
    __builtin_prefetch(&pool->run[e >> 1].what); /* a run may lie across two lines of the cache */
    __builtin_prefetch(&pool->mate[e]);
    if (t->point) __builtin_prefetch(&t->point[e & ~1]);
}

/* Of a stroke whose first run is there: the vertices of that, and the next run. */
static void fetch_on(const tour_t *t, const pool_t *pool, int32_t e, ink_fetch_t fetch, void *ctx) {
    if (fetch) fetch_between(&pool->run[e >> 1], fetch, ctx);
    const int32_t next = pool->mate[pool_other_end(e)];
    if (next >= 0) fetch_run(t, pool, next);
}

#if CONFIG_MANY_STROKES
/* Which strokes are plain is guessed wrong as often as not: so it is asked where they are drawn, and nowhere else. */
void tour_fetch_winding(tour_t *t, const pool_t *pool, ink_fetch_t fetch, void *ctx) {
    if (!is_of_ends(t)) return;
    const int32_t k = t->wound++;
    if (k + 2 * TOUR_FETCH_WINDING >= t->windings) return;
    fetch_on(t, pool, end_at(t, t->winding[k + TOUR_FETCH_WINDING]), fetch, ctx);
    fetch_run(t, pool, end_at(t, t->winding[k + 2 * TOUR_FETCH_WINDING]));
}
#endif

void tour_fetch(const tour_t *t, const pool_t *pool, int32_t k, ink_fetch_t fetch, void *ctx) {
    if (k + 3 * TOUR_FETCH >= t->n) return;
    const int32_t e = end_at(t, k + 2 * TOUR_FETCH);
    if (is_of_ends(t)) {
        __builtin_prefetch(&t->point[e & ~1]); /* nothing else is needed of a plain one */
        return;
    }
    fetch_on(t, pool, end_at(t, k + TOUR_FETCH), fetch, ctx);
    __builtin_prefetch(&t->end[t->order[k + 3 * TOUR_FETCH] >> 1]);
    fetch_run(t, pool, e);
}
#endif
