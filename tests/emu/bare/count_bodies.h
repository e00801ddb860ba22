/* count_bodies.h - the solids, wire frames and polygons whose cost is counted: families of the report (solid_rows.h) as
 * small as a Pico's memory takes. They are made in the compiler's floating point, which is not counted. */
#ifndef COUNT_BODIES_H
#define COUNT_BODIES_H

#include "poly/poly.h"
#include "scene/mesh.h"

enum body { BODY_CUBES, BODY_TORUS, BODY_BALL, BODY_RANDOM, BODIES };
extern const char *const body_name[BODIES];

#define BODY_VERTICES 128
#define BODY_WORDS 512

/* 4 x 4 cubes (Franklin & Akman's figure 4), a torus and a ball of triangles, 8 points around, and 12 slanting boxes
 * that do not touch. The mesh stays valid until the next call. */
const mesh_t *body_mesh(enum body which);

#define STAR_RAYS 40 /* vertices of a contour */
/* A star of the clipper's benchmark (stars.h), on a page whose unit is so many lat. */
void body_star(int spiky, int star, double unit, poly_vertex_t v[2 * STAR_RAYS]);

#endif
