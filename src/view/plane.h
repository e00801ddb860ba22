/* plane.h - scales of a central (or parallel) projection onto a vertical plane, chosen from the scene's box.
 *
 * In a frame of u (across, in the plane), v (depth, square to it) and z the projection is u / v and z / v, everything
 * relative to the eye. Its numerators are taken relative to the sight line through the middle of the box, which
 * loses nothing of a scene that is a million units away:
 *
 *     a = ((u - u_ref) - shear_u (v - v_ref)) / |v - eye_v|     w = ((z - z_ref) - shear_w (v - v_ref)) / |v - eye_v|
 *
 * If the eye is within the box's range of u (or z) the sight line keeps u (z) constant, so that points in the eye's own
 * vertical or level plane get a == 0 (w == 0) exactly. Parallel views: the same without the division, and u is taken as
 * it is.
 *
 * Scaling: numerators and reciprocals are integers, plane_project multiplies them and keeps the upper 32 bits. For
 * points inside the box |a|, |w| <= PENCIL_LIMIT, and one of them reaches a fourth of it at least. Error: 1 unit. */
#ifndef PLANE_H
#define PLANE_H

#include "num/num.h"
#include "view/pencil.h"

typedef struct plane {
    bool perspective;
    num_t u_ref, v_ref, z_ref, eye_v;
    num_t shear_u, shear_w;
    int16_t u_bits, z_bits, r_bits; /* numerators count 2^-u_bits, 2^-z_bits, reciprocals 2^-r_bits */
} plane_t;

/* lo and hi of u, v and z; the eye in the same frame, with v outside of its range. Parallel views: eye is the direction
 * to the eye, eye[0] == 0, eye[1] != 0. */
void plane_init(plane_t *p, bool perspective, const num_t u[2], const num_t v[2], const num_t z[2], const num_t eye[3]);

/* Numerators: the parts that come from u, from z, and what v adds to either. */
int32_t plane_u(const plane_t *p, num_t u);
int32_t plane_z(const plane_t *p, num_t z);
int32_t plane_u_of_v(const plane_t *p, num_t v);
int32_t plane_z_of_v(const plane_t *p, num_t v);
/* 1 / |v - eye_v|; perspective only. */
uint32_t plane_reciprocal(const plane_t *p, num_t v);

/* A numerator divided. */
static inline int32_t plane_project(int32_t n, uint32_t r) {
    return (int32_t)(((int64_t)n * (int64_t)r) >> 32);
}

/* a * 2^bits to nearest, saturating. */
int32_t plane_fixed(num_t a, int bits);
/* The largest k with a * 2^k < 2^bits, 0 for a == 0; a >= 0. */
int16_t plane_bits_below(num_t a, int bits);

#endif
