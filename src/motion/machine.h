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
/* Whether motion can be planned and stepped for it: steps/mm above 1/16, speeds 1 mm/s..4 m/s, acceleration 1 mm/s^2..
 * 100 m/s^2, junction deviation up to 10 mm, delays up to 60 s, set-up and pulse up to 1 ms, and no motor faster than
 * machine_gap_ticks allows, with an eighth to spare for a step that was put off. */
bool machine_is_possible(const machine_t *m);
/* Shortest time between two pulses of a motor: the pulse, then low as long as a pulse or a change of DIR needs, and 1
 * us for the latency that the step generator tolerates. */
uint32_t machine_gap_ticks(const machine_t *m);
/* Rounded up, and no more: the moments that pins change at are ticks. */
uint32_t machine_ticks_from_ns(uint32_t ns);

#endif
