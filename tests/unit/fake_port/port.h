/* port.h - what hal/port/console.c asks of a port, with the PL011 that two boards have. */
#ifndef PORT_H
#define PORT_H

#include "hal/hal.h"
#include "hal/port/pl011.h"

#define PORT_ALL_PINS 0x3fu
typedef uint32_t port_word_t;

static inline port_word_t port_word(uint32_t mask, uint32_t value) {
    return mask & value;
}
static inline void port_write(port_word_t word) {
    (void)word;
}
static inline void port_pen_up(void) {}

#endif
