/* Seeded random scenes of solids with translucent faces and lines on faces, drawn by the area sort and judged against
 * rays. Only where bodies on a lattice cut through each other, edges lie in the very lines in which faces cut, which
 * are not drawn and which the reference sees: those scenes are left out. RIDGELINE_CASES=100 tries a hundred times as
 * many; RIDGELINE_SEED=n tries one. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "tests/oracle/clear_ref.h"
#include "tests/oracle/run_cases.h"
#include "tests/oracle/solid_cases.h"

static void tell(const char *what, const judge_report_t *r) {
    if (cases_good(r)) return;
    print_message("#   %s: missing %g mm (line %d, %g to %g), false %g mm (line %d, %g to %g), end %g steps, twice %g "
                  "mm\n",
                  what, r->missing_mm, r->missing.line, r->missing.from, r->missing.to, r->false_mm, r->falsely.line,
                  r->falsely.from, r->falsely.to, r->end_steps, r->twice_mm);
}

static int run(const char *name, uint64_t first, uint64_t count, int objects, solid_make_t make) {
    static const char *const what[4] = {"edges", "edges, with those behind", "details", "details, with those behind"};
    uint64_t from, to;
    int failed = 0, left_out = 0, behind = 0, clear = 0;
    cases_t c[4];
    if (!cases_seeds(first, count, &from, &to)) return 0;
    for (int k = 0; k < 4; k++) c[k] = (cases_t){.name = what[k]};
    for (uint64_t seed = from; seed < to && failed < 20; seed++) {
        solid_scene_t s;
        clear_report_t r;
        make(&s, seed, objects);
        bool good = clear_scene_judge(&s, &r);
        if (r.area.intersections && s.lattice) {
            left_out++;
            solid_scene_free(&s);
            continue;
        }
        const judge_report_t *const all[4] = {&r.edges[0], &r.edges[1], &r.details[0], &r.details[1]};
        behind += r.area.behind;
        clear += r.edges[1].ink_mm > r.edges[0].ink_mm;
        if (!good) {
            failed++;
            print_message("# FAILED RIDGELINE_SEED=%llu build/tests/property/test_clear_random: %s, %d lost\n",
                          (unsigned long long)seed, s.what, r.lost);
            for (int k = 0; k < 4; k++) tell(what[k], all[k]);
        }
        for (int k = 0; k < 4; k++) {
            c[k].run++;
            c[k].facets += s.ref.nf;
            judge_worst(&c[k].worst, all[k]);
        }
        solid_scene_free(&s);
    }
    for (int k = 0; k < 4; k++) cases_summary(&c[k]);
    print_message("# %s: in %d something is seen through faces, in %d something is behind the eye; %d left out\n", name,
                  clear, behind, left_out);
    return failed;
}

static void few_objects(void **state) {
    (void)state;
    assert_int_equal(run("translucent, few", 0, cases_scaled(1000), 3, clear_scene_random), 0);
}
static void many_objects(void **state) {
    (void)state;
    assert_int_equal(run("translucent, many", 1000000000, cases_scaled(20), 16, clear_scene_random), 0);
}

static void hard_polygons(void **state) {
    (void)state;
    assert_int_equal(run("translucent, polygons", 2000000000, cases_scaled(200), 3, clear_scene_polygons), 0);
}

/* An edge that touches what hides its face, which is of a translucent body. */
static void once_wrong(void **state) {
    (void)state;
    uint64_t only;
    solid_scene_t s;
    clear_report_t r;
    if (cases_only_seed(&only)) return;
    clear_scene_random(&s, 1502977, 3);
    assert_true(clear_scene_judge(&s, &r));
    solid_scene_free(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(few_objects),
        cmocka_unit_test(many_objects),
        cmocka_unit_test(hard_polygons),
        cmocka_unit_test(once_wrong),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
