/* switches.c - see switches.h. */
#include "hal/port/switches.h"

#include "hal/hal.h"
#include "hal/port/cortex.h"
#include "port.h"

#define ALL_INPUTS 0x0fu
#define LIMITS (HAL_IN_LIMIT_X | HAL_IN_LIMIT_Y)
#define STOPPED_PINS (HAL_X_STEP | HAL_Y_STEP | HAL_PEN)

static struct {
    uint32_t invert; /* levels that are active low: all, unless told otherwise */
    uint32_t seen;
    volatile uint32_t trip;
} s = {.invert = ALL_INPUTS};

uint32_t hal_inputs(void) {
    return (port_inputs() ^ s.invert) & ALL_INPUTS;
}

void hal_wire(const hal_wiring_t *wiring) {
    uint32_t state = irq_lock();
    uint32_t value = port_pins() ^ port.invert;
    port.invert = PORT_INVERT ^ wiring->invert_pins;
    port_write(port_word(PORT_ALL_PINS, value));
    s.invert = ALL_INPUTS ^ wiring->invert_inputs;
    s.seen = hal_inputs(); /* what is closed now has not just closed */
    port_wire(wiring);
    irq_unlock(state);
}

void hal_trip(uint32_t limits) {
    s.trip = limits & LIMITS;
}

void switches_start(void) {
    s.seen = hal_inputs();
}

void switches_isr(void) {
    uint32_t inputs = hal_inputs(), risen = inputs & ~s.seen;
    if (risen & (s.trip | HAL_IN_ESTOP))
        port_write(port_word(STOPPED_PINS | (risen & HAL_IN_ESTOP ? HAL_ENABLE : 0u), 0));
    s.seen = inputs;
    if (risen & (LIMITS | HAL_IN_ESTOP)) console_input_isr(inputs);
}
