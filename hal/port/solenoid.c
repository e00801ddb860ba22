/* solenoid.c - see solenoid.h. */
#include "hal/port/solenoid.h"

#include "port.h"

#ifdef PORT_SOFT_PEN
#define PERIOD_US 1000u

static struct {
    uint16_t pull, pulled; /* ms */
    uint16_t hold_us;      /* of each ms */
    bool holding;          /* its part of the ms is under way */
} s;

bool solenoid_wire(const hal_wiring_t *w) {
    s.pull = w->pull_ms;
    s.hold_us = (uint16_t)(w->hold_percent * (PERIOD_US / 100));
    s.pulled = s.holding = 0;
    port_pen_drive(true);
    return w->pen == HAL_PEN_SOLENOID;
}

uint32_t solenoid_turn(void) {
    if (s.holding) {
        s.holding = false;
        port_pen_drive(false);
        return PERIOD_US - s.hold_us;
    }
    port_pen_drive(true);
    if (!port_pen_is_down())
        s.pulled = 0;
    else if (s.pulled < s.pull)
        s.pulled++;
    else if (s.hold_us < PERIOD_US) {
        s.holding = true;
        return s.hold_us;
    }
    return PERIOD_US;
}
#endif
