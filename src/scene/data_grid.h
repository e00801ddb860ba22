/* data_grid.h - points of a data file, in the order of the file, become a grid of heights in lent memory.
 *
 * The file holds isolines: blocks of points along which one of x, y stays and the other changes, in the same steps in
 * every block. Which of the two it is, and in which directions they run, is found out from the points; blocks may be
 * separated by blank lines (data_grid_break) or simply begin again where the first one began. Spacing is free. A
 * coordinate may differ between blocks by 2^-12 of the first step (files are rounded); the first block's value counts.
 *
 * Memory: one packed_t (8 bytes) per height plus one per column and row: heights grow from the pool's lower end,
 * coordinates from its upper end. Nothing is moved when the file is complete: direction and transposition are strides.
 */
#ifndef DATA_GRID_H
#define DATA_GRID_H

#include "scene/packed.h"
#include "scene/surface.h"
#include <stddef.h>

/* Memory for data, taken from both ends; units of 8 bytes. */
typedef struct data_pool {
    packed_t *base;
    size_t low, high; /* [low, high) is free */
} data_pool_t;

enum data_grid_trouble { /* why a point was refused */
                         DATA_OK,
                         DATA_FULL,      /* the pool is full */
                         DATA_NO_PLACE,  /* x or y is undefined */
                         DATA_NO_GRID,   /* neither x nor y stays the same from the first point to the second */
                         DATA_TURNS,     /* a coordinate does not keep increasing or decreasing */
                         DATA_OFF_GRID,  /* not where the corresponding point of the first block lies */
                         DATA_RAGGED,    /* a block with another number of points than the first */
                         DATA_TOO_SMALL, /* fewer than 2 x 2 points */
                         /* found by data_reader */
                         DATA_SETS,         /* more data sets than can be drawn at once */
                         DATA_TWO_COLUMNS,  /* neither z nor x y z */
                         DATA_SHORT,        /* a row without a column that is wanted */
                         DATA_TEXT,         /* a field is not a number */
                         DATA_DETAIL,       /* obj_reader: a detail without a face */
                         DATA_TONE,         /* obj_reader: no percentage behind `tone`, or more */
                         DATA_VERTEX,       /* obj_reader: a vertex that does not exist */
                         DATA_BINARY_COUNT, /* data_binary: the first number of a matrix is no number of columns */
                         DATA_BINARY_SHORT, /* data_binary: the file ends too soon */
};

typedef struct data_grid {
    data_pool_t *pool;
    packed_t *z;                             /* heights, block after block */
    packed_t *inner, *outer;                 /* coordinates, growing downwards: inner[-1 - k] */
    int32_t inner_n, outer_n;                /* points per block (0 until the first is complete), complete blocks */
    int32_t at;                              /* points of the block being read */
    bool inner_is_x, inner_down, outer_down; /* directions: does the coordinate decrease */
    bool oriented;                           /* inner_is_x is known */
    packed_t first_x, first_y;               /* the first point of the block being read */
    num_t tolerance;                         /* between blocks, of the inner coordinate */
} data_grid_t;

void data_grid_start(data_grid_t *g, data_pool_t *pool);
/* The next point. Returns 0, ERR_FULL or ERR_DATA; then *trouble says why. */
int data_grid_point(data_grid_t *g, num_t x, num_t y, num_t z, enum data_grid_trouble *trouble);
/* The next point, if it is as the first block and the last point tell: the usual one. False: nothing has happened, and
 * data_grid_point() knows more. */
static inline bool data_grid_usual(data_grid_t *g, packed_t x, packed_t y, packed_t z) {
    const packed_t stays = g->inner_is_x ? g->first_y : g->first_x;
    data_pool_t *pool = g->pool;
    if (g->at == 0 || g->at >= g->inner_n || (g->inner_is_x ? y : x) != stays ||
        (g->inner_is_x ? x : y) != g->inner[-1 - g->at] || pool->low >= pool->high)
        return false;
    pool->base[pool->low++] = z;
    g->at++;
    return true;
}
/* The end of a block (a blank line); does nothing between blocks. Errors as above. */
int data_grid_break(data_grid_t *g, enum data_grid_trouble *trouble);
/* The end of the data: ends the last block. */
int data_grid_finish(data_grid_t *g, enum data_grid_trouble *trouble);
/* A sentence for trouble. */
const char *data_grid_text(enum data_grid_trouble trouble);

/* The surface of a finished grid, without the columns and rows outside of x_lim, y_lim (pairs lo, hi; NULL: no limit).
 * Returns 0, or ERR_EMPTY when fewer than two columns or rows remain. v and the pool outlive the surface. */
typedef struct data_view {
    const data_grid_t *g;
    const packed_t *z;
    int64_t step_i, step_j; /* from column to column, row to row, in z */
    const packed_t *x, *y;  /* of column 0, row 0 */
    int32_t x_step, y_step; /* +1 or -1 */
} data_view_t;
int data_grid_surface(const data_grid_t *g, const num_t *x_lim, const num_t *y_lim, data_view_t *v, surface_t *out);
/* Of the same surface. */
num_t data_view_x(const data_view_t *v, int32_t i);
num_t data_view_y(const data_view_t *v, int32_t j);
num_t data_view_z(const data_view_t *v, int32_t i, int32_t j);

#endif
