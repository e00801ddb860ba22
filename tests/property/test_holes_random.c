/* Seeded random scenes with undefined points: facets that touch one are not drawn and hide nothing, and what is behind
 * a hole is drawn. RIDGELINE_CASES=100 tries a hundred times as many; RIDGELINE_SEED=n tries one. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "tests/oracle/run_cases.h"

#define NAME "test_holes_random"

static void test_small(void **state) {
    (void)state;
    assert_int_equal(cases_random_surfaces(NAME, 2000000000, cases_scaled(1500), 12, true), 0);
}

static void test_larger(void **state) {
    (void)state;
    assert_int_equal(cases_random_surfaces(NAME, 4000000000, cases_scaled(40), 40, true), 0);
}

/* Steep edges that fall together but for rounding: nothing shows between them. */
static void test_steep_together(void **state) {
    (void)state;
    cases_t c = {.name = "steep edges together", .program = NAME};
    scene_t s;
    scene_random(&s, 4000003441, 40, true);
    const bool good = cases_surface(&c, &s, 4000003441, false);
    scene_free(&s);
    assert_true(good);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_small),
        cmocka_unit_test(test_larger),
        cmocka_unit_test(test_steep_together),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
