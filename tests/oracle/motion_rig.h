/* motion_rig.h - a plotter on the test bench: drawings as lists of strokes, run through the motion stage and the
 * simulator, recorded, and checked against the path they were meant to follow. */
#ifndef MOTION_RIG_H
#define MOTION_RIG_H

#include "host/trace.h"
#include "motion/motion.h"
#include "tests/oracle/motion_ref.h"

typedef struct rig_drawing {
    motion_ref_point_t *point; /* mm; every point is a multiple of 1 lat */
    size_t points, point_room;
    size_t *stroke; /* index of the first point of each */
    size_t strokes, stroke_room;
} rig_drawing_t;

void rig_move(rig_drawing_t *d, double x, double y);
void rig_draw(rig_drawing_t *d, double x, double y);
void rig_free(rig_drawing_t *d);

/* The whole time of the ideal: motors on, strokes, travels, lifts, and back home. */
double rig_ideal_s(const rig_drawing_t *d, const machine_t *m);

typedef struct rig_run {
    int error;
    bool prepared; /* faults may have been injected */
    motion_stats_t stats;
    trace_t trace; /* trace_free */
    uint64_t hash; /* over ticks and pins of every change */
} rig_run_t;

/* Hands all strokes to an initialised motion. Returns the first error. */
int rig_feed(const rig_drawing_t *d, motion_t *motion);

/* Runs d with `bytes` of memory. Injected faults of the simulator must be set by `prepare`, if any. */
rig_run_t rig_run(const rig_drawing_t *d, const machine_t *m, size_t bytes, void (*prepare)(void));
/* The time that motion_init_estimate tells, in s. */
double rig_estimate_s(const rig_drawing_t *d, const machine_t *m, size_t bytes);

/* Greatest distance, in steps of the coarser motor, of any position the pen takes (down) from the strokes, walked in
 * order. */
double rig_deviation_steps(const rig_drawing_t *d, const machine_t *m, const trace_t *t);

/* The same against where the ideal plan has the pen at that moment; the moment of a step is that of half of it. Each
 * stroke is stretched to the time that it took. */
double rig_timed_deviation_steps(const rig_drawing_t *d, const machine_t *m, const trace_t *t);

#endif
