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

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_small),
        cmocka_unit_test(test_larger),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
