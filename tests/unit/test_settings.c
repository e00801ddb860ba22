/* test_settings.c - what set, unset, reset and show do to settings_t. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "session_fixture.h"

static const settings_t *settings(fixture_t *f) {
    return session_settings(&f->session);
}

static void check_range(const range_t *r, bool auto_lo, double lo, bool auto_hi, double hi, bool reverse) {
    assert_int_equal(r->auto_lo, auto_lo);
    assert_int_equal(r->auto_hi, auto_hi);
    assert_int_equal(r->reverse, reverse);
    if (!auto_lo) assert_true(fixture_double(r->lo) == lo);
    if (!auto_hi) assert_true(fixture_double(r->hi) == hi);
}

/* `show` prints commands: feeding them back to a fresh session must give the same settings and the same text. */
static void show_can_be_fed_back(void **state) {
    fixture_t *f = *state;
    assert_int_equal(fixture_feed(f,
                                  "set xrange [3:-2.5]; set yrange [*:7]; set zrange [1e-9:2e10]; set samples 7,8\n"
                                  "set isosamples 11; set view from 6,8,3.25 to 0,1,-1; set hidden3d horizon infinite\n"
                                  "set title 'A hill'; set xyplane at -2; set paper 200,150.5 margin 7.25\n"
                                  "set dummy u,v; set datafile separator ';'; set polar; set urange [0:2]\n"
                                  "set trange [*:7]; set mapping spherical; set dgrid3d 8,9 gauss 0.5; set logscale x\n"
                                  "set machine steps 80,100.5 speed 90 travel 150 accel 1500 junction 0.02 lift 0.15\n"
                                  "set machine lower 0.2 pulse 2.5 setup 1.5 enable 0.3 swap corexy size 300,200\n"
                                  "set machine pen solenoid 0.02,35 limits off home left,top pulloff 2.5, invert "
                                  "xy,enable,limits, enable 0.3"),
                     0);
    static char shown[8192], feed[8192];
    settings_t before = *settings(f);
    assert_int_equal(fixture_feed(f, "show all"), 0);
    strcpy(shown, f->out);
    /* the variables at its end are not settings */
    strcpy(feed, shown);
    *strstr(feed, "pi = ") = '\0';
    session_init(&f->session, &f->port, f->pool, sizeof f->pool);
    assert_int_equal(fixture_feed(f, feed), 0);
    assert_int_equal(fixture_feed(f, "show all"), 0);
    assert_string_equal(f->out, shown);
    const settings_t *s = settings(f);
    check_range(&s->x, false, -2.5, false, 3, true);
    check_range(&s->y, true, 0, false, 7, false);
    assert_memory_equal(&s->machine, &before.machine, sizeof s->machine);
    assert_int_equal(s->paper.height_um, 150500);
    assert_int_equal(s->paper.margin_um, 7250);
    assert_true(s->view.from && s->view.has_to && fixture_double(s->view.eye[2]) == 3.25);
    assert_int_equal(s->hidden, HIDDEN_HORIZON);
    assert_true(s->horizon_infinite);
    assert_true(f->session.axes == AXES_POLAR && f->session.mapping == DATA_SPHERICAL && f->session.scattered.on);
    assert_true(num_sign(f->session.log_base[0]) > 0 && num_sign(f->session.log_base[1]) == 0);
    check_range(&f->session.uv[0], false, 0, false, 2, false);
    check_range(&f->session.t, true, 0, false, 7, false);
    assert_int_equal(s->machine.steps_per_mm_q16[1], 100 * 65536 + 32768);
    assert_int_equal(s->machine.lift_us, 150000);
    assert_int_equal(s->machine.dir_setup_ns, 1500);
    assert_true(s->machine.invert[0] && s->machine.invert[1] && s->machine.swap_xy);
    assert_int_equal(s->machine.kinematics, MACHINE_COREXY);
    assert_int_equal(s->machine.home_far, 2);
    assert_int_equal(s->machine.pull_off_um, 2500);
    assert_int_equal(s->machine.limits, MACHINE_LIMITS_OFF);
    const hal_wiring_t *w = &s->machine.wiring;
    assert_true(w->pen == HAL_PEN_SOLENOID && w->pull_ms == 20 && w->hold_percent == 35);
    assert_int_equal(w->invert_pins, HAL_ENABLE);
    assert_int_equal(w->invert_inputs, HAL_IN_LIMIT_X | HAL_IN_LIMIT_Y);
    assert_int_equal(fixture_feed(f, "reset; show view; show paper"), 0);
    assert_string_equal(f->out, "set view 60,30,1,1\nset paper 297,210 margin 10\n");
}

