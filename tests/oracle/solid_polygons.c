/* solid_polygons.c - polygons as the area sort dislikes them; see solid_scenes.h. */
#include <math.h>
#include <stdio.h>

#include "tests/oracle/num_of.h"
#include "tests/oracle/scenes.h"
#include "tests/oracle/solid_scenes.h"

#define FULL_TURN 6.283185307179586

static uint64_t rng;
/* A plane at a time: origin and axes. */
static double frame[4][3];

static double uniform(double lo, double hi) {
    return lo + (hi - lo) * scene_uniform(&rng);
}
static int pick(int n) {
    return scene_below(&rng, n);
}

/* Level or upright planes on a lattice, else turned by any angles. */
static void choose_frame(bool turned) {
    scene_turn(&rng, turned, frame);
    for (int k = 0; k < 3; k++) frame[3][k] = 0;
}

static int put(solid_ref_t *r, double x, double y, double z) {
    double q[3];
    for (int k = 0; k < 3; k++) q[k] = frame[3][k] + x * frame[0][k] + y * frame[1][k] + z * frame[2][k];
    return solid_ref_vertex(r, q[0], q[1], q[2]);
}

static void plate(solid_ref_t *r, const double (*xy)[2], int n, double z) {
    int v[32];
    for (int k = 0; k < n; k++) v[k] = put(r, xy[k][0], xy[k][1], z);
    solid_ref_face(r, v, n);
}

static void rectangle(solid_ref_t *r, double x0, double y0, double x1, double y1, double z) {
    const double xy[4][2] = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
    plate(r, xy, 4, z);
}

static void box(solid_ref_t *r, double x0, double y0, double z0, double x1, double y1, double z1) {
    int v[8];
    for (int k = 0; k < 8; k++) v[k] = put(r, k & 1 ? x1 : x0, k & 2 ? y1 : y0, k & 4 ? z1 : z0);
    solid_ref_box(r, v);
}

/* ---- faces with holes ---- */

/* n corners around a place, from any of them on; turned: the other way round. */
static int around(solid_ref_t *r, int *v, double x, double y, double size, bool turned) {
    const int n = 3 + pick(5), from = pick(n);
    const double deep = pick(2) ? 1 : .4;
    double xy[8][2];
    for (int k = 0; k < n; k++) {
        const double t = FULL_TURN * (k + (pick(2) ? 0 : .3)) / n, d = size * (k & 1 ? deep : 1);
        xy[k][0] = x + d * cos(t), xy[k][1] = y + d * sin(t);
    }
    for (int k = 0; k < n; k++) {
        const int i = (from + (turned ? n - k : k)) % n;
        v[k] = put(r, xy[i][0], xy[i][1], 0);
    }
    return n;
}

/* Holes in the fields of a square, which are 1 apart: size 1.4 lets corners of neighbours meet. */
static void holed(solid_ref_t *r, int n) {
    int v[128], m = 0;
    const int fields = 1 + pick(3);
    const double half = fields / 2. + (pick(4) ? .1 : 0), z = uniform(-.5, .5);
    for (int k = 0; k < 3; k++) frame[3][k] += z * frame[2][k];
    const int from = pick(4);
    for (int k = 0; k < 4; k++) {
        const int i = (from + k) % 4;
        v[m++] = put(r, i == 1 || i == 2 ? half : -half, i > 1 ? half : -half, 0);
    }
    for (int k = 0; k < fields * fields && k < n + 1; k++) {
        if (pick(4) == 0) continue;
        const double x = k % fields - fields / 2. + .5, y = (double)(k / fields) - fields / 2. + .5;
        const int first = v[0];
        v[m++] = first;
        const int begin = m;
        if (pick(3) == 0) { /* a field, or a diamond in it, whose corners touch those of its neighbours */
            const double d = pick(2) ? .5 : .3;
            const int at = pick(4);
            const bool diamond = pick(2);
            for (int i = 0; i < 4; i++) {
                const double t = FULL_TURN / 4 * -((i + at) % 4) + (diamond ? 0 : FULL_TURN / 8);
                const double l = diamond ? d : d * .98;
                v[m++] = put(r, x + l * cos(t), y + l * sin(t), 0);
            }
        } else {
            m += around(r, v + m, x, y, .47, true);
        }
        v[m] = v[begin];
        m++;
    }
    solid_ref_face(r, v, m);
}

