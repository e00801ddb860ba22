/* hard_holes.h - faces with holes that touch their outer contour or each other, and what is around them. */
#ifndef HARD_HOLES_H
#define HARD_HOLES_H

#include "tests/oracle/solid_ref.h"

/* Holes that touch in points: on an edge, in a corner, in two corners, each other, all of it, one in another. */
#define HARD_HOLES 6
void hard_hole(solid_ref_t *r, int k);
/* Holes that share a part of an edge, or all of it, with the outer contour or each other; notched: the polygon that it
 * is then. */
#define HARD_NOTCHES 4
void hard_notch(solid_ref_t *r, int k, bool notched);

#endif
