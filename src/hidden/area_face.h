/* area_face.h - the polygons that the area sort works on: faces on the page, their boxes and depths. */
#ifndef AREA_FACE_H
#define AREA_FACE_H

#include "poly/poly.h"
#include "view/solid_map.h"

/* Vertices are kept finer than a lat, by as many bits as the scene's size leaves: cuts at small angles need them. */
typedef struct area_lattice {
    const solid_map_t *m;
    int bits;       /* 1 lat is 2^bits units */
    int64_t near_e; /* perspective: the least depth of all vertices in front of the eye; z is -2^49 there */
} area_lattice_t;

#define AREA_LATTICE_BITS 5
#define AREA_Z_BITS 49

area_lattice_t area_lattice(const solid_map_t *m);
/* A vertex that is not behind the eye, and its depth: as solid_place_t.z, but finer. */
poly_point_t area_vertex(const area_lattice_t *l, int32_t v, int64_t *z);
/* The ends of what of an edge is in front of the eye, with their depths, and their parameters in space. False if there
 * is nothing. */
bool area_edge(const area_lattice_t *l, int32_t edge, poly_point_t end[2], int64_t z[2], int64_t t_q30[2]);

/* From a fraction of the way between such ends to the parameter in space (q30). */
int64_t area_space(const area_lattice_t *l, int32_t edge, int32_t page_q30);

typedef struct area_box {
    int32_t x0, y0, x1, y1;
} area_box_t;

static inline bool area_boxes_meet(const area_box_t *a, const area_box_t *b) {
    return a->x0 < b->x1 && b->x0 < a->x1 && a->y0 < b->y1 && b->y0 < a->y1;
}
area_box_t area_box_of(const poly_vertex_t *v, int32_t n);
/* No wider than a few units: the seam of two faces as rounding leaves it, or a face seen edge-on. */
bool area_is_thin(const poly_t *p, const area_box_t *box);

/* Depth over the page, as the plane through three corners that span the face. */
typedef struct area_plane {
    poly_point_t a, b, c;
    int64_t za, zb, zc;
    int64_t slack; /* so much a depth may be off, since the corners are rounded */
} area_plane_t;

typedef struct area_face {
    int32_t face;     /* of the scene */
    int32_t first, n; /* vertices */
    area_box_t box;
    int64_t z_near;
    area_plane_t plane;
    bool on_stack;
} area_face_t;

typedef struct area_faces {
    area_face_t *face; /* by depth, nearest first */
    int32_t n;
    poly_vertex_t *vertex;
    int32_t vertices;
    area_lattice_t lattice;
} area_faces_t;

/* Is the eye on the side of a face from which it runs counter-clockwise, the outer one of a closed object? */
bool area_looks_at_eye(const solid_map_t *m, int32_t face);
/* Depth at a place, smaller is nearer. */
int64_t area_depth(const area_plane_t *p, poly_point_t at);
/* What is left of a face that is cut off behind the eye may have so many corners. */
#define AREA_CORNERS(map, n) ((map)->any_behind ? 2 * (n) : (n))

/* How many faces may take part: not those of closed objects that are seen from behind. */
int32_t area_faces_most(const solid_map_t *m);
/* Those of them that are not seen edge-on. faces->face has room for area_faces_most() and one more, ->vertex for
 * AREA_CORNERS of all. corner_edge and depths: lent, one for each corner
 * and AREA_CORNERS of the largest face. state: of each face
 * of the scene, enum area_state (area_wires.h). */
void area_faces_make(area_faces_t *faces, const solid_map_t *m, int32_t *corner_edge, uint8_t *state, int64_t *depths);

#endif
