/* improve.c - tour_improve: local search on the circle of strokes. See tour.h.
 *
 * Every stroke's end a has a link, the pen-up travel to the end b that comes next. A better neighbour c of a (nearer
 * than b) suggests two changes:
 *
 *     2-opt:   a - b ... c - d    becomes   a - c ... b - d              (what is between is turned round)
 *     Or-opt:  a - b ... d - c..e - f    becomes   a - c..e - b ... d - f    (up to three strokes c..e move)
 *
 * Both are sequences of one primitive, the 2-opt exchange of two links, which is a reversal of the shorter side of the
 * circle. A journal of reversals makes a failed attempt undoable. */
#include "config.h"
#include "path/dist.h"
#include "path/tour.h"
#include <stddef.h>

#define SEGMENT_MAX 3     /* strokes moved by Or-opt */
#define REVERSAL_MAX 1000 /* longer reversals are not worth their cost; strokes in the shorter side */
#define STRETCH_MAX 8     /* strokes in each of the two stretches that a kick exchanges */
#define TODO_MAX 64       /* strokes to look at again after a kick */
#define JOURNAL_MAX 64
#define CROWD 2 /* items to a cell: so many that the cells around hold the neighbours worth trying */

typedef struct search {
    tour_t *t;
    int32_t *todo, (*journal)[2]; /* TODO_MAX, JOURNAL_MAX; after the first descent */
    int todos, journals;
    bool local; /* between kicks: use todo and the journal */
    uint32_t random;
} search_t;

static int32_t length(const spot_t *spot, int32_t a, int32_t b) {
    return (int32_t)dist_root(near_square(spot[a], spot[b]));
}

static int32_t gap(search_t *s, int32_t a, int32_t b) {
    s->t->budget--;
    return length(s->t->spot, a, b);
}

static int32_t after(const tour_t *t, int32_t place) {
    return place == t->n ? 0 : place + 1;
}
static int32_t before(const tour_t *t, int32_t place) {
    return place == 0 ? t->n : place - 1;
}

/* Is the item the end at which its stroke is left? */
static bool is_exit(const tour_t *t, int32_t item) {
    return t->order[t->place[item >> 1]] != item;
}

/* The item that the pen travels to (or from) at this one. */
static int32_t link_of(const tour_t *t, int32_t item) {
    int32_t p = t->place[item >> 1];
    return is_exit(t, item) ? t->order[after(t, p)] : t->order[before(t, p)] ^ 1;
}

/* Turns the places from..to (round the circle) back, or all the others, which is the same circle mirrored. */
static void reverse(search_t *s, int32_t from, int32_t to) {
    tour_t *t = s->t;
    int32_t all = t->n + 1, length = to - from;
    if (length < 0) length += all;
    length++;
    if (2 * length > all) {
        int32_t keep = from;
        from = after(t, to);
        to = before(t, keep);
        length = all - length;
    }
    t->budget -= length / 4;
    for (int32_t i = 0; i < (length + 1) / 2; i++) {
        int32_t x = t->order[from] ^ 1, y = t->order[to] ^ 1;
        t->order[from] = y;
        t->place[y >> 1] = from;
        t->order[to] = x;
        t->place[x >> 1] = to;
        from = after(t, from);
        to = before(t, to);
    }
}

/* 2-opt: the links a - b and c - d become a - c and b - d. a and c are both exits or both entries. */
static void exchange(search_t *s, int32_t a, int32_t b, int32_t c, int32_t d) {
    const int32_t *place = s->t->place;
    bool out = is_exit(s->t, a);
    int32_t from = place[(out ? b : a) >> 1], to = place[(out ? c : d) >> 1];
    if (s->local) {
        s->journal[s->journals][0] = from;
        s->journal[s->journals++][1] = to;
    }
    reverse(s, from, to);
}

/* A change found for the end a with link b: c is to be next to a. The segment that moves is c..e; e is -1 for 2-opt. */
typedef struct change {
    int32_t gain, a, b, c, d, e, f;
} change_t;

/* Would joining strokes at these places turn round more of the circle than it is worth? */
static bool is_far(const tour_t *t, int32_t p, int32_t q) {
    int32_t length = p - q;
    if (length < 0) length = -length;
    return length > REVERSAL_MAX && t->n + 1 - length > REVERSAL_MAX;
}

/* 2-opt. saved: the links a - b and c - d without a - c. What would make the gain smaller is computed only while it can
 * still be the best; returns how many distances that took. */
