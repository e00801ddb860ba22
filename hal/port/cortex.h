/* cortex.h - what all Cortex-M chips have in common. */
#ifndef CORTEX_H
#define CORTEX_H

#include <stdint.h>

#define REG(address) (*(volatile uint32_t *)(address))

#define SYST_CSR REG(0xe000e010u)
#define SYST_RVR REG(0xe000e014u)
#define SYST_CVR REG(0xe000e018u)
#define ICSR REG(0xe000ed04u)
#define SHPR3 REG(0xe000ed20u)
#define VTOR REG(0xe000ed08u)
#define AIRCR REG(0xe000ed0cu)

static inline void irq_enable(unsigned n) {
    REG(0xe000e100u + 4 * (n / 32)) = 1u << n % 32;
}
static inline void irq_pend(unsigned n) {
    REG(0xe000e200u + 4 * (n / 32)) = 1u << n % 32;
}
/* level 0 is the most urgent, 3 the least: what a Cortex-M0 has. Word access, which is all it allows. */
static inline void irq_priority(unsigned n, uint32_t level) {
    uint32_t shift = 8 * (n % 4);
    volatile uint32_t *r = &REG(0xe000e400u + n / 4 * 4);
    *r = (*r & ~(0xffu << shift)) | level << (shift + 6);
}

/* PendSV and SysTick: the system's own exceptions that have a level. */
static inline void pendsv_priority(uint32_t level) {
    SHPR3 = (SHPR3 & ~0xff0000u) | level << 22;
}
static inline void systick_priority(uint32_t level) {
    SHPR3 = (SHPR3 & ~0xff000000u) | level << 30;
}
static inline void pendsv_pend(void) {
    ICSR = 1u << 28;
}

/* Number of the exception being served: 14 is PendSV. */
static inline uint32_t exception(void) {
    uint32_t n;
    __asm volatile("mrs %0, ipsr" : "=r"(n));
    return n & 0x1ff;
}

static inline uint32_t irq_lock(void) {
    uint32_t state;
    __asm volatile("mrs %0, primask\n cpsid i" : "=r"(state)::"memory");
    return state;
}
static inline void irq_unlock(uint32_t state) {
    __asm volatile("msr primask, %0" ::"r"(state) : "memory");
}

#endif
