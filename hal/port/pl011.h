/* pl011.h - ARM's PrimeCell UART (PL011), which the LM3S6965 and the RP2040 both have: its registers, and what
 * console.h asks of a port. regs.h tells where it is (UART0) and what a register is (REG). Without its FIFO: an
 * interrupt for every byte. */
#ifndef PL011_H
#define PL011_H

#include <stdbool.h>
#include <stdint.h>

#include "regs.h" /* of the board */

#define UART_DR REG(UART0 + 0x00u)
#define UART_RSR REG(UART0 + 0x04u)
#define UART_FR REG(UART0 + 0x18u)
#define UART_IBRD REG(UART0 + 0x24u)
#define UART_FBRD REG(UART0 + 0x28u)
#define UART_LCRH REG(UART0 + 0x2cu)
#define UART_CR REG(UART0 + 0x30u)
#define UART_IMSC REG(UART0 + 0x38u)
#define UART_ICR REG(UART0 + 0x44u)

#define PORT_UART_NONE UINT32_MAX
#define PORT_UART_LOST 0x800u /* as in DR */
#define PORT_UART_DAMAGED 0x700u
#define UART_RX (1u << 4) /* in IMSC */
#define UART_TX (1u << 5)

static inline uint32_t port_uart_take(void) {
    if (UART_FR & 1u << 4) return PORT_UART_NONE;
    uint32_t data = UART_DR;
    if (data & 0xf00u) UART_RSR = 0;
    return data;
}

static inline bool port_uart_sent(void) {
    return !(UART_FR & 1u << 5);
}

static inline void port_uart_send(uint8_t byte) {
    UART_DR = byte;
}

static inline void port_uart_put(uint8_t byte) {
    while (!port_uart_sent()) continue;
    port_uart_send(byte);
}

static inline void port_uart_sending(bool on) {
    UART_IMSC = UART_RX | (on ? UART_TX : 0);
}

#endif
