/* Ranges that gnuplot 5.4 printed (GPVAL_Z_MIN, GPVAL_Z_MAX) for data with known ends. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "error.h"
#include "view/autoscale.h"

static double to_double(num_t a) {
    return (double)a.m * __builtin_ldexp(1.0, a.e);
}

static num_t decimal(int64_t mantissa, int exp10) {
    num_t a = num_from_decimal((uint64_t)(mantissa < 0 ? -mantissa : mantissa), exp10);
    return mantissa < 0 ? num_neg(a) : a;
}

static const range_t OPEN = {.auto_lo = true, .auto_hi = true};

static void agrees_with_gnuplot(void **state) {
    (void)state;
    static const struct {
        int64_t lo, hi;
        int exp10;
        double want_lo, want_hi;
    } CASES[] = {
        {411, 3411, -4, 0, 0.35},         {1507, 12507, -4, 0, 1.4},     {3151, 26151, -4, 0, 3},
        {6439, 53439, -4, 0.5, 5.5},      {13563, 112563, -4, 1, 12},    {1781, 14781, -3, 0, 16},
        {3699, 30699, -3, 0, 35},         {16851, 139851, -7, 0, 0.014}, {1691265, 14036265, -4, 0, 1600},
        {685, 5685, -4, 0, 0.6},          {11234, 93234, -4, 1, 10},     {137, 1137, -10, 0, 1.2e-7},
        {83570000, 693570000, 0, 0, 7e8}, {3, 3, 0, 2.97, 3.03},         {0, 0, 0, -1, 1},
        {-250, -250, 0, -253, -247},      {-10, 10, 0, -10, 10},
    };
    for (size_t k = 0; k < sizeof CASES / sizeof CASES[0]; k++) {
        num_t lo = decimal(CASES[k].lo, CASES[k].exp10), hi = decimal(CASES[k].hi, CASES[k].exp10);
        assert_int_equal(autoscale_range(&OPEN, AUTOSCALE_TICS, &lo, &hi), 0);
        double scale = CASES[k].want_hi - CASES[k].want_lo;
        assert_float_equal((float)(to_double(lo) / scale), (float)(CASES[k].want_lo / scale), 1e-6);
        assert_float_equal((float)(to_double(hi) / scale), (float)(CASES[k].want_hi / scale), 1e-6);
    }
}

static void keeps_fixed_ends(void **state) {
    (void)state;
    range_t low_fixed = {.auto_hi = true, .lo = decimal(5, -2)};
    num_t lo = decimal(0, 0), hi = decimal(1, 0);
    assert_int_equal(autoscale_range(&low_fixed, AUTOSCALE_TICS, &lo, &hi), 0);
    assert_int_equal(num_cmp(lo, low_fixed.lo), 0);
    assert_float_equal((float)to_double(hi), 1.0f, 1e-6);
}

static void stays_without_tics(void **state) {
    (void)state;
    num_t lo = decimal(411, -4), hi = decimal(3411, -4);
    assert_int_equal(autoscale_range(&OPEN, AUTOSCALE_NONE, &lo, &hi), 0);
    assert_int_equal(num_cmp(lo, decimal(411, -4)), 0);
    assert_int_equal(num_cmp(hi, decimal(3411, -4)), 0);
}

static void refuses_empty_ranges(void **state) {
    (void)state;
    range_t same = {.lo = decimal(2, 0), .hi = decimal(2, 0)}, above = {.auto_hi = true, .lo = decimal(9, 0)};
    num_t lo = decimal(0, 0), hi = decimal(1, 0);
    assert_int_equal(autoscale_range(&same, AUTOSCALE_TICS, &lo, &hi), ERR_VALUE);
    lo = decimal(0, 0), hi = decimal(1, 0);
    assert_int_equal(autoscale_range(&above, AUTOSCALE_TICS, &lo, &hi), ERR_VALUE);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(agrees_with_gnuplot),
        cmocka_unit_test(keeps_fixed_ends),
        cmocka_unit_test(stays_without_tics),
        cmocka_unit_test(refuses_empty_ranges),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
