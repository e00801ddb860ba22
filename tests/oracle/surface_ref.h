/* surface_ref.h - what of a grid surface can be seen: the reference the kernels are judged by.
 *
 * Method. No order, no horizon, no incremental state: each grid edge is held against every cell that the ground
 * triangle (eye, edge) meets. On a vertical plane through the eye a cell covers what lies between the plane's
 * crossing with the cell's near chain and the one with its far chain (Anderson's facet; twisted ones too). Along the
 * edge each of those conditions is the sign of a linear function, a 2x2 or 3x3 determinant, so each cell hides an
 * intersection of half-lines of the parameter. Signs are exact (exact_sign.h); interval ends are good to about 2^-58.
 *
 * Ties. A point is hidden only strictly inside of a cover. An edge that lies in a vertical plane through the eye is on
 * the border of every cell that could hide it; it is hidden where the cells on its left and those on its right both
 * hide it, visible where neither does, `either` in between. Where an edge falls together on the page with a nearer one
 * it is `either`, too: the ink is there in any case. A cell right below or above the eye whose four corners do not tell
 * on which side of it the eye is makes `either` of what it might hide.
 *
 * Holes: cells with an undefined corner do not exist; an edge exists if one of its cells does.
 * Cost: O(cells met) per edge, about 0.1 us each. */
#ifndef SURFACE_REF_H
#define SURFACE_REF_H

#include <stdbool.h>

#include "tests/oracle/exact_sign.h"
#include "tests/oracle/spans.h"

typedef struct surface_ref {
    int nx, ny;
    double *x, *y;       /* strictly increasing */
    double *z;           /* z[j * nx + i] */
    unsigned char *hole; /* same layout, 1 where undefined; NULL if there are none */
    exact_eye_t eye;
    /* Further sheets over the same grid, which hide this one too. They must not cross it or each other: two cells over
     * one rectangle have no order of their own. */
    int sheets;
    double *const *sheet_z;
    unsigned char *const *sheet_hole; /* NULL if no sheet has holes */
} surface_ref_t;

enum { REF_ROW = 0, REF_COL = 1 }; /* y = y[line], counted along x; x = x[line], counted along y */

exact_point_t surface_ref_node(const surface_ref_t *r, int i, int j);
bool surface_ref_cell_exists(const surface_ref_t *r, int ci, int cj);
/* Is edge k of a line (from vertex k to k + 1) there? */
bool surface_ref_edge_exists(const surface_ref_t *r, int family, int line, int k);
/* Ends of that edge. */
void surface_ref_edge_ends(const surface_ref_t *r, int family, int line, int k, exact_point_t end[2]);
/* Where the edge is hidden, as intervals of [0, 1]; what may count as either goes to `either`. */
void surface_ref_edge(const surface_ref_t *r, int family, int line, int k, spans_t *hidden, spans_t *either);
/* The same for the segment `moved` in place of the edge, taken to be as far from the eye as the edge: how the judge
 * asks what a small error of the drawing could have shown. The two cells that the edge borders hide nothing of it. */
void surface_ref_moved(const surface_ref_t *r, int family, int line, int k, const exact_point_t moved[2],
                       spans_t *hidden);

/* Where the edge runs, on the page, between `moved` and `other` (the edge moved to both sides) together with a nearer
 * edge: there is ink in that place whoever draws it. */
void surface_ref_doubled(const surface_ref_t *r, int family, int line, int k, const exact_point_t moved[2],
                         const exact_point_t other[2], spans_t *out);

#endif
