/* One edge against every cell between it and the eye; surface_ref.h has the argument.
 *
 * Corners of a cell are counter-clockwise from the south-west one, side k runs from corner k to k + 1:
 *
 *        C3 --2-- C2         side k is near if the eye is outside of it, far if it is inside; the ground ray to
 *        3         1         P crosses a near side k when P is left of Ck's ray and right of Ck+1's with the
 *        C0 --0-- C1         signs below, a far side the other way round. */
#include "tests/oracle/surface_ref.h"

#include "tests/oracle/surface_visit.h"

enum { SOUTH, EAST, NORTH, WEST };
enum nadir { NADIR_BELOW, NADIR_ABOVE, NADIR_UNSURE };

exact_point_t surface_ref_node(const surface_ref_t *r, int i, int j) {
    return (exact_point_t){r->x[i], r->y[j], r->z[j * r->nx + i]};
}

static bool defined(const surface_ref_t *r, int i, int j) {
    return !r->hole || !r->hole[j * r->nx + i];
}

bool surface_ref_cell_exists(const surface_ref_t *r, int ci, int cj) {
    return ci >= 0 && cj >= 0 && ci + 1 < r->nx && cj + 1 < r->ny && defined(r, ci, cj) && defined(r, ci + 1, cj) &&
           defined(r, ci, cj + 1) && defined(r, ci + 1, cj + 1);
}

bool surface_ref_edge_exists(const surface_ref_t *r, int family, int line, int k) {
    return family == REF_ROW ? surface_ref_cell_exists(r, k, line) || surface_ref_cell_exists(r, k, line - 1)
                             : surface_ref_cell_exists(r, line, k) || surface_ref_cell_exists(r, line - 1, k);
}

void surface_ref_edge_ends(const surface_ref_t *r, int family, int line, int k, exact_point_t end[2]) {
    for (int s = 0; s < 2; s++)
        end[s] = family == REF_ROW ? surface_ref_node(r, k + s, line) : surface_ref_node(r, line, k + s);
}

/* Sign of the eye's distance to the inside of a side: negative for a near side. */
static int inside(const surface_ref_t *r, int ci, int cj, int side) {
    const exact_eye_t *e = &r->eye;
    double at = side == SOUTH ? r->y[cj] : side == NORTH ? r->y[cj + 1] : side == WEST ? r->x[ci] : r->x[ci + 1];
    double d = side == SOUTH || side == NORTH ? e->y : e->x;
    if (!e->h) at = 0;
    int s = (d > at) - (d < at);
    return side == SOUTH || side == WEST ? s : -s;
}

/* Has P gone past a near side into the cell, and past a far side out of it? The grid's lines part nodes exactly. */
static bool past_near(const query_t *q, int ci, int cj, int side) {
    return side == SOUTH   ? q->jmax > cj
           : side == NORTH ? q->jmin < cj + 1
           : side == WEST  ? q->imax > ci
                           : q->imin < ci + 1;
}
static bool past_far(const query_t *q, int ci, int cj, int side) {
    return side == SOUTH   ? q->jmax <= cj
           : side == NORTH ? q->jmin >= cj + 1
           : side == WEST  ? q->imax <= ci
                           : q->imin >= ci + 1;
}

/* Is the surface below or above the eye in the cell that contains its foot? Asked of both triangulations. */
static enum nadir nadir_of(const surface_ref_t *r, const exact_point_t c[4]) {
    exact_point_t e = {r->eye.x, r->eye.y, r->eye.z};
    long double s =
        exact_left(&c[0], &c[2], &e) <= 0 ? exact_above(&c[0], &c[1], &c[2], &e) : exact_above(&c[0], &c[2], &c[3], &e);
    long double t =
        exact_left(&c[1], &c[3], &e) >= 0 ? exact_above(&c[0], &c[1], &c[3], &e) : exact_above(&c[1], &c[2], &c[3], &e);
    return s > 0 && t > 0 ? NADIR_BELOW : s < 0 && t < 0 ? NADIR_ABOVE : NADIR_UNSURE;
}

/* A cell of another sheet that has the edge, in a vertical plane through the eye, above or below one of its sides: seen
 * from a little to that side it covers from its near chain as far as that side. */
