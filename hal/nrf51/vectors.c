/* vectors.c - the vector table of the nRF51822. */
#include "firmware/start.h"
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
    [14] = port_plan_isr,
    [15] = unexpected,
    [16 + 0 ... 16 + 1] = unexpected,
    [16 + PORT_IRQ_UART] = port_uart_isr,
    [16 + 3 ... 16 + 7] = unexpected,
    [16 + PORT_IRQ_TIMER] = port_timer_isr,
    [16 + 9 ... 16 + 31] = unexpected,
};
