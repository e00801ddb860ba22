/* hal.h - the boundary to hardware. The core calls down through these functions; each build links exactly one folder
 * that defines them (sim/ on the desktop, hal/<port>/ elsewhere). hal/README.md is the contract line by line.
 *
 * Time is hal_now(): 32-bit ticks of HAL_TICK_HZ that wrap around; compare with hal_before() only. */
#ifndef HAL_H
#define HAL_H

#include <stdbool.h>
#include <stdint.h>

#define HAL_TICK_HZ 16000000u /* the tick of traces and plans; a port scales to its own timer */

/* Pin word. A set bit means: stepping pulse active, direction positive, pen down, motors on - the port applies
 * the board's polarity. */
enum hal_pin {
    HAL_X_STEP = 1 << 0,
    HAL_X_DIR = 1 << 1,
    HAL_Y_STEP = 1 << 2,
    HAL_Y_DIR = 1 << 3,
    HAL_PEN = 1 << 4,
    HAL_ENABLE = 1 << 5,
};

/* Sets the pins in mask to the bits of value, all at once where the hardware can. */
void hal_pins_write(uint32_t mask, uint32_t value);
uint32_t hal_now(void);
/* Calls stepgen_isr() at absolute tick `at`; a tick in the past is served at once and counted as late. */
void hal_timer_arm(uint32_t at);
void hal_timer_cancel(void);
/* Waits for something to happen: lets the interrupt run. The simulator moves its virtual clock here. */
void hal_idle(void);
/* Stops everything: pen up, motors off, message out. Does not return on a board. */
void hal_fault(const char *what, int32_t a, int32_t b);

/* Upward: the only function a port calls. The body lives in src/motion. */
void stepgen_isr(void);

static inline bool hal_before(uint32_t a, uint32_t b) { return (int32_t)(a - b) < 0; }

#endif
