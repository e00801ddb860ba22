/* match.c - see match.h.
 *
 * Ends lie in memory as they do on the page ("places": row of cells by row, an end after the other), so that what is
 * near is looked at without going anywhere else. */
#include "path/match.h"
#include "path/near.h"
#include <stddef.h>

#define CROWD 1    /* ends to a cell: the search looks at the fewest */
#define CROWDED 16 /* times as many, where a grid has brought little together */

/* Which end is in a place, and the place of the other end of its stroke, or chain of strokes. */
typedef struct place {
    int32_t end, tip;
} place_t;

/* Where the ends are, marked when they have a link, lies together: that is what is looked through. */
typedef struct places {
    int32_t n;
    spot_t *spot;
    place_t *place;
} places_t;

typedef struct match {
    const chain_t *chain;
    near_extent_t box;
    spot_t last; /* the greatest x and y in the box */
    page_point_t at, home;
    places_t now, next; /* a round's, and where the next round's will be */
    uint32_t *start;    /* of every cell, in now; and two more */
    int32_t nx, ny;
    int shift_x, shift_y; /* a cell is 2^shift_x spots wide, and as high or twice as high */
} match_t;

static inline bool is_marked(spot_t s) {
    return s.x < 0;
}

/* Is the end e free, and the first of its stroke's? */
static inline bool is_first(const int32_t *mate, int32_t e) {
    return mate[e] < 0 && ~mate[e] > e;
}

/* How many strokes there are, and what they extend over. */
static int32_t measure(match_t *m) {
    const chain_t *c = m->chain;
    const int32_t *mate = c->pool->mate;
    near_extent_t box = {INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN, 0};
    int32_t strokes = 0;
    for (int32_t e = 0; e < 2 * c->pool->n; e++) {
        if (mate[e] >= 0) continue;
        near_include(&box, c->point[e]);
        strokes++;
    }
    strokes /= 2;
    if (strokes == 0) return 0;
    near_fit(&box);
    m->box = box;
    m->last = near_spot(&box, (page_point_t){box.x1, box.y1});
    return strokes;
}

static void take_places(places_t *p, int32_t **mem, int32_t n) {
    p->spot = (spot_t *)(void *)*mem;
    p->place = (place_t *)(void *)(*mem + n);
    *mem += 3 * (ptrdiff_t)n;
}

static bool lay_out(match_t *m, int32_t strokes) {
    const pool_t *pool = m->chain->pool;
    const int32_t ends = 2 * strokes + 2; /* the pen's is a stroke, too */
    const int64_t points = 4 * (int64_t)pool->n, words = points + 7 * (int64_t)ends + 3;
    if (words > ((int64_t)pool->cap + 1) * (POOL_WORK_PER_RUN / 4)) return false;
    int32_t *mem = (int32_t *)(void *)pool->work + points;
    take_places(&m->now, &mem, ends);
    m->start = (uint32_t *)(void *)mem;
    mem += ends + 3;
    take_places(&m->next, &mem, ends);
    return true;
}

static inline spot_t spot_of(const match_t *m, page_point_t p) {
    return near_spot(&m->box, p);
}
/* The pen may be elsewhere. */
static spot_t spot_nearest(const match_t *m, page_point_t p) {
    return (spot_t){(int16_t)near_clamp((p.x_lat - m->box.x0) >> m->box.shift, m->last.x),
                    (int16_t)near_clamp((p.y_lat - m->box.y0) >> m->box.shift, m->last.y)};
}

static inline uint32_t *start_of(const match_t *m, spot_t s) {
    return &m->start[(s.y >> m->shift_y) * m->nx + (s.x >> m->shift_x)];
}

/* Cells for so many ends, nothing in them. */
static void make_cells(match_t *m, int32_t ends, int32_t crowd) {
    near_size(ends / crowd, m->last.x, m->last.y, &m->shift_x, &m->shift_y);
    m->nx = (m->last.x >> m->shift_x) + 1;
    m->ny = (m->last.y >> m->shift_y) + 1;
    for (int32_t k = 0; k < m->nx * m->ny + 2; k++) m->start[k] = 0;
}

