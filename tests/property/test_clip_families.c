/* The clipper on families of pairs that break clippers (tests/oracle/clip_families.h): combs, terraces, checkerboards,
 * rings that touch, fans, needles, walks, ribbons, spirals, windows; each with itself, with another of its kind or with
 * another kind, in each direction, from single units to nearly all of the range, judged by tests/oracle/clip_judge.h.
 * RIDGELINE_CASES multiplies the count, RIDGELINE_SEED tries one. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "tests/oracle/clip_families.h"
#include "tests/oracle/run_cases.h"

#define APART 1000000000 /* seeds of families are so far apart */

static void families_are_right(void **state) {
    (void)state;
    static clip_shape_t subject, clip;
    int failed = 0;
    for (int f = 0; f < clip_family_count(); f++) {
        clip_account_t account = {0};
        uint64_t first, to;
        if (!cases_seeds((uint64_t)f * APART, cases_scaled(400), &first, &to)) continue;
        for (uint64_t seed = first; seed < to && failed < 5; seed++) {
            enum clip_fill rule;
            clip_family_make(f, seed, &subject, &clip, &rule);
            const char *wrong = clip_judge(&subject, &clip, rule, seed % 200 == 0, &account);
            if (!wrong) continue;
            failed++;
            print_message("# FAILED RIDGELINE_SEED=%llu build/tests/property/test_clip_families: %s: %s\n",
                          (unsigned long long)seed, clip_family_name(f), wrong);
            clip_shape_print("subject", &subject);
            clip_shape_print("clip", &clip);
        }
        print_message("# clipper, %s: %lld pairs, %lld contours of results, %lld holes; %lld crossings rounded, sweeps "
                      "%.2f on average, %d at most; mean displacement of borders at worst %.3f units\n",
                      clip_family_name(f), (long long)account.pairs, (long long)account.contours,
                      (long long)account.holes, (long long)account.rounded,
                      account.pairs ? (double)account.sweeps / (double)account.pairs : 0, account.most_sweeps,
                      account.worst);
    }
    assert_int_equal(failed, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(families_are_right)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
