/* surface_visit.h - which cells of a grid can be between an edge and the eye: the part of surface_ref that only saves
 * time.
 *
 * The ground triangle (eye, edge), for a parallel view a strip, is cut by the slabs of the grid's rows; each cell that
 * it meets is visited, and a few more. */
#ifndef SURFACE_VISIT_H
#define SURFACE_VISIT_H

#include "tests/oracle/surface_ref.h"

/* The edge in question, with the box of its node indices. */
typedef struct query {
    const surface_ref_t *r;
    exact_point_t p[2];
    int imin, imax, jmin, jmax;
    int lean; /* +1, -1: seen from a little to the left, right of a vertical plane that holds it; else 0 */
} query_t;

/* A cell and the edge: apart; a cell that the edge borders; one that it would border if it were of the same sheet. */
enum place { APART, OWN, OVER };

typedef void surface_visit_fn(const query_t *q, int ci, int cj, enum place place, void *ctx);

/* Visits the cells of the edge's own sheet, and of the others with q->r standing for the sheet. */
void surface_visit(const query_t *q, surface_visit_fn *visit, void *ctx);

#endif
