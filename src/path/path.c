/* path.c - the stages of path.h put together: when the pool is full, and at the end. */
#include "path/path.h"
#include "error.h"
#include "path/dist.h"
#include "path/emit.h"
#include "path/order.h"

/* A full pool draws a half of its strokes; the rest stays to be continued. Smaller parts make 3 % fewer strokes, but
 * travel twice as far to them; keeping the youngest strokes instead of the farthest does the same. */
#define FLUSH_PART 2

/* With a feed: strokes are settled when the pen has less than this to do, until it has that much. */
#define FEED_LEAST_US 1000000
#define FEED_ENOUGH_US 4000000
#define FEED_MEMORY_PART 8 /* of the memory, at most, is the outbox */

#define TELL_STROKES 16384

void path_default(path_config_t *c, uint32_t steps_per_mm_q16) {
    uint64_t step_q16 = steps_per_mm_q16 ? ((uint64_t)LAT_PER_MM << 32) / steps_per_mm_q16 : (uint64_t)LAT_PER_MM << 16;
    uint64_t step = (step_q16 + (1 << 15)) >> 16;
    *c = (path_config_t){.effort = 500, .effort_max = 1 << 18};
    c->step_lat = step < PATH_STEP_MIN ? PATH_STEP_MIN : step > PATH_STEP_MAX ? PATH_STEP_MAX : (int32_t)step;
}

static inline path_fed_t *fed_of(const path_t *p) {
    return CONFIG_FED ? p->fed : NULL;
}

static int pen_move(void *ctx, page_point_t to) {
    path_t *p = ctx;
    p->stats.strokes++;
    p->at = to;
    return p->pen->move(p->pen->ctx, to);
}

static int pen_draw(void *ctx, page_point_t to) {
    path_t *p = ctx;
    p->stats.draws++;
    p->at = to;
    return p->pen->draw(p->pen->ctx, to);
}

static void forget_drawn(pool_t *pool) {
    int32_t n = 0;
    for (int32_t r = 0; r < pool->n; r++) {
        if (pool->run[r].to_hi & RUN_DRAWN) continue;
        pool->run[n] = pool->run[r];
        pool->run[n++].to_hi &= ~RUN_SEEN;
    }
    pool->n = n;
}

/* The next vertex of the outbox. */
static int draw_next(path_t *p) {
    const path_feed_t *feed = p->config.feed;
    bool over;
    int err = outbox_draw(&fed_of(p)->outbox, p->map, &p->simplify, &p->stats.vertices, &over);
    return !err && over && feed->rest ? feed->rest(feed->ctx) : err;
}

/* What the machine takes without waiting. */
static void pump(path_t *p) {
    const path_feed_t *feed = p->config.feed;
    if (!fed_of(p)) return;
    while ((!feed->ready || feed->ready(feed->ctx)) && fed_of(p)->outbox.n > 0 && !fed_of(p)->error)
        fed_of(p)->error = draw_next(p);
}

static void pump_tick(void *ctx) {
    pump(ctx);
}

static int drain(path_t *p) {
    while (fed_of(p)->outbox.n > 0 && !fed_of(p)->error) fed_of(p)->error = draw_next(p);
    return fed_of(p)->error;
}

/* The pen will have so much to do with a run, at least. */
static int32_t run_us(const path_t *p, int32_t e) {
    page_point_t a, b;
    if (!pool_end_point(&p->pool, p->map, e, &a) || !pool_end_point(&p->pool, p->map, pool_other_end(e), &b)) return 0;
    return (int32_t)((int64_t)dist_between(a, b) * 1000 / p->config.feed->lat_per_ms) + 1;
}

/* Moves a stroke from the pool into the outbox. */
static int settle(path_t *p, int32_t start) {
    pool_t *pool = &p->pool;
    for (int32_t e = start; e >= 0 && !fed_of(p)->error;) {
        const int32_t far = pool_other_end(e), next = pool->mate[far];
        while (outbox_full(&fed_of(p)->outbox) && !fed_of(p)->error) fed_of(p)->error = draw_next(p);
        const int32_t us = run_us(p, e) + (next < 0 ? p->config.feed->stroke_us : 0);
        outbox_put(&fed_of(p)->outbox, &pool->run[e >> 1], e & 1, next < 0, us);
        pool->run[e >> 1].to_hi |= RUN_DRAWN;
        fed_of(p)->ahead_us += us;
        if (fed_of(p)->ahead_us > fed_of(p)->outbox.us) fed_of(p)->ahead_us = fed_of(p)->outbox.us;
        if (next < 0) pool_end_point(pool, p->map, far, &p->leaves);
        e = next;
    }
    return fed_of(p)->error;
}

