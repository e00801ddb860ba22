/* solid_ref.c - see solid_ref.h. */
#include "tests/oracle/solid_ref.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct vec {
    long double x, y, z;
} vec_t;

static vec_t sub(exact_point_t a, exact_point_t b) {
    return (vec_t){(long double)a.x - b.x, (long double)a.y - b.y, (long double)a.z - b.z};
}
static vec_t cross(vec_t a, vec_t b) {
    return (vec_t){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
static long double dot(vec_t a, vec_t b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
static long double norm(vec_t a) {
    return sqrtl(dot(a, a));
}

static void *grow(void *p, int n, size_t size) {
    if (n & (n - 1)) return p; /* at powers of two */
    p = realloc(p, (n ? 2 * (size_t)n : 1) * size);
    if (!p) abort();
    return p;
}

void solid_ref_free(solid_ref_t *r) {
    free(r->vertex);
    free(r->corner);
    free(r->first);
    free(r->line);
    free(r->edge);
    free(r->clear);
    free(r->detail);
    *r = (solid_ref_t){0};
}

int solid_ref_vertex(solid_ref_t *r, double x, double y, double z) {
    r->vertex = grow(r->vertex, r->nv, sizeof *r->vertex);
    r->vertex[r->nv] = (exact_point_t){x, y, z};
    return r->nv++;
}

void solid_ref_face(solid_ref_t *r, const int *v, int n) {
    if (r->nf == 0) {
        r->first = grow(r->first, 0, sizeof *r->first);
        r->first[0] = 0;
    }
    r->first = grow(r->first, r->nf + 1, sizeof *r->first);
    for (int k = 0; k < n; k++) {
        r->corner = grow(r->corner, r->nc, sizeof *r->corner);
        r->corner[r->nc++] = v[k];
    }
    r->first[++r->nf] = r->nc;
}

void solid_ref_line(solid_ref_t *r, int a, int b) {
    r->line = grow(r->line, r->nl, sizeof *r->line);
    r->line[r->nl][0] = a;
    r->line[r->nl++][1] = b;
}

void solid_ref_box(solid_ref_t *r, const int v[8]) {
    static const int side[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (int k = 0; k < 6; k++)
        solid_ref_face(r, (int[]){v[side[k][0]], v[side[k][1]], v[side[k][2]], v[side[k][3]]}, 4);
}

static bool same(const solid_ref_t *r, int a, int b) {
    return a == b || memcmp(&r->vertex[a], &r->vertex[b], sizeof r->vertex[0]) == 0;
}

static void add_edge(solid_ref_t *r, int a, int b) {
    if (same(r, a, b)) return;
    for (int k = 0; k < r->ne; k++)
        if ((same(r, r->edge[k][0], a) && same(r, r->edge[k][1], b)) ||
            (same(r, r->edge[k][0], b) && same(r, r->edge[k][1], a)))
            return;
    r->edge = grow(r->edge, r->ne, sizeof *r->edge);
    r->edge[r->ne][0] = a;
    r->edge[r->ne++][1] = b;
}

/* Is edge k of a face there twice: the cut that joins a hole to its outer contour? That is no line. */
static bool is_cut(const solid_ref_t *r, int f, int k) {
    int n = r->first[f + 1] - r->first[f], count = 0;
    const int *c = r->corner + r->first[f];
    for (int i = 0; i < n; i++) count += same(r, c[i], c[(k + 1) % n]) && same(r, c[(i + 1) % n], c[k]);
    return count > 0;
}

/* Corners that differ from the one before. */
static int distinct(const solid_ref_t *r, int f) {
    int n = r->first[f + 1] - r->first[f], count = 0;
    const int *c = r->corner + r->first[f];
    for (int k = 0; k < n; k++) count += !same(r, c[k], c[(k + 1) % n]);
    return count;
}

void solid_ref_finish(solid_ref_t *r) {
    exact_point_t lo = r->vertex[0], hi = lo;
    for (int v = 0; v < r->nv; v++) {
        lo = (exact_point_t){fmin(lo.x, r->vertex[v].x), fmin(lo.y, r->vertex[v].y), fmin(lo.z, r->vertex[v].z)};
        hi = (exact_point_t){fmax(hi.x, r->vertex[v].x), fmax(hi.y, r->vertex[v].y), fmax(hi.z, r->vertex[v].z)};
    }
    r->size = fmax(hi.x - lo.x, fmax(hi.y - lo.y, hi.z - lo.z));
    for (int f = 0; f < r->nf; f++) {
        int n = r->first[f + 1] - r->first[f];
        const int *c = r->corner + r->first[f];
        for (int k = 0; k < n && distinct(r, f) >= 3; k++)
            if (!is_cut(r, f, k)) add_edge(r, c[k], c[(k + 1) % n]);
    }
    for (int k = 0; k < r->nl; k++) add_edge(r, r->line[k][0], r->line[k][1]);
}

static double distance(const solid_ref_t *r, int v, const double p[3]) {
    return fabs(r->vertex[v].x - p[0]) + fabs(r->vertex[v].y - p[1]) + fabs(r->vertex[v].z - p[2]);
}

int solid_ref_find(const solid_ref_t *r, const double a[3], const double b[3], double within, bool *turned) {
    int nearest = -1;
    for (int k = 0; k < r->ne; k++)
        for (int t = 0; t < 2; t++) {
            double off = distance(r, r->edge[k][t], a) + distance(r, r->edge[k][1 - t], b);
            if (off > within) continue;
            within = off;
            nearest = k;
            *turned = t;
            if (off <= 1e-7 * r->size) return k; /* as good as the same */
        }
    return nearest;
}

static vec_t to_eye(const solid_ref_t *r, vec_t p) {
    if (!r->eye.h) return (vec_t){r->eye.x, r->eye.y, r->eye.z};
    return (vec_t){r->eye.x - p.x, r->eye.y - p.y, r->eye.z - p.z};
}

/* A face's plane: its normal, of length 1, by Newell; false without an area. */
static bool plane(const solid_ref_t *r, int f, vec_t *n) {
    *n = (vec_t){0, 0, 0};
    exact_point_t o = r->vertex[r->corner[r->first[f]]];
    for (int k = r->first[f]; k + 1 < r->first[f + 1]; k++) {
        vec_t c = cross(sub(r->vertex[r->corner[k]], o), sub(r->vertex[r->corner[k + 1]], o));
        *n = (vec_t){n->x + c.x, n->y + c.y, n->z + c.z};
    }
    long double length = norm(*n);
    if (length <= 1e-14L * r->size * r->size) return false;
    *n = (vec_t){n->x / length, n->y / length, n->z / length};
    return true;
}

static vec_t at_vertex(const solid_ref_t *r, int k) {
    return (vec_t){r->vertex[r->corner[k]].x, r->vertex[r->corner[k]].y, r->vertex[r->corner[k]].z};
}

/* Even-odd, along the plane's two broadest axes; *border: nearer than `tolerance` to it. */
static bool is_within(const solid_ref_t *r, int f, vec_t n, vec_t p, long double tolerance, bool *border) {
    int drop = fabsl(n.x) > fabsl(n.y) ? (fabsl(n.x) > fabsl(n.z) ? 0 : 2) : (fabsl(n.y) > fabsl(n.z) ? 1 : 2);
    bool inside = false;
    int from = r->first[f], to = r->first[f + 1];
    *border = false;
    for (int k = from; k < to; k++) {
        vec_t a = at_vertex(r, k), b = at_vertex(r, k + 1 < to ? k + 1 : from);
        long double au = drop == 0 ? a.y : a.x, av = drop == 2 ? a.y : a.z, bu = drop == 0 ? b.y : b.x,
                    bv = drop == 2 ? b.y : b.z, pu = drop == 0 ? p.y : p.x, pv = drop == 2 ? p.y : p.z;
        long double length = hypotl(bu - au, bv - av);
        if (length > 0) {
            long double t = ((pu - au) * (bu - au) + (pv - av) * (bv - av)) / (length * length);
            t = t < 0 ? 0 : t > 1 ? 1 : t;
            if (hypotl(pu - au - t * (bu - au), pv - av - t * (bv - av)) < tolerance) *border = true;
        }
        if ((av > pv) != (bv > pv) && pu < au + (pv - av) / (bv - av) * (bu - au)) inside = !inside;
    }
    return inside;
}

typedef struct cuts {
    long double t[4096];
    int n;
} cuts_t;

static void cut(cuts_t *c, long double a, long double b) {
    if ((a > 0) == (b > 0) || c->n == 4096) return;
    c->t[c->n++] = a / (a - b);
}

static int by_value(const void *p, const void *q) {
    long double a = *(const long double *)p, b = *(const long double *)q;
    return (a > b) - (a < b);
}

static bool in_plane(const solid_ref_t *r, int f, vec_t n, exact_point_t p) {
    return fabsl(dot(n, sub(p, r->vertex[r->corner[r->first[f]]]))) < 1e-8L * r->size;
}

/* 1: hidden, 0: visible, -1: touches a border only. */
static int ray(const solid_ref_t *r, vec_t p, const exact_point_t own[2]) {
    vec_t d = to_eye(r, p);
    int result = 0;
    for (int f = 0; f < r->nf; f++) {
        vec_t n, o = at_vertex(r, r->first[f]);
        if (!plane(r, f, &n)) continue;
        long double slope = dot(n, d);
        if (fabsl(slope) < 1e-13L * norm(d)) continue;
        if (own && in_plane(r, f, n, own[0]) && in_plane(r, f, n, own[1])) continue;
        long double s = dot(n, (vec_t){o.x - p.x, o.y - p.y, o.z - p.z}) / slope;
        if (s * norm(d) < 1e-10L * r->size || (r->eye.h && s >= 1)) continue;
        bool border;
        bool inside =
            is_within(r, f, n, (vec_t){p.x + s * d.x, p.y + s * d.y, p.z + s * d.z}, 1e-11L * r->size, &border);
        if (border)
            result = -1;
        else if (inside)
            return 1;
    }
    return result;
}

/* Cuts the segment where it passes the planes through the eye and a border of face f. */
static void cut_at_borders(cuts_t *c, const solid_ref_t *r, int f, const exact_point_t at[2]) {
    for (int k = r->first[f]; k < r->first[f + 1]; k++) {
        exact_point_t p = r->vertex[r->corner[k]],
                      q = r->vertex[r->corner[k + 1 < r->first[f + 1] ? k + 1 : r->first[f]]];
        vec_t m = cross(sub(q, p), to_eye(r, (vec_t){p.x, p.y, p.z}));
        cut(c, dot(m, sub(at[0], p)), dot(m, sub(at[1], p)));
    }
}

void solid_ref_hidden(const solid_ref_t *r, const exact_point_t at[2], const exact_point_t own[2], spans_t *hidden,
                      spans_t *either) {
    static cuts_t c;
    const vec_t a = {at[0].x, at[0].y, at[0].z}, b = {at[1].x, at[1].y, at[1].z};
    c.n = 0;
    c.t[c.n++] = 0;
    c.t[c.n++] = 1;
    for (int f = 0; f < r->nf; f++) {
        vec_t n;
        if (!plane(r, f, &n)) continue;
        exact_point_t o = r->vertex[r->corner[r->first[f]]];
        cut(&c, dot(n, sub(at[0], o)), dot(n, sub(at[1], o)));
        cut_at_borders(&c, r, f, at);
    }
    qsort(c.t, (size_t)c.n, sizeof c.t[0], by_value);
    spans_clear(hidden);
    if (either) spans_clear(either);
    for (int k = 0; k + 1 < c.n; k++) {
        long double t = (c.t[k] + c.t[k + 1]) / 2;
        if (c.t[k + 1] - c.t[k] < 1e-13L) continue;
        int state = ray(r, (vec_t){a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)}, own);
        if (state > 0) spans_add(hidden, c.t[k], c.t[k + 1]);
        if (state < 0 && either) spans_add(either, c.t[k], c.t[k + 1]);
    }
    spans_tidy(hidden);
    if (either) spans_tidy(either);
}

void solid_ref_beside(const solid_ref_t *r, int f, const exact_point_t at[2], spans_t *beside, spans_t *either) {
    static cuts_t c;
    const vec_t a = {at[0].x, at[0].y, at[0].z}, b = {at[1].x, at[1].y, at[1].z};
    vec_t n;
    const bool flat = plane(r, f, &n);
    spans_clear(beside);
    spans_clear(either);
    c.n = 0;
    c.t[c.n++] = 0;
    c.t[c.n++] = 1;
    cut_at_borders(&c, r, f, at);
    qsort(c.t, (size_t)c.n, sizeof c.t[0], by_value);
    for (int k = 0; k + 1 < c.n; k++) {
        const long double t = (c.t[k] + c.t[k + 1]) / 2;
        const vec_t p = {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)}, d = to_eye(r, p),
                    o = at_vertex(r, r->first[f]);
        const long double slope = flat ? dot(n, d) : 0;
        bool border = false, inside = false;
        if (fabsl(slope) < 1e-3L * norm(d)) { /* the lattice of the scene decides where the border is */
            border = true;
        } else {
            const long double s = dot(n, (vec_t){o.x - p.x, o.y - p.y, o.z - p.z}) / slope;
            inside = is_within(r, f, n, (vec_t){p.x + s * d.x, p.y + s * d.y, p.z + s * d.z}, 1e-8L * r->size, &border);
        }
        if (border)
            spans_add(either, c.t[k], c.t[k + 1]);
        else if (!inside)
            spans_add(beside, c.t[k], c.t[k + 1]);
    }
    spans_tidy(beside);
    spans_tidy(either);
}

bool solid_ref_eye_touches(const solid_ref_t *r) {
    const vec_t e = {r->eye.x, r->eye.y, r->eye.z};
    for (int f = 0; f < r->nf && r->eye.h; f++) {
        vec_t n;
        bool border;
        if (!plane(r, f, &n) || !in_plane(r, f, n, (exact_point_t){r->eye.x, r->eye.y, r->eye.z})) continue;
        if (is_within(r, f, n, e, 1e-8L * r->size, &border) || border) return true;
    }
    return false;
}

static int solid_lines(const void *ref, int family) {
    return family ? 0 : ((const solid_ref_t *)ref)->ne;
}
static int solid_edges(const void *ref, int family, int line) {
    (void)ref, (void)family, (void)line;
    return 1;
}
static bool solid_exists(const void *ref, int family, int line, int k) {
    (void)ref, (void)family, (void)line, (void)k;
    return true;
}
static void solid_ends(const void *ref, int family, int line, int k, exact_point_t end[2]) {
    const solid_ref_t *r = ref;
    (void)family, (void)k;
    for (int i = 0; i < 2; i++) end[i] = r->vertex[r->edge[line][i]];
}
static void solid_look(const void *ref, int family, int line, int k, spans_t *hidden, spans_t *either) {
    exact_point_t end[2];
    solid_ends(ref, family, line, k, end);
    solid_ref_hidden(ref, end, end, hidden, either);
}
static void solid_moved(const void *ref, int family, int line, int k, const exact_point_t at[2], spans_t *hidden) {
    exact_point_t end[2];
    solid_ends(ref, family, line, k, end);
    solid_ref_hidden(ref, at, end, hidden, NULL);
}
static void solid_doubled(const void *ref, int family, int line, int k, const exact_point_t at[2],
                          const exact_point_t other[2], spans_t *out) {
    (void)ref, (void)family, (void)line, (void)k, (void)at, (void)other;
    spans_clear(out); /* a line in front hides nothing by itself */
}

judge_subject_t judge_solid(const solid_ref_t *r) {
    return (judge_subject_t){.ref = r,
                             .lines = solid_lines,
                             .edges = solid_edges,
                             .exists = solid_exists,
                             .ends = solid_ends,
                             .look = solid_look,
                             .moved = solid_moved,
                             .doubled = solid_doubled};
}
