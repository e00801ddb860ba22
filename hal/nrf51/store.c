/* store.c - the last 8 KB of flash: 4 slots of 2 pages of 1 KB. The processor stands still while the flash is busy. */
#include <string.h>

#include "error.h"
#include "hal/hal.h"
#include "port.h"

#define START (0x40000u - HAL_STORE_SLOTS * HAL_STORE_BYTES)
#define PAGE 1024u

static bool slot_ok(int slot, size_t bytes) {
    return slot >= 0 && slot < HAL_STORE_SLOTS && bytes <= HAL_STORE_BYTES;
}

static const uint8_t *slot_at(int slot) {
    return (const uint8_t *)(START + (uint32_t)slot * HAL_STORE_BYTES);
}

int hal_store_read(int slot, void *buf, size_t bytes) {
    if (!slot_ok(slot, bytes)) return ERR_FILE;
    memcpy(buf, slot_at(slot), bytes);
    return 0;
}

static void wait_ready(void) {
    while (!NVMC_READY) continue;
}

int hal_store_write(int slot, const void *buf, size_t bytes) {
    if (!slot_ok(slot, bytes)) return ERR_FILE;
    uint32_t to = (uint32_t)slot_at(slot);
    NVMC_CONFIG = 2; /* erase */
    for (uint32_t page = 0; page < HAL_STORE_BYTES; page += PAGE) {
        NVMC_ERASEPAGE = to + page;
        wait_ready();
    }
    NVMC_CONFIG = 1; /* write */
    for (size_t i = 0; i < bytes; i += 4) {
        uint32_t word = 0xffffffffu;
        memcpy(&word, (const uint8_t *)buf + i, bytes - i < 4 ? bytes - i : 4);
        REG(to + i) = word;
        wait_ready();
    }
    NVMC_CONFIG = 0;
    return memcmp(slot_at(slot), buf, bytes) == 0 ? 0 : ERR_FILE;
}
