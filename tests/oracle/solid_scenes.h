/* solid_scenes.h - random and hard scenes of solids, with their views. */
#ifndef SOLID_SCENES_H
#define SOLID_SCENES_H

#include <stdint.h>

#include "hidden/area/area.h"
#include "lang/settings.h"
#include "scene/mesh.h"
#include "tests/oracle/solid_ref.h"

typedef struct solid_scene {
    solid_ref_t ref; /* without the eye */
    settings_t set;  /* view and paper */
    char what[160];
    bool lattice;  /* bodies on a lattice: where they cut through each other, edges lie in faces that do */
    bool in_plane; /* the eye is in the plane of a face, of which others may be, too */
} solid_scene_t;

/* Up to `objects` of: boxes (turned, or touching each other on a lattice), pyramids, prisms (L-shaped ones too),
 * needles, tori, open sheets, single polygons, free segments; windings as they come, faces twice, faces without an
 * area. Seen from anywhere, from along the axes, from inside of the box, from the plane of a face. */
void solid_scene_random(solid_scene_t *s, uint64_t seed, int objects);
/* Up to `objects` boxes and wires on a lattice, flush in part with each other, in half of the scenes turned by some
 * angle. */
void solid_scene_flush(solid_scene_t *s, uint64_t seed, int objects);
/* Up to `objects` bodies of one kind that touch: wedges round an axis, tetrahedra that fill boxes, boxes in boxes,
 * stacks, bodies on both sides of a mirror, pyramids tip to tip; mostly turned, so that contacts are rounded. Seen from
 * anywhere, from planes of faces, from lines of edges, from close to a vertex. */
void solid_scene_touching(solid_scene_t *s, uint64_t seed, int objects);
/* Up to `objects` bodies as people put them together: rooms in rooms, cubes that share faces, stars and cogwheels,
 * stairs with boxes on them, cones of slivers, bodies that are there twice or a hair apart, regular ones, rows of
 * smaller and smaller boxes, piles of boards; turned and seen as the former. */
void solid_scene_composed(solid_scene_t *s, uint64_t seed, int objects);
/* As solid_scene_touching, from a hundredth to a tenth of a unit cube from a vertex. */
void solid_scene_close(solid_scene_t *s, uint64_t seed, int objects);
/* How far p is from the nearest face, or less: on a face, what the eye sees is a matter of taste. */
double solid_scene_clearance(const solid_ref_t *r, const exact_point_t *p);
/* Polygons as the area sort dislikes them, of one kind: faces with holes that touch each other and their outline, bars
 * in circles of which none is the first, slats woven into each other, plates in one plane and planes next to it, steps
 * with flush walls, sizes from 1 to 10,000; mostly turned. `objects` says how many, roughly. */
void solid_scene_polygons(solid_scene_t *s, uint64_t seed, int objects);
/* k x k unit cubes, pitch 1.5, 25 degrees above the ground: Franklin & Akman's figure 4. */
void solid_scene_cubes(solid_scene_t *s, int k);
/* n x n quadrilaterals of two triangles round a torus; hole 0: a ball. Seen as the cubes. */
void solid_scene_round(solid_scene_t *s, int n, double hole);
/* Those bodies alone, without the edges that only the reference needs. */
void solid_body_cubes(solid_ref_t *r, int k);
void solid_body_round(solid_ref_t *r, int n, double hole);
/* The environments of Weiler and Atherton's introduction: n rectangles that one covers, n of which each is seen in
 * part, as one piece, and n bars that divide each other. */
void solid_body_covered(solid_ref_t *r, int n);
void solid_body_shingles(solid_ref_t *r, int n);
void solid_body_woven(solid_ref_t *r, int n);
/* A tube of n x m quadrilaterals of two triangles in a trefoil knot; k x k prisms over an L, 3 apart. */
void solid_body_knot(solid_ref_t *r, int n, int m);
void solid_body_angles(solid_ref_t *r, int k);
void solid_scene_free(solid_scene_t *s);
/* Its faces and lines as the program has them. */
void solid_scene_mesh(const solid_ref_t *r, mesh_t *m);
void solid_scene_mesh_free(mesh_t *m);

/* A scene on its way through the program's stages, to be drawn as often as one likes. */
typedef struct solid_stage {
    bool area; /* by the area sort; else by the convex kernel */
    mesh_t mesh;
    solid_t solid;
    camera_t cam;
    solid_map_t map;
    void *mem[3];
    size_t bytes; /* lent to the kernel */
    hidden_stats_t stats;
    area_stats_t sorted;
} solid_stage_t;

/* Up to the kernel. Returns the stages' error; solid_stage_free() in any case. t must not move. */
int solid_stage_make(solid_stage_t *t, const solid_scene_t *s, bool area);
int solid_stage_draw(solid_stage_t *t, const ink_sink_t *sink);
/* Draws and judges every so-manieth edge (0: all). *good: within the limits of run_cases.h; out stays 0 where the eye
 * touches a face before the area sort: what it sees is then a matter of taste. Returns the kernel's error. */
int solid_stage_judge(solid_stage_t *t, const solid_scene_t *s, int every, judge_report_t *out, bool *good);
void solid_stage_free(solid_stage_t *t);

/* Draws it with the convex kernel; true if it is within the limits of run_cases.h. */
bool solid_scene_judge(const solid_scene_t *s, judge_report_t *out);
/* The same with the area sort. A scene in which area->intersections is not 0 afterwards is none for it. */
bool solid_scene_judge_area(const solid_scene_t *s, judge_report_t *out, area_stats_t *area);

#endif