static inline int32_t try_two(const tour_t *t, change_t *best, int32_t c, int32_t d, int32_t gain) {
    if (gain <= best->gain) return 0;
    gain -= length(t->spot, best->b, d);
    if (gain > best->gain) *best = (change_t){gain, best->a, best->b, c, d, -1, -1};
    return 1;
}

/* Or-opt: the segment from c, in place p, away from its link d. leaves: c is the end at which its stroke is left. */
static inline int32_t try_segment(const tour_t *t, change_t *best, int32_t c, int32_t d, int32_t p, bool leaves,
                                  int32_t saved) {
    const int32_t a = best->a, b = best->b;
    int32_t took = 0;
    for (int32_t k = 0, start = c; k < SEGMENT_MAX; k++) {
        if (start >> 1 == a >> 1 || start >> 1 == b >> 1) break;
        p = leaves ? before(t, p) : after(t, p);
        const int32_t e = start ^ 1, f = leaves ? t->order[p] ^ 1 : t->order[p];
        int32_t gain = saved + length(t->spot, e, f);
        took++;
        if (gain > best->gain) gain -= length(t->spot, e, b), took++;
        if (gain > best->gain) gain -= length(t->spot, d, f), took++;
        if (gain > best->gain) *best = (change_t){gain, a, b, c, d, e, f};
        start = f;
    }
    return took;
}

/* Looks among the items of one cell for a neighbour c of a that is nearer than its link, and tries the changes it
 * suggests. */
static void find_in_cell(search_t *s, change_t *best, const near_cell_t *cell, int32_t ab) {
    const tour_t *t = s->t;
    const int32_t a = best->a, *item = &t->near.item[cell->start], place = t->place[a >> 1];
    const spot_t at = t->spot[a];
    const uint32_t limit = near_square(at, t->spot[best->b]);
    const bool out = t->order[place] != a;
    const int32_t count = cell->count < NEAR_CELL_SCAN ? (int32_t)cell->count : NEAR_CELL_SCAN;
    int32_t took = count / 4;
    for (int32_t i = 0; i < count; i++) {
        const int32_t c = item[i], p = t->place[c >> 1];
        const uint32_t square = near_square(at, t->spot[c]);
        if (square >= limit || c >> 1 == a >> 1 || is_far(t, place, p)) continue;
        const bool leaves = t->order[p] != c;
        const int32_t d = leaves ? t->order[after(t, p)] : t->order[before(t, p)] ^ 1;
        const int32_t saved = ab - (int32_t)dist_root(square) + length(t->spot, c, d);
        took += 2;
        if (out == leaves) took += try_two(t, best, c, d, saved);
        took += try_segment(t, best, c, d, p, leaves, saved);
    }
    s->t->budget -= took;
}

/* The best change for the end a. */
static change_t find(search_t *s, int32_t a) {
    const tour_t *t = s->t;
    const near_t *g = &t->near;
    int32_t b = link_of(t, a), ab = gap(s, a, b);
    change_t best = {0, a, b, -1, -1, -1, -1};
    int32_t x = t->spot[a].x, y = t->spot[a].y, cx = x >> g->shift_x, cy = y >> g->shift_y;
    int32_t x0 = (x - ab) >> g->shift_x, x1 = (x + ab) >> g->shift_x;
    int32_t y0 = (y - ab) >> g->shift_y, y1 = (y + ab) >> g->shift_y;
    if (ab == 0) return best;
    for (int32_t j = y0 < cy ? cy - 1 : cy; j <= (y1 > cy ? cy + 1 : cy); j++) {
        for (int32_t i = x0 < cx ? cx - 1 : cx; i <= (x1 > cx ? cx + 1 : cx); i++) {
            const near_cell_t *cell = near_cell_at(g, i, j);
            if (cell) find_in_cell(s, &best, cell, ab);
        }
    }
    return best;
}

static void wake(search_t *s, int32_t item) {
    int32_t k = item >> 1;
    if (!s->local) {
        s->t->end[k] &= ~TOUR_QUIET;
        return;
    }
    for (int i = 0; i < s->todos; i++) {
        if (s->todo[i] == k) return;
    }
    if (s->todos < TODO_MAX) s->todo[s->todos++] = k;
}

static void apply(search_t *s, const change_t *m) {
    if (m->e < 0) {
        exchange(s, m->a, m->b, m->c, m->d);
    } else if (is_exit(s->t, m->a) == is_exit(s->t, m->c)) {
        exchange(s, m->a, m->b, m->c, m->d);
        exchange(s, m->e, m->f, m->b, m->d);
    } else {
        exchange(s, m->a, m->b, m->e, m->f);
        exchange(s, m->a, m->e, m->c, m->d);
        exchange(s, m->e, m->d, m->b, m->f);
    }
    wake(s, m->a);
    wake(s, m->b);
    wake(s, m->c);
    wake(s, m->d);
    if (m->e >= 0) {
        wake(s, m->e);
        wake(s, m->f);
    }
}