static void plates_with_holes(solid_ref_t *r, int n) {
    const int plates = 1 + pick(2);
    choose_frame(pick(3) > 0);
    for (int k = 0; k < plates; k++) {
        for (int i = 0; i < 3; i++) frame[3][i] = k * 2.4 * frame[2][i];
        holed(r, n);
        for (int i = 0; i < n; i++) { /* before, behind, and through the holes */
            const double x = uniform(-1.5, 1.5), y = uniform(-1.5, 1.5), u = uniform(-1.5, 1.5), w = uniform(-1.5, 1.5);
            solid_ref_line(r, put(r, x, y, uniform(-1, 1)), put(r, u, w, uniform(-1, 1)));
        }
        rectangle(r, -1.2, -.9, .8, 1.1, -.8);
    }
}

/* ---- order ---- */

/* Bars round a circle, each rising over the next; a smaller circle in it, turning the other way. */
static void circles(solid_ref_t *r, int n) {
    choose_frame(pick(2));
    double size = 1;
    const int circles = 1 + pick(2);
    for (int c = 0; c < circles; c++, size *= .45) {
        const int bars = 3 + pick(n + 4);
        const double rise = (c & 1 ? -1 : 1) * uniform(.05, .6), over = uniform(.15, .45), wide = uniform(.05, .28);
        for (int k = 0; k < bars; k++) {
            const double t = FULL_TURN * k / bars, u = FULL_TURN * (k + 1) / bars;
            double p[2][2] = {{cos(t), sin(t)}, {cos(u), sin(u)}};
            const double d[2] = {p[1][0] - p[0][0], p[1][1] - p[0][1]}, l = hypot(d[0], d[1]);
            int v[4];
            for (int i = 0; i < 4; i++) {
                const bool far = i == 1 || i == 2;
                const double side = (i < 2 ? 1 : -1) * wide * l / 2, along = far ? over : -over;
                v[i] = put(r, size * (p[far][0] + along * d[0] - side * d[1] / l),
                           size * (p[far][1] + along * d[1] + side * d[0] / l), size * rise * (far ? 1 : 0));
            }
            solid_ref_face(r, v, 4);
        }
    }
}

/* Slats in and out between each other. */
static void woven(solid_ref_t *r, int n) {
    choose_frame(pick(2));
    const int m = 2 + pick(n);
    const double wide = uniform(.1, .45), bow = uniform(.05, .3);
    for (int k = 0; k < m; k++)
        for (int across = 0; across < 2; across++)
            for (int i = 0; i < m; i++) { /* a piece of a slat from one crossing to the next */
                const double sign = (i + k + across) & 1 ? 1 : -1, mid = (k - (m - 1) / 2.);
                const double z0 = 0, z1 = sign * bow;
                const double a[3] = {i - m / 2., i - m / 2. + .5, i - m / 2. + 1}, h[3] = {z0, z1, z0};
                for (int part = 0; part < 2; part++) {
                    int v[4];
                    for (int c = 0; c < 4; c++) {
                        const int e = part + (c == 1 || c == 2);
                        const double s = mid + (c > 1 ? wide : -wide);
                        v[c] = across ? put(r, s, a[e], h[e]) : put(r, a[e], s, h[e]);
                    }
                    solid_ref_face(r, v, 4);
                }
            }
}

/* Plates in few planes, those in one overlapping in any way. */
static void coplanar(solid_ref_t *r, int n) {
    choose_frame(pick(2));
    const int planes = 1 + pick(3);
    const double apart = pow(10, uniform(-4, -.3));
    for (int k = 0; k < n + 2; k++) {
        const double z = apart * pick(planes), x = pick(5) / 2., y = pick(5) / 2.;
        if (pick(2)) {
            rectangle(r, x, y, x + (1 + pick(4)) / 2., y + (1 + pick(4)) / 2., z);
        } else {
            const double xy[3][2] = {{x, y}, {x + (1 + pick(4)) / 2., y}, {x + pick(4) / 2., y + 1}};
            plate(r, xy, 3, z);
        }
    }
}

