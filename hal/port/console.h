/* console.h - the queues between a UART's interrupt and hal.h's console, and the last words of a fault, for all ports.
 *
 * The port defines in its port.h:
 *     uint32_t port_uart_take(void)     the next byte received, with PORT_UART_LOST if others before it were lost,
 *                                       PORT_UART_DAMAGED if it is none; PORT_UART_NONE when there is no other
 *     bool port_uart_sent(void)         there is room for a byte to be sent
 *     void port_uart_send(uint8_t)
 *     void port_uart_sending(bool)      whether room interrupts
 *     void port_uart_put(uint8_t)       sends a byte without interrupts, after whatever was being sent
 *     void port_pen_up(void)            for a pen that does not follow its pin without interrupts; its pin is at rest
 */
#ifndef PORT_CONSOLE_H
#define PORT_CONSOLE_H

#include <stdbool.h>

/* The body of the UART's interrupt. */
void console_uart_isr(void);
/* For errors that come without a byte. In the interrupt. */
void console_lost(void);
/* Bytes wait to be read. */
bool console_waiting(void);
/* For all vectors that nothing is expected at: a fault with the exception's number. */
void console_panic(void);

#endif
