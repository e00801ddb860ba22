/* seams_cross.c - see seams_cross.h. */
#include "hidden/solid/seams_cross.h"

#include "num/ints.h"

#define FINE_BITS 8                 /* of a lattice unit: how ends of seams are compared */
#define LEAST_FINE (4 << FINE_BITS) /* what is shorter is none */

/* Place on a seam's line, in 2^-FINE_BITS of a lattice unit. */
typedef struct fine {
    int64_t at[3];
} fine_t;

seam_plane_t seam_plane(const solid_t *s, const seam_piece_t *p) {
    const solid_vertex_t *v = s->vertex;
    seam_plane_t plane = {.on = &v[seam_corner(s, p, 0)]};
    plane.n = p->v[0] < 0 ? solid_face_normal(s, p->face)
                          : solid_cross(solid_sub(&v[p->v[1]], plane.on), solid_sub(&v[p->v[2]], plane.on));
    plane.slack = solid_slack(&plane.n);
    return plane;
}

static wide_t height(const solid_t *s, const seam_plane_t *plane, int32_t v) {
    return solid_dot(&plane->n, solid_sub(&s->vertex[v], plane->on));
}

/* Where the edge from v to w, which are on either side, goes through a plane: the same place whichever way it runs. */
static fine_t pierce(const solid_t *s, int32_t v, int32_t w, wide_t dv, wide_t dw) {
    if (v > w) {
        const int32_t u = v;
        v = w;
        w = u;
        const wide_t d = dv;
        dv = dw;
        dw = d;
    }
    if (wide_sign(dv) < 0) dv = wide_neg(dv);
    if (wide_sign(dw) < 0) dw = wide_neg(dw);
    wide_t sum = wide_add(dv, dw);
    const int shift = sum.hi != 0 ? 66 - ints_clz64((uint64_t)sum.hi) : sum.lo >> 62 != 0 ? 2 : 0;
    const int64_t part = (int64_t)wide_sar(dv, shift).lo, all = (int64_t)wide_sar(sum, shift).lo;
    const solid_vertex_t *a = &s->vertex[v], *b = &s->vertex[w];
    fine_t p;
    for (int k = 0; k < 3; k++) {
        const int64_t from = (int64_t)a->at[k] * (1 << FINE_BITS),
                      way = (int64_t)(b->at[k] - a->at[k]) * (1 << FINE_BITS);
        p.at[k] = from + ints_muldiv_round(way, part, all);
    }
    return p;
}

/* The two places where a piece's border goes through a plane; false if the piece does not reach beyond it on both
 * sides. */
static bool pierce_twice(const solid_t *s, const seam_piece_t *p, const seam_plane_t *plane, fine_t at[2]) {
    const int32_t n = seam_corners(s, p);
    int places = 0;
    bool above = false, below = false;
    int32_t v = seam_corner(s, p, n - 1);
    wide_t d = height(s, plane, v);
    for (int32_t k = 0; k < n; k++) {
        const int32_t w = seam_corner(s, p, k);
        const wide_t e = height(s, plane, w);
        above |= wide_cmp(e, plane->slack) > 0;
        below |= wide_cmp(e, wide_neg(plane->slack)) < 0;
        if ((wide_sign(d) < 0) != (wide_sign(e) < 0)) {
            if (places == 2) return false;
            at[places++] = pierce(s, v, w, d, e);
        }
        v = w;
        d = e;
    }
    return above && below && places == 2;
}

static int32_t to_lattice(int64_t fine) {
    return (int32_t)((fine + (1 << (FINE_BITS - 1))) >> FINE_BITS);
}

bool seam_cross(const solid_t *s, const seam_piece_t *a, const seam_plane_t *pa, const seam_piece_t *b, seam_t *out) {
    const seam_plane_t pb = seam_plane(s, b);
    fine_t p[2], q[2];
    if (!pierce_twice(s, a, &pb, p) || !pierce_twice(s, b, pa, q)) return false;
    int axis = 0;
    int64_t most = -1;
    for (int k = 0; k < 3; k++) {
        const int64_t way = (int64_t)(ints_abs64(p[1].at[k] - p[0].at[k]) + ints_abs64(q[1].at[k] - q[0].at[k]));
        if (way > most) most = way, axis = k;
    }
    const int pl = p[1].at[axis] < p[0].at[axis], ql = q[1].at[axis] < q[0].at[axis];
    const fine_t from = p[pl].at[axis] > q[ql].at[axis] ? p[pl] : q[ql];
    const fine_t to = p[!pl].at[axis] < q[!ql].at[axis] ? p[!pl] : q[!ql];
    if (to.at[axis] - from.at[axis] < LEAST_FINE) return false;
    for (int k = 0; k < 3; k++) {
        out->end[0].at[k] = to_lattice(from.at[k]);
        out->end[1].at[k] = to_lattice(to.at[k]);
    }
    return true;
}
