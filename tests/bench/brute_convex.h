/* brute_convex.h - what bench_solids is compared with: every edge against every convex body, in floating point.
 *
 * Ricci's method as one writes it in an afternoon, without a grid, for a parallel view and convex bodies that are there
 * already: vertices are turned into the view, planes and outlines found, then each edge that does not hide itself is
 * clipped by each body whose box it meets. Nothing is exact, nothing is checked, what coincides is drawn twice. */
#ifndef BRUTE_CONVEX_H
#define BRUTE_CONVEX_H

#include <stdint.h>

#include "scene/solid.h"

typedef struct brute brute_t;

/* Takes a scene over (untimed); all its objects are convex. NULL if there is no memory. */
brute_t *brute_new(const solid_t *s);
void brute_free(brute_t *b);
/* Turns the vertices: rows of the view are right, up and towards the eye. */
void brute_view(brute_t *b, const double view[3][3]);
/* Planes, outlines, boxes, then all edges. Returns how many visible pieces there are, *ink their sum in parts of edges.
 */
int32_t brute_hide(brute_t *b, double *ink);

#endif
