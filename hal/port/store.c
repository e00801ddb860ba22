/* store.c - see store.h. */
#include "hal/port/store.h"

#include "error.h"
#include "hal/hal.h"
#include "port.h"

static bool slot_ok(int slot, size_t bytes) {
    return slot >= 0 && slot < HAL_STORE_SLOTS && bytes <= HAL_STORE_BYTES;
}

static uintptr_t slot_at(int slot) {
    return PORT_STORE_END - (uint32_t)(HAL_STORE_SLOTS - slot) * HAL_STORE_BYTES;
}

int hal_store_read(int slot, void *buf, size_t bytes) {
    if (!slot_ok(slot, bytes)) return ERR_FILE;
    memcpy(buf, (const void *)slot_at(slot), bytes);
    return 0;
}

int hal_store_write(int slot, const void *buf, size_t bytes) {
    if (!slot_ok(slot, bytes)) return ERR_FILE;
    port_store_write(slot_at(slot), buf, bytes);
    return memcmp((const void *)slot_at(slot), buf, bytes) == 0 ? 0 : ERR_FILE;
}
