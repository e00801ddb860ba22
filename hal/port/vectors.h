/* vectors.h - the head of a Cortex-M's vector table, which is alike everywhere. */
#ifndef PORT_VECTORS_H
#define PORT_VECTORS_H

#include "firmware/start.h"
#include "hal/port/ahead.h"
#include "hal/port/console.h"

#define VECTOR_TABLE __attribute__((section(".vectors"), used)) static void (*const vectors[])(void)

/* clang-format off */
#define VECTORS_HEAD(pendsv, systick) \
    [0] = (void (*)(void))(void *)_stack_top, \
    [1] = start_reset, \
    [2 ... 6] = console_panic, /* NMI and the faults */ \
    [11] = console_panic, \
    [12] = console_panic, \
    [14] = (pendsv), \
    [15] = (systick)
/* clang-format on */

#endif
