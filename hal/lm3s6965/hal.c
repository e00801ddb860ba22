/* hal.c - hal.h on a Stellaris LM3S6965, 50 MHz. Pins of port B: 0 X step, 1 X dir, 2 Y step, 3 Y dir, 4 pen, 5 motors
 * on (inverted for drivers with /ENABLE). Port E: 0 limit X, 1 limit Y, 2 start button, 3 emergency stop, all to
 * ground.
 *
 * The clock is SysTick, 24 bits at 50 MHz, extended in port.h: 25 cycles are 8 ticks. The alarm is GPTM 0, one shot. */
#include "hal/hal.h"

#include <string.h>

#include "error.h"
#include "hal/lm3s6965/port.h"
#include "hal/lm3s6965/regs.h"
#include "hal/port/ahead.h"
#include "hal/port/ring.h"

#define ALL_PINS 0x3fu
#define BOARD_INVERT 0u /* high is active: a chip in reset drives nothing, and pull-downs leave motors off, pen up */
#define ALL_INPUTS 0x0fu

port_state_t port = {.invert = BOARD_INVERT};

static struct {
    uint32_t invert_in;
    ring_t rx, tx;
    volatile bool sending;
    volatile uint32_t errors;
    uint32_t inputs;
} p;

/* At each wrap, every 0.34 s, so none is missed. */
void port_systick_isr(void) {
    (void)hal_now();
}

void hal_invert(uint32_t pins, uint32_t inputs) {
    uint32_t value = GPIO_DATA(GPIOB, ALL_PINS) ^ port.invert;
    port.invert = BOARD_INVERT ^ pins;
    p.invert_in = ALL_INPUTS ^ inputs;
    hal_pins_write(ALL_PINS, value);
}

void port_timer_isr(void) {
    TIMER0_ICR = 1;
    ahead_write_isr();
}

/* Not WFI: there is always the console to look at, and the pins do not get quieter by it. */
void hal_idle(void) {}

int hal_console_read(void) {
    return ring_get(&p.rx);
}

static void send_next(void) {
    int byte = ring_get(&p.tx);
    p.sending = byte >= 0;
    if (byte >= 0) UART0_DR = (uint32_t)byte;
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
    UART0_ICR = 0x7f0;
    while (!(UART0_FR & 1u << 4)) {
        uint32_t data = UART0_DR;
        if (data & 0xf00u) { /* overrun: the byte is good, one before it was lost; else: framing */
            UART0_RSR = 0;
            p.errors++;
            if (data & 0x700u) continue;
        }
        if (!ring_put(&p.rx, (uint8_t)data)) p.errors++;
    }
    if (!(UART0_FR & 1u << 5)) send_next();
}

uint32_t hal_inputs(void) {
    return (GPIO_DATA(GPIOE, ALL_INPUTS) ^ p.invert_in) & ALL_INPUTS;
}

void port_switches_isr(void) {
    GPIO_ICR(GPIOE) = ALL_INPUTS;
    uint32_t inputs = hal_inputs(), risen = inputs & ~p.inputs;
    p.inputs = inputs;
    if (risen & ~(uint32_t)HAL_IN_BUTTON) console_input_isr(inputs);
}

void hal_watchdog_start(uint32_t ms) {
    WDT_LOCK = 0x1acce551;
    WDT_LOAD = ms * 25000; /* the first expiry warns, the second resets: half the time each */
    WDT_CTL = 3;
    WDT_LOCK = 0;
}

void hal_watchdog_feed(void) {
    WDT_LOCK = 0x1acce551;
    WDT_ICR = 1;
    WDT_LOCK = 0;
}

const char *hal_board_name(void) {
    return "lm3s6965";
}

static void clocks_start(void) {
    const uint32_t bypass = 1u << 11, usesys = 1u << 22, pwrdn = 1u << 13;
    SYSCTL_RCC = (SYSCTL_RCC | bypass) & ~usesys;
    SYSCTL_RCC = (SYSCTL_RCC & ~(pwrdn | 0xfu << 6 | 3u << 4 | 1u << 0)) | 14u << 6; /* 8 MHz crystal */
    SYSCTL_RCC = (SYSCTL_RCC & ~(0xfu << 23)) | 3u << 23 | usesys;                   /* 200 MHz / 4 */
    while (!(SYSCTL_RIS & 1u << 6)) continue;
    SYSCTL_RCC &= ~bypass;
}

void hal_start(void) {
    SYSCTL_RCGC2 = 1u << 0 | 1u << 1 | 1u << 4;
    (void)SYSCTL_RCGC2; /* the ports answer three cycles later */
    p.invert_in = ALL_INPUTS;
    GPIO_DIR(GPIOB) = ALL_PINS;
    GPIO_DATA(GPIOB, ALL_PINS) = port.invert;
    GPIO_DEN(GPIOB) = ALL_PINS;
    clocks_start();
    SYSCTL_RCGC0 |= 1u << 3;
    SYSCTL_RCGC1 |= 1u << 16 | 1u << 0;
    (void)SYSCTL_RCGC1;

    SYST_CSR = 4; /* the processor's clock */
    SYST_RVR = 0xffffff;
    SYST_CVR = 0;
    SYST_CSR = 7;
    TIMER0_CTL = 0;
    TIMER0_CFG = 0;
    TIMER0_TAMR = 1;
    TIMER0_IMR = 1;

    GPIO_AFSEL(GPIOA) = 3;
    GPIO_DEN(GPIOA) = 3;
    UART0_CTL = 0;
    UART0_IBRD = 27; /* 50 MHz / 16 / 115200 = 27.127 */
    UART0_FBRD = 8;
    UART0_LCRH = 0x60;
    UART0_CTL = 0x301;
    UART0_IM = 1u << 4 | 1u << 5;

    GPIO_DIR(GPIOE) = 0;
    GPIO_PUR(GPIOE) = ALL_INPUTS;
    GPIO_DEN(GPIOE) = ALL_INPUTS;
    GPIO_IBE(GPIOE) = ALL_INPUTS;
    GPIO_ICR(GPIOE) = 0xff;
    GPIO_IM(GPIOE) = ALL_INPUTS;
    p.inputs = hal_inputs();

    pendsv_priority(1);
    systick_priority(3);
    irq_priority(PORT_IRQ_UART, 2);
    irq_enable(PORT_IRQ_TIMER);
    irq_enable(PORT_IRQ_UART);
    irq_enable(PORT_IRQ_SWITCHES);
}

static void safe(void) {
    TIMER0_CTL = 0;
    GPIO_DATA(GPIOB, ALL_PINS) = port.invert;
}

static void put_polled(const char *text) {
    for (; *text; text++) {
        while (UART0_FR & 1u << 5) continue;
        UART0_DR = (uint8_t)*text;
    }
}

void hal_fault(const char *what, int32_t a, int32_t b) {
    (void)irq_lock();
    safe();
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
