/* Seeded random scenes, drawn by the perimeter kernel and judged against the reference. RIDGELINE_CASES=100 tries a
 * hundred times as many; RIDGELINE_SEED=n tries one. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "tests/oracle/run_cases.h"

#define NAME "test_perimeter_random"

static void test_small(void **state) {
    (void)state;
    assert_int_equal(cases_random_surfaces(NAME, 0, cases_scaled(2500), 12, false), 0);
}
static void test_larger(void **state) {
    (void)state;
    assert_int_equal(cases_random_surfaces(NAME, 1000000000, cases_scaled(60), 48, false), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_small),
        cmocka_unit_test(test_larger),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
