/* solid_build.h - what the files of src/scene/solid*.c share while a scene is put together; not for others. */
#ifndef SOLID_BUILD_H
#define SOLID_BUILD_H

#include "scene/solid.h"

typedef struct solid_build {
    solid_t *s;
    solid_vertex_t *vertex;
    solid_edge_t *edge;
    int32_t edges_max; /* there is memory for */
    bool full;         /* and it did not suffice */
    solid_face_t *face;
    int32_t *corner;
    solid_object_t *object;
    int32_t bits; /* of the fixed point numbers that vertices pass through */
    int64_t origin[3];
    /* Until the end of the work only: */
    solid_edge_t *detail;
    bool new_polygon;     /* the next contour of a detail begins one */
    int32_t *map;         /* vertex of the mesh at hand -> vertex, or -1 */
    int32_t *slot;        /* hash table of vertices, later of edges; -1: free */
    uint32_t slots;       /* a power of two */
    int32_t *corner_face; /* face of each corner */
    int32_t *corner_next; /* the next corner whose edge lies between the same vertices; -1 */
    int32_t *group;       /* of each face: which `o` or `g` of which mesh; they do not decrease */
    uint32_t *parent;     /* of faces: parent << 1 | does it run the other way; then the face's turn alone */
} solid_build_t;

/* The next edge, a free one; NULL and b->full if there is no memory for it. */
static inline solid_edge_t *solid_new_edge(solid_build_t *b, int32_t p, int32_t q) {
    const int32_t e = b->s->ne;
    b->full |= e == b->edges_max;
    if (b->full) return NULL;
    b->s->ne++;
    b->edge[e] = (solid_edge_t){{p < q ? p : q, p < q ? q : p}, {-1, -1}, -1, e};
    return &b->edge[e];
}

/* solid_join.c: from corners to edges, objects and kinds. s->ne: free segments are there already. */
void solid_join(solid_build_t *b);
/* solid_double.c: leaves out faces that their group has twice, before there are corners' chains; returns whether there
 * were any. parent, slot: used meanwhile. Not done when memory is so short that slots are fewer than faces. */
bool solid_drop_doubles(solid_build_t *b);
/* solid_convex.c: objects marked convex that are not become closed ones. Faces run outward. */
void solid_find_convex(solid_build_t *b);

#endif
