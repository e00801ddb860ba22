/* Surfaces and viewpoints that an outsider tries first: much in them coincides, is seen edge-on, or nearly so.
 *
 * RIDGELINE_CASES multiplies the count, RIDGELINE_SEED tries one. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>

#include "tests/oracle/families.h"

#define FIRST 10000000000u

/* A multiple of 2^-6 in [-n, n] / 64: sums and products of few of them are exact. */
static double lattice(uint64_t *rng, int n) {
    return (scene_below(rng, 2 * n + 1) - n) / 64.;
}

static void even_spacing(scene_t *s) {
    for (int i = 0; i < s->ref.nx; i++) s->ref.x[i] = .5 * i - 1;
    for (int j = 0; j < s->ref.ny; j++) s->ref.y[j] = .5 * j - 1;
}

static double eye_x(const scene_t *s, uint64_t *rng) {
    return s->ref.x[scene_below(rng, s->ref.nx)];
}
static double eye_y(const scene_t *s, uint64_t *rng) {
    return s->ref.y[scene_below(rng, s->ref.ny)];
}

/* One profile again and again, but for so little; seen along it, across it, or from anywhere. */
static void alike(scene_t *s, uint64_t *rng) {
    const double little = scene_below(rng, 4) ? family_log_uniform(rng, 1e-9, 1e-2) : 0;
    const bool rows = scene_below(rng, 2);
    double profile[16];
    for (int k = 0; k < 16; k++) profile[k] = scene_uniform(rng);
    for (int j = 0; j < s->ref.ny; j++)
        for (int i = 0; i < s->ref.nx; i++)
            *family_height(s, i, j) = profile[rows ? i : j] + little * (scene_uniform(rng) - .5);
    if (scene_below(rng, 2)) s->ref.eye = (exact_eye_t){!rows, rows, lattice(rng, 64), 0};
}

/* floor(): stairs with a riser in each few cells, the eye level with a tread or on the line of a riser. */
static void terraces(scene_t *s, uint64_t *rng) {
    const int kx = 1 + scene_below(rng, 4), ky = scene_below(rng, 4), high = 1 << scene_below(rng, 4);
    for (int j = 0; j < s->ref.ny; j++)
        for (int i = 0; i < s->ref.nx; i++)
            *family_height(s, i, j) = (floor(kx * s->ref.x[i]) + floor(ky * s->ref.y[j])) / high;
    if (scene_below(rng, 2)) s->ref.eye.z = *family_height(s, scene_below(rng, s->ref.nx), scene_below(rng, s->ref.ny));
    if (scene_below(rng, 2)) s->ref.eye.x = eye_x(s, rng);
}

/* A saddle whose two straight lines are level with the eye. */
static void saddle(scene_t *s, uint64_t *rng) {
    even_spacing(s);
    const double x = eye_x(s, rng), y = eye_y(s, rng), up = lattice(rng, 64);
    for (int j = 0; j < s->ref.ny; j++)
        for (int i = 0; i < s->ref.nx; i++) *family_height(s, i, j) = up + (s->ref.x[i] - x) * (s->ref.y[j] - y);
    s->ref.eye = scene_below(rng, 4) ? (exact_eye_t){lattice(rng, 640), 8 + lattice(rng, 64), up, 1}
                                     : (exact_eye_t){lattice(rng, 64), 1, 0, 0};
    if (scene_below(rng, 3) == 0) s->ref.eye.x = x;
}

/* Inside of what the surface encloses: a bowl, a valley, a tent, under its rim. */
static void hull(scene_t *s, uint64_t *rng) {
    const int kind = scene_below(rng, 3);
    const double k = family_log_uniform(rng, .1, 10);
    for (int j = 0; j < s->ref.ny; j++)
        for (int i = 0; i < s->ref.nx; i++) {
            const double x = s->ref.x[i], y = s->ref.y[j];
            *family_height(s, i, j) = k * (kind == 0 ? x * x + y * y : kind == 1 ? x * x : -fabs(x) - fabs(y));
        }
    double at[3];
    family_place(s, rng, at);
    s->ref.eye = (exact_eye_t){at[0], at[1], at[2] + (kind == 2 ? -1 : 1) * family_log_uniform(rng, 1e-3, 4) * k, 1};
    if (scene_below(rng, 3) == 0) s->ref.eye.x = eye_x(s, rng);
}

