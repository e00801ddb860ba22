/* ahead.h - punctual pins: runs the step generator a little ahead of time and keeps its edges in a ring, so that they
 * leave at their ticks however long it takes to compute one.
 *
 *     stepgen_isr, in planned time, PendSV -> ring of (tick, mask, value) -> the port's timer interrupt -> pins
 *
 * The timer's interrupt has the highest priority and does nothing but write edges that are ready. PendSV, below it and
 * above all others, computes the next ones; it may take as long as it likes as long as it keeps up in the mean.
 *
 * This file defines hal_now, hal_pins_write, hal_timer_arm and hal_timer_cancel for all Cortex-M ports. To stepgen_isr
 * every deadline is served at its tick exactly, so its edges are those of the simulator. Two edges that come closer
 * than AHEAD_GAP are set apart by it, which is the only difference. When the chip cannot keep up, the whole plan slips
 * by what it is late, and no pulse gets shorter than planned.
 *
 * The switches' interrupt may have the timer's priority: console_input_isr then interrupts the planner, and what was
 * being planned is dropped.
 *
 * The port defines in its port.h, as inline functions or macros, for use with interrupts off or in the timer's:
 *     uint32_t port_now(void)              the clock, 16 MHz
 *     uint32_t port_raw(uint32_t at)       a tick near the last port_now, as whatever the port compares fastest
 *     void port_until(uint32_t raw)        waits for it
 *     void port_alarm(uint32_t at)         lets its interrupt call ahead_write_isr at or shortly before that tick, soon
 *                                          if it has gone by; replaces an earlier alarm
 *     port_word_t port_word(uint32_t mask, uint32_t value)   what to write, polarity applied, made ready
 *     void port_write(port_word_t word)
 *     AHEAD_ENTRY   ticks from an alarm to where an edge is waited for, at most: other code has interrupts off
 * meanwhile AHEAD_GAP     ticks from one write to the next, for edges made ready together AHEAD_CHAIN   edges that
 * follow each other sooner than this have to be AHEAD_SLACK   an edge later than so many ticks makes the plan slip;
 * steps may come closer by as much
 */
#ifndef AHEAD_H
#define AHEAD_H

#include <stdbool.h>
#include <stdint.h>

#ifndef AHEAD_EDGES
#define AHEAD_EDGES 16 /* in the ring, a power of two: 8 bytes each */
#endif
#define AHEAD_WINDOW (500 * 16)      /* ticks: no deadline is served earlier than this */
#define AHEAD_SOON (2 * AHEAD_ENTRY) /* not worth leaving the interrupt for */

/* The body of the port's timer interrupt. */
void ahead_write_isr(void);
/* The body of PendSV. */
void ahead_plan_isr(void);
/* Edges that left late for other reasons than their neighbours, and the latest (ticks), since power-on. */
uint32_t ahead_late(void);
uint32_t ahead_latest(void);

#endif
