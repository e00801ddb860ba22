/* Seeded random scenes of solids, drawn by the convex kernel and judged against rays. RIDGELINE_CASES=100 tries a
 * hundred times as many; RIDGELINE_SEED=n tries one. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "tests/oracle/solid_cases.h"

static enum solid_verdict judge(void *ctx, const solid_scene_t *s, judge_report_t *r) {
    (void)ctx;
    return solid_scene_judge(s, r) ? SOLID_GOOD : SOLID_FAILED;
}

static int run(const char *name, uint64_t first, uint64_t count, int objects) {
    cases_t c = {.name = name, .program = "test_convex_random"};
    return solid_cases_random(&c, first, count, objects, judge, NULL);
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
