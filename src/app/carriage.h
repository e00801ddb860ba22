/* carriage.h - the machine between drawings: where the pen is and whether that is known, holds, stops, homing, alarms.
 *
 * A drawing is carriage_begin, strokes into carriage_pen, carriage_end. The pen goes home at its end and the motors
 * off; after a stop it stays where it is, pen up, motors on, and the next drawing starts there. After a limit switch or
 * the emergency stop the place is unknown, and everything but carriage_home and carriage_unlock is refused.
 *
 * Homing: each axis to its limit switch, off it, again slowly, and off again: that is the page's origin, or with a
 * switch at the right or the top (machine_t.home_far) the other end of the machine. The switches are those of the
 * page's axes, whatever the motors.
 *
 * Context: main loop, but for carriage_input_isr. */
#ifndef CARRIAGE_H
#define CARRIAGE_H

#include "error.h"
#include "motion/motion.h"

enum carriage_state {
    CARRIAGE_IDLE,
    CARRIAGE_RUN,   /* a drawing is under way */
    CARRIAGE_HOLD,  /* braking, or standing, until resumed */
    CARRIAGE_HOME,  /* homing */
    CARRIAGE_ALARM, /* place unknown */
};

enum carriage_alarm {
    CARRIAGE_NO_ALARM,
    CARRIAGE_LIMIT,      /* a limit switch closed while moving */
    CARRIAGE_ESTOP,      /* the emergency stop was pressed; motors are off */
    CARRIAGE_NO_SWITCH,  /* homing found no switch, or one that stays closed */
    CARRIAGE_BROKEN_OFF, /* homing was stopped */
};

typedef struct carriage {
    motion_t motion;
    const machine_t *machine; /* of the drawing or homing under way, or the last one; the caller's */
    void *mem;                /* lent: motion's queue and look-ahead */
    size_t bytes;
    void (*poll)(void *ctx); /* called while the machine is waited for, before hal_idle() */
    void *ctx;
    page_point_t place; /* while nothing moves */
    uint8_t state;      /* enum carriage_state: IDLE, RUN or HOME */
    bool stopping;      /* a stop is wanted: when held, the drawing ends */
    bool changing;      /* at home until resumed, for another pen */
    bool pen_down;      /* by carriage_pen_test */
    uint8_t seeking;    /* homing: the switch that ends this move */
    uint8_t alarm;      /* written by the interrupt, and by the main loop when nothing moves */
} carriage_t;

/* mem: at least MOTION_BYTES_MIN, aligned to 8, the caller's for good. The pen is taken to be at home. */
void carriage_init(carriage_t *c, void *mem, size_t bytes, void (*poll)(void *ctx), void *ctx);

/* Switches that forbid a drawing now: enum hal_input. Limits count as `set machine limits` says. */
uint32_t carriage_closed(const machine_t *machine);
/* Prepares a drawing. machine is the caller's until carriage_end. Returns 0, ERR_MACHINE (alarm, a closed switch, or as
 * motion_init) or ERR_FULL. */
int carriage_begin(carriage_t *c, const machine_t *machine);
/* Where its strokes go. Polls; returns ERR_STOPPED after a stop or alarm. */
pen_sink_t carriage_pen(carriage_t *c);
/* For path_feed_t: does the pen take a line at once? And: nothing is known of what follows, up with it. ctx is c. */
bool carriage_ready(void *ctx);
int carriage_rest(void *ctx);
/* Ends it: goes home, or after a stop or alarm stays. stats may be NULL. Returns err, or what went wrong since;
 * ERR_MACHINE after an alarm. */
int carriage_end(carriage_t *c, int err, motion_stats_t *stats);

/* During a drawing: goes home, motors on, and waits there for carriage_resume: somebody puts another pen in. Returns 0,
 * ERR_STOPPED, or the error of a move. */
int carriage_change(carriage_t *c);

/* Blocks, polling. Returns 0, ERR_STOPPED or ERR_MACHINE: then carriage_alarm() says why, or nothing moved, as the
 * emergency stop is closed or the machine has no switches. */
int carriage_home(carriage_t *c, const machine_t *machine);
/* The pen was put to home by hand. False while the emergency stop is pressed. */
bool carriage_unlock(carriage_t *c);
enum carriage_alarm carriage_alarm(const carriage_t *c);

/* At any time; without effect when nothing moves. */
void carriage_hold(carriage_t *c);
void carriage_resume(carriage_t *c);
void carriage_stop(carriage_t *c);

/* At rest: moves the pen and waits for it. */
void carriage_pen_test(carriage_t *c, const machine_t *machine, bool down);
/* At rest: motors on, or off; the pen is then taken to be at home, as somebody will put it there by hand. */
void carriage_motors(carriage_t *c, bool on);

enum carriage_state carriage_state(const carriage_t *c);
/* Of the pen on the page, at rest and while moving. */
page_point_t carriage_place(const carriage_t *c);
bool carriage_pen_is_down(const carriage_t *c);

/* The body of hal.h's console_input_isr. Context: interrupt. */
void carriage_input_isr(carriage_t *c, uint32_t inputs);

#endif
