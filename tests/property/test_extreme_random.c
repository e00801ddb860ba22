/* Surfaces and viewpoints at the ends of what is possible, by families: the others' random scenes, pushed there.
 *
 * RIDGELINE_CASES multiplies the count, RIDGELINE_SEED tries one. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "tests/oracle/run_cases.h"

#define FIRST 9000000000u
#define FAMILIES 16

static double log_uniform(uint64_t *rng, double lo, double hi) {
    return lo * pow(hi / lo, scene_uniform(rng));
}

static double *height(const scene_t *s, int i, int j) {
    return &s->ref.z[j * s->ref.nx + i];
}

/* Somewhere in the rectangle: a vertex, a place on a grid line, or any. */
static void place(const scene_t *s, uint64_t *rng, double at[3]) {
    const surface_ref_t *r = &s->ref;
    int i = scene_below(rng, r->nx - 1), j = scene_below(rng, r->ny - 1), kind = scene_below(rng, 3);
    double u = kind > 0 ? scene_uniform(rng) : 0, v = kind > 1 ? scene_uniform(rng) : 0;
    at[0] = r->x[i] + u * (r->x[i + 1] - r->x[i]);
    at[1] = r->y[j] + v * (r->y[j + 1] - r->y[j]);
    at[2] = (1 - v) * ((1 - u) * *height(s, i, j) + u * *height(s, i + 1, j)) +
            v * ((1 - u) * *height(s, i, j + 1) + u * *height(s, i + 1, j + 1));
}

/* A parallel view of more would be no wider than a step. */
static double highest(const scene_t *s) {
    return s->ref.eye.h ? 1e6 : 1e3;
}

/* Heights up to 10^(1..6) times the base, most of them low, as 1/(x*x+y*y) has them; the eye near the foot. */
static void tall(scene_t *s, uint64_t *rng) {
    const double most = log_uniform(rng, 10, highest(s)), side = scene_below(rng, 2) ? 1 : -1;
    for (int k = 0; k < s->ref.nx * s->ref.ny; k++) {
        double z = log_uniform(rng, 1e-3, most);
        s->ref.z[k] = scene_below(rng, 3) ? fmod(z, 1) : z * (scene_below(rng, 4) ? 1 : side);
    }
    if (scene_below(rng, 3) == 0) return;
    double at[3];
    place(s, rng, at);
    s->ref.eye = (exact_eye_t){at[0], at[1], at[2] + (scene_uniform(rng) < .5 ? -1 : 1) * log_uniform(rng, .01, 3), 1};
    if (scene_below(rng, 2)) s->ref.eye.y = 2 + log_uniform(rng, .02, 10);
}

/* 10^-3 over or under the surface. */
static void skimming(scene_t *s, uint64_t *rng) {
    double at[3];
    place(s, rng, at);
    s->ref.eye = (exact_eye_t){at[0], at[1], at[2] + (scene_below(rng, 2) ? -1e-3 : 1e-3), 1};
}

static void far_away(scene_t *s, uint64_t *rng) {
    const double d = log_uniform(rng, 1e4, 1e6);
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

/* A hole that is a half-plane, a ring, a checkerboard, or spots. */
static void holes(scene_t *s, uint64_t *rng) {
    const int kind = scene_below(rng, 4), cut = scene_below(rng, 5);
    const surface_ref_t *r = &s->ref;
    if (r->hole == NULL) return;
    for (int j = 0; j < r->ny; j++)
        for (int i = 0; i < r->nx; i++) {
            int d = (int)hypot(i - r->nx / 2, j - r->ny / 2);
            r->hole[j * r->nx + i] = (unsigned char)(kind == 0   ? i + j < cut + 1
                                                     : kind == 1 ? d < 1 || d > 1 + cut
                                                     : kind == 2 ? ((i / 2 + j / 2) & 1) != 0
                                                                 : scene_below(rng, 6) == 0);
        }
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
    const double kx = log_uniform(rng, .5, 3), ky = log_uniform(rng, .5, 3), most = log_uniform(rng, 1e2, highest(s));
    for (int j = 0; j < s->ref.ny; j++)
        for (int i = 0; i < s->ref.nx; i++) {
            double z = steep_function(which, kx * s->ref.x[i], ky * s->ref.y[j]);
            if (!(z < most)) z = most; /* a pole, or 0 / 0 */
            *height(s, i, j) = z < -most ? -most : z;
        }
}

/* Levels a million apart, exactly or nearly. */
static void high_cliffs(scene_t *s, uint64_t *rng) {
    const double high = highest(s) * log_uniform(rng, 1e-2, 1);
    const double rough = scene_below(rng, 2) ? log_uniform(rng, 1e-9, 1) : 0;
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
        scene_stretch(s, log_uniform(rng, 10, 1e4), rng);
        snap(s);
    }
    if (heights < 5) shape[heights](s, rng);
    if (eye == 0) skimming(s, rng);
    if (eye == 1) far_away(s, rng);
    if (eye == 2) { /* in a plane of the grid, or almost */
        s->ref.eye.x = s->ref.x[scene_below(rng, s->ref.nx)];
        if (scene_below(rng, 2)) s->ref.eye.x += log_uniform(rng, 1e-12, 1e-3);
    }
    if (eye == 3) {
        double at[3];
        place(s, rng, at);
        s->ref.eye = (exact_eye_t){at[0], at[1], at[2] + log_uniform(rng, 1e-3, 10), 1};
        if (scene_below(rng, 2)) s->ref.eye.y = 2 + log_uniform(rng, 1e-3, 10);
    }
}

