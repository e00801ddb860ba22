/* Several surfaces over one grid, one above the other: each hides the others and itself. Judged sheet by sheet.
 *
 * RIDGELINE_CASES multiplies the count, RIDGELINE_SEED tries one. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include <math.h>

#include "error.h"
#include "tests/oracle/run_cases.h"

#define MOST 3

/* Lays n - 1 more sheets over the scene's, each a random distance above the one before or touching it here and
 * there. */
static void stack(const scene_t *s, int n, double *z[MOST], unsigned char *hole[MOST], uint64_t *rng) {
    int points = s->ref.nx * s->ref.ny;
    double rough = scene_below(rng, 2) ? 1 : .05;
    bool touching = scene_below(rng, 4) == 0;
    for (int k = 0; k < n; k++) {
        z[k] = malloc((size_t)points * sizeof(double));
        hole[k] = calloc((size_t)points, 1);
        if (!z[k] || !hole[k]) abort();
        for (int i = 0; i < points; i++) {
            double above = touching && scene_below(rng, 2) ? 0 : .05 + rough * scene_uniform(rng);
            z[k][i] = k ? z[k - 1][i] + above : s->ref.z[i];
            hole[k][i] = s->ref.hole && scene_uniform(rng) < .1;
        }
    }
}

/* Where two sheets have the same edge either may draw it: adds what the others drew of sheet k's edges to d[k]. */
static void share(const surface_ref_t *sheet, int n, int k, const run_drawing_t *d, run_drawing_t *out) {
    const surface_ref_t *r = &sheet[k];
    ink_sink_t sink = run_sink(out);
    for (int m = 0; m < n; m++) {
        for (size_t p = 0; p < d[m].n; p++) {
            judge_piece_t all = d[m].piece[p];
            for (int cell = (int)floor(all.from); cell < all.to; cell++) {
                exact_point_t a[2], b[2];
                surface_ref_edge_ends(r, all.family, all.line, cell, a);
                surface_ref_edge_ends(&sheet[m], all.family, all.line, cell, b);
                if (m != k && (a[0].z != b[0].z || a[1].z != b[1].z)) continue;
                if (m != k && !surface_ref_edge_exists(r, all.family, all.line, cell)) continue;
                double from = fmax(all.from, cell), to = fmin(all.to, cell + 1);
                sink.piece(sink.ctx, &(ink_piece_t){.family = all.family == REF_ROW ? INK_ROW : INK_COL,
                                                    .line = all.line,
                                                    .from = (int64_t)ldexp(from, INK_GRID_BITS),
                                                    .to = (int64_t)ldexp(to, INK_GRID_BITS)});
            }
        }
    }
}

static bool judge_stack(cases_t *c, const scene_t *s, int n, double *z[MOST], unsigned char *hole[MOST]) {
    surface_ref_t sheet[MOST];
    run_drawing_t d[MOST] = {{0}};
    hidden_stats_t stats;
    bool good = true;
    for (int k = 0; k < n; k++) {
        sheet[k] = s->ref;
        sheet[k].z = z[k];
        sheet[k].hole = hole[k];
    }
    int err = run_several(sheet, n, d, &stats);
    c->run++;
    c->facets += stats.facets;
    for (int k = 0; k < n; k++) {
        double *other_z[MOST];
        unsigned char *other_hole[MOST];
        surface_ref_t ref = sheet[k];
        judge_report_t r = {0};
        for (int i = 0; i < n; i++)
            if (i != k) other_z[ref.sheets] = z[i], other_hole[ref.sheets++] = hole[i];
        ref.sheet_z = other_z;
        ref.sheet_hole = other_hole;
        judge_subject_t what = judge_surface(&ref);
        run_drawing_t shared = {0};
        if (!err) share(sheet, n, k, d, &shared);
        if (!err) err = judge_pieces(&what, &s->view, shared.piece, shared.n, &r);
        run_drawing_free(&shared);
        judge_worst(&c->worst, &r);
        if (err == ERR_EMPTY) err = 0;
        if (!err && cases_good(&r)) continue;
        good = false;
        print_message("# FAILED: RIDGELINE_SEED of %s\n#   sheet %d of %d: error %d, missing %g mm (%d %d: %g to %g), "
                      "false %g mm (%d %d: %g to %g), end %g steps, twice %g\n",
                      s->what, k, n, err, r.missing_mm, r.missing.family, r.missing.line, r.missing.from, r.missing.to,
                      r.false_mm, r.falsely.family, r.falsely.line, r.falsely.from, r.falsely.to, r.end_steps,
                      r.twice_mm);
    }
    for (int k = 0; k < n; k++) run_drawing_free(&d[k]);
    return good;
}

static bool try_seed(cases_t *c, uint64_t seed) {
    scene_t s;
    uint64_t rng = seed ^ 0x5eed;
    double *z[MOST];
    unsigned char *hole[MOST];
    int n = 2 + scene_below(&rng, MOST - 1);
    bool good = true;
    scene_random(&s, seed, 10, seed % 3 == 0);
    if (s.ref.eye.h != 0 || s.ref.eye.x != 0 || s.ref.eye.y != 0) { /* in a plan one sheet draws the lines of all */
        stack(&s, n, z, hole, &rng);
        good = judge_stack(c, &s, n, z, hole);
        for (int k = 0; k < n; k++) {
            free(z[k]);
            free(hole[k]);
        }
    }
    scene_free(&s);
    return good;
}

/* The eye over a corner and close to the surface: heights are small beside the chart's unit. */
static void test_low_over_corner(void **state) {
    (void)state;
    cases_t c = {.name = "low over a corner"};
    assert_true(try_seed(&c, 7000004517));
}

/* Three sheets have an edge in common; the first has no facet where the others do. */
static void test_three_together(void **state) {
    (void)state;
    cases_t c = {.name = "three together"};
    assert_true(try_seed(&c, 7000001652));
    assert_true(try_seed(&c, 7000003236));
}

static void test_random(void **state) {
    (void)state;
    cases_t c = {.name = "test_several_random"};
    uint64_t first, to;
    int failed = 0;
    if (!cases_seeds(7000000000, cases_scaled(500), &first, &to)) return;
    for (uint64_t seed = first; seed < to && failed < 10; seed++) {
        if (!try_seed(&c, seed)) failed++;
    }
    cases_summary(&c);
    assert_int_equal(failed, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_low_over_corner), cmocka_unit_test(test_three_together),
                                       cmocka_unit_test(test_random)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
