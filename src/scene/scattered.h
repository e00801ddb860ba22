/* scattered.h - set dgrid3d: heights at the points of a grid, as weighted means of those of scattered points.
 *
 * The grid spans what the points span. The weight of a point at distance r is, as in gnuplot, 1 / r^q for qnorm, where
 * a point of the data that is on the grid counts alone, or another function of r, r^2 = (dx/sx)^2 + (dy/sy)^2.
 *
 * Cost: points x nodes. Memory: 24 bytes a point at the pool's lower end, the grid behind them. Context: main loop. */
#ifndef SCATTERED_H
#define SCATTERED_H

#include "scene/data_grid.h"

enum scattered_weight {
    SCATTERED_QNORM,
    SCATTERED_GAUSS,  /* exp(-r^2) */
    SCATTERED_EXP,    /* exp(-r) */
    SCATTERED_CAUCHY, /* 1 / (1 + r^2) */
    SCATTERED_BOX,    /* 1 for r < 1 */
    SCATTERED_HANN,   /* (1 + cos(pi r)) / 2 for r < 1 */
};

#define SCATTERED_SIDE_MAX 1000

/* What `set dgrid3d` says. */
typedef struct scattered_spec {
    bool on, density; /* the sum of weighted heights, not their mean */
    enum scattered_weight weight;
    int32_t nx, ny, q;
    num_t scale[2]; /* sx, sy */
} scattered_spec_t;
void scattered_default(scattered_spec_t *spec);

typedef struct scattered {
    data_pool_t *pool;
    packed_t *point; /* x, y, z of each */
    int32_t n;
    num_t end[2][2]; /* of x and y: the least and the most */
} scattered_t;

void scattered_start(scattered_t *s, data_pool_t *pool);
/* One without a height is left out. 0 or ERR_FULL. */
int scattered_point(scattered_t *s, const num_t p[3]);
/* The finished grid. 0, ERR_FULL, or ERR_EMPTY for points on one line along x or y. */
int scattered_grid(const scattered_t *s, const scattered_spec_t *spec, data_grid_t *g);

#endif
