/* halo_scenes.h - the wire frames of Franklin & Akman (1987), for the benchmark and the report. */
#ifndef HALO_SCENES_H
#define HALO_SCENES_H

#include "hidden/halo/halo.h"

#define HALO_SCENE_PAGE 8600000 /* lat: the short side of an A4 sheet, with margins */

/* n random edges, section 4. "Average length L" means that dx and dy are uniform in +-L; such edges begin at a random
 * place of the unit square. */
void halo_scene_random(halo_edge_t *edge, int32_t n, double length);
/* Figure 4: k x k unit cubes, 1.5 apart, seen from 25 degrees above; edge: 12 k k. Returns the size of a cube, lat. */
double halo_scene_cubes(halo_edge_t *edge, int k);

#endif