/* Improves around stroke k until nothing there helps; returns the sum of gains. */
static int32_t settle(search_t *s, int32_t k) {
    int32_t sum = 0;
    for (int side = 0; side < 2 && s->t->budget > 0; side++) {
        if (s->local && s->journals > JOURNAL_MAX - 3) break;
        if (CONFIG_FED && s->t->tick) s->t->tick(s->t->tick_ctx);
        change_t m = find(s, 2 * k + side);
        if (m.gain <= 0) continue;
        apply(s, &m);
        sum += m.gain;
        side = -1;
    }
    return sum;
}

static void descend(search_t *s) {
    tour_t *t = s->t;
    int32_t quiet = 0;
    for (int32_t k = 0; k <= t->n; k++) t->end[k] &= ~TOUR_QUIET;
    for (int32_t p = 0; quiet <= t->n && t->budget > 0; p = after(t, p)) {
        int32_t k = t->order[p] >> 1;
        quiet++;
        if (t->end[k] & TOUR_QUIET) continue;
        if (settle(s, k) > 0) quiet = 0;
        t->end[k] |= TOUR_QUIET;
    }
}

static int32_t random_below(search_t *s, int32_t n) {
    s->random = s->random * 1664525u + 1013904223u;
    return (int32_t)(((s->random >> 16) * (uint64_t)n) >> 16);
}

/* Exchanges two neighbouring stretches of the circle; returns how much longer it gets. */
static int32_t kick(search_t *s) {
    tour_t *t = s->t;
    int32_t all = t->n + 1, most = all / 4 < STRETCH_MAX ? all / 4 : STRETCH_MAX;
    int32_t p = random_below(s, all), l1 = 1 + random_below(s, most), l2 = 1 + random_below(s, most);
    int32_t q = p, item[6];
    item[0] = t->order[p] ^ 1;
    item[1] = t->order[after(t, p)];
    for (int32_t i = 0; i < l1; i++) q = after(t, q);
    item[2] = t->order[q] ^ 1;
    item[3] = t->order[after(t, q)];
    for (int32_t i = 0; i < l2; i++) q = after(t, q);
    item[4] = t->order[q] ^ 1;
    item[5] = t->order[after(t, q)];
    s->todos = s->journals = 0;
    for (int i = 0; i < 6; i++) wake(s, item[i]);
    int32_t cost = gap(s, item[0], item[3]) + gap(s, item[4], item[1]) + gap(s, item[2], item[5]) -
                   gap(s, item[0], item[1]) - gap(s, item[2], item[3]) - gap(s, item[4], item[5]);
    exchange(s, item[0], item[1], item[4], item[5]); /* both stretches turned round and exchanged: turn each back */
    exchange(s, item[0], item[4], item[3], item[2]);
    exchange(s, item[4], item[2], item[1], item[5]);
    return cost;
}

static void undo(search_t *s) {
    while (s->journals > 0) {
        s->journals--;
        reverse(s, s->journal[s->journals][0], s->journal[s->journals][1]);
    }
}

#define KICKS_FROM 16 /* strokes: with fewer there is little to find, and a small core has no stack for it */

/* Kicks until the operations are used up. A function of its own: its arrays are not on the stack before. */
static __attribute__((noinline)) void kick_on(search_t *s) {
    int32_t todo[TODO_MAX], journal[JOURNAL_MAX][2];
    s->todo = todo;
    s->journal = journal;
    s->local = true;
    while (s->t->budget > 0) {
        int32_t cost = kick(s);
        while (s->todos > 0) cost -= settle(s, s->todo[--s->todos]);
        if (cost > 0) undo(s);
    }
    s->todo = NULL;
    s->journal = NULL;
}

void tour_improve(tour_t *t, int64_t operations) {
    search_t s = {.t = t, .random = 1};
    t->budget = operations;
    if (t->n < 2 || operations <= 0) return;
    for (int32_t k = 0; k <= t->n; k++) t->place[t->order[k] >> 1] = k;
    for (int32_t k = 0; k < t->n; k++) near_unmark(t->spot, k); /* tour_greedy has taken them all */
    near_build(&t->near, t->n + 1, CROWD);
    descend(&s);
    if (t->n >= KICKS_FROM) kick_on(&s);
}
