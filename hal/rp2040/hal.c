/* hal.c - hal.h on the RP2040 of a Raspberry Pi Pico, 133 MHz; see port.h for pins and clock. */
#include "hal/hal.h"

#include <string.h>

#include "hal/port/ahead.h"
#include "hal/port/console.h"
#include "hal/port/switches.h"
#include "port.h"

enum { PIN_TX = 0, PIN_RX = 1 };
#define INPUT_EDGES                                                                                                    \
    (GPIO_EDGES(FIRST_INPUT) | GPIO_EDGES(FIRST_INPUT + 1) | GPIO_EDGES(FIRST_INPUT + 2) | GPIO_EDGES(FIRST_INPUT + 3))

port_state_t port = {.invert = PORT_INVERT, .inverted = PORT_ALL_PINS};

void port_timer_isr(void) {
    TIMER_INTR = 2;
    TIMER_INTF_CLR = 2;
    player_isr();
}

/* Sleeps until an interrupt, 1 ms at most. One that came before, but after its cause was looked for, ends the sleep
 * at once, as it is still pending: interrupts are off meanwhile, which WFI does not mind. */
void hal_idle(void) {
    uint32_t state = irq_lock();
    TIMER_ALARM0 = TIMER_RAWL + 1000;
    if (!console_waiting()) __asm volatile("wfi");
    irq_unlock(state);
}

void port_wake_isr(void) {
    TIMER_INTR = 1;
}

void port_switches_isr(void) {
    GPIO_INTR(FIRST_INPUT) = INPUT_EDGES;
    switches_isr();
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

/* From the ring oscillator to 133 MHz (PLL_SYS), the most that the data sheet allows, and 12 MHz for TIMER. */
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
    REG(PLL_SYS + 0x08u) = 133; /* 1596 MHz */
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
    UART_IBRD = 72; /* 133 MHz / 16 / 115200 = 72.157 */
    UART_FBRD = 10;
    UART_LCRH = 3u << 5; /* no FIFO: an interrupt for every byte */
    UART_CR = 0x301;
    UART_IMSC = UART_RX;
}

static void clock_start(void) {
    PWM_DIV(CLOCK_SLICE) = 8u << 4 | 5; /* 16 MHz */
    PWM_TOP(CLOCK_SLICE) = 0xffff;
    PWM_CTR(CLOCK_SLICE) = 0;
    PWM_CSR(CLOCK_SLICE) = 1;
    uint32_t us = TIMER_RAWL;
    while (TIMER_RAWL == us) continue;
    port.phase = (uint16_t)(PWM_CTR(CLOCK_SLICE) - (us + 1) * 16);
}

/* Vectors are read at each interrupt, and not to wait for the flash either. */
static void vectors_to_ram(void) {
    static uint32_t vectors[16 + 32] __attribute__((aligned(256)));
    memcpy(vectors, (const void *)VTOR, sizeof vectors);
    VTOR = (uint32_t)vectors;
}

void hal_start(void) {
    /* DMA, IO_BANK0, PADS_BANK0, PIO0, PWM, TIMER, UART0 */
    const uint32_t need = 1u << 2 | 1u << 5 | 1u << 8 | 1u << 10 | 1u << 14 | 1u << 21 | 1u << 22;
    REG(RESETS + CLR) = 1u << 5 | 1u << 8;
    while ((~REG(RESETS + 0x08u)) & (1u << 5 | 1u << 8)) continue;
    pins_start();
    vectors_to_ram();
    clocks_start();
    REG(RESETS + CLR) = need;
    while (~REG(RESETS + 0x08u) & need) continue;
    player_start();
    uart_start();
    clock_start();
    switches_start();
    GPIO_INTE(FIRST_INPUT) = INPUT_EDGES;
    pendsv_priority(1);
    irq_priority(PORT_IRQ_UART, 2);
    TIMER_INTE = 3 | PEN_ALARM;
    irq_priority(PORT_IRQ_WAKE, 3);
    irq_priority(PORT_IRQ_PEN, 3);
    irq_enable(PORT_IRQ_WAKE);
    irq_enable(PORT_IRQ_TIMER);
    irq_enable(PORT_IRQ_DMA);
    irq_enable(PORT_IRQ_SWITCHES);
    irq_enable(PORT_IRQ_UART);
}
