/* data_curve.h - points of a data file in the plane, in the order of the file, for `plot 'file'`.
 *
 * Memory: 16 bytes a point from the pool's lower end. A blank line interrupts the curve: a point without y. */
#ifndef DATA_CURVE_H
#define DATA_CURVE_H

#include "scene/curve.h"
#include "scene/data_grid.h"

typedef struct data_curve {
    data_pool_t *pool;
    packed_t (*point)[2]; /* x, y */
    int32_t n;
    bool any; /* a point with a y */
} data_curve_t;

void data_curve_start(data_curve_t *c, data_pool_t *pool);
/* The next point; an undefined x or y is a gap. Returns 0 or ERR_FULL. */
int data_curve_point(data_curve_t *c, num_t x, num_t y);
/* Interrupts the curve here. */
int data_curve_gap(data_curve_t *c);
/* Returns 0, or ERR_EMPTY when no point has both coordinates. c and the pool outlive out. */
int data_curve_finish(data_curve_t *c);
/* The finished curve and, if not NULL, the extent of its x. */
void data_curve_get(data_curve_t *c, curve_t *out, num_t extent[2]);

#endif
