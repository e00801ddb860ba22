/* hard_solids.h - solids, viewpoints and wire frames that break hidden-line programs, by name. */
#ifndef HARD_SOLIDS_H
#define HARD_SOLIDS_H

#include "hidden/halo/halo.h"
#include "tests/oracle/solid_scenes.h"

/* Scenes 0 .. hard_solids_count() - 1, for the convex kernel and the area sort. */
int hard_solids_count(void);
const char *hard_solids_name(int i);
/* Makes one, to be freed. Of large ones every so-manieth edge alone is to be judged: that is returned, or 0. */
int hard_solids_build(int i, solid_scene_t *s);

/* Wire frames for haloes: edges on the page, and how wide a halo they are to have. */
#define HARD_WIRES_EDGES 400
int hard_wires_count(void);
const char *hard_wires_name(int i);
int hard_wires_build(int i, halo_edge_t edge[HARD_WIRES_EDGES], int32_t *width);

#endif
