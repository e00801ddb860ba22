/* Seeded random scenes of solids, drawn by the convex kernel and judged against rays. RIDGELINE_CASES=100 tries a
 * hundred times as many; RIDGELINE_SEED=n tries one. */
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
    int failed = 0;
    cases_t c = {.name = name};
    if (!cases_seeds(first, count, &from, &to)) return 0;
    for (uint64_t seed = from; seed < to && failed < 20; seed++) {
        solid_scene_t s;
        judge_report_t r;
        solid_scene_random(&s, seed, objects);
        c.run++;
        c.facets += s.ref.nf;
        if (!solid_scene_judge(&s, &r)) {
            failed++;
            print_message(
                "# FAILED RIDGELINE_SEED=%llu build/tests/property/test_convex_random: %s\n"
                "#   missing %g mm (edge %d, %g to %g), false %g mm (edge %d, %g to %g), end %g steps, twice %g mm\n",
                (unsigned long long)seed, s.what, r.missing_mm, r.missing.line, r.missing.from, r.missing.to,
                r.false_mm, r.falsely.line, r.falsely.from, r.falsely.to, r.end_steps, r.twice_mm);
        }
        judge_worst(&c.worst, &r);
        solid_scene_free(&s);
    }
    cases_summary(&c);
    return failed;
}

static void few_objects(void **state) {
    (void)state;
    assert_int_equal(run("solids, few", 0, cases_scaled(2000), 3), 0);
}
static void many_objects(void **state) {
    (void)state;
    assert_int_equal(run("solids, many", 1000000000, cases_scaled(60), 16), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(few_objects),
        cmocka_unit_test(many_objects),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
