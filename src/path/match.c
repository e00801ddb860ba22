/* match.c - see match.h. */
#include "path/match.h"

#if CONFIG_MANY_STROKES

#define CROWD 1    /* ends to a cell: the search looks at the fewest */
#define CROWDED 16 /* times as many, where a grid has brought little together */

/* The nearest end so far, by its place, and the square of its distance. */
typedef struct best {
    uint32_t square;
    uint32_t place;
} best_t;
#define NOWHERE UINT32_MAX

/* The square of twice the distance, which is below two cells and a half. */
static inline uint32_t square_between(spot_t a, spot_t b) {
    const int32_t dx = (int16_t)((a.x - b.x) * 2), dy = (int16_t)((a.y - b.y) * 2);
    return (uint32_t)(dx * dx) + (uint32_t)(dy * dy);
}

/* Looks at the places from..to. What is nearest so far is kept without a branch, which would be guessed wrong as often
 * as not. */
static inline __attribute__((always_inline)) void look(const spot_t *spot, spot_t at, uint32_t not, uint32_t from,
                                                       uint32_t to, best_t *best) {
    uint32_t square = best->square, place = best->place;
    if (to - from > PLACES_SCAN) to = from + PLACES_SCAN;
    for (uint32_t k = from; k < to; k++) {
        uint32_t d = square_between(spot[k], at) | (0u - (uint32_t)(spot[k].x < 0)); /* marked: as far as can be */
        d = k == not ? NEAR_FAR : d;
        place = d < square ? k : place;
        square = d < square ? d : square;
    }
    best->square = square;
    best->place = place;
}

static inline uint32_t square_of(uint32_t v) {
    return 4 * v * v;
}

/* Looks for a partner of the end in place k of the cell (x, y) in what comes after it: in its own cell, in the next,
 * and in three of the next row; each only if it is nearer than what has been found. */
static inline uint32_t partner(const places_t *p, int32_t x, int32_t y, uint32_t k) {
    const uint32_t *own = &p->start[y * p->nx + x], *up = own + p->nx;
    const spot_t *spot = p->now.spot, at = spot[k];
    const uint32_t not = (uint32_t)p->now.place[k].tip;
    best_t best = {NEAR_FAR, NOWHERE};
    const uint32_t wide = 1u << (p->cell_x - p->fine), high = 1u << (p->cell_y - p->fine);
    const uint32_t in_x = (uint32_t)at.x & (wide - 1), in_y = (uint32_t)at.y & (high - 1);
    const uint32_t left = x > 0 ? square_of(in_x + 1) : NEAR_FAR;
    const uint32_t right = x + 1 < p->nx ? square_of(wide - in_x) : NEAR_FAR;
    const uint32_t above = y + 1 < p->ny ? square_of(high - in_y) : NEAR_FAR;
    look(spot, at, not, k + 1, own[1 + (x + 1 < p->nx)], &best);
    if (above >= best.square) return best.place;
    const int32_t from = left + above < best.square ? -1 : 0, to = right + above < best.square ? 2 : 1;
    look(spot, at, not, up[from], up[to], &best);
    return best.place;
}

static inline void link_places(const places_t *p, uint32_t i, uint32_t j) {
    const int32_t a = p->now.place[i].end, b = p->now.place[j].end;
    int32_t *mate = p->chain->pool->mate;
    places_link(&p->now, i, j);
    mate[a] = ~b;
    mate[b] = ~a;
}

/* Goes through all cells once. Returns how many links it has made. */
static int32_t go_through(const places_t *p) {
    int32_t made = 0;
    for (int32_t y = 0; y < p->ny; y++) {
        for (int32_t x = 0; x < p->nx; x++) {
            const uint32_t *own = &p->start[y * p->nx + x];
            for (uint32_t k = own[0]; k < own[1]; k++) {
                if (places_is_marked(p->now.spot[k])) continue;
                const uint32_t with = partner(p, x, y, k);
                if (with == NOWHERE) continue;
                link_places(p, k, with);
                made++;
            }
        }
    }
    return made;
}

static void link_all(places_t *p) {
    int32_t chains = p->strokes + 1, crowd = CROWD;
    for (;;) {
        const int32_t made = go_through(p);
        chains -= made;
        if (chains == 1) break;
        crowd = made > chains ? CROWD : crowd < 2 * chains / CROWDED ? crowd * CROWDED : 2 * chains;
        places_thin(p, chains, crowd);
    }
    int32_t last = 0;
    while (places_is_marked(p->now.spot[last])) last++;
    link_places(p, (uint32_t)last, (uint32_t)p->now.place[last].tip);
}

/* The other end of a stroke. */
static inline int32_t far_end(const int32_t *mate, int32_t e) {
    for (e = pool_other_end(e); mate[e] >= 0;) e = pool_other_end(mate[e]);
    return e;
}

static inline int32_t told(const places_t *p, int32_t e) {
    return chain_is_plain(p->chain, e >> 1) && p->chain->pool->mate[pool_other_end(e)] < 0 ? e | TOUR_PLAIN : e;
}

int32_t *match_order(places_t *p) {
    if (p->strokes < MATCH_STROKES_MIN) return NULL;
    int32_t *order = (int32_t *)(void *)p->now.spot;
    const int32_t *mate = p->chain->pool->mate;
    link_all(p);
    /* From where the pen is and back from its home, in turn: the next of one is on its way from memory while the other
     * goes on. */
    int32_t from = p->pen + 1, to = p->pen;
    for (int32_t k = 0, last = p->strokes - 1; k <= last; k++, last--) {
        const int32_t e = ~mate[from], f = ~mate[to];
        from = far_end(mate, e);
        to = far_end(mate, f);
        order[k] = told(p, e);
        if (k < last) order[last] = told(p, to);
    }
    return order;
}

#endif
