/* ring.h - bytes between an interrupt and the main loop: one writer, one reader, each index written by one of them, no
 * read-modify-write that an interrupt could tear. The bytes lie beside it: an array whose size is a power of two. */
#ifndef RING_H
#define RING_H

#include <stdbool.h>
#include <stdint.h>

typedef struct ring {
    volatile uint32_t head, tail;
} ring_t;

static inline bool ring_put(ring_t *r, volatile uint8_t *bytes, uint32_t size, uint8_t byte) {
    uint32_t head = r->head;
    if (head - r->tail == size) return false;
    bytes[head % size] = byte;
    r->head = head + 1;
    return true;
}

/* The next byte, or -1. */
static inline int ring_get(ring_t *r, const volatile uint8_t *bytes, uint32_t size) {
    uint32_t tail = r->tail;
    if (tail == r->head) return -1;
    uint8_t byte = bytes[tail % size];
    r->tail = tail + 1;
    return byte;
}

static inline bool ring_empty(const ring_t *r) {
    return r->head == r->tail;
}

#endif
