/* Polygons that are hard to sort (solid_scene_polygons), by the area sort and by the convex kernel, judged against
 * rays. Where faces cut through each other, edges may lie in the very lines of the cuts, which are not drawn: there it
 * is judged that nothing hidden is. RIDGELINE_CASES multiplies the count, RIDGELINE_SEED tries one. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "tests/oracle/solid_cases.h"

/* Each plate is held by the plane of its own corners, which are rounded: seen from in that plane others in it may be
 * behind or in front. */
static enum solid_verdict by_convex(void *ctx, const solid_scene_t *s, judge_report_t *r) {
    (void)ctx;
    if (s->in_plane) return SOLID_LEFT_OUT;
    return solid_scene_judge(s, r) ? SOLID_GOOD : SOLID_FAILED;
}

static int run(const char *name, uint64_t first, solid_judge_t judge, void *ctx) {
    cases_t c = {.name = name, .program = "test_polygons_random"};
    return solid_cases_made(&c, first, cases_scaled(600), 4, solid_scene_polygons, judge, ctx);
}

static void polygons_area(void **state) {
    (void)state;
    int cut = 0;
    const int failed = run("polygons, area sort", 0, solid_cases_area, &cut);
    print_message("# polygons, area sort: in %d faces cut through each other\n", cut);
    assert_int_equal(failed, 0);
}
static void polygons_convex(void **state) {
    (void)state;
    assert_int_equal(run("polygons, convex", 1000000000, by_convex, NULL), 0);
}

/* A small face on a plate, the eye close by and all but in its plane; both sides of a plate, the eye in its plane. */
static void once_wrong_area(void **state) {
    (void)state;
    static const uint64_t seeds[] = {760, 7421, 8421, 16282};
    cases_t c = {.name = "polygons, once wrong", .program = "test_polygons_random"};
    const int failed = solid_cases_once_wrong(&c, seeds, sizeof seeds / sizeof *seeds, 4, solid_scene_polygons,
                                              solid_cases_area, NULL);
    assert_int_equal(failed, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(polygons_area), cmocka_unit_test(polygons_convex),
                                       cmocka_unit_test(once_wrong_area)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
