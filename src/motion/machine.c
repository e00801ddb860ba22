/* machine.c - the plotter we assume when nothing is said. */
#include "motion/machine.h"

#include "config.h"

void machine_default(machine_t *m) {
    *m = (machine_t){
        .steps_per_mm_q16 = {80u << 16, 80u << 16},
        .draw_speed_um_s = CONFIG_SPEED_UM_S,
        .travel_speed_um_s = CONFIG_SPEED_UM_S,
        .accel_um_s2 = 1000000,
        .junction_um = 10,
        .lift_us = 100000,
        .lower_us = 100000,
        .enable_us = 1000,
        .dir_setup_ns = CONFIG_DIR_SETUP_NS,
        .pulse_ns = CONFIG_PULSE_NS,
        .kinematics = MACHINE_CARTESIAN,
        .pull_off_um = 3000,
        .wiring = {.up_us = 1000, .down_us = 2000, .pull_ms = 50, .hold_percent = 30},
    };
}
