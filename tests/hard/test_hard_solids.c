/* The hard lists of solids (by the convex kernel and by the area sort) and of haloes: nothing missing or false beyond a
 * step, haloes within their bound. RIDGELINE_CASE draws one alone. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "tests/oracle/halo_run.h"
#include "tests/oracle/hard_solids.h"
#include "tests/oracle/run_cases.h"

static bool is_wanted(int i) {
    const char *one = getenv("RIDGELINE_CASE");
    return !one || atoi(one) == i;
}

static void solids(bool area) {
    cases_t c = {.name = area ? "hard list of solids, area sort" : "hard list of solids, convex"};
    int failed = 0;
    for (int i = 0; i < hard_solids_count(); i++) {
        solid_scene_t s;
        solid_stage_t t;
        judge_report_t r = {0};
        bool good = false;
        if (!is_wanted(i)) continue;
        const int every = hard_solids_build(i, &s);
        int err = solid_stage_make(&t, &s, area);
        if (!err) err = solid_stage_judge(&t, &s, every, &r, &good);
        if (err || !good) {
            failed++;
            print_message("# FAILED %s: error %d, missing %g mm, false %g mm, ends off by %g steps, twice %g mm\n"
                          "#   repeat: RIDGELINE_CASE=%d build/tests/hard/test_hard_solids\n",
                          s.what, err, r.missing_mm, r.false_mm, r.end_steps, r.twice_mm, i);
        }
        c.run++;
        c.facets += s.ref.nf;
        judge_worst(&c.worst, &r);
        solid_stage_free(&t);
        solid_scene_free(&s);
    }
    cases_summary(&c);
    assert_int_equal(failed, 0);
}

static void test_convex(void **state) {
    (void)state;
    solids(false);
}
static void test_area_sort(void **state) {
    (void)state;
    solids(true);
}

static void test_haloes(void **state) {
    (void)state;
    static halo_edge_t edge[HARD_WIRES_EDGES];
    halo_run_t run = {0};
    int failed = 0, crossings = 0;
    halo_run_make(&run, HARD_WIRES_EDGES, 40 * HARD_WIRES_EDGES);
    for (int i = 0; i < hard_wires_count(); i++) {
        int32_t width;
        const int n = hard_wires_build(i, edge, &width);
        if (!is_wanted(i)) continue;
        const int err = halo_run_draw(&run, edge, n, width);
        const halo_ref_report_t r = halo_ref_judge(edge, n, width, false, 1, run.piece, run.n);
        crossings += r.crossings;
        if (!err && r.beyond <= 0) continue;
        failed++;
        print_message("# FAILED %s: error %d, %g units missing, %g false\n"
                      "#   repeat: RIDGELINE_CASE=%d build/tests/hard/test_hard_solids\n",
                      hard_wires_name(i), err, r.missing, r.falsely, i);
    }
    halo_run_free(&run);
    print_message("# hard list of haloes: %d frames, %d crossings\n", hard_wires_count(), crossings);
    assert_int_equal(failed, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_convex),
        cmocka_unit_test(test_area_sort),
        cmocka_unit_test(test_haloes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
