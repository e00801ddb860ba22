/* clip_sweep.c - one sweep from left to right: splits edges where they meet, counts windings, links the borders.
 *
 * Everything the sweep decides is exact as long as no crossing is found. When one is, it is rounded and the edges are
 * split; the rest of that sweep may then be slightly out of order, which costs nothing but another sweep: the last one
 * finds no crossing, and all that counts is taken from it. */
#include "poly/clip_inner.h"

#include "num/ints.h"
#include <string.h>

/* > 0: v is above e. */
static int64_t side(const clip_seg_t *e, poly_point_t v) {
    return poly_orient(e->l, e->r, v);
}

/* ---- the heap of second parts, by left ends ---- */

static void wait_for(clip_t *c, const clip_seg_t *s) {
    if (c->waiting == c->most_waiting) {
        c->full = true;
        return;
    }
    int32_t k = c->waiting++;
    for (; k > 0 && poly_before(s->l, c->heap[(k - 1) / 2].l); k = (k - 1) / 2) c->heap[k] = c->heap[(k - 1) / 2];
    c->heap[k] = *s;
}

static clip_seg_t take_waiting(clip_t *c) {
    clip_seg_t first = c->heap[0], last = c->heap[--c->waiting];
    int32_t k = 0;
    for (int32_t child = 1; child < c->waiting; child = 2 * k + 1) {
        if (child + 1 < c->waiting && poly_before(c->heap[child + 1].l, c->heap[child].l)) child++;
        if (!poly_before(c->heap[child].l, last.l)) break;
        c->heap[k] = c->heap[child];
        k = child;
    }
    c->heap[k] = last;
    return first;
}

/* ---- the graph's edges ---- */

static void add_edge(clip_t *c, const clip_seg_t *s) {
    /* in[in_from..] is still to be read, and the two grow towards each other. */
    if ((void *)(c->edge + c->edges + 1) > (void *)(c->in + c->in_from)) {
        c->full = true;
        return;
    }
    clip_edge_t *e = &c->edge[c->edges++];
    e->s = *s;
    e->under = -1;
    e->next[0] = e->next[1] = CLIP_NO_EDGE;
}

/* Collects the edges that start at v. Is v a crossing that this sweep has rounded? */
static bool gather(clip_t *c, poly_point_t v) {
    bool rounded = false;
    while (c->in_from < c->in_to && poly_same(c->in[c->in_from].l, v)) {
        clip_seg_t s = c->in[c->in_from++];
        if (!poly_same(s.l, s.r)) add_edge(c, &s);
    }
    while (c->waiting && poly_same(c->heap[0].l, v)) {
        clip_seg_t s = take_waiting(c);
        if (poly_same(s.l, s.r))
            rounded = true;
        else
            add_edge(c, &s);
    }
    return rounded;
}

/* Two edges from one point in one direction: they become one up to the nearer end; the rest of the longer waits. */
static void merge(clip_t *c, clip_seg_t *into, const clip_seg_t *from) {
    if (!poly_same(into->r, from->r)) {
        bool further = poly_before(into->r, from->r);
        clip_seg_t rest = further ? *from : *into;
        rest.l = further ? into->r : from->r;
        wait_for(c, &rest);
        into->r = rest.l;
    }
    into->w[0] = (int16_t)(into->w[0] + from->w[0]);
    into->w[1] = (int16_t)(into->w[1] + from->w[1]);
    if (into->tag < 0) into->tag = from->tag;
}

/* Sorts the edges from edge[first] on, which start in one point, from below; merges those that coincide and drops what
 * then bounds nothing. */
