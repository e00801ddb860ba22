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

void census_fetch(const census_t *c, page_point_t p) {
    __builtin_prefetch(row_of(c, p.x_lat >> c->shift, p.y_lat >> c->shift));
}

void census_enter(census_t *c, page_point_t p) {
    int32_t x = p.x_lat >> c->shift, y = p.y_lat >> c->shift;
    uint32_t *row = row_of(c, x, y), one = somebody(x);
    *row |= one | (*row & one) << 1;
}

/* The same where the cells around lie in two tiles side by side. */
static bool is_alone_in(const census_t *c, int32_t x, int32_t y, const int32_t xs[2], const int32_t ys[2]) {
    if (*row_of(c, x, y) & somebody(x) << 1) return false;
    for (int32_t v = ys[0]; v <= ys[1]; v++) {
        for (int32_t u = xs[0]; u <= xs[1]; u++) {
            if ((u != x || v != y) && *row_of(c, u, v) & somebody(u)) return false;
        }
    }
    return true;
}

bool census_is_alone(const census_t *c, page_point_t p, int32_t near_lat) {
    const int32_t x = p.x_lat >> c->shift, y = p.y_lat >> c->shift;
    const int32_t xs[2] = {(p.x_lat - near_lat) >> c->shift, (p.x_lat + near_lat) >> c->shift};
    const int32_t ys[2] = {(p.y_lat - near_lat) >> c->shift, (p.y_lat + near_lat) >> c->shift};
    if (xs[0] >> TILE_BITS != xs[1] >> TILE_BITS) return is_alone_in(c, x, y, xs, ys);
    /* Two rows at most: which cells of them count is arithmetic, which would be guessed wrong as often as not. */
    const uint32_t cells = (2 * somebody(xs[1]) - somebody(xs[0])) & 0x55555555u, own = somebody(x);
    const int32_t beside = ys[0] + ys[1] - y;
    const uint32_t here = *row_of(c, x, y) & ((cells & ~own) | own << 1);
    const uint32_t there = *row_of(c, x, beside) & (beside == y ? 0 : cells);
    return (here | there) == 0;
}
