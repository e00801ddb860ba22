/* sides.h - the four sides of a layer's facet, one at a time: for cells.c.
 *
 *        +--3--+       0 and 2 are column edges, 1 and 3 edges of line[0] and line[1]
 *        0     2
 *        +--1--+ */
#ifndef SIDES_H
#define SIDES_H

#include "hidden/surface/sweep.h"

#define SIDES 4

static inline bool side_is_column(int side) {
    return side % 2 == 0;
}

/* Has the side of cell i been clipped already? */
static inline uint8_t *side_done(layer_t *l, int32_t i, int side) {
    return side_is_column(side) ? &l->column_done[i + side / 2] : &l->row_done[side / 2][i];
}

/* Clips the side, or notes it (edges.h). Returns 0 or an error. */
static inline int side_clip(sweep_t *s, layer_t *l, int32_t i, int side) {
    return side_is_column(side) ? sweep_column_edge(s, l, i + side / 2) : sweep_row_edge(s, l, side / 2, i);
}

/* Which edges of a cell face the eye: a column or -1, a line or -1. */
typedef struct near_edges {
    int32_t column;
    int line;
} near_edges_t;

/* Those of cell i in a row: see sweep_row_t. */
near_edges_t side_near_edges(const chart_t *c, int32_t i, int far, bool fresh);

static inline bool side_faces_eye(near_edges_t near, int32_t i, int side) {
    return side_is_column(side) ? i + side / 2 == near.column : side / 2 == near.line;
}

/* Has the layer a facet in cell i? */
static inline bool side_present(const layer_t *l, int32_t i) {
    const uint8_t *h0 = l->line[0].hole, *h1 = l->line[1].hole;
    return !(h0[i] || h0[i + 1] || h1[i] || h1[i + 1]);
}

/* From now on edges are the layer's. */
static inline void side_take_layer(sweep_t *s, layer_t *l) {
    s->edges.runs.surface = l->surface;
    s->edges.outline = l->outline;
    s->edges.lines = l->lines;
}

/* Notes the lines that bound the layer's facet in cell i. */
int side_outline(sweep_t *s, layer_t *l, int32_t i);

/* Does the side lie in a vertical plane through the eye, but for rounding? */
bool side_is_vertical(const sweep_t *s, const layer_t *l, int32_t i, int side);

/* Have two layers the same edge there, but for rounding? */
bool side_coincides(const sweep_t *s, const layer_t *l, const layer_t *m, int32_t i, int side);

/* Notes what layer m hides of the vertical side of layer l, for edges_t.shade. Returns how many intervals: 0 to 2. */
int32_t side_shade(const sweep_t *s, const layer_t *l, const layer_t *m, int32_t i, int side, shade_t out[2]);

#endif
