/* port.h - what ahead.h asks of this port, and the interrupts for its vector table.
 *
 * Pins of the micro:bit's edge connector: P0 step X, P1 dir X, P2 step Y, P8 dir Y, P12 pen, P16 motors on; inputs
 * P13 limit X, P14 limit Y, button A start, P15 emergency stop. */
#ifndef PORT_H
#define PORT_H

#include "hal/hal.h"
#include "hal/nrf51/regs.h"

#define AHEAD_ENTRY 100
#define AHEAD_GAP 20
#define AHEAD_CHAIN 120
#define AHEAD_SLACK 160

enum { PORT_IRQ_UART = 2, PORT_IRQ_TIMER = 8 };

/* Pin numbers of the chip, in the order of enum hal_pin. */
enum { PIN_X_STEP = 3, PIN_X_DIR = 2, PIN_Y_STEP = 1, PIN_Y_DIR = 18, PIN_PEN = 20, PIN_ENABLE = 16 };

void port_uart_isr(void);
void port_timer_isr(void);
void port_plan_isr(void);
/* An exception that cannot be: pen up, motors off, stop. */
void port_panic(void);

extern const uint32_t port_spread[64]; /* pin word to the chip's pins */
extern uint32_t port_invert;           /* pins that are active low */

static inline uint32_t port_now(void) {
    TIMER0_CAPTURE1 = 1;
    return TIMER0_CC1;
}

static inline uint32_t port_raw(uint32_t at) {
    return at;
}

static inline void port_until(uint32_t raw) {
    while ((int32_t)(port_now() - raw) < 0) continue;
}

/* The new compare value before the old event is cleared: in 32-bit mode QEMU would raise it again at once. */
static inline void port_alarm(uint32_t at) {
    TIMER0_CC0 = at;
    TIMER0_COMPARE0 = 0;
    if ((int32_t)(at - port_now()) < 4) irq_pend(PORT_IRQ_TIMER);
}

static inline void port_pins(uint32_t mask, uint32_t value) {
    value ^= port_invert;
    GPIO_OUTSET = port_spread[value & mask];
    GPIO_OUTCLR = port_spread[~value & mask];
}

#endif
