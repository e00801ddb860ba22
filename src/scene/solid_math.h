/* solid_math.h - exact products of lattice vectors (solid.h). */
#ifndef SOLID_MATH_H
#define SOLID_MATH_H

#include "num/wide.h"
#include "scene/solid.h"

/* Components of a difference of vertices, and of a normal. */
typedef struct solid_delta {
    int32_t d[3];
} solid_delta_t;
typedef struct solid_normal {
    int64_t n[3];
} solid_normal_t;

static inline solid_delta_t solid_sub(const solid_vertex_t *a, const solid_vertex_t *b) {
    return (solid_delta_t){{a->at[0] - b->at[0], a->at[1] - b->at[1], a->at[2] - b->at[2]}};
}

static inline solid_normal_t solid_cross(solid_delta_t a, solid_delta_t b) {
    return (solid_normal_t){{wide_mul_s32(a.d[1], b.d[2]) - wide_mul_s32(a.d[2], b.d[1]),
                             wide_mul_s32(a.d[2], b.d[0]) - wide_mul_s32(a.d[0], b.d[2]),
                             wide_mul_s32(a.d[0], b.d[1]) - wide_mul_s32(a.d[1], b.d[0])}};
}

static inline wide_t solid_dot(const solid_normal_t *n, solid_delta_t d) {
    return wide_dot3(n->n, d.d);
}

static inline uint64_t solid_abs(int64_t a) {
    return a < 0 ? 0 - (uint64_t)a : (uint64_t)a;
}

/* SOLID_FLAT times the sum of the normal's components: how much a dot product may differ from 0 in its plane. */
wide_t solid_slack(const solid_normal_t *n);

/* Twice the area of a face as a vector: its normal, outward where it runs outward. All zero for a face without an area,
 * or one so tangled that it has none. */
solid_normal_t solid_face_normal(const solid_t *s, int32_t face);
/* Its direction in 30 bits, rounded down where it had more. */
void solid_shorten(solid_normal_t *n);
/* Do all corners lie in a plane within SOLID_FLAT? */
bool solid_face_is_flat(const solid_t *s, int32_t face, const solid_normal_t *normal);
/* Do all corners of a face lie in the plane of another, within SOLID_FLAT? */
bool solid_face_lies_in(const solid_t *s, int32_t face, int32_t of);
/* Is the face flat within SOLID_FLAT, and its polygon convex? */
bool solid_face_is_convex(const solid_t *s, int32_t face, const solid_normal_t *normal);

#endif