static void defaults_are_gnuplots(void **state) {
    fixture_t *f = *state;
    const settings_t *s = settings(f);
    check_range(&s->x, true, 0, true, 0, false);
    assert_int_equal(s->samples[0], 100);
    assert_int_equal(s->isosamples[1], 10);
    assert_int_equal(s->hidden, HIDDEN_PERIMETER);
    assert_true(fixture_double(s->view.rot_x) == 60 && fixture_double(s->view.rot_z) == 30);
    assert_true(!s->xyplane_at && fixture_double(s->xyplane) == 0.5);
    assert_string_equal(s->title, "");
}

/* What gnuplot draws on the base plane and the axes decides about the box (seen in its pictures). */
static void border_and_tics(void **state) {
    fixture_t *f = *state;
    const settings_t *s = settings(f);
    assert_true(s->border_base && s->tics == SETTINGS_TICS_ALL);
    assert_int_equal(fixture_feed(f, "unset border; unset xtics"), 0);
    assert_true(!s->border_base && s->tics == (SETTINGS_TICS_Y | SETTINGS_TICS_Z));
    assert_int_equal(fixture_feed(f, "unset tics; set border 16; set ztics"), 0);
    assert_true(!s->border_base && s->tics == SETTINGS_TICS_Z);
    assert_int_equal(fixture_feed(f, "set border 4095 lw 2"), 0);
    assert_true(s->border_base);
    assert_int_equal(fixture_feed(f, "set tics; set xtics 0,1,2"), 0);
    assert_int_equal(s->tics, SETTINGS_TICS_ALL);
    assert_int_equal(fixture_feed(f, "unset border; unset tics; reset"), 0);
    assert_true(s->border_base && s->tics == SETTINGS_TICS_ALL);
}

static void ranges(void **state) {
    fixture_t *f = *state;
    const settings_t *s = settings(f);
    assert_int_equal(fixture_feed(f, "set xr [1:5]"), 0);
    check_range(&s->x, false, 1, false, 5, false);
    assert_int_equal(fixture_feed(f, "set xr [:3]"), 0);
    check_range(&s->x, false, 1, false, 3, false);
    assert_int_equal(fixture_feed(f, "set xr [7:]"), 0); /* 7 to 3 */
    check_range(&s->x, false, 3, false, 7, true);
    assert_int_equal(fixture_feed(f, "set xr [:9]"), 0); /* 7 to 9 */
    check_range(&s->x, false, 7, false, 9, false);
    assert_int_equal(fixture_feed(f, "set xr []; set xr"), 0);
    check_range(&s->x, false, 7, false, 9, false);
    assert_int_equal(fixture_feed(f, "set xr [*:9]"), 0);
    check_range(&s->x, true, 0, false, 9, false);
    assert_int_equal(fixture_feed(f, "a=2; set xr[-a:a**2]noextend; set yr [1:2]; set zr [3:4]"), 0);
    check_range(&s->x, false, -2, false, 4, false);
    assert_int_equal(fixture_feed(f, "set autoscale xzmin"), 0);
    check_range(&s->x, true, 0, false, 4, false);
    check_range(&s->z, true, 0, false, 4, false);
    assert_int_equal(fixture_feed(f, "set auto y"), 0);
    check_range(&s->y, true, 0, true, 0, false);
    assert_int_equal(fixture_feed(f, "set yr [1:2]; set auto; set xr [0:1] reverse"), 0);
    check_range(&s->y, true, 0, true, 0, false);
    assert_true(s->x.reverse);
    assert_int_equal(fixture_feed(f, "unset xr; set xr [1/0:2]"), ERR_VALUE);
    assert_int_equal(fixture_feed(f, "set auto foo"), ERR_SYNTAX);
    check_range(&s->x, true, 0, true, 0, false);
}

