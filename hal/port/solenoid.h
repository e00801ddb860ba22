/* solenoid.h - a solenoid where no PWM of the chip is at the pen's pin: holding it with a part of the power.
 *
 *     pen     ___|~~~~~~~~~~~~~~~~~~~~~~~~~~|___     its bit of the pin word
 *     driven  ~~~~~~~~~~~~|_|~|__|~|__|~|__|~~~~     what this does
 *     pin     ___|~~~~~~~~|_|~|__|~|__|~|__|____     where it is not driven a resistor keeps it at rest
 *                 pull, ms  hold, 1 kHz
 *
 * So edges of the pen leave at their ticks, as those of a level, and whatever stops the machine lifts it. Holding is an
 * interrupt that comes twice a millisecond at most: less urgent than the player, more than the planner.
 *
 * The port defines in its port.h, for use in that interrupt:
 *     bool port_pen_is_down(void)          the pen's bit, as last written
 *     void port_pen_drive(bool on)         the pin is driven, or let go of */
#ifndef PORT_SOLENOID_H
#define PORT_SOLENOID_H

#include "hal/hal.h"

/* The pen is, or is not, one: true if its interrupt is wanted. */
bool solenoid_wire(const hal_wiring_t *wiring);
/* The body of the interrupt: us until it is wanted again. */
uint32_t solenoid_turn(void);

#endif
