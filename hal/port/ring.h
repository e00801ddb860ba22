/* ring.h - bytes between an interrupt and the main loop: one writer, one reader, each index written by one of them, no
 * read-modify-write that an interrupt could tear. */
#ifndef RING_H
#define RING_H

#include <stdbool.h>
#include <stdint.h>

#define RING_BYTES 128 /* a power of two */

typedef struct ring {
    volatile uint32_t head, tail;
    volatile uint8_t byte[RING_BYTES];
} ring_t;

static inline bool ring_put(ring_t *r, uint8_t byte) {
    uint32_t head = r->head;
    if (head - r->tail == RING_BYTES) return false;
    r->byte[head % RING_BYTES] = byte;
    r->head = head + 1;
    return true;
}

/* The next byte, or -1. */
static inline int ring_get(ring_t *r) {
    uint32_t tail = r->tail;
    if (tail == r->head) return -1;
    uint8_t byte = r->byte[tail % RING_BYTES];
    r->tail = tail + 1;
    return byte;
}

static inline bool ring_empty(const ring_t *r) {
    return r->head == r->tail;
}

#endif
