/* profiles_mesh.h - a terrain of triangles cut by vertical planes: another source of profiles.
 *
 * Each triangle that a plane meets gives one segment; sorted across the view they make the profile, with a gap where
 * two neighbours do not share an edge. A plane through a vertex is taken to pass just before it, so that every
 * triangle gives one segment or none, and neighbours meet in the same point exactly. */
#ifndef PROFILES_MESH_H
#define PROFILES_MESH_H

#include "scene/mesh.h"
#include "scene/profiles.h"
#include <stddef.h>

/* The source's own: the profile at hand and the vertices' depths, in lent memory. */
typedef struct profiles_mesh {
    const mesh_t *mesh;
    num_t side[2], away[2];
    int64_t *depth; /* of each vertex, in units of 2^-bits */
    int16_t bits;
    int64_t nearest, range;   /* of the depths */
    int32_t count;            /* profiles */
    struct profiles_cut *cut; /* the segments of profile `at`, sorted */
    int32_t *vertex;          /* its vertices: 2 * segment + end, or -1 in a gap */
    int32_t segments, vertices, capacity;
    int32_t at;
} profiles_mesh_t;

/* Makes p a source of `count` profiles across mesh, square to the view, evenly spaced: the k-th at (k + 1/2) / count of
 * the way from the nearest to the farthest vertex. mem (aligned to 8 bytes) must outlive p, as must s and mesh; 8
 * bytes per vertex and PROFILES_MESH_SEGMENT per triangle in the fullest profile are used.
 * Returns 0; ERR_EMPTY for a mesh without triangles or extent, ERR_VALUE for count < 1, or ERR_FULL.
 * Cost: one look at each triangle when another profile is asked for than last time. */
#define PROFILES_MESH_SEGMENT 76
int profiles_from_mesh(profiles_t *p, profiles_mesh_t *s, const mesh_t *mesh, const camera_t *cam, int32_t count,
                       void *mem, size_t bytes);

#endif
