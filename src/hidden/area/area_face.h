/* area_face.h - the polygons that the area sort works on: faces on the page, their boxes and depths. */
#ifndef AREA_FACE_H
#define AREA_FACE_H

#include "hidden/area/area_plane.h"

typedef struct area_box {
    int32_t x0, y0, x1, y1;
} area_box_t;

static inline bool area_boxes_meet(const area_box_t *a, const area_box_t *b) {
    return a->x0 < b->x1 && b->x0 < a->x1 && a->y0 < b->y1 && b->y0 < a->y1;
}
area_box_t area_box_of(const poly_vertex_t *v, int32_t n);
/* The halves across its longer side, whose length is returned; the first is the one at the lower end. */
int32_t area_box_halve(const area_box_t *box, area_box_t half[2]);
/* No wider than welds close from both sides (area_weld.c): the seam of two faces as rounding leaves it, or a face seen
 * edge-on. */
#define AREA_THIN 16
#define AREA_TENTH_OF_A_STEP 1280
bool area_is_thin(const poly_t *p, const area_box_t *box);
/* Is the corner b between a and c so pointed that it is no wider than a weld for a tenth of a step? */
bool area_is_sharp(poly_point_t a, poly_point_t b, poly_point_t c);

typedef struct area_face {
    int32_t face;     /* of the scene */
    int32_t first, n; /* vertices */
    area_box_t box;
    int64_t z_near, z_far;
    area_plane_t plane;
    int64_t slope, slack; /* area_plane_slope(); area_slack() at z_near */
    int32_t object;       /* of the scene */
    bool deep : 1;        /* its slack differs much from place to place */
    bool holed : 1;       /* then edges of it may cancel each other */
    bool sharp : 1;       /* a corner of it is so pointed that what welds close is long */
    bool on_stack : 1;
    bool body : 1;   /* the silhouette of an object (area_body.h): it has no plane */
    bool part : 1;   /* of one */
    bool broken : 1; /* a body that something may cut through */
} area_face_t;

typedef struct area_faces {
    area_face_t *face; /* what is sorted, by depth, nearest first; after that the faces that bodies consist of */
    int32_t n, parts;
    int32_t *of_object; /* area_body.c */
    poly_vertex_t *vertex;
    int32_t vertices;
    area_lattice_t lattice;
} area_faces_t;

/* Is the eye on the side of a face from which it runs counter-clockwise, the outer one of a closed object? */
bool area_looks_at_eye(const solid_map_t *m, int32_t face);
/* Is it turned away from an eye that cannot see it then: one with everything in front of it is outside of all closed
 * objects, and sees their outer sides only? into: translucent faces are looked through, into bodies of which they are
 * a part. */
bool area_is_turned_away(const solid_map_t *m, int32_t face, bool into);
/* What is left of a face that is clipped may have so many corners. */
#define AREA_CORNERS(clips, n) ((clips) ? 2 * (n) + 8 : (n))
/* Scratch for a face of n corners, and while it is clipped for twice as many as are left. */
#define AREA_SCRATCH(clips, n) ((size_t)(AREA_CORNERS(clips, n)) * ((clips) ? 2 : 1) * sizeof(area_corner_t))

/* A corner on its way to the page. */
typedef struct area_corner {
    area_place_t at;
    area_fine_t fine;
    int32_t tag;
} area_corner_t;

/* A face's corners on the page and in scratch, clipped where they cannot be drawn. v has room for AREA_CORNERS, which
 * is `most`, and scratch is AREA_SCRATCH. corner_edge: tags of all corners of the scene, or NULL. Returns how many, or
 * ERR_FULL. */
int32_t area_face_place(const area_lattice_t *l, const solid_face_t *f, const int32_t *corner_edge, poly_vertex_t *v,
                        area_corner_t *scratch, int32_t most);

/* The same of n edges of a detail's contour, from `edge` on (solid_tone). */
int32_t area_contour_place(const area_lattice_t *l, int32_t edge, int32_t n, poly_vertex_t *v, area_corner_t *scratch,
                           int32_t most);

/* How much the depth of a face may be off where it is z: SOLID_FLAT units of the scene across its plane. */
int64_t area_slack(const area_lattice_t *l, const area_face_t *f, int64_t z);
/* How many faces may take part: not those of closed objects that are seen from behind. */
int32_t area_faces_most(const solid_map_t *m);
/* Those of them that are not seen edge-on. faces->lattice is set, ->face has room for area_faces_most() and one more,
 * ->vertex for AREA_CORNERS of each. corner_edge: lent, one for each corner; scratch: AREA_SCRATCH of the largest face.
 * state: of each face of the scene, enum area_state (area_wires.h). Returns 0 or ERR_FULL. */
int area_faces_make(area_faces_t *faces, int32_t *corner_edge, uint8_t *state, area_corner_t *scratch, int32_t most);

#endif
