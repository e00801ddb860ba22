/* corner.h - facets off the eye's row and column, decided as a whole: for perimeter.c and holes.c.
 *
 *           f          n is the near corner, f the far one, l and r the others from left to right.
 *         .' '.        If f takes the place of n in a horizon, both far edges are visible: six comparisons.
 *       l       r      If the highest of l, f, r is below the lowest of the horizon over them, both are hidden.
 *         '. .'        Only the rest is clipped edge by edge. */
#ifndef CORNER_H
#define CORNER_H

#include "hidden/surface/sweep.h"

static inline pencil_t mirror(pencil_t p) {
    return (pencil_t){p.a, -p.w};
}

/* A facet off the eye's row and column, by its corners: n is the near one, f the far one, l and r the others from left
 * to right. */
typedef struct corner {
    pencil_t n, l, r, f;
    bool ascending;
} corner_t;

static inline bool advance_upper(sweep_t *s, const corner_t *q) {
    horizons_t *h = &s->edges.horizons;
    return h->has_upper && envelope_advance(&h->upper, q->ascending, q->l, q->n, q->r, q->f, &h->count);
}

static inline bool advance_lower(sweep_t *s, const corner_t *q) {
    horizons_t *h = &s->edges.horizons;
    return h->has_lower &&
           envelope_advance(&h->lower, q->ascending, mirror(q->l), mirror(q->n), mirror(q->r), mirror(q->f), &h->count);
}

/* Sorts out what can be told of a whole facet: its far edges both visible, both hidden, or to be clipped. Neighbours
 * tend to be alike, so what the last facet was is tried first. */
static inline enum facet_kind corner_judge_here(sweep_t *s, const corner_t *q) {
    horizons_t *h = &s->edges.horizons;
    if (s->last == FACET_ABOVE && advance_upper(s, q)) return FACET_ABOVE;
    if (s->last == FACET_BELOW && advance_lower(s, q)) return FACET_BELOW;
    const int32_t top = pencil_max(q->f.w, pencil_max(q->l.w, q->r.w));
    const int32_t bottom = pencil_min(q->f.w, pencil_min(q->l.w, q->r.w));
    bool upper = !h->has_upper || lowest_hides(&h->lowest_upper, q->l.a, q->r.a, top);
    bool lower = !h->has_lower || lowest_hides(&h->lowest_lower, q->l.a, q->r.a, -bottom);
    if (upper & lower) return FACET_HIDDEN; /* one branch: either alone is hard to guess */
    upper = upper || horizons_see(&h->upper, &h->lowest_upper, q->l.a, q->r.a, top);
    lower = lower || horizons_see(&h->lower, &h->lowest_lower, q->l.a, q->r.a, -bottom);
    if (upper && lower) return FACET_HIDDEN;
    h->skip_upper = upper;
    h->skip_lower = lower;
    if (!upper && s->last != FACET_ABOVE && envelope_passes(&h->upper, q->l, q->n, q->r) && advance_upper(s, q))
        return FACET_ABOVE;
    if (!lower && s->last != FACET_BELOW && envelope_passes(&h->lower, mirror(q->l), mirror(q->n), mirror(q->r)) &&
        advance_lower(s, q))
        return FACET_BELOW;
    return FACET_CUT;
}

/* The same, where a call costs nothing: one copy. */
enum facet_kind corner_judge(sweep_t *s, const corner_t *q);

/* CHART_AROUND: is it in one sector and one zone? */
static inline bool corner_in_one_zone(const corner_t *q) {
    if (q->n.a == CHART_NONE || q->f.a == CHART_NONE) return false;
    const int32_t low = pencil_min(pencil_min(q->n.w, q->f.w), pencil_min(q->l.w, q->r.w));
    const int32_t high = pencil_max(pencil_max(q->n.w, q->f.w), pencil_max(q->l.w, q->r.w));
    return edges_is_straight(q->l, q->r) && chart_in_one_zone(low, high);
}

/* Are its edges lines of the chart? In a plan nothing is hidden. */
static inline bool corner_is_straight(const chart_t *c, const corner_t *q) {
    return c->kind < CHART_AROUND || (c->kind == CHART_AROUND && corner_in_one_zone(q));
}

static inline corner_t corner_of_facet(const layer_t *l, int32_t i, int far, bool rightward) {
    const pencil_t *lf = l->line[far].at, *ln = l->line[1 - far].at;
    const int32_t in = rightward ? i : i + 1, out = rightward ? i + 1 : i;
    const bool ascending = rightward != (far == 1);
    return (corner_t){.n = ln[in],
                      .l = ascending ? lf[in] : ln[out],
                      .r = ascending ? ln[out] : lf[in],
                      .f = lf[out],
                      .ascending = ascending};
}

#endif
