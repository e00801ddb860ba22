/* motion.h - from strokes on the page to pins: the stage that moves the plotter.
 *
 *     pen_sink -> planner (speeds) -> tracer (lines to timed pieces) -> stepgen (interrupt) -> hal.h
 *
 * Usage: motion_init, hand motion_pen_sink to the stage that orders ink, motion_finish. The drawing starts and ends at
 * home (page origin 0,0), pen up, motors off. The sink's calls block while the queue of pieces is full
 * and let the machine run through hal_idle(). Time of a drawing is within 1 % of infinite look-ahead as long as the
 * ring of blocks covers the stopping distance (v^2/2a; 5 mm by default).
 *
 * Moves are lazy: consecutive moves collapse, a move to where the pen already is does not lift it, and
 * a stroke of one point is a dot. Vertices closer than a quarter step to the last planned one are
 * skipped, except at a stroke's end. */
#ifndef MOTION_H
#define MOTION_H

#include "motion/kinematics.h"
#include "motion/machine.h"
#include "motion/planner.h"
#include "motion/stepgen.h"
#include "motion/tracer.h"
#include "view/page.h"
#include <stddef.h>

typedef struct motion_stats {
    uint64_t steps[2];         /* pulses per motor */
    int32_t position_steps[2]; /* motors at the end; 0, 0 after motion_finish */
    uint64_t down_lat, up_lat; /* length drawn and travelled; 2^15 lat = 1 mm */
    uint32_t strokes, lifts;   /* pen lowered and lifted so often */
    uint64_t ticks;            /* from motors on to motors off, HAL_TICK_HZ */
    uint32_t max_speed_um_s;
    uint32_t starved;      /* the queue ran dry while moving or with the pen down: must be 0 */
    uint32_t late;         /* deadlines served or planned late; 0 unless the port delays interrupts */
    uint32_t forced;       /* blocks planned with too little look-ahead */
    uint32_t memory_bytes; /* of the caller's memory in use */
} motion_stats_t;

typedef struct motion {
    machine_t machine;
    kinematics_t kin;
    planner_t planner;
    tracer_t tracer;
    uint32_t draw_top_q3, travel_top_q3;
    bool estimate; /* no stepping, only the time */
    bool started;  /* motors are on */
    bool down, pending_move, pending_vertex;
    bool resting; /* the stroke is over: the pen will be lifted when the last of it is in the queue */
    uint64_t down_q3, up_q3;
    page_point_t at; /* last planned vertex */
    page_point_t move_to, vertex;
    int32_t near_lat;     /* a quarter step */
    int32_t reach_lat[2]; /* soft limits; 0 = none */
    int error;
    motion_stats_t stats;
} motion_t;

/* Bytes of memory for so many blocks of look-ahead and pieces of queue (a power of two). */
#define MOTION_BYTES(blocks, pieces) ((blocks) * sizeof(planner_block_t) + (pieces) * sizeof(stepgen_piece_t) + 16)
#define MOTION_BYTES_MIN MOTION_BYTES(8, 8)     /* works, but looks ahead 8 segments only */
#define MOTION_BYTES_SMALL MOTION_BYTES(32, 16) /* a small board */
#define MOTION_BYTES_HOST MOTION_BYTES(512, 64) /* 5 mm of look-ahead in segments of 0.01 mm */

/* Prepares a drawing. machine is copied. mem: the caller's until motion_finish, aligned to 8 bytes; about a quarter
 * becomes the queue of pieces (at most 64), the rest look-ahead. Only one motion_t that steps can be active, as there
 * is one step interrupt; any number that estimate can be.
 * Returns 0, ERR_FULL (mem below MOTION_BYTES_MIN), ERR_MACHINE (not machine_is_possible). */
int motion_init(motion_t *m, const machine_t *machine, void *mem, size_t bytes);
/* The same planner without steps: motion_finish tells the time, lengths and lifts (steps stay 0). No hal call is made.
 * Cost: about 50 ns per segment on a desktop. */
int motion_init_estimate(motion_t *m, const machine_t *machine, void *mem, size_t bytes);
/* After motion_init: the pen is here instead of at home, which is at its motors' nearest steps. */
void motion_start_at(motion_t *m, page_point_t at);
/* Where the pen is, also while it moves: the steps made so far. */
page_point_t motion_place(const motion_t *m);
/* After motion_init: wait is called instead of hal_idle() whenever the machine is waited for; it must call hal_idle().
 */
void motion_on_wait(motion_t *m, void (*wait)(void *ctx), void *ctx);
/* Takes strokes. move and draw return 0, ERR_MACHINE (outside the machine's reach: nothing of the move is stepped; or
 * outside +-4 m), ERR_STOPPED (after stepgen_halt) or the error of an earlier call. Context: main loop. */
pen_sink_t motion_pen_sink(motion_t *m);
/* Pen up, straight to a point, as soon as what was given before is done. Errors as move. */
int motion_travel(motion_t *m, page_point_t to);
/* Fills the queue from what is planned, and sets the machine going. Will the pen sink take a line without waiting for
 * it? To be called now and then while lines are still being computed. */
bool motion_ready(motion_t *m);
/* The stroke is over and nothing is known of what follows: the pen is lifted after it. wait: all of it is in the queue
 * on return; else motion_ready sees to that. Errors as move. */
int motion_rest(motion_t *m, bool wait);
/* Lifts the pen and waits until everything is stepped. It stays where it is, motors on. As motion_finish otherwise. */
int motion_park(motion_t *m, motion_stats_t *stats);
/* Lifts the pen, goes home, waits until everything is stepped, switches the motors off; also after an error.
 * stats may be NULL. Returns 0 or the first error: ERR_STOPPED after stepgen_halt, which is where it then stays. */
int motion_finish(motion_t *m, motion_stats_t *stats);

#endif
