/* data_crop.h - the lines of a data grid, cut where they cross the limits of x and y.
 *
 * Hidden lines are removed from whole facets, so data_grid_surface() leaves out the columns and rows beyond the limits.
 * Lines that hide nothing go on to the limit, as gnuplot draws them: the rows of one surface have a point more at an
 * end where they are cut, the columns of another; its height lies on the straight edge between its neighbours. An edge
 * with both ends beyond a limit is not drawn. */
#ifndef DATA_CROP_H
#define DATA_CROP_H

#include "scene/data_grid.h"

typedef struct data_crop {
    data_view_t all; /* without limits along the lines, with those across them */
    bool along_y;
    int32_t first; /* the point of them that is 0 here, along the lines */
    num_t end[2];  /* where the first and the last edge are cut; undefined: not */
    int32_t n;     /* points of a line */
} data_crop_t;

/* The rows, or along_y the columns, of g within x_lim and y_lim (pairs lo, hi, or NULL), which are cut at `at` (the
 * same pairs, less what limits have of slack). 0 or ERR_EMPTY as data_grid_surface(). c and the pool outlive the
 * surface. */
int data_crop_lines(const data_grid_t *g, const num_t *x_lim, const num_t *y_lim, const num_t *at, bool along_y,
                    data_crop_t *c, surface_t *out);

#endif
