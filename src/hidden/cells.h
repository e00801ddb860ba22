/* cells.h - several surfaces over the same points, with holes or without.
 *
 * Cell by cell, in the order of the sweep: the near edges of all surfaces in the cell are clipped against what the
 * cells before it cover, the others also against the other surfaces' facets in the cell; then all its facets cover.
 * Where facets of two surfaces cross, each still hides what it should; the line in which they cross is not drawn. */
#ifndef CELLS_H
#define CELLS_H

#include "hidden/sweep.h"

/* A sweep_row_t for sweeps with gaps. */
int cells_row(sweep_t *s, int far, bool fresh);

#endif
