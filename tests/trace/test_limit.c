/* Limit switches and the emergency stop: homing, and what a switch that closes while drawing does to the pins. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "tests/unit/console_fixture.h"

#define SCENE "set paper 100,80 margin 5;set isosamples 15,15\rsplot exp(-x*x-y*y)\r"

/* A machine with switches: the carriage stands so many steps from them, and they close where they are. */
static struct {
    int32_t from[2]; /* steps from the switch at power-on */
    bool present[2], closed[2];
    bool far; /* they stand at the other end: x counts down towards them */
} machine;

static void watch(void *ctx, uint64_t tick, uint32_t pins, uint32_t changed) {
    static const uint8_t LIMIT[2] = {HAL_IN_LIMIT_X, HAL_IN_LIMIT_Y};
    fix_record(ctx, tick, pins, changed);
    for (int k = 0; k < 2; k++) {
        int32_t away = machine.far ? machine.from[k] - fix.at[k] : machine.from[k] + fix.at[k];
        bool closed = machine.present[k] && away <= 0;
        if (closed != machine.closed[k]) sim_inputs_set(tick + 1, LIMIT[k], closed ? LIMIT[k] : 0);
        machine.closed[k] = closed;
    }
}

static void power_on(int32_t x_steps, int32_t y_steps) {
    fix_power_on(sizeof fix.memory);
    machine.far = false;
    machine.from[0] = x_steps;
    machine.from[1] = y_steps;
    for (int k = 0; k < 2; k++) {
        machine.present[k] = true;
        machine.closed[k] = false;
    }
    sim_record(watch, NULL);
}

static int on(void **state) {
    (void)state;
    sim_store_erase();
    power_on(80 * 50, 80 * 30);
    return 0;
}

static void test_homing(void **state) {
    (void)state;
    static const int32_t FROM[][2] = {{4000, 2400}, {1, 1}, {20000, 60000}, {37, 9999}};
    for (size_t i = 0; i < sizeof FROM / sizeof FROM[0]; i++) {
        power_on(FROM[i][0], FROM[i][1]);
        uint64_t start = sim_now();
        fix_say("home\r", 0);
        assert_true(fix_heard("\r\nhome\r\n"));
        /* 3 mm off both switches, which it found by touching them slowly */
        for (int k = 0; k < 2; k++) {
            assert_in_range(machine.from[k] + fix.at[k], 239, 241);
            assert_false(machine.closed[k]);
        }
        printf("# homing from %.1f, %.1f mm: %.1f s, %d and %d steps from the switches\n", FROM[i][0] / 80.0,
               FROM[i][1] / 80.0, (double)(sim_now() - start) / HAL_TICK_HZ, machine.from[0] + fix.at[0],
               machine.from[1] + fix.at[1]);
        int32_t home[2] = {fix.at[0], fix.at[1]};
        fix_say("?", 10 * MS);
        assert_true(fix_heard("<Idle|MPos:0.000,0.000|Pen:up>"));
        fix_say(SCENE, 0);
        assert_int_equal(fix.at[0], home[0]);
        assert_int_equal(fix.at[1], home[1]);
    }
}

static void test_homing_on_the_switch(void **state) {
    (void)state;
    power_on(0, 0); /* both are closed before anything moves */
    sim_inputs_set(sim_now() + 1, HAL_IN_LIMIT_X | HAL_IN_LIMIT_Y, HAL_IN_LIMIT_X | HAL_IN_LIMIT_Y);
    machine.closed[0] = machine.closed[1] = true;
    fix_run(10 * MS);
    fix_say(SCENE, 0);
    assert_true(fix_heard("A limit switch or the emergency stop is closed"));
    assert_int_equal(fix.steps[0], 0);
    fix_say("home\r", 0);
    assert_true(fix_heard("\r\nhome\r\n"));
    for (int k = 0; k < 2; k++) assert_in_range(fix.at[k], 239, 241);
}

static void test_no_switch(void **state) {
    (void)state;
    machine.present[1] = false;
    fix_say("set machine size 200,150\rhome\r", 0);
    assert_true(fix_heard("ALARM: homing found no limit switch"));
    assert_int_equal(fix.at[1], -225 * 80); /* half as far again as the machine is long */
    fix_say("splot x\r", SECOND);
    assert_true(fix_heard("Locked: the position is unknown"));
    fix_say("unlock\r?", SECOND);
    assert_true(fix_heard("<Idle|"));
}

static void test_homing_stopped(void **state) {
    (void)state;
    fix_type("home\r");
    sim_console_type(SECOND, "\x18", 1);
    fix_run(0);
    fix_run(SECOND);
    assert_true(fix_heard("ALARM: homing was stopped"));
    fix_say("home\r", 0);
    assert_true(fix_heard("\r\nhome\r\n"));
}

