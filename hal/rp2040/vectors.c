/* vectors.c - the vector table of the RP2040. */
#include "firmware/start.h"
#include "hal/port/ahead.h"
#include "port.h"

static void unexpected(void) {
    port_panic();
}

__attribute__((section(".vectors"), used)) static void (*const vectors[16 + 32])(void) = {
    [0] = (void (*)(void))(void *)_stack_top,
    [1] = start_reset,
    [2] = unexpected, /* NMI */
    [3] = unexpected, /* the hard fault */
    [11] = unexpected,
    [14] = ahead_plan_isr,
    [15] = unexpected,
    [16 + PORT_IRQ_WAKE] = port_wake_isr,
    [16 + PORT_IRQ_TIMER] = port_timer_isr,
    [16 + 2 ... 16 + 12] = unexpected,
    [16 + PORT_IRQ_SWITCHES] = port_switches_isr,
    [16 + 14 ... 16 + 19] = unexpected,
    [16 + PORT_IRQ_UART] = port_uart_isr,
    [16 + 21 ... 16 + 31] = unexpected,
};
