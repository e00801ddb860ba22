/* Surfaces that people have and that those of test_awkward_random, test_extreme_random and test_folded_random are not:
 * terrain with detail of every size, chessboards, half spheres and other roots, functions with poles, cones looked at
 * from their points, ruled surfaces along their rulings, logarithmic axes, heights in whole numbers with holes all
 * over.
 *
 * RIDGELINE_CASES multiplies the count, RIDGELINE_SEED tries one. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "tests/oracle/families.h"

#define NAME "test_natural_random"
#define FIRST 22000000000u

/* More vertices than scene_random's, on [-2,2]^2; the eye stays. */
static void regrid(scene_t *s, int nx, int ny, bool holes) {
    const exact_eye_t eye = s->ref.eye;
    scene_t t;
    scene_init(&t, nx, ny);
    if (holes && !(t.ref.hole = calloc((size_t)nx * (size_t)ny, 1))) abort();
    for (size_t k = 0; k < sizeof t.what; k++) t.what[k] = s->what[k];
    scene_free(s);
    *s = t;
    s->ref.eye = eye;
}

/* Midpoint displacement: every half as rough as the whole. */
static void terrain(scene_t *s, uint64_t *rng) {
    enum { SIDE = 16 };
    const double rough = .35 + .4 * scene_uniform(rng);
    regrid(s, SIDE + 1, SIDE + 1, false);
    for (int step = SIDE, half; step > 1; step = half) {
        const double size = 1.5 * pow((double)step / SIDE, -log2(rough));
        half = step / 2;
        for (int j = 0; j <= SIDE; j += half)
            for (int i = 0; i <= SIDE; i += half) {
                const bool x = i % step != 0, y = j % step != 0;
                if (!x && !y) continue;
                const int i0 = i - (x ? half : 0), i1 = i + (x ? half : 0), j0 = j - (y ? half : 0),
                          j1 = j + (y ? half : 0);
                *family_height(s, i, j) =
                    .5 * (*family_height(s, i0, j0) + *family_height(s, i1, j1)) + size * (scene_uniform(rng) - .5);
            }
    }
    double at[3];
    family_place(s, rng, at);
    if (scene_below(rng, 2)) s->ref.eye = (exact_eye_t){at[0], at[1], at[2] + family_log_uniform(rng, 1e-2, 4), 1};
}

/* Fields of two heights, a cell or several wide; walls between them, or the fields themselves slanting. */
static void chess(scene_t *s, uint64_t *rng) {
    const int field = 1 + scene_below(rng, 3);
    const double high = family_log_uniform(rng, .01, 10), slope = scene_below(rng, 3) * .25;
    for (int j = 0; j < s->ref.ny; j++)
        for (int i = 0; i < s->ref.nx; i++)
            *family_height(s, i, j) = ((i / field + j / field) & 1) * high + slope * (i % field);
    if (scene_below(rng, 2)) { /* over the corner of a field, or level with one */
        s->ref.eye.x = s->ref.x[scene_below(rng, s->ref.nx)];
        s->ref.eye.y = s->ref.y[scene_below(rng, s->ref.ny)];
        if (scene_below(rng, 2)) s->ref.eye = (exact_eye_t){1, scene_below(rng, 3) - 1, scene_below(rng, 3) * high, 0};
    }
}

/* What is defined inside a curve only, and ends there steeply. */
static void roots(scene_t *s, uint64_t *rng) {
    const int which = scene_below(rng, 5);
    const double radius = .7 + 2 * scene_uniform(rng), sign = scene_below(rng, 2) ? 1 : -1;
    regrid(s, 6 + scene_below(rng, 12), 6 + scene_below(rng, 12), true);
    for (int j = 0; j < s->ref.ny; j++)
        for (int i = 0; i < s->ref.nx; i++) {
            const double x = s->ref.x[i], y = s->ref.y[j], r = hypot(x, y);
            const double z = which == 0   ? sqrt(radius * radius - r * r)
                             : which == 1 ? sqrt(sin(3 * x) * cos(2 * y))
                             : which == 2 ? log(r - .5 * radius)
                             : which == 3 ? asin(x * y / radius)
                                          : sqrt(r - radius);
            s->ref.hole[j * s->ref.nx + i] = (unsigned char)(!isfinite(z));
            *family_height(s, i, j) = isfinite(z) ? sign * z : 0;
        }
    if (scene_below(rng, 3) == 0)
        s->ref.eye =
            (exact_eye_t){.1 * scene_uniform(rng), scene_below(rng, 2) * .2, radius * (.2 + scene_uniform(rng)), 1};
}