static void side_hides(const query_t *q, const exact_point_t c[4], const long double a[4][2], const int in[4],
                       enum nadir n, spans_t *hidden, spans_t *either) {
    const surface_ref_t *r = q->r;
    double s0 = surface_ref_node(r, q->imin, q->jmin).z, s1 = surface_ref_node(r, q->imax, q->jmax).z;
    long double v0 = (long double)q->p[0].z - s0, v1 = (long double)q->p[1].z - s1;
    bool outside = false;
    for (int k = 0; k < 4; k++) {
        int k1 = (k + 1) & 3;
        span_t both = {0, 1};
        outside |= in[k] < 0;
        if (in[k] >= 0) continue;
        span_keep_positive(&both, -a[k][0], -a[k][1]);
        span_keep_positive(&both, a[k1][0], a[k1][1]);
        if (!(both.a < both.b)) continue;
        long double u0 = exact_plane(&r->eye, &c[k], &c[k1], &q->p[0]);
        long double u1 = exact_plane(&r->eye, &c[k], &c[k1], &q->p[1]);
        for (int s = -1; s <= 1; s += 2) {
            span_t t = both;
            span_keep_positive(&t, s * u0, s * u1);
            span_keep_positive(&t, s * v0, s * v1);
            spans_add(hidden, t.a, t.b);
        }
    }
    if (outside) return;
    span_t t = {0, 1};
    if (n == NADIR_BELOW) span_keep_positive(&t, -v0, -v1);
    if (n == NADIR_ABOVE) span_keep_positive(&t, v0, v1);
    spans_add(n == NADIR_UNSURE ? either : hidden, t.a, t.b);
}

/* Adds what cell (ci, cj) hides of the edge. */
static void cell_hides(const query_t *q, int ci, int cj, enum place place, spans_t *hidden, spans_t *either) {
    const surface_ref_t *r = q->r;
    exact_point_t c[4] = {surface_ref_node(r, ci, cj), surface_ref_node(r, ci + 1, cj),
                          surface_ref_node(r, ci + 1, cj + 1), surface_ref_node(r, ci, cj + 1)};
    long double a[4][2]; /* left of the ray to corner k, at the edge's two ends */
    int left = 0, right = 0;
    for (int k = 0; k < 4; k++) {
        for (int s = 0; s < 2; s++) a[k][s] = exact_side(&r->eye, &c[k], &q->p[s]);
        if (q->lean && a[k][0] == 0 && a[k][1] == 0)
            for (int s = 0; s < 2; s++) a[k][s] = q->lean * exact_ahead(&r->eye, &c[k], &q->p[s]);
        for (int s = 0; s < 2; s++) left += a[k][s] > 0, right += a[k][s] < 0;
    }
    if (!left || !right) return;
    int in[4], outside = 0;
    for (int k = 0; k < 4; k++) in[k] = inside(r, ci, cj, k), outside += in[k] < 0;
    bool own = place == OWN;
    if (place == OVER && q->lean)
        side_hides(q, c, (const long double(*)[2])a, in, outside ? NADIR_UNSURE : nadir_of(r, c), hidden, either);
    for (int m = 0; m < 4; m++) {
        int m1 = (m + 1) & 3;
        if (in[m] <= 0 || !past_far(q, ci, cj, m)) continue;
        span_t far = {0, 1};
        span_keep_positive(&far, a[m][0], a[m][1]);
        span_keep_positive(&far, -a[m1][0], -a[m1][1]);
        if (!(far.a < far.b)) continue;
        long double v0 = exact_plane(&r->eye, &c[m], &c[m1], &q->p[0]);
        long double v1 = exact_plane(&r->eye, &c[m], &c[m1], &q->p[1]);
        if (!outside) { /* the eye's foot is in this cell: it covers all from straight below (above) to its far side */
            enum nadir n = nadir_of(r, c);
            if (v0 == 0 && v1 == 0 && !own) n = NADIR_UNSURE;
            if (n == NADIR_BELOW) span_keep_positive(&far, -v0, -v1);
            if (n == NADIR_ABOVE) span_keep_positive(&far, v0, v1);
            spans_add(n == NADIR_UNSURE ? either : hidden, far.a, far.b);
            continue;
        }
        for (int k = 0; k < 4; k++) {
            int k1 = (k + 1) & 3;
            if (in[k] >= 0 || !past_near(q, ci, cj, k)) continue;
            span_t both = far;
            span_keep_positive(&both, -a[k][0], -a[k][1]);
            span_keep_positive(&both, a[k1][0], a[k1][1]);
            if (!(both.a < both.b)) continue;
            long double u0 = exact_plane(&r->eye, &c[k], &c[k1], &q->p[0]);
            long double u1 = exact_plane(&r->eye, &c[k], &c[k1], &q->p[1]);
            if ((u0 == 0 && u1 == 0) || (v0 == 0 && v1 == 0 && !own)) spans_add(either, both.a, both.b);
            for (int s = -1; s <= 1; s += 2) { /* above the one and below the other, and the reverse */
                span_t t = both;
                span_keep_positive(&t, s * u0, s * u1);
                span_keep_positive(&t, s * v0, s * v1);
                spans_add(hidden, t.a, t.b);
            }
        }
    }
}

typedef struct cover {
    bool skip_own;
    spans_t *hidden, *either;
} cover_t;

static void visit_cover(const query_t *q, int ci, int cj, enum place place, void *ctx) {
    const cover_t *c = ctx;
    if (place == OWN && c->skip_own) return;
    cell_hides(q, ci, cj, place, c->hidden, c->either);
}

