/* machine.h - what a plotter is: the numbers of `set machine`, as the planner and step generator want them.
 *
 * Defaults (machine_default): 80 steps/mm, 100 mm/s drawing and travelling, 1000 mm/s^2, junction deviation 0.01 mm,
 * 0.1 s to lift and 0.1 s to lower the pen, DIR stable 1 us before STEP, pulses 2 us wide, no axis inverted; a pen that
 * is moved by a level; limit switches at the left and the bottom, which stop the machine. */
#ifndef MACHINE_H
#define MACHINE_H

#include "hal/hal.h"

enum machine_kinematics { MACHINE_CARTESIAN, MACHINE_COREXY };
enum machine_limits {
    MACHINE_LIMITS_ON,     /* a limit switch that closes stops the machine */
    MACHINE_LIMITS_HOMING, /* they are for homing only */
    MACHINE_LIMITS_OFF,    /* there are none */
};

typedef struct machine {
    uint32_t steps_per_mm_q16[2]; /* motors A and B (cartesian: X and Y) */
    uint32_t draw_speed_um_s;     /* pen down */
    uint32_t travel_speed_um_s;   /* pen up */
    uint32_t accel_um_s2;         /* of the pen's point, along its path and across it */
    uint32_t junction_um;         /* junction deviation; 0 stops at every corner */
    uint32_t lift_us, lower_us;   /* how long the pen takes; nothing moves meanwhile */
    uint32_t enable_us;           /* after motors on, before the first step */
    uint32_t dir_setup_ns, pulse_ns;
    bool invert[2]; /* turn a motor's direction round */
    bool swap_xy;   /* page x on motor B and page y on motor A */
    enum machine_kinematics kinematics;
    int32_t width_um, height_um; /* reach; 0 = no limit */
    uint8_t limits;              /* enum machine_limits */
    uint8_t home_far;            /* 1: x's switch is at the right, 2: y's at the top, and not at the page's origin */
    uint16_t pull_off_um;        /* homing ends so far off the switches */
    hal_wiring_t wiring;
} machine_t;

void machine_default(machine_t *m);

#endif
