/* bilinear.h - heights between the points of a grid, so that profiles can be cut through data.
 *
 * Inside a cell the height is linear along x and along y; on the grid's lines it is what the surface's edges are. */
#ifndef BILINEAR_H
#define BILINEAR_H

#include "scene/surface.h"

/* The height at (x, y); undefined outside of the grid (by more than its own rounding) and in cells with an undefined
 * corner. Cost: log2(nx) + log2(ny) comparisons, four heights. */
num_t bilinear_at(const surface_t *s, num_t x, num_t y);

#endif
