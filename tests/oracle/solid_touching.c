/* solid_touching.c - bodies that touch; see solid_scenes.h. */
#include <math.h>
#include <stdio.h>

#include "tests/oracle/num_of.h"
#include "tests/oracle/scenes.h"
#include "tests/oracle/solid_scenes.h"

#define FULL_TURN 6.283185307179586

static uint64_t rng;
static double turn[3][3], scale;

static double uniform(double lo, double hi) {
    return lo + (hi - lo) * scene_uniform(&rng);
}
static int pick(int n) {
    return scene_below(&rng, n);
}

static void choose_turn(void) {
    const bool turned = pick(3) > 0;
    scale = turned ? uniform(.5, 3) : 1;
    scene_turn(&rng, turned, turn);
}

static int put(solid_ref_t *r, double x, double y, double z) {
    double q[3];
    for (int k = 0; k < 3; k++) q[k] = scale * (turn[k][0] * x + turn[k][1] * y + turn[k][2] * z);
    return solid_ref_vertex(r, q[0], q[1], q[2]);
}

/* A prism from z0 to z1 over a polygon that turns to the left. */
static void prism(solid_ref_t *r, const double (*xy)[2], int n, double z0, double z1) {
    int low[8], high[8], cap[8];
    for (int k = 0; k < n; k++) low[k] = put(r, xy[k][0], xy[k][1], z0);
    for (int k = 0; k < n; k++) high[k] = put(r, xy[k][0], xy[k][1], z1);
    for (int k = 0; k < n; k++) cap[k] = low[n - 1 - k];
    solid_ref_face(r, cap, n);
    solid_ref_face(r, high, n);
    for (int k = 0; k < n; k++) {
        const int next = (k + 1) % n;
        solid_ref_face(r, (int[]){low[k], low[next], high[next], high[k]}, 4);
    }
}

static void box(solid_ref_t *r, double x, double y, double z, double a, double b, double c) {
    const double xy[4][2] = {{x, y}, {x + a, y}, {x + a, y + b}, {x, y + b}};
    prism(r, xy, 4, z, z + c);
}

/* Sectors, each as high as it happens. */
static void wedges(solid_ref_t *r, int n) {
    const int around = n + 2 + pick(3);
    for (int k = 0; k < n; k++) {
        double xy[3][2] = {{0, 0}};
        for (int i = 0; i < 2; i++) {
            xy[1 + i][0] = cos(FULL_TURN * (k + i) / around);
            xy[1 + i][1] = sin(FULL_TURN * (k + i) / around);
        }
        prism(r, xy, 3, -uniform(0, 1), pick(2) ? 1 : uniform(.1, 2));
    }
}

