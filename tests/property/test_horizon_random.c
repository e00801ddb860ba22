/* Seeded random profiles, drawn by the horizon kernel and judged against every-segment-with-every-nearer-segment.
 * RIDGELINE_CASES multiplies the count, RIDGELINE_SEED tries one. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "error.h"
#include "tests/oracle/run_cases.h"
#include "tests/oracle/run_horizon.h"

#define MOST 40 /* profiles, and points of one */

typedef struct profile_scene {
    horizon_ref_t ref;
    page_view_t view;
    double away[2];
    int first[MOST + 1];
    exact_point_t point[MOST * MOST];
    unsigned char gap[MOST * MOST];
} profile_scene_t;

static double span(uint64_t *rng, double lo, double hi) {
    return lo + (hi - lo) * scene_uniform(rng);
}

/* The camera's fit wants a surface; the corners of the box will do. */
static void aim(profile_scene_t *s) {
    double lo[3] = {INFINITY, INFINITY, INFINITY}, hi[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (int i = 0; i < s->first[s->ref.count]; i++) {
        double p[3] = {s->point[i].x, s->point[i].y, s->point[i].z};
        for (int k = 0; k < 3; k++) lo[k] = fmin(lo[k], p[k]), hi[k] = fmax(hi[k], p[k]);
    }
    double x[4] = {lo[0], lo[0], hi[0], hi[0]}, y[2] = {lo[1], hi[1]};
    double z[8] = {lo[2], hi[2], lo[2], hi[2], lo[2], hi[2], lo[2], hi[2]};
    surface_ref_t box = {.nx = 4, .ny = 2, .x = x, .y = y, .z = z, .eye = s->ref.eye};
    double to[3] = {.5 * (lo[0] + hi[0]), .5 * (lo[1] + hi[1]), .5 * (lo[2] + hi[2])};
    page_view_aim(&s->view, &box, to);
}

static double height(int shape, double side, double depth, uint64_t *rng) {
    switch (shape) {
    case 0:
        return scene_uniform(rng);
    case 1:
        return exp(-side * side - (depth - 2) * (depth - 2));
    case 2:
        return floor(3 * scene_uniform(rng)) * .5; /* coincidences */
    case 3:
        return .3 * depth; /* coplanar profiles, edge-on for some eyes */
    case 4:
        return sin(3 * side) * .2 + .1 * depth;
    default:
        return scene_below(rng, 6) ? 0 : 2 * scene_uniform(rng);
    }
}

/* Profiles perpendicular to the ground direction `away`, from depth 0 on; lateral positions on a common lattice, on
 * their own lattice or anywhere. */
static void make(profile_scene_t *s, uint64_t seed, int max) {
    uint64_t rng = seed;
    *s = (profile_scene_t){0};
    int count = 2 + scene_below(&rng, max - 1), shape = scene_below(&rng, 6), lattice = scene_below(&rng, 3);
    int parallel = scene_below(&rng, 3) == 0, gaps = scene_below(&rng, 3) == 0;
    double turn = scene_below(&rng, 3) ? span(&rng, 0, 6.283185307) : 1.5707963267948966 * scene_below(&rng, 4);
    double c = cos(turn), d = sin(turn), step = span(&rng, .05, .5);
    if (fabs(c) < 1e-9) c = 0;
    if (fabs(d) < 1e-9) d = 0;
    s->away[0] = c;
    s->away[1] = d;
    int points = 2 + scene_below(&rng, max - 1), at = 0;
    for (int k = 0; k < count; k++) {
        s->first[k] = at;
        int n = lattice == 2 ? 2 + scene_below(&rng, max - 1) : points;
        double side = lattice ? span(&rng, -2.2, -1.8) : -2;
        for (int v = 0; v < n; v++) {
            double depth = k * step;
            s->point[at] =
                (exact_point_t){side * d + depth * c, -side * c + depth * d, height(shape, side, depth, &rng)};
            s->gap[at++] = gaps && scene_below(&rng, 12) == 0;
            side += lattice == 2 ? 4.0 / n * span(&rng, .1, 1.9) : 4.0 / n;
        }
    }
    s->first[count] = at;
    double back = scene_below(&rng, 8) ? span(&rng, .5, 9) : 6000, z = scene_below(&rng, 4) ? span(&rng, -1, 3) : 0.5;
    if (back > 1000) z *= 1000;
    s->ref = (horizon_ref_t){.count = count,
                             .first = s->first,
                             .point = s->point,
                             .gap = gaps ? s->gap : NULL,
                             .infinite = scene_below(&rng, 2) == 0};
    double off = scene_below(&rng, 3) ? span(&rng, -2, 2) : 0;
    s->ref.eye =
        parallel ? (exact_eye_t){-c, -d, .2 * z, 0} : (exact_eye_t){off * d - back * c, -off * c - back * d, z, 1};
    aim(s);
}

static void test_random(void **state) {
    (void)state;
    cases_t c = {.name = "test_horizon_random"};
    uint64_t first = 0, count = cases_scaled(2500);
    int failed = 0;
    if (cases_only_seed(&first))
        count = 1;
    else
        first = cases_first(first, count);
    for (uint64_t seed = first; seed < first + count && failed < 10; seed++) {
        static profile_scene_t s;
        run_drawing_t d = {0};
        hidden_stats_t stats;
        judge_report_t r = {0};
        make(&s, seed, seed % 50 == 7 ? MOST : 14);
        judge_subject_t what = judge_horizon(&s.ref);
        int err = run_horizon(&s.ref, s.away, &d, &stats);
        if (err == 0) err = judge_pieces(&what, &s.view, d.piece, d.n, &r);
        if (err == ERR_EMPTY) err = 0;
        c.run++;
        c.facets += stats.facets;
        judge_worst(&c.worst, &r);
        if (err || !cases_good(&r)) {
            failed++;
            print_message(
                "# FAILED: RIDGELINE_SEED=%llu build/tests/property/test_horizon_random\n"
                "#   %d profiles, eye %.9g,%.9g,%.9g h %d%s: error %d, missing %g mm (%d: %g to %g), false %g mm "
                "(%d: %g to %g), end %g steps (%d: %g), twice %g\n",
                (unsigned long long)seed, s.ref.count, s.ref.eye.x, s.ref.eye.y, s.ref.eye.z, s.ref.eye.h,
                s.ref.infinite ? " infinite" : "", err, r.missing_mm, r.missing.line, r.missing.from, r.missing.to,
                r.false_mm, r.falsely.line, r.falsely.from, r.falsely.to, r.end_steps, r.end.line, r.end.from,
                r.twice_mm);
        }
        run_drawing_free(&d);
    }
    cases_summary(&c);
    assert_int_equal(failed, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_random)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
