/* hal.c - hal.h on the nRF51822 of a BBC micro:bit. The clock and the alarm are TIMER0, 32 bits at 8 MHz: two
 * ticks a count. The switches are looked at after every edge and by hal_idle, as QEMU knows no interrupt on a pin of
 * this chip. */
#include "hal/hal.h"

#include "hal/port/ahead.h"
#include "hal/port/console.h"
#include "hal/port/solenoid.h"
#include "hal/port/switches.h"
#include "port.h"

enum { PIN_TX = 24, PIN_RX = 25 };

port_state_t port = {.invert = PORT_INVERT};

#define BIT(word, pin, at) ((uint32_t)((word) >> (pin)&1) << (at))
#define SPREAD1(w)                                                                                                     \
    (BIT(w, 0, PIN_X_STEP) | BIT(w, 1, PIN_X_DIR) | BIT(w, 2, PIN_Y_STEP) | BIT(w, 3, PIN_Y_DIR) |                     \
     BIT(w, 4, PIN_PEN) | BIT(w, 5, PIN_ENABLE) | 1u << PIN_TX)
#define SPREAD4(w) SPREAD1(w), SPREAD1((w) + 1), SPREAD1((w) + 2), SPREAD1((w) + 3)
#define SPREAD16(w) SPREAD4(w), SPREAD4((w) + 4), SPREAD4((w) + 8), SPREAD4((w) + 12)
const uint32_t port_spread[64] = {SPREAD16(0), SPREAD16(16), SPREAD16(32), SPREAD16(48)};

static const uint8_t PIN[6] = {PIN_X_STEP, PIN_X_DIR, PIN_Y_STEP, PIN_Y_DIR, PIN_PEN, PIN_ENABLE};
static const uint8_t INPUT[4] = {23, 22, 17, 21};
#define INPUTS (1u << 23 | 1u << 22 | 1u << 17 | 1u << 21)

uint32_t port_pins(void) {
    uint32_t out = GPIO_OUT, value = 0;
    for (int i = 0; i < 6; i++) value |= (out >> PIN[i] & 1) << i;
    return value;
}

uint32_t port_inputs(void) {
    uint32_t in = GPIO_IN, inputs = 0;
    for (int i = 0; i < 4; i++) inputs |= (in >> INPUT[i] & 1) << i;
    return inputs;
}

void port_uart_isr(void) {
    if (UART_ERROR) {
        UART_ERROR = 0;
        UART_ERRORSRC = UART_ERRORSRC; /* ones clear */
        console_lost();
    }
    console_uart_isr();
}

#define WAKE (1u << 16) /* of TIMER1's interrupts: compare 0 */
#define PEN (1u << 18)

/* Not before now: the counter would have to come round. */
static void pen_in(uint32_t us) {
    const uint32_t state = irq_lock();
    uint32_t at = TIMER1_CC2 + us;
    TIMER1_CAPTURE3 = 1;
    if ((int16_t)(at - TIMER1_CC3) < 4) at = TIMER1_CC3 + 4;
    TIMER1_CC2 = at & 0xffff;
    irq_unlock(state);
}

void port_wake_isr(void) {
    if (TIMER1_COMPARE0) {
        TIMER1_COMPARE0 = 0;
        pendsv_pend();
    }
    if (TIMER1_COMPARE2 && TIMER1_INTENSET & PEN) {
        TIMER1_COMPARE2 = 0;
        pen_in(solenoid_turn());
    }
}

/* Interrupts off only when there is something to be done: the player's may be due. */
static void look_at_switches(void) {
    static uint32_t seen = UINT32_MAX;
    const uint32_t in = GPIO_IN & INPUTS;
    if (in == seen) return;
    const uint32_t state = irq_lock();
    seen = in;
    switches_isr();
    irq_unlock(state);
}

void port_plan_isr(void) {
    ahead_plan_isr();
    look_at_switches();
}

void hal_idle(void) {
    look_at_switches();
}

/* 32,768 Hz, its own oscillator; runs on while the processor sleeps or is held by a debugger's breakpoint not. */
void hal_watchdog_start(uint32_t ms) {
    WDT_CRV = ms * 32768 / 1000;
    WDT_RREN = 1;
    WDT_START = 1;
}

void hal_watchdog_feed(void) {
    WDT_RR0 = 0x6e524635;
}

void port_wire(const hal_wiring_t *wiring) {
    player_turn(port.invert);
    GPIO_PIN_CNF(PIN_PEN) = 1 | (port.invert & HAL_PEN ? 3u : 1u) << 2; /* pulled to rest, where it is not driven */
    GPIO_DIRSET = port_spread[PORT_ALL_PINS];
    TIMER1_INTENCLR = PEN;
    if (!solenoid_wire(wiring)) return;
    pen_in(0);
    TIMER1_INTENSET = PEN;
}

const char *hal_board_name(void) {
    return "nrf51";
}

void hal_start(void) {
    hal_pins_write(PORT_ALL_PINS, 0);
    for (int i = 0; i < 4; i++) GPIO_PIN_CNF(INPUT[i]) = 3u << 2; /* pulled up */

    CLOCK_HFCLKSTART = 1; /* the crystal */
    while (!CLOCK_HFCLKSTARTED) continue;
    TIMER0_BITMODE = 3;
    TIMER0_PRESCALER = 1;
    TIMER0_INTENSET = 1u << 16;
    TIMER0_START = 1;
    TIMER1_BITMODE = 0;
    TIMER1_PRESCALER = 4;
    TIMER1_INTENSET = WAKE;
    TIMER1_START = 1;

    GPIO_OUTSET = 1u << PIN_TX;
    GPIO_DIRSET = 1u << PIN_TX;
    UART_PSELTXD = PIN_TX;
    UART_PSELRXD = PIN_RX;
    UART_BAUDRATE = 0x01d7e000;
    UART_ENABLE = 4;
    UART_INTENSET = 1u << 2 | 1u << 7 | 1u << 9;
    UART_STARTTX = 1;
    UART_STARTRX = 1;

    switches_start();
    irq_priority(PORT_IRQ_WAKE, 1);
    pendsv_priority(2);
    irq_priority(PORT_IRQ_UART, 3);
    irq_enable(PORT_IRQ_TIMER);
    irq_enable(PORT_IRQ_WAKE);
    irq_enable(PORT_IRQ_UART);
}
