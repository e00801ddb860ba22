/* pool.h - the memory shared by the stages that see many runs at once.
 *
 * An end is 2 * run + side (side 0: from, 1: to). `mate` links ends: an end >= 0 is the one it continues into without
 * lifting the pen; a free end holds ~(the free end at the far side of its stroke). So a stroke is known by either of
 * its free ends, and drawn backwards by starting from the other. The stages run one after another, and their work
 * arrays share one piece of memory. */
#ifndef POOL_H
#define POOL_H

#include "config.h"
#include "path/run.h"
#include "view/page.h"

#define POOL_RUNS_MIN 4
#define POOL_RUNS_MAX ((int32_t)1 << 28)
#define POOL_WORK_PER_RUN 32
#define POOL_BYTES_PER_RUN (sizeof(run_t) + 2 * sizeof(int32_t) + POOL_WORK_PER_RUN)
#define POOL_BYTES(runs)                                                                                               \
    (((size_t)(runs) + 1) * POOL_BYTES_PER_RUN) /* one more: the pen's place is in the tour, too                       \
                                                 */

typedef void (*ink_fetch_t)(void *ctx, uint8_t family, uint8_t surface, int32_t line, int64_t t);

typedef bool (*ink_span_t)(void *ctx, uint8_t family, uint8_t surface, int32_t line, int64_t from, int64_t to,
                           page_point_t out[2]);

typedef struct pool {
    int32_t n, cap;
    run_t *run;              /* cap */
    int32_t *mate;           /* 2 * cap. Where there is memory for more, a stage may keep it elsewhere in the pool */
    uint32_t *work;          /* POOL_WORK_PER_RUN * (cap + 1) bytes, aligned for uint32_t */
    void (*tick)(void *ctx); /* called now and then while runs are put in order, or NULL */
    void *tick_ctx;
#if CONFIG_FETCH
    ink_span_t span; /* path.h */
#endif
} pool_t;

/* Where the links are if nobody has said otherwise: behind the runs. The work area is behind them. */
static inline int32_t *pool_own_mate(const pool_t *p) {
    return (int32_t *)(void *)(p->run + p->cap + 1);
}
static inline uint32_t *pool_end(const pool_t *p) {
    return p->work + (POOL_WORK_PER_RUN / 4) * ((size_t)p->cap + 1);
}

static inline void pool_tick(const pool_t *p) {
    if (CONFIG_FED && p->tick) p->tick(p->tick_ctx);
}

static inline int32_t pool_other_end(int32_t e) {
    return e ^ 1;
}
static inline int64_t pool_end_t(const pool_t *p, int32_t e) {
    return run_t_of(&p->run[e >> 1], e & 1);
}

static inline bool pool_end_point(const pool_t *p, const ink_map_t *map, int32_t e, page_point_t *out) {
    const run_t *r = &p->run[e >> 1];
    return map->point(map->ctx, run_family(r), run_surface(r), run_line(r), run_t_of(r, e & 1), out);
}

/* The points of both ends of the run r. */
static inline bool pool_run_points(const pool_t *p, const ink_map_t *map, int32_t r, page_point_t out[2]) {
#if CONFIG_FETCH
    const run_t *run = &p->run[r];
    if (p->span)
        return p->span(map->ctx, run_family(run), run_surface(run), run_line(run), run_t_of(run, 0), run_t_of(run, 1),
                       out);
#endif
    return pool_end_point(p, map, 2 * r, &out[0]) && pool_end_point(p, map, 2 * r + 1, &out[1]);
}

#endif
