/* switches.h - limits, emergency stop and start button, and the wiring's polarity, for all ports.
 *
 * The port defines in its port.h:
 *     uint32_t port_inputs(void)    levels, in the order of enum hal_input
 *     uint32_t port_pins(void)      levels of the pins now, in the order of enum hal_pin
 *     PORT_INVERT                   pins that are active low on this board
 *     PORT_ALL_PINS
 *     void port_wire(const hal_wiring_t *)    the polarity is known and the pins are right: drives all of them from now
 *                                             on, the pen's in the way that is asked for
 */
#ifndef PORT_SWITCHES_H
#define PORT_SWITCHES_H

/* Once, when the inputs are set up. */
void switches_start(void);
/* To be called when a level has changed, or may have: at the timer's priority, in PendSV, or with interrupts off. The
 * pins are made safe before anything else. */
void switches_isr(void);

#endif
