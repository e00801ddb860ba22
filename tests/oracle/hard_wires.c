/* hard_wires.c - wire frames for haloes; see hard_solids.h. */
#include <math.h>

#include "tests/oracle/halo_scenes.h"
#include "tests/oracle/hard_solids.h"
#include "view/page.h"

#define MM ((double)LAT_PER_MM)
#define UP (1 << 20)

static halo_edge_t *out;
static int n;

/* In mm, and in units of depth. */
static void line(double x0, double y0, int32_t z0, double x1, double y1, int32_t z1) {
    out[n] = (halo_edge_t){{(int32_t)lround(MM * x0), (int32_t)lround(MM * y0), z0},
                           {(int32_t)lround(MM * x1), (int32_t)lround(MM * y1), z1},
                           n};
    n++;
}
/* Through (x, y) at an angle, z at both ends. */
static void through(double x, double y, double degrees, double half, int32_t z0, int32_t z1) {
    const double t = degrees / 57.29577951308232, c = half * cos(t), s = half * sin(t);
    line(x - c, y - s, z0, x + c, y + s, z1);
}

static void cubes(void) {
    halo_scene_cubes(out, 4);
    n = 12 * 16;
}
static void random_edges(void) {
    n = 300;
    halo_scene_random(out, n, .1);
}
static void star(void) { /* all meet in one vertex: none cuts another; a bar over them does */
    for (int k = 0; k < 24; k++) line(60, 60, UP, 60 + 50 * cos(.2618 * k), 60 + 50 * sin(.2618 * k), 2 * UP * (k & 1));
    line(20, 40, 4 * UP, 100, 45, 4 * UP);
}
static void coincident(void) {
    for (int k = 0; k < 6; k++) line(10 * k, 20 + 5. * (k / 2), k * UP, 60 + 10 * k, 20 + 5. * (k / 2), k * UP);
    for (int k = 0; k < 6; k++) line(10 + 18 * k, 10, 3 * UP - k, 10 + 18 * k, 40, 3 * UP - k);
}
static void near_parallel(void) {
    for (int k = 1; k <= 8; k++) {
        through(60, 12. * k, 0, 50, 0, 0);
        through(60, 12. * k, 3 * pow(.35, k), 50, UP, UP);
    }
}
static void in_contact(void) { /* pass each other by a few units of depth */
    for (int k = 0; k < 12; k++) line(10, 8. * k, 0, 110, 8. * k, 0);
    for (int k = 0; k < 12; k++) line(12 + 8. * k, -5, k - 5, 12 + 8. * k, 95, 5 - k);
}
static void at_ends(void) {
    for (int k = 0; k < 10; k++) {
        line(10 + 10 * k, 10, 0, 10 + 10 * k, 50, 0);
        line(5 + 10 * k, k & 1 ? 50 : 10, k & 2 ? UP : -UP, 10 + 10 * k, k & 1 ? 50 : 10,
             k & 2 ? UP : -UP);                         /* ends on it */
        line(10 + 10 * k, 30, UP, 16 + 10 * k, 30, UP); /* begins on it */
    }
}
static void end_on(void) {
    for (int k = 0; k < 10; k++) {
        line(10 + 10 * k, 30, 0, 10 + 10 * k, 30, 2 * UP); /* dots */
        line(5 + 10 * k, 25, UP, 15 + 10 * k, 35, UP);
    }
}
static void one_point(void) {
    for (int k = 0; k < 24; k++) through(60, 60, 7.5 * k, 55, UP * (k * 7 % 24), UP * (k * 7 % 24));
}
static void steep(void) { /* which is nearer on the whole is not which is nearer where they cross */
    for (int k = 0; k < 10; k++) {
        line(10, 5 + 10 * k, 6 * UP, 110, 8 + 10 * k, -5 * UP);
        line(12 + 10 * k, 0, 0, 12 + 10 * k, 105, 0);
    }
}
static void three(void) {
    for (int k = 0; k < 3; k++) {
        const double t = 2.0944 * k, u = 2.0944 * (k + 1.4);
        line(60 + 50 * cos(t), 60 + 50 * sin(t), 0, 60 + 50 * cos(u), 60 + 50 * sin(u), 3 * UP);
    }
}
static void tiny(void) { /* from 1/3 of a step down to single units */
    for (int k = 0; k < 200; k++) {
        const double size = .004 * pow(.96, k), x = 10 + .05 * (k % 20), y = 10 + .05 * (k / 20);
        line(x, y, UP, x + size, y + size * (k % 3 - 1), UP);
        line(x, y - size, 2 * UP, x + size / 2, y + size, 0);
    }
}
static void wide(void) {
    for (int k = 0; k < 40; k++) through(20 + 2 * (k % 8), 20 + 2 * (k / 8), 40 * k, 1.5, UP * k, UP * k);
}
static void lattice(void) {
    for (int k = 0; k < 12; k++) {
        line(10, 10 + 8 * k, UP * (k % 3), 98, 10 + 8 * k, UP * (k % 3));
        line(10 + 8 * k, 10, UP * ((k + 1) % 3), 10 + 8 * k, 98, UP * ((k + 1) % 3));
        if (k < 11) line(10 + 8 * k, 10 + 8 * k, 4 * UP, 18 + 8 * k, 18 + 8 * k, 4 * UP); /* vertex to vertex */
    }
}

static const struct {
    const char *name;
    void (*make)(void);
    double width_mm;
} list[] = {
    {"4x4 cubes (figure 4)", cubes, .4},         {"random edges", random_edges, .42},
    {"edges that meet in a vertex", star, 1},    {"exactly coincident edges", coincident, 1},
    {"near-parallel edges", near_parallel, .5},  {"in contact: a few units of depth apart", in_contact, 1},
    {"crossings at ends", at_ends, 1},           {"edges seen end-on", end_on, 1},
    {"24 lines through a point", one_point, .5}, {"order turns along the edge", steep, 1},
    {"three that overlap cyclically", three, 2}, {"edges below a step", tiny, .002},
    {"haloes wider than edges", wide, 3},        {"crossings at vertices of a lattice", lattice, .8},
};

int hard_wires_count(void) {
    return (int)(sizeof list / sizeof *list);
}

const char *hard_wires_name(int i) {
    return list[i].name;
}

int hard_wires_build(int i, halo_edge_t edge[HARD_WIRES_EDGES], int32_t *width) {
    out = edge;
    n = 0;
    list[i].make();
    *width = (int32_t)lround(list[i].width_mm * MM);
    return n;
}
