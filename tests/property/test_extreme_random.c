/* Surfaces and viewpoints at the ends of what is possible, by families: the others' random scenes, pushed there.
 *
 * RIDGELINE_CASES multiplies the count, RIDGELINE_SEED tries one. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>

#include "tests/oracle/families.h"

#define FIRST 9000000000u

#define HIGHEST 1e6

/* Heights up to 10^(1..6) times the base, most of them low, as 1/(x*x+y*y) has them; the eye near the foot. */
static void tall(scene_t *s, uint64_t *rng) {
    const double most = family_log_uniform(rng, 10, HIGHEST), side = scene_below(rng, 2) ? 1 : -1;
    for (int k = 0; k < s->ref.nx * s->ref.ny; k++) {
        double z = family_log_uniform(rng, 1e-3, most);
        s->ref.z[k] = scene_below(rng, 3) ? fmod(z, 1) : z * (scene_below(rng, 4) ? 1 : side);
    }
    if (scene_below(rng, 3) == 0) return;
    double at[3];
    family_place(s, rng, at);
    s->ref.eye =
        (exact_eye_t){at[0], at[1], at[2] + (scene_uniform(rng) < .5 ? -1 : 1) * family_log_uniform(rng, .01, 3), 1};
    if (scene_below(rng, 2)) s->ref.eye.y = 2 + family_log_uniform(rng, .02, 10);
}

/* 10^-3 over or under the surface, or less. */
static void skimming(scene_t *s, uint64_t *rng) {
    double at[3];
    family_place(s, rng, at);
    s->ref.eye =
        (exact_eye_t){at[0], at[1], at[2] + (scene_below(rng, 2) ? -1 : 1) * family_log_uniform(rng, 1e-4, 1e-3), 1};
}

static void far_away(scene_t *s, uint64_t *rng) {
    const double d = family_log_uniform(rng, 1e4, 1e6);
    s->ref.eye = (exact_eye_t){d * (scene_uniform(rng) - .5), d, d * (scene_uniform(rng) - .3), 1};
    if (scene_below(rng, 2)) s->ref.eye.x = s->ref.x[scene_below(rng, s->ref.nx)];
}

/* An eye that was over the border is over it again, however the stretched lines were rounded. */
static void snap(scene_t *s) {
    exact_eye_t *e = &s->ref.eye;
    for (int k = 0; k < 2; k++) {
        const double x = s->ref.x[k ? s->ref.nx - 1 : 0], y = s->ref.y[k ? s->ref.ny - 1 : 0];
        if (e->h && fabs(e->x - x) < 1e-12) e->x = x;
        if (e->h && fabs(e->y - y) < 1e-12) e->y = y;
    }
}

/* Everything in other units. */
static void rescale(scene_t *s, double kx, double ky, double kz) {
    for (int i = 0; i < s->ref.nx; i++) s->ref.x[i] *= kx;
    for (int j = 0; j < s->ref.ny; j++) s->ref.y[j] *= ky;
    for (int k = 0; k < s->ref.nx * s->ref.ny; k++) s->ref.z[k] *= kz;
    s->ref.eye.x *= kx, s->ref.eye.y *= ky, s->ref.eye.z *= kz;
}

/* Heights of few levels, so that much coincides, from directions that make more coincide. */
static void lattice(scene_t *s, uint64_t *rng) {
    static const double cell = 4.0 / 8;
    const int levels = 1 + scene_below(rng, 4);
    for (int i = 0; i < s->ref.nx; i++) s->ref.x[i] = cell * i;
    for (int j = 0; j < s->ref.ny; j++) s->ref.y[j] = cell * j;
    for (int k = 0; k < s->ref.nx * s->ref.ny; k++) s->ref.z[k] = cell * scene_below(rng, levels + 1);
    double dx = scene_below(rng, 3) - 1, dy = scene_below(rng, 3) - 1;
    s->ref.eye = (exact_eye_t){dx, dx == 0 && dy == 0 ? 1 : dy, scene_below(rng, 5) - 2, 0};
    if (scene_below(rng, 2)) s->ref.eye.x *= 10, s->ref.eye.y *= 10, s->ref.eye.z *= cell, s->ref.eye.h = 1;
}

/* Differences of 10^-9 on a level that the eye may share. */
static void billionths(scene_t *s, uint64_t *rng) {
    for (int k = 0; k < s->ref.nx * s->ref.ny; k++) s->ref.z[k] = 1 + 1e-9 * scene_below(rng, 3);
    if (scene_below(rng, 2)) s->ref.eye.z = s->ref.eye.h ? 1 : 0;
}

static void cliffs(scene_t *s, uint64_t *rng) {
    for (int k = 0; k < s->ref.nx * s->ref.ny; k++) s->ref.z[k] = 1e4 * (scene_below(rng, 3) - 1);
    if (s->ref.eye.h && scene_below(rng, 2)) s->ref.eye.z *= 1e4;
}

