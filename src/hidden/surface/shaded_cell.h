/* shaded_cell.h - a facet of a surface on its way to hatching: on the page, in the chart, and what else is in its cell
 * (shaded.c). */
#ifndef SHADED_CELL_H
#define SHADED_CELL_H

#include "config.h"
#include "hidden/surface/shaded.h"
#include "hidden/surface/sweep.h"

/* 3--2
 * |  |   the line between the rows j and j + 1, sides from the corner with the smaller index: 0-1, 1-2, 3-2, 0-3
 * 0--1 */
typedef struct other {
    const layer_t *layer;
    int64_t above[4]; /* how far above the facet at its corners, in some unit */
    bool upper;       /* its upper side is seen: it hides what it is above of */
} shaded_other_t;

typedef struct facet {
    const shaded_vertex_t *v[4];
    poly_point_t page[4];
    hatch_place_t place[4]; /* along the family at hand */
    pencil_t at[4];
    uint32_t g[4];
    int32_t x[4], y[4];
    int64_t z[4];
    bool around;
    /* Other surfaces' facets over the same cell. */
    shaded_other_t other[CONFIG_PLOT_ITEMS];
    int32_t others;
} shaded_cell_t;

/* Row j of a surface on its way through the page. */
const shaded_vertex_t *shaded_row(shaded_t *s, const layer_t *l, int32_t j);
/* The corners on the page. False if one is off by more than the hatching's lattice takes: far off the paper. */
bool shaded_place(const shaded_t *s, const shaded_vertex_t *const v[4], poly_point_t page[4]);
/* Twice the area of its picture; negative: clockwise. */
int64_t shaded_area2(const poly_point_t p[4]);
/* Where facet i of the layer at hand is in the chart. */
void shaded_chart(shaded_cell_t *f, const chart_t *c, const layer_t *l, int32_t i);
/* The other surfaces' facets in its cell. */
void shaded_others(shaded_t *s, shaded_cell_t *f, const sweep_t *sw, const layer_t *l, int32_t i);
/* Is all of it behind what is covered? */
bool shaded_is_hidden(const sweep_t *sw, const shaded_cell_t *f);

#endif
