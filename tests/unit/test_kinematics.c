/* kinematics.h: every kind of machine, rounding, and the way back (host/trace_path.h). */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "host/trace_path.h"
#include "motion/kinematics.h"
#include "motion/planner.h"

static machine_t machine(bool corexy, bool swap, bool invert_a, bool invert_b) {
    machine_t m;
    machine_default(&m);
    m.steps_per_mm_q16[1] = 100u << 16;
    m.kinematics = corexy ? MACHINE_COREXY : MACHINE_CARTESIAN;
    m.swap_xy = swap;
    m.invert[0] = invert_a;
    m.invert[1] = invert_b;
    return m;
}

static void expect(machine_t m, double x_mm, double y_mm, double a_steps, double b_steps) {
    kinematics_t k;
    kinematics_pos_t pos[2];
    kinematics_init(&k, &m);
    kinematics_motors(&k, (page_point_t){(int32_t)(x_mm * LAT_PER_MM), (int32_t)(y_mm * LAT_PER_MM)}, pos);
    assert_true(ldexp((double)pos[0], -KINEMATICS_STEP_BITS) == a_steps);
    assert_true(ldexp((double)pos[1], -KINEMATICS_STEP_BITS) == b_steps);
    double motor[2] = {a_steps, b_steps}, page[2];
    trace_path_page(&m, motor, page);
    assert_true(fabs(page[0] - x_mm) < 1e-12 && fabs(page[1] - y_mm) < 1e-12);
}

static void test_kinds(void **state) {
    (void)state;
    expect(machine(false, false, false, false), 3, 5.5, 240, 550);
    expect(machine(false, true, false, false), 3, 5.5, 440, 300);
    expect(machine(false, false, true, false), 3, 5.5, -240, 550);
    expect(machine(false, true, false, true), 3, 5.5, 440, -300);
    expect(machine(true, false, false, false), 3, 5.5, 680, -250);
    expect(machine(true, true, false, false), 3, 5.5, 680, 250);
    expect(machine(true, false, true, true), 3, 5.5, -680, 250);
    expect(machine(true, true, true, true), -3, 0.25, 220, -325);
}

static void test_rounding(void **state) {
    (void)state;
    const int64_t step = (int64_t)1 << KINEMATICS_STEP_BITS;
    assert_int_equal(kinematics_round(0), 0);
    assert_int_equal(kinematics_round(step / 2 - 1), 0);
    assert_int_equal(kinematics_round(step / 2), 1);
    assert_int_equal(kinematics_round(-step / 2), 0);
    assert_int_equal(kinematics_round(-step / 2 - 1), -1);
    assert_int_equal(kinematics_round(-7 * step), -7);
}

/* The largest coordinates on the finest machine do not overflow. */
static void test_range(void **state) {
    (void)state;
    machine_t m = machine(true, false, true, false);
    m.steps_per_mm_q16[0] = m.steps_per_mm_q16[1] = UINT32_MAX;
    kinematics_t k;
    kinematics_pos_t pos[2];
    kinematics_init(&k, &m);
    kinematics_motors(&k, (page_point_t){PLANNER_REACH_LAT - 1, PLANNER_REACH_LAT - 1}, pos);
    assert_true(pos[0] == -(2ll * PLANNER_REACH_LAT - 2) * UINT32_MAX && pos[1] == 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_kinds),
        cmocka_unit_test(test_rounding),
        cmocka_unit_test(test_range),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
