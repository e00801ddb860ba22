/* page_map.h - from a place on a grid line to the page, in fixed point.
 *
 * Homogeneous page coordinates are sums of a column's, a row's and a height's share:
 *     H_k(i, j, zi) = col_k[i] + row_k[j] + zi * z_k,   k = X, Y, E;   page = (H_X / H_E, H_Y / H_E)
 * all int64_t in one unit 2^-frac_bits chosen per scene so that |H| < 2^60 everywhere on the grid (block scaling).
 * The shares come from the camera's matrix once a picture; after that a vertex costs three products and, in
 * perspective, two divisions. Error: below 1 lat (1/400 step) while depths differ by less than 1:10^4, below 8 for what
 * is nearer; from 1:2^15 on points are worked out in scaled integers (line_space.h).
 *
 * Points between two vertices are interpolated in space, where a grid edge is straight.
 * Context: main loop. Memory: the caller lends 24 bytes per column and row, or nothing: then shares are worked out
 * every time (for the smallest boards; some 20 times slower). */
#ifndef PAGE_MAP_H
#define PAGE_MAP_H

#include "scene/grid.h"
#include "view/camera.h"

#define PAGE_MAP_BYTES(nx, ny) (((size_t)(nx) + (size_t)(ny)) * 3 * sizeof(int64_t))

typedef struct page_map {
    grid_t *grid;
    const camera_t *cam;
    num_t origin[3], origin_h[3]; /* the grid's middle, and where the camera puts it */
    line_space_t lines;           /* the result: INK_ROW and INK_COL lines of the grid */
    int64_t z_mul[3];             /* height's share: zi * z_mul / 2^(32 + z_shift) */
    uint8_t z_shift[3];
    bool tall;       /* heights are evaluated: see grid_is_tall */
    page_h_t *table; /* nx columns, then ny rows; NULL: compute */
} page_map_t;

/* g and cam must outlive m. memory: PAGE_MAP_BYTES(nx, ny) or NULL. Returns 0 or ERR_VALUE when the grid's box does
 * not project into 60 bits (coordinates beyond any use). */
int page_map_setup(page_map_t *m, grid_t *g, const camera_t *cam, void *memory);

#endif
