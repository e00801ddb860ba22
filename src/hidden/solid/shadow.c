/* shadow.c - a segment against a shadow: a clip by planes, in space.
 *
 * Bits: n . p of a front plane 2^87; of a plane through the eye and two vertices, the product of two differences 2^57
 * times e - p w, 2^110. All signs are exact. */
#include "hidden/solid/shadow_sides.h"
#include "num/ints.h"
#include "view/solid_side.h"

#define OPEN_MOST 8
#define DEPTH_OFF 4 /* depths are rounded */
#define STEEP_BITS 10

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

/* Where it is not sure; touches: neither end is in front of the plane but for touching it. Returns whether a part is
 * behind. */
static bool clip_by_plane(const shadows_t *s, const shadow_t *shadow, int32_t face, const solid_vertex_t *const end[2],
                          bool touches, clip_t *c) {
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
    const wide_t slack = solid_slack(&n);
    wide_t at[2];
    for (int i = 0; i < 2; i++) at[i] = wide_add(solid_dot(&n, solid_sub(end[i], on)), slack);
    const int sign_a = wide_sign(at[0]), sign_b = wide_sign(at[1]);
    if (sign_a >= 0 && sign_b >= 0) return false;
    return touches || clip_by(c, at[0], at[1], sign_a, sign_b);
}

/* Does a line that is in front of a plane by no more than it may be off, and reaches -least below it, go through it
 * steeply: is it in front only for a crumb, 2 SOLID_FLAT << STEEP_BITS units long? One as flat may run along a face
 * that is much smaller than itself, and whose plane is off so far from it by as much as the line is behind. */
static inline bool is_steep(const solid_vertex_t *const end[2], int64_t least, int64_t size) {
    const solid_delta_t d = solid_sub(end[1], end[0]);
    return -least >= (int64_t)((solid_abs(d.d[0]) + solid_abs(d.d[1]) + solid_abs(d.d[2])) >> STEEP_BITS) * size;
}

/* Touching is not hidden, and a line that ends in touching does not cross. */
static inline bool clip_by_planes(const shadows_t *s, const shadow_t *shadow, const shadow_line_t *line, clip_t *c) {
    const solid_vertex_t *vertex = s->map->solid->vertex, *const end[2] = {&vertex[line->v[0]], &vertex[line->v[1]]};
    const shadow_plane_t *p = &s->plane[shadow->plane];
    for (const shadow_plane_t *last = p + shadow->planes; p < last; p++) {
        const int64_t a = shadow_plane_dot(p->n, end[0]->at) - p->c, b = shadow_plane_dot(p->n, end[1]->at) - p->c,
                      most = a < b ? b : a, least = a < b ? a : b;
        if (most <= -SHADOW_NEAR) continue;
        if (least >= SHADOW_NEAR) return false;
        const int64_t size = shadow_plane_size(p->n);
        const bool touches = most <= size * (2 * SOLID_FLAT) && is_steep(end, least, size);
        if (touches && least <= -SHADOW_NEAR) continue;
        if (!clip_by_plane(s, shadow, p->face, end, touches, c)) return false;
    }
    return true;
}

static inline int64_t cross(int32_t ax, int32_t ay, int32_t bx, int32_t by) {
    return wide_mul_s32(ax, by) - wide_mul_s32(ay, bx);
}

/* A corner of the outline's picture, as the line sees it from its first end. */
typedef struct corner {
    int32_t x, y;
    int32_t side;  /* of the line: -1 and 1 for sure, 0 if it may be on it */
    int64_t along; /* corner x line */
} corner_t;

/* A line's picture as it is held against those of outlines. */
typedef struct picture {
    const solid_place_t *from;
    int32_t dx, dy;
    int64_t margin; /* by which a product may be off */
} picture_t;

static inline corner_t corner_of(const picture_t *l, const solid_place_t *p) {
    const int32_t x = p->x - l->from->x, y = p->y - l->from->y;
    const int64_t along = cross(x, y, l->dx, l->dy);
    return (corner_t){x, y, (along > l->margin) - (along < -l->margin), along};
}

/* Edges of an outline that the line is not surely inside of: their numbers, or all if there are more. */
typedef struct open_edges {
    uint8_t n, k[OPEN_MOST];
} open_edges_t;