/* Boxes of six tetrahedra around a diagonal, some of which are missing. */
static void tetrahedra(solid_ref_t *r, int n) {
    static const int order[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    const double size[3] = {uniform(.5, 2), uniform(.5, 2), uniform(.5, 2)};
    for (int k = 0; k < 2 * n; k++) {
        const int *o = order[k % 6];
        double at[3] = {(double)(k / 6), 0, 0};
        int v[4];
        if (pick(4) == 0) continue;
        v[0] = put(r, at[0] * size[0], at[1] * size[1], at[2] * size[2]);
        for (int i = 0; i < 3; i++) {
            at[o[i]] += 1;
            v[1 + i] = put(r, at[0] * size[0], at[1] * size[1], at[2] * size[2]);
        }
        static const int side[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
        for (int f = 0; f < 4; f++) { /* odd orders turn the other way */
            const bool odd = k % 6 > 2;
            const int a = v[side[f][0]], b = v[side[f][odd ? 2 : 1]], c = v[side[f][odd ? 1 : 2]];
            solid_ref_face(r, (int[]){a, b, c}, 3);
        }
    }
}

/* Boxes that share a corner, or an edge's middle; open ones let the inner ones be seen. */
static void nested(solid_ref_t *r, int n) {
    for (int k = 0; k < n; k++) {
        const double s = 2. / (k + 1), off = pick(2) ? 0 : 1 - s / 2;
        box(r, off, pick(2) ? 0 : 2 - s, 0, s, s, s);
    }
}

/* Boxes one on the other, edges of some over the middle of others; or into it, flush below and often in a side. */
static void stack(solid_ref_t *r, int n) {
    double z = 0;
    for (int k = 0; k < n; k++) {
        const double h = pick(2) ? 1 : uniform(.05, 1), x = pick(5) / 4., y = pick(5) / 4.;
        box(r, x, y, z, 1 + pick(3) / 2., 1 + pick(3) / 2., h);
        z += pick(4) ? h : 0;
    }
}

static void mirrored(solid_ref_t *r, int n) {
    for (int k = 0; k < n; k += 2) {
        double xy[6][2];
        const int m = 3 + pick(4);
        const double x = 1.5 * k, h = uniform(.2, 2);
        for (int i = 0; i < m; i++) {
            xy[i][0] = x + cos(FULL_TURN * i / m);
            xy[i][1] = sin(FULL_TURN * i / m);
        }
        prism(r, xy, m, 0, h);
        prism(r, xy, m, -h, 0);
    }
}

static void tips(solid_ref_t *r, int n) {
    for (int k = 0; k < n; k++) {
        const double a = FULL_TURN * k / n, c = cos(a), s = sin(a), w = uniform(.1, .5);
        const int tip = put(r, 0, 0, 0);
        int v[4];
        for (int i = 0; i < 4; i++) {
            const double side = w * (i == 1 || i == 2 ? 1 : -1), up = w * (i > 1 ? 1 : -1);
            v[i] = put(r, 2 * c - side * s, 2 * s + side * c, up);
        }
        solid_ref_face(r, v, 4);
        for (int i = 0; i < 4; i++) solid_ref_face(r, (int[]){v[(i + 1) % 4], v[i], tip}, 3);
    }
}

/* In the plane of a face, or on the line of an edge. */
static exact_point_t among_corners(const solid_ref_t *r, bool line) {
    const int f = pick(r->nf), n = r->first[f + 1] - r->first[f], *c = r->corner + r->first[f], k = pick(n);
    const exact_point_t *o = &r->vertex[c[k]], *p = &r->vertex[c[(k + 1) % n]], *q = &r->vertex[c[(k + 2) % n]];
    const double a = uniform(-4, 4), b = line ? 0 : uniform(-4, 4);
    return (exact_point_t){o->x + a * (p->x - o->x) + b * (q->x - o->x), o->y + a * (p->y - o->y) + b * (q->y - o->y),
                           o->z + a * (p->z - o->z) + b * (q->z - o->z)};
}

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
static void minus(const exact_point_t *a, const exact_point_t *b, double out[3]) {
    out[0] = a->x - b->x, out[1] = a->y - b->y, out[2] = a->z - b->z;
}

/* How far p is from a triangle, or less: from its plane, if it is over it, or from one of its sides. */
static double from_triangle(const exact_point_t *p, const exact_point_t *v[3]) {
    double u[3], w[3], d[3], least = INFINITY;
    minus(v[1], v[0], u), minus(v[2], v[0], w), minus(p, v[0], d);
    const double n[3] = {u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]};
    const double uu = dot(u, u), uw = dot(u, w), ww = dot(w, w), nn = dot(n, n);
    const double a = (dot(d, u) * ww - dot(d, w) * uw) / nn, b = (dot(d, w) * uu - dot(d, u) * uw) / nn;
    if (a >= 0 && b >= 0 && a + b <= 1) return fabs(dot(d, n)) / sqrt(nn);
    for (int k = 0; k < 3; k++) {
        minus(v[(k + 1) % 3], v[k], u), minus(p, v[k], d);
        const double t = fmin(fmax(dot(d, u) / dot(u, u), 0), 1);
        for (int i = 0; i < 3; i++) d[i] -= t * u[i];
        least = fmin(least, sqrt(dot(d, d)));
    }
    return least;
}

double solid_scene_clearance(const solid_ref_t *r, const exact_point_t *p) {
    double least = INFINITY;
    for (int f = 0; f < r->nf; f++) {
        const int n = r->first[f + 1] - r->first[f], *c = r->corner + r->first[f];
        for (int k = 1; k + 1 < n; k++) {
            const exact_point_t *v[3] = {&r->vertex[c[0]], &r->vertex[c[k]], &r->vertex[c[k + 1]]};
            least = fmin(least, from_triangle(p, v));
        }
    }
    return least;
}

enum { FROM_PLANE, FROM_LINE, FROM_ANYWHERE, FROM_NEAR, ALONG_AXES, ALONG_ANY, PLACES, FROM_CLOSE };

static exact_point_t eye_of(const solid_ref_t *r, int kind) {
    if (kind <= FROM_LINE) return among_corners(r, kind == FROM_LINE);
    if (kind == FROM_ANYWHERE) return (exact_point_t){uniform(-6, 6), uniform(-6, 6), uniform(-6, 6)};
    const double near = kind == FROM_CLOSE ? pow(10, uniform(-2, -1)) : pow(10, uniform(-1.3, -.3));
    exact_point_t e = r->vertex[r->corner[pick(r->nc)]];
    e.x += near * uniform(-1, 1), e.y += near * uniform(-1, 1), e.z += near * uniform(-1, 1);
    return e;
}

static void look(solid_scene_t *s, int kind) {
    const solid_ref_t *r = &s->ref;
    s->set.view.from = kind < ALONG_AXES || kind == FROM_CLOSE;
    if (s->set.view.from) {
        exact_point_t e = eye_of(r, kind);
        for (int k = 0; k < 20 && solid_scene_clearance(r, &e) < 2e-4; k++) e = eye_of(r, kind);
        const double at[3] = {e.x, e.y, e.z};
        for (int k = 0; k < 3; k++) s->set.view.eye[k] = num_of(at[k]);
        snprintf(s->what, sizeof s->what, "touching, set view from %.17g,%.17g,%.17g", at[0], at[1], at[2]);
    } else {
        const bool axes = kind == ALONG_AXES;
        const double rx = axes ? 90 * pick(3) : uniform(0, 180), rz = axes ? 45 * pick(8) : uniform(0, 360);
        s->set.view.rot_x = num_of(rx);
        s->set.view.rot_z = num_of(rz);
        snprintf(s->what, sizeof s->what, "touching, set view %.17g,%.17g", rx, rz);
    }
}

static void make(solid_scene_t *s, uint64_t seed, int objects, bool close) {
    static void (*const kind[])(solid_ref_t * r, int n) = {wedges, tetrahedra, nested, stack, mirrored, tips};
    rng = seed ^ 0x70c4;
    for (int k = 0; k < 4; k++) scene_uniform(&rng);
    *s = (solid_scene_t){.lattice = true};
    settings_default(&s->set);
    choose_turn();
    kind[pick(sizeof kind / sizeof *kind)](&s->ref, 2 + pick(objects));
    if (s->ref.nf == 0) box(&s->ref, 0, 0, 0, 1, 1, 1);
    look(s, close ? FROM_CLOSE : pick(PLACES));
    solid_ref_finish(&s->ref);
}

void solid_scene_touching(solid_scene_t *s, uint64_t seed, int objects) {
    make(s, seed, objects, false);
}

void solid_scene_close(solid_scene_t *s, uint64_t seed, int objects) {
    make(s, seed, objects, true);
}
