/* area_detail.h - surface detail: lines on a face, of which its visible polygons show parts (Weiler & Atherton 1977).
 *
 * A detail is inside of a polygon between two crossings with its border (even-odd). Where that is an edge of the scene,
 * the crossing is that of the two lines before they are rounded to the lattice: faces that are seen almost edge-on have
 * lines that meet their borders at angles where rounding would move the crossing by steps. */
#ifndef AREA_DETAIL_H
#define AREA_DETAIL_H

#include "hidden/area/area_place.h"
#include "hidden/intervals.h"

/* Adds what of the details of a face lies in a visible polygon of it, lines numbered as the scene's edges. Returns 0 or
 * ERR_FULL. Cost: details times vertices. */
int area_details(const area_lattice_t *l, int32_t face, const poly_t *p, intervals_t *to);

/* The first detail of a face, an edge of the scene, or of a later one. */
int32_t area_detail_first(const solid_t *s, int32_t face);

#endif
