/* machine.c - the plotter we assume when nothing is said, and which plotters there can be. */
#include "motion/machine.h"

#include "config.h"

#define DELAY_MAX_US 60000000u

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

uint32_t machine_ticks_from_ns(uint32_t ns) {
    return (uint32_t)(((uint64_t)ns * (HAL_TICK_HZ / 1000000) + 999) / 1000);
}

uint32_t machine_gap_ticks(const machine_t *m) {
    uint32_t pulse = machine_ticks_from_ns(m->pulse_ns), setup = machine_ticks_from_ns(m->dir_setup_ns);
    return pulse + (setup > pulse ? setup : pulse) + HAL_TICK_HZ / 1000000;
}

static bool in_range(uint32_t value, uint32_t lo, uint32_t hi) {
    return value >= lo && value <= hi;
}

bool machine_is_possible(const machine_t *m) {
    if (!in_range(m->draw_speed_um_s, 1000, 4000000) || !in_range(m->travel_speed_um_s, 1000, 4000000)) return false;
    if (!in_range(m->accel_um_s2, 1000, 100000000) || m->junction_um > 10000) return false;
    if (m->lift_us > DELAY_MAX_US || m->lower_us > DELAY_MAX_US || m->enable_us > DELAY_MAX_US) return false;
    if (!in_range(m->pulse_ns, 1, 1000000) || m->dir_setup_ns > 1000000) return false;
    if (m->width_um < 0 || m->height_um < 0) return false;
    uint32_t speed = m->draw_speed_um_s > m->travel_speed_um_s ? m->draw_speed_um_s : m->travel_speed_um_s;
    uint64_t fastest = m->kinematics == MACHINE_COREXY ? (uint64_t)speed * 1415 / 1000 : speed;
    for (int i = 0; i < 2; i++) {
        if (m->steps_per_mm_q16[i] < 4096) return false;
        uint64_t steps_s = (fastest * m->steps_per_mm_q16[i] >> 16) / 1000;
        if (steps_s * machine_gap_ticks(m) / 8 * 9 > HAL_TICK_HZ) return false;
    }
    return true;
}
