/* Seeded random scenes of solids, drawn by the area sort and judged against rays, with eyes in the midst of them and
 * faces that cut through each other. Only where bodies on a lattice do that, edges lie in the very lines in which faces
 * cut, which are not drawn and which the reference sees: in those scenes it is judged that nothing hidden is drawn.
 * RIDGELINE_CASES=100 tries a hundred times as many; RIDGELINE_SEED=n tries one. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "tests/oracle/solid_cases.h"

typedef struct account {
    int half_judged, behind, cut;
} account_t;

static enum solid_verdict judge(void *ctx, const solid_scene_t *s, judge_report_t *r) {
    account_t *a = ctx;
    area_stats_t area = {0};
    bool good = solid_scene_judge_area(s, r, &area);
    if (area.intersections && s->lattice) {
        a->half_judged++;
        r->missing_mm = r->end_steps = 0;
        good = r->false_mm <= CASES_RUN_MM && r->twice_mm <= CASES_TWICE_MM;
    }
    a->behind += area.behind;
    a->cut += area.intersections > 0;
    return good ? SOLID_GOOD : SOLID_FAILED;
}

static int run(const char *name, uint64_t first, uint64_t count, int objects) {
    cases_t c = {.name = name, .program = "test_area_random"};
    account_t a = {0};
    int failed = solid_cases_random(&c, first, count, objects, judge, &a);
    print_message(
        "# %s: in %d something is behind the eye, in %d faces cut through each other, in %d of these on lattices\n",
        name, a.behind, a.cut, a.half_judged);
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
