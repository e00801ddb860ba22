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

#define AHEAD_EDGES 32 /* player_isr.S */
#define AHEAD_BATCH 17 /* one of them is kept for what ends it: half of the ring */

#define PORT_ALL_PINS 0x3fu
#define PORT_INVERT 0u /* high is active: a chip in reset drives nothing, and pull-downs leave motors off, pen up */
#define PORT_STORE_END 0x40000u /* of flash */

enum { PORT_IRQ_UART = 2, PORT_IRQ_TIMER = 8 /* TIMER0 */, PORT_IRQ_WAKE = 9 /* TIMER1 */ };

/* Pin numbers of the chip, in the order of enum hal_pin. */
enum { PIN_X_STEP = 3, PIN_X_DIR = 2, PIN_Y_STEP = 1, PIN_Y_DIR = 18, PIN_PEN = 20, PIN_ENABLE = 16 };

void port_uart_isr(void);
void port_wake_isr(void);
void player_turn(uint32_t pins); /* these are active low: not while edges are played */
void port_wire(const hal_wiring_t *wiring);
static inline void port_pen_up(void) {}
void port_plan_isr(void);

extern const uint32_t port_spread[64]; /* pin word to the chip's pins, and the console's, which rests high */
uint32_t port_pins(void);
uint32_t port_inputs(void);

typedef struct port_state {
    uint32_t invert; /* pins that are active low */
} port_state_t;
extern port_state_t port;

#define PORT_SOFT_PEN /* solenoid.h, by TIMER1's third compare */

static inline bool port_pen_is_down(void) {
    return !(GPIO_OUT & 1u << PIN_PEN) == !!(port.invert & HAL_PEN);
}

static inline void port_pen_drive(bool on) {
    if (on)
        GPIO_DIRSET = 1u << PIN_PEN;
    else
        GPIO_DIRCLR = 1u << PIN_PEN;
}

static inline uint32_t port_count(void) {
    TIMER0_CAPTURE1 = 1;
    return TIMER0_CC1;
}

static inline uint32_t port_now(void) {
    return port_count() * 2;
}

/* Below 2^16 us, 2 at least. */
static inline void port_wake_in(uint32_t us) {
    TIMER1_CAPTURE1 = 1;
    TIMER1_CC0 = (TIMER1_CC1 + us) & 0xffff;
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
