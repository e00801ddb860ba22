/* test_log_axes.c - set logscale: logarithms are drawn, over ranges as gnuplot's. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "session_fixture.h"

#define EACH(f, k) for (int k = 0; k < (f)->points; k++)

static void near(double a, double b) {
    assert_true(fabs(a - b) <= 1e-12 * (1 + fabs(b)));
}

static void heights_are_logarithms(void **state) {
    fixture_t *f = *state;
    assert_int_equal(fixture_feed(f, "set isosamples 5; set logscale z; splot x*y+3"), 0);
    EACH(f, k) {
        const double z = f->x[k] * f->y[k] + 3;
        if (z > 0)
            near(f->z[k], log10(z));
        else
            assert_true(isnan(f->z[k]));
    }
    assert_int_equal(f->settings.log_axes, 4);
    near(f->x[0], -10);
    assert_int_equal(fixture_feed(f, "unset logscale; replot"), 0);
    near(f->z[0], 103);
    assert_int_equal(f->settings.log_axes, 0);
}

/* Functions are asked at equal distances on the paper: powers of x. */
static void functions_of_logarithms(void **state) {
    fixture_t *f = *state;
    assert_int_equal(fixture_feed(f, "set samples 4; set logscale x; plot [1:1000] x**2"), 0);
    for (int k = 0; k < 4; k++) {
        near(f->x[k], k);
        near(f->z[k], pow(100, k));
    }
    assert_int_equal(fixture_feed(f, "set logscale y 2; plot [1:1000] x"), 0);
    for (int k = 0; k < 4; k++) near(f->z[k], k * log2(10));
    assert_int_equal(fixture_feed(f, "set isosamples 4; set logscale; splot [][1:1000] x/y"), 0);
    near(f->x[0], -1); /* 0.1 to 10, where [-10:10] has no logarithms */
    near(f->x[3], 1);
    EACH(f, k) near(f->z[k], f->x[k] - f->y[k]);
}

static void data_are_converted(void **state) {
    fixture_t *f = *state;
    fixture_file(f, 0, "g", "1 1 10\n10 1 0\n100 1 -3\n\n1 2 1\n10 2 100\n100 2 1e5\n");
    assert_int_equal(fixture_feed(f, "set logscale xz; splot 'g'"), 0);
    static const double z[] = {1, NAN, NAN, 0, 2, 5};
    assert_int_equal(f->points, 6);
    EACH(f, k) {
        near(f->x[k], k % 3);
        near(f->y[k], 1 + k / 3);
        assert_true(isnan(z[k]) ? isnan(f->z[k]) : fabs(f->z[k] - z[k]) < 1e-12);
    }
    assert_int_equal(fixture_feed(f, "plot 'g' using 1:3"), 0);
    near(f->x[0], 0);
    near(f->z[0], 10);
}

/* The ranges that the picture gets, and what else is in the units of the data; all as before afterwards. */
static void ranges_are_logarithms(void **state) {
    fixture_t *f = *state;
    assert_int_equal(fixture_feed(f, "set logscale; set zrange [0:1000]; set yrange [100:1]; set xyplane at 0.01"), 0);
    assert_int_equal(fixture_feed(f, "set view from 10,100,1000; splot x*y"), 0);
    near(fixture_double(f->settings.z.lo), -1); /* as gnuplot */
    near(fixture_double(f->settings.z.hi), 3);
    near(fixture_double(f->settings.y.hi), 2);
    near(fixture_double(f->settings.xyplane), -2);
    for (int k = 0; k < 3; k++) near(fixture_double(f->settings.view.eye[k]), k + 1);
    near(fixture_double(f->session.settings.view.eye[2]), 1000);
    near(fixture_double(f->session.settings.xyplane), 0.01);
    near(fixture_double(f->session.settings.z.hi), 1000);
    assert_int_equal(fixture_feed(f, "set view from 1,1,0; replot"), ERR_VALUE);
    near(fixture_double(f->session.settings.view.eye[0]), 1);
    assert_int_equal(fixture_feed(f, "set view 60,30; set xrange [-3:-1]; replot"), ERR_VALUE);
    assert_non_null(strstr(f->err, "no values but above 0"));
    assert_int_equal(fixture_feed(f, "set xrange [0:0.01]; replot"), ERR_VALUE);
    assert_int_equal(fixture_feed(f, "reset; splot x"), 0);
    near(f->x[0], -10);
}

static void axes_and_bases(void **state) {
    fixture_t *f = *state;
    assert_int_equal(fixture_feed(f, "set logscale zcb; set log x2y 2; show logscale"), 0);
    assert_string_equal(f->out, "set logscale y 2.0\nset logscale z 10.0\n");
    assert_int_equal(fixture_feed(f, "unset logscale z; set nolog y; show logscale"), 0);
    assert_string_equal(f->out, "");
    assert_int_equal(fixture_feed(f, "set logscale q"), ERR_NAME);
    assert_int_equal(fixture_feed(f, "set logscale x 1"), ERR_VALUE);
    assert_int_equal(fixture_feed(f, "set logscale x 10 y"), ERR_SYNTAX);
    assert_int_equal(fixture_feed(f, "set nonlinear x via log10(x); splot x"), ERR_UNSUPPORTED);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(heights_are_logarithms, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(functions_of_logarithms, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(data_are_converted, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(ranges_are_logarithms, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(axes_and_bases, fixture_setup, fixture_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
