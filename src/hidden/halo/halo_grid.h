/* halo_grid.h - the grid in which CUT finds the pairs of edges that may cross; not for others.
 *
 * The page is overlaid with square cells about as large as the edges are (Franklin & Akman, step C2), and with coarser
 * grids of 2, 4, 8... times that size for the edges that are larger (their section 5). An edge has one home: in the
 * finest grid where its box spans at most two columns and two rows, the cell of its lower left corner. So
 * - edges can be sorted by home, and those of neighbouring cells of a row lie side by side in memory;
 * - two edges of one grid are a candidate pair only if their homes are neighbours: every edge looks at the rest of its
 * own cell and at four cells more, so each pair is found once and no crossing has to be computed to know it;
 * - an edge looks for those of finer grids in the cells along it, and they are at home in one of them only.
 *
 * Boxes are rounded outward to 15 bits, four to a word, and two of them compared by one subtraction. */
#ifndef HALO_GRID_H
#define HALO_GRID_H

#include "hidden/halo/halo.h"

#define HALO_LEVELS 13
#define HALO_GUARDS UINT64_C(0x8000800080008000) /* a bit above each field */

typedef struct halo_grid {
    uint32_t *start; /* first edge of a cell, in the order of cells; one more at the end */
    int32_t cells, levels;
    int32_t base[HALO_LEVELS + 1]; /* first cell of a grid */
    int32_t row[HALO_LEVELS + 1];  /* its first row, all grids' rows being numbered through */
    int32_t wide[HALO_LEVELS];     /* its columns */
    int shift;                     /* fine units of a cell of grid 0, as a power of two */
    int32_t pad;                   /* fine units by which boxes are larger than their edges */
    int32_t x0, y0;                /* fine = (x - x0) * mul / 2^mul_shift */
    uint32_t mul;
    int mul_shift;
} halo_grid_t;

/* Fields of a box, from bit 0 on: left, bottom, and the complements of right and top. */
static inline int32_t halo_left(uint64_t box) {
    return (int32_t)(box & 0x7fff);
}
static inline int32_t halo_bottom(uint64_t box) {
    return (int32_t)(box >> 16 & 0x7fff);
}
static inline int32_t halo_right(uint64_t box) {
    return (int32_t)(~box >> 32 & 0x7fff);
}
static inline int32_t halo_top(uint64_t box) {
    return (int32_t)(~box >> 48 & 0x7fff);
}
/* What to subtract other boxes from: where all guards stay, the boxes overlap. */
static inline uint64_t halo_probe(uint64_t box) {
    return ~(box << 32 | box >> 32) | HALO_GUARDS;
}

/* Sizes the grid for h's edges and sorts them. g->start is placed at mem. Returns the end of what is used of mem, or
 * NULL if the bytes do not suffice. h->box must have room. */
uint8_t *halo_grid_build(halo_grid_t *g, halo_t *h, uint8_t *mem, size_t bytes);

/* A coordinate in fine units. */
static inline int32_t halo_fine(const halo_grid_t *g, int32_t v, int32_t origin) {
    return (int32_t)((uint64_t)(uint32_t)(v - origin) * g->mul >> g->mul_shift);
}

#endif
