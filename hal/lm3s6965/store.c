/* store.c - the last 8 KB of flash: 4 slots of 2 pages of 1 KB. The processor stands still while the flash is busy. */
#include <string.h>

#include "error.h"
#include "hal/hal.h"
#include "hal/lm3s6965/regs.h"

#define START (0x40000u - HAL_STORE_SLOTS * HAL_STORE_BYTES)
#define PAGE 1024u
_Static_assert(HAL_STORE_SLOTS *HAL_STORE_BYTES == 8192, "what linker/lm3s6965.ld keeps free");
#define KEY 0xa4420000u

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

static void command(uint32_t address, uint32_t bit) {
    FLASH_FMA = address;
    FLASH_FMC = KEY | bit;
    while (FLASH_FMC & bit) continue;
}

int hal_store_write(int slot, const void *buf, size_t bytes) {
    if (!slot_ok(slot, bytes)) return ERR_FILE;
    uint32_t to = (uint32_t)slot_at(slot);
    SYSCTL_USECRL = 50 - 1; /* MHz, less one: what times the pulses */
    for (uint32_t page = 0; page < HAL_STORE_BYTES; page += PAGE) command(to + page, 2);
    for (size_t i = 0; i < bytes; i += 4) {
        uint32_t word = 0xffffffffu;
        memcpy(&word, (const uint8_t *)buf + i, bytes - i < 4 ? bytes - i : 4);
        FLASH_FMD = word;
        command(to + i, 1);
    }
    return memcmp(slot_at(slot), buf, bytes) == 0 ? 0 : ERR_FILE;
}
