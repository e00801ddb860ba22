/* census.c - two bits a cell: bit 0 somebody, bit 1 more than one. See census.h. */
#include "path/census.h"

#define TILE_BITS 4 /* a tile is 2^4 cells wide */
#define TILE_WORDS 16
#define ENDS_PER_TILE 16

void census_init(census_t *c, uint32_t *mem, size_t bytes, int32_t ends, int shift) {
    *c = (census_t){mem, 0, shift};
    while ((2 * (size_t)c->mask + 2) * TILE_WORDS * 4 <= bytes && (int32_t)c->mask < ends / ENDS_PER_TILE)
        c->mask = 2 * c->mask + 1;
    for (size_t k = 0; k < ((size_t)c->mask + 1) * TILE_WORDS; k++) mem[k] = 0;
}

/* A row of 16 cells, of which (x, y) is one, is a word. */
static uint32_t *row_of(const census_t *c, int32_t x, int32_t y) {
    uint32_t tile = (uint32_t)(x >> TILE_BITS) * 0x9E3779B1u ^ (uint32_t)(y >> TILE_BITS) * 0x85EBCA6Bu;
    return &c->word[((tile ^ tile >> 15) & c->mask) * TILE_WORDS + ((uint32_t)y & (TILE_WORDS - 1))];
}

static uint32_t somebody(int32_t x) {
    return 1u << 2 * ((uint32_t)x & 15);
}

void census_enter(census_t *c, page_point_t p) {
    int32_t x = p.x_lat >> c->shift, y = p.y_lat >> c->shift;
    uint32_t *row = row_of(c, x, y), one = somebody(x);
    *row |= one | (*row & one) << 1;
}

bool census_is_alone(const census_t *c, page_point_t p, int32_t near_lat) {
    int32_t x = p.x_lat >> c->shift, y = p.y_lat >> c->shift;
    if (*row_of(c, x, y) & somebody(x) << 1) return false;
    int32_t x0 = (p.x_lat - near_lat) >> c->shift, x1 = (p.x_lat + near_lat) >> c->shift;
    int32_t y0 = (p.y_lat - near_lat) >> c->shift, y1 = (p.y_lat + near_lat) >> c->shift;
    if (x0 == x1 && y0 == y1) return true;
    for (int32_t v = y0; v <= y1; v++) {
        for (int32_t u = x0; u <= x1; u++) {
            if ((u != x || v != y) && *row_of(c, u, v) & somebody(u)) return false;
        }
    }
    return true;
}