/* Orders what is in the pool (as it comes, if the pen waits for it) and draws, or settles, the first strokes of it:
 * all, a part to make room, or until the pen has enough to do. */
enum flush { FLUSH_ALL, FLUSH_ROOM, FLUSH_FEED };
static int flush(path_t *p, enum flush why) {
    const bool all = why == FLUSH_ALL;
    const int64_t until_us = why == FLUSH_FEED ? FEED_ENOUGH_US : INT64_MAX;
    pool_t *pool = &p->pool;
    tour_t tour;
    order_strokes(p, &tour, all, why != FLUSH_FEED);
    const int32_t count = why == FLUSH_ROOM ? (tour.n + FLUSH_PART - 1) / FLUSH_PART : tour.n;
    int err = !fed_of(p) ? 0 : all ? drain(p) : fed_of(p)->error;
    p->drawing = tour.n;
    for (int32_t k = 0; !err && k < count && (!fed_of(p) || fed_of(p)->ahead_us < until_us); k++) {
        p->drawn = k;
        if (k % TELL_STROKES == 0)
            order_tell(p, all, TOLD_ORDERED + (int32_t)((int64_t)k * (TOLD_ALL - TOLD_ORDERED) / count));
#if CONFIG_FETCH
        tour_fetch(&tour, pool, k, p->config.fetch, p->map->ctx);
#endif
        if (all && tour_is_plain(&tour, k)) {
            err = emit_plain(tour.point, tour_stroke(&tour, pool, k), &p->simplify, &p->stats.vertices);
            if (err) return err;
            continue;
        }
#if CONFIG_FETCH && CONFIG_MANY_STROKES
        tour_fetch_winding(&tour, pool, p->config.fetch, p->map->ctx);
#endif
        int32_t start = tour_stroke(&tour, pool, k);
        if (!all && order_drop_dot(p, tour.point, start)) continue;
        if (fed_of(p) && !all)
            err = settle(p, start);
        else
            err = emit_stroke(pool, p->map, tour.point, start, &p->simplify, &p->stats.vertices);
    }
    if (err) return err;
    if (!fed_of(p)) {
        const path_feed_t *feed = p->config.feed;
        p->leaves = p->at;
        if (!all && feed && feed->rest) err = feed->rest(feed->ctx); /* not a word until the pool is full again */
    }
    if (err) return err;
    p->drawing = p->drawn = 0;
    if (all)
        pool->n = 0;
    else
        forget_drawn(pool);
    return 0;
}

/* Has the pen soon nothing to do? More than the outbox can hold is no use. */
static bool is_hungry(const path_fed_t *f) {
    const bool small = f->outbox.filled && f->outbox.us < 2 * FEED_LEAST_US;
    return f->ahead_us <= (small ? f->outbox.us / 2 : FEED_LEAST_US);
}

/* us have passed: does the pen need strokes? */
static bool wants_strokes(path_t *p, int32_t us) {
    pump(p);
    fed_of(p)->ahead_us -= us;
    return !fed_of(p)->error && is_hungry(p->fed);
}

int path_advance(path_t *p, int32_t us) {
    if (!fed_of(p)) return 0;
    if (!wants_strokes(p, us)) return fed_of(p)->error;
    int err = p->pool.n == 0 ? join_finish(&p->join) : 0;
    return err || p->pool.n == 0 ? err : flush(p, FLUSH_FEED);
}

/* What is in the pool will be put in order, which takes time. */
static int before_order(path_t *p) {
    if (!fed_of(p)) return 0;
    if (!wants_strokes(p, p->pool.n * p->config.feed->order_us) || p->pool.n == 0) return fed_of(p)->error;
    return flush(p, FLUSH_FEED);
}

