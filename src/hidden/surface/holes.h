/* holes.h - one surface with holes: two horizons, and the windows between them.
 *
 * As perimeter.c has it, but a facet may have a near edge that no facet in front of it ends at: the hole's far rim.
 * Such an edge is clipped first, and leaves a window between it and the horizon. Edges show beyond the horizons and
 * through windows; a facet that has windows over it closes what it covers of them. Away from windows facets cost what
 * they do without holes. */
#ifndef HOLES_H
#define HOLES_H

#include "hidden/surface/sweep.h"

/* A sweep_row_t for COVER_WINDOWS. */
int holes_row(sweep_t *s, int far, bool fresh);

#endif
