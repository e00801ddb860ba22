/* port.h - what ahead.h asks of this port, and the interrupts for its vector table.
 *
 * Pins: GP2 step X, GP3 dir X, GP4 step Y, GP5 dir Y, GP6 pen, GP7 motors off (the drivers' /ENABLE); inputs GP10 limit
 * X, GP11 limit Y, GP12 start, GP13 emergency stop; GP0, GP1 console. The pin word is the chip's, shifted by FIRST_PIN.
 *
 * A servo or solenoid at GP6: PWM slice 3, which follows the pen's bit of the pin word once a millisecond (pen.c).
 *
 * Clock: PWM slice 7 counts clk_sys / (7 + 13/16) = 16 MHz in 16 bits, TIMER (same crystal) tells which 4 ms.
 * Alarm: TIMER alarm 1, up to a microsecond early. */
#ifndef PORT_H
#define PORT_H

#include "hal/hal.h"
#include "hal/port/pl011.h"
#include "hal/rp2040/regs.h"

#define AHEAD_EDGES 512
#define AHEAD_ALIGN 2048 /* bytes: the DMA wraps there */
#define AHEAD_BATCH 64

#define PORT_ALL_PINS 0x3fu
#define PORT_INVERT HAL_ENABLE /* /ENABLE, pulled up on the drivers: a chip in reset leaves them off */

#define XIP 0x10000000u /* where flash is read */
#define PORT_STORE_END (XIP + 0x200000u)

#define FIRST_PIN 2
#define FIRST_INPUT 10 /* four in one register of eight */
#define CLOCK_SLICE 7

#define PEN_SLICE 3         /* of GP6, channel A */
#define PEN_ALARM (1u << 2) /* TIMER alarm 2 */

enum {
    PORT_IRQ_WAKE = 0 /* TIMER alarm 0 */,
    PORT_IRQ_TIMER = 1,
    PORT_IRQ_PEN = 2,
    PORT_IRQ_DMA = 11,
    PORT_IRQ_SWITCHES = 13,
    PORT_IRQ_UART = 20
};

void port_timer_isr(void);
void port_wake_isr(void);
void player_dma_isr(void);
void player_start(void);
void player_drive(void); /* from now on the pins are driven */
void port_switches_isr(void);
void port_pen_isr(void); /* pen.c, as the next two */
void port_wire(const hal_wiring_t *wiring);
void port_pen_up(void);

typedef struct port_state {
    uint16_t phase;    /* of the counter against TIMER */
    uint32_t invert;   /* pins that are active low */
    uint32_t inverted; /* as the pads have them */
} port_state_t;
extern port_state_t port;

static inline uint32_t port_now(void) {
    uint32_t coarse = TIMER_RAWL * 16;
    return coarse + (uint32_t)(int16_t)(uint16_t)(PWM_CTR(CLOCK_SLICE) - port.phase - coarse);
}

/* Two microseconds ahead at least: an alarm that has gone by while it is written would come in an hour. Sooner, the
 * timer's own request is forced: that of alarm 0 would make an emulator forget one made in the NVIC. */
static inline void port_alarm(uint32_t at) {
    int32_t in = (int32_t)(at - port_now());
    if (in < 48)
        TIMER_INTF_SET = 1u << PORT_IRQ_TIMER;
    else
        TIMER_ALARM1 = TIMER_RAWL + ((uint32_t)in >> 4);
}

typedef struct port_word {
    uint32_t mask, value;
} port_word_t;

static inline port_word_t port_word(uint32_t mask, uint32_t value) {
    return (port_word_t){mask, value};
}

/* By hand: stops the state machine that plays edges (see player.c), and lets the other write the pins. */
void port_write(port_word_t word);

static inline uint32_t port_pins(void) {
    return (PIO_PADOUT >> FIRST_PIN & PORT_ALL_PINS) ^ port.inverted;
}

static inline uint32_t port_inputs(void) {
    return SIO_IN >> FIRST_INPUT & 0x0f;
}

#endif
