/* chart.h - from grid points to pencil coordinates (pencil.h).
 *
 * A chart is a central projection from the eye onto a vertical plane, so it maps lines to lines. With d = (dx, dy, dz)
 * the vector from the eye to a point:
 *
 *   CHART_PARALLEL   a = across the view,      w = z - climb of the view * depth       no division
 *   CHART_NORTH      a = -dx / |dy|,  w = dz / |dy|   the eye is beyond the first or last row
 *   CHART_EAST       a =  dy / |dx|,  w = dz / |dx|   the eye is beyond the first or last column
 *   CHART_AROUND     four of these, one for each quarter of the compass, side by side along a, counter-clockwise,
 *                    cut open in the south-west: Anderson's pseudo-angle. For eyes inside the rectangle of the
 *                    grid, on its border or very close to it.
 *
 * Scales are chosen for the scene, relative to the sight line through its middle: see plane.h.
 * In CHART_AROUND w has no bound below the eye: its scale changes by zones (chart_around.h), and what is steeper than
 * 2^18 (a fifteenth of a step on the page around the point below the eye) has no pencil coordinates: chart_line.at has
 * a == CHART_NONE there, and nothing can stand in front of it.
 *
 * Bit budget: numerators 32 bits signed, reciprocals 32 unsigned, products 63 and sign, their upper half is the result.
 * Error: 1 unit in a and in w; the scene fills at least a fourth of the 2^31 units.
 * Cost per point: two 32x32->64 products (parallel: none). Per row some 20 operations of num.h. */
#ifndef CHART_H
#define CHART_H

#include "scene/grid.h"
#include "view/camera.h"
#include "view/plane.h"

#define CHART_NONE INT32_MIN
#define CHART_SECTOR_BITS 28 /* CHART_AROUND: a sector is 2^28 units wide, the middle one of three cuts is at 0 */
/* Units: a row within so many is seen as one vertical line, a thirtieth of a step wide at most. */
#define CHART_IN_PLANE (1 << 10)

enum chart_kind { CHART_PARALLEL, CHART_NORTH, CHART_EAST, CHART_AROUND, CHART_VERTICAL };

/* A column's constants. */
typedef struct chart_column {
    int32_t p;  /* numerator of a; CHART_AROUND: dx */
    int32_t s;  /* part of w's numerator; CHART_AROUND: shift of r */
    uint32_t r; /* reciprocal of the distance */
} chart_column_t;

typedef struct chart {
    enum chart_kind kind; /* CHART_VERTICAL: a parallel view straight down or up, nothing hides anything */
    grid_t *grid;         /* the first one: coordinates are common to all */
    const camera_t *cam;
    int32_t i0, j0;                 /* the eye's cell, clamped to the grid */
    int8_t side_x, side_y;          /* -1, 1: the eye is before the first, beyond the last column (row); 0: neither */
    int8_t sign;                    /* of dy (CHART_NORTH) or dx (CHART_EAST) */
    plane_t plane;                  /* CHART_NORTH: u is x, v is y; CHART_EAST: u is y, v is x */
    num_t x_ref, y_ref, z_ref;      /* CHART_PARALLEL: the middle; CHART_AROUND: the eye */
    num_t turn[2];                  /* CHART_PARALLEL: what a row's y adds to a and w, negative */
    int16_t x_bits, y_bits, z_bits; /* scales of a's and w's numerators */
    int16_t z_shift;                /* CHART_AROUND: how many bits more heights have than distances */
    bool tall;                      /* CHART_AROUND: heights are evaluated, 31 bits are not enough */
    chart_column_t *column;         /* CHART_EAST, CHART_AROUND: nx, in lent memory */
    int32_t *p, *s; /* CHART_NORTH, CHART_PARALLEL: the same memory, nx of the column's p; and of its s */
} chart_t;

/* One row of the grid in pencil coordinates. */
typedef struct chart_line {
    int32_t j;
    bool in_plane; /* the row is in a vertical plane through the eye, or so nearly that nobody could tell */
    pencil_t *at;  /* points first .. last */
    int64_t *z;    /* nx heights relative to the eye (CHART_AROUND), less than 2^60, in the scale of w's numerator */
    uint8_t *hole; /* nx flags, or NULL when the grid has no holes */
    int32_t first, last; /* columns: all but after chart_row_over. Before the first call: first is 0 */
    int32_t dy;          /* CHART_AROUND */
    uint32_t r;          /* CHART_NORTH: reciprocal of the row's distance */
} chart_line_t;

/* Chooses the chart for n grids over the same points (x, y), and a view. column: nx constants, must outlive c, as must
 * grids and cam. */
void chart_init(chart_t *c, grid_t *const grid[], int32_t n, const camera_t *cam, chart_column_t *column);

/* Bytes of them that the chart uses, from the front. */
static inline size_t chart_column_bytes(const chart_t *c) {
    const size_t each = c->kind == CHART_NORTH      ? sizeof *c->p
                        : c->kind == CHART_PARALLEL ? sizeof *c->p + sizeof *c->s
                                                    : sizeof *c->column;
    return (size_t)c->grid->nx * each;
}

/* Which sides of a grid can be seen: 1 only upper ones (the eye is above it, over its rectangle), -1 only lower ones, 0
 * both. May ask the grid for four heights. */
int8_t chart_seen(const chart_t *c, grid_t *g);

/* Is the eye in the vertical plane of a column (row), exactly? Parallel views: is their direction? */
bool chart_column_has_eye(const chart_t *c, int32_t i);
bool chart_row_has_eye(const chart_t *c, int32_t j);

/* Fills in row j of grid g: line->at, and line->z, line->hole if they are not NULL. */
void chart_row(const chart_t *c, grid_t *g, int32_t j, chart_line_t *line);
/* The same, but no more than the corners of facets that reach into abscissae from lo to hi: as many as
 * chart_columns_over says, or fewer, down to none. line->at then points as far before the row's memory as there are
 * columns before them. The grid has no holes. */
void chart_row_over(const chart_t *c, grid_t *g, int32_t j, int32_t lo, int32_t hi, chart_line_t *line);
int32_t chart_columns_over(const chart_t *c, int32_t lo, int32_t hi);
/* Of a point of the grid; not in CHART_AROUND. */
int32_t chart_abscissa(const chart_t *c, int32_t i, int32_t j);

/* CHART_AROUND: the sector of a direction in plan, 0 south, 1 east, 2 north, 3 west (diagonals: north or south). */
int chart_sector(int32_t dx, int32_t dy);

/* CHART_AROUND: the sector of an abscissa. */
static inline int chart_sector_at(int32_t a) {
    return (a + (2 << CHART_SECTOR_BITS)) >> CHART_SECTOR_BITS;
}

/* CHART_AROUND: a point, relative to the eye in the chart's scales, as `sector` sees it; the point is in that sector or
 * on its border. False if it has no coordinates there: too steep, then
 * at is the nearest that has, above or below; or exactly below the eye, then at->a is CHART_NONE. */
bool chart_around(const chart_t *c, int sector, int32_t dx, int32_t dy, int64_t dz, pencil_t *at);

/* The position in space (q46), of a point that is `u` of the way from end 0 to end 1 in the chart, along an edge whose
 * ends have the reciprocal distances g0 and g1 (any common scale). Good to 2^-30; where one end is more than 16 times
 * as far as the other, as fine as u is at the near one. Cost: one division; none if g0 == g1. */
int64_t chart_unproject(int32_t u_q30, uint32_t g0, uint32_t g1);

#endif
