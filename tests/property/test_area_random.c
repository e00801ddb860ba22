/* Seeded random scenes of solids, drawn by the area sort and judged against rays, with eyes in the midst of them and
 * faces that cut through each other. Only where bodies on a lattice do that, edges lie in the very lines in which faces
 * cut, which are not drawn and which the reference sees: those scenes are left out. RIDGELINE_CASES=100 tries a hundred
 * times as many; RIDGELINE_SEED=n tries one. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "tests/oracle/run_cases.h"
#include "tests/oracle/solid_scenes.h"

static int run(const char *name, uint64_t first, uint64_t count, int objects) {
    uint64_t from, to;
    int failed = 0, left_out = 0, behind = 0, cut = 0;
    cases_t c = {.name = name};
    if (!cases_seeds(first, count, &from, &to)) return 0;
    for (uint64_t seed = from; seed < to && failed < 20; seed++) {
        solid_scene_t s;
        judge_report_t r;
        area_stats_t area = {0};
        solid_scene_random(&s, seed, objects);
        bool good = solid_scene_judge_area(&s, &r, &area);
        if (area.intersections && s.lattice) {
            left_out++;
            solid_scene_free(&s);
            continue;
        }
        c.run++;
        behind += area.behind;
        cut += area.intersections > 0;
        c.facets += s.ref.nf;
        if (!good) {
            failed++;
            print_message(
                "# FAILED RIDGELINE_SEED=%llu build/tests/property/test_area_random: %s\n"
                "#   missing %g mm (edge %d, %g to %g), false %g mm (edge %d, %g to %g), end %g steps, twice %g mm\n",
                (unsigned long long)seed, s.what, r.missing_mm, r.missing.line, r.missing.from, r.missing.to,
                r.false_mm, r.falsely.line, r.falsely.from, r.falsely.to, r.end_steps, r.twice_mm);
        }
        judge_worst(&c.worst, &r);
        solid_scene_free(&s);
    }
    cases_summary(&c);
    print_message("# %s: in %d something is behind the eye, in %d faces cut through each other; %d left out\n", name,
                  behind, cut, left_out);
    return failed;
}

static void few_objects(void **state) {
    (void)state;
    assert_int_equal(run("area sort, few", 0, cases_scaled(2000), 3), 0);
}
static void many_objects(void **state) {
    (void)state;
    assert_int_equal(run("area sort, many", 1000000000, cases_scaled(60), 16), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(few_objects),
        cmocka_unit_test(many_objects),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