static void sort_starts(clip_t *c, int32_t first) {
    int32_t n = first + 1;
    bool nothing = false;
    if (c->edges - first < 2) return;
    for (int32_t k = n; k < c->edges; k++) {
        int32_t j = n;
        int64_t turn = poly_orient(c->edge[k].s.l, c->edge[j - 1].s.r, c->edge[k].s.r);
        if (turn > 0 && n == k) { /* in order as they came */
            n++;
            continue;
        }
        const clip_edge_t e = c->edge[k];
        while (turn < 0 && --j > first) turn = poly_orient(e.s.l, c->edge[j - 1].s.r, e.s.r);
        if (j > first && turn == 0) {
            clip_seg_t *into = &c->edge[j - 1].s;
            merge(c, into, &e.s);
            nothing |= !into->w[0] && !into->w[1];
            continue;
        }
        for (int32_t i = n++; i > j; i--) c->edge[i] = c->edge[i - 1];
        c->edge[j] = e;
    }
    c->edges = nothing ? first : n;
    for (int32_t k = first; nothing && k < n; k++)
        if (c->edge[k].s.w[0] || c->edge[k].s.w[1]) c->edge[c->edges++] = c->edge[k];
}

/* ---- crossings ---- */

/* Do a and b, neighbours with a below, cross further on? One orientation where their order is right so far. */
static bool do_cross(const clip_seg_t *a, const clip_seg_t *b) {
    if (poly_same(a->r, b->r) || !poly_before(a->l, b->r) || !poly_before(b->l, a->r)) return false;
    if (poly_before(a->r, b->r) ? side(b, a->r) <= 0 : side(a, b->r) >= 0) return false;
    /* In a sweep that has rounded already the order may be wrong where they begin. */
    return poly_before(a->l, b->l) ? side(a, b->l) >= 0 : side(b, a->l) <= 0;
}

static clip_seg_t mark(poly_point_t at) {
    return (clip_seg_t){.l = at, .r = at};
}

/* Splits the edge in status place j at p; v is where the sweep is. What is ahead of the sweep waits; of what is behind,
 * the part that reaches beyond v stays in the status and the other is only kept for the next sweep. p is in the box of
 * the edge, but a steep edge that falls may have its rounded crossing before its left end or after its right end. */
static void split(clip_t *c, int32_t j, poly_point_t p, poly_point_t v) {
    clip_seg_t *s = &c->edge[c->status[j]].s, first = *s, second = *s;
    if (poly_same(p, s->l) || poly_same(p, s->r)) return;
    first.r = second.l = p;
    first = clip_upright(first);
    second = clip_upright(second);
    const clip_seg_t marks[2] = {mark(p), mark(s->l)};
    bool ahead = poly_before(v, p);
    *s = ahead ? first : second;
    if (ahead) {
        wait_for(c, &second);
        wait_for(c, &marks[0]);
    } else {
        add_edge(c, &first);
        for (int k = 0; k < 2; k++) add_edge(c, &marks[k]);
        c->unsorted = true;
    }
}

/* The same for neighbours of a sweep that has not rounded anything: both have begun and none has ended. */
static bool do_cross_ahead(const clip_seg_t *a, const clip_seg_t *b) {
    if (poly_same(a->r, b->r)) return false;
    return poly_before(a->r, b->r) ? side(b, a->r) > 0 : side(a, b->r) < 0;
}

/* The edges in places j and j + 1 of the status seem to cross. */
static void cross(clip_t *c, int32_t j, poly_point_t v) {
    const clip_seg_t *a = &c->edge[c->status[j]].s, *b = &c->edge[c->status[j + 1]].s;
    if (c->full || (c->rounded && !do_cross(a, b))) return;
    poly_point_t p = clip_crossing(a, b);
    bool ahead = poly_before(v, p);
    c->rounded = true;
    c->stats.crossings++;
    split(c, j, p, v);
    split(c, j + 1, p, v);
    if (ahead || c->full) return;
    int32_t swap = c->status[j];
    c->status[j] = c->status[j + 1];
    c->status[j + 1] = swap;
}

/* Looks for a crossing of the edges in places j and j + 1 of the status; v is where the sweep is. */
static inline void meet(clip_t *c, int32_t j, poly_point_t v) {
    if (j < 0 || j + 1 >= c->active) return;
    const clip_seg_t *a = &c->edge[c->status[j]].s, *b = &c->edge[c->status[j + 1]].s;
    if (c->rounded || do_cross_ahead(a, b)) cross(c, j, v);
}

