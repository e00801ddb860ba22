/* solid_side.c - see solid_side.h. */
#include "view/solid_side.h"

static wide_t eye_dot(const solid_map_t *m, const solid_normal_t *n, const solid_vertex_t *p) {
    int64_t v[3];
    solid_to_eye(m, p, v);
    return wide_dot3_s64(n->n, v);
}

int solid_side_exact(const solid_map_t *m, const solid_normal_t *n, const solid_vertex_t *p) {
    return wide_sign(eye_dot(m, n, p));
}

int solid_side(const solid_map_t *m, const solid_normal_t *n, const solid_vertex_t *p) {
    const wide_t sum = eye_dot(m, n, p);
    const int sign = wide_sign(sum);
    if (m->eye.w == 0 || sign == 0) return sign;
    const uint64_t size = solid_abs(n->n[0]) + solid_abs(n->n[1]) + solid_abs(n->n[2]);
    const wide_u_t near = wide_mul_u64(size, SOLID_FLAT * (uint64_t)m->eye.w); /* 2^60 2^24 */
    return wide_cmp(sign < 0 ? wide_neg(sum) : sum, (wide_t){(int64_t)near.hi, near.lo}) <= 0 ? 0 : sign;
}
