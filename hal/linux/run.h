/* run.h - what the stepping process does: a drawing, a move, homing, or only lowering the pen.
 *
 * Ways to end before the end: a signal (brakes along the path, then pen up and motors off; the second one at once), a
 * limit switch or the emergency stop (at once, within one step), a line that cannot be written or read any more. Each
 * says where the pen stood, counted at the pins. */
#ifndef LINUX_RUN_H
#define LINUX_RUN_H

#include "hal/linux/port.h"
#include "host/drawing.h"
#include "motion/machine.h"

enum run_what { RUN_PLOT, RUN_JOG, RUN_HOME, RUN_PEN_DOWN, RUN_OFF };

typedef struct run {
    enum run_what what;
    machine_t machine;
    drawing_t drawing; /* RUN_PLOT */
    page_point_t by;   /* RUN_JOG: from where the pen stands */
    bool limit[2];     /* RUN_HOME: the pin file has this switch */
    int hold_s;        /* RUN_PEN_DOWN: how long; 0: until a signal; up to RUN_HOLD_MAX_S */
} run_t;

#define RUN_HOLD_MAX_S 120
#define RUN_HOME_UM_S 10000       /* speed towards a switch */
#define RUN_HOME_BACK_UM 2000     /* home is so far off the switch */
#define RUN_HOME_REACH_UM 1500000 /* searched so far when the machine's size is not set */

/* In the stepping process, after port_open. ctx: a run_t. Returns the exit status. */
int run_step(void *ctx);
/* "x 12.345 mm, y 6.789 mm (988, 543 steps)", from the pulses counted at the pins. */
void run_position(const machine_t *machine, const port_counts_t *counts, char *text, size_t size);

#endif
