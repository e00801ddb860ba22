/* match.c - see match.h. */
#include "path/match.h"

#if CONFIG_MANY_STROKES

#define CROWD 1    /* ends to a cell: the search looks at the fewest */
#define CROWDED 16 /* times as many, where a grid has brought little together */

/* What does not change while all cells are gone through: in registers, as far as they go. */
typedef struct pass {
    const uint32_t *spot;
    const place_t *place;
    const uint32_t *start;
    int32_t nx, ny;
    uint32_t wide, high; /* masks of what is within a cell */
} pass_t;

/* The nearest end so far, by its place, and the square of twice its distance. */
typedef struct best {
    uint32_t square;
    uint32_t place;
} best_t;

/* What is within two cells is nearer, what is marked is not. */
#define NOBODY ((best_t){1u << 29, UINT32_MAX})

/* Looks at the places from..to. What is nearest so far is kept without a branch, which would be guessed wrong as often
 * as not. */
static inline __attribute__((always_inline)) best_t look(best_t best, const uint32_t *spot, uint32_t at, uint32_t not,
                                                         uint32_t from, uint32_t to) {
    if (to - from > PLACES_SCAN) to = from + PLACES_SCAN;
    for (uint32_t k = from; k < to; k++) {
        const uint32_t s = spot[k];
        const int32_t dx = (int16_t)(s - at), dy = (int16_t)((s >> 16) - (at >> 16));
        uint32_t d = (uint32_t)(dx * dx) + (uint32_t)(dy * dy);
        d = k == not ? NEAR_FAR : d;
        best.place = d < best.square ? k : best.place;
        best.square = d < best.square ? d : best.square;
    }
    return best;
}

static inline uint32_t square_of(uint32_t v) {
    return 4 * v * v;
}

/* Looks for a partner of the end in place k of the column x in what comes after it: in its own cell and in the next,
 * and, if they are nearer than what has been found, in three of the next row, where `up` is. */
static inline uint32_t partner(const pass_t *p, int32_t x, const uint32_t *own, const uint32_t *up, uint32_t k) {
    const uint32_t at = p->spot[k], not = (uint32_t)p->place[k].tip;
    const uint32_t in_x = at >> 1 & p->wide, in_y = at >> 17 & p->high;
    best_t best = look(NOBODY, p->spot, at, not, k + 1, own[1 + (x + 1 < p->nx)]);
    const uint32_t above = square_of(p->high + 1 - in_y);
    if (!up || above >= best.square) return best.place;
    const bool left = (x > 0) & (square_of(in_x + 1) + above < best.square);
    const bool right = (x + 1 < p->nx) & (square_of(p->wide + 1 - in_x) + above < best.square);
    return look(best, p->spot, at, not, up[x - left], up[x + 1 + right]).place;
}

static inline void link_places(const places_t *p, uint32_t i, uint32_t j) {
    const int32_t a = p->now.place[i].end, b = p->now.place[j].end;
    int32_t *mate = p->chain->pool->mate;
    places_link(&p->now, i, j);
    mate[a] = ~b;
    mate[b] = ~a;
}

/* Goes through all cells once. Returns how many links it has made. */
static __attribute__((noinline)) int32_t go_through(const places_t *p) {
    const pass_t pass = {p->now.spot,
                         p->now.place,
                         p->start,
                         p->nx,
                         p->ny,
                         (1u << (p->cell_x - p->fine)) - 1,
                         (1u << (p->cell_y - p->fine)) - 1};
    int32_t made = 0;
    for (int32_t y = 0; y < pass.ny; y++) {
        const uint32_t *row = pass.start + y * pass.nx, *up = y + 1 < pass.ny ? row + pass.nx : NULL;
        for (int32_t x = 0; x < pass.nx; x++) {
            for (uint32_t k = row[x]; k < row[x + 1]; k++) {
                if (places_is_marked(pass.spot[k])) continue;
                const uint32_t with = partner(&pass, x, row + x, up, k);
                if (with == NOBODY.place) continue;
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

/* The stroke entered at e has the place k in the order. Returns 1 if it is not plain, else 0. */
static inline int32_t put_stroke(const places_t *p, tour_t *t, int32_t k, int32_t e) {
    const bool ends = p->chain->pool->mate[pool_other_end(e)] < 0, plain = ends & (int)chain_is_plain(p->chain, e >> 1);
    t->order[k] = e | (plain ? TOUR_PLAIN : 0);
    return !plain;
}

bool match_order(places_t *p, tour_t *t) {
    if (p->strokes < MATCH_STROKES_MIN) return false;
    const int32_t *mate = p->chain->pool->mate;
    int32_t *order = (int32_t *)(void *)p->now.spot, *winding = order + p->strokes;
    link_all(p);
    *t = (tour_t){.n = p->strokes, .order = order, .winding = winding, .point = p->chain->point};
    /* From where the pen is and back from its home, in turn: the next of one is on its way from memory while the other
     * goes on. */
    int32_t from = p->pen + 1, to = p->pen, first = 0, last = t->n;
    for (int32_t k = 0, back = t->n - 1; k <= back; k++, back--) {
        const int32_t e = ~mate[from], f = ~mate[to];
        from = far_end(mate, e);
        to = far_end(mate, f);
        winding[first] = k;
        first += put_stroke(p, t, k, e);
        if (k == back) break;
        winding[last - 1] = back;
        last -= put_stroke(p, t, back, to);
    }
    while (last < t->n) winding[first++] = winding[last++];
    t->windings = first;
    return true;
}

#endif