/* Up to 10^3..10^6 beside a pole, of both signs, holes on it; autoscale makes all the rest flat. */
static void poles(scene_t *s, uint64_t *rng) {
    const int which = scene_below(rng, 5);
    const double k = 1 + 3 * scene_uniform(rng), off = scene_below(rng, 2) ? 0 : family_log_uniform(rng, 1e-6, .1);
    if (!s->ref.hole) return;
    for (int j = 0; j < s->ref.ny; j++)
        for (int i = 0; i < s->ref.nx; i++) {
            const double x = s->ref.x[i] + off, y = s->ref.y[j];
            const double z = which == 0   ? tan(k * x)
                             : which == 1 ? 1 / x
                             : which == 2 ? 1 / (x * y)
                             : which == 3 ? y / x
                                          : 1 / (x * x + y * y);
            const bool defined = fabs(z) < 1e6;
            s->ref.hole[j * s->ref.nx + i] = (unsigned char)(!defined);
            *family_height(s, i, j) = defined ? z : 0;
        }
    if (s->ref.eye.h && scene_below(rng, 2)) s->ref.eye.z = family_log_uniform(rng, .1, 1e4);
}

/* A cone or pyramid, looked at from its point, which is cut off: every line that goes up is a point, every facet a
 * line. Or along one of its sides, from beyond. */
static void cone(scene_t *s, uint64_t *rng) {
    const int kind = scene_below(rng, 3);
    const double x0 = (scene_below(rng, 33) - 16) / 16., y0 = (scene_below(rng, 33) - 16) / 16.,
                 k = (1 + scene_below(rng, 12)) / 4.;
    if (!s->ref.hole) return;
    for (int j = 0; j < s->ref.ny; j++)
        for (int i = 0; i < s->ref.nx; i++) {
            const double x = s->ref.x[i] - x0, y = s->ref.y[j] - y0;
            const double r = kind == 0 ? hypot(x, y) : kind == 1 ? fabs(x) + fabs(y) : fmax(fabs(x), fabs(y));
            *family_height(s, i, j) = -k * r;
            s->ref.hole[j * s->ref.nx + i] = (unsigned char)(r < .6);
        }
    s->ref.eye = scene_below(rng, 3) ? (exact_eye_t){x0, y0, 0, 1} : (exact_eye_t){3, scene_below(rng, 2), 3 * k, 0};
    if (scene_below(rng, 4) == 0) s->ref.eye.z += family_log_uniform(rng, 1e-9, 1e-2);
}

/* z = a + b x + (c + d x) y: straight lines both ways, the eye on one of them or along it. */
static void ruled(scene_t *s, uint64_t *rng) {
    const double a = (scene_below(rng, 9) - 4) / 4., b = (scene_below(rng, 9) - 4) / 4.,
                 c = (scene_below(rng, 9) - 4) / 4., d = (scene_below(rng, 9) - 4) / 4.;
    for (int i = 0; i < s->ref.nx; i++) s->ref.x[i] = i * .25 - 1;
    for (int j = 0; j < s->ref.ny; j++) s->ref.y[j] = j * .25 - 1;
    for (int j = 0; j < s->ref.ny; j++)
        for (int i = 0; i < s->ref.nx; i++)
            *family_height(s, i, j) = a + b * s->ref.x[i] + (c + d * s->ref.x[i]) * s->ref.y[j];
    const double x = (scene_below(rng, 65) - 32) / 16., far = 3 + scene_below(rng, 5);
    s->ref.eye = scene_below(rng, 2) ? (exact_eye_t){x, far, a + b * x + (c + d * x) * far, 1}
                                     : (exact_eye_t){0, 1, c + d * x, 0};
    if (scene_below(rng, 3) == 0) s->ref.eye.z += family_log_uniform(rng, 1e-12, 1e-3);
}

