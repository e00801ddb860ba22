/* solid_scenes.h - random and hard scenes of solids, with their views. */
#ifndef SOLID_SCENES_H
#define SOLID_SCENES_H

#include <stdint.h>

#include "hidden/area.h"
#include "lang/settings.h"
#include "scene/mesh.h"
#include "tests/oracle/solid_ref.h"

typedef struct solid_scene {
    solid_ref_t ref; /* without the eye */
    settings_t set;  /* view and paper */
    char what[160];
} solid_scene_t;

/* Up to `objects` of: boxes (turned, or touching each other on a lattice), pyramids, prisms (L-shaped ones too),
 * needles, tori, open sheets, single polygons, free segments; windings as they come, faces twice, faces without an
 * area. Seen from anywhere, from along the axes, from inside of the box, from the plane of a face. */
void solid_scene_random(solid_scene_t *s, uint64_t seed, int objects);
void solid_scene_free(solid_scene_t *s);
/* Its faces and lines as the program has them. */
void solid_scene_mesh(const solid_ref_t *r, mesh_t *m);
void solid_scene_mesh_free(mesh_t *m);
/* Draws it with the convex kernel; true if it is within the limits of run_cases.h. */
bool solid_scene_judge(const solid_scene_t *s, judge_report_t *out);
/* The same with the area sort. A scene in which area->intersections is not 0 afterwards is none for it. */
bool solid_scene_judge_area(const solid_scene_t *s, judge_report_t *out, area_stats_t *area);

#endif
