/* shadow.c - a segment against a shadow: a clip by planes, in space.
 *
 * Bits: n . p of a front plane 2^87; of a plane through the eye and two vertices, the product of two differences 2^57
 * times e - p w, 2^110. All signs are exact. */
#include "hidden/shadow_sides.h"
#include "num/ints.h"
#include "view/solid_side.h"

/* Parts of the line left and right of which it is not hidden. */
typedef struct clip {
    int64_t from, to;
} clip_t;

static int bits_of(wide_t a) { /* a >= 0 */
    return a.hi ? 128 - ints_clz64((uint64_t)a.hi) : a.lo ? 64 - ints_clz64(a.lo) : 0;
}

/* INK_ONE a / (a + b) for a, b >= 0 that are not both 0. 33 bits of each are kept: off by less than 0.8 units, and one
 * division of 64 bits. */
static int64_t fraction(wide_t a, wide_t b) {
    wide_t sum = wide_add(a, b);
    int shift = bits_of(sum) - 33;
    if (shift > 0) {
        a = wide_sar(a, shift);
        sum = wide_sar(sum, shift);
    }
    return (int64_t)(((a.lo << 30) + (sum.lo >> 1)) / sum.lo);
}

/* Takes off what is not below zero, for values a and b at the line's ends. */
static bool clip_by(clip_t *c, wide_t a, wide_t b, int sign_a, int sign_b) {
    if (sign_a > 0) {
        int64_t t = fraction(a, wide_neg(b));
        if (t > c->from) c->from = t;
    } else if (sign_b > 0) {
        int64_t t = fraction(wide_neg(a), b);
        if (t < c->to) c->to = t;
    }
    return c->from < c->to;
}

/* The value of a plane at an end of the line, but for what it is off (shadow.h). */
static inline int64_t plane_near(const shadow_plane_t *p, const solid_vertex_t *v) {
    return wide_mul_s32(p->n[0], v->at[0]) + wide_mul_s32(p->n[1], v->at[1]) + wide_mul_s32(p->n[2], v->at[2]) - p->c;
}

static inline int64_t plane_slack(const shadow_plane_t *p) {
    return (int64_t)(solid_abs(p->n[0]) + solid_abs(p->n[1]) + solid_abs(p->n[2])) * SOLID_FLAT;
}

/* Where it is not sure. Returns whether a part is behind. */
static bool clip_by_plane(const shadows_t *s, const shadow_t *shadow, int32_t face, const solid_vertex_t *const end[2],
                          clip_t *c) {
    const solid_vertex_t *on;
    solid_normal_t n;
    if (face >= 0) {
        n = solid_face_normal(s->map->solid, face);
        on = shadow_corner(s, face, 0);
        for (int k = 0; k < 3 && shadow_side_of(s, face) == SHADOW_AWAY; k++) n.n[k] = -n.n[k];
    } else {
        const solid_vertex_t *vertex = s->map->solid->vertex;
        const shadow_edge_t *e = &s->outline[shadow->outline];
        on = &vertex[e[0].p];
        n = solid_cross(solid_sub(&vertex[e[0].q], on), solid_sub(&vertex[e[1].q], on));
    }
    const wide_t slack = solid_slack(&n), a = wide_add(solid_dot(&n, solid_sub(end[0], on)), slack),
                 b = wide_add(solid_dot(&n, solid_sub(end[1], on)), slack), twice = wide_add(slack, slack);
    const int sign_a = wide_sign(a), sign_b = wide_sign(b);
    if (sign_a >= 0 && sign_b >= 0) return false;
    return (wide_cmp(a, twice) <= 0 && wide_cmp(b, twice) <= 0) || clip_by(c, a, b, sign_a, sign_b);
}

