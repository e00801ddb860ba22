/* meet.c - see meet.h. */
#include "path/meet.h"
#include "path/cluster.h"
#include "path/loop.h"

#if CONFIG_MANY_STROKES

#define FOUND 16 /* pairs of places that wait until their points have come from memory; a power of two */
#define AHEAD 6  /* places that are compared at a time, without asking whose cell they are of */

/* The ends in the places i and j have been paired: they are so in their places, too. */
static void link_meeting(places_t *p, uint32_t i, uint32_t j) {
    place_t *place = p->now.place;
    int32_t *mate = p->chain->pool->mate;
    p->strokes--;
    if (place[i].tip == (int32_t)j) { /* a closed stroke */
        places_mark(&p->now.spot[i]);
        places_mark(&p->now.spot[j]);
        p->loop[p->loops++] = (int32_t)i;
    } else {
        const int32_t a = place[place[i].tip].end, b = place[place[j].tip].end;
        places_link(&p->now, i, j);
        mate[a] = ~b; /* which may be about to be paired, too */
        mate[b] = ~a;
    }
    mate[place[i].end] = place[j].end;
    mate[place[j].end] = place[i].end;
}

/* In a crowd it may not be among the n places found. Returns how many there are with it. */
static int with(uint32_t *at, int n, uint32_t k) {
    for (int i = 0; i < n; i++) {
        if (at[i] == k) return n;
    }
    at[n] = k;
    return n + 1;
}

/* Pairs the ends in the places k and j, which meet, and whoever they meet. */
static __attribute__((noinline)) void pair_at(places_t *p, uint32_t k, uint32_t j) {
    uint32_t at[CHAIN_CLUSTER];
    int32_t end[CHAIN_CLUSTER], list[CHAIN_CLUSTER], mate[CHAIN_CLUSTER];
    int n = places_near(p, p->chain->point[p->now.place[k].end], at, CHAIN_CLUSTER - 2);
    n = with(at, with(at, n, k), j);
    for (int i = 0; i < n; i++) list[i] = end[i] = p->now.place[at[i]].end;
    cluster_pair(p->chain, list, n);
    for (int i = 0; i < n; i++) mate[i] = p->chain->pool->mate[end[i]];
    for (int i = 0; i < n; i++) {
        for (int m = i + 1; m < n; m++) {
            if (mate[i] == end[m]) link_meeting(p, at[i], at[m]);
        }
    }
}

/* Two places that may meet. Where exactly they are is elsewhere in memory: it is asked for now, and looked at when so
 * many others have been found. */
typedef struct found {
    uint32_t place[FOUND][2];
    uint32_t n;
} found_t;

static void look_at(places_t *p, const found_t *f, uint32_t i) {
    const uint32_t k = f->place[i % FOUND][0], j = f->place[i % FOUND][1];
    const place_t *list = p->now.place;
    const page_point_t *point = p->chain->point;
    const int32_t a = list[k].end, b = list[j].end;
    if (a >= p->pen || b >= p->pen || !chain_is_near(p->chain, point[a], point[b])) return;
    if (!places_is_marked(p->now.spot[k]) && !places_is_marked(p->now.spot[j])) pair_at(p, k, j);
}

static inline void note(places_t *p, found_t *f, uint32_t k, uint32_t j) {
    if (f->n >= FOUND) look_at(p, f, f->n);
    f->place[f->n % FOUND][0] = k;
    f->place[f->n++ % FOUND][1] = j;
    for (int i = 0; i < 2; i++) {
        const int32_t e = p->now.place[i ? j : k].end;
        __builtin_prefetch(&p->chain->point[e]);
        __builtin_prefetch(&p->chain->pool->run[e >> 1]);
        __builtin_prefetch(&p->chain->pool->mate[e]);
    }
}

/* How spots are compared: what is within `by` of one, in x and in y, is between that and a mask more. A borrow from x
 * makes y one less; by has room for that. */
typedef struct compare {
    uint32_t by, back, beyond;
    uint32_t wide, high; /* masks of what is within a cell */
    uint32_t cell;       /* bits that are the same in one cell */
} compare_t;

