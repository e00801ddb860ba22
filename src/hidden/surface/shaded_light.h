/* shaded_light.h - the light on a facet of a surface. Not for other files than shaded.c. */
#ifndef SHADED_LIGHT_H
#define SHADED_LIGHT_H

#include "hidden/surface/shaded.h"
#include "scene/grid.h"

/* All lights together on a facet that is turned squarely to them: at least as much as one. */
void shaded_weigh_lights(shaded_t *s);
/* What a facet gets, as a share of the most, on the side that runs counter-clockwise (turn: the other one). */
int64_t shaded_brightness(const shaded_t *s, const grid_t *g, int32_t i, int32_t j, const shaded_vertex_t *v[4],
                          bool turn);

#endif
