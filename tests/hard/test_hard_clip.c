/* The hard list of pairs of polygons, judged exactly (tests/oracle/clip_judge.h): as it is, turned by quarters, and
 * blown up by a factor that makes crossings lattice points no more, or all of them. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "tests/oracle/hard_pairs.h"

static void turn(clip_shape_t *s, int32_t scale) {
    for (int32_t k = 0; k < s->out.n; k++) s->v[k].at = (poly_point_t){-scale * s->v[k].at.y, scale * s->v[k].at.x};
}

static void hard_pairs_are_right(void **state) {
    (void)state;
    static clip_shape_t subject, clip;
    clip_account_t account = {0};
    int failed = 0;
    for (int i = 0; i < hard_pairs_count(); i++)
        for (int32_t scale = 1; scale <= 60; scale = scale == 1 ? 7 : scale == 7 ? 60 : 61) {
            enum clip_fill fill;
            hard_pairs_build(i, &subject, &clip, &fill);
            for (int quarter = 0; quarter < 4; quarter++) {
                if (quarter) turn(&subject, 1), turn(&clip, 1);
                if (!quarter) turn(&subject, scale), turn(&clip, scale);
                const char *wrong = clip_judge(&subject, &clip, fill, true, &account);
                if (!wrong) continue;
                failed++;
                print_message("# FAILED %s, times %d, turned by %d quarters: %s\n", hard_pairs_name(i), (int)scale,
                              quarter + 1, wrong);
            }
        }
    print_message("# clipper, hard list: %lld pairs, all in rationals; %lld crossings rounded, %d sweeps at most; mean "
                  "displacement of borders at worst %.3f units\n",
                  (long long)account.pairs, (long long)account.rounded, account.most_sweeps, account.worst);
    assert_int_equal(failed, 0);
}

/* What can be said without a judge: numbers of contours and areas. */
static void known_results(void **state) {
    (void)state;
    static clip_shape_t subject, clip;
    /* inside, outside, rest, union, xor: contours, twice the area */
    static const struct {
        int pair;
        int64_t of[5][2];
    } known[] = {
        {0, {{1, 288}, {0, 0}, {0, 0}, {1, 288}, {0, 0}}},     /* one polygon twice */
        {1, {{1, 288}, {0, 0}, {0, 0}, {1, 288}, {0, 0}}},     /* the other way round */
        {3, {{0, 0}, {1, 288}, {1, 192}, {1, 480}, {1, 480}}}, /* an edge in common: one outline around both */
        {5, {{0, 0}, {1, 288}, {1, 128}, {2, 416}, {2, 416}}}, /* a corner in common: two */
        {8, {{0, 0}, {2, 216}, {1, 72}, {1, 288}, {1, 288}}},  /* a hole that is filled */
    };
    for (size_t k = 0; k < sizeof known / sizeof *known; k++) {
        clip_account_t account = {0};
        enum clip_fill fill;
        hard_pairs_build(known[k].pair, &subject, &clip, &fill);
        assert_null(clip_judge(&subject, &clip, fill, true, &account));
        for (int r = 0; r < 5; r++) {
            assert_int_equal(clip_judge_result[r].out.contours, known[k].of[r][0]);
            assert_int_equal(poly_area2(&clip_judge_result[r].poly), known[k].of[r][1]);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(hard_pairs_are_right), cmocka_unit_test(known_results)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