/* Straight down, or so nearly. */
static void down(scene_t *s, uint64_t *rng) {
    const double by = scene_below(rng, 4) ? family_log_uniform(rng, 1e-14, .1) : 0, turn = 7 * scene_uniform(rng);
    s->ref.eye = (exact_eye_t){by * cos(turn), by * sin(turn), scene_below(rng, 2) ? 1 : -1, 0};
    if (scene_below(rng, 2)) s->ref.eye.x = 0;
    if (scene_below(rng, 2)) return;
    double at[3];
    family_place(s, rng, at);
    s->ref.eye = (exact_eye_t){at[0] + by, at[1], at[2] + s->ref.eye.z * family_log_uniform(rng, 3, 1e5), 1};
}

/* Exactly over or under a vertex, or some point of an edge. */
static void over(scene_t *s, uint64_t *rng) {
    double at[3];
    do family_place(s, rng, at);
    while (at[0] != eye_x(s, rng) && at[1] != eye_y(s, rng));
    s->ref.eye =
        (exact_eye_t){at[0], at[1], at[2] + (scene_below(rng, 2) ? 1 : -1) * family_log_uniform(rng, 1e-3, 1e3), 1};
}

/* In the plane of a facet, on lattice points: a flat cell is seen as a line. */
static void in_facet(scene_t *s, uint64_t *rng) {
    even_spacing(s);
    for (int k = 0; k < s->ref.nx * s->ref.ny; k++) s->ref.z[k] = lattice(rng, 16);
    const int i = scene_below(rng, s->ref.nx - 1), j = scene_below(rng, s->ref.ny - 1);
    const double z = *family_height(s, i, j), dx = *family_height(s, i + 1, j) - z,
                 dy = *family_height(s, i, j + 1) - z;
    *family_height(s, i + 1, j + 1) = z + dx + dy;
    const double u = lattice(rng, 1024), v = scene_below(rng, 3) ? lattice(rng, 1024) : scene_below(rng, 2);
    s->ref.eye = (exact_eye_t){s->ref.x[i] + .5 * u, s->ref.y[j] + .5 * v, z + u * dx + v * dy, 1};
    if (scene_below(rng, 4) == 0) s->ref.eye = (exact_eye_t){.5 * u, .5 * v, u * dx + v * dy, 0};
    if (s->ref.eye.h == 0 && u == 0 && v == 0) s->ref.eye.x = 1;
}

/* On the line of an edge, beyond it: the edge is a point. */
static void end_on(scene_t *s, uint64_t *rng) {
    even_spacing(s);
    for (int k = 0; k < s->ref.nx * s->ref.ny; k++) s->ref.z[k] = lattice(rng, 16);
    const int i = scene_below(rng, s->ref.nx - 1), j = scene_below(rng, s->ref.ny - 1);
    const bool row = scene_below(rng, 2);
    const double z = *family_height(s, i, j), d = *family_height(s, i + row, j + !row) - z,
                 t = 1 + lattice(rng, 32) + 10;
    s->ref.eye = (exact_eye_t){s->ref.x[i] + row * .5 * t, s->ref.y[j] + !row * .5 * t, z + d * t, 1};
    if (scene_below(rng, 2)) s->ref.eye = (exact_eye_t){row, !row, 2 * d, 0};
}

/* Very long, very flat, or very tall, each by itself. */
static void aspect(scene_t *s, uint64_t *rng) {
    const double kx = family_log_uniform(rng, 1e-4, 1e4), kz = family_log_uniform(rng, 1e-6, 1e2);
    for (int i = 0; i < s->ref.nx; i++) s->ref.x[i] *= kx;
    for (int k = 0; k < s->ref.nx * s->ref.ny; k++) s->ref.z[k] *= kz;
    s->ref.eye.x *= kx, s->ref.eye.z *= scene_below(rng, 2) ? kz : 1;
    if (!s->ref.eye.h) s->ref.eye.x /= kx * kx; /* as much of the way is across in the picture */
}

/* Half of the vertices at the level of the eye. */
static void level(scene_t *s, uint64_t *rng) {
    const double z = lattice(rng, 64), rough = scene_below(rng, 2) ? family_log_uniform(rng, 1e-9, 1) : 1;
    for (int k = 0; k < s->ref.nx * s->ref.ny; k++)
        s->ref.z[k] = z + (scene_below(rng, 2) ? 0 : rough * (scene_uniform(rng) - .5));
    s->ref.eye.z = s->ref.eye.h ? z : 0;
}

