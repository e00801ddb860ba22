/* ahead.h - punctual pins: runs the step generator a little ahead of time and keeps its edges in a ring, so that edges
 * that follow each other closely leave in time however long it takes to compute one.
 *
 *     stepgen_isr, in planned time -> ring of (tick, mask, value) -> the port's interrupt, in real time -> pins
 *
 * This file defines hal_now, hal_pins_write, hal_timer_arm and hal_timer_cancel for all ports with one interrupt. To
 * stepgen_isr every deadline is served at its tick exactly, so its edges are those of the simulator. When the chip
 * cannot keep up, the whole plan slips by what it is late, and no pulse gets shorter than planned.
 *
 * The port defines in its port.h, as inline functions or macros:
 *     uint32_t port_now(void)              the clock, 16 MHz, interrupts off or in the interrupt itself
 *     uint32_t port_wait(uint32_t at)   waits for that tick; returns the clock, which may be past it
 *     void port_alarm(uint32_t at)         lets its interrupt call ahead_isr at or shortly before that tick, soon if it
 *                                          has gone by; replaces an earlier alarm
 *     void port_pins(uint32_t mask, uint32_t value)
 *     AHEAD_ENTRY   ticks from the interrupt to where an edge is waited for
 *     AHEAD_COST    ticks that stepgen_isr takes
 *     AHEAD_SLACK   an edge later than so many ticks makes the plan slip; steps may come closer by as much
 *     AHEAD_MERGE   steps of two motors this close leave together, at the later one's tick
 */
#ifndef AHEAD_H
#define AHEAD_H

#include <stdbool.h>
#include <stdint.h>

#define AHEAD_EDGES 16                            /* in the ring */
#define AHEAD_WINDOW (500 * 16)                   /* ticks: no deadline is served earlier than this */
#define AHEAD_SOON (AHEAD_ENTRY + AHEAD_COST / 2) /* not worth leaving the interrupt for */

/* The body of the port's timer interrupt. */
void ahead_isr(void);
/* Edges that came so late that the plan slipped, and the latest (ticks), since power-on. */
uint32_t ahead_late(void);
uint32_t ahead_latest(void);

#endif