/* ---- the status ---- */

/* Is v near an edge that has begun? */
static bool is_near(const clip_seg_t *s, poly_point_t v) {
    return poly_before(s->l, v) && clip_is_near(s, v);
}

static bool ends_or_holds(const clip_seg_t *s, poly_point_t v) {
    return poly_same(s->r, v) || side(s, v) == 0;
}

/* The places [*from, *to) of the edges that v lies on or ends; when snapping, also those near it. */
static void find(clip_t *c, poly_point_t v, bool snap, int32_t *from, int32_t *to) {
    int32_t lo = 0, hi;
    for (int32_t left = c->active; left > 0;) { /* without a branch to guess wrong */
        int32_t half = left / 2;
        bool above = side(&c->edge[c->status[lo + half]].s, v) > 0;
        lo = above ? lo + half + 1 : lo;
        left = above ? left - half - 1 : half;
    }
    hi = lo;
    while (hi < c->active && ends_or_holds(&c->edge[c->status[hi]].s, v)) hi++;
    while (lo > 0 && poly_same(c->edge[c->status[lo - 1]].s.r, v)) lo--;
    if (snap) {
        for (; hi < c->active && is_near(&c->edge[c->status[hi]].s, v); hi++) c->rounded = true;
        for (; lo > 0 && is_near(&c->edge[c->status[lo - 1]].s, v); lo--) c->rounded = true;
    }
    *from = lo;
    *to = hi;
}

/* Edges in places [lo, hi) that go on beyond v are split there, exactly. */
static void split_passing(clip_t *c, poly_point_t v, int32_t lo, int32_t hi) {
    for (int32_t j = lo; j < hi && !c->full; j++) {
        clip_seg_t *s = &c->edge[c->status[j]].s;
        if (!poly_before(v, s->r)) continue;
        clip_seg_t rest = *s;
        s->r = rest.l = v;
        add_edge(c, &rest);
    }
}

/* Draws all other edges near v to it: nearly vertical ones may be anywhere in the status. */
static void snap_all(clip_t *c, poly_point_t v, int32_t lo, int32_t hi) {
    for (int32_t j = 0; j < c->active && !c->full; j++) {
        if ((j >= lo && j < hi) || !is_near(&c->edge[c->status[j]].s, v)) continue;
        c->rounded = true;
        split(c, j, v, v);
    }
}

static void replace(clip_t *c, int32_t lo, int32_t hi, int32_t first) {
    int32_t starts = c->edges - first;
    if (c->active - (hi - lo) + starts > c->most_active) {
        c->full = true;
        return;
    }
    if (starts != hi - lo)
        memmove(c->status + lo + starts, c->status + hi, (size_t)(c->active - hi) * sizeof c->status[0]);
    for (int32_t k = 0; k < starts; k++) c->status[lo + k] = first + k;
    c->active += starts - (hi - lo);
}

/* ---- faces and borders ---- */

static void count_windings(clip_t *c, int32_t lo, int32_t hi, int32_t first) {
    int16_t w[2] = {0, 0};
    if (lo > 0) memcpy(w, c->edge[c->status[lo - 1]].above, sizeof w);
    if (first == c->edges) return;
    c->edge[first].under = lo < hi ? c->status[lo] : lo > 0 ? c->status[lo - 1] : -1;
    for (int32_t k = first; k < c->edges; k++) {
        clip_edge_t *e = &c->edge[k];
        e->above[0] = w[0] = (int16_t)(w[0] + e->s.w[0]);
        e->above[1] = w[1] = (int16_t)(w[1] + e->s.w[1]);
        if (k > first) e->under = k - 1;
    }
}

/* Links the borders of result k at a vertex: counter-clockwise around it, first the edges to the right from below, then
 * those to the left from above. A border has the result on its left: one that leaves is followed, around the vertex,
 * by a piece of the result, one that arrives by none. The border that arrives goes on with the one that left before it,
 * round the same piece. */
