/* solid_math.c - see solid_math.h. */
#include "scene/solid_math.h"

#include "num/ints.h"

/* Fans of up to so many triangles cannot overflow whatever their polygon does. */
#define SURE_CORNERS 16

solid_normal_t solid_face_normal(const solid_t *s, int32_t face) {
    const solid_face_t *f = &s->face[face];
    const int32_t *c = s->corner + f->corner;
    solid_normal_t sum = {{0, 0, 0}};
    const solid_vertex_t *at = &s->vertex[c[0]];
    if (f->n == 4) /* of its diagonals */
        return solid_cross(solid_sub(&s->vertex[c[2]], at), solid_sub(&s->vertex[c[3]], &s->vertex[c[1]]));
    for (int32_t k = 1; k + 1 < f->n; k++) {
        solid_normal_t n = solid_cross(solid_sub(&s->vertex[c[k]], at), solid_sub(&s->vertex[c[k + 1]], at));
        for (int i = 0; i < 3; i++) {
            sum.n[i] += n.n[i];
            /* A simple polygon stays inside of its box: below 2^58. */
            if (f->n > SURE_CORNERS && solid_abs(sum.n[i]) > (uint64_t)1 << 60) return (solid_normal_t){{0, 0, 0}};
        }
    }
    return sum;
}

wide_t solid_slack(const solid_normal_t *n) {
    wide_u_t p = wide_mul_u64(solid_abs(n->n[0]) + solid_abs(n->n[1]) + solid_abs(n->n[2]), SOLID_FLAT);
    return (wide_t){(int64_t)p.hi, p.lo};
}

static bool is_within(wide_t v, wide_t slack) {
    return wide_cmp(v, slack) <= 0 && wide_cmp(v, wide_neg(slack)) >= 0;
}

static bool agrees(const solid_normal_t *a, const solid_normal_t *b) {
    return wide_sign(wide_dot3_s64(a->n, b->n)) >= 0;
}

/* Do all corners of a face lie in a plane? */
static bool is_in_plane(const solid_t *s, int32_t face, const solid_normal_t *normal, const solid_vertex_t *at) {
    const solid_face_t *f = &s->face[face];
    const wide_t slack = solid_slack(normal);
    for (int32_t k = 0; k < f->n; k++)
        if (!is_within(solid_dot(normal, solid_sub(&s->vertex[s->corner[f->corner + k]], at)), slack)) return false;
    return true;
}

static const solid_vertex_t *first_of(const solid_t *s, int32_t face) {
    return &s->vertex[s->corner[s->face[face].corner]];
}

bool solid_face_is_flat(const solid_t *s, int32_t face, const solid_normal_t *normal) {
    return is_in_plane(s, face, normal, first_of(s, face));
}

bool solid_face_lies_in(const solid_t *s, int32_t face, int32_t of) {
    const solid_normal_t normal = solid_face_normal(s, of);
    return is_in_plane(s, face, &normal, first_of(s, of));
}

/* A quadrilateral, whose normal is the product of its diagonals: its corners are off its plane by turns as much as the
 * second is. Opposite turns add up to the normal. */
static bool is_convex_cell(const solid_t *s, const int32_t *c, const solid_normal_t *normal, wide_t slack) {
    const solid_delta_t side[3] = {solid_sub(&s->vertex[c[1]], &s->vertex[c[0]]),
                                   solid_sub(&s->vertex[c[2]], &s->vertex[c[1]]),
                                   solid_sub(&s->vertex[c[3]], &s->vertex[c[2]])};
    if (!is_within(solid_dot(normal, side[0]), slack)) return false;
    const wide_t whole = wide_dot3_s64(normal->n, normal->n);
    for (int k = 0; k < 2; k++) {
        const solid_normal_t turn = solid_cross(side[k], side[k + 1]);
        const wide_t part = wide_dot3_s64(normal->n, turn.n);
        if (wide_sign(part) < 0 || wide_cmp(part, whole) > 0) return false;
    }
    return true;
}

bool solid_face_is_convex(const solid_t *s, int32_t face, const solid_normal_t *normal) {
    const solid_face_t *f = &s->face[face];
    const int32_t *c = s->corner + f->corner;
    if (normal->n[0] == 0 && normal->n[1] == 0 && normal->n[2] == 0) return false;
    if (f->n == 3) return true;
    const wide_t slack = solid_slack(normal);
    const solid_vertex_t *at = &s->vertex[c[0]];
    if (f->n == 4) return is_convex_cell(s, c, normal, slack);
    for (int32_t k = 0; k < f->n; k++) {
        const solid_vertex_t *p = &s->vertex[c[k]], *q = &s->vertex[c[k + 1 < f->n ? k + 1 : 0]],
                             *r = &s->vertex[c[k + 2 < f->n ? k + 2 : k + 2 - f->n]];
        if (!is_within(solid_dot(normal, solid_sub(p, at)), slack)) return false;
        solid_normal_t turn = solid_cross(solid_sub(q, p), solid_sub(r, q));
        if (!agrees(normal, &turn)) return false;
        solid_normal_t fan = solid_cross(solid_sub(p, at), solid_sub(q, at)); /* a star turns one way too, but not so */
        if (!agrees(normal, &fan)) return false;
    }
    return true;
}

void solid_shorten(solid_normal_t *n) {
    uint64_t most = solid_abs(n->n[0]) | solid_abs(n->n[1]) | solid_abs(n->n[2]);
    int shift = most ? 30 - (64 - ints_clz64(most)) : 0;
    for (int k = 0; k < 3; k++) n->n[k] = shift < 0 ? n->n[k] >> -shift : n->n[k] * ((int64_t)1 << shift);
}

static int64_t product(const solid_normal_t *a, const solid_normal_t *b) {
    return a->n[0] * b->n[0] + a->n[1] * b->n[1] + a->n[2] * b->n[2];
}

static bool is_across(const solid_t *s, const solid_edge_t *e) {
    const solid_vertex_t *a = &s->vertex[e->v[0]], *b = &s->vertex[e->v[1]];
    return e->face[0] >= 0 && s->object[s->face[e->face[0]].object].smooth_q30 == MESH_GRID && a->at[0] != b->at[0] &&
           a->at[1] != b->at[1];
}

bool solid_is_smooth(const solid_t *s, const solid_edge_t *e) {
    if (e->face[0] < 0 || e->face[1] < 0) return false;
    const int32_t least_q30 = s->object[s->face[e->face[0]].object].smooth_q30;
    if (!least_q30) return false;
    if (least_q30 == MESH_GRID) return is_across(s, e);
    solid_normal_t a = solid_face_normal(s, e->face[0]), b = solid_face_normal(s, e->face[1]);
    solid_shorten(&a);
    solid_shorten(&b);
    int64_t lengths = (int64_t)ints_sqrt_u64((uint64_t)product(&a, &a)) * ints_sqrt_u64((uint64_t)product(&b, &b));
    int64_t dot = product(&a, &b);
    return dot > 0 && dot >> 30 > (lengths >> 30) * least_q30 >> 30;
}
