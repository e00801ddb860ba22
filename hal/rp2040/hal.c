/* hal.c - hal.h on the RP2040 of a Raspberry Pi Pico, 125 MHz; see port.h for pins and clock. */
#include "hal/hal.h"

#include "error.h"
#include "hal/port/ahead.h"
#include "hal/port/ring.h"
#include "port.h"

#define ALL_PINS 0x3fu
#define BOARD_INVERT HAL_ENABLE /* /ENABLE, pulled up on the drivers: a chip in reset leaves them off */
#define ALL_INPUTS 0x0fu
#define STOPPING (HAL_IN_LIMIT_X | HAL_IN_LIMIT_Y | HAL_IN_ESTOP)

#define RX_IRQ (1u << 4)
#define TX_IRQ (1u << 5)

enum { PIN_TX = 0, PIN_RX = 1, FIRST_INPUT = 10 }; /* four in one register of eight */
#define INPUT_EDGES                                                                                                    \
    (GPIO_EDGES(FIRST_INPUT) | GPIO_EDGES(FIRST_INPUT + 1) | GPIO_EDGES(FIRST_INPUT + 2) | GPIO_EDGES(FIRST_INPUT + 3))

port_state_t port = {.invert = BOARD_INVERT};

static struct {
    uint32_t invert_in;
    ring_t rx, tx;
    volatile bool sending;
    volatile uint32_t errors;
    uint32_t inputs;
} p;

void hal_invert(uint32_t pins, uint32_t inputs) {
    uint32_t value = (SIO_OUT >> FIRST_PIN & ALL_PINS) ^ port.invert;
    port.invert = BOARD_INVERT ^ pins;
    p.invert_in = ALL_INPUTS ^ inputs;
    hal_pins_write(ALL_PINS, value);
}

void port_timer_isr(void) {
    TIMER_INTR = 2;
    ahead_write_isr();
}

/* Sleeps until an interrupt, 1 ms at most. One that came before, but after its cause was looked for, ends the sleep
 * at once, as it is still pending: interrupts are off meanwhile, which WFI does not mind. */
void hal_idle(void) {
    uint32_t state = irq_lock();
    TIMER_ALARM0 = TIMER_RAWL + 1000;
    if (ring_empty(&p.rx)) __asm volatile("wfi");
    irq_unlock(state);
}

void port_wake_isr(void) {
    TIMER_INTR = 1;
}

int hal_console_read(void) {
    return ring_get(&p.rx);
}

static void send_next(void) {
    int byte = ring_get(&p.tx);
    p.sending = byte >= 0;
    UART_IMSC = RX_IRQ | (p.sending ? TX_IRQ : 0);
    if (byte >= 0) UART_DR = (uint32_t)byte;
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
    UART_ICR = 0x7f0;
    while (!(UART_FR & 1u << 4)) {
        uint32_t data = UART_DR;
        if (data & 0xf00u) { /* overrun: the byte is good, one before it was lost; else: framing */
            UART_RSR = 0;
            p.errors++;
            if (data & 0x700u) continue;
        }
        if (!ring_put(&p.rx, (uint8_t)data)) p.errors++;
    }
    if (p.sending && !(UART_FR & 1u << 5)) send_next();
}

uint32_t hal_inputs(void) {
    return (SIO_IN >> FIRST_INPUT & ALL_INPUTS) ^ p.invert_in;
}

void port_switches_isr(void) {
    GPIO_INTR(FIRST_INPUT) = INPUT_EDGES;
    uint32_t inputs = hal_inputs(), risen = inputs & ~p.inputs;
    p.inputs = inputs;
    if (risen & STOPPING) console_input_isr(inputs);
}

static uint32_t watchdog_load;

/* Counts down twice a microsecond (erratum RP2040-E1). */
void hal_watchdog_start(uint32_t ms) {
    watchdog_load = ms * 2000;
    REG(WATCHDOG + CLR) = 1u << 30;
    REG(0x40010008u) = 0x1fffcu; /* PSM_WDSEL: all but the oscillators is reset */
    hal_watchdog_feed();
    REG(WATCHDOG + SET) = 1u << 30;
}

void hal_watchdog_feed(void) {
    REG(WATCHDOG + 0x04u) = watchdog_load;
}

const char *hal_board_name(void) {
    return "rp2040";
}

