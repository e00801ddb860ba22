/* vectors.c - the vector table of the nRF51822. */
#include "hal/port/vectors.h"
#include "port.h"

VECTOR_TABLE = {
    VECTORS_HEAD(port_plan_isr, console_panic), [16 + 0 ... 16 + 1] = console_panic,
    [16 + PORT_IRQ_UART] = port_uart_isr,       [16 + 3 ... 16 + 7] = console_panic,
    [16 + PORT_IRQ_TIMER] = player_isr,         [16 + PORT_IRQ_WAKE] = port_wake_isr,
    [16 + 10 ... 16 + 31] = console_panic,
};
