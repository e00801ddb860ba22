/* cells.h - several surfaces over the same points, with holes or without.
 *
 * Cell by cell, in the order of the sweep, against two horizons and the windows between them, as holes.h has it: the
 * near edges of all surfaces in the cell are looked at first, the others also against the other surfaces' facets in the
 * cell; then all its facets cover. That needs no order among the surfaces: where facets of two cross, each still hides
 * what it should; the line in which they cross is not drawn. */
#ifndef CELLS_H
#define CELLS_H

#include "hidden/surface/sweep.h"

/* A sweep_row_t for COVER_WINDOWS and several layers. */
int cells_row(sweep_t *s, int far, bool fresh);

#endif
