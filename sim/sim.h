/* sim.h - the simulator's side of hal.h: a virtual clock and a recorder below the pins.
 *
 * There is one simulated machine per program. hal_idle() moves the clock to the armed deadline and calls stepgen_isr(),
 * and then through the edges that it made ahead (half a millisecond at most, and nothing beyond what sim_at holds);
 * nothing else moves it, so a run takes no longer than its computing and repeats exactly. With no deadline armed,
 * hal_idle() lets SIM_IDLE_TICKS pass. Something scheduled from outside (sim_at) comes in between at its own tick.
 *
 * Console, switches, store and watchdog of the machine are in sim_console.h. */
#ifndef SIM_H
#define SIM_H

#include "hal/hal.h"
#include <stdint.h>

#define SIM_IDLE_TICKS (HAL_TICK_HZ / 1000)

/* Called for every write that changes a pin: all pins after it, and which of them changed. tick counts from sim_reset
 * and never wraps. */
typedef void (*sim_recorder_t)(void *ctx, uint64_t tick, uint32_t pins, uint32_t changed);

/* Back to tick 0, all pins 0, no recorder, no faults injected. */
void sim_reset(void);
/* recorder may be NULL. Stays until sim_reset. */
void sim_record(sim_recorder_t recorder, void *ctx);
uint64_t sim_now(void);
uint32_t sim_pins(void);
/* Message of the last hal_fault since sim_reset, or NULL. */
const char *sim_fault(void);
/* Lets virtual time pass, serving deadlines: as a main loop that is busy elsewhere would. */
void sim_run(uint64_t ticks);

/* Calls event(ctx) when the clock reaches `tick`, as an interrupt would: within hal_idle or sim_run, before a deadline
 * of the same tick. A tick gone by counts as now. Same ticks keep their order. False when SIM_EVENTS are waiting. */
#define SIM_EVENTS 4096
bool sim_at(uint64_t tick, void (*event)(void *ctx), void *ctx);

/* Fault injection: every `period`-th deadline is served `late` ticks late (period 0: none). */
void sim_inject_late(uint32_t period, uint32_t late);
/* Whether stepgen_isr() may make edges ahead, as on the boards, or makes one at a time; they are the same. Stays. */
void sim_play_ahead(bool ahead);
/* The 32-bit clock starts here instead of 0 (to test wrap-around); ticks reported still count from 0. */
void sim_set_clock(uint32_t now);

#endif
