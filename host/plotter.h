/* plotter.h - a drawing on the simulated plotter: its step trace, or only how long it takes. */
#ifndef PLOTTER_H
#define PLOTTER_H

#include "host/drawing.h"
#include "motion/motion.h"

/* Drives the whole core below the pen sink on the simulator and writes what happens at the pins as VCD (sim/vcd.h).
 * 0, ERR_FILE, ERR_MACHINE when the drawing or the machine's numbers are out of range. */
int plotter_write_vcd(const drawing_t *d, const machine_t *machine, const char *path);

/* The plan's time, lengths and lifts, without stepping. 0 or ERR_MACHINE. */
int plotter_estimate(const drawing_t *d, const machine_t *machine, motion_stats_t *stats);

#endif