/* From the ring oscillator to 125 MHz (PLL_SYS) and 12 MHz for TIMER. */
static void clocks_start(void) {
    REG(XOSC + 0x00u) = 0xaa0;
    REG(XOSC + 0x0cu) = 47; /* start-up: 1 ms */
    REG(XOSC + SET + 0x00u) = 0xfabu << 12;
    while (!(REG(XOSC + 0x04u) & 1u << 31)) continue;
    REG(CLOCKS + CLR + 0x3cu) = 1; /* clk_sys from clk_ref while its PLL is set */
    while (REG(CLOCKS + 0x44u) != 1) continue;
    REG(CLOCKS + 0x30u) = 2; /* clk_ref from the crystal */
    while (REG(CLOCKS + 0x38u) != 4) continue;
    const uint32_t pll = 1u << 12;
    REG(RESETS + SET) = pll;
    REG(RESETS + CLR) = pll;
    while (!(REG(RESETS + 0x08u) & pll)) continue;
    REG(PLL_SYS + 0x00u) = 1;
    REG(PLL_SYS + 0x08u) = 125; /* 1500 MHz */
    REG(PLL_SYS + CLR + 0x04u) = 1u << 0 | 1u << 5;
    while (!(REG(PLL_SYS) & 1u << 31)) continue;
    REG(PLL_SYS + 0x0cu) = 6u << 16 | 2u << 12;
    REG(PLL_SYS + CLR + 0x04u) = 1u << 3;
    REG(CLOCKS + 0x40u) = 1u << 8;
    REG(CLOCKS + 0x3cu) = 0;
    REG(CLOCKS + SET + 0x3cu) = 1;
    while (REG(CLOCKS + 0x44u) != 2) continue;
    REG(CLOCKS + 0x48u) = 1u << 11;       /* clk_peri */
    REG(WATCHDOG + 0x2cu) = 1u << 9 | 12; /* the tick of TIMER: 1 us */
}

static void pins_start(void) {
    SIO_OUT_XOR = SIO_OUT ^ port.invert << FIRST_PIN;
    for (uint32_t i = FIRST_PIN; i < FIRST_PIN + 6; i++) {
        GPIO_PAD(i) = PAD_OUT;
        GPIO_CTRL(i) = FUNC_SIO;
    }
    SIO_OE_SET = ALL_PINS << FIRST_PIN;
    for (uint32_t i = FIRST_INPUT; i < FIRST_INPUT + 4; i++) {
        GPIO_PAD(i) = PAD_PULLUP;
        GPIO_CTRL(i) = FUNC_SIO;
    }
}

static void uart_start(void) {
    GPIO_PAD(PIN_TX) = PAD_OUT;
    GPIO_PAD(PIN_RX) = PAD_PULLUP;
    GPIO_CTRL(PIN_TX) = FUNC_UART;
    GPIO_CTRL(PIN_RX) = FUNC_UART;
    UART_IBRD = 67; /* 125 MHz / 16 / 115200 = 67.817 */
    UART_FBRD = 52;
    UART_LCR = 3u << 5; /* no FIFO: an interrupt for every byte */
    UART_CR = 0x301;
    UART_IMSC = RX_IRQ;
}

static void clock_start(void) {
    PWM_DIV(CLOCK_SLICE) = 7u << 4 | 13;
    PWM_TOP(CLOCK_SLICE) = 0xffff;
    PWM_CTR(CLOCK_SLICE) = 0;
    PWM_CSR(CLOCK_SLICE) = 1;
    uint32_t us = TIMER_RAWL;
    while (TIMER_RAWL == us) continue;
    port.phase = (uint16_t)(PWM_CTR(CLOCK_SLICE) - (us + 1) * 16);
}

void hal_start(void) {
    /* IO_BANK0, PADS_BANK0, PWM, TIMER, UART0 */
    const uint32_t need = 1u << 5 | 1u << 8 | 1u << 14 | 1u << 21 | 1u << 22;
    REG(RESETS + CLR) = 1u << 5 | 1u << 8;
    while ((~REG(RESETS + 0x08u)) & (1u << 5 | 1u << 8)) continue;
    p.invert_in = ALL_INPUTS;
    pins_start();
    clocks_start();
    REG(RESETS + CLR) = need;
    while (~REG(RESETS + 0x08u) & need) continue;
    uart_start();
    clock_start();
    p.inputs = hal_inputs();
    GPIO_INTE(FIRST_INPUT) = INPUT_EDGES;
    pendsv_priority(1);
    irq_priority(PORT_IRQ_UART, 2);
    TIMER_INTE = 3;
    irq_priority(PORT_IRQ_WAKE, 3);
    irq_enable(PORT_IRQ_WAKE);
    irq_enable(PORT_IRQ_TIMER);
    irq_enable(PORT_IRQ_SWITCHES);
    irq_enable(PORT_IRQ_UART);
}

static void put_polled(const char *text) {
    for (; *text; text++) {
        while (UART_FR & 1u << 5) continue;
        UART_DR = (uint8_t)*text;
    }
}

void hal_fault(const char *what, int32_t a, int32_t b) {
    (void)irq_lock();
    port_write(port_word(ALL_PINS, 0));
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
