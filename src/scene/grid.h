/* grid.h - a surface's heights as 32-bit integers of one scale (block scaling).
 *
 * One pass over the surface finds the range of its heights; then every height is
 *     z = z_origin + zi * 2^z_exp,   |zi| <= 2^30,   rounded down,
 * so one unit is the range times 2^-29 or less: four orders below a step on A4. If the caller lends cache
 * memory for nx * ny heights, each point is evaluated once; otherwise rows are evaluated again when asked for.
 * Both give the same integers.
 * Points outside [zlo, zhi] (`set zrange`) are holes, as in gnuplot. */
#ifndef GRID_H
#define GRID_H

#include "config.h"
#include "scene/surface.h"
#include <stddef.h>

#define GRID_SIDE_MAX 65536          /* points along one side */
#define GRID_HOLE INT32_MIN          /* a height that is none, where heights are kept; and ... */
#define GRID_UNKNOWN (INT32_MIN + 1) /* ... one that is not there */

typedef struct grid_known {
    uint16_t i, j;
    int32_t zi; /* or GRID_HOLE, or GRID_UNKNOWN: nothing */
} grid_known_t;

typedef struct grid {
    const surface_t *src;
    int32_t nx, ny;
    num_t z_min, z_max;  /* measured range of the defined points that are inside the limits */
    num_t z_origin;      /* the first defined point, counting along rows from (0, 0) */
    int16_t z_exp;       /* see above */
    bool has_lo, has_hi; /* is there a `set zrange` limit */
    bool below, above;   /* is any point beyond it? Such points are holes */
    bool to_limits;      /* the owner's: lines are drawn up to the limits that they cross (grid_edge_limit) */
    num_t z_lo, z_hi;
    int64_t holes;     /* undefined points */
    int64_t evaluated; /* points evaluated so far: the cost of a small memory shows here */
    int32_t *cache;    /* nx * ny heights or NULL; GRID_HOLE marks a hole inside the cache only */
#if CONFIG_HEIGHTS > 0
    grid_known_t known[CONFIG_HEIGHTS]; /* without a cache: single heights that were asked for lately */
#endif
} grid_t;

/* Measures src. cache may be NULL or hold nx * ny entries, and must outlive g. lo, hi: limits or NULL.
 * Returns 0, ERR_EMPTY when no point is defined, or ERR_FULL for a side of more
 * than GRID_SIDE_MAX points. tick (may be NULL) is called once a row, for progress. */
int grid_measure(grid_t *g, const surface_t *src, const num_t *lo, const num_t *hi, int32_t *cache,
                 void (*tick)(void *ctx, int32_t done, int32_t of), void *tick_ctx);
/* Row j into zi[0..nx). hole[i] is 1 where the point is undefined and zi[i] is then 0; hole may be NULL
 * when g->holes == 0. Returns the number of holes in the row. */
int32_t grid_row(grid_t *g, int32_t j, int32_t *zi, uint8_t *hole);
/* The same if all heights are kept and none is a hole, or NULL. */
static inline const int32_t *grid_kept_row(const grid_t *g, int32_t j) {
    return g->cache != NULL && g->holes == 0 ? g->cache + (int64_t)j * g->nx : NULL;
}
/* One height; false at a hole. */
bool grid_height(grid_t *g, int32_t i, int32_t j, int32_t *zi);
/* The same of a grid with a cache, inline. */
static inline bool grid_cached_height(const grid_t *g, int32_t i, int32_t j, int32_t *zi) {
    *zi = g->cache[(int64_t)j * g->nx + i];
    return *zi != GRID_HOLE;
}

/* Are the heights so far apart, more than 2^4 times as far as the points, that an eye close to some of them needs more
 * than their 31 bits? So it does from a fourth of them on where it is in the surface's box, or close to that: a
 * ten-thousandth of them from the surface, rounded heights would turn its lines of sight by steps. */
bool grid_is_tall(const grid_t *g, const num_t eye[3]);
/* One height as it is, evaluated again; false at a hole. */
bool grid_value(grid_t *g, int32_t i, int32_t j, num_t *z);

/* The straight edge from a point (column, row) within the limits of heights to one beyond them: which limit it meets,
 * and at which fraction of its length. False if the far point is undefined. Both points are evaluated. */
bool grid_edge_limit(grid_t *g, const int32_t inside[2], const int32_t outside[2], num_t *limit, int64_t *s_q46);

#endif
