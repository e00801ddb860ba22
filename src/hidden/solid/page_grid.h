/* page_grid.h - boxes on the page in square cells: which of them may a line meet?
 *
 * The cells cover a window; what is outside of it does not count. Their size is chosen so that there are one to
 * four for each box, as many as boxes when memory is short (no more than half of it is taken for finer ones), and fewer
 * when it is shorter: with a single cell everything is near everything.
 * Memory: 4 bytes a cell, 4 for each box in each cell it touches. */
#ifndef PAGE_GRID_H
#define PAGE_GRID_H

#include "view/solid_map.h"

typedef struct page_box {
    int32_t x0, y0, x1, y1; /* lat, inclusive */
} page_box_t;

typedef struct page_grid {
    page_box_t window;
    int32_t shift; /* cells are 2^shift lat wide */
    int32_t columns, rows;
    int32_t *start; /* of each cell, in entry; and one more */
    int32_t *entry;
    size_t bytes;
} page_grid_t;

/* The part of the page in which there is anything of a scene: what is outside is not drawn. */
page_box_t page_grid_window(const solid_map_t *m);
/* Sorts n boxes into cells. box(ctx, k): the k-th. mem: aligned to 4. Returns 0 or ERR_FULL. */
int page_grid_build(page_grid_t *g, const page_box_t *window, int32_t n, page_box_t (*box)(void *ctx, int32_t k),
                    void *ctx, void *mem, size_t bytes);
/* Takes the numbers of some boxes, from .. end - 1; false: enough. */
typedef bool page_grid_visit_t(void *ctx, const int32_t *from, const int32_t *end);
/* Calls visit for all boxes in the cells of a box, some more than once; false: it had enough. */
bool page_grid_visit(const page_grid_t *g, const page_box_t *box, page_grid_visit_t *visit, void *ctx);
/* Calls visit for all boxes in the cells that the line from a to b comes near, some more than once, until it returns
 * false. The line's ends may be off by off_lat more than by rounding. */
void page_grid_walk(const page_grid_t *g, const solid_place_t *a, const solid_place_t *b, int32_t off_lat,
                    page_grid_visit_t *visit, void *ctx);

#endif
