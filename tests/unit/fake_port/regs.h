/* regs.h - registers of a UART that exists in test_uart.c only. */
#ifndef REGS_H
#define REGS_H

#include <stdint.h>

uint32_t *fake_register(uint32_t address);
#define REG(address) (*fake_register(address))
#define UART0 0u

#endif