/* A switch at every kind of moment of a drawing: no pulse begins after it, the pen goes up at that tick. */
static void test_hard_limit(void **state) {
    (void)state;
    int hits = 0;
    for (uint64_t ms = 300; ms < 12000; ms += 371) {
        power_on(1 << 20, 1 << 20);
        uint64_t tick = ms * MS + ms * 977 % MS;
        sim_inputs_set(tick, HAL_IN_LIMIT_Y, HAL_IN_LIMIT_Y);
        fix_say(SCENE, 0);
        assert_true(fix.last_step <= tick);
        assert_int_equal(fix.pins & (HAL_PEN | HAL_X_STEP | HAL_Y_STEP), 0);
        assert_true(fix.pins & HAL_ENABLE);
        assert_true(fix_heard("ALARM: a limit switch closed; position unknown"));
        fix_say("?", 10 * MS);
        assert_true(fix_heard("<Alarm|"));
        uint64_t steps = fix.steps[0] + fix.steps[1];
        fix_say("replot\rpen down\r", SECOND);
        assert_int_equal(fix.steps[0] + fix.steps[1], steps);
        assert_int_equal(fix.pins & HAL_PEN, 0);
        hits++;
    }
    printf("# %d limit hits: no pulse begins after the switch, pen up at its tick\n", hits);
    sim_inputs_set(sim_now() + 1, HAL_IN_LIMIT_Y, 0);
    fix_say("unlock\rreplot\r", 0);
    assert_int_equal(fix.pins & (HAL_PEN | HAL_ENABLE), 0);
}

static void test_emergency_stop(void **state) {
    (void)state;
    sim_inputs_set(5 * SECOND, HAL_IN_ESTOP, HAL_IN_ESTOP);
    fix_say(SCENE, 0);
    assert_true(fix.last_step <= 5 * SECOND);
    assert_int_equal(fix.pins & ~(uint32_t)(HAL_X_DIR | HAL_Y_DIR), 0); /* motors off, too */
    assert_true(fix_heard("ALARM: emergency stop"));
    fix_say("unlock\rhome\rsplot x\r", SECOND);
    assert_int_equal(fix.pins & HAL_ENABLE, 0);
    sim_inputs_set(sim_now() + 1, HAL_IN_ESTOP, 0);
    fix_say("unlock\r", SECOND);
    assert_true(fix_heard("unlocked"));
}

/* Switches at the right and the top, pulled off by 1.5 mm: the place is the machine's other corner. */
static void test_homing_far(void **state) {
    (void)state;
    machine.far = true;
    fix_say("set machine home right,top\r", SECOND);
    assert_true(fix_heard("home right and home top need the machine's size"));
    fix_say("set machine size 200,150 home right,top pulloff 1.5\rhome\r", 0);
    fix_say("?", 10 * MS);
    assert_true(fix_heard("<Idle|MPos:200.000,150.000|Pen:up>"));
    for (int k = 0; k < 2; k++) assert_in_range(machine.from[k] - fix.at[k], 119, 121);
    const int32_t corner[2] = {fix.at[0], fix.at[1]};
    fix_say(SCENE, 0); /* ends at the page's origin */
    assert_int_equal(corner[0] - fix.at[0], 200 * 80);
    assert_int_equal(corner[1] - fix.at[1], 150 * 80);
}

/* limits homing: they do not stop a drawing; off: there is nothing to home to. */
static void test_limits_off(void **state) {
    (void)state;
    power_on(1 << 20, 1 << 20);
    fix_say("set machine limits homing\r", SECOND);
    sim_inputs_set(sim_now() + 3 * SECOND, HAL_IN_LIMIT_X, HAL_IN_LIMIT_X);
    fix_say(SCENE, 0);
    assert_false(fix_heard("ALARM"));
    assert_true(fix.steps[0] > 1000);
    fix_say("set machine limits off\rhome\r", SECOND);
    assert_true(fix_heard("There are no limit switches to home to"));
    fix_say("?", 10 * MS);
    assert_true(fix_heard("<Idle|"));
    fix_say("set machine limits on\rreplot\r", SECOND);
    assert_true(fix_heard("A limit switch or the emergency stop is closed"));
    /* The other level: the same switch is now open. */
    uint64_t steps = fix.steps[0];
    fix_say("set machine invert limits\r", SECOND);
    sim_inputs_set(sim_now() + 1, HAL_IN_LIMIT_Y, HAL_IN_LIMIT_Y);
    fix_run(SECOND);
    fix_say("replot\r", 0);
    assert_true(fix.steps[0] > steps);
    sim_inputs_set(sim_now() + 1, HAL_IN_ESTOP, HAL_IN_ESTOP);
    fix_run(SECOND);
    fix_say("home\r", SECOND);
    assert_true(fix_heard("The emergency stop is pressed"));
}

/* A held machine that hits nothing may be hit itself. */
static void test_limit_while_held(void **state) {
    (void)state;
    power_on(1 << 20, 1 << 20);
    fix_type(SCENE);
    sim_console_type(4 * SECOND, "!", 1);
    sim_inputs_set(6 * SECOND, HAL_IN_LIMIT_X, HAL_IN_LIMIT_X);
    fix_run(SECOND);
    assert_true(fix_heard("ALARM: a limit switch closed"));
    assert_true(fix.last_step < 4 * SECOND + 101 * MS);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_homing, on),           cmocka_unit_test_setup(test_homing_on_the_switch, on),
        cmocka_unit_test_setup(test_no_switch, on),        cmocka_unit_test_setup(test_homing_stopped, on),
        cmocka_unit_test_setup(test_hard_limit, on),       cmocka_unit_test_setup(test_emergency_stop, on),
        cmocka_unit_test_setup(test_limit_while_held, on), cmocka_unit_test_setup(test_homing_far, on),
        cmocka_unit_test_setup(test_limits_off, on),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
