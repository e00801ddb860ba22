/* census.c - two bits a cell: bit 0 somebody, bit 1 more than one. See census.h. */
#include "path/census.h"

#define ENDS_PER_TILE 16

void census_init(census_t *c, uint32_t *mem, size_t bytes, int32_t ends, int shift) {
    *c = (census_t){mem, 0, shift};
    while ((2 * (size_t)c->mask + 2) * CENSUS_TILE_WORDS * 4 <= bytes && (int32_t)c->mask < ends / ENDS_PER_TILE)
        c->mask = 2 * c->mask + 1;
    for (size_t k = 0; k < ((size_t)c->mask + 1) * CENSUS_TILE_WORDS; k++) mem[k] = 0;
}

/* Where the cells around lie in two tiles side by side. */
static bool is_alone_between(const census_t *c, page_point_t p, int32_t near_lat) {
    const int32_t x = p.x_lat >> c->shift, y = p.y_lat >> c->shift;
    if (*census_row(c, x, y) & census_somebody(x) << 1) return false;
    for (int32_t v = (p.y_lat - near_lat) >> c->shift; v <= (p.y_lat + near_lat) >> c->shift; v++) {
        for (int32_t u = (p.x_lat - near_lat) >> c->shift; u <= (p.x_lat + near_lat) >> c->shift; u++) {
            if ((u != x || v != y) && *census_row(c, u, v) & census_somebody(u)) return false;
        }
    }
    return true;
}

bool census_is_alone(const census_t *c, page_point_t p, int32_t near_lat) {
    const int32_t x = p.x_lat >> c->shift, y = p.y_lat >> c->shift;
    const int32_t x0 = (p.x_lat - near_lat) >> c->shift, x1 = (p.x_lat + near_lat) >> c->shift;
    if ((x0 ^ x1) >> CENSUS_TILE_BITS != 0) return is_alone_between(c, p, near_lat);
    /* Two rows at most: which cells of them count is arithmetic, which would be guessed wrong as often as not. */
    const uint32_t cells = (2 * census_somebody(x1) - census_somebody(x0)) & 0x55555555u, own = census_somebody(x);
    const int32_t beside = ((p.y_lat - near_lat) >> c->shift) + ((p.y_lat + near_lat) >> c->shift) - y;
    const uint32_t here = *census_row(c, x, y) & ((cells & ~own) | own << 1);
    const uint32_t there = *census_row(c, x, beside) & (beside == y ? 0 : cells);
    return (here | there) == 0;
}
