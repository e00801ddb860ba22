/* tracer.h - turns planned lines into pieces for the step interrupt: where each motor steps, and exactly when.
 *
 * Time comes from the height h of planner.h: from rest to height h takes T(h) = sqrt(2h/a), so a step at distance s
 * into a rising line is due at T(h_in + s) - T(h_in) after its start: one root per time and no accumulated error. A
 * piece spans at most 1/16 of its height; times inside it are a parabola through the exact first, middle and last step
 * (speed error below 0.05 %), and near rest, where a sixteenth is less than a step, every step is a piece of its own
 * and exact.
 *
 * Rounding: a motor steps when its unrounded position passes the half between two steps. Where a motor turns
 * round less than TRACER_TURN beyond such a half, the step and its way back are both left out: they would follow
 * each other within microseconds. So the path is within 0.85 of a step per motor at such a turn, 0.5 elsewhere.
 *
 * Context: main loop. Blocks while the queue is full, through hal_idle() or what `wait` does instead. */
#ifndef TRACER_H
#define TRACER_H

#include "motion/kinematics.h"
#include "motion/planner.h"
#include <stdint.h>

typedef struct tracer {
    const kinematics_t *kin;
    bool estimate;           /* only time is wanted */
    void (*wait)(void *ctx); /* called while the queue is full; NULL: hal_idle() */
    void *wait_ctx;
    uint32_t root_q20;        /* T(h) = root_q20 * sqrt(h) in the units of tracer.c */
    uint32_t min_gap_ticks;   /* between two pulses of a motor */
    int64_t clock_q16;        /* ticks planned so far, up to where the last line ended */
    int64_t piece_tick;       /* whole ticks handed to the queue */
    kinematics_pos_t pos[2];  /* unrounded, end of the last line */
    int32_t steps[2];         /* rounded: what the queue adds up to */
    int64_t last_step_q16[2]; /* when the motor's last pulse began */
    bool forward[2];          /* its direction then */
    int64_t taken_q16;        /* when the interrupt takes the next piece */
    uint64_t pulses[2];
    int64_t out_time_q16; /* T(h) at the end of the last line */
    uint32_t top_q3;      /* the run's limit as a height, and what follows from it: */
    int64_t top_time_q16; /* T(top) */
    uint64_t per_lat_q24; /* ticks per lat */
    int64_t cruise_q16;   /* distance of the longest piece at that speed */
    int64_t peak_q16;     /* greatest height so far */
} tracer_t;

/* min_gap_ticks: shortest time between two pulses of a motor; kin stays the caller's. */
void tracer_init(tracer_t *t, const kinematics_t *kin, uint32_t accel_um_s2, uint32_t min_gap_ticks, bool estimate);
/* Before a run: its speed limit, as speed and as height. */
void tracer_speed(tracer_t *t, uint32_t speed_um_s, uint32_t top_q3);
/* Traces one planned line. */
void tracer_move(tracer_t *t, const planner_move_t *move);
/* Writes pen and enable and waits; nothing moves meanwhile. Only at rest. */
void tracer_wait(tracer_t *t, uint32_t wait_us, uint8_t pins);

#endif
