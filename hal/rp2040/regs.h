/* regs.h - registers of the RP2040 that the port uses; names as in its data sheet. */
#ifndef REGS_H
#define REGS_H

#include "hal/port/cortex.h"

/* Aliases of most registers that set or clear the ones written. */
#define SET 0x2000u
#define CLR 0x3000u

#define XIP_SSI 0x18000000u
#define RESETS 0x4000c000u
#define CLOCKS 0x40008000u
#define XOSC 0x40024000u
#define PLL_SYS 0x40028000u
#define PLL_USB 0x4002c000u
#define WATCHDOG 0x40058000u
#define TIMER_RAWL REG(0x40054028u)
#define TIMER_ALARM0 REG(0x40054010u)
#define TIMER_ALARM1 REG(0x40054014u)
#define TIMER_ALARM2 REG(0x40054018u)
#define TIMER_INTR REG(0x40054034u)
#define TIMER_INTE REG(0x40054038u)
#define TIMER_INTF_SET REG(0x4005403cu + SET)
#define TIMER_INTF_CLR REG(0x4005403cu + CLR)
#define UART0 0x40034000u
#define PWM 0x40050000u
#define SIO 0xd0000000u
#define PIO0 0x50200000u
#define DMA 0x50000000u

#define GPIO_CTRL(pin) REG(0x40014004u + 8u * (pin))
#define GPIO_INTE(pin) REG(0x40014100u + 4u * ((pin) / 8)) /* core 0 */
#define GPIO_INTR(pin) REG(0x400140f0u + 4u * ((pin) / 8))
#define GPIO_EDGES(pin) (0xcu << 4 * ((pin) % 8))
#define GPIO_PAD(pin) REG(0x4001c004u + 4u * (pin))
#define FUNC_UART 2u
#define FUNC_PWM 4u
#define FUNC_SIO 5u
#define FUNC_PIO0 6u
#define OUT_INVERTED (1u << 8) /* at the pad */
#define PAD_OUT 0x56u          /* 4 mA, input enabled */
#define PAD_PULLUP 0x5au       /* input with pull-up, Schmitt trigger */

#define SIO_IN REG(SIO + 0x04u)
#define SIO_OUT REG(SIO + 0x10u)
#define SIO_OUT_XOR REG(SIO + 0x1cu)
#define SIO_OE_SET REG(SIO + 0x24u)

#define PWM_CSR(slice) REG(PWM + 0x14u * (slice))
#define PWM_DIV(slice) REG(PWM + 0x14u * (slice) + 0x04u)
#define PWM_CTR(slice) REG(PWM + 0x14u * (slice) + 0x08u)
#define PWM_CC(slice) REG(PWM + 0x14u * (slice) + 0x0cu) /* channel A in the lower half */
#define PWM_TOP(slice) REG(PWM + 0x14u * (slice) + 0x10u)

#define PIO_CTRL (PIO0 + 0x00u)
#define PIO_TXF(sm) REG(PIO0 + 0x10u + 4u * (sm))
#define PIO_PADOUT REG(PIO0 + 0x3cu)
#define PIO_INSTR_MEM(i) REG(PIO0 + 0x48u + 4u * (i))
#define PIO_CLKDIV(sm) REG(PIO0 + 0xc8u + 0x18u * (sm))
#define PIO_EXECCTRL(sm) REG(PIO0 + 0xccu + 0x18u * (sm))
#define PIO_SHIFTCTRL(sm) REG(PIO0 + 0xd0u + 0x18u * (sm))
#define PIO_INSTR(sm) REG(PIO0 + 0xd8u + 0x18u * (sm))
#define PIO_PINCTRL(sm) REG(PIO0 + 0xdcu + 0x18u * (sm))

#define DMA_READ_ADDR REG(DMA + 0x00u) /* channel 0 */
#define DMA_WRITE_ADDR REG(DMA + 0x04u)
#define DMA_TRANS_COUNT REG(DMA + 0x08u)
#define DMA_CTRL REG(DMA + 0x10u)             /* does not start it */
#define DMA_TRANS_COUNT_TRIG REG(DMA + 0x1cu) /* does */
#define DMA_INTE0 REG(DMA + 0x404u)
#define DMA_INTS0 REG(DMA + 0x40cu)
#define DMA_ABORT REG(DMA + 0x444u)
#define DMA_BUSY (1u << 24)

#endif
