/* vectors.c - the vector table of the LM3S6965. */
#include "firmware/start.h"
#include "hal/lm3s6965/port.h"
#include "hal/port/ahead.h"

static void unexpected(void) {
    port_panic();
}

__attribute__((section(".vectors"), used)) static void (*const vectors[16 + 44])(void) = {
    [0] = (void (*)(void))(void *)_stack_top,
    [1] = start_reset,
    [2 ... 6] = unexpected, /* NMI and the faults */
    [11] = unexpected,
    [12] = unexpected,
    [14] = ahead_plan_isr,
    [15] = port_systick_isr,
    [16 + 0 ... 16 + 3] = unexpected,
    [16 + PORT_IRQ_SWITCHES] = port_switches_isr,
    [16 + PORT_IRQ_UART] = port_uart_isr,
    [16 + 6 ... 16 + 18] = unexpected,
    [16 + PORT_IRQ_TIMER] = port_timer_isr,
    [16 + 20 ... 16 + 43] = unexpected,
};
