/* The hard list of lights (tests/oracle/hard_lights.h) against rays. RIDGELINE_CASE draws one alone. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "tests/oracle/hard_lights.h"
#include "tests/oracle/light_ref.h"

static void lights_reach_what_rays_do(void **state) {
    (void)state;
    const char *one = getenv("RIDGELINE_CASE");
    light_tally_t all = {0};
    int failed = 0;
    for (int i = 0; i < hard_lights_count(); i++) {
        if (one && atoi(one) != i) continue;
        light_tally_t n = {0};
        light_t light[LIGHTS_MAX];
        solid_scene_t s;
        const int lights = hard_lights_build(i, &s, light);
        bool good = true;
        for (uint64_t seed = 0; seed < 12; seed++) good &= light_ref_judge(&s, seed, light, lights, &n);
        solid_scene_free(&s);
        light_tally_add(&all, &n);
        if (good) continue;
        failed++;
        printf("# FAILED %s: ", hard_lights_name(i));
        light_tally_tell(&n);
        printf("\n#   repeat: RIDGELINE_CASE=%d build/tests/hard/test_hard_lights\n", i);
    }
    print_message("# lights, hard list: %d, %lld of %lld places wrong, %lld of %lld borders where nothing changes, "
                  "%lld of %lld changes without a border\n",
                  hard_lights_count(), all.places_wrong, all.places, all.borders_wrong, all.borders, all.changes_missed,
                  all.changes);
    assert_int_equal(failed, 0);
    assert_int_equal(all.left_out, 0);
    if (!one) assert_true(all.places > 10000 && all.borders > 1000 && all.changes > 500);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(lights_reach_what_rays_do)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
