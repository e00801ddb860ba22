/* store.h - hal.h's store for all ports: slots in a row at the end of a flash that is read like memory.
 *
 * The port defines in its port.h:
 *     PORT_STORE_END    address behind the last slot, as it is read */
#ifndef PORT_STORE_H
#define PORT_STORE_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

/* The port's: erases the slot that begins at address `to` and writes buf there. What comes of it is read back. */
void port_store_write(uintptr_t to, const uint8_t *buf, size_t bytes);

/* The word at buf + i, filled up with what erased flash reads as. */
static inline uint32_t store_word(const uint8_t *buf, size_t bytes, size_t i) {
    uint32_t word = 0xffffffffu;
    memcpy(&word, buf + i, bytes - i < 4 ? bytes - i : 4);
    return word;
}

#endif
