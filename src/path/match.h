/* match.h - the order of very many strokes: ends that are near each other are linked until all are one tour.
 *
 * Greedy matching instead of a walk to the nearest end (tour.h): the cells of a grid are gone through in order, and
 * every end is linked with the nearest that has no link yet, in its cell and those that come after it, unless that
 * would close a circle too soon. What is left, a few ends for which nobody was there, goes through the same again on a
 * coarser grid, and so on. Compared with the walk, a rough surface's pen-up travel is a tenth less, since nothing is
 * left behind that has to be fetched from afar (Johnson and McGeoch 1997: greedy tours are 14-18 % above the best, the
 * walk 25); strokes strewn at random are travelled to as far. It takes half the time, since one search serves two ends,
 * and looks at memory that the last one has just looked at.
 * Where strokes are so few that their tour is worth improving, the walk is as good a beginning. */
#ifndef MATCH_H
#define MATCH_H

#include "path/places.h"
#include "path/tour.h"

#define MATCH_STROKES_MIN 65536

/* Puts the strokes in order, if they are so many: a tour of ends of runs (tour.h). Else returns false. The far sides of
 * free ends are no longer known then (pool.h). Cost near-linear. */
bool match_order(places_t *p, tour_t *t);

#endif
