/* stepgen_parts.h - what the files of the step generator share. Not for others.
 *
 *     stepgen.c         the queue, start and halt, where the machine is
 *     stepgen_isr.c     the interrupt: whatever is due, edge by edge
 *     stepgen_pulses.c  the short way through steps and nothing else
 *     stepgen_hold.c    hold and resume, by stretching time */
#ifndef STEPGEN_PARTS_H
#define STEPGEN_PARTS_H

#include "hal/hal.h"
#include "motion/stepgen.h"

#define STEPGEN_LEAD_TICKS 2000               /* from starting to the first piece: longer than it takes to get there */
#define STEPGEN_GRID_TICKS 32768u             /* 2 ms */
#define STEPGEN_NEAR_TICKS (HAL_EDGE_GAP - 1) /* what is due so soon after an edge goes with it */
#define STEPGEN_NEVER INT32_MAX

/* What is used most comes first: a Cortex-M0 reaches bytes up to 31 and words up to 124 bytes into a structure. */
typedef struct stepgen_motor {
    bool high;
    bool turn;         /* DIR must change before the next step */
    bool forward;      /* of the steps to come */
    uint32_t left;     /* pulses of this piece still to begin */
    uint64_t next_q32; /* tick of the next pulse */
    uint64_t interval_q32;
    int64_t add_q32;
    uint32_t fall; /* tick at which the pulse ends */
    int32_t goal;  /* position after this piece */
} stepgen_motor_t;

typedef struct stepgen_state {
    bool next_known;
    bool set_pins; /* to be written at set_at */
    bool rest;
    bool running; /* written by the main loop only while it is false */
    bool halted;
    /* Hold and resume. */
    bool want_hold; /* written by the main loop only */
    bool stop;      /* when held, halt: written by the main loop only */
    bool hold;      /* the motion is being held */
    bool asked;     /* hold will follow want_hold at asked_at */
    bool stretched; /* time runs slower than planned */
    bool parked;    /* stretched for ever, and no deadline is armed */
    int8_t slope;
    uint8_t pins; /* pen and enable of the taken piece */
    uint32_t pulse, setup, slack;
    stepgen_motor_t motor[2];
    /* Edges. */
    uint32_t now;   /* the armed deadline */
    uint32_t level; /* of all pins, after the newest */
    uint32_t edge;  /* when that was */
    hal_edges_t ahead;
    uint32_t made; /* of ahead.room */
    uint32_t first;
    uint32_t next; /* deadline, if known */
    stepgen_piece_t *queue;
    uint32_t mask;
    uint32_t head;  /* next slot to fill: written by the main loop only */
    uint32_t tail;  /* next slot to take: written by the interrupt only */
    uint32_t end;   /* where the taken piece ends and the next begins */
    uint32_t begun; /* when the motion, or the one before, began: the grid's origin */
    uint32_t set_at;
    uint32_t speed; /* of the taken piece at its end */
    uint32_t asked_at;
    uint32_t pace; /* speed at the end of the slice, as speed is */
    uint32_t slice_end;
    uint32_t rate_q16, stretch_q16; /* planned time per time, and its inverse */
    uint32_t starved, late;
} stepgen_state_t;
extern stepgen_state_t stepgen;

/* All pins, from stepgen.now on. */
static inline void stepgen_put(uint32_t level) {
    if (stepgen.made < stepgen.ahead.room) {
        if (stepgen.made == 0) stepgen.first = stepgen.now;
        stepgen.ahead.word[stepgen.made++] = hal_edge(level, stepgen.now - stepgen.edge);
    } else {
        hal_pins_write(level ^ stepgen.level, level);
    }
    stepgen.level = level;
    stepgen.edge = stepgen.now;
}

static inline void stepgen_begin_pulse(stepgen_motor_t *a, uint32_t now) {
    a->high = true;
    a->fall = now + stepgen.pulse;
    a->left--;
    a->next_q32 += a->interval_q32;
    a->interval_q32 += (uint64_t)a->add_q32;
}

static inline bool stepgen_piece_done(void) {
    return !stepgen.motor[0].left && !stepgen.motor[1].left && !stepgen.set_pins;
}

/* Puts off what the plan has still to come. */
static inline void stepgen_put_off(uint32_t ticks) {
    stepgen.motor[0].next_q32 += (uint64_t)ticks << 32;
    stepgen.motor[1].next_q32 += (uint64_t)ticks << 32;
    stepgen.set_at += ticks;
    stepgen.end += ticks;
}

/* stepgen.c: all that must not go on. Returns what the pins shall be. */
uint32_t stepgen_cut(bool motors_on);
static inline void stepgen_stop_running(void) {
    __atomic_store_n(&stepgen.running, false, __ATOMIC_RELEASE);
}

/* stepgen_isr.c: a piece is taken as soon as its predecessor has nothing more to do. */
void stepgen_take_due(void);

/* stepgen_pulses.c: from stepgen.now on, through what is left of the piece and those behind it. at_once: what is due
 * at stepgen.now has not been done. False: it led nowhere. */
bool stepgen_short_way(bool at_once);
/* The deadline that follows, where the short way came by it and nothing is asked for. */
bool stepgen_next_pulse(void);

/* stepgen_hold.c: ticks until `hold` has to change, which is done here when they are over. */
int32_t stepgen_follow_hold(void);
/* When the interrupt is next wanted, if pulses end after `fall`, the plan goes on after `plan` ticks of its own, and it
 * is wanted after `ask` in any case. */
int32_t stepgen_stretch(int32_t fall, int32_t plan, int32_t ask);

#endif
