/* path.h - from visible ink to strokes: joined, ordered, simplified, in bounded memory.
 *
 *     ink pieces -> join (runs through nodes) -> pool -> chain (ends that meet) -> order (pen-up travel)
 *                -> emit (vertices again, through the map) -> simplify -> pen sink
 *
 * The pool holds runs, not points: PATH_BYTES_PER_RUN bytes each with all that ordering needs. When it is full, what
 * is there is ordered, the first strokes of that order are drawn, and the rest stays to meet what is still to come. So
 * any amount of memory from PATH_BYTES_MIN on draws everything; more memory means fewer strokes and less
 * travel (tests/property/test_path_random.c prints how much).
 * A machine that draws while more is computed is fed (path_feed_t): what is settled waits in an outbox and is drawn as
 * it is taken, and so much is settled that the pen has something to do until the next ink comes.
 * The result depends on the pieces, the configuration and the pool's size only, on every target, and never on time.
 *
 * Cost per piece: a few comparisons. Per run: two points to place it, near-linear ordering whose operations are counted
 * and bounded (never timed), one point for each of its vertices. */
#ifndef PATH_H
#define PATH_H

#include "config.h"
#include "path/join.h"
#include "path/outbox.h"
#include "path/pool.h"
#include "path/simplify.h"

/* Drawing begins before all ink is there. How long the pen has to do is reckoned from below: the chords of runs at full
 * speed; how long computing takes from above. So the same ink gives the same strokes however fast the processor is. */
typedef struct path_feed {
    void *ctx;
    bool (*ready)(void *ctx); /* does the pen take a vertex at once? NULL: always */
    int (*rest)(void *ctx);   /* the stroke is over, lift the pen. Returns as the pen does; may be NULL */
    int32_t runs;             /* that may wait in the outbox, if there is memory. Without one the pen is only lifted
                                 when the pool has been drawn in part */
    int32_t lat_per_ms;       /* how fast the pen draws */
    int32_t stroke_us;        /* and how long it takes to lift and lower it */
    int32_t order_us;         /* to put a run in order, at most */
} path_feed_t;

typedef struct path_config {
    int32_t step_lat; /* one motor step; 410 at 80 steps/mm. All tolerances derive from it: ends within a quarter
                         step are joined, vertices within an eighth are merged, strokes shorter than one are dropped */
    int32_t lines;    /* lines that grow at the same time: the grid's columns, or its profiles. Fewer is allowed, see
                         join.h; 0 means 1 */
    int32_t effort; /* improvement operations per stroke (tour.h); 500 is within 5 % of ten times as many, 0 leaves the
                       greedy order. An operation is some 6 ns on a desktop */
    int32_t effort_max; /* and in all, each time strokes are ordered; 2^18. A thousand strokes would gain 2 % from four
                           times as many; beyond some 10,000 lifting the pen takes hours, and what travel could still be
                           saved, minutes */
    page_point_t home;  /* where the pen starts and where it goes after the last stroke */
#if CONFIG_TELL_ORDER
    void (*tell)(void *ctx, int32_t done, int32_t of); /* how far ordering and drawing the rest is; or NULL */
    void *tell_ctx;
#endif
#if CONFIG_FETCH
    ink_span_t span;   /* what the map says of both ends of a run; its ctx is the map's. Or NULL */
    ink_fetch_t fetch; /* asks the cache for what the map will read; its ctx is the map's. Or NULL */
#endif
    const path_feed_t *feed; /* NULL: nothing is drawn before the pool is full or all ink is there */
} path_config_t;

typedef struct path_stats {
    int64_t pieces;   /* taken from the kernel */
    int64_t runs;     /* after joining */
    int64_t strokes;  /* drawn: so often the pen is lowered */
    int64_t dots;     /* strokes below one step, not drawn */
    int64_t lost;     /* runs whose ends the map did not find on the paper, not drawn */
    int64_t vertices; /* computed */
    int64_t draws;    /* left after merging */
    int64_t flushes;  /* how often the pool was full */
    size_t bytes;     /* memory used */
} path_stats_t;

/* What only a path with a feed has. */
typedef struct path_fed {
    outbox_t outbox;
    int64_t ahead_us; /* what the pen has to do, less what computing has taken: see path_feed_t */
    int error;        /* of the pen, while strokes were being put in order */
} path_fed_t;

typedef struct path {
    path_config_t config;
    const ink_map_t *map;
    const pen_sink_t *pen;
    join_t join;
    pool_t pool;
    simplify_t simplify;
    path_fed_t *fed;        /* in the lent memory, or NULL */
    page_point_t at;        /* where the pen is */
    page_point_t leaves;    /* where it will be when all that is settled is drawn */
    int32_t drawing, drawn; /* while strokes of the pool are drawn: how many there are, and which */
    int64_t vertices;       /* of all runs taken so far; stats.vertices counts them as they are drawn */
    path_stats_t stats;
} path_t;

/* Bytes for a pool of `runs` runs and `lines` lines growing at the same time (lines rounded up to a power of two). */
#define PATH_BYTES_PER_RUN POOL_BYTES_PER_RUN
#define PATH_BYTES(runs, lines) (JOIN_BYTES(lines) + POOL_BYTES(runs) + 16)
#define PATH_BYTES_MIN PATH_BYTES(POOL_RUNS_MIN, 1)

#define PATH_STEP_MIN 8         /* lat; 4,096 steps per mm */
#define PATH_STEP_MAX (1 << 20) /* lat; a step of 32 mm */

/* Defaults for a machine of so many steps per mm (q16 as in machine_t; the coarser axis), brought into range. */
void path_default(path_config_t *c, uint32_t steps_per_mm_q16);
/* Prepares p in mem (any alignment, owned by the caller until path_finish). Open runs have the first claim on it, the
 * the rest is the pool. map and pen must outlive p. Returns 0, ERR_FULL when bytes < PATH_BYTES_MIN, or ERR_VALUE for a
 * step_lat out of range. */
int path_init(path_t *p, void *mem, size_t bytes, const path_config_t *c, const ink_map_t *map, const pen_sink_t *pen);
/* Where a kernel puts its ink; any order, any family, several kernels one after another. Errors: ERR_VALUE for a piece
 * outside run.h's ranges, else what the pen sink returned. */
ink_sink_t path_sink(path_t *p);
/* To be called between pieces, at places that depend on the scene only. us: what computing since the last call took at
 * most. With a feed it draws what the pen takes, and settles strokes when it will soon have nothing to do. Returns 0 or
 * the error of the pen sink. */
int path_advance(path_t *p, int32_t us);
/* A flat polyline of so many vertices as one piece of family INK_CURVE. */
int path_polyline(path_t *p, uint8_t surface, int32_t line, int32_t vertices);
/* Draws all that is left. The pen is not sent home: that is the machine's. Returns 0 or the error of the pen sink;
 * stats may be NULL. */
int path_finish(path_t *p, path_stats_t *stats);

#endif
