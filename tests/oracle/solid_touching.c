/* solid_touching.c - bodies that touch; see solid_scenes.h. */
#include <math.h>

#include "tests/oracle/solid_build.h"

/* Sectors, each as high as it happens. */
static void wedges(solid_ref_t *r, int n) {
    const int around = n + 2 + solid_build_pick(3);
    for (int k = 0; k < n; k++) {
        double xy[3][2] = {{0, 0}};
        for (int i = 0; i < 2; i++) {
            xy[1 + i][0] = cos(SOLID_FULL_TURN * (k + i) / around);
            xy[1 + i][1] = sin(SOLID_FULL_TURN * (k + i) / around);
        }
        solid_build_prism(r, xy, 3, -solid_build_uniform(0, 1), solid_build_pick(2) ? 1 : solid_build_uniform(.1, 2));
    }
}

/* Boxes of six tetrahedra around a diagonal, some of which are missing. */
static void tetrahedra(solid_ref_t *r, int n) {
    static const int order[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    const double size[3] = {solid_build_uniform(.5, 2), solid_build_uniform(.5, 2), solid_build_uniform(.5, 2)};
    for (int k = 0; k < 2 * n; k++) {
        const int *o = order[k % 6];
        double at[3] = {(double)(k / 6), 0, 0};
        int v[4];
        if (solid_build_pick(4) == 0) continue;
        v[0] = solid_build_put(r, at[0] * size[0], at[1] * size[1], at[2] * size[2]);
        for (int i = 0; i < 3; i++) {
            at[o[i]] += 1;
            v[1 + i] = solid_build_put(r, at[0] * size[0], at[1] * size[1], at[2] * size[2]);
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
        const double s = 2. / (k + 1), off = solid_build_pick(2) ? 0 : 1 - s / 2;
        solid_build_box(r, off, solid_build_pick(2) ? 0 : 2 - s, 0, s, s, s);
    }
}

/* Boxes one on the other, edges of some over the middle of others; or into it, flush below and often in a side. */
static void stack(solid_ref_t *r, int n) {
    double z = 0;
    for (int k = 0; k < n; k++) {
        const double h = solid_build_pick(2) ? 1 : solid_build_uniform(.05, 1), x = solid_build_pick(5) / 4.,
                     y = solid_build_pick(5) / 4.;
        solid_build_box(r, x, y, z, 1 + solid_build_pick(3) / 2., 1 + solid_build_pick(3) / 2., h);
        z += solid_build_pick(4) ? h : 0;
    }
}

static void mirrored(solid_ref_t *r, int n) {
    for (int k = 0; k < n; k += 2) {
        double xy[6][2];
        const int m = 3 + solid_build_pick(4);
        const double x = 1.5 * k, h = solid_build_uniform(.2, 2);
        for (int i = 0; i < m; i++) {
            xy[i][0] = x + cos(SOLID_FULL_TURN * i / m);
            xy[i][1] = sin(SOLID_FULL_TURN * i / m);
        }
        solid_build_prism(r, xy, m, 0, h);
        solid_build_prism(r, xy, m, -h, 0);
    }
}

static void tips(solid_ref_t *r, int n) {
    for (int k = 0; k < n; k++) {
        const double a = SOLID_FULL_TURN * k / n, c = cos(a), s = sin(a), w = solid_build_uniform(.1, .5);
        const int tip = solid_build_put(r, 0, 0, 0);
        int v[4];
        for (int i = 0; i < 4; i++) {
            const double side = w * (i == 1 || i == 2 ? 1 : -1), up = w * (i > 1 ? 1 : -1);
            v[i] = solid_build_put(r, 2 * c - side * s, 2 * s + side * c, up);
        }
        solid_ref_face(r, v, 4);
        for (int i = 0; i < 4; i++) solid_ref_face(r, (int[]){v[(i + 1) % 4], v[i], tip}, 3);
    }
}

static void make(solid_scene_t *s, uint64_t seed, int objects, bool close) {
    static void (*const kind[])(solid_ref_t * r, int n) = {wedges, tetrahedra, nested, stack, mirrored, tips};
    solid_build_begin(s, seed);
    kind[solid_build_pick(sizeof kind / sizeof *kind)](&s->ref, 2 + solid_build_pick(objects));
    if (s->ref.nf == 0) solid_build_box(&s->ref, 0, 0, 0, 1, 1, 1);
    solid_build_end(s, "touching", close ? FROM_CLOSE : (enum solid_eye_place)solid_build_pick(PLACES));
}

void solid_scene_touching(solid_scene_t *s, uint64_t seed, int objects) {
    make(s, seed, objects, false);
}

void solid_scene_close(solid_scene_t *s, uint64_t seed, int objects) {
    make(s, seed, objects, true);
}
