/* port.h - what ahead.h asks of this port, and the interrupts for its vector table.
 *
 * Pins of the micro:bit's edge connector: P0 step X, P1 dir X, P2 step Y, P8 dir Y, P12 pen, P16 motors on; inputs
 * P13 limit X, P14 limit Y, button A start, P15 emergency stop.
 *
 * TIMER0 counts at 8 MHz, two ticks a count. At 16 MHz QEMU would gain half a nanosecond whenever it is read after an
 * odd number of counts, as 62.5 ns is no whole number of them: 40 us in a drawing of a second. */
#ifndef PORT_H
#define PORT_H

#include "hal/hal.h"
#include "hal/nrf51/regs.h"

#define AHEAD_EDGES 16
#define AHEAD_BATCH 8
#define AHEAD_PAIR 72
#define AHEAD_ENTRY 80
#define AHEAD_SOON 176
#define AHEAD_AFTER 80
#define AHEAD_SLACK 96

#define PORT_ALL_PINS 0x3fu
#define PORT_INVERT 0u /* high is active: a chip in reset drives nothing, and pull-downs leave motors off, pen up */

enum { PORT_IRQ_UART = 2, PORT_IRQ_TIMER = 8 };

/* Pin numbers of the chip, in the order of enum hal_pin. */
enum { PIN_X_STEP = 3, PIN_X_DIR = 2, PIN_Y_STEP = 1, PIN_Y_DIR = 18, PIN_PEN = 20, PIN_ENABLE = 16 };
#define PORT_OUT                                                                                                       \
    (1u << PIN_X_STEP | 1u << PIN_X_DIR | 1u << PIN_Y_STEP | 1u << PIN_Y_DIR | 1u << PIN_PEN | 1u << PIN_ENABLE)

void port_uart_isr(void);
void port_timer_isr(void);
void port_wire(const hal_wiring_t *wiring);
static inline void port_pen_up(void) {}
void port_plan_isr(void);

extern const uint32_t port_spread[64]; /* pin word to the chip's pins */
uint32_t port_pins(void);
uint32_t port_inputs(void);

typedef struct port_state {
    uint32_t invert; /* pins that are active low */
} port_state_t;
extern port_state_t port;

static inline uint32_t port_count(void) {
    TIMER0_CAPTURE1 = 1;
    return TIMER0_CC1;
}

static inline uint32_t port_now(void) {
    return port_count() * 2;
}

static inline uint32_t port_raw(uint32_t at) {
    return at;
}

static inline void port_until(uint32_t raw) {
    while ((int32_t)(port_now() - raw) < 0) continue;
}

/* The new compare value before the old event is cleared: in 32-bit mode QEMU would raise it again at once. One that
 * came in between would be lost, and the next only after nine minutes. */
static inline void port_alarm(uint32_t at) {
    const uint32_t last = TIMER0_CC1, count = last + (uint32_t)((int32_t)(at - last * 2) >> 1);
    TIMER0_CC0 = count;
    TIMER0_COMPARE0 = 0;
    if ((int32_t)(count - port_count()) < 2) irq_pend(PORT_IRQ_TIMER);
}

typedef struct port_word {
    uint32_t mask, value;
} port_word_t;

static inline port_word_t port_word(uint32_t mask, uint32_t value) {
    return (port_word_t){port_spread[mask], port_spread[(value ^ port.invert) & mask]};
}

/* Not by OUTSET and OUTCLR, which would be two moments. */
static inline void port_write(port_word_t word) {
    GPIO_OUT = (GPIO_OUT & ~word.mask) | word.value;
}

static inline uint32_t port_level(uint32_t pins) {
    return port_spread[(pins ^ port.invert) & PORT_ALL_PINS];
}

static inline void port_put(uint32_t level) {
    GPIO_OUT = (GPIO_OUT & ~PORT_OUT) | level;
}

#define PORT_UART_NONE UINT32_MAX
#define PORT_UART_LOST 0x100u
#define PORT_UART_DAMAGED 0x200u

/* Errors come by an event of their own: port_uart_isr. */
static inline uint32_t port_uart_take(void) {
    if (!UART_RXDRDY) return PORT_UART_NONE;
    UART_RXDRDY = 0;
    return UART_RXD & 0xff;
}

static inline bool port_uart_sent(void) {
    if (!UART_TXDRDY) return false;
    UART_TXDRDY = 0;
    return true;
}

static inline void port_uart_send(uint8_t byte) {
    UART_TXD = byte;
}

static inline void port_uart_put(uint8_t byte) {
    UART_TXDRDY = 0;
    UART_TXD = byte;
    while (!UART_TXDRDY) continue;
}

static inline void port_uart_sending(bool on) {
    (void)on; /* the event comes once for each byte */
}

#endif
