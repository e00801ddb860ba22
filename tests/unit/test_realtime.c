/* realtime.h: what is answered while a drawing runs. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "tests/unit/console_fixture.h"

#define SCENE "set paper 100,80 margin 5;set isosamples 15,15\rsplot exp(-x*x-y*y)\r"

static int on(void **state) {
    (void)state;
    sim_store_erase();
    fix_power_on(sizeof fix.memory);
    return 0;
}

static void at(double seconds, const char *text) {
    sim_console_type((uint64_t)(seconds * HAL_TICK_HZ), text, strlen(text));
}

/* The n-th status line said. */
static const char *status(int n) {
    const char *p = fix.said;
    while ((p = strchr(p, '<')) && n--) p++;
    return p;
}

static bool is_status(int n, const char *state) {
    const char *p = status(n);
    return p && strncmp(p + 1, state, strlen(state)) == 0;
}

static double field(int n, const char *name) {
    const char *p = strstr(status(n), name);
    return p && p[strlen(name)] != '?' ? atof(p + strlen(name)) : -1;
}

static void test_status(void **state) {
    (void)state;
    at(0.1, SCENE);
    for (int s = 1; s < 200; s++) at(s, "?");
    fix_run(SECOND);
    double total = (double)fix.last_step / HAL_TICK_HZ, worst = 0, last = 0;
    fix_run((uint64_t)(201 - total) * SECOND);
    int n = 0;
    for (; is_status(n, "Run"); n++) {
        double now = n + 1, left = field(n, "Left:"), done = field(n, "Done:");
        assert_true(done >= last || done < 0);
        last = done;
        if (left < 0) continue;
        double error = now + left - total;
        if (now > total / 4 && fabs(error) > worst) worst = fabs(error);
    }
    printf("# drawing of %.0f s: %d answers, seconds left within %.0f s after the first quarter\n", total, n, worst);
    assert_true(n > 20 && fabs(n - total) < 3);
    assert_true(worst < total / 4);
    assert_true(is_status(n, "Idle|MPos:0.000,0.000|Pen:up>"));
}

static void test_hold_and_resume(void **state) {
    (void)state;
    fix_say(SCENE, 0);
    uint64_t steps[2] = {fix.steps[0], fix.steps[1]}, took = fix.last_step;
    fix_power_on(sizeof fix.memory);
    at(0.1, SCENE);
    at(5, "!");
    at(6, "?");
    at(20, "?");
    at(21, "~");
    at(22, "?");
    fix_run(SECOND);
    assert_true(is_status(0, "Hold"));
    assert_true(is_status(1, "Hold"));
    assert_int_equal(strncmp(status(0), status(1), 30), 0); /* it stood still */
    assert_true(is_status(2, "Run"));
    assert_int_equal(fix.steps[0], steps[0]);
    assert_int_equal(fix.steps[1], steps[1]);
    assert_int_equal(fix.at[0], 0);
    double longer = ((double)fix.last_step - (double)took) / HAL_TICK_HZ;
    assert_true(longer > 15.9 && longer < 16.3);
}

/* Ctrl-X at many moments: it stops within its braking distance, pen up, motors on, knows where it is, and the next
 * drawing ends at home. */
static void test_stop(void **state) {
    (void)state;
    for (double s = 0.5; s < 12; s += 0.97) {
        fix_power_on(sizeof fix.memory);
        at(0.1, SCENE);
        at(s, "\x18");
        at(s + 0.0002, "print 99\r"); /* comes after the stop, so it counts */
        fix_run(SECOND);
        double after = (double)fix.last_step / HAL_TICK_HZ - s;
        assert_true(after < 0.101);
        assert_int_equal(fix.pins & (HAL_PEN | HAL_ENABLE), HAL_ENABLE);
        assert_true(fix_heard("stopped"));
        assert_true(fix_heard("\r\n99\r\n"));
        fix_say("?", 50 * MS);
        char place[64];
        snprintf(place, sizeof place, "<Idle|MPos:%.3f,%.3f|Pen:up>", fix.at[0] / 80.0, fix.at[1] / 80.0);
        if (strncmp(status(0), place, 16) != 0) print_message("%s is not %s\n", status(0), place);
        assert_true(fabs(field(0, "MPos:") - fix.at[0] / 80.0) < 0.002);
        fix_say("replot\r", 0);
        assert_int_equal(fix.at[0], 0);
        assert_int_equal(fix.at[1], 0);
        assert_int_equal(fix.pins & (HAL_PEN | HAL_ENABLE), 0);
    }
}

/* Stopped while held, while braking, and twice. */
static void test_stop_held(void **state) {
    (void)state;
    at(0.1, SCENE);
    at(5, "!");
    at(7, "\x18\x18");
    fix_run(SECOND);
    assert_true((double)fix.last_step / HAL_TICK_HZ < 5.11);
    assert_int_equal(fix.pins & HAL_PEN, 0);
    fix_power_on(sizeof fix.memory);
    at(0.1, SCENE);
    at(5, "!~!~!\x18");
    fix_run(SECOND);
    assert_true((double)fix.last_step / HAL_TICK_HZ < 5.11);
    assert_true(fix_heard("stopped"));
}

/* Operators in lines that are typed ahead stay what they are. */
static void test_typed_ahead(void **state) {
    (void)state;
    at(0.1, SCENE);
    at(3, "print 1>0?5:6, !0, ~0\r");
    at(4, "?print 77\r");
    fix_run(SECOND);
    assert_true(is_status(0, "Run"));
    assert_true(fix_heard("\r\n5 1 -1\r\n"));
    assert_true(fix_heard("\r\n77\r\n"));
    fix_say("?", 100 * MS);
    fix_say("print 0?1:2\x15?", 100 * MS); /* an emptied line is a new one */
    assert_true(is_status(2, "Idle"));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_status, on),      cmocka_unit_test_setup(test_hold_and_resume, on),
        cmocka_unit_test_setup(test_stop, on),        cmocka_unit_test_setup(test_stop_held, on),
        cmocka_unit_test_setup(test_typed_ahead, on),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
