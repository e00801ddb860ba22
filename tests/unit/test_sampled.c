/* test_sampled.c - what is computed from a parameter and drawn as data: '+', '++', sampling ranges, parametric and
 * polar curves; set mapping. Numbers of points and ranges are those that gnuplot writes with `set table`. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "session_fixture.h"

static void near(double a, double b) {
    assert_true(fabs(a - b) <= 1e-12 * (1 + fabs(b)));
}

static void check_ends(const fixture_t *f, int n, double from, double to) {
    assert_int_equal(f->points, n);
    near(f->x[0], from);
    near(f->x[n - 1], to);
}

static void a_file_of_one_parameter(void **state) {
    fixture_t *f = *state;
    assert_int_equal(fixture_feed(f, "set samples 5; plot '+' using 1:($1*2)"), 0);
    check_ends(f, 5, -10, 10);
    for (int k = 0; k < 5; k++) near(f->z[k], 2 * f->x[k]);
    assert_int_equal(fixture_feed(f, "set xrange [0:2]; plot '+' using (x):(x*x), '' using 1:1"), 0);
    near(f->x[4], 2);
    near(f->z[4], 4);
    near(f->z[9], 2);
    assert_int_equal(fixture_feed(f, "set trange [3:5]; plot '+' using 1:1"), 0);
    check_ends(f, 5, 3, 5);
    assert_int_equal(fixture_feed(f, "plot sample [t=-3:2.5:0.5] '+' using (t):(t**2)"), 0);
    check_ends(f, 12, -3, 2.5);
    assert_int_equal(fixture_feed(f, "plot sample [0:10:-1] '+' using 1:1"), ERR_VALUE);
    assert_int_equal(fixture_feed(f, "plot sample [t=0:1] '+' using (t):(q)"), ERR_NAME);
    /* Only some of the columns have no value: it is the first mistake that counts, and it ends the plot. */
    assert_int_equal(fixture_feed(f, "set parametric; plot sin(nobody),t"), ERR_NAME);
    assert_int_equal(fixture_feed(f, "set parametric 3"), ERR_SYNTAX);
    assert_int_equal(fixture_feed(f, "unset trange; reset; set samples 3; set logscale x; plot [1:100] '+' using 1:1"),
                     0);
    near(f->x[1], 1); /* evenly on the paper */
    near(f->z[1], 10);
    /* A range of its own is spread evenly, its open end being that of the axis. */
    assert_int_equal(fixture_feed(f, "plot [1:1000] sample [*:501] '+' using 1:1"), 0);
    near(f->z[0], 1);
    near(f->z[1], 251);
    near(f->z[2], 501);
    assert_int_equal(fixture_feed(f, "plot sample [*:500.1] '+' using 1:1"), 0);
    near(f->z[0], 0.1);
    near(f->z[1], 250.1);
    assert_int_equal(fixture_feed(f, "set logscale x 2; plot '+' using 1:1"), 0);
    near(f->x[0], log2(0.1)); /* as functions */
    near(f->z[0], 0.1);
    near(f->z[2], 10);
}

static void a_file_of_two_parameters(void **state) {
    fixture_t *f = *state;
    assert_int_equal(fixture_feed(f, "set samples 3,4; set isosamples 5,6; splot '++' using 1:2:($1*$2)"), 0);
    assert_int_equal(f->item[0].nx, 3);
    assert_int_equal(f->item[0].ny, 6);
    check_ends(f, 18, -5, 5);
    for (int k = 0; k < 18; k++) near(f->z[k], f->x[k] * f->y[k]);
    assert_int_equal(fixture_feed(f, "splot sample [u=0:2][v=3:5:2] '++' using (u):(v):(u+v), x*y"), 0);
    assert_int_equal(f->items, 2);
    assert_int_equal(f->item[0].ny, 2);
    near(f->z[5], 7);
    assert_int_equal(fixture_feed(f, "set urange [0:1]; set vrange [4:2]; splot '++' using (u):(v):(u*v)"), 0);
    near(f->x[2], 1);
    assert_int_equal(fixture_feed(f, "splot '++'"), ERR_DATA);
}

static void functions_over_ranges_of_their_own(void **state) {
    fixture_t *f = *state;
    assert_int_equal(fixture_feed(f, "set samples 3; plot sample [*:1] x, [t=1:5] t**2, x"), 0);
    static const double x[] = {-10, -4.5, 1, 1, 3, 5, -10, 0, 10};
    for (int k = 0; k < 9; k++) near(f->x[k], x[k]);
    near(f->z[4], 9);
    assert_int_equal(fixture_feed(f, "plot keyentry with points title 'k', x"), 0);
    assert_int_equal(f->items, 1);
}

static void parametric_and_polar_curves(void **state) {
    fixture_t *f = *state;
    assert_int_equal(fixture_feed(f, "set samples 5; set parametric; plot t, t**2, 2*t, 1"), 0);
    assert_int_equal(f->items, 2);
    near(f->x[0], -5);
    near(f->z[0], 25);
    near(f->x[9], 10);
    assert_int_equal(fixture_feed(f, "plot [0:1][-2:2] cos(t), sin(t)"), 0);
    near(f->x[4], cos(1));
    near(fixture_double(f->settings.x.hi), 2);
    assert_int_equal(fixture_feed(f, "plot t"), ERR_SYNTAX);
    assert_int_equal(fixture_feed(f, "set dummy p; plot p, x"), ERR_NAME);
    assert_int_equal(fixture_feed(f, "reset; set samples 5; set polar; plot 2"), 0);
    const double pi = acos(-1);
    for (int k = 0; k < 5; k++) {
        assert_true(fabs(f->x[k] - 2 * cos(k * pi / 2)) < 1e-12);
        assert_true(fabs(f->z[k] - 2 * sin(k * pi / 2)) < 1e-12);
    }
    fixture_file(f, 0, "g", "0 1\n90 2\n180 3\n");
    assert_int_equal(fixture_feed(f, "set angles degrees; plot 'g', t/90.0"), 0);
    near(f->x[0], 1);
    near(f->z[1], 2);
    near(f->x[2], -3);
    near(f->z[4], 1); /* 90 degrees */
}

static void mapped_data(void **state) {
    fixture_t *f = *state;
    fixture_file(f, 0, "g", "0 30\n90 30\n180 30\n");
    assert_int_equal(fixture_feed(f, "splot 'g'"), ERR_DATA); /* two columns */
    assert_int_equal(fixture_feed(f, "set angles degrees; set mapping spherical; splot 'g'"), 0);
    assert_int_equal(f->mesh.segments, 2);
    const packed_t *v = f->mesh.vertex[1];
    assert_true(fabs(fixture_double(packed_num(v[0]))) < 1e-12);
    near(fixture_double(packed_num(v[1])), sqrt(0.75));
    near(fixture_double(packed_num(v[2])), 0.5);
    assert_int_equal(fixture_feed(f, "set mapping cyl; splot 'g' using 1:2:(3)"), 0);
    v = f->mesh.vertex[2];
    near(fixture_double(packed_num(v[0])), -3);
    near(fixture_double(packed_num(v[2])), 30);
    assert_int_equal(fixture_feed(f, "unset mapping; splot 'g' using 1:2"), ERR_SYNTAX);
    assert_int_equal(fixture_feed(f, "set mapping conical"), ERR_SYNTAX);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_file_of_one_parameter, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(a_file_of_two_parameters, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(functions_over_ranges_of_their_own, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(parametric_and_polar_curves, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(mapped_data, fixture_setup, fixture_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