static void view_keeps_what_is_left_out(void **state) {
    fixture_t *f = *state;
    const settings_t *s = settings(f);
    assert_int_equal(fixture_feed(f, "set view 80,30,1,1; set view 50"), 0);
    assert_true(fixture_double(s->view.rot_x) == 50 && fixture_double(s->view.rot_z) == 30);
    assert_int_equal(fixture_feed(f, "set view ,45; set view ,,,0.7; set view"), 0);
    assert_true(fixture_double(s->view.rot_x) == 50 && fixture_double(s->view.rot_z) == 45);
    assert_true(fabs(fixture_double(s->view.zscale) - 0.7) < 1e-15);
    assert_int_equal(fixture_feed(f, "set view from 6,8,3"), 0);
    assert_true(s->view.from && !s->view.has_to);
    assert_int_equal(fixture_feed(f, "set view ,,1.5"), 0);
    assert_true(!s->view.from);
    assert_int_equal(fixture_feed(f, "set view 10,20,0"), ERR_VALUE);
    assert_true(fixture_double(s->view.rot_x) == 50); /* nothing of a wrong command is kept */
    assert_int_equal(fixture_feed(f, "set view 10,20; set view equal xyz; show view"), 0);
    assert_string_equal(f->out, "set view 10,20,1.5,0.7\nset view equal xyz\n");
    assert_int_equal(s->view.equal, 3);
    assert_int_equal(fixture_feed(f, "set view equal xy"), 0);
    assert_int_equal(s->view.equal, 2);
    assert_int_equal(fixture_feed(f, "set view equal yz"), ERR_SYNTAX);
    assert_int_equal(fixture_feed(f, "set view noequal_axes; set view azimuth 10"), 0);
    assert_int_equal(s->view.equal, 0);
    assert_non_null(strstr(f->err, "ignored"));
    assert_int_equal(fixture_feed(f, "unset view"), 0);
    assert_true(fixture_double(s->view.rot_z) == 30);
}

/* As gnuplot: what is compiled while degrees are set computes with them. */
static void angles_are_degrees_if_so_set(void **state) {
    fixture_t *f = *state;
    assert_int_equal(fixture_feed(f, "set angles degrees; g(x) = sin(x); a = 30\n"
                                     "print sin(90), cos(60), tan(45), asin(1), acos(0), atan(1), atan2(1,-1), sin(a), "
                                     "g(30), exp(0)\nshow angles"),
                     0);
    assert_string_equal(f->out, "1.0 0.5 1.0 90.0 90.0 45.0 135.0 0.5 0.5 1.0\nset angles degrees\n");
    assert_int_equal(
        fixture_feed(f, "set angles; print atan(1)*4; set angles deg; unset angles; print atan(1)*4; set ang d; reset"
                        "; print atan(1)*4"),
        0);
    assert_string_equal(f->out, "3.14159265358979\n3.14159265358979\n3.14159265358979\n");
    assert_int_equal(fixture_feed(f, "set angles grads"), ERR_SYNTAX);
}

static void paper(void **state) {
    fixture_t *f = *state;
    const settings_t *s = settings(f);
    assert_int_equal(fixture_feed(f, "set paper a3 portrait margin 15"), 0);
    assert_int_equal(s->paper.width_um, 297000);
    assert_int_equal(s->paper.height_um, 420000);
    assert_int_equal(s->paper.margin_um, 15000);
    assert_int_equal(fixture_feed(f, "set paper letter"), 0);
    assert_int_equal(s->paper.width_um, 279400);
    assert_int_equal(fixture_feed(f, "set paper portrait"), 0);
    assert_int_equal(s->paper.width_um, 215900);
    assert_int_equal(fixture_feed(f, "set paper 120,80.5"), 0);
    assert_int_equal(s->paper.height_um, 80500);
    assert_int_equal(fixture_feed(f, "set paper 120"), ERR_SYNTAX);
    assert_int_equal(fixture_feed(f, "unset paper"), 0);
    assert_int_equal(s->paper.width_um, 297000);
}

