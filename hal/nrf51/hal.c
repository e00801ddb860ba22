/* hal.c - hal.h on the nRF51822 of a BBC micro:bit. The clock and the alarm are TIMER0, 32 bits at 8 MHz: two
 * ticks a count. The switches are looked at by the UART's and the timer's interrupts and by hal_idle, 1 ms apart at
 * most, because the processor has no interrupt on a pin that QEMU knows. */
#include "hal/hal.h"

#include "error.h"
#include "hal/port/ahead.h"
#include "hal/port/ring.h"
#include "port.h"

#define BOARD_INVERT 0u /* high is active: a chip in reset drives nothing, and pull-downs leave motors off, pen up */
#define ALL_INPUTS 0x0fu
#define STOPPING (HAL_IN_LIMIT_X | HAL_IN_LIMIT_Y | HAL_IN_ESTOP)

enum { PIN_TX = 24, PIN_RX = 25 };

uint32_t port_invert = BOARD_INVERT;

#define BIT(word, pin, at) ((uint32_t)((word) >> (pin)&1) << (at))
#define SPREAD1(w)                                                                                                     \
    (BIT(w, 0, PIN_X_STEP) | BIT(w, 1, PIN_X_DIR) | BIT(w, 2, PIN_Y_STEP) | BIT(w, 3, PIN_Y_DIR) |                     \
     BIT(w, 4, PIN_PEN) | BIT(w, 5, PIN_ENABLE))
#define SPREAD4(w) SPREAD1(w), SPREAD1((w) + 1), SPREAD1((w) + 2), SPREAD1((w) + 3)
#define SPREAD16(w) SPREAD4(w), SPREAD4((w) + 4), SPREAD4((w) + 8), SPREAD4((w) + 12)
const uint32_t port_spread[64] = {SPREAD16(0), SPREAD16(16), SPREAD16(32), SPREAD16(48)};

static const uint8_t PIN[6] = {PIN_X_STEP, PIN_X_DIR, PIN_Y_STEP, PIN_Y_DIR, PIN_PEN, PIN_ENABLE};
static const uint8_t INPUT[4] = {23, 22, 17, 21};

static struct {
    uint32_t invert_in;
    ring_t rx, tx;
    volatile bool sending;
    volatile uint32_t errors;
    uint32_t inputs;
} p;

void hal_invert(uint32_t pins, uint32_t inputs) {
    uint32_t out = GPIO_OUT, value = 0;
    for (int i = 0; i < 6; i++) value |= (out >> PIN[i] & 1) << i;
    value ^= port_invert;
    port_invert = BOARD_INVERT ^ pins;
    p.invert_in = ALL_INPUTS ^ inputs;
    hal_pins_write(0x3f, value);
}

uint32_t hal_inputs(void) {
    uint32_t in = GPIO_IN, inputs = 0;
    for (int i = 0; i < 4; i++) inputs |= (in >> INPUT[i] & 1) << i;
    return inputs ^ p.invert_in;
}

/* Interrupts off or in PendSV. */
static void look_at_switches(void) {
    uint32_t inputs = hal_inputs(), risen = inputs & ~p.inputs;
    p.inputs = inputs;
    if (risen & STOPPING) console_input_isr(inputs);
}

void port_timer_isr(void) {
    TIMER0_COMPARE0 = 0;
    ahead_write_isr();
}

void port_plan_isr(void) {
    ahead_plan_isr();
    look_at_switches();
}

void hal_idle(void) {
    uint32_t state = irq_lock();
    look_at_switches();
    irq_unlock(state);
}

int hal_console_read(void) {
    return ring_get(&p.rx);
}

static void send_next(void) {
    int byte = ring_get(&p.tx);
    p.sending = byte >= 0;
    if (byte >= 0) UART_TXD = (uint32_t)byte;
}

void hal_console_write(const char *text, size_t bytes) {
    for (size_t i = 0; i < bytes; i++) {
        while (!ring_put(&p.tx, (uint8_t)text[i])) hal_idle();
        uint32_t state = irq_lock();
        if (!p.sending) send_next();
        irq_unlock(state);
    }
}

uint32_t hal_console_errors(void) {
    uint32_t state = irq_lock();
    uint32_t n = p.errors;
    p.errors = 0;
    irq_unlock(state);
    return n;
}

void port_uart_isr(void) {
    if (UART_ERROR) {
        UART_ERROR = 0;
        UART_ERRORSRC = UART_ERRORSRC; /* ones clear */
        p.errors++;
    }
    while (UART_RXDRDY) {
        UART_RXDRDY = 0;
        if (!ring_put(&p.rx, (uint8_t)UART_RXD)) p.errors++;
    }
    if (UART_TXDRDY) {
        UART_TXDRDY = 0;
        send_next();
    }
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

const char *hal_board_name(void) {
    return "nrf51";
}

void hal_start(void) {
    hal_pins_write(0x3f, 0);
    GPIO_DIRSET = port_spread[0x3f];
    p.invert_in = ALL_INPUTS;
    for (int i = 0; i < 4; i++) GPIO_PIN_CNF(INPUT[i]) = 3u << 2; /* pulled up */

    CLOCK_HFCLKSTART = 1; /* the crystal */
    while (!CLOCK_HFCLKSTARTED) continue;
    TIMER0_BITMODE = 3;
    TIMER0_PRESCALER = 1;
    TIMER0_INTENSET = 1u << 16;
    TIMER0_START = 1;

    GPIO_OUTSET = 1u << PIN_TX;
    GPIO_DIRSET = 1u << PIN_TX;
    UART_PSELTXD = PIN_TX;
    UART_PSELRXD = PIN_RX;
    UART_BAUDRATE = 0x01d7e000;
    UART_ENABLE = 4;
    UART_INTENSET = 1u << 2 | 1u << 7 | 1u << 9;
    UART_STARTTX = 1;
    UART_STARTRX = 1;

    p.inputs = hal_inputs();
    pendsv_priority(1);
    irq_priority(PORT_IRQ_UART, 2);
    irq_enable(PORT_IRQ_TIMER);
    irq_enable(PORT_IRQ_UART);
}

static void put_polled(const char *text) {
    for (; *text; text++) {
        UART_TXDRDY = 0;
        UART_TXD = (uint8_t)*text;
        while (!UART_TXDRDY) continue;
    }
}

void hal_fault(const char *what, int32_t a, int32_t b) {
    (void)irq_lock();
    port_write(port_word(0x3f, 0));
    put_polled("\r\nfault: ");
    put_polled(what);
    const int32_t number[2] = {a, b};
    for (int i = 0; i < 2; i++) {
        char text[] = " 0x00000000";
        for (int k = 0; k < 8; k++) text[10 - k] = "0123456789abcdef"[(uint32_t)number[i] >> 4 * k & 15];
        put_polled(text);
    }
    put_polled("\r\n");
    for (;;) continue;
}

void port_panic(void) {
    hal_fault("exception", (int32_t)(ICSR & 0x1ff), 0);
}