/* Decades on one axis or both, as `set logscale` and measured data have them. */
static void decades(scene_t *s, uint64_t *rng) {
    const int axes = 1 + scene_below(rng, 3);
    const double most = family_log_uniform(rng, 10, 1e6);
    for (int axis = 0; axis < 2; axis++) {
        double *c = axis ? s->ref.y : s->ref.x;
        const int n = axis ? s->ref.ny : s->ref.nx;
        if (!(axes >> axis & 1)) continue;
        for (int i = 0; i < n; i++) c[i] = 4 * (pow(most, (double)i / (n - 1)) - 1) / (most - 1) - 2;
    }
    scene_eye(s, (enum scene_eye)scene_below(rng, EYES), rng);
}

/* Heights 0 to 3 in whole cells, a tenth to two thirds of the points missing, seen from everywhere. */
static void whole_numbers(scene_t *s, uint64_t *rng) {
    const double share = .1 + .55 * scene_uniform(rng);
    const int levels = 2 + scene_below(rng, 3);
    regrid(s, 5 + scene_below(rng, 12), 5 + scene_below(rng, 12), true);
    for (int i = 0; i < s->ref.nx; i++) s->ref.x[i] = i - s->ref.nx / 2;
    for (int j = 0; j < s->ref.ny; j++) s->ref.y[j] = j - s->ref.ny / 2;
    for (int k = 0; k < s->ref.nx * s->ref.ny; k++) {
        s->ref.z[k] = scene_below(rng, levels);
        s->ref.hole[k] = (unsigned char)(scene_uniform(rng) < share);
    }
    const double x = scene_below(rng, 2 * s->ref.nx) - s->ref.nx, y = scene_below(rng, 2 * s->ref.ny) - s->ref.ny;
    s->ref.eye = (exact_eye_t){.5 * x, .5 * y, levels + scene_below(rng, 4), 1};
    if (scene_below(rng, 2)) s->ref.eye = (exact_eye_t){scene_below(rng, 5) - 2, 1, scene_below(rng, 7) - 3, 0};
    if (scene_below(rng, 4) == 0) s->ref.eye = (exact_eye_t){scene_below(rng, 3) - 1, 0, 8, 0};
}

/* Ridges that run along the line of sight, from an eye in the plane of one, their flanks a little or very steep. */
static void sawtooth(scene_t *s, uint64_t *rng) {
    const double steep = family_log_uniform(rng, 1e-3, 1e3),
                 wave = scene_below(rng, 2) ? 0 : family_log_uniform(rng, 1e-6, .1);
    const int period = 1 + scene_below(rng, 4);
    for (int j = 0; j < s->ref.ny; j++)
        for (int i = 0; i < s->ref.nx; i++)
            *family_height(s, i, j) = steep * (period > 1 ? i % period : i & 1) + wave * sin(3 * j);
    const double x = s->ref.x[scene_below(rng, s->ref.nx)];
    s->ref.eye = scene_below(rng, 2) ? (exact_eye_t){x, scene_below(rng, 2) ? 7 : -7, steep * scene_below(rng, 4), 1}
                                     : (exact_eye_t){0, 1, steep * (scene_below(rng, 3) - 1) / 4, 0};
}

static const family_t family[] = {
    {"terrain", terrain, false},   {"chess", chess, false},
    {"roots", roots, true},        {"poles", poles, true},
    {"cone", cone, true},          {"ruled", ruled, false},
    {"decades", decades, true},    {"whole numbers", whole_numbers, true},
    {"sawtooth", sawtooth, false},
};

static void random_families(void **state) {
    (void)state;
    assert_int_equal(families_run(NAME, family, sizeof family / sizeof *family, FIRST, 120), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(random_families)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