/* Holes beside cliffs. */
static void holes_and_cliffs(scene_t *s, uint64_t *rng) {
    const double high = family_log_uniform(rng, .1, s->ref.eye.h ? 1e5 : 1e3);
    for (int k = 0; k < s->ref.nx * s->ref.ny; k++) s->ref.z[k] = high * (scene_below(rng, 3) - 1);
    family_holes(s, rng);
    if (scene_below(rng, 2)) s->ref.eye.x = eye_x(s, rng);
    if (scene_below(rng, 3) == 0 && s->ref.eye.h) s->ref.eye.z = high * (scene_below(rng, 3) - 1);
}

/* Symmetrical, and seen so: from the plane or the axis of symmetry. */
static void symmetrical(scene_t *s, uint64_t *rng) {
    const int nx = s->ref.nx, ny = s->ref.ny, kind = scene_below(rng, 3);
    even_spacing(s);
    for (int j = 0; j < ny; j++)
        for (int i = 0; i < nx; i++) {
            const int u = i < nx - 1 - i ? i : nx - 1 - i, v = j < ny - 1 - j ? j : ny - 1 - j;
            *family_height(s, i, j) = kind == 0 ? *family_height(s, u, j) : *family_height(s, u, v);
        }
    const double x = .5 * (s->ref.x[0] + s->ref.x[nx - 1]), y = .5 * (s->ref.y[0] + s->ref.y[ny - 1]);
    s->ref.eye = (exact_eye_t){x, kind == 2 ? y : 8 + lattice(rng, 64), 3 + lattice(rng, 320), 1};
    if (scene_below(rng, 3) == 0) s->ref.eye = (exact_eye_t){0, 1, lattice(rng, 64), 0};
}

/* Single points that stand out of a plain. */
static void needles(scene_t *s, uint64_t *rng) {
    const double high = family_log_uniform(rng, 1, 1e3);
    for (int k = 0; k < s->ref.nx * s->ref.ny; k++)
        s->ref.z[k] = scene_below(rng, 6) ? 0 : high * (scene_below(rng, 2) ? 1 : -scene_uniform(rng));
    if (scene_below(rng, 2)) s->ref.eye.z = s->ref.eye.h ? family_log_uniform(rng, 1e-3, 2) : 0;
}

/* All heights 0 or 1. */
static void binary(scene_t *s, uint64_t *rng) {
    for (int k = 0; k < s->ref.nx * s->ref.ny; k++) s->ref.z[k] = scene_below(rng, 2);
    if (scene_below(rng, 2)) even_spacing(s);
    if (scene_below(rng, 2)) s->ref.eye.x = eye_x(s, rng);
    if (scene_below(rng, 2)) s->ref.eye.z = scene_below(rng, 3) * .5;
}

static void alike_with_holes(scene_t *s, uint64_t *rng) {
    alike(s, rng);
    family_holes(s, rng);
}
static void terraces_with_holes(scene_t *s, uint64_t *rng) {
    terraces(s, rng);
    family_holes(s, rng);
}
static void binary_with_holes(scene_t *s, uint64_t *rng) {
    binary(s, rng);
    family_holes(s, rng);
}

static const family_t families[] = {
    {"alike", alike, false},
    {"terraces", terraces, false},
    {"saddles", saddle, false},
    {"in the hull", hull, false},
    {"straight down", down, false},
    {"exactly over", over, false},
    {"in a facet's plane", in_facet, false},
    {"edges end-on", end_on, false},
    {"aspect", aspect, false},
    {"level", level, false},
    {"holes and cliffs", holes_and_cliffs, true},
    {"symmetrical", symmetrical, false},
    {"needles", needles, false},
    {"0 or 1", binary, false},
    {"alike with holes", alike_with_holes, true},
    {"terraces with holes", terraces_with_holes, true},
    {"0 or 1 with holes", binary_with_holes, true},
};

static void test_families(void **state) {
    (void)state;
    assert_int_equal(families_run("test_awkward_random", families, sizeof families / sizeof *families, FIRST, 150), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_families)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
