/* plane.c - see plane.h. */
#include "view/plane.h"

#include <stddef.h>

/* Room for rounding between 2^30 and PENCIL_LIMIT. */
#define SLACK num_from_fixed((1 << 16) + 1, 16)

int32_t plane_fixed(num_t a, int bits) {
    int64_t v = num_to_fixed(a, bits, NULL);
    return v > INT32_MAX ? INT32_MAX : v < -INT32_MAX ? -INT32_MAX : (int32_t)v;
}

int16_t plane_bits_below(num_t a, int bits) {
    return (int16_t)(a.m == 0 ? 0 : bits - 63 - a.e);
}

static num_t middle(num_t a, num_t b) {
    return num_ldexp(num_add(a, b), -1);
}

static bool outside(num_t a, const num_t range[2]) {
    return num_cmp(a, range[0]) < 0 || num_cmp(a, range[1]) > 0;
}

/* The largest numerator, divided in perspective, over the corners of the rectangle n x v. */
static num_t extent(const plane_t *p, const num_t n[2], num_t n_ref, const num_t v[2], num_t shear) {
    num_t most = num_from_i64(0);
    for (int k = 0; k < 4; k++) {
        num_t a = num_sub(num_sub(n[k & 1], n_ref), num_mul(shear, num_sub(v[k >> 1], p->v_ref)));
        if (p->perspective) a = num_div(a, num_sub(v[k >> 1], p->eye_v));
        if (num_cmp(most, num_abs(a)) < 0) most = num_abs(a);
    }
    return num_mul(most, SLACK);
}

void plane_init(plane_t *p, bool perspective, const num_t u[2], const num_t v[2], const num_t z[2],
                const num_t eye[3]) {
    const num_t zero = num_from_i64(0);
    *p = (plane_t){.perspective = perspective, .eye_v = eye[1], .shear_u = zero, .shear_w = zero};
    p->v_ref = middle(v[0], v[1]);
    if (!perspective) {
        p->u_ref = middle(u[0], u[1]);
        p->z_ref = middle(z[0], z[1]);
        p->shear_w = num_div(eye[2], eye[1]);
        p->u_bits = plane_bits_below(extent(p, u, p->u_ref, v, zero), 30);
        p->z_bits = plane_bits_below(extent(p, z, p->z_ref, v, p->shear_w), 30);
        return;
    }
    num_t depth = num_sub(p->v_ref, eye[1]);
    p->u_ref = eye[0];
    p->z_ref = eye[2];
    if (outside(eye[0], u)) {
        p->u_ref = middle(u[0], u[1]);
        p->shear_u = num_div(num_sub(p->u_ref, eye[0]), depth);
    }
    if (outside(eye[2], z)) {
        p->z_ref = middle(z[0], z[1]);
        p->shear_w = num_div(num_sub(p->z_ref, eye[2]), depth);
    }
    num_t near = num_sub(v[0], eye[1]), other = num_sub(v[1], eye[1]);
    if (num_cmp(num_abs(other), num_abs(near)) < 0) near = other;
    /* a = (n * r) >> 32: the scales of n and r add up to 32 more than that of a. r fills 32 bits at the nearest
     * depth; |a| < 2^30 there, so |n| < 2^31, and it is no larger elsewhere. */
    p->r_bits = plane_bits_below(num_div(num_from_i64(1), num_abs(near)), 32);
    p->u_bits = (int16_t)(plane_bits_below(extent(p, u, p->u_ref, v, p->shear_u), 30) + 32 - p->r_bits);
    p->z_bits = (int16_t)(plane_bits_below(extent(p, z, p->z_ref, v, p->shear_w), 30) + 32 - p->r_bits);
}

int32_t plane_u(const plane_t *p, num_t u) {
    return plane_fixed(num_sub(u, p->u_ref), p->u_bits);
}

int32_t plane_z(const plane_t *p, num_t z) {
    return plane_fixed(num_sub(z, p->z_ref), p->z_bits);
}

int32_t plane_u_of_v(const plane_t *p, num_t v) {
    return -plane_fixed(num_mul(p->shear_u, num_sub(v, p->v_ref)), p->u_bits);
}

int32_t plane_z_of_v(const plane_t *p, num_t v) {
    return -plane_fixed(num_mul(p->shear_w, num_sub(v, p->v_ref)), p->z_bits);
}

uint32_t plane_reciprocal(const plane_t *p, num_t v) {
    int64_t r = num_to_fixed(num_div(num_from_i64(1), num_abs(num_sub(v, p->eye_v))), p->r_bits, NULL);
    return r > (int64_t)UINT32_MAX ? UINT32_MAX : (uint32_t)r;
}
