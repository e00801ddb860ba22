/* regs.h - registers of the LM3S6965 that the port uses; names as in its data sheet. */
#ifndef REGS_H
#define REGS_H

#include "hal/port/cortex.h"

#define SYSCTL_RIS REG(0x400fe050u)
#define SYSCTL_RCC REG(0x400fe060u)
#define SYSCTL_RCGC0 REG(0x400fe100u)
#define SYSCTL_RCGC1 REG(0x400fe104u)
#define SYSCTL_RCGC2 REG(0x400fe108u)
#define SYSCTL_USECRL REG(0x400fe140u)

#define GPIOA 0x40004000u
#define GPIOB 0x40005000u
#define GPIOE 0x40024000u
#define GPIO_DATA(port, mask) REG((port) + ((uint32_t)(mask) << 2)) /* touches the bits of mask only */
#define GPIO_DIR(port) REG((port) + 0x400u)
#define GPIO_IBE(port) REG((port) + 0x408u)
#define GPIO_IM(port) REG((port) + 0x410u)
#define GPIO_ICR(port) REG((port) + 0x41cu)
#define GPIO_AFSEL(port) REG((port) + 0x420u)
#define GPIO_PUR(port) REG((port) + 0x510u)
#define GPIO_PDR(port) REG((port) + 0x514u)
#define GPIO_DEN(port) REG((port) + 0x51cu)

#define UART0 0x4000c000u

#define TIMER0_CFG REG(0x40030000u)
#define TIMER0_TAMR REG(0x40030004u)
#define TIMER0_CTL REG(0x4003000cu)
#define TIMER0_IMR REG(0x40030018u)
#define TIMER0_ICR REG(0x40030024u)
#define TIMER0_TAILR REG(0x40030028u)

#define TIMER1_TAMR REG(0x40031004u)
#define TIMER1_CTL REG(0x4003100cu)
#define TIMER1_IMR REG(0x40031018u)
#define TIMER1_ICR REG(0x40031024u)
#define TIMER1_TAILR REG(0x40031028u)

#define WDT_LOAD REG(0x40000000u)
#define WDT_CTL REG(0x40000008u)
#define WDT_ICR REG(0x4000000cu)
#define WDT_LOCK REG(0x40000c00u)

#define FLASH_FMA REG(0x400fd000u)
#define FLASH_FMD REG(0x400fd004u)
#define FLASH_FMC REG(0x400fd008u)

#endif
