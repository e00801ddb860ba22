/* store.c - the last 8 KB of flash: 4 slots of 2 pages of 1 KB. The processor stands still while the flash is busy. */
#include "hal/port/store.h"

#include "hal/hal.h"
#include "hal/nrf51/regs.h"

#define PAGE 1024u
_Static_assert(HAL_STORE_SLOTS *HAL_STORE_BYTES == 8192, "what linker/nrf51.ld keeps free");

static void wait_ready(void) {
    while (!NVMC_READY) continue;
}

void port_store_write(uintptr_t to, const uint8_t *buf, size_t bytes) {
    NVMC_CONFIG = 2; /* erase */
    for (uint32_t page = 0; page < HAL_STORE_BYTES; page += PAGE) {
        NVMC_ERASEPAGE = to + page;
        wait_ready();
    }
    NVMC_CONFIG = 1; /* write */
    for (size_t i = 0; i < bytes; i += 4) {
        REG(to + i) = store_word(buf, bytes, i);
        wait_ready();
    }
    NVMC_CONFIG = 0;
}
