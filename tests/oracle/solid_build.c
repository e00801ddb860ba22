/* solid_build.c - see solid_build.h. */
#include "tests/oracle/solid_build.h"

#include <math.h>
#include <stdio.h>

#include "tests/oracle/num_of.h"
#include "tests/oracle/scenes.h"

static uint64_t rng;
static double turn[3][3], scale;

double solid_build_uniform(double lo, double hi) {
    return lo + (hi - lo) * scene_uniform(&rng);
}
int solid_build_pick(int n) {
    return scene_below(&rng, n);
}

static void choose_turn(void) {
    const bool turned = solid_build_pick(3) > 0;
    scale = turned ? solid_build_uniform(.5, 3) : 1;
    scene_turn(&rng, turned, turn);
}

int solid_build_put(solid_ref_t *r, double x, double y, double z) {
    double q[3];
    for (int k = 0; k < 3; k++) q[k] = scale * (turn[k][0] * x + turn[k][1] * y + turn[k][2] * z);
    return solid_ref_vertex(r, q[0], q[1], q[2]);
}

/* A prism from z0 to z1 over a polygon that turns to the left. */
void solid_build_prism(solid_ref_t *r, const double (*xy)[2], int n, double z0, double z1) {
    int low[SOLID_CORNERS], high[SOLID_CORNERS], cap[SOLID_CORNERS] = {0};
    for (int k = 0; k < n; k++) low[k] = solid_build_put(r, xy[k][0], xy[k][1], z0);
    for (int k = 0; k < n; k++) high[k] = solid_build_put(r, xy[k][0], xy[k][1], z1);
    for (int k = 0; k < n; k++) cap[k] = low[n - 1 - k];
    solid_ref_face(r, cap, n);
    solid_ref_face(r, high, n);
    for (int k = 0; k < n; k++) {
        const int next = (k + 1) % n;
        solid_ref_face(r, (int[]){low[k], low[next], high[next], high[k]}, 4);
    }
}

void solid_build_box(solid_ref_t *r, double x, double y, double z, double a, double b, double c) {
    const double xy[4][2] = {{x, y}, {x + a, y}, {x + a, y + b}, {x, y + b}};
    solid_build_prism(r, xy, 4, z, z + c);
}

/* In the plane of a face, or on the line of an edge. */
static exact_point_t among_corners(const solid_ref_t *r, bool line) {
    const int f = solid_build_pick(r->nf), n = r->first[f + 1] - r->first[f], *c = r->corner + r->first[f],
              k = solid_build_pick(n);
    const exact_point_t *o = &r->vertex[c[k]], *p = &r->vertex[c[(k + 1) % n]], *q = &r->vertex[c[(k + 2) % n]];
    const double a = solid_build_uniform(-4, 4), b = line ? 0 : solid_build_uniform(-4, 4);
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

static exact_point_t eye_of(const solid_ref_t *r, enum solid_eye_place kind) {
    if (kind <= FROM_LINE) return among_corners(r, kind == FROM_LINE);
    if (kind == FROM_ANYWHERE)
        return (exact_point_t){solid_build_uniform(-6, 6), solid_build_uniform(-6, 6), solid_build_uniform(-6, 6)};
    const double near =
        kind == FROM_CLOSE ? pow(10, solid_build_uniform(-2, -1)) : pow(10, solid_build_uniform(-1.3, -.3));
    exact_point_t e = r->vertex[r->corner[solid_build_pick(r->nc)]];
    e.x += near * solid_build_uniform(-1, 1), e.y += near * solid_build_uniform(-1, 1),
        e.z += near * solid_build_uniform(-1, 1);
    return e;
}

static void look(solid_scene_t *s, const char *what, enum solid_eye_place kind) {
    const solid_ref_t *r = &s->ref;
    s->set.view.from = kind < ALONG_AXES || kind == FROM_CLOSE;
    if (s->set.view.from) {
        exact_point_t e = eye_of(r, kind);
        for (int k = 0; k < 20 && solid_scene_clearance(r, &e) < 2e-4; k++) e = eye_of(r, kind);
        const double at[3] = {e.x, e.y, e.z};
        for (int k = 0; k < 3; k++) s->set.view.eye[k] = num_of(at[k]);
        snprintf(s->what, sizeof s->what, "%s, set view from %.17g,%.17g,%.17g", what, at[0], at[1], at[2]);
    } else {
        const bool axes = kind == ALONG_AXES;
        const double rx = axes ? 90 * solid_build_pick(3) : solid_build_uniform(0, 180),
                     rz = axes ? 45 * solid_build_pick(8) : solid_build_uniform(0, 360);
        s->set.view.rot_x = num_of(rx);
        s->set.view.rot_z = num_of(rz);
        snprintf(s->what, sizeof s->what, "%s, set view %.17g,%.17g", what, rx, rz);
    }
}

void solid_build_begin(solid_scene_t *s, uint64_t seed) {
    rng = seed ^ 0x70c4;
    for (int k = 0; k < 4; k++) scene_uniform(&rng);
    *s = (solid_scene_t){.lattice = true};
    settings_default(&s->set);
    choose_turn();
}

void solid_build_end(solid_scene_t *s, const char *what, enum solid_eye_place kind) {
    look(s, what, kind);
    solid_ref_finish(&s->ref);
}
