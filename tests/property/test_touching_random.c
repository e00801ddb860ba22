/* Bodies that touch in faces, edges and corners, seen along these (solid_scene_touching, and boxes flush on a lattice,
 * solid_scene_flush), by the convex kernel and by the area sort, judged against rays; by the convex kernel also from
 * close to a vertex (solid_scene_close), where the area sort's ends are off by half a step. RIDGELINE_CASES multiplies
 * the count, RIDGELINE_SEED tries one. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "tests/oracle/solid_cases.h"

static enum solid_verdict by_convex(void *ctx, const solid_scene_t *s, judge_report_t *r) {
    (void)ctx;
    return solid_scene_judge(s, r) ? SOLID_GOOD : SOLID_FAILED;
}

static int run(const char *name, uint64_t first, solid_make_t make, solid_judge_t judge) {
    cases_t c = {.name = name, .program = "test_touching_random"};
    return solid_cases_made(&c, first, cases_scaled(600), 5, make, judge, NULL);
}

static void touching_convex(void **state) {
    (void)state;
    assert_int_equal(run("touching, convex", 0, solid_scene_touching, by_convex), 0);
}
static void touching_area(void **state) {
    (void)state;
    assert_int_equal(run("touching, area sort", 1000000000, solid_scene_touching, solid_cases_area), 0);
}
static void flush_convex(void **state) {
    (void)state;
    assert_int_equal(run("flush, convex", 2000000000, solid_scene_flush, by_convex), 0);
}
static void flush_area(void **state) {
    (void)state;
    assert_int_equal(run("flush, area sort", 3000000000, solid_scene_flush, solid_cases_area), 0);
}
static void close_convex(void **state) {
    (void)state;
    assert_int_equal(run("close, convex", 4000000000, solid_scene_close, by_convex), 0);
}

/* Strips of a few units beside edges that fall together; an edge on the border of the paper; a silhouette's side a hair
 * inside of a face's. */
static void once_wrong_area(void **state) {
    (void)state;
    static const uint64_t seeds[] = {1000001108, 1000012805, 1000020269, 1000104049, 1000009524, 1000309990};
    cases_t c = {.name = "touching, once wrong", .program = "test_touching_random"};
    const int failed = solid_cases_once_wrong(&c, seeds, sizeof seeds / sizeof *seeds, 5, solid_scene_touching,
                                              solid_cases_area, NULL);
    assert_int_equal(failed, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(touching_convex), cmocka_unit_test(close_convex),
                                       cmocka_unit_test(touching_area),   cmocka_unit_test(flush_convex),
                                       cmocka_unit_test(flush_area),      cmocka_unit_test(once_wrong_area)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
