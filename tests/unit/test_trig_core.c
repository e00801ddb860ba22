/* test_trig_core.c - what is left of an angle modulo 2^64 is what the difference of 128 bits has, for every k there is.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "num/trig_core.h"

/* floor((whole - k pi/128 2^57) / 2^57), whole a multiple of 2^57: less the steps rounded up. */
static void every_rest_is_the_long_one(void **state) {
    (void)state;
    const uint32_t last = trig_nearest(UINT64_C(0x7fffffffffffffff), -43) + 1;
    for (uint32_t k = 0; k <= last; k++) {
        const wide_t steps = trig_steps(k);
        const uint64_t up = ((uint64_t)steps.hi << 7 | steps.lo >> 57) + (steps.lo << 7 != 0);
        if (trig_rest_q69(0, -69, k) != (int64_t)(0 - up)) fail_msg("k = %u", (unsigned)k);
    }
    print_message("# %u multiples of pi/128\n", (unsigned)last);
    assert_true(last > 42000000);
}

/* An angle of 2^-7 or more and below 2^20, and no other, is a whole number of 2^-69 of which the nearest k is known. */
static void whole_ones_are_told(void **state) {
    (void)state;
    for (int e = -1200; e < 1000; e++) assert_int_equal(TRIG_WHOLE(e), e >= -69 && e <= -43);
    for (int e = -69; e <= -43; e++) {
        const uint64_t m = UINT64_C(0x5a5a5a5a5a5a5a5a);
        const wide_t rest = wide_sub(wide_shl(wide_from_s64((int64_t)m), e + 126), trig_steps(trig_nearest(m, e)));
        assert_true(trig_rest_q69(m, e, trig_nearest(m, e)) == (int64_t)wide_sar(rest, 57).lo);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_rest_is_the_long_one),
        cmocka_unit_test(whole_ones_are_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
