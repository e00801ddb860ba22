/* port.h - what ahead.h asks of this port, and the interrupts for its vector table. */
#ifndef PORT_H
#define PORT_H

#include "hal/hal.h"
#include "hal/lm3s6965/regs.h"
#include "hal/port/pl011.h"

#define AHEAD_ENTRY 20
#define AHEAD_SOON 40
#define AHEAD_AFTER 12
#define AHEAD_SLACK 16

#define PORT_ALL_PINS 0x3fu
#define PORT_INVERT 0u /* high is active: a chip in reset drives nothing, and pull-downs leave motors off, pen up */
#define PORT_STORE_END 0x40000u /* of flash */

enum {
    PORT_IRQ_SWITCHES = 4 /* GPIO port E */,
    PORT_IRQ_UART = 5,
    PORT_IRQ_TIMER = 19 /* GPTM 0A */,
    PORT_IRQ_PEN = 21 /* GPTM 1A */
};

void port_systick_isr(void);
void port_switches_isr(void);
void port_uart_isr(void);
void port_timer_isr(void);
void port_pen_isr(void);
void port_wire(const hal_wiring_t *wiring);
static inline void port_pen_up(void) {}

typedef struct port_state {
    uint32_t ticks, part; /* clock at systick, and 1/25 ticks */
    uint32_t systick;
    uint32_t invert; /* pins that are active low */
    uint32_t level;  /* of all pins, as written: the chip forgets that of one that is not driven */
} port_state_t;
extern port_state_t port;

#define PORT_SOFT_PEN /* solenoid.h, by GPTM 1 */

static inline bool port_pen_is_down(void) {
    return (port.level ^ port.invert) & HAL_PEN;
}

/* What was written while it was not driven comes first: until then the pad is off. */
static inline void port_pen_drive(bool on) {
    const uint32_t others = PORT_ALL_PINS & ~(uint32_t)HAL_PEN, state = irq_lock();
    if (!on) {
        GPIO_DIR(GPIOB) = others;
    } else if (!(GPIO_DIR(GPIOB) & HAL_PEN)) {
        GPIO_DEN(GPIOB) = others;
        GPIO_DIR(GPIOB) = PORT_ALL_PINS;
        GPIO_DATA(GPIOB, HAL_PEN) = port.level;
        GPIO_DEN(GPIOB) = PORT_ALL_PINS;
    }
    irq_unlock(state);
}

static inline uint32_t port_now(void) {
    uint32_t at = SYST_CVR;
    uint32_t sum = port.part + ((port.systick - at) & 0xffffffu) * 8;
    uint32_t whole = sum / 25;
    port.systick = at;
    port.part = sum - whole * 25;
    return port.ticks += whole;
}

/* Cycles from the last port_now on. */
static inline uint32_t port_raw(uint32_t at) {
    int32_t in = (int32_t)(at - port.ticks);
    return in <= 0 ? 0 : ((uint32_t)in * 25 - port.part) >> 3;
}

static inline void port_until(uint32_t raw) {
    const uint32_t from = port.systick;
    while (((from - SYST_CVR) & 0xffffffu) < raw) continue;
}

static inline void port_alarm(uint32_t at) {
    TIMER0_CTL = 0;
    int32_t in = (int32_t)(at - port_now());
    if (in <= 0) {
        irq_pend(PORT_IRQ_TIMER);
    } else {
        TIMER0_TAILR = (uint32_t)(((uint64_t)(uint32_t)in * 25) >> 3);
        TIMER0_CTL = 1;
    }
}

typedef struct port_word {
    uint32_t mask, value;
} port_word_t;

static inline port_word_t port_word(uint32_t mask, uint32_t value) {
    return (port_word_t){mask, (value ^ port.invert) & mask};
}

static inline void port_write(port_word_t word) {
    GPIO_DATA(GPIOB, word.mask) = word.value;
    port.level = (port.level & ~word.mask) | word.value;
}

static inline uint32_t port_level(uint32_t pins) {
    return pins ^ port.invert;
}

static inline void port_put(uint32_t level) {
    GPIO_DATA(GPIOB, PORT_ALL_PINS) = level;
    port.level = level;
}

static inline uint32_t port_pins(void) {
    return port.level;
}

static inline uint32_t port_inputs(void) {
    return GPIO_DATA(GPIOE, 0x0f);
}

#endif
