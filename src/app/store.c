/* store.c - see store.h. */
#include "app/store.h"

#include <string.h>

#include "error.h"

#define MAGIC 0x474c4452u /* RDLG */
#define HEADER sizeof(store_record_t)

static uint32_t crc32(uint32_t crc, const void *data, size_t bytes) {
    const uint8_t *p = data;
    for (size_t i = 0; i < bytes; i++) {
        crc ^= p[i];
        for (int bit = 0; bit < 8; bit++) crc = (crc >> 1) ^ (0xedb88320u & (0u - (crc & 1)));
    }
    return crc;
}

static uint32_t crc_of(const store_record_t *r) {
    uint32_t crc = crc32(UINT32_MAX, &r->number, sizeof r->number);
    crc = crc32(crc, &r->bytes, sizeof r->bytes);
    return ~crc32(crc, r->text, r->bytes);
}

static int slot_of(enum store_kind kind, int turn) {
    return 2 * (int)kind + turn;
}

/* Reads a slot; false when it holds no record, or none that store_save could have written with this memory. */
static bool read_slot(int slot, store_record_t *r, size_t room) {
    if (room < HEADER || hal_store_read(slot, r, HEADER) != 0) return false;
    if (r->magic != MAGIC || r->bytes > STORE_TEXT_MAX || r->bytes > room - HEADER) return false;
    if (hal_store_read(slot, r, HEADER + r->bytes) != 0) return false;
    return r->crc == crc_of(r);
}

/* Which of the two slots holds the text: 0 or 1, or ERR_EMPTY. *loaded: its record is in r (it was looked at last). */
static int newest(enum store_kind kind, store_record_t *r, size_t room, uint32_t *number, bool *loaded) {
    int best = ERR_EMPTY;
    for (int turn = 0; turn < 2; turn++) {
        bool found = read_slot(slot_of(kind, turn), r, room);
        *loaded = false;
        if (!found || (best == 0 && (int32_t)(r->number - *number) < 0)) continue;
        best = turn;
        *number = r->number;
        *loaded = true;
    }
    return best;
}

int store_load(enum store_kind kind, store_record_t *r, size_t room) {
    uint32_t number = 0;
    bool loaded;
    int turn = newest(kind, r, room, &number, &loaded);
    if (turn < 0) return turn;
    if (!loaded && !read_slot(slot_of(kind, turn), r, room)) return ERR_EMPTY;
    if (r->bytes < room - HEADER) r->text[r->bytes] = '\0';
    return (int)r->bytes;
}

int store_save(enum store_kind kind, store_record_t *r, size_t bytes, size_t room) {
    size_t size = (HEADER + bytes + 3) / 4 * 4;
    if (bytes > STORE_TEXT_MAX || 2 * size > room) return ERR_FULL;
    store_record_t *other = (store_record_t *)(void *)((uint8_t *)r + size);
    uint32_t number = 0;
    bool loaded;
    int turn = newest(kind, other, room - size, &number, &loaded);
    if (turn >= 0) {
        if (!loaded && !read_slot(slot_of(kind, turn), other, room - size)) return ERR_FILE;
        if (other->bytes == bytes && memcmp(other->text, r->text, bytes) == 0) return 0;
    }
    r->magic = MAGIC;
    r->number = number + 1;
    r->bytes = (uint32_t)bytes;
    r->crc = crc_of(r);
    return hal_store_write(slot_of(kind, turn == 0), r, size);
}