static void all_cells(const query_t *q, bool skip_own, spans_t *hidden, spans_t *either) {
    cover_t c = {skip_own, hidden, either};
    surface_visit(q, visit_cover, &c);
    spans_tidy(hidden);
    spans_tidy(either);
}

static query_t query_of(const surface_ref_t *r, int family, int line, int k) {
    query_t q = {.r = r};
    surface_ref_edge_ends(r, family, line, k, q.p);
    q.imin = family == REF_ROW ? k : line;
    q.imax = family == REF_ROW ? k + 1 : line;
    q.jmin = family == REF_ROW ? line : k;
    q.jmax = family == REF_ROW ? line : k + 1;
    return q;
}

/* For an edge in a vertical plane through the eye: both when either side hides it; else the doubt. */
static void two_sided(query_t *q, bool own, spans_t *hidden, spans_t *either) {
    spans_t side[2] = {{0}, {0}}, both = {0}, doubt = {0};
    for (int s = 0; s < 2; s++) {
        q->lean = s ? -1 : 1;
        all_cells(q, own, &side[s], either);
    }
    spans_intersect(&side[0], &side[1], &both);
    spans_copy(&both, hidden);
    for (int s = 0; s < 2; s++) {
        spans_subtract(&side[s], &both, &doubt);
        for (size_t i = 0; i < doubt.n; i++) spans_add(either, doubt.s[i].a, doubt.s[i].b);
    }
    spans_tidy(either);
    spans_free(&side[0]);
    spans_free(&side[1]);
    spans_free(&both);
    spans_free(&doubt);
}

static void look(query_t *q, bool own, spans_t *hidden, spans_t *either) {
    spans_clear(hidden);
    spans_clear(either);
    if (exact_side(&q->r->eye, &q->p[0], &q->p[1]) == 0)
        two_sided(q, own, hidden, either);
    else
        all_cells(q, own, hidden, either);
}

void surface_ref_edge(const surface_ref_t *r, int family, int line, int k, spans_t *hidden, spans_t *either) {
    query_t q = query_of(r, family, line, k);
    look(&q, false, hidden, either);
}

void surface_ref_moved(const surface_ref_t *r, int family, int line, int k, const exact_point_t moved[2],
                       spans_t *hidden) {
    query_t q = query_of(r, family, line, k);
    spans_t either = {0};
    q.p[0] = moved[0];
    q.p[1] = moved[1];
    look(&q, true, hidden, &either);
    spans_free(&either);
}

typedef struct doubling {
    const exact_point_t *moved, *other;
    spans_t *out;
} doubling_t;

/* Adds where a side of the cell, in front of the edge, lies between the edge's two moved copies. */
static void visit_doubled(const query_t *q, int ci, int cj, enum place place, void *ctx) {
    const surface_ref_t *r = q->r;
    const doubling_t *d = ctx;
    int ni[5] = {ci, ci + 1, ci + 1, ci, ci}, nj[5] = {cj, cj, cj + 1, cj + 1, cj};
    for (int k = 0; k < 4; k++) {
        int in = inside(r, ci, cj, k);
        bool near = in < 0 && past_near(q, ci, cj, k), far = in > 0 && past_far(q, ci, cj, k) && place != OWN;
        if (!near && !far) continue;
        exact_point_t c0 = surface_ref_node(r, ni[k], nj[k]), c1 = surface_ref_node(r, ni[k + 1], nj[k + 1]);
        long double sign = near ? 1 : -1;
        span_t at = {0, 1};
        span_keep_positive(&at, -sign * exact_side(&r->eye, &c0, &q->p[0]), -sign * exact_side(&r->eye, &c0, &q->p[1]));
        span_keep_positive(&at, sign * exact_side(&r->eye, &c1, &q->p[0]), sign * exact_side(&r->eye, &c1, &q->p[1]));
        if (!(at.a < at.b)) continue;
        long double u[2], v[2];
        for (int s = 0; s < 2; s++) {
            u[s] = exact_plane(&r->eye, &c0, &c1, &d->moved[s]);
            v[s] = exact_plane(&r->eye, &c0, &c1, &d->other[s]);
        }
        for (int s = -1; s <= 1; s += 2) {
            span_t t = at;
            span_keep_positive(&t, s * u[0], s * u[1]);
            span_keep_positive(&t, -s * v[0], -s * v[1]);
            spans_add(d->out, t.a, t.b);
        }
    }
}

void surface_ref_doubled(const surface_ref_t *r, int family, int line, int k, const exact_point_t moved[2],
                         const exact_point_t other[2], spans_t *out) {
    query_t q = query_of(r, family, line, k);
    doubling_t d = {moved, other, out};
    spans_clear(out);
    surface_visit(&q, visit_doubled, &d);
    spans_tidy(out);
}
