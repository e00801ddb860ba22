/* surface.h - what a surface is to the rest of the program: a grid of heights that can be asked for.
 *
 * A surface is never held as a whole. Its source is a compiled expression, a data file kept by the host, or
 * rows of inline data; each implements three calls. Points may be asked for in any order, and again.
 * Abscissae and ordinates strictly increase with the index: a source whose range runs backwards turns itself
 * round. Ownership: the source outlives the surface; nothing is freed. */
#ifndef SURFACE_H
#define SURFACE_H

#include "config.h"
#include "num/num.h"
#include <stddef.h>

typedef struct surface {
    int32_t nx;                                     /* columns, >= 2 */
    int32_t ny;                                     /* rows, >= 2 */
    void *ctx;                                      /* the source's own */
    num_t (*x_of)(void *ctx, int32_t i);            /* 0 <= i < nx, always defined */
    num_t (*y_of)(void *ctx, int32_t j);            /* 0 <= j < ny, always defined */
    num_t (*z_of)(void *ctx, int32_t i, int32_t j); /* undefined at a hole */
    /* Lends memory (aligned to 8) that makes z_of faster and changes no height; until it is called again, the last time
     * with NULL. Returns the bytes that it takes, 0 if it cannot use them. NULL: no memory helps. */
    size_t (*lend)(void *ctx, void *mem, size_t bytes);
#if CONFIG_ROW_POINTS > 1
    /* z_of for columns i to i + n - 1 into z, n <= CONFIG_ROW_POINTS. NULL: not sooner than one by one. */
    void (*z_row)(void *ctx, int32_t i, int32_t j, int32_t n, num_t *z);
#endif
} surface_t;

/* What a surface says of places off its grid, for profiles; the calls take its ctx. */
typedef struct surface_anywhere {
    num_t (*z_at)(void *ctx, num_t x, num_t y);
    size_t (*lend)(void *ctx, void *mem, size_t bytes); /* as the surface's, for z_at, and instead of it */
} surface_anywhere_t;

#endif
