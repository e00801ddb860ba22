/* solid_scenes.c - see solid_scenes.h. */
#include "tests/oracle/solid_scenes.h"
#include "tests/oracle/num_of.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static uint64_t rng;

static double uniform(double lo, double hi) {
    rng ^= rng << 13, rng ^= rng >> 7, rng ^= rng << 17;
    return lo + (hi - lo) * (double)(rng >> 11) * 0x1p-53;
}
static int pick(int n) {
    return (int)uniform(0, n);
}

/* How an object is placed: size, turn, offset. */
typedef struct place {
    double m[3][3], at[3];
} place_t;

static place_t place(bool turned, double size, const double at[3]) {
    place_t p = {{{size, 0, 0}, {0, size, 0}, {0, 0, size}}, {at[0], at[1], at[2]}};
    for (int axis = 0; axis < 3 && turned; axis++) {
        double a = uniform(0, 6.3), c = cos(a), s = sin(a);
        int u = axis, v = (axis + 1) % 3;
        for (int k = 0; k < 3; k++) {
            double x = p.m[u][k], y = p.m[v][k];
            p.m[u][k] = c * x - s * y;
            p.m[v][k] = s * x + c * y;
        }
    }
    return p;
}

static int put(solid_ref_t *r, const place_t *p, double x, double y, double z) {
    double q[3];
    for (int k = 0; k < 3; k++) q[k] = p->at[k] + p->m[k][0] * x + p->m[k][1] * y + p->m[k][2] * z;
    return solid_ref_vertex(r, q[0], q[1], q[2]);
}

/* A face, maybe turned round. */
static void add(solid_ref_t *r, const int *v, int n, bool turned) {
    int w[64];
    for (int k = 0; k < n; k++) w[k] = v[turned ? n - 1 - k : k];
    solid_ref_face(r, w, n);
}

/* A prism over the polygon xy, with caps; wild: windings as they come. missing: leave out this face. */
static void prism(solid_ref_t *r, const place_t *p, const double (*xy)[2], int n, double height, bool point, bool wild,
                  int missing) {
    int low[32], high[32];
    for (int k = 0; k < n; k++) low[k] = put(r, p, xy[k][0], xy[k][1], 0);
    int top = point ? put(r, p, 0.1, 0.2, height) : 0;
    for (int k = 0; k < n && !point; k++) high[k] = put(r, p, xy[k][0], xy[k][1], height);
    int cap[32];
    for (int k = 0; k < n; k++) cap[k] = low[n - 1 - k];
    if (missing != 0) add(r, cap, n, wild && pick(2));
    if (!point && missing != 1) add(r, high, n, wild && pick(2));
    for (int k = 0; k < n; k++) {
        int next = (k + 1) % n;
        if (missing == 2 + k) continue;
        int side[4] = {low[k], low[next], point ? top : high[next], high[k]};
        add(r, side, point ? 3 : 4, wild && pick(2));
    }
}

static void polygon(double (*xy)[2], int n, double rx, double ry) {
    for (int k = 0; k < n; k++) {
        xy[k][0] = rx * cos(6.283185307179586 * k / n);
        xy[k][1] = ry * sin(6.283185307179586 * k / n);
    }
}

static void torus(solid_ref_t *r, const place_t *p, int n, int m) {
    int v[16][16];
    for (int i = 0; i < n; i++)
        for (int j = 0; j < m; j++) {
            double a = 6.283185307179586 * i / n, b = 6.283185307179586 * j / m, c = 1 + 0.4 * cos(b);
            v[i][j] = put(r, p, c * cos(a), c * sin(a), 0.4 * sin(b));
        }
    for (int i = 0; i < n; i++)
        for (int j = 0; j < m; j++) {
            int a = v[i][j], b = v[(i + 1) % n][j], c = v[(i + 1) % n][(j + 1) % m], d = v[i][(j + 1) % m];
            add(r, (int[]){a, b, c}, 3, false);
            add(r, (int[]){a, c, d}, 3, false);
        }
}

static void sheet(solid_ref_t *r, const place_t *p, int n) {
    int v[8][8];
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) v[i][j] = put(r, p, i - n / 2.0, j - n / 2.0, uniform(-0.6, 0.6));
    for (int i = 0; i + 1 < n; i++)
        for (int j = 0; j + 1 < n; j++) {
            add(r, (int[]){v[i][j], v[i + 1][j], v[i + 1][j + 1]}, 3, pick(2));
            add(r, (int[]){v[i][j], v[i + 1][j + 1], v[i][j + 1]}, 3, pick(2));
        }
}

