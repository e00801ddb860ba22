/* Hold and resume: the same steps in the same order, within the acceleration, and how long a stop takes. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "hal/hal.h"
#include "sim/sim.h"
#include "tests/oracle/motion_rig.h"

#define MS (HAL_TICK_HZ / 1000)

static uint32_t seed = 1;
static double uniform(void) {
    seed = seed * 1664525u + 1013904223u;
    return (seed >> 8) / 16777216.0;
}

static machine_t machine;

static void do_hold(void *ctx) {
    (void)ctx;
    stepgen_hold();
}
static void do_resume(void *ctx) {
    (void)ctx;
    stepgen_resume();
}

/* The holds of the next run: at tick, for so long (ticks). */
static struct { uint64_t at, length; } plan[2000];
static size_t plans;

static void schedule(void) {
    for (size_t i = 0; i < plans; i++) {
        sim_at(plan[i].at, do_hold, NULL);
        sim_at(plan[i].at + plan[i].length, do_resume, NULL);
    }
}

static rig_drawing_t straight(void) {
    rig_drawing_t d = {0};
    rig_move(&d, 10, 10);
    rig_draw(&d, 110, 10);
    return d;
}

static rig_drawing_t spiral(void) {
    rig_drawing_t d = {0};
    for (int i = 0; i < 2000; i++) {
        double t = i * 0.02, r = 1 + 1.2 * t;
        (i ? rig_draw : rig_move)(&d, 80 + r * cos(t), 80 + r * sin(t));
    }
    return d;
}

static rig_drawing_t scribble(void) {
    rig_drawing_t d = {0};
    for (int s = 0; s < 12; s++) {
        double x = 20 + 60 * uniform(), y = 20 + 60 * uniform();
        rig_move(&d, x, y);
        for (int i = 0; i < 40; i++) {
            double size = s % 3 == 0 ? 0.2 : s % 3 == 1 ? 3 : 25;
            x += size * (uniform() - 0.5);
            y += size * (uniform() - 0.5);
            rig_draw(&d, x, y);
        }
    }
    return d;
}

/* The beginnings of pulses with their direction, and the pen, in order. */
static size_t sequence(const trace_t *t, uint8_t *out) {
    size_t n = 0;
    for (size_t i = 0; i < t->count; i++) {
        const trace_event_t *e = &t->events[i];
        uint8_t rises = e->changed & e->pins & (HAL_X_STEP | HAL_Y_STEP);
        for (int k = 0; k < 2; k++) {
            if (!(rises & (k ? HAL_Y_STEP : HAL_X_STEP))) continue;
            out[n++] = (uint8_t)(1 + 2 * k + !!(e->pins & (k ? HAL_Y_DIR : HAL_X_DIR)));
        }
        if (e->changed & (HAL_PEN | HAL_ENABLE)) out[n++] = (uint8_t)(0x40 | (e->pins & (HAL_PEN | HAL_ENABLE)));
    }
    return n;
}

static void assert_same_steps(const trace_t *a, const trace_t *b) {
    uint8_t *x = malloc(a->count * 2 + 2), *y = malloc(b->count * 2 + 2);
    size_t n = sequence(a, x);
    assert_int_equal(n, sequence(b, y));
    assert_memory_equal(x, y, n);
    free(x);
    free(y);
}

/* Draws d undisturbed and with the plan's holds. */
static trace_judgement_t compare(const char *name, const rig_drawing_t *d, rig_run_t *held) {
    rig_run_t free_run = rig_run(d, &machine, MOTION_BYTES_HOST, NULL);
    *held = rig_run(d, &machine, MOTION_BYTES_HOST, schedule);
    assert_int_equal(held->error, 0);
    assert_int_equal(held->stats.starved, 0);
    assert_int_equal(held->stats.late, 0);
    assert_int_equal(held->stats.position_steps[0], 0);
    assert_int_equal(held->stats.position_steps[1], 0);
    trace_judgement_t before, after;
    trace_judge(&free_run.trace, &machine, &before);
    trace_judge(&held->trace, &machine, &after);
    /* Two holds in a row may last just as long as the pen's changes; all else must be legal. */
    after.unchanged = 0;
    if (!trace_is_legal(&after)) trace_print(&after, &machine, stdout);
    assert_true(trace_is_legal(&after));
    assert_same_steps(&free_run.trace, &held->trace);
    double jump[2] = {0, 0};
    for (int k = 0; k < 2; k++) {
        jump[0] = fmax(jump[0], before.axis[k].max_jump_mm_s);
        jump[1] = fmax(jump[1], after.axis[k].max_jump_mm_s);
    }
    printf("# %-22s %4zu holds: same %zu steps, acceleration %.0f mm/s^2 (undisturbed %.0f), jump %.2f mm/s (%.2f)\n",
           name, plans, (size_t)(after.axis[0].steps + after.axis[1].steps), after.max_accel, before.max_accel, jump[1],
           jump[0]);
    assert_true(after.max_accel < before.max_accel + 175);
    trace_free(&free_run.trace);
    return after;
}