/* The outline's edges from the page: is the line surely outside of one? An end's distance from an edge p q is
 * (p - end) x (q - end), which grows by q x line - p x line to the other end. Only an edge whose ends the line parts
 * can be where it enters or leaves a convex outline; mostly one begins where the one before ends, and half of it is
 * known. */
static bool is_outside(const shadows_t *s, const shadow_t *shadow, const shadow_line_t *line, open_edges_t *open) {
    const solid_place_t *place = s->map->place, *from = &line->end[0];
    const shadow_edge_t *e = &s->outline[shadow->outline];
    picture_t l = {from, line->end[1].x - from->x, line->end[1].y - from->y, 64}; /* 31 bits */
    /* a difference of two rounded places is off by a lat and a hair; none is larger than both boxes, which meet */
    l.margin += 3 * ((int64_t)(solid_abs(l.dx) + solid_abs(l.dy)) + (int64_t)shadow->x1 - shadow->x0 +
                     (int64_t)shadow->y1 - shadow->y0);
    int32_t known = -1, sides = 0, corners = shadow->outlines;
    corner_t p, q = {0, 0, 0, 0};
    open->n = 0;
    for (int32_t k = 0; k < shadow->outlines; k++, e++) {
        p = q;
        if (e->p != known) {
            p = corner_of(&l, &place[e->p]);
            sides += p.side;
            corners++;
        }
        known = e->q;
        q = corner_of(&l, &place[known]);
        sides += q.side;
        if (p.side * q.side > 0) continue;
        const int64_t a = cross(p.x, p.y, q.x, q.y), b = a + q.along - p.along;
        if ((a < b ? a : b) > l.margin) continue;
        if ((a < b ? b : a) < -l.margin) return true;
        if (open->n < OPEN_MOST && k <= UINT8_MAX)
            open->k[open->n++] = (uint8_t)k;
        else
            open->n = UINT8_MAX;
    }
    return sides == corners || sides == -corners;
}

/* In the plane itself is inside: behind the outline, or behind the seam of two faces. */
static bool clip_by_outline(const shadows_t *s, const shadow_edge_t *e, const shadow_line_t *line, clip_t *c) {
    const solid_vertex_t *vertex = s->map->solid->vertex, *p = &vertex[e->p];
    const solid_delta_t u = solid_sub(&vertex[e->q], p);
    int64_t v[3];
    wide_t at[2]; /* (u x v) . d = (d x u) . v */
    solid_to_eye(s->map, p, v);
    for (int i = 0; i < 2; i++) at[i] = wide_dot3_s64(solid_cross(solid_sub(&vertex[line->v[i]], p), u).n, v);
    int sign_a = wide_sign(at[0]), sign_b = wide_sign(at[1]);
    if (sign_a == 0 && sign_b == 0) return true;
    if (sign_a >= 0 && sign_b >= 0) return false;
    return clip_by(c, at[0], at[1], sign_a, sign_b);
}

/* Is all of the line farther away than all that is seen of the object? */
static inline bool is_behind(const shadow_t *shadow, const shadow_line_t *line) {
    const int32_t a = line->end[0].z, b = line->end[1].z;
    return (a < b ? a : b) - DEPTH_OFF > shadow->far;
}

bool shadow_hides(const shadows_t *s, const shadow_t *shadow, const shadow_line_t *line, int32_t *from, int32_t *to) {
    clip_t c = {0, INK_ONE};
    open_edges_t open = {.n = UINT8_MAX};
    const bool exact = shadow->exact || line->exact, behind = !exact && is_behind(shadow, line);
    const bool whole = shadow->planes > 1; /* a body fills its box, and half of what meets that is not behind it */
    if (!behind && whole && !clip_by_planes(s, shadow, line, &c)) return false;
    if (!exact && is_outside(s, shadow, line, &open)) return false;
    if (!behind && !whole && !clip_by_planes(s, shadow, line, &c)) return false;
    const shadow_edge_t *e = &s->outline[shadow->outline];
    const int32_t n = open.n == UINT8_MAX ? shadow->outlines : open.n;
    for (int32_t k = 0; k < n; k++)
        if (!clip_by_outline(s, &e[open.n == UINT8_MAX ? k : open.k[k]], line, &c)) return false;
    *from = (int32_t)c.from;
    *to = (int32_t)c.to;
    return true;
}
