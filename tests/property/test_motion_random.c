/* Random machines draw random paths: whatever the numbers, the trace is legal, ends at home, stays on the path and
 * takes the time of infinite look-ahead. RIDGELINE_SEED=n repeats a failure,
 * RIDGELINE_CASES tries so many times more. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "error.h"
#include "hal/hal.h"
#include "tests/oracle/motion_rig.h"
#include "tests/oracle/run_cases.h"

#define RUNS 120

static uint64_t seed;
static double uniform(void) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(seed >> 40) / 16777216.0;
}
/* Between lo and hi, every factor as likely. */
static double spread(double lo, double hi) {
    return lo * pow(hi / lo, uniform());
}

static machine_t random_machine(void) {
    machine_t m;
    machine_default(&m);
    for (int i = 0; i < 2; i++) {
        m.steps_per_mm_q16[i] = (uint32_t)(spread(0.1, 2000) * 65536);
        m.invert[i] = uniform() < 0.5;
    }
    if (uniform() < 0.7) m.steps_per_mm_q16[1] = m.steps_per_mm_q16[0];
    m.swap_xy = uniform() < 0.5;
    m.kinematics = uniform() < 0.5 ? MACHINE_COREXY : MACHINE_CARTESIAN;
    m.draw_speed_um_s = (uint32_t)spread(1000, 4000000);
    m.travel_speed_um_s = (uint32_t)spread(1000, 4000000);
    m.accel_um_s2 = (uint32_t)spread(10000, 100000000);
    m.junction_um = uniform() < 0.1 ? 0 : (uint32_t)spread(1, 10000);
    m.lift_us = (uint32_t)(uniform() * 300000);
    m.lower_us = (uint32_t)(uniform() * 300000);
    m.pulse_ns = (uint32_t)spread(100, 20000);
    m.dir_setup_ns = (uint32_t)(uniform() * 20000);
    return m;
}

/* Some strokes whose size is a share of what the machine does in a few thousand steps. */
static rig_drawing_t random_drawing(const machine_t *m) {
    rig_drawing_t d = {0};
    double finest = fmax(m->steps_per_mm_q16[0], m->steps_per_mm_q16[1]) / 65536;
    double extent = fmin(spread(10, 20000) / finest, 500), cut = spread(1, 1000);
    int strokes = 1 + (int)(uniform() * 4);
    for (int s = 0; s < strokes; s++) {
        double x = extent * uniform(), y = extent * uniform(), heading = 6.28 * uniform(), bend = 0;
        double sharp = uniform() < 0.3 ? 3 : 0.1 * uniform(),
               length = fmax(extent / cut, 1.5 / finest); /* those below a quarter step are skipped */
        rig_move(&d, x, y);
        int lines = (int)fmin(cut * 3, 400);
        for (int i = 0; i < lines; i++) {
            bend = 0.8 * bend + sharp * (uniform() - 0.5);
            heading += bend;
            double l = length * (0.3 + uniform());
            rig_draw(&d, x += l * cos(heading), y += l * sin(heading));
        }
    }
    return d;
}

static void check(uint64_t number) {
    seed = number;
    machine_t m = random_machine();
    rig_drawing_t d = random_drawing(&m);
    rig_run_t r = rig_run(&d, &m, MOTION_BYTES(1024, 16), NULL);
    bool possible = r.error != ERR_MACHINE;
    if (possible) {
        trace_judgement_t j;
        assert_int_equal(trace_judge(&r.trace, &m, &j), 0);
        double deviation = rig_deviation_steps(&d, &m, &r.trace);
        double ratio = (double)r.stats.ticks / HAL_TICK_HZ / rig_ideal_s(&d, &m);
        /* Without junction deviation a turn that is lost in rounding is passed where the reference stops. */
        bool good = r.error == 0 && j.legal && deviation <= 1 && r.stats.starved == 0 && r.stats.late == 0 &&
                    (ratio > 0.99 || m.junction_um == 0) && (ratio < 1.01 || r.stats.forced > 0);
        if (!good) {
            print_message("# FAILED RIDGELINE_SEED=%llu build/tests/property/test_motion_random: error %d, %.4f steps "
                          "off the path, %.5f of the ideal, %u late, %u forced\n",
                          (unsigned long long)number, r.error, deviation, ratio, r.stats.late, r.stats.forced);
            trace_print(&j, &m, stdout);
        }
        assert_true(good);
    }
    trace_free(&r.trace);
    rig_free(&d);
}

static void test_random_machines(void **state) {
    (void)state;
    uint64_t from, to;
    if (!cases_seeds(1, cases_scaled(RUNS), &from, &to)) return;
    for (uint64_t i = from; i < to; i++) check(i);
    print_message("# motion: %llu drawings\n", (unsigned long long)(to - from));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random_machines),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