/* Bodies on a lattice: they touch in faces, edges and corners, and are seen along them. */
static void lattice_box(solid_ref_t *r) {
    static const double square[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    double at[3] = {pick(4) - 2, pick(4) - 2, pick(3)};
    place_t p = place(false, 1, at);
    for (int k = 0; k < 3; k++) p.m[k][k] = 1 + pick(2);
    prism(r, &p, square, 4, 1, false, false, -1);
}

static void object(solid_ref_t *r, bool lattice) {
    static const double bend[6][2] = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    double at[3] = {uniform(-3, 3), uniform(-3, 3), uniform(-2, 2)}, xy[16][2];
    int n = 3 + pick(6);
    if (lattice) {
        lattice_box(r);
        return;
    }
    place_t p = place(pick(3), uniform(0.3, 1.6), at);
    polygon(xy, n, 1, 1);
    switch (pick(11)) {
    case 0:
    case 1:
        prism(r, &p, xy, n, uniform(0.3, 2), false, false, -1);
        break;
    case 2:
        prism(r, &p, xy, n, uniform(0.3, 2), true, pick(2), -1);
        break;
    case 3:
        prism(r, &p, bend, 6, uniform(0.3, 2), false, pick(2), -1);
        break;
    case 4: /* a needle, or a plate */
        polygon(xy, n, pick(2) ? 1e-3 : 4, 1e-3);
        prism(r, &p, xy, n, 3, pick(2), false, -1);
        break;
    case 5:
        torus(r, &p, 5 + pick(3), 3 + pick(3));
        break;
    case 6:
        sheet(r, &p, 3 + pick(3));
        break;
    case 7: /* open: a face is missing */
        prism(r, &p, xy, n, 1, false, pick(2), pick(n + 2));
        break;
    case 8: { /* one polygon, maybe there twice, maybe concave */
        int v[6];
        for (int k = 0; k < 6; k++) v[k] = put(r, &p, bend[k][0], bend[k][1], 0);
        solid_ref_face(r, v, 6);
        if (pick(3) == 0) add(r, v, 6, pick(2));
        break;
    }
    case 9: { /* broken: without an area, and a corner twice */
        int a = put(r, &p, 0, 0, 0), b = put(r, &p, 1, 0, 0), c = put(r, &p, 2, 0, 0), d = put(r, &p, 0, 1, 0);
        solid_ref_face(r, (int[]){a, b, c}, 3);
        solid_ref_face(r, (int[]){a, b, b, d}, 4);
        break;
    }
    default:
        for (int k = 0; k < 4; k++)
            solid_ref_line(r, put(r, &p, uniform(-3, 3), uniform(-3, 3), uniform(-2, 2)),
                           put(r, &p, uniform(-3, 3), uniform(-3, 3), uniform(-2, 2)));
    }
}

static void set_view(solid_scene_t *s, bool lattice) {
    settings_t *set = &s->set;
    double r[3] = {uniform(-4, 4), uniform(-4, 4), uniform(-3, 3)};
    int kind = pick(6);
    set->view.from = kind < 3;
    const double far = kind == 0 ? (double[]){3, 100, 1e4}[pick(3)] : 1;
    for (int k = 0; k < 3; k++) r[k] *= far;
    if (kind == 2 && lattice)
        for (int k = 0; k < 3; k++) r[k] = floor(r[k] * 2); /* in planes of faces */
    if (kind < 3) {
        for (int k = 0; k < 3; k++) set->view.eye[k] = num_of(r[k]);
        set->view.has_to = pick(2);
        for (int k = 0; k < 3; k++) set->view.to[k] = num_of(uniform(-1, 1));
        snprintf(s->what, sizeof s->what, "set view from %.17g,%.17g,%.17g", r[0], r[1], r[2]);
    } else {
        double rx = kind == 3 ? 90 * pick(3) : uniform(0, 180), rz = kind <= 4 ? 45 * pick(8) : uniform(0, 360);
        set->view.rot_x = num_of(rx);
        set->view.rot_z = num_of(rz);
        snprintf(s->what, sizeof s->what, "set view %.17g,%.17g", rx, rz);
    }
}

void solid_scene_random(solid_scene_t *s, uint64_t seed, int objects) {
    rng = seed * 0x9e3779b97f4a7c15u + 0x1234567;
    for (int k = 0; k < 5; k++) uniform(0, 1);
    *s = (solid_scene_t){0};
    settings_default(&s->set);
    bool lattice = s->lattice = pick(3) == 0;
    int n = 1 + pick(objects);
    for (int k = 0; k < n; k++) object(&s->ref, lattice && pick(6));
    set_view(s, lattice);
    solid_ref_finish(&s->ref);
}

void solid_scene_flush(solid_scene_t *s, uint64_t seed, int objects) {
    rng = seed * 0x9e3779b97f4a7c15u + 0x7654321;
    for (int k = 0; k < 5; k++) uniform(0, 1);
    *s = (solid_scene_t){0};
    settings_default(&s->set);
    const int n = 1 + pick(objects);
    for (int k = 0; k < n; k++) {
        const double at[3] = {0, 0, 0};
        const place_t p = place(false, 1, at);
        if (pick(4)) {
            lattice_box(&s->ref);
        } else { /* wires along the lattice */
            const double x = pick(5) - 2, y = pick(5) - 2, z = pick(4), way = 1 + pick(3);
            const int axis = pick(3);
            solid_ref_line(&s->ref, put(&s->ref, &p, x, y, z),
                           put(&s->ref, &p, x + (axis == 0) * way, y + (axis == 1) * way, z + (axis == 2) * way));
        }
    }
    if (pick(2)) { /* the whole turned: then nothing is exactly on anything */
        const double at[3] = {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
        const place_t p = place(true, uniform(0.5, 3), at);
        solid_ref_t *r = &s->ref;
        for (int v = 0; v < r->nv; v++) {
            const exact_point_t q = r->vertex[v];
            (void)put(r, &p, q.x, q.y, q.z);
            r->vertex[v] = r->vertex[--r->nv];
        }
    }
    set_view(s, true);
    solid_ref_finish(&s->ref);
}

void solid_scene_free(solid_scene_t *s) {
    solid_ref_free(&s->ref);
}
