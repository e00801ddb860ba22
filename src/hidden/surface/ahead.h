/* ahead.h - which of the next facets of a row are hidden for sure, by what is remembered of the horizons (lowest.h).
 *
 * On a rough surface one facet in two is, which cannot be guessed: asked one by one, each answer is a branch that goes
 * wrong half the time. Here 64 are asked without a branch, and only the others have a turn. Horizons only rise, so what
 * was said of a facet still holds when its turn would come. For perimeter.c, where nothing else is done with facets. */
#ifndef SURFACE_AHEAD_H
#define SURFACE_AHEAD_H

#include "hidden/surface/corner.h"

#define AHEAD_FACETS 64
#define AHEAD (CONFIG_64BIT && CONFIG_LOWEST && CONFIG_WAITING == 0)

/* Is it worth asking: the last facet was not one of a surface that faces the eye? */
static inline bool ahead_is_wanted(const sweep_t *s) {
    const edges_t *e = &s->edges;
    const horizons_t *h = &e->horizons;
#if CONFIG_AREA
    if (s->shaded != NULL) return false;
#endif
    return AHEAD && (s->last == FACET_CUT || s->last == FACET_HIDDEN) && e->cover == COVER_HORIZONS &&
           e->chart.kind < CHART_AROUND && (!h->has_upper || h->lowest_upper.w != NULL) &&
           (!h->has_lower || h->lowest_lower.w != NULL);
}

/* Bit k: facet i + k, or i - k if the row goes to the left, has to be looked at. 0 < n <= AHEAD_FACETS. */
static inline uint64_t ahead_shown(const sweep_t *s, int32_t i, int32_t n, int far, bool rightward) {
    const horizons_t *h = &s->edges.horizons;
    const int by = rightward ? 1 : -1;
    const bool ascending = rightward != (far == 1);
    const pencil_t *lf = s->layer->line[far].at + (rightward ? i : i + 1),
                   *ln = s->layer->line[1 - far].at + (lf - s->layer->line[far].at);
    const lowest_t *upper = h->has_upper ? &h->lowest_upper : &h->lowest_lower;
    const lowest_t *lower = h->has_lower ? &h->lowest_lower : &h->lowest_upper;
    uint64_t shown = 0;
    pencil_t side = *lf;
    for (int32_t k = 0; k < n; k++) {
        lf += by;
        ln += by;
        const pencil_t f = *lf, other = *ln;
        const int32_t top = pencil_max(f.w, pencil_max(side.w, other.w));
        const int32_t bottom = -pencil_min(f.w, pencil_min(side.w, other.w));
        const uint32_t from = lowest_place(upper, (ascending ? side.a : other.a) - 1);
        const uint32_t to = lowest_place(upper, (ascending ? other.a : side.a) + 1);
        uint64_t bit = 1;
        if (to - from < LOWEST_LANES)
            bit = !lowest_hide_few(upper, lower, from, to, h->has_upper ? top : bottom, h->has_lower ? bottom : top);
        shown = shown >> 1 | bit << 63;
        side = f;
    }
    return shown >> (64 - n);
}

#endif