/* A family: its name in front of the figures, and how a random scene is pushed there; holes: it may have some. */
typedef struct family {
    const char *name;
    void (*push)(scene_t *s, uint64_t *rng);
    bool holes;
} family_t;

static void billionfold(scene_t *s, uint64_t *rng) {
    (void)rng;
    rescale(s, 1e9, 1e9, 1e9);
}
static void billionth(scene_t *s, uint64_t *rng) {
    (void)rng;
    rescale(s, 1e-9, 1e-9, 1e-9);
}
static void wide(scene_t *s, uint64_t *rng) {
    rescale(s, log_uniform(rng, 1, 1e3), 1, log_uniform(rng, .1, 100));
}
static void stretched(scene_t *s, uint64_t *rng) {
    scene_stretch(s, 1e4, rng);
    snap(s);
}
static void tall_with_holes(scene_t *s, uint64_t *rng) {
    tall(s, rng);
    holes(s, rng);
}
static void mixed_with_holes(scene_t *s, uint64_t *rng) {
    mixed(s, rng);
    holes(s, rng);
}

static const family_t families[FAMILIES] = {
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
    {"holes", holes, true},
    {"tall with holes", tall_with_holes, true},
    {"cliffs of 1e6", high_cliffs, false},
    {"steep functions", steep, false},
    {"mixed", mixed, false},
    {"mixed with holes", mixed_with_holes, true},
};

/* How far the eye is from the surface over or under it, measured across. On the surface nothing has a right answer. */
static double clearance(const scene_t *s) {
    const surface_ref_t *r = &s->ref;
    const exact_eye_t *e = &r->eye;
    if (!e->h) return INFINITY;
    double least = INFINITY;
    for (int j = 0; j + 1 < r->ny; j++)
        for (int i = 0; i + 1 < r->nx; i++) {
            const double dx = r->x[i + 1] - r->x[i], dy = r->y[j + 1] - r->y[j];
            const double u = fmin(fmax((e->x - r->x[i]) / dx, 0), 1), v = fmin(fmax((e->y - r->y[j]) / dy, 0), 1);
            const double z00 = *height(s, i, j), z10 = *height(s, i + 1, j), z01 = *height(s, i, j + 1),
                         z11 = *height(s, i + 1, j + 1);
            const double slope_x = ((1 - v) * (z10 - z00) + v * (z11 - z01)) / dx;
            const double slope_y = ((1 - u) * (z01 - z00) + u * (z11 - z10)) / dy;
            const double z = (1 - v) * ((1 - u) * z00 + u * z10) + v * ((1 - u) * z01 + u * z11);
            const double across = fabs(e->z - z) / hypot(1, hypot(slope_x, slope_y));
            least = fmin(least, hypot(across, hypot(e->x - r->x[i] - u * dx, e->y - r->y[j] - v * dy)));
        }
    return least;
}

static void push(scene_t *s, const family_t *f, uint64_t *rng) {
    f->push(s, rng);
    const double width = s->ref.x[s->ref.nx - 1] - s->ref.x[0];
    for (int k = 0; k < 40 && clearance(s) < 25e-6 * width; k++) s->ref.eye.z += width * ldexp(25e-5, k);
    scene_aim(s);
    strncat(s->what, ", ", sizeof s->what - strlen(s->what) - 1);
    strncat(s->what, f->name, sizeof s->what - strlen(s->what) - 1);
}

static void test_families(void **state) {
    (void)state;
    uint64_t first = FIRST, count = cases_scaled(300) * FAMILIES;
    int failed = 0;
    cases_t c[FAMILIES];
    for (int f = 0; f < FAMILIES; f++) c[f] = (cases_t){.name = families[f].name, .program = "test_extreme_random"};
    if (cases_only_seed(&first)) {
        count = 1;
    } else {
        first = cases_first(first, count);
    }
    for (uint64_t seed = first; seed < first + count && failed < 20; seed++) {
        const int family = (int)(seed % FAMILIES);
        scene_t s;
        uint64_t rng = seed ^ 0xe7;
        scene_random(&s, seed, 10, families[family].holes);
        push(&s, &families[family], &rng);
        if (!cases_surface(&c[family], &s, seed, failed < 3)) failed++;
        scene_free(&s);
    }
    for (int f = 0; f < FAMILIES; f++) {
        if (c[f].run > 0) cases_summary(&c[f]);
    }
    assert_int_equal(failed, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_families)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
