/* vectors.c - the vector table of the LM3S6965. */
#include "hal/port/vectors.h"
#include "hal/lm3s6965/port.h"

VECTOR_TABLE = {
    VECTORS_HEAD(ahead_plan_isr, port_systick_isr),
    [16 + 0 ... 16 + 3] = console_panic,
    [16 + PORT_IRQ_SWITCHES] = port_switches_isr,
    [16 + PORT_IRQ_UART] = port_uart_isr,
    [16 + 6 ... 16 + 18] = console_panic,
    [16 + PORT_IRQ_TIMER] = port_timer_isr,
    [16 + 20] = console_panic,
    [16 + PORT_IRQ_PEN] = port_pen_isr,
    [16 + 22 ... 16 + 43] = console_panic,
};
