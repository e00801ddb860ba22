/* Bodies as people put them together (solid_scene_composed), by the convex kernel and by the area sort, judged against
 * rays. RIDGELINE_CASES multiplies the count, RIDGELINE_SEED tries one. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "tests/oracle/solid_cases.h"

#define FIRST 23000000000u

static enum solid_verdict by_convex(void *ctx, const solid_scene_t *s, judge_report_t *r) {
    (void)ctx;
    return solid_scene_judge(s, r) ? SOLID_GOOD : SOLID_FAILED;
}

static int run(const char *name, uint64_t first, solid_judge_t judge) {
    cases_t c = {.name = name, .program = "test_composed_random"};
    return solid_cases_made(&c, first, cases_scaled(300), 4, solid_scene_composed, judge, NULL);
}

static void composed_convex(void **state) {
    (void)state;
    assert_int_equal(run("composed, convex", FIRST, by_convex), 0);
}
static void composed_area(void **state) {
    (void)state;
    assert_int_equal(run("composed, area sort", FIRST + 1000000000, solid_cases_area), 0);
}

/* An edge seen end-on in an outline; a line along a seam of triangles that were cut in the plane. */
static void once_wrong_convex(void **state) {
    (void)state;
    static const uint64_t seeds[] = {23000000300, 23000004696};
    cases_t c = {.name = "composed, once wrong", .program = "test_composed_random"};
    const int failed =
        solid_cases_once_wrong(&c, seeds, sizeof seeds / sizeof *seeds, 4, solid_scene_composed, by_convex, NULL);
    assert_int_equal(failed, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(composed_convex), cmocka_unit_test(composed_area),
                                       cmocka_unit_test(once_wrong_convex)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
