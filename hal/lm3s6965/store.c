/* store.c - the last 8 KB of flash: 4 slots of 2 pages of 1 KB. The processor stands still while the flash is busy. */
#include "hal/port/store.h"

#include "hal/hal.h"
#include "hal/lm3s6965/regs.h"

#define PAGE 1024u
_Static_assert(HAL_STORE_SLOTS *HAL_STORE_BYTES == 8192, "what linker/lm3s6965.ld keeps free");
#define KEY 0xa4420000u

static void command(uint32_t address, uint32_t bit) {
    FLASH_FMA = address;
    FLASH_FMC = KEY | bit;
    while (FLASH_FMC & bit) continue;
}

void port_store_write(uintptr_t to, const uint8_t *buf, size_t bytes) {
    SYSCTL_USECRL = 50 - 1; /* MHz, less one: what times the pulses */
    for (uint32_t page = 0; page < HAL_STORE_BYTES; page += PAGE) command(to + page, 2);
    for (size_t i = 0; i < bytes; i += 4) {
        FLASH_FMD = store_word(buf, bytes, i);
        command(to + i, 1);
    }
}