static int take_run(void *ctx, const ink_piece_t *run) {
    path_t *p = ctx;
    if (p->pool.n == p->pool.cap) {
        int err = before_order(p);
        if (!err && p->pool.n == p->pool.cap) err = flush(p, FLUSH_ROOM);
        if (err) return err;
        p->stats.flushes++;
    }
    p->pool.run[p->pool.n++] = run_pack(run);
    p->vertices += ((run->to - run->from) >> ink_bits(run->family)) + 2;
    p->stats.runs++;
    return 0;
}

/* Is it better to have so many pairs of open runs, or more runs in the pool? With the eye outside the grid a line grows
 * in one direction, so two lines can share a pair, and then a slot for each is worth more than the pool. */
static bool wants_pairs(const path_config_t *c, uint32_t pairs, size_t bytes) {
    if (pairs > 1u << 24 || (int64_t)pairs >= 2 * (int64_t)c->lines) return false;
    size_t most = (int64_t)pairs < c->lines ? bytes - POOL_BYTES(POOL_RUNS_MIN) : bytes / 4;
    return JOIN_BYTES(pairs) <= most;
}

int path_init(path_t *p, void *mem, size_t bytes, const path_config_t *c, const ink_map_t *map, const pen_sink_t *pen) {
    if (c->step_lat < PATH_STEP_MIN || c->step_lat > PATH_STEP_MAX || c->lines < 0 || c->effort < 0 ||
        c->effort_max < 0)
        return ERR_VALUE;
    if (!mem || bytes < PATH_BYTES_MIN) return ERR_FULL;
    size_t skip = (8 - (uintptr_t)mem % 8) % 8, left = bytes - skip;
    uint32_t pairs = 1;
    while (wants_pairs(c, 2 * pairs, left)) pairs *= 2;
    *p = (path_t){.config = *c, .map = map, .pen = pen, .at = c->home, .leaves = c->home};
    join_init(&p->join, (uint8_t *)mem + skip, pairs, c->step_lat / 4, map, (ink_sink_t){p, take_run});
    left -= JOIN_BYTES(pairs);
    const size_t waiting = CONFIG_FED && c->feed ? (size_t)c->feed->runs : 0;
    size_t fed = waiting ? sizeof(path_fed_t) + OUTBOX_BYTES(waiting) : 0;
    if (fed > left / FEED_MEMORY_PART) fed = 0;
    left = (left - fed) / 8 * 8;
    size_t cap = left / POOL_BYTES_PER_RUN - 1;
    if (cap > POOL_RUNS_MAX) cap = POOL_RUNS_MAX;
    p->pool.cap = (int32_t)cap;
    p->pool.run = (run_t *)(void *)((uint8_t *)mem + skip + JOIN_BYTES(pairs));
    p->pool.mate = pool_own_mate(&p->pool);
#if CONFIG_FETCH
    p->pool.span = c->span;
#endif
    p->pool.work = (uint32_t *)(void *)(p->pool.mate + 2 * (cap + 1));
    p->stats.bytes = JOIN_BYTES(pairs) + POOL_BYTES(cap) + fed;
    if (fed) {
        p->fed = (path_fed_t *)(void *)((uint8_t *)p->pool.run + left);
        *p->fed = (path_fed_t){.ahead_us = 0};
        outbox_init(&fed_of(p)->outbox, (outbox_run_t *)(void *)(p->fed + 1), (int32_t)waiting);
        p->pool.tick = pump_tick;
        p->pool.tick_ctx = p;
    }
    simplify_init(&p->simplify, c->step_lat / 8, (pen_sink_t){p, pen_move, pen_draw});
    return 0;
}

static int take_piece(void *ctx, const ink_piece_t *piece) {
    path_t *p = ctx;
    if (!run_fits(piece)) return ERR_VALUE;
    return join_piece(&p->join, piece);
}

ink_sink_t path_sink(path_t *p) {
    return (ink_sink_t){p, take_piece};
}

int path_polyline(path_t *p, uint8_t surface, int32_t line, int32_t vertices) {
    ink_piece_t piece = {INK_CURVE, surface, line, 0, (vertices - 1) * INK_ONE};
    return take_piece(p, &piece);
}

int path_finish(path_t *p, path_stats_t *stats) {
    int err = join_finish(&p->join);
    if (!err) err = before_order(p);
    if (!err) err = flush(p, FLUSH_ALL);
    p->stats.pieces = p->join.pieces;
    p->at = p->config.home;
    if (stats) *stats = p->stats;
    return err;
}
