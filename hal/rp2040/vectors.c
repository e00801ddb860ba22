/* vectors.c - the vector table of the RP2040. */
#include "hal/port/vectors.h"
#include "port.h"

VECTOR_TABLE = {
    VECTORS_HEAD(ahead_plan_isr, console_panic),
    [16 + PORT_IRQ_WAKE] = port_wake_isr,
    [16 + PORT_IRQ_TIMER] = port_timer_isr,
    [16 + PORT_IRQ_PEN] = port_pen_isr,
    [16 + 3 ... 16 + 10] = console_panic,
    [16 + PORT_IRQ_DMA] = player_dma_isr,
    [16 + 12] = console_panic,
    [16 + PORT_IRQ_SWITCHES] = port_switches_isr,
    [16 + 14 ... 16 + 19] = console_panic,
    [16 + PORT_IRQ_UART] = console_uart_isr,
    [16 + 21 ... 16 + 31] = console_panic,
};