static void link(clip_t *c, int k, int32_t lo, int32_t hi, int32_t first) {
    int32_t out = CLIP_NO_EDGE, lone = CLIP_NO_EDGE, starts = c->edges - first, all = starts + hi - lo;
    for (int32_t i = 0; i < all; i++) {
        int32_t number = i < starts ? first + i : c->status[hi - 1 - (i - starts)];
        clip_edge_t *e = &c->edge[number];
        bool above = clip_is_in_above(c, k, e);
        if (above == (c->result[k] >> clip_bit_below(c, e) & 1)) continue;
        if (above == (i < starts)) {
            out = number;
        } else if (out != CLIP_NO_EDGE) {
            e->next[k] = out;
            out = CLIP_NO_EDGE;
        } else {
            lone = number;
        }
    }
    if (lone != CLIP_NO_EDGE) c->edge[lone].next[k] = out;
}

/* The commonest vertex by far, where one edge goes on as another: the same faces, the same contours. */
static void pass_on(clip_t *c, int32_t from, int32_t to) {
    clip_edge_t *a = &c->edge[from], *b = &c->edge[to];
    memcpy(b->above, a->above, sizeof b->above);
    b->under = from;
    const unsigned bit_above = clip_bit(c, a->above), bit_below = clip_bit_below(c, a);
    for (int k = 0; k < 2; k++) {
        const unsigned table = (unsigned)c->result[k], above = table >> bit_above & 1;
        if (above == (table >> bit_below & 1)) continue;
        if (above)
            a->next[k] = to;
        else
            b->next[k] = from;
    }
}

/* Faces and borders at a vertex where the edges in places [lo, hi) end and those from edge[first] on start. Without
 * meaning once something was rounded: then another sweep comes. */
static void settle(clip_t *c, int32_t lo, int32_t hi, int32_t first) {
    if (c->rounded) return;
    count_windings(c, lo, hi, first);
    for (int k = 0; k < 2; k++)
        if (c->result[k] != CLIP_NOTHING) link(c, k, lo, hi, first);
}

/* Does one edge end here, in place lo, and another of the same borders begin, and that is all? */
static bool goes_on(const clip_t *c, poly_point_t v, int32_t lo, int32_t hi, int32_t first) {
    if (hi - lo != 1 || c->edges - first != 1 || c->snap || c->full) return false;
    const clip_seg_t *from = &c->edge[c->status[lo]].s, *to = &c->edge[first].s;
    return from->w[0] == to->w[0] && from->w[1] == to->w[1] && poly_same(from->r, v);
}

static void visit(clip_t *c, poly_point_t v) {
    int32_t first = c->edges, lo, hi;
    bool rounded = gather(c, v);
    find(c, v, rounded, &lo, &hi);
    if (goes_on(c, v, lo, hi, first)) {
        if (!c->rounded) pass_on(c, c->status[lo], first);
        c->status[lo] = first;
        meet(c, lo - 1, v);
        meet(c, lo, v);
        return;
    }
    split_passing(c, v, lo, hi);
    if (c->full) return;
    sort_starts(c, first);
    settle(c, lo, hi, first);
    int32_t starts = c->edges - first;
    replace(c, lo, hi, first);
    if (c->snap) snap_all(c, v, lo, lo + starts);
    /* An end that nothing starts from must be met again by the next sweep. */
    const clip_seg_t end = mark(v);
    if (!starts) add_edge(c, &end);
    if (c->full) return;
    meet(c, lo - 1, v);
    if (starts) meet(c, lo + starts - 1, v);
}

void clip_sweep(clip_t *c) {
    c->edges = c->waiting = c->active = 0;
    c->rounded = c->unsorted = c->full = false;
    while (!c->full && (c->in_from < c->in_to || c->waiting)) {
        bool heap = c->waiting && (c->in_from == c->in_to || poly_before(c->heap[0].l, c->in[c->in_from].l));
        visit(c, heap ? c->heap[0].l : c->in[c->in_from].l);
    }
    if (c->edges > c->stats.most_edges) c->stats.most_edges = c->edges;
}
