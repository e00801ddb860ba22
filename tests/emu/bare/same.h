/* same.h - seeded scenes through the kernels, and a hash of all that they say: one line a scene, the same on every
 * machine.
 *
 *     same_X FIRST COUNT     scenes FIRST .. FIRST + COUNT - 1: number and hash
 *     same_X SEED            that scene, told: what it is made of, and its ink
 *     same_X SEED cut DROP   the same two without those parts of it whose bits are set: for making a scene small
 *
 * A program has one same_scene(); same_main.c is the rest. */
#ifndef SAME_H
#define SAME_H

#include "hidden/hidden.h"
#include "num/num.h"

typedef struct same {
    uint64_t hash;
    bool telling;
    uint32_t drop; /* parts to be left out: rows and columns, or objects */
} same_t;

/* Enters a number; when telling prints it, too, and what comes after it (may be NULL: not printed). */
void same_enter(same_t *s, int64_t v, const char *after);
/* An ink sink's function for a same_t: enters every piece. */
int same_ink(void *ctx, const ink_piece_t *p);
void same_num(const same_t *s, num_t v);
/* Makes the scene of this seed, draws it, and enters what comes of it. */
void same_scene(uint64_t seed, same_t *s);

#endif