/* Flights of steps side by side, walls flush, levels in common. */
static void terraces(solid_ref_t *r, int n) {
    choose_frame(pick(3) > 0);
    for (int k = 0; k < n + 1; k++) {
        const double x = k, deep = (1 + pick(3)) / 2.;
        const int steps = 1 + pick(4);
        for (int i = 0; i < steps; i++)
            box(r, x, i * deep, 0, x + (pick(4) ? 1 : .5), (i + 1) * deep, (1 + i + pick(2)) / 3.);
    }
}

/* From one to ten thousand: what is small lies on, before and behind what is large. */
static void sizes(solid_ref_t *r, int n) {
    choose_frame(pick(2));
    double size = 1;
    rectangle(r, -2, -2, 2, 2, 0);
    for (int k = 0; k < n + 2; k++) {
        const double x = uniform(-.5, .5), y = uniform(-.5, .5), z = size * uniform(.05, .5) * (pick(2) ? 1 : -1);
        if (pick(2))
            rectangle(r, x * size, y * size, (x + 1) * size, (y + 1) * size, z);
        else
            box(r, x * size, y * size, z > 0 ? 0 : z, (x + .7) * size, (y + .6) * size, z > 0 ? z : 0);
        size *= pow(10, uniform(-1, -.2));
    }
}

static void look(solid_scene_t *s, const char *name) {
    const solid_ref_t *r = &s->ref;
    const int kind = pick(6);
    s->set.view.from = kind < 3;
    if (kind < 3) { /* from before or behind the last plane, at any distance: never in the midst of things */
        const double d = kind == 2 ? pow(10, uniform(.9, 4)) : uniform(5, 9);
        const double a = uniform(0, FULL_TURN), h = uniform(-1, 1), w = sqrt(1 - h * h);
        const double at[3] = {d * w * cos(a), d * w * sin(a), d * h};
        for (int k = 0; k < 3; k++) s->set.view.eye[k] = num_of(at[k]);
        if (pick(4) == 0 && r->nf) { /* in the plane of a face */
            const int f = pick(r->nf), *c = r->corner + r->first[f];
            const exact_point_t *o = &r->vertex[c[0]], *p = &r->vertex[c[1]], *q = &r->vertex[c[2]];
            const double u = uniform(6, 9), v = uniform(6, 9);
            const double in[3] = {o->x + u * (p->x - o->x) + v * (q->x - o->x),
                                  o->y + u * (p->y - o->y) + v * (q->y - o->y),
                                  o->z + u * (p->z - o->z) + v * (q->z - o->z)};
            if (solid_scene_clearance(r, &(exact_point_t){in[0], in[1], in[2]}) > 2e-4)
                for (int k = 0; k < 3; k++) s->set.view.eye[k] = num_of(in[k]), s->in_plane = true;
        }
        snprintf(s->what, sizeof s->what, "%s, set view from %.17g,%.17g,%.17g", name, num_value(s->set.view.eye[0]),
                 num_value(s->set.view.eye[1]), num_value(s->set.view.eye[2]));
    } else {
        const double rx = kind == 3 ? 90 * pick(3) : uniform(0, 180), rz = kind == 3 ? 45 * pick(8) : uniform(0, 360);
        s->set.view.rot_x = num_of(rx);
        s->set.view.rot_z = num_of(rz);
        snprintf(s->what, sizeof s->what, "%s, set view %.17g,%.17g", name, rx, rz);
    }
}

void solid_scene_polygons(solid_scene_t *s, uint64_t seed, int objects) {
    static const struct {
        const char *name;
        void (*make)(solid_ref_t *r, int n);
    } kind[] = {{"holes", plates_with_holes}, {"circles", circles},   {"woven", woven},
                {"coplanar", coplanar},       {"terraces", terraces}, {"sizes", sizes}};
    rng = seed ^ 0x9017;
    for (int k = 0; k < 4; k++) scene_uniform(&rng);
    *s = (solid_scene_t){.lattice = true};
    settings_default(&s->set);
    const int k = pick(sizeof kind / sizeof *kind);
    kind[k].make(&s->ref, 1 + pick(objects));
    look(s, kind[k].name);
    solid_ref_finish(&s->ref);
}