/* From the command to the last step before the pause that follows. */
static void measure_stop(const trace_t *t, uint64_t at, double *seconds, double *mm) {
    uint64_t at_ps = at * 62500, last_ps = at_ps;
    size_t steps = 0;
    for (size_t i = 0; i < t->count; i++) {
        const trace_event_t *e = &t->events[i];
        if (e->time_ps < at_ps || !(e->changed & e->pins & HAL_X_STEP)) continue;
        if (e->time_ps - last_ps > 200000000000) break;
        last_ps = e->time_ps;
        steps++;
    }
    *seconds = (double)(last_ps - at_ps) * 1e-12;
    *mm = (double)steps / 80;
}

static void test_stop(void **state) {
    (void)state;
    rig_drawing_t d = straight();
    rig_run_t r;
    plans = 1;
    plan[0].at = 1000 * MS;
    plan[0].length = 700 * MS;
    compare("line at 100 mm/s", &d, &r);
    double seconds, mm;
    measure_stop(&r.trace, plan[0].at, &seconds, &mm);
    printf(
        "# hold at 100 mm/s, 1000 mm/s^2: %.1f ms and %.2f mm to the last step (ideal 100 and 5; Grbl 144 and 9.5)\n",
        seconds * 1e3, mm);
    assert_true(seconds > 0.09 && seconds < 0.1021); /* it begins within 2.05 ms */
    assert_true(mm > 4.9 && mm < 5.21);
    trace_free(&r.trace);
    rig_free(&d);
}

/* At any moment of a line: speeding up, at speed, slowing down, while the pen moves. */
static void test_every_moment(void **state) {
    (void)state;
    rig_drawing_t d = straight();
    double worst = 0;
    for (uint64_t ms = 0; ms < 2800; ms += 97) {
        plans = 1;
        plan[0].at = ms * MS + ms * 131 % MS;
        plan[0].length = 400 * MS;
        rig_run_t r = rig_run(&d, &machine, MOTION_BYTES_HOST, schedule);
        trace_judgement_t j;
        trace_judge(&r.trace, &machine, &j);
        if (!j.legal) trace_print(&j, &machine, stdout);
        assert_true(j.legal);
        assert_int_equal(j.axis[0].steps, 2 * 110 * 80);
        worst = fmax(worst, j.max_accel);
        trace_free(&r.trace);
    }
    printf("# 29 moments of a line: acceleration at most %.0f mm/s^2\n", worst);
    assert_true(worst < 1150);
    rig_free(&d);
}

static void many(const char *name, rig_drawing_t d, double seconds, size_t count, double longest_ms) {
    rig_run_t r;
    plans = count;
    uint64_t at = 0;
    for (size_t i = 0; i < count; i++) {
        at += (uint64_t)(uniform() * 2 * seconds * HAL_TICK_HZ / (double)count);
        plan[i].at = at;
        plan[i].length = (uint64_t)(uniform() * longest_ms * MS);
        at += plan[i].length;
    }
    compare(name, &d, &r);
    trace_free(&r.trace);
    rig_free(&d);
}

static void test_many(void **state) {
    (void)state;
    many("spiral", spiral(), 60, 60, 600);
    many("spiral, impatient", spiral(), 60, 400, 90); /* resumed while braking, held while speeding up */
    many("corners", scribble(), 15, 40, 500);
    many("corners, impatient", scribble(), 15, 300, 60);
}

static void test_other_machines(void **state) {
    (void)state;
    machine.kinematics = MACHINE_COREXY;
    many("CoreXY", scribble(), 15, 60, 300);
    machine_default(&machine);
    machine.accel_um_s2 = 10000000;
    machine.draw_speed_um_s = machine.travel_speed_um_s = 300000;
    many("10 m/s^2, 300 mm/s", scribble(), 5, 40, 300);
    machine.accel_um_s2 = 50000;
    many("50 mm/s^2", scribble(), 60, 30, 4000);
    machine_default(&machine);
}

/* Served late at times: the plan slips, steps are still not lost. */
static void inject(void) {
    schedule();
    sim_inject_late(97, 400);
}
static void test_late(void **state) {
    (void)state;
    rig_drawing_t d = scribble();
    plans = 1;
    plan[0].at = 3000 * MS;
    plan[0].length = 500 * MS;
    rig_run_t r = rig_run(&d, &machine, MOTION_BYTES_HOST, inject);
    trace_judgement_t j;
    trace_judge(&r.trace, &machine, &j);
    assert_true(j.legal);
    trace_free(&r.trace);
    rig_free(&d);
}

/* A hold across the wrap of the clock, and one that lasts longer than half a turn of it. */
static void set_clock(void) {
    schedule();
    sim_set_clock((uint32_t)-2000 * MS);
}
static void test_clock(void **state) {
    (void)state;
    rig_drawing_t d = straight();
    plans = 1;
    plan[0].at = 1000 * MS;
    plan[0].length = 400000ull * MS;
    rig_run_t r = rig_run(&d, &machine, MOTION_BYTES_HOST, set_clock);
    trace_judgement_t j;
    trace_judge(&r.trace, &machine, &j);
    assert_true(j.legal);
    assert_true(j.duration_s > 402 && j.duration_s < 404);
    trace_free(&r.trace);
    rig_free(&d);
}

static int setup(void **state) {
    (void)state;
    machine_default(&machine);
    return 0;
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_stop, setup), cmocka_unit_test_setup(test_every_moment, setup),
        cmocka_unit_test_setup(test_many, setup), cmocka_unit_test_setup(test_other_machines, setup),
        cmocka_unit_test_setup(test_late, setup), cmocka_unit_test_setup(test_clock, setup),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