/* Touching is not hidden, and a line that ends in touching does not cross. */
static bool clip_by_planes(const shadows_t *s, const shadow_t *shadow, const shadow_line_t *line, clip_t *c) {
    const solid_vertex_t *vertex = s->map->solid->vertex, *const end[2] = {&vertex[line->v[0]], &vertex[line->v[1]]};
    const shadow_plane_t *p = &s->plane[shadow->plane];
    for (int32_t k = 0; k < shadow->planes; k++, p++) {
        const int64_t a = plane_near(p, end[0]), b = plane_near(p, end[1]), least = a < b ? a : b, most = a < b ? b : a;
        if (least >= SHADOW_NEAR) return false;
        if (least <= -SHADOW_NEAR && most <= 2 * plane_slack(p) - SHADOW_NEAR) continue;
        if (!clip_by_plane(s, shadow, p->face, end, c)) return false;
    }
    return true;
}

static inline int64_t span(int32_t a, int32_t b, int32_t lo, int32_t hi) {
    int64_t from = a < b ? a : b, to = a < b ? b : a;
    return (to > hi ? to : hi) - (from < lo ? from : lo);
}

/* The outline's edges from the page: is the line surely outside of one? Bit k of *open: not surely inside of edge k
 * (the last bit stands for all from there on). */
static bool is_outside(const shadows_t *s, const shadow_t *shadow, const shadow_line_t *line, uint64_t *open) {
    const solid_place_t *place = s->map->place, from = line->end[0], to = line->end[1];
    const shadow_edge_t *e = &s->outline[shadow->outline];
    const int64_t dx = to.x - from.x, dy = to.y - from.y; /* of places: 31 bits */
    /* a difference of two rounded places is off by a lat and a hair; no difference is larger than the box of both */
    const int64_t margin =
        3 * (span(from.x, to.x, shadow->x0, shadow->x1) + span(from.y, to.y, shadow->y0, shadow->y1)) + 8;
    uint64_t bits = 0;
    for (int32_t k = 0; k < shadow->outlines; k++, e++) {
        const solid_place_t *p = &place[e->p], *q = &place[e->q];
        const int64_t ux = q->x - p->x, uy = q->y - p->y;
        const int64_t a = ux * (from.y - p->y) - uy * (from.x - p->x), b = a + ux * dy - uy * dx;
        const int64_t least = a < b ? a : b;
        if (least > margin) continue;
        if ((a < b ? b : a) < -margin) return true;
        bits |= (uint64_t)1 << (k < 63 ? k : 63);
    }
    *open = bits;
    return false;
}

/* In the plane itself is inside: behind the outline, or behind the seam of two faces. */
static bool clip_by_outline(const shadows_t *s, const shadow_edge_t *e, const shadow_line_t *line, clip_t *c) {
    const solid_vertex_t *vertex = s->map->solid->vertex, *p = &vertex[e->p];
    const solid_delta_t u = solid_sub(&vertex[e->q], p);
    wide_t at[2]; /* (u x (eye - p)) . d = (d x u) . (eye - p) */
    for (int i = 0; i < 2; i++) {
        const solid_normal_t n = solid_cross(solid_sub(&vertex[line->v[i]], p), u);
        at[i] = solid_eye_dot(s->map, &n, p);
    }
    int sign_a = wide_sign(at[0]), sign_b = wide_sign(at[1]);
    if (sign_a == 0 && sign_b == 0) return true;
    if (sign_a >= 0 && sign_b >= 0) return false;
    return clip_by(c, at[0], at[1], sign_a, sign_b);
}

bool shadow_hides(const shadows_t *s, const shadow_t *shadow, const shadow_line_t *line, int32_t *from, int32_t *to) {
    clip_t c = {0, INK_ONE};
    uint64_t open = ~(uint64_t)0;
    const bool whole = shadow->planes > 1; /* a body fills its box, and half of what meets that is not behind it */
    if (whole && !clip_by_planes(s, shadow, line, &c)) return false;
    if (!shadow->exact && !line->exact && is_outside(s, shadow, line, &open)) return false;
    if (!whole && !clip_by_planes(s, shadow, line, &c)) return false;
    for (int32_t k = 0; k < shadow->outlines && open; k++) {
        if (!(open >> (k < 63 ? k : 63) & 1)) continue;
        if (!clip_by_outline(s, &s->outline[shadow->outline + k], line, &c)) return false;
    }
    *from = (int32_t)c.from;
    *to = (int32_t)c.to;
    return true;
}
