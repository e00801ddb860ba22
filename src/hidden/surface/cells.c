/* cells.c - see cells.h. */
#include "hidden/surface/cells.h"

#include "config.h"
#include "hidden/surface/sides.h"

_Static_assert(CONFIG_PLOT_ITEMS <= 32, "a bit for each layer");

/* Takes what is visible of a side in a vertical plane through the eye: of the other layers' facets in the cell only the
 * edges in the same plane count. */
static int look_vertical(sweep_t *s, layer_t *l, int32_t i, int side) {
    edges_t *e = &s->edges;
    const int32_t sheets = e->sheets;
    e->sheets = 0;
    e->shade = s->shade;
    for (int32_t k = 0; k < s->layers; k++) {
        const layer_t *o = &s->layer[k];
        if (o != l && o->present) e->shades += side_shade(s, l, o, i, side, e->shade + e->shades);
    }
    int err = side_clip(s, l, i, side);
    e->shades = 0;
    e->sheets = sheets;
    return err;
}

/* Takes what is visible of some sides. */
static int look_at(sweep_t *s, layer_t *l, int32_t i, uint8_t sides) {
    int err = 0;
    side_take_layer(s, l);
    s->edges.work = EDGES_LOOK;
    for (int side = 0; side < SIDES && err == 0; side++) {
        if (!(sides >> side & 1)) continue;
        err = side_is_vertical(s, l, i, side) ? look_vertical(s, l, i, side) : side_clip(s, l, i, side);
    }
    s->edges.work = EDGES_CLIP;
    return err;
}

/* Covers by some sides. */
static int cover_by(sweep_t *s, layer_t *l, int32_t i, uint8_t sides, bool bare) {
    edges_t *e = &s->edges;
    int err = 0;
    side_take_layer(s, l);
    e->work = EDGES_COVER;
    e->bare = bare;
    for (int side = 0; side < SIDES && err == 0; side++) {
        if (sides >> side & 1) err = side_clip(s, l, i, side);
    }
    e->work = EDGES_CLIP;
    e->bare = false;
    return err;
}

/* Notes which sides of a layer's facet are new: those that face the eye and are not vertical, and the others. */
static void find_new(sweep_t *s, layer_t *l, int32_t i, near_edges_t near) {
    l->near_new = l->far_new = 0;
    for (int side = 0; side < SIDES; side++) {
        uint8_t *done = side_done(l, i, side);
        if (*done) continue;
        *done = 1;
        const bool is_near = side_faces_eye(near, i, side) && !side_is_vertical(s, l, i, side);
        *(is_near ? &l->near_new : &l->far_new) |= (uint8_t)(1 << side);
    }
}

