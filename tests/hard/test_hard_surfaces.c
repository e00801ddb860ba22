/* The surfaces and viewpoints of tests/oracle/hard_list.h, each drawn by the perimeter kernel and judged by the same
 * limits as everything else (run_cases.h): nothing missing or false beyond one step, ends within a quarter step. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "tests/oracle/hard_list.h"
#include "tests/oracle/run_cases.h"

static void test_list(void **state) {
    (void)state;
    cases_t all = {.name = "hard list"};
    int failed = 0;
    const char *only = getenv("RIDGELINE_CASE"); /* its number, for a closer look */
    for (int i = 0; i < hard_list_count(); i++) {
        scene_t s;
        if (only && atoi(only) != i) continue;
        hard_list_build(i, &s);
        if (!cases_surface(&all, &s, (uint64_t)i, false)) {
            failed++;
            printf("#   repeat: RIDGELINE_CASE=%d build/tests/hard/test_hard_surfaces\n", i);
            if (only) scene_print(&s);
        }
        scene_free(&s);
    }
    cases_summary(&all);
    assert_int_equal(failed, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_list)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
