/* arena.h - hands out pieces of one lent block of memory; nothing is ever given back. */
#ifndef ARENA_H
#define ARENA_H

#include <stddef.h>
#include <stdint.h>

typedef struct arena {
    uint8_t *base;
    size_t bytes, used;
} arena_t;

static inline size_t arena_left(const arena_t *a) {
    return a->bytes - a->used;
}

/* 8 on a board, where memory begins at a multiple of it: what fits must not depend on where the linker put the block.
 */
#define ARENA_ALIGN (2 * sizeof(void *))

/* Bytes to the next address that is aligned. */
static inline size_t arena_gap(const arena_t *a) {
    return (size_t)(-(uintptr_t)(a->base + a->used) & (ARENA_ALIGN - 1));
}

/* size bytes, aligned, or NULL. */
static inline void *arena_take(arena_t *a, size_t size) {
    size_t start = a->used + arena_gap(a);
    if (start > a->bytes || size > a->bytes - start) return NULL;
    a->used = start + size;
    return a->base + start;
}

/* All that is left, aligned, or NULL; *bytes: how much that is. */
static inline void *arena_take_rest(arena_t *a, size_t *bytes) {
    const size_t left = arena_left(a);
    *bytes = left > 16 ? left - 16 : 0;
    return arena_take(a, *bytes);
}

#endif
