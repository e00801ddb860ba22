/* hal.c - hal.h on a Stellaris LM3S6965, 50 MHz. Pins of port B: 0 X step, 1 X dir, 2 Y step, 3 Y dir, 4 pen, 5 motors
 * on (inverted for drivers with /ENABLE). Port E: 0 limit X, 1 limit Y, 2 start button, 3 emergency stop, all to
 * ground.
 *
 * The clock is SysTick, 24 bits at 50 MHz, extended in port.h: 25 cycles are 8 ticks. The alarm is GPTM 0, one shot. */
#include "hal/hal.h"

#include "hal/lm3s6965/port.h"
#include "hal/lm3s6965/regs.h"
#include "hal/port/ahead.h"
#include "hal/port/console.h"
#include "hal/port/solenoid.h"
#include "hal/port/switches.h"

port_state_t port = {.invert = PORT_INVERT, .level = PORT_INVERT};

/* At each wrap, every 0.34 s, so none is missed. */
void port_systick_isr(void) {
    (void)hal_now();
}

void port_timer_isr(void) {
    TIMER0_ICR = 1;
    player_isr();
}

/* Not WFI: there is always the console to look at, and the pins do not get quieter by it. */
void hal_idle(void) {}

void port_switches_isr(void) {
    GPIO_ICR(GPIOE) = 0x0f;
    switches_isr();
}

void port_uart_isr(void) {
    UART_ICR = 0x7f0;
    console_uart_isr();
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

static void pen_in(uint32_t us) {
    TIMER1_TAILR = us * 50;
    TIMER1_CTL = 1;
}

void port_pen_isr(void) {
    TIMER1_ICR = 1;
    pen_in(solenoid_turn());
}

void port_wire(const hal_wiring_t *wiring) {
    /* The pen's is pulled to rest, where it is not driven. */
    GPIO_PUR(GPIOB) = port.invert & HAL_PEN;
    GPIO_PDR(GPIOB) = HAL_PEN & ~port.invert;
    GPIO_DEN(GPIOB) = PORT_ALL_PINS;
    TIMER1_CTL = 0;
    if (solenoid_wire(wiring)) pen_in(1);
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
    (void)SYSCTL_RCGC2;  /* the ports answer three cycles later */
    GPIO_DEN(GPIOB) = 0; /* the pads are off until port_wire */
    GPIO_DIR(GPIOB) = PORT_ALL_PINS;
    GPIO_DATA(GPIOB, PORT_ALL_PINS) = port.invert;
    clocks_start();
    SYSCTL_RCGC0 |= 1u << 3;
    SYSCTL_RCGC1 |= 1u << 17 | 1u << 16 | 1u << 0;
    (void)SYSCTL_RCGC1;

    SYST_CSR = 4; /* the processor's clock */
    SYST_RVR = 0xffffff;
    SYST_CVR = 0;
    SYST_CSR = 7;
    TIMER0_CTL = 0;
    TIMER0_CFG = 0;
    TIMER0_TAMR = 1;
    TIMER0_IMR = 1;
    TIMER1_TAMR = 1;
    TIMER1_IMR = 1;

    GPIO_AFSEL(GPIOA) = 3;
    GPIO_DEN(GPIOA) = 3;
    UART_CR = 0;
    UART_IBRD = 27; /* 50 MHz / 16 / 115200 = 27.127 */
    UART_FBRD = 8;
    UART_LCRH = 0x60;
    UART_CR = 0x301;
    UART_IMSC = UART_RX;

    GPIO_DIR(GPIOE) = 0;
    GPIO_PUR(GPIOE) = 0x0f;
    GPIO_DEN(GPIOE) = 0x0f;
    GPIO_IBE(GPIOE) = 0x0f;
    GPIO_ICR(GPIOE) = 0xff;
    GPIO_IM(GPIOE) = 0x0f;
    switches_start();

    irq_priority(PORT_IRQ_PEN, 1);
    pendsv_priority(2);
    irq_priority(PORT_IRQ_UART, 3);
    systick_priority(3);
    irq_enable(PORT_IRQ_PEN);
    irq_enable(PORT_IRQ_TIMER);
    irq_enable(PORT_IRQ_UART);
    irq_enable(PORT_IRQ_SWITCHES);
}
