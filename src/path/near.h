/* near.h - which stroke ends are near a place: a grid over the page.
 *
 * Coordinates are "spots": 15 bits an axis over the drawing's extent, so that squares fit 32 bits and a stroke's ends
 * cost 8 bytes. Items are 2 * stroke + side. Heavy cells are not searched to the end, since whatever is in the same
 * cell is near. */
#ifndef NEAR_H
#define NEAR_H

#include "view/page.h"
#include <stdbool.h>
#include <stdint.h>

typedef struct spot {
    int16_t x, y; /* 0 .. 32767; x + INT16_MIN of a stroke that has been taken */
} spot_t;

/* The extent of a drawing in lat, and how many bits must go so that it fits 15. */
typedef struct near_extent {
    int32_t x0, y0, x1, y1;
    int shift;
} near_extent_t;

static inline void near_include(near_extent_t *b, page_point_t p) {
    if (p.x_lat < b->x0) b->x0 = p.x_lat;
    if (p.y_lat < b->y0) b->y0 = p.y_lat;
    if (p.x_lat > b->x1) b->x1 = p.x_lat;
    if (p.y_lat > b->y1) b->y1 = p.y_lat;
}
/* Once all is in there. */
static inline void near_fit(near_extent_t *b) {
    while ((b->x1 - b->x0) >> b->shift > INT16_MAX || (b->y1 - b->y0) >> b->shift > INT16_MAX) b->shift++;
}
static inline spot_t near_spot(const near_extent_t *b, page_point_t p) {
    return (spot_t){(int16_t)((p.x_lat - b->x0) >> b->shift), (int16_t)((p.y_lat - b->y0) >> b->shift)};
}

static inline void near_mark_end(spot_t *s) {
    s->x = (int16_t)(s->x | INT16_MIN);
}
/* Both ends of the stroke are taken, so that a search need look nowhere else to know. */
static inline void near_mark(spot_t *spot, int32_t stroke) {
    near_mark_end(&spot[2 * stroke]);
    near_mark_end(&spot[2 * stroke + 1]);
}
/* Undoes it. */
static inline void near_unmark(spot_t *spot, int32_t stroke) {
    spot[2 * stroke].x &= INT16_MAX;
    spot[2 * stroke + 1].x &= INT16_MAX;
}

typedef struct near_cell {
    uint32_t start, count; /* of items */
} near_cell_t;

typedef struct near {
    const spot_t *spot; /* of every item */
    int32_t *item;
    int32_t items; /* entered by near_build: how much of `item` is used */
    near_cell_t *cell;
    int32_t cells_max;
    int32_t nx, ny;
    int shift_x, shift_y; /* a cell is 2^shift_x spots wide, and as high or twice as high */
} near_t;

#define NEAR_CELL_SCAN 32  /* items looked at in one cell where a tour is improved */
#define NEAR_TAKE_SCAN 128 /* and where one is begun */
#define NEAR_FAR INT32_MAX /* beyond every square of a distance; twice that fits 32 bits */

static inline uint32_t near_square(spot_t a, spot_t b) {
    int32_t dx = a.x - b.x, dy = a.y - b.y;
    return (uint32_t)(dx * dx) + (uint32_t)(dy * dy);
}

/* The size of the cells if at most `wanted` of them are to cover the spots up to x_max and y_max. */
static inline void near_size(int32_t wanted, int32_t x_max, int32_t y_max, int *shift_x, int *shift_y) {
    for (*shift_x = *shift_y = 0; *shift_x < 15;) {
        if (((x_max >> *shift_x) + 1) * ((y_max >> *shift_y) + 1) <= wanted) break;
        if (*shift_y > *shift_x)
            ++*shift_x;
        else
            ++*shift_y;
    }
}

static inline int32_t near_clamp(int32_t v, int32_t max) {
    return v < 0 ? 0 : v > max ? max : v;
}

/* Enters both ends of the strokes 0..strokes-1, `crowd` or up to twice as many to a cell of the drawing's extent, if
 * there is memory for so many cells. */
void near_build(near_t *g, int32_t strokes, int32_t crowd);
/* Builds the grid anew, as coarse as what is left is sparse: marked strokes are gone. At least half must be. */
void near_thin(near_t *g, int32_t crowd);
/* The nearest item of a stroke that is not marked, seen from `at`, where the item `from` is; or -1 when none is left.
 * Both are forgotten: whoever takes it marks its stroke and goes on at its other end. Exact but for heavy cells. */
int32_t near_take(near_t *g, spot_t at, int32_t from);
/* The cell with column cx and row cy, or NULL outside. */
const near_cell_t *near_cell_at(const near_t *g, int32_t cx, int32_t cy);

#endif
