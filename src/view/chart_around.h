/* chart_around.h - CHART_AROUND (chart.h): the parts of a chart that only an eye over the rectangle, or very close to
 * it, needs. Four sectors in a, seven zones in w.
 *
 * Zones: right below the eye lines of sight are as steep as one likes, at the horizon a millionth matters. So w is the
 * slope dz / d in units that grow with it, in zones of constant scale:
 *
 *      |slope|    up to 1      to 2^6     to 2^12    to 2^18     steeper: no coordinates
 *      unit        2^-28       2^-22       2^-16      2^-10      at most 2^-22 of the angle
 *
 * On the border of two zones w is continuous, so order is kept, and within a zone lines stay lines. Slopes are in units
 * of the data, distances those of the wider side of the rectangle. From far above (below) everything is steep: slopes
 * then count in a power of two that the least of them reaches. */
#ifndef CHART_AROUND_H
#define CHART_AROUND_H

#include "view/chart.h"

/* Chooses the scales, after the eye's cell is known; x, y, z: lo and hi of the box. */
void chart_around_init(chart_t *c, grid_t *const grid[], int32_t n, const num_t x[2], const num_t y[2],
                       const num_t z[2]);

/* Row j, at y: line->at, line->z, line->dy, and line->hole if it is not NULL. */
void chart_around_row(const chart_t *c, grid_t *g, int32_t j, num_t y, chart_line_t *line);

/* The borders of the zones: |w| there. */
#define CHART_ZONES 4
extern const int32_t chart_zone_border[CHART_ZONES];

/* How high above (below) the eye's level the border after zone k is at distance d, in the scale of chart_line.z. */
int64_t chart_zone_height(const chart_t *c, int k, int32_t d);

/* Have all ordinates from low to high one scale? */
bool chart_in_one_zone(int32_t low, int32_t high);

#endif
