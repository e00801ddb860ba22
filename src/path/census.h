/* census.h - which ends have nobody near, found out without looking for neighbours.
 *
 * Most runs of a rough surface end where something hides them, far from any other end; looking for neighbours that are
 * not there is what pairing would spend its time on. So the ends are counted first, none, one or more to a cell of the
 * page, two bits each. Cells are counted in tiles of 16 x 16, 64 bytes; tiles may share those bytes (a hash), so the
 * answer "not alone" may be wrong, "alone" never is. Cost: linear, some ten operations an end. */
#ifndef CENSUS_H
#define CENSUS_H

#include "view/page.h"
#include <stddef.h>

typedef struct census {
    uint32_t *word; /* 16 to a tile */
    uint32_t mask;  /* tiles - 1 */
    int shift;      /* cells are 2^shift lat wide */
} census_t;

#define CENSUS_BYTES_MIN 64

/* An empty census in mem (CENSUS_BYTES_MIN bytes or more; of them no more than are of use for so many ends). */
void census_init(census_t *c, uint32_t *mem, size_t bytes, int32_t ends, int shift);

#define CENSUS_TILE_BITS 4 /* a tile is 2^4 cells wide; a row of it, of which (x, y) is a cell, is a word */
#define CENSUS_TILE_WORDS 16

static inline uint32_t *census_row(const census_t *c, int32_t x, int32_t y) {
    uint32_t tile = (uint32_t)(x >> CENSUS_TILE_BITS) * 0x9E3779B1u ^ (uint32_t)(y >> CENSUS_TILE_BITS) * 0x85EBCA6Bu;
    return &c->word[((tile ^ tile >> 15) & c->mask) * CENSUS_TILE_WORDS + ((uint32_t)y & (CENSUS_TILE_WORDS - 1))];
}

static inline uint32_t census_somebody(int32_t x) {
    return 1u << 2 * ((uint32_t)x & 15);
}

static inline void census_enter(census_t *c, page_point_t p) {
    int32_t x = p.x_lat >> c->shift, y = p.y_lat >> c->shift;
    uint32_t *row = census_row(c, x, y), one = census_somebody(x);
    *row |= one | (*row & one) << 1;
}
/* Asks the cache for what the other two read. */
static inline void census_fetch(const census_t *c, page_point_t p) {
    __builtin_prefetch(census_row(c, p.x_lat >> c->shift, p.y_lat >> c->shift));
}
/* Is certainly no other end within near_lat of p, which has been entered itself? near_lat <= 2^(shift - 1). */
bool census_is_alone(const census_t *c, page_point_t p, int32_t near_lat);

#endif
