/* Shadows of seeded random scenes against rays to the lights (tests/oracle/light_ref.h): of any solids, of polygons
 * that are hard to sort, and of bodies that touch. RIDGELINE_CASES tries so many times more, RIDGELINE_SEED=n one. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "tests/oracle/light_ref.h"
#include "tests/oracle/run_cases.h"
#include "tests/oracle/solid_cases.h"

static bool try_scene(uint64_t seed, solid_make_t make, light_tally_t *n) {
    light_tally_t one = {0};
    solid_scene_t s;
    make(&s, seed, 3 + (int)(seed % 3));
    const bool good = light_ref_judge(&s, seed, NULL, 0, &one);
    solid_scene_free(&s);
    light_tally_add(n, &one);
    if (good) return true;
    printf("# FAILED RIDGELINE_SEED=%llu build/tests/property/test_light_random: ", (unsigned long long)seed);
    light_tally_tell(&one);
    printf("\n");
    return false;
}

static void tell(const char *name, const light_tally_t *n, int wrong) {
    print_message("# lights, %s: %lld scenes (in %lld something is behind the eye; %lld left out), %lld of %lld places "
                  "wrong (%lld more seen edge-on), %lld of %lld borders where nothing changes, %lld of %lld changes "
                  "without a border; %d scenes\n",
                  name, n->scenes, n->behind, n->left_out, n->places_wrong, n->places, n->edge_on, n->borders_wrong,
                  n->borders, n->changes_missed, n->changes, wrong);
}

static int run(const char *name, uint64_t from, uint64_t count, solid_make_t make) {
    light_tally_t n = {0};
    uint64_t first, to;
    int wrong = 0;
    if (!cases_seeds(from, cases_scaled(count), &first, &to)) return 0;
    for (uint64_t seed = first; seed < to; seed++) wrong += !try_scene(seed, make, &n);
    tell(name, &n, wrong);
    return wrong;
}

static void shadows_are_where_rays_end(void **state) {
    (void)state;
    assert_int_equal(run("solids", 0, 300, solid_scene_random), 0);
}
static void of_polygons(void **state) {
    (void)state;
    assert_int_equal(run("polygons", 1000000000, 60, solid_scene_polygons), 0);
}
static void of_bodies_that_touch(void **state) {
    (void)state;
    assert_int_equal(run("touching", 2000000000, 60, solid_scene_touching), 0);
}

/* Corners too far off the page to have a picture; a needle's shadow; a face behind a seam, seen along it; the shadow of
 * a face at which the light grazes. Plates with holes of which a light sees little more than an edge; corners of holes
 * that touch the outline there. */
static void once_wrong(void **state) {
    (void)state;
    static const uint64_t hard[] = {467, 2215, 875, 1407, 938, 450735};
    static const uint64_t plates[] = {1000000787, 1000001051, 1000000627};
    light_tally_t n = {0};
    uint64_t only;
    int wrong = 0;
    if (cases_only_seed(&only)) return;
    for (size_t k = 0; k < sizeof hard / sizeof *hard; k++) wrong += !try_scene(hard[k], solid_scene_random, &n);
    for (size_t k = 0; k < sizeof plates / sizeof *plates; k++)
        wrong += !try_scene(plates[k], solid_scene_polygons, &n);
    tell("once wrong", &n, wrong);
    assert_int_equal(wrong, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(shadows_are_where_rays_end), cmocka_unit_test(of_polygons),
                                       cmocka_unit_test(of_bodies_that_touch), cmocka_unit_test(once_wrong)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