/* Where a cell's ends go is counted up in the start of the next; the counts that make it are one further yet. So when
 * all are sorted, every start is where it should be. */
static inline void count(match_t *m, spot_t a, spot_t b) {
    start_of(m, a)[2]++;
    start_of(m, b)[2]++;
}
static void add_up(match_t *m) {
    for (int32_t k = 2; k < m->nx * m->ny + 2; k++) m->start[k] += m->start[k - 1];
}
static inline void put(match_t *m, places_t *to, spot_t a, int32_t end_a, spot_t b, int32_t end_b) {
    const uint32_t i = start_of(m, a)[1]++, j = start_of(m, b)[1]++;
    to->spot[i] = a;
    to->spot[j] = b;
    to->place[i] = (place_t){end_a, (int32_t)j};
    to->place[j] = (place_t){end_b, (int32_t)i};
}

/* The pen's stroke has the ends that one more run would have: home, where it is entered, and where the pen is. */
static void enter_strokes(match_t *m, int32_t strokes) {
    const page_point_t *point = m->chain->point;
    const int32_t *mate = m->chain->pool->mate, ends = 2 * m->chain->pool->n;
    const spot_t home = spot_nearest(m, m->home), at = spot_nearest(m, m->at);
    make_cells(m, 2 * strokes + 2, CROWD);
    count(m, home, at);
    for (int32_t e = 0; e < ends; e++) {
        if (is_first(mate, e)) count(m, spot_of(m, point[e]), spot_of(m, point[~mate[e]]));
    }
    add_up(m);
    put(m, &m->now, home, ends, at, ends + 1);
    for (int32_t e = 0; e < ends; e++) {
        if (is_first(mate, e)) put(m, &m->now, spot_of(m, point[e]), e, spot_of(m, point[~mate[e]]), ~mate[e]);
    }
    m->now.n = 2 * strokes + 2;
}

/* Is there the first end of a chain of strokes in place k? */
static inline bool is_left(const places_t *p, int32_t k) {
    return !is_marked(p->spot[k]) && k < p->place[k].tip;
}

static void enter_left(match_t *m, int32_t chains, int32_t crowd) {
    const places_t from = m->now;
    places_t *to = &m->next;
    make_cells(m, 2 * chains, crowd);
    for (int32_t k = 0; k < from.n; k++) {
        if (is_left(&from, k)) count(m, from.spot[k], from.spot[from.place[k].tip]);
    }
    add_up(m);
    for (int32_t k = 0; k < from.n; k++) {
        const place_t *a = &from.place[k], *b = &from.place[a->tip];
        if (is_left(&from, k)) put(m, to, from.spot[k], a->end, from.spot[a->tip], b->end);
    }
    to->n = 2 * chains;
    m->now = *to;
    m->next = from;
}

/* The nearest end so far, by its place, and the square of its distance. */
typedef struct best {
    uint32_t square;
    uint32_t place;
} best_t;
#define NOWHERE UINT32_MAX

/* Looks at the places from..to. What is nearest so far is kept without a branch, which would be guessed wrong as often
 * as not. */
static inline __attribute__((always_inline)) void look(const spot_t *spot, spot_t at, uint32_t not, uint32_t from,
                                                       uint32_t to, best_t *best) {
    uint32_t square = best->square, place = best->place;
    if (to - from > NEAR_TAKE_SCAN) to = from + NEAR_TAKE_SCAN;
    for (uint32_t k = from; k < to; k++) {
        uint32_t d = near_square(spot[k], at) | (0u - (uint32_t)(spot[k].x < 0)); /* marked: as far as can be */
        d = k == not ? NEAR_FAR : d;
        place = d < square ? k : place;
        square = d < square ? d : square;
    }
    best->square = square;
    best->place = place;
}

