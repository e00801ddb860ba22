/* The list, and how an entry becomes a scene. */
#include "tests/oracle/hard_solids.h"

#include <math.h>
#include <stdio.h>

#include "tests/oracle/num_of.h"

#define TURN 6.283185307179586

static void polygon(solid_ref_t *r, const double (*p)[3], int n) {
    int v[16];
    for (int k = 0; k < n; k++) v[k] = solid_ref_vertex(r, p[k][0], p[k][1], p[k][2]);
    solid_ref_face(r, v, n);
}

static void box(solid_ref_t *r, double x, double y, double z, double a, double b, double c) {
    static const int side[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    int v[8];
    for (int k = 0; k < 8; k++) v[k] = solid_ref_vertex(r, k & 1 ? x + a : x, k & 2 ? y + b : y, k & 4 ? z + c : z);
    for (int k = 0; k < 6; k++) {
        const int f[4] = {v[side[k][0]], v[side[k][1]], v[side[k][2]], v[side[k][3]]};
        solid_ref_face(r, f, 4);
    }
}

static void cubes(solid_ref_t *r) {
    solid_body_cubes(r, 4);
}
static void many_cubes(solid_ref_t *r) {
    solid_body_cubes(r, 14);
}
static void one_box(solid_ref_t *r) {
    box(r, -1, -1, -1, 2, 2, 2);
}
static void flush(solid_ref_t *r) {
    box(r, 0, 0, 0, 3, 1, 1);
    box(r, 1, 0, 1, 1, 1, 1);
    box(r, 2, 0, 1, 1.5, 1, 0.5);
    box(r, -2, 0.25, 0, 2, 0.75, 2);
    box(r, 0, 1, 0, 2.5, 1, 1.5);
    box(r, 0, 2.5, 0, 3, 0.5, 3);
}
static void lattice(solid_ref_t *r) {
    for (int k = 0; k < 27; k++)
        if ((k % 3 + k / 3 % 3 + k / 9) & 1) box(r, k % 3, k / 3 % 3, k / 9, 1, 1, 1);
}
static void one_plane(solid_ref_t *r) {
    static const double a[][3] = {{0, 0, 1}, {3, 0, 2.5}, {3, 3, 4}, {0, 3, 2.5}},
                        b[][3] = {{1, 1, 2}, {4, 2, 4}, {1, 4, 3.5}}, c[][3] = {{2, -1, 0}, {3, 5, 0}, {-1, 4, 0}};
    polygon(r, a, 4);
    polygon(r, b, 3);
    polygon(r, a, 4); /* there twice */
    polygon(r, c, 3);
}
static void brackets(solid_ref_t *r) {
    static const double a[][3] = {{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {1, 1, 0},
                                  {1, 3, 0}, {4, 3, 0}, {4, 4, 0}, {0, 4, 0}};
    double b[8][3];
    for (int k = 0; k < 8; k++) {
        b[k][0] = 6.5 - a[k][0];
        b[k][1] = a[k][1] + 0.3;
        b[k][2] = (b[k][1] - 2) * 0.4;
    }
    polygon(r, a, 8);
    polygon(r, (const double(*)[3])b, 8);
}
static void bars(solid_ref_t *r) {
    enum { N = 9 };
    for (int k = 0; k < N; k++) {
        const double t = TURN * k / N, u = TURN * (k + 1.6) / N, w = .07;
        const double way[2] = {cos(u) - cos(t), sin(u) - sin(t)}, l = hypot(way[0], way[1]);
        const double side[2] = {-w * way[1] / l, w * way[0] / l};
        const double q[4][3] = {{cos(t) - side[0], sin(t) - side[1], 0},
                                {cos(u) - side[0], sin(u) - side[1], .4},
                                {cos(u) + side[0], sin(u) + side[1], .4},
                                {cos(t) + side[0], sin(t) + side[1], 0}};
        polygon(r, q, 4);
    }
}
static void penetrating(solid_ref_t *r) {
    box(r, -1, -1, -1, 2, 2, 2);
    box(r, -2, -.43, -.37, 4.1, .81, .77);
    box(r, -.31, -.29, -2, .7, .66, 4.3);
}
static void slivers(solid_ref_t *r) {
    for (int k = 0; k < 24; k++) {
        const double t = 0.26 * k, w = pow(10, -1 - k % 4);
        const double p[3][3] = {{0.1 * cos(t), 0.1 * sin(t), 0.02 * k},
                                {2 * cos(t), 2 * sin(t), 1 + 0.02 * k},
                                {2 * cos(t + w), 2 * sin(t + w), 1.01 + 0.02 * k}};
        polygon(r, p, 3);
    }
}
static void needles(solid_ref_t *r) {
    for (int k = 0; k < 12; k++) {
        const double t = 0.52 * k, x = 1.1 * cos(t), y = 1.1 * sin(t), z = 0.3 * (k % 3) - 0.3;
        const double p[3][3] = {{3 * x, 3 * y, z}, {-2 * x, y, z + 0.001}, {-2 * x, y + 0.01, z + 0.02}};
        polygon(r, p, 3);
    }
}
static void needle(solid_ref_t *r) {
    box(r, 0.78130257267132908, -2.3769730647190506, 0.63550474263457746, 0.0017, 0.0017512, 2.69);
}
static void plates(solid_ref_t *r) {
    for (int k = 0; k < 10; k++) box(r, .1 * k, .07 * k, 2e-4 * k, 2, 2, 1e-4);
}
static void billionth(solid_ref_t *r) {
    static const double a[][3] = {{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}};
    double b[4][3];
    for (int k = 0; k < 4; k++) b[k][0] = a[k][0] + .3, b[k][1] = a[k][1] + .4, b[k][2] = 1 - 1e-9;
    polygon(r, a, 4);
    polygon(r, (const double(*)[3])b, 4);
}
static void twisted(solid_ref_t *r) {
    enum { N = 8 };
    for (int k = 0; k < N; k++) {
        double q[4][3];
        for (int i = 0; i < 4; i++) {
            const double t = TURN * (k + (i == 1 || i == 2)) / N;
            q[i][0] = cos(t), q[i][1] = sin(t), q[i][2] = (i > 1) + .25 * ((k + i) & 1);
        }
        polygon(r, (const double(*)[3])q, 4);
    }
}
/* A square with a window, joined to its outline by a cut gone along both ways, before and behind other things. */
static void window(solid_ref_t *r) {
    static const double at[][2] = {{0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 0}, {2, 2}, {2, 6}, {6, 6}, {6, 2}, {2, 2}},
                        back[][3] = {{-1, 1, -2}, {9, 2, -1.5}, {8, 7, -1.6}, {0, 6, -2}};
    int v[10];
    for (int k = 0; k < 10; k++)
        v[k] = k == 4 ? v[0] : k == 9 ? v[5] : solid_ref_vertex(r, at[k][0], at[k][1], .2 * at[k][0]);
    solid_ref_face(r, v, 10);
    polygon(r, back, 4);
    box(r, 2.4, 2.3, -1, .5, .5, 4);
}
static void angles(solid_ref_t *r) {
    solid_body_angles(r, 3);
}
static void large_and_small(solid_ref_t *r) {
    box(r, -5e5, -5e5, -1e6, 1e6, 1e6, 1e6);
    for (int k = 0; k < 5; k++) box(r, 1e5 * k - 2e5, 1e5 * k - 2e5, 0, k < 3 ? 1 : 5e4, 7e4, 4e4);
}
static void millionth(solid_ref_t *r) {
    for (int k = 0; k < 4; k++) box(r, 1.5e-6 * (k & 1), 1.5e-6 * (k >> 1), 0, 1e-6, 1e-6, 1e-6);
}
static void broken(solid_ref_t *r) {
    static const double line[][3] = {{0, 0, 2}, {1, 1, 2}, {2, 2, 2}},
                        q[][3] = {{0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}};
    polygon(r, line, 3); /* without an area */
    polygon(r, q, 4);
    polygon(r, q, 4);
    box(r, .5, .5, -1, 1, 1, 1);
    const int a = solid_ref_vertex(r, -1, 1, .5), b = solid_ref_vertex(r, 3, 1, .5);
    solid_ref_face(r, (int[]){a, b, b, a}, 4);
    solid_ref_line(r, a, b);
}
static void open_sides(solid_ref_t *r) {
    static const double lid[][3] = {{-1, -1, 1}, {1, -1, 1}, {1, .2, 1.8}, {-1, .2, 1.8}},
                        side[][4][3] = {{{-1, -1, -1}, {1, -1, -1}, {1, -1, 1}, {-1, -1, 1}},
                                        {{1, -1, -1}, {1, 1, -1}, {1, 1, 1}, {1, -1, 1}},
                                        {{-1, 1, -1}, {-1, -1, -1}, {-1, -1, 1}, {-1, 1, 1}},
                                        {{-1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {1, -1, -1}}};
    for (int k = 0; k < 4; k++) polygon(r, side[k], 4);
    polygon(r, lid, 4);
}
static void fan(solid_ref_t *r) {
    for (int k = 0; k < 12; k++) {
        const double t = 1e-6 * k * k;
        const double p[3][3] = {
            {0, .1 * k, .05 * k}, {3 * cos(t), .1 * k + 3 * sin(t), .05 * k}, {1.5, 1 + .1 * k, 1 + .05 * k}};
        polygon(r, p, 3);
    }
}
static void segment(solid_ref_t *r) {
    solid_ref_line(r, solid_ref_vertex(r, 0, 0, 0), solid_ref_vertex(r, 1, 2, 3));
    solid_ref_line(r, solid_ref_vertex(r, 1, 0, 1), solid_ref_vertex(r, 0, 2, 1));
}

static const struct {
    const char *name;
    void (*make)(solid_ref_t *r);
    bool from; /* the eye; or gnuplot's angles */
    double at[3];
    int every;
} list[] = {
    /* Where the viewer stands. */
    {"4x4 cubes", cubes, false, {65, 30, 0}, 0},
    {"viewer in planes of faces", cubes, true, {2.5, -6, 1}, 0},
    {"viewer on the line of an edge", cubes, true, {-4, 1, 1}, 0},
    {"viewer over a vertex", cubes, true, {1, 1, 4}, 0},
    {"viewer 1e6 away", cubes, true, {6e5, -8e5, 3e5}, 0},
    {"viewer 1e-3 from a face", flush, true, {3.501, .4, 1.2}, 0},
    {"viewer inside of a closed box", one_box, true, {.3, .2, .1}, 0},
    {"viewer among flush walls", flush, true, {1.7, 2.2, .7}, 0},
    {"everything behind or beside the viewer", needles, true, {.8, .1, .2}, 0},
    /* What coincides. */
    {"faces exactly edge-on", cubes, false, {90, 0, 0}, 0},
    {"exactly coincident edges, from above", cubes, false, {0, 0, 0}, 0},
    {"crossings at vertices, isometric lattice", lattice, false, {54.735610317245346, 45, 0}, 0},
    {"faces that touch: flush walls", flush, false, {60, 40, 0}, 0},
    {"faces in one plane, one there twice", one_plane, false, {40, 70, 0}, 0},
    {"planes 1e-9 apart", billionth, false, {50, 20, 0}, 0},
    {"near-parallel edges", fan, false, {55, 15, 0}, 0},
    /* Order. */
    {"two that overlap cyclically", brackets, false, {20, 10, 0}, 0},
    {"nine that overlap cyclically", bars, false, {25, 0, 0}, 0},
    {"bodies that penetrate", penetrating, false, {60, 30, 0}, 0},
    /* Shapes. */
    {"slivers below a step", slivers, false, {50, 30, 0}, 0},
    {"a needle from its end", needle, false, {2, 100, 0}, 0},
    {"plates thinner than a step", plates, false, {75, 35, 0}, 0},
    {"twisted quads", twisted, false, {65, 20, 0}, 0},
    {"concave, with a window", window, false, {30, 20, 0}, 0},
    {"concave prisms", angles, false, {60, 30, 0}, 0},
    {"open: a box without walls", open_sides, false, {60, 30, 0}, 0},
    {"broken: no area, there twice, a corner twice", broken, false, {60, 30, 0}, 0},
    /* Sizes. */
    {"1e6 and 1 in one scene", large_and_small, false, {60, 30, 0}, 0},
    {"a world of 1e-6", millionth, false, {60, 30, 0}, 0},
    {"segments alone", segment, false, {60, 30, 0}, 0},
    {"14x14 cubes, some edges judged", many_cubes, false, {65, 30, 0}, 61},
};

int hard_solids_count(void) {
    return (int)(sizeof list / sizeof *list);
}

const char *hard_solids_name(int i) {
    return list[i].name;
}

int hard_solids_build(int i, solid_scene_t *s) {
    const double *at = list[i].at;
    *s = (solid_scene_t){0};
    settings_default(&s->set);
    list[i].make(&s->ref);
    solid_ref_finish(&s->ref);
    s->set.view.from = list[i].from;
    for (int k = 0; k < 3; k++) s->set.view.eye[k] = num_of(at[k]);
    s->set.view.rot_x = num_of(at[0]);
    s->set.view.rot_z = num_of(at[1]);
    if (list[i].from)
        snprintf(s->what, sizeof s->what, "%s (eye %g,%g,%g)", list[i].name, at[0], at[1], at[2]);
    else
        snprintf(s->what, sizeof s->what, "%s (view %g,%g)", list[i].name, at[0], at[1]);
    return list[i].every;
}