static compare_t make_compare(const places_t *p) {
    const uint32_t by = (uint32_t)(p->chain->near_lat >> p->fine) + PLACES_NEAR_MARGIN;
    const uint32_t wide = (1u << (p->cell_x - p->fine)) - 1, high = (1u << (p->cell_y - p->fine)) - 1;
    uint32_t within = 1;
    while (within < 2 * by) within = 2 * within + 1;
    return (compare_t){.by = by,
                       .back = PLACES_SPOT(by, by),
                       .beyond = PLACES_SPOT(PLACES_MASK & ~within, PLACES_MASK & ~within),
                       .wide = wide,
                       .high = high,
                       .cell = PLACES_SPOT(PLACES_MASK & ~wide, PLACES_MASK & ~high)};
}

static inline bool is_close(const compare_t *c, uint32_t from, uint32_t spot) {
    return ((spot - from) & c->beyond) == 0;
}

static inline void note_close(places_t *p, found_t *f, const compare_t *c, uint32_t k, uint32_t from, uint32_t to) {
    const uint32_t *spot = p->now.spot;
    if (to - from > PLACES_CROWD) to = from + PLACES_CROWD;
    for (uint32_t j = from; j < to; j++) {
        if (is_close(c, spot[k] - c->back, spot[j]) && !places_is_marked(spot[j])) note(p, f, k, j);
    }
}

/* Looks beyond the borders of the cell that the place k is in, where it is near them. */
static __attribute__((noinline)) void look_beyond(places_t *p, found_t *f, const compare_t *c, uint32_t k, bool right,
                                                  bool up) {
    const page_point_t at = p->chain->point[p->now.place[k].end];
    const uint32_t *cell = places_cell(p, at);
    const int32_t y = (at.y_lat - p->box.y0) >> p->cell_y, x = (at.x_lat - p->box.x0) >> p->cell_x;
    const bool more = x + 1 < p->nx;
    if (right && more) note_close(p, f, c, k, cell[1], cell[2]);
    if (up && y + 1 < p->ny) note_close(p, f, c, k, cell[p->nx - (x > 0)], cell[p->nx + 1 + more]);
}

/* In its cell an end is compared with those that come after it, so many at a time. */
static void pair_all(places_t *p) {
    const compare_t c = make_compare(p);
    const uint32_t n = (uint32_t)p->now.n;
    const uint32_t *spot = p->now.spot;
    found_t found = {.n = 0};
    for (uint32_t k = 0; k < n; k++) {
        const uint32_t s = spot[k], from = s - c.back;
        if (places_is_marked(s)) continue;
        uint32_t j = k + 1;
        do {
            bool meets = false;
            for (uint32_t i = 0; i < AHEAD; i++) meets |= is_close(&c, from, spot[j + i]);
            if (meets) note_close(p, &found, &c, k, j, j + AHEAD < n ? j + AHEAD : n);
            j += AHEAD;
        } while (((places_without_mark(spot[j]) ^ s) & c.cell) == 0 && j < k + PLACES_SCAN && j < n);
        const bool right = (s >> 1 & c.wide) + c.by > c.wide, up = (s >> 17 & c.high) + c.by > c.high;
        if (right | up) look_beyond(p, &found, &c, k, right, up);
    }
    for (uint32_t i = found.n < FOUND ? 0 : found.n - FOUND; i < found.n; i++) look_at(p, &found, i);
}

/* Opens the stroke that was closed between the place i and its tip. Where another is found that ends on it, they are
 * one, and its end is elsewhere in the same place. */
static void open_loop(places_t *p, uint32_t i) {
    place_list_t *list = &p->now;
    loop_joint_t joint;
    if (loop_open_at(p->chain, list->place[i].end, &joint)) {
        list->place[places_find(p, joint.other, joint.at)].end = joint.end;
    } else {
        places_unmark(&list->spot[i]);
        places_unmark(&list->spot[list->place[i].tip]);
        p->strokes++;
    }
}

void meet_pair(places_t *p) {
    pair_all(p);
    p->chain->places = p;
    for (int32_t k = 0; k < p->loops; k++) open_loop(p, (uint32_t)p->loop[k]);
}

#endif
