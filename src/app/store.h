/* store.h - texts kept without power: the saved scene, the machine's settings.
 *
 * Each text has two slots of hal.h and is written to the one that does not hold it, as a record with a sequence number
 * and a checksum (CRC-32). So a write that loses its power at any moment leaves the old text, or, if all of it was
 * written, the new one; the record with a right checksum and the later number counts.
 *
 *     magic 4 | number 4 | bytes 4 | crc 4 of number, bytes, text | text        (words as the chip has them)
 *
 * Context: main loop, at rest (hal_store_write). */
#ifndef STORE_H
#define STORE_H

#include "hal/hal.h"
#include <stddef.h>
#include <stdint.h>

enum store_kind { STORE_SCENE, STORE_SETTINGS, STORE_KINDS };
_Static_assert(HAL_STORE_SLOTS >= 2 * STORE_KINDS, "two slots each");

typedef struct store_record {
    uint32_t magic, number, bytes, crc;
    char text[];
} store_record_t;

#define STORE_TEXT_MAX (HAL_STORE_BYTES - sizeof(store_record_t))

/* Reads the kept text into record (room bytes, aligned to 4, header included), and a zero behind it if there is room.
 * Returns its length, or ERR_EMPTY when there is none that fits. */
int store_load(enum store_kind kind, store_record_t *record, size_t room);
/* Keeps record->text of so many bytes, at most STORE_TEXT_MAX. The record lies at the start of room bytes, of which the
 * part behind it is used to look at the slots. Returns 0 (also without writing, when the same text is kept already),
 * ERR_FULL (text too long, or room for less than two records of this length), ERR_FILE (the memory failed; the old
 * text is still kept). */
int store_save(enum store_kind kind, store_record_t *record, size_t bytes, size_t room);

#endif