/* What people type that grows out of bounds: the heights are as steep as the functions are. */
static double steep_function(int which, double x, double y) {
    switch (which) {
    case 0:
        return pow(x, 9);
    case 1:
        return exp(3 * x * y);
    case 2:
        return 1 / (x * x + y * y);
    case 3:
        return tan(x + .5 * y);
    case 4:
        return log(x * x + y * y);
    case 5:
        return floor(2 * x) * floor(3 * y);
    case 6:
        return x * y / (x * x - y * y);
    default:
        return exp(x) * sin(5 * y) + 1e3 * (x * x < .1);
    }
}

static void steep(scene_t *s, uint64_t *rng) {
    const int which = scene_below(rng, 8);
    const double kx = family_log_uniform(rng, .5, 3), ky = family_log_uniform(rng, .5, 3),
                 most = family_log_uniform(rng, 1e2, HIGHEST);
    for (int j = 0; j < s->ref.ny; j++)
        for (int i = 0; i < s->ref.nx; i++) {
            double z = steep_function(which, kx * s->ref.x[i], ky * s->ref.y[j]);
            if (!(z < most)) z = most; /* a pole, or 0 / 0 */
            *family_height(s, i, j) = z < -most ? -most : z;
        }
}

/* Levels a million apart, exactly or nearly. */
static void high_cliffs(scene_t *s, uint64_t *rng) {
    const double high = HIGHEST * family_log_uniform(rng, 1e-2, 1);
    const double rough = scene_below(rng, 2) ? family_log_uniform(rng, 1e-9, 1) : 0;
    for (int k = 0; k < s->ref.nx * s->ref.ny; k++) {
        s->ref.z[k] = high * (scene_below(rng, 3) - 1) + rough * scene_uniform(rng);
    }
    if (s->ref.eye.h && scene_below(rng, 2)) s->ref.eye.z *= high;
}

/* One extreme height, one extreme grid, one extreme eye. */
static void mixed(scene_t *s, uint64_t *rng) {
    static void (*const shape[])(scene_t * s, uint64_t * rng) = {tall, high_cliffs, steep, billionths, cliffs};
    const int heights = scene_below(rng, 7), eye = scene_below(rng, 5);
    if (scene_below(rng, 2)) {
        scene_stretch(s, family_log_uniform(rng, 10, 1e4), rng);
        snap(s);
    }
    if (heights < 5) shape[heights](s, rng);
    if (eye == 0) skimming(s, rng);
    if (eye == 1) far_away(s, rng);
    if (eye == 2) { /* in a plane of the grid, or almost */
        s->ref.eye.x = s->ref.x[scene_below(rng, s->ref.nx)];
        if (scene_below(rng, 2)) s->ref.eye.x += family_log_uniform(rng, 1e-12, 1e-3);
    }
    if (eye == 3) {
        double at[3];
        family_place(s, rng, at);
        s->ref.eye = (exact_eye_t){at[0], at[1], at[2] + family_log_uniform(rng, 1e-3, 10), 1};
        if (scene_below(rng, 2)) s->ref.eye.y = 2 + family_log_uniform(rng, 1e-3, 10);
    }
}

static void billionfold(scene_t *s, uint64_t *rng) {
    (void)rng;
    rescale(s, 1e9, 1e9, 1e9);
}
static void billionth(scene_t *s, uint64_t *rng) {
    (void)rng;
    rescale(s, 1e-9, 1e-9, 1e-9);
}
static void wide(scene_t *s, uint64_t *rng) {
    rescale(s, family_log_uniform(rng, 1, 1e3), 1, family_log_uniform(rng, .1, 100));
}
static void stretched(scene_t *s, uint64_t *rng) {
    scene_stretch(s, 1e4, rng);
    snap(s);
}
static void tall_with_holes(scene_t *s, uint64_t *rng) {
    tall(s, rng);
    family_holes(s, rng);
}
static void mixed_with_holes(scene_t *s, uint64_t *rng) {
    mixed(s, rng);
    family_holes(s, rng);
}

static const family_t families[] = {
    {"tall", tall, false},
    {"skimming", skimming, false},
    {"far", far_away, false},
    {"cells 1e-4 to 1", stretched, false},
    {"x1e9", billionfold, false},
    {"x1e-9", billionth, false},
    {"wide", wide, false},
    {"lattice", lattice, false},
    {"1e-9", billionths, false},
    {"cliffs", cliffs, false},
    {"holes", family_holes, true},
    {"tall with holes", tall_with_holes, true},
    {"cliffs of 1e6", high_cliffs, false},
    {"steep functions", steep, false},
    {"mixed", mixed, false},
    {"mixed with holes", mixed_with_holes, true},
};

static void test_families(void **state) {
    (void)state;
    assert_int_equal(families_run("test_extreme_random", families, sizeof families / sizeof *families, FIRST, 300), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_families)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