/* Is a layer's facet behind what the cells before it cover? Then its edges are done, and it covers nothing new. */
static bool is_hidden(sweep_t *s, layer_t *l, int32_t i) {
    edges_t *e = &s->edges;
    const outline_line_t *o = l->outline;
    if (l->lines == 0) return false;
    pencil_t least = o->p, most = o->q;
    for (int32_t k = 0; k < l->lines; k++, o++) {
        const int32_t low = pencil_min(o->p.w, o->q.w), high = pencil_max(o->p.w, o->q.w);
        least = (pencil_t){pencil_min(least.a, o->p.a), k == 0 ? low : pencil_min(least.w, low)};
        most = (pencil_t){pencil_max(most.a, o->q.a), k == 0 ? high : pencil_max(most.w, high)};
    }
    if (!envelope_hides(&e->horizons.upper, least.a, most.a, most.w) ||
        !envelope_hides(&e->horizons.lower, least.a, most.a, -least.w) ||
        windows_any(&e->windows, least.a, most.a, least.w, most.w)) {
        return false;
    }
    for (int side = 0; side < SIDES; side++) {
        e->clipped += !*side_done(l, i, side);
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

/* Does layer k draw what layer m has as well, or has it been drawn? */
static bool draws_for(const sweep_t *s, int32_t k, int32_t m, uint32_t done, uint32_t shared) {
    const bool first = k < m || !s->layer[m].present;
    return (done >> k & 1) != 0 || (first && s->layer[k].present && (shared >> k & 1) == 0);
}

/* Where layers have the same edge, the first that has a facet in this cell draws it; if one of them has been drawn,
 * none is again. What had been done before must be told from what is shared now: there may be three. */
static void share_coinciding(sweep_t *s, int32_t i, int side) {
    uint32_t done = 0, shared = 0;
    for (int32_t m = 0; m < s->layers; m++) done |= (uint32_t)*side_done(&s->layer[m], i, side) << m;
    for (int32_t m = 0; m < s->layers; m++) {
        if (done >> m & 1) continue;
        for (int32_t k = 0; k < s->layers; k++) {
            if (k == m || !draws_for(s, k, m, done, shared)) continue;
            if (!side_coincides(s, &s->layer[k], &s->layer[m], i, side)) continue;
            shared |= UINT32_C(1) << m;
            *side_done(&s->layer[m], i, side) = 1;
            break;
        }
    }
}

/* Takes what is visible of a layer's far sides: beyond the cells before, and the other layers' facets in this one.
 * Where edges of two layers coincide the first one's is drawn, neither none nor both. */
static int look_among_others(sweep_t *s, int32_t m, int32_t i) {
    edges_t *e = &s->edges;
    if (s->layer[m].far_new == 0) return 0;
    for (int32_t k = 0; k < s->layers; k++) {
        const layer_t *o = &s->layer[k];
        if (k == m || !o->present) continue;
        e->sheet[e->sheets++] = (edges_sheet_t){
            .span = o->span, .spans = o->spans, .below = o->below, .open = k > m && coincide(s, &s->layer[m], o, i)};
    }
    int err = look_at(s, &s->layer[m], i, s->layer[m].far_new);
    e->sheets = 0;
    return err;
}

/* All facets of the cell cover. Right below (above) the eye a facet covers from its far edges down (up) and has no near
 * ones: what is between it and another surface's stays open, and closes where it is covered. */
static int cover(sweep_t *s, int32_t i) {
    int err = 0;
    for (int32_t m = 0; m < s->layers && err == 0; m++) {
        layer_t *l = &s->layer[m];
        if (l->present) err = cover_by(s, l, i, l->near_new, true);
    }
    for (int32_t m = 0; m < s->layers && err == 0; m++) {
        layer_t *l = &s->layer[m];
        if (!l->present) continue;
        err = cover_by(s, l, i, l->far_new, l->below != 0);
        if (err == 0 && l->below != 0) err = edges_cover_below(&s->edges, l->span, l->spans, l->below);
        if (err == 0) err = windows_close(&s->edges.windows, l->span, l->spans, l->below);
    }
    return err;
}

/* Can the cell touch the point right below the eye? */
static bool is_central(const sweep_t *s, const layer_t *l, int32_t i) {
    const chart_t *c = &s->edges.chart;
    const int32_t di = i - c->i0, dj = l->line[0].j - c->j0;
    return di >= -1 && di <= 1 && dj >= -1 && dj <= 1;
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
        if (err == 0 && is_hidden(s, l, i)) {
            l->present = false;
        } else if (err == 0) {
            l->below = is_central(s, l, i) ? l->seen : 0;
            l->spans = windows_spans(l->outline, l->lines, l->span);
        }
    }
    for (int32_t m = 0; m < s->layers && err == 0; m++) {
        if (s->layer[m].present) err = sweep_shade(s, &s->layer[m], i);
    }
    for (int side = 0; side < SIDES && present > 0; side++) share_coinciding(s, i, side);
    for (int32_t m = 0; m < s->layers && err == 0; m++) {
        if (!s->layer[m].present) continue;
        find_new(s, &s->layer[m], i, near);
        err = look_at(s, &s->layer[m], i, s->layer[m].near_new);
    }
    for (int32_t m = 0; m < s->layers && err == 0; m++) {
        if (s->layer[m].present) err = look_among_others(s, m, i);
    }
    s->facets += present;
    return err != 0 ? err : cover(s, i);
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
