/* What one surface hides of another's edge in a vertical plane through the eye. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "hidden/surface/shade.h"

#define ONE_Q30 (INT32_C(1) << 30)
#define NEAR_ENOUGH 256 /* of 2^30 */

static void assert_shade(shade_t v, int32_t from, int32_t to) {
    assert_in_range((uint32_t)v.from_q30, (uint32_t)(from > NEAR_ENOUGH ? from - NEAR_ENOUGH : 0), (uint32_t)from);
    assert_in_range((uint32_t)v.to_q30, (uint32_t)(to > NEAR_ENOUGH ? to - NEAR_ENOUGH : 0), (uint32_t)to);
}

/* The near end of m, one down at distance 1, hides k, three down, from distance 3 on: the middle of [1, 5]. m rises
 * above the eye, so that the rest of k stays hidden. Whatever a unit of height is. */
static void test_in_space_in_any_unit(void **state) {
    (void)state;
    for (int bits = 4; bits <= 57; bits++) {
        const int64_t unit = INT64_C(1) << bits;
        const int64_t k_z[2] = {-3 * unit, -3 * unit}, m_z[2] = {-unit, 4 * unit};
        const int32_t d[2] = {INT32_C(1) << 27, 5 * (INT32_C(1) << 27)};
        assert_shade(shade_in_space(k_z, m_z, d, 4), ONE_Q30 / 2, ONE_Q30);
    }
}

/* Behind the level line of sight along m nothing of k is hidden that comes up through it; a lower m that rises hides.
 */
static void test_in_chart(void **state) {
    (void)state;
    const pencil_t k[2] = {{0, -1000}, {0, 1000}}, m[2] = {{0, 0}, {0, 0}};
    assert_shade(shade_in_chart(k, m), ONE_Q30 / 2, ONE_Q30 / 2);
    const pencil_t high[2] = {{0, 500}, {0, 500}}, low[2] = {{0, -500}, {0, 3000}};
    const shade_t v = shade_in_chart(high, low);
    assert_true(v.from_q30 < v.to_q30);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_in_space_in_any_unit),
        cmocka_unit_test(test_in_chart),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
