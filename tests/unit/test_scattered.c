/* test_scattered.c - set dgrid3d: means of scattered heights, against the formulas in floating point. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "session_fixture.h"

enum { POINTS = 37 };
static double at[POINTS][3];

/* Blank lines and data sets mean nothing; neither does a point without a height. */
static void make(fixture_t *f) {
    static char text[POINTS * 64];
    uint32_t dice = 12345;
    size_t n = 0;
    for (int i = 0; i < POINTS; i++) {
        for (int k = 0; k < 3; k++) {
            dice = dice * 1664525 + 1013904223;
            at[i][k] = (double)(dice >> 16) / 4096;
        }
        n += (size_t)snprintf(text + n, sizeof text - n, "%s%.10f %.10f %.10f\n", i % 7 == 3 ? "\n1 2 NaN\n\n" : "",
                              at[i][0], at[i][1], at[i][2]);
    }
    fixture_file(f, 0, "s", text);
}

static double mean(double x, double y, double (*weight)(double r), double sx, double sy) {
    double sum = 0, weights = 0;
    for (int i = 0; i < POINTS; i++) {
        const double r = hypot((at[i][0] - x) / sx, (at[i][1] - y) / sy);
        if (r == 0) return at[i][2];
        sum += weight(r) * at[i][2];
        weights += weight(r);
    }
    return sum / weights;
}

static double over_r(double r) {
    return 1 / r;
}
static double over_r4(double r) {
    return pow(r, -4);
}
static double over_r3(double r) {
    return pow(r, -3);
}
static double gauss(double r) {
    return exp(-r * r);
}
static double exponential(double r) {
    return exp(-r);
}
static double cauchy(double r) {
    return 1 / (1 + r * r);
}
static double box(double r) {
    return r < 1;
}
static double hann(double r) {
    return r < 1 ? (1 + cos(acos(-1) * r)) / 2 : 0;
}

static void heights_are_means(void **state) {
    static const struct {
        const char *set;
        double (*weight)(double r);
        double sx, sy;
        int nx, ny;
    } cases[] = {
        {"", over_r, 1, 1, 10, 10},
        {"5,7", over_r, 1, 1, 7, 5},
        {"4 qnorm 4", over_r4, 1, 1, 4, 4},
        {",,3", over_r3, 1, 1, 10, 10},
        {"6,6 gauss 9", gauss, 9, 9, 6, 6},
        {"6,6 exp", exponential, 1, 1, 6, 6},
        {"6,6 cauchy 3,2", cauchy, 3, 2, 6, 6},
        {"6,6 box 4", box, 4, 4, 6, 6},
        {"6,6 hann 4,5", hann, 4, 5, 6, 6},
    };
    fixture_t *f = *state;
    make(f);
    for (size_t c = 0; c < sizeof cases / sizeof cases[0]; c++) {
        char line[80];
        snprintf(line, sizeof line, "set dgrid3d %s; splot 's'", cases[c].set);
        assert_int_equal(fixture_feed(f, line), 0);
        assert_int_equal(f->item[0].nx, cases[c].nx);
        assert_int_equal(f->item[0].ny, cases[c].ny);
        for (int k = 0; k < f->points; k++) {
            const double z = mean(f->x[k], f->y[k], cases[c].weight, cases[c].sx, cases[c].sy);
            assert_true(isnan(z) ? isnan(f->z[k]) : fabs(f->z[k] - z) < 1e-8 * (1 + fabs(z)));
        }
    }
}

static void sums_and_the_point_itself(void **state) {
    fixture_t *f = *state;
    fixture_file(f, 0, "s", "0 0 3\n4 2 5\n0 2 7\n");
    assert_int_equal(fixture_feed(f, "set dgrid3d 2; splot 's'"), 0);
    assert_true(f->z[0] == 3 && f->z[2] == 7 && f->z[3] == 5);
    assert_int_equal(fixture_feed(f, "set dgrid3d 2 gauss kdensity 1; splot 's'"), 0);
    assert_true(fabs(f->z[0] - (3 + 5 * exp(-20) + 7 * exp(-4))) < 1e-12);
}

static void what_is_wrong_is_told(void **state) {
    fixture_t *f = *state;
    make(f);
    assert_int_equal(fixture_feed(f, "splot 's'"), 0);
    assert_non_null(strstr(f->err, "set dgrid3d"));
    fixture_file(f, 1, "line", "0 0 3\n0 2 5\n");
    assert_int_equal(fixture_feed(f, "set dgrid3d; splot 'line'"), ERR_EMPTY);
    assert_int_equal(fixture_feed(f, "set dgrid3d 1,1"), ERR_VALUE);
    assert_int_equal(fixture_feed(f, "set dgrid3d gauss -1"), ERR_VALUE);
    assert_int_equal(fixture_feed(f, "set dgrid3d frob"), ERR_SYNTAX);
    assert_int_equal(fixture_feed(f, "set dgrid3d 3 hann 2,1.5; show dgrid3d; unset dgrid3d; show dgrid3d"), 0);
    assert_string_equal(f->out, "set dgrid3d 3,3 hann 2.0,1.5\nunset dgrid3d\n");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(heights_are_means, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(sums_and_the_point_itself, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(what_is_wrong_is_told, fixture_setup, fixture_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