static inline uint32_t square_of(int32_t v) {
    return (uint32_t)(v * v);
}

/* Looks for a partner of the end in place k of the cell (x, y) in what comes after it: in its own cell, in the next,
 * and in three of the next row; each only if it is nearer than what has been found. */
static inline uint32_t partner(const match_t *m, int32_t x, int32_t y, uint32_t k) {
    const uint32_t *own = &m->start[y * m->nx + x], *up = own + m->nx;
    const spot_t *spot = m->now.spot, at = spot[k];
    const uint32_t not = (uint32_t)m->now.place[k].tip;
    best_t best = {NEAR_FAR, NOWHERE};
    look(spot, at, not, k + 1, own[1], &best);
    const int32_t in_x = at.x - (x << m->shift_x), in_y = at.y - (y << m->shift_y);
    const uint32_t left = x > 0 ? square_of(in_x + 1) : NEAR_FAR;
    const uint32_t right = x + 1 < m->nx ? square_of((1 << m->shift_x) - in_x) : NEAR_FAR;
    const uint32_t above = y + 1 < m->ny ? square_of((1 << m->shift_y) - in_y) : NEAR_FAR;
    if (right < best.square) look(spot, at, not, own[1], own[2], &best);
    if (above < best.square) look(spot, at, not, up[0], up[1], &best);
    if (left + above < best.square) look(spot, at, not, up[-1], up[0], &best);
    if (right + above < best.square) look(spot, at, not, up[1], up[2], &best);
    return best.place;
}

static inline void link_places(const match_t *m, uint32_t i, uint32_t j) {
    const places_t *p = &m->now;
    const place_t a = p->place[i], b = p->place[j];
    p->place[a.tip].tip = b.tip;
    p->place[b.tip].tip = a.tip;
    m->chain->pool->mate[a.end] = ~b.end;
    m->chain->pool->mate[b.end] = ~a.end;
    near_mark_end(&p->spot[i]);
    near_mark_end(&p->spot[j]);
}

/* Goes through all cells once. Returns how many links it has made. */
static int32_t go_through(const match_t *m) {
    int32_t made = 0;
    for (int32_t y = 0; y < m->ny; y++) {
        for (int32_t x = 0; x < m->nx; x++) {
            const uint32_t *own = &m->start[y * m->nx + x];
            for (uint32_t k = own[0]; k < own[1]; k++) {
                if (is_marked(m->now.spot[k])) continue;
                const uint32_t with = partner(m, x, y, k);
                if (with == NOWHERE) continue;
                link_places(m, k, with);
                made++;
            }
        }
    }
    return made;
}

static void link_all(match_t *m, int32_t strokes) {
    int32_t chains = strokes + 1, crowd = CROWD;
    enter_strokes(m, strokes);
    for (;;) {
        const int32_t made = go_through(m);
        chains -= made;
        if (chains == 1) break;
        crowd = made > chains ? CROWD : crowd < 2 * chains / CROWDED ? crowd * CROWDED : 2 * chains;
        enter_left(m, chains, crowd);
    }
    int32_t last = 0;
    while (is_marked(m->now.spot[last])) last++;
    link_places(m, (uint32_t)last, (uint32_t)m->now.place[last].tip);
}

int32_t *match_order(const chain_t *c, page_point_t at, page_point_t home, int32_t *strokes) {
    match_t m = {.chain = c, .at = at, .home = home};
    const int32_t n = measure(&m), pen = 2 * c->pool->n;
    if (n < MATCH_STROKES_MIN || !lay_out(&m, n)) return NULL;
    int32_t *mate = c->pool->mate, *order = (int32_t *)(void *)m.now.spot;
    link_all(&m, n);
    int32_t from = pen + 1;
    for (int32_t k = 0; k < n; k++) {
        int32_t e = ~mate[from];
        order[k] = e;
        for (from = pool_other_end(e); mate[from] >= 0;) from = pool_other_end(mate[from]);
    }
    *strokes = n;
    return order;
}
