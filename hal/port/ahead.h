/* ahead.h - punctual pins: runs the step generator a little ahead of time and keeps its edges in a ring, so that they
 * leave at their ticks however long it takes to compute one.
 *
 *     stepgen_isr, in planned time, PendSV -> ring of words (pins, ticks since the edge before) -> player -> pins
 *
 * PendSV computes the next edges, a batch at a time; it may take as long as it likes as long as it keeps up in the
 * mean. The player has a higher priority, or is hardware, and does nothing but write edges that are ready. There are
 * three: ahead_timer.c, an interrupt; the nRF51's, which is another; and the RP2040's, a state machine (player.c of
 * both ports).
 *
 * This file defines hal_now, hal_edges, hal_pins_write, hal_timer_arm and hal_timer_cancel for all Cortex-M ports. To
 * stepgen_isr every deadline is served at its tick exactly, so its edges are those of the simulator. When the chip
 * cannot keep up, the whole plan slips by what it is late.
 *
 * The switches' interrupt may have the player's priority: console_input_isr then interrupts the planner, and what was
 * being planned is dropped.
 *
 * The port defines in its port.h, as inline functions or macros, for use with interrupts off or in the player's:
 *     uint32_t port_now(void)               the clock, 16 MHz
 *     port_word_t port_word(uint32_t mask, uint32_t value)   what to write, polarity applied
 *     void port_write(port_word_t word)
 */
#ifndef AHEAD_H
#define AHEAD_H

#include <stdbool.h>
#include <stdint.h>

#include "port.h"

#ifndef AHEAD_EDGES
#define AHEAD_EDGES 64 /* in the ring, a power of two: 4 bytes each */
#endif
#ifndef AHEAD_ALIGN
#define AHEAD_ALIGN 4 /* of the ring */
#endif
#ifndef AHEAD_BATCH
#define AHEAD_BATCH (AHEAD_EDGES / 4) /* edges that are made in one go: a batch is played once it is complete */
#endif
#define AHEAD_WINDOW (500 * 16) /* ticks: nothing is planned earlier than this before its time */

typedef struct ahead {
    _Alignas(AHEAD_ALIGN) uint32_t ring[AHEAD_EDGES + 1]; /* a batch may begin in the last and need two */
    volatile uint32_t head;                               /* words put in: written by the planner */
    volatile uint32_t tail;                               /* words taken out: written by the player */
    volatile bool armed;                                  /* there is a deadline: plan */
    volatile bool planning;                               /* stepgen_isr is running */
    volatile bool dropped;  /* what it is planning came to nothing: it was interrupted by a halt */
    uint32_t plan;          /* the armed deadline, in planned time */
    uint32_t newest;        /* when the newest edge leaves, in planned time */
    volatile uint32_t skew; /* real time is planned time + skew: written by the player, and by the planner at rest */
    volatile uint32_t wake; /* when the planner wants to go on, in real time */
    uint32_t late, latest;
} ahead_t;
extern ahead_t ahead;

/* The body of PendSV. */
void ahead_plan_isr(void);
/* Edges that left late for other reasons than their neighbours, and the latest (ticks), since power-on. */
uint32_t ahead_late(void);
uint32_t ahead_latest(void);

/* The player's part. player_isr: the body of its interrupt. */
void player_isr(void);
/* The ring is empty, and the next word put in is to leave at that tick, real time. Returns from when its ticks count.
 */
uint32_t player_begin(uint32_t at);
/* There are more words. */
void player_fed(void);
/* ahead.wake has changed. All three: context planner. */
void player_wake(void);
/* Brings ahead.tail up to date. Interrupts off. */
void player_refresh(void);
/* The ring was emptied: nothing more leaves. Interrupts off. */
void player_cut(void);

#endif
