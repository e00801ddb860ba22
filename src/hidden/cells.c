/* cells.c - see cells.h. */
#include "hidden/cells.h"

#include "hidden/sides.h"

/* Where edges of two layers coincide the later one's facet is taken that much lower and less high: the first one's edge
 * is drawn, neither none nor both. */
#define COINCIDING (2 * ENVELOPE_NOISE + 1)

/* Clips a side in a vertical plane through the eye: of the other layers' facets in the cell only the edges in the same
 * plane count. */
static int clip_vertical(sweep_t *s, layer_t *l, int32_t i, int side) {
    edges_t *e = &s->edges;
    bands_t *filter = e->filter;
    e->filter = NULL;
    e->shade = s->shade;
    for (int32_t k = 0; k < s->layers; k++) {
        const layer_t *o = &s->layer[k];
        if (o != l && o->present) e->shades += side_shade(s, l, o, i, side, e->shade + e->shades);
    }
    int err = side_clip(s, l, i, side);
    e->shades = 0;
    e->filter = filter;
    return err;
}

/* Clips those edges of a layer's facet that are new and near (or not near). */
static int clip_edges(sweep_t *s, layer_t *l, int32_t i, near_edges_t near, bool are_near) {
    int err = 0;
    side_take_layer(s, l);
    for (int side = 0; side < SIDES && err == 0; side++) {
        uint8_t *done = side_done(l, i, side);
        if (*done || side_faces_eye(near, i, side) != are_near) continue;
        *done = 1;
        err =
            s->layers > 1 && side_is_vertical(s, l, i, side) ? clip_vertical(s, l, i, side) : side_clip(s, l, i, side);
    }
    return err;
}

/* Is a layer's facet behind what the cells before it cover? Then its edges are done, and it covers nothing new. */
static bool is_hidden(sweep_t *s, layer_t *l, int32_t i) {
    const bands_line_t *o = l->outline;
    if (l->lines == 0) return false;
    pencil_t least = o->p, most = o->q;
    for (int32_t k = 0; k < l->lines; k++, o++) {
        const int32_t low = pencil_min(o->p.w, o->q.w), high = pencil_max(o->p.w, o->q.w);
        least = (pencil_t){pencil_min(least.a, o->p.a), k == 0 ? low : pencil_min(least.w, low)};
        most = (pencil_t){pencil_max(most.a, o->q.a), k == 0 ? high : pencil_max(most.w, high)};
    }
    if (!bands_hide(&s->edges.bands, least.a, most.a, least.w, most.w)) return false;
    for (int side = 0; side < SIDES; side++) {
        s->edges.clipped += !*side_done(l, i, side);
        *side_done(l, i, side) = 1;
    }
    return true;
}

/* Have two layers' facets an edge in common? */
static bool coincide(const sweep_t *s, const layer_t *l, const layer_t *m, int32_t i) {
    for (int side = 0; side < SIDES; side++) {
        if (side_coincides(s, l, m, i, side)) return true;
    }
    return false;
}

/* Where two layers have the same edge, at least one of them with a facet in this cell, the first that has one draws it;
 * and if either has, nobody does again. */
static void share_coinciding(sweep_t *s, int32_t i) {
    for (int32_t m = 1; m < s->layers; m++) {
        for (int32_t k = 0; k < m; k++) {
            layer_t *a = &s->layer[k], *b = &s->layer[m];
            if (!a->present && !b->present) continue;
            for (int side = 0; side < SIDES; side++) {
                uint8_t *a_done = side_done(a, i, side), *b_done = side_done(b, i, side);
                if (*a_done && *b_done) continue;
                if (!side_coincides(s, a, b, i, side)) continue;
                const bool done = *a_done || *b_done;
                if (done || a->present) *b_done = 1;
                if (done || !a->present) *a_done = 1;
            }
        }
    }
}

/* Clips a layer's edges against the cells before, and against the other layers' facets in this one. */
static int clip_among_others(sweep_t *s, int32_t m, int32_t i, near_edges_t near) {
    edges_t *e = &s->edges;
    bool others = false;
    for (int32_t k = 0; k < s->layers; k++) {
        const layer_t *o = &s->layer[k];
        if (k == m || !o->present) continue;
        int err = others ? 0 : edges_filter(e, &s->local, s->local_pool, s->local_words);
        const int32_t inset = k > m && coincide(s, &s->layer[m], o, i) ? COINCIDING : 0;
        if (err == 0) err = bands_add(&s->local, o->outline, o->lines, o->seen, inset);
        if (err != 0) return err;
        others = true;
    }
    int err = clip_edges(s, &s->layer[m], i, near, false);
    e->filter = NULL;
    return err;
}

static int cell(sweep_t *s, int32_t i, near_edges_t near) {
    int err = 0;
    int32_t present = 0;
    for (int32_t m = 0; m < s->layers && err == 0; m++) {
        layer_t *l = &s->layer[m];
        /* In a plan all layers' lines are the same on the page: one will do. */
        l->present = side_present(l, i) && !(s->edges.chart.kind == CHART_VERTICAL && present > 0);
        if (!l->present) continue;
        present++;
        err = side_outline(s, l, i);
        if (err == 0 && is_hidden(s, l, i)) l->present = false;
    }
    share_coinciding(s, i);
    for (int32_t m = 0; m < s->layers && err == 0; m++) {
        if (s->layer[m].present) err = clip_edges(s, &s->layer[m], i, near, true);
    }
    for (int32_t m = 0; m < s->layers && err == 0; m++) {
        if (s->layer[m].present) err = clip_among_others(s, m, i, near);
    }
    for (int32_t m = 0; m < s->layers && err == 0; m++) {
        const layer_t *l = &s->layer[m];
        if (l->present) err = bands_add(&s->edges.bands, l->outline, l->lines, l->seen, 0);
    }
    s->facets += present;
    return err;
}

int cells_row(sweep_t *s, int far, bool fresh) {
    const chart_t *c = &s->edges.chart;
    const int32_t nx = c->grid->nx, i0 = c->i0;
    for (int32_t m = 0; m < s->layers; m++) {
        for (int32_t i = 0; i < nx; i++) s->layer[m].column_done[i] = 0;
    }
    int err = 0;
    for (int32_t i = i0; i < nx - 1 && err == 0; i++) err = cell(s, i, side_near_edges(c, i, far, fresh));
    for (int32_t i = i0 - 1; i >= 0 && err == 0; i--) err = cell(s, i, side_near_edges(c, i, far, fresh));
    return err;
}