static void hidden3d(void **state) {
    fixture_t *f = *state;
    const settings_t *s = settings(f);
    assert_int_equal(fixture_feed(f, "unset hidden3d"), 0);
    assert_int_equal(s->hidden, HIDDEN_NONE);
    assert_int_equal(fixture_feed(f, "set hidden3d offset 0"), 0);
    assert_int_equal(s->hidden, HIDDEN_PERIMETER);
    assert_int_equal(fixture_feed(f, "set nohidden3d; set nokey"), 0);
    assert_int_equal(s->hidden, HIDDEN_NONE);
    assert_int_equal(fixture_feed(f, "set nofoo"), ERR_NAME);
    assert_int_equal(fixture_feed(f, "set hid horizon"), 0);
    assert_int_equal(s->hidden, HIDDEN_HORIZON);
    assert_int_equal(fixture_feed(f, "set hidden3d trianglepattern 3 undefined 1 noaltdiagonal front"), 0);
    assert_int_equal(s->hidden, HIDDEN_PERIMETER);
    assert_int_equal(fixture_feed(f, "set hidden3d none"), 0);
    assert_int_equal(s->hidden, HIDDEN_NONE);
    /* what show says is what set takes */
    static const char *const words[] = {"perimeter", "horizon infinite", "convex dashed", "halo",
                                        "area",      "perimeter dashed"};
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        char line[80], shown[80];
        snprintf(shown, sizeof shown, "set hidden3d %s\n", words[i]);
        snprintf(line, sizeof line, "set hidden3d %s; show hidden3d", words[i]);
        assert_int_equal(fixture_feed(f, line), 0);
        assert_string_equal(f->out, shown);
    }
}

static void titles(void **state) {
    fixture_t *f = *state;
    const settings_t *s = settings(f);
    assert_int_equal(fixture_feed(f, "set title \"a \\\"hill\\\"\" font 'x,3' offset 1,2; print 1"), 0);
    assert_string_equal(s->title, "a \"hill\"");
    assert_string_equal(f->out, "1\n");
    assert_int_equal(fixture_feed(f, "set title 'it''s'; show title"), 0);
    assert_string_equal(f->out, "set title 'it''s'\n");
    assert_int_equal(fixture_feed(f, "set title"), 0);
    assert_string_equal(s->title, "");
    char line[200];
    snprintf(line, sizeof line, "set title '%0120d'", 0);
    assert_int_equal(fixture_feed(f, line), 0);
    assert_int_equal(strlen(s->title), SETTINGS_TITLE_MAX - 1);
    assert_string_equal(f->err, "line 4: warning: the title is cut\n");
}

static void help_says_something(void **state) {
    fixture_t *f = *state;
    static const char *const topics[] = {"",           " splot",      " set view", " sp",      " set",
                                         " functions", " data",       " print",    " machine", " set paper",
                                         " hidden3d",  " isosamples", " quit",     " set xr"};
    for (size_t i = 0; i < sizeof topics / sizeof topics[0]; i++) {
        char line[64];
        snprintf(line, sizeof line, "help%s", topics[i]);
        assert_int_equal(fixture_feed(f, line), 0);
        assert_true(strlen(f->out) > 20);
        for (const char *p = f->out; *p; p += strcspn(p, "\n") + 1) assert_true(strcspn(p, "\n") <= 120);
    }
    assert_int_equal(fixture_feed(f, "?"), 0);
    assert_non_null(strstr(f->out, "splot"));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(defaults_are_gnuplots, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(show_can_be_fed_back, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(border_and_tics, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(ranges, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(view_keeps_what_is_left_out, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(angles_are_degrees_if_so_set, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(paper, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(hidden3d, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(titles, fixture_setup, fixture_teardown),
        cmocka_unit_test_setup_teardown(help_says_something, fixture_setup, fixture_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
