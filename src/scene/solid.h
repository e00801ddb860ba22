/* solid.h - a scene of solids and wire frames: meshes put together on one lattice of integers.
 *
 * Vertices are integers, rounded once: the scene's box is centred and its longest side scaled by a power of two to
 * SOLID_BITS bits, so what lies in a plane x = const of the files lies in one here, and small decimals are exact.
 * Vertices that fall together are one vertex; an edge is there once for all faces of its object.
 *
 * An object is what hangs together by edges of two faces each, so that a cube whose sides are six groups is a cube, and
 * a hundred cubes in one group are a hundred. `o` and `g` of a file matter only where bodies touch along an edge. Faces
 * of a closed object are turned so that they run counter-clockwise seen from outside, whatever the file says; an object
 * is convex if a segment between any two of its points stays inside. Polygons stay polygons.
 *
 * Bits: |coordinate| <= 2^27; the difference of two fits 2^28, a component of a triangle's normal 2^57, its product
 * with a difference 2^87 in wide_t. Memory: solid_bytes(); 12 bytes a vertex, 12 a face, 4 a corner, 24 an edge stay in
 * use. */
#ifndef SOLID_H
#define SOLID_H

#include "scene/mesh.h"
#include <stddef.h>

#ifndef SOLID_BITS /* the report tries fewer */
#define SOLID_BITS 28
#endif
#define SOLID_FLAT                                                                                                     \
    4 /* lattice units: so far from a plane, as its normal's largest sum measures it, is in the plane                  \
       */

_Static_assert(2 * SOLID_BITS + 1 < 62, "a normal fits 64 bits");
_Static_assert(3 * SOLID_BITS + 1 + 2 + 3 < 126, "a determinant of three differences fits wide_t");

typedef struct solid_vertex {
    int32_t at[3];
} solid_vertex_t;

typedef struct solid_edge {
    int32_t v[2];    /* v[0] < v[1] */
    int32_t face[2]; /* of one object: [0] runs from v[0] to v[1], [1] the other way (open and twisted objects: either
                        way); -1: none. Both -1: a free segment */
    int32_t twin;    /* the next edge between the same two vertices, -1 at the end */
    int32_t first;   /* the first of them, which stands for all in ink; itself for most */
} solid_edge_t;

typedef struct solid_face {
    int32_t corner; /* solid->corner[corner .. corner + n - 1], n >= 3; neighbours differ */
    int32_t n : 31;
    bool clear : 1; /* translucent */
    int32_t object;
} solid_face_t;

enum solid_kind {
    SOLID_OPEN,   /* with a border, or twisted, or edges of more than two faces: both sides of faces may be seen */
    SOLID_CLOSED, /* the surface of a body: edges have two faces each, which run outward */
    SOLID_CONVEX, /* and the body is convex */
};

typedef struct solid_object {
    int32_t faces;
    int32_t smooth_q30; /* of the mesh of its first face (mesh.h) */
    uint8_t kind;       /* enum solid_kind */
    bool clear;         /* some of its faces are translucent */
} solid_object_t;

typedef struct solid {
    int32_t nv, ne, nf, no, nc; /* vertices, edges, faces, objects, corners */
    const solid_vertex_t *vertex;
    const solid_edge_t *edge; /* free segments included */
    int32_t nd;               /* edge[ne] .. edge[ne + nd - 1] are details: lines on face[0], in its order. They hide
                                 nothing, and only the area sort knows them. Of polygons with a tone face[1] is
                                 solid_tone_t, and they follow one another around each contour */
    const solid_face_t *face;
    const int32_t *corner; /* vertices */
    const solid_object_t *object;
    num_t lo[3], hi[3]; /* the box, in the files' coordinates; with the rounding of vertices where it is thin */
    num_t origin[3];    /* coordinate = origin + at * 2^-shift */
    int32_t shift;
    size_t bytes; /* of the lent memory that stay in use */
} solid_t;

/* Is the edge, with all twins behind it, a cut from a polygon's border to a hole in it? Both sides are one face, and it
 * is no line of the drawing. */
static inline bool solid_is_cut(const solid_t *s, const solid_edge_t *e) {
    while (e->face[0] >= 0 && e->face[0] == e->face[1]) {
        if (e->twin < 0) return true;
        e = &s->edge[e->twin];
    }
    return false;
}

/* Memory that certainly suffices for these meshes while they are put together. */
size_t solid_bytes(const mesh_t *const *mesh, int32_t n);
/* What solid_build gets through with at the least, if every edge has two faces. */
size_t solid_bytes_least(const mesh_t *const *mesh, int32_t n);
/* Puts n meshes together in mem (aligned to 8), which lives as long as s; s->bytes of it are used afterwards. The
 * meshes are not needed any more then. Faces without an area and segments without a length are left out. Returns 0;
 * ERR_EMPTY if nothing is left; ERR_FULL; ERR_VALUE for coordinates beyond any use, and for
 * scenes 2^48 times as far from the origin as they are large. Cost: linear but for hashing; about
 * 0.5 us a corner on a desktop. */
int solid_build(solid_t *s, const mesh_t *const *mesh, int32_t n, void *mem, size_t bytes);

/* Makes free segments of the details, for kernels that do not know them: what lies on a face is seen like it. */
void solid_free_details(solid_t *s);
/* What face[1] < 0 of a detail says: of edges of polygons with a tone. */
typedef struct solid_tone {
    int32_t percent; /* of the light that it gives back */
    bool turned;     /* it runs from v[1] to v[0] */
    bool contour;    /* it begins a contour */
    bool polygon;    /* and that a polygon */
} solid_tone_t;
static inline solid_tone_t solid_tone(const solid_edge_t *e) {
    const int32_t code = ~e->face[1];
    return (solid_tone_t){code >> 3, code & 1, code >> 1 & 1, code >> 2 & 1};
}
/* Is the face translucent? */
static inline bool solid_is_clear(const solid_t *s, int32_t face) {
    return s->face[face].clear;
}
/* Do the edge's two faces meet so flatly that `crease` leaves it to outlines? Or does it run across a cell of a surface
 * (MESH_GRID)? */
bool solid_is_smooth(const solid_t *s, const solid_edge_t *e);

#endif
