/* stepgen.h - the step interrupt: consumes pieces, drives pins through hal.h. Simple and dumb on purpose.
 *
 * A piece is a span of time in which each motor takes some steps in one direction at intervals that change linearly:
 * the first at `first`, then `interval`, growing by `add` each time. The motors are timed independently, so each steps
 * at its own exact moments instead of at the other one's. The interrupt only adds and compares: no multiplication, no
 * division. A step is two deadlines, pulse begin and pulse end; deadlines less than HAL_EDGE_GAP (3 ticks, 0.19 us)
 * apart share one write of the pins, at the first of them, so no two writes are closer than that.
 *
 *      piece         |<------------------ length ------------------>|
 *      motor A       |   first   |interval|interval+add|  ...       |
 *      motor B       |first|     ...
 *
 * DIR changes set-up and 1 us before the first step of the other direction; the producer leaves pulse + set-up + 1 us
 * between that and the last step of the one before. Served late by more than half a pulse width, the interrupt
 * slips everything still to come, so widths, set-up and intervals stay legal and no step is lost.
 *
 * Hold and resume stretch time: each piece says how fast the pen is (as the time v/a that a stop takes), so the
 * interrupt can let the speed fall by one unit of that time in each unit of time, which is the acceleration itself.
 * Half a millisecond at a time it compares the speed wanted with the plan's, and what is still to come is put off by
 * what the ratio leaves. The steps and their order stay those of the plan; a stop takes v/a and v^2/2a. The pen never
 * brakes harder than the plan does, so it is never faster than the plan at that place either. Both begin at the next of
 * the moments that come every 2 ms (2^15 ticks) from when the motion began, or was held.
 *
 * Queue: single producer (main loop), single consumer (interrupt); each index has one writer and a slot is
 * written before its index is released. */
#ifndef STEPGEN_H
#define STEPGEN_H

#include <stdbool.h>
#include <stdint.h>

typedef struct stepgen_axis_piece {
    uint64_t first_q32;    /* ticks from the end of the piece before to the first pulse */
    uint64_t interval_q32; /* ticks to the second */
    int64_t add_q32;       /* then added to the interval each time */
    uint32_t count;        /* pulses; 0: the rest is ignored */
    bool forward;          /* level of DIR */
} stepgen_axis_piece_t;

typedef struct stepgen_piece {
    stepgen_axis_piece_t axis[2];
    uint32_t length; /* ticks, below 2^30; no pulse begins later than this */
    uint32_t speed;  /* of the pen at the end, as v/a in STEPGEN_SPEED_TICKS; 0: at rest */
    int8_t slope;    /* 1: speeding up at the machine's acceleration, 0: keeping its speed, -1: slowing down */
    bool set_pins;   /* at the start of the piece write pen and enable; such a piece has no steps */
    uint8_t pins;    /* HAL_PEN, HAL_ENABLE */
    bool rest;       /* the machine stands still at the end: running dry there is no fault */
} stepgen_piece_t;

#define STEPGEN_SPEED_TICKS 16

/* queue: slots pieces, a power of two, the caller's until the next init. Stops what runs and clears all
 * pins, but motors that are on stay on, with DIR as it is. Positions begin at 0. Context: main loop. */
void stepgen_init(stepgen_piece_t *queue, uint32_t slots, uint32_t pulse_ticks, uint32_t setup_ticks);
/* The slot to fill next, or NULL when the queue is full. Context: main loop. */
stepgen_piece_t *stepgen_slot(void);
/* Hands the filled slot to the interrupt, which starts when it has a good many. Context: main loop. */
void stepgen_push(void);
/* Starts the interrupt if it stands still and there is something to do, unless held. Context: main loop. */
void stepgen_start(void);
/* How many pieces the queue has room for. Context: main loop. */
uint32_t stepgen_room(void);
/* For hal_idle() on a chip that sleeps: makes sure that some interrupt comes within so many ticks. Context: main loop.
 */
void stepgen_wake(uint32_t ticks);
/* True when every piece has been carried out, or after a halt. */
bool stepgen_idle(void);
/* Pulses counted at the pins, with sign. Exact when idle or held. */
int32_t stepgen_position(int motor);
/* Is the pen down? As last written by a piece or a halt. */
bool stepgen_pen_down(void);
/* Pen and motors by hand, at rest. Context: main loop. */
void stepgen_set_pins(uint32_t mask, uint32_t value);
/* What the count begins at: after stepgen_init only. */
void stepgen_set_position(int motor, int32_t steps);

/* Brakes to a standstill along the path, or stays where it is; the pen is left as it is. Context: main loop. */
void stepgen_hold(void);
/* Goes on where it was held, from rest, or speeds up again when still braking. Context: main loop. */
void stepgen_resume(void);
/* Holds, and when it stands, the interrupt halts: pen up, motors left on. Not taken back by stepgen_resume. Without
 * effect on a machine that is not running: see stepgen_held. Context: main loop. */
void stepgen_stop(void);
/* A hold is wanted (and not yet resumed); the machine stands because of it. */
bool stepgen_holding(void);
bool stepgen_held(void);
/* Stops within the step under way, pen up, motors left on or switched off, and forgets the queue. From then on pieces
 * are taken and forgotten at once, until stepgen_init. Away from rest the position is lost: a motor may run on.
 * Context: any that stepgen_isr() cannot interrupt or be interrupted by; main loop when held or idle. */
void stepgen_halt(bool motors_on);
bool stepgen_halted(void);
/* Times the queue ran dry away from a rest; deadlines that made the plan slip or came after their time. */
uint32_t stepgen_starved(void);
uint32_t stepgen_late(void);

#endif
