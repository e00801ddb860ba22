/* holes.c - see holes.h. */
#include "hidden/surface/holes.h"

#include "hidden/surface/corner.h"
#include "hidden/surface/sides.h"

/* Clips the near sides that are new: nothing in front of the facet ends there. Those in a plane through the eye do not
 * bound it. */
static int clip_bare(sweep_t *s, layer_t *l, int32_t i, near_edges_t near) {
    int err = 0;
    s->edges.bare = true;
    for (int side = 0; side < SIDES && err == 0; side++) {
        if (!side_faces_eye(near, i, side) || *side_done(l, i, side) || side_is_vertical(s, l, i, side)) continue;
        *side_done(l, i, side) = 1;
        err = side_clip(s, l, i, side);
    }
    s->edges.bare = false;
    return err;
}

/* Clips the others that are new, the vertical ones first. */
static int clip_far(sweep_t *s, layer_t *l, int32_t i) {
    int err = 0;
    for (int turn = 0; turn < 2; turn++) {
        for (int side = 0; side < SIDES && err == 0; side++) {
            if (*side_done(l, i, side) || (turn == 0 && !side_is_vertical(s, l, i, side))) continue;
            *side_done(l, i, side) = 1;
            err = side_clip(s, l, i, side);
        }
    }
    return err;
}

/* Closes what a facet covers. Not inline: its arrays need not be on the stack while edges are clipped. */
static __attribute__((noinline)) int close_facet(edges_t *e, const layer_t *l, int8_t below) {
    int err = 0;
    int32_t end[WINDOWS_ENDS];
    const int32_t ends = windows_ends(l->outline, l->lines, end);
    for (int32_t c = 0; c + 1 < ends && err == 0; c++) { /* one span at a time: they take much stack */
        windows_span_t span;
        if (!windows_span(l->outline, l->lines, end[c], end[c + 1], &span)) continue;
        if (below != 0) err = edges_cover_below(e, &span, 1, below);
        if (err == 0) err = windows_close(&e->windows, &span, 1, below);
    }
    return err;
}

/* Clips and closes all that is new of a facet. */
static int facet(sweep_t *s, layer_t *l, int32_t i, int8_t below) {
    int err = side_outline(s, l, i);
    if (err == 0) err = clip_far(s, l, i);
    if (err != 0 || (below == 0 && s->edges.windows.present == 0)) return err;
    return close_facet(&s->edges, l, below);
}

/* Is no window over the facet, and none of its far edges vertical? */
static bool is_plain(const sweep_t *s, const layer_t *l, int32_t i, int far, int32_t out, const corner_t *q) {
    const int32_t low = pencil_min(pencil_min(q->n.w, q->f.w), pencil_min(q->l.w, q->r.w));
    const int32_t high = pencil_max(pencil_max(q->n.w, q->f.w), pencil_max(q->l.w, q->r.w));
    return !windows_any(&s->edges.windows, q->l.a, q->r.a, low, high) &&
           !edges_row_is_vertical(&s->edges, &l->line[far], i) &&
           !edges_column_is_vertical(&s->edges, &l->line[0], &l->line[1], out);
}

static int corner_facet(sweep_t *s, layer_t *l, int32_t i, int far, bool rightward) {
    edges_t *e = &s->edges;
    const int32_t out = rightward ? i + 1 : i;
    uint8_t *column = &l->column_done[out], *row = &l->row_done[far][i];
    const corner_t q = corner_of_facet(l, i, far, rightward);
    const bool near_done = l->column_done[rightward ? i : i + 1] && l->row_done[1 - far][i]; /* unless vertical */
    if (!near_done || !corner_is_straight(&e->chart, &q)) return facet(s, l, i, l->seen);
    s->last = corner_judge(s, &q);
    if (s->last == FACET_HIDDEN || s->last == FACET_CUT) {
        if (!is_plain(s, l, i, far, out, &q)) return facet(s, l, i, 0);
        if (s->last == FACET_CUT) return clip_far(s, l, i);
        e->clipped += 2;
    }
    *column = *row = 1;
    if (s->last == FACET_HIDDEN) return 0;
    int err = edges_whole(e, INK_COL, out, l->line[0].j, &l->column_run[out]);
    return err != 0 ? err : edges_whole(e, INK_ROW, l->line[far].j, i, &l->row_run[far]);
}

static int cell(sweep_t *s, int32_t i, int far, bool fresh) {
    const chart_t *c = &s->edges.chart;
    layer_t *l = s->layer;
    horizons_t *h = &s->edges.horizons;
    h->skip_upper = h->skip_lower = false;
    if (!side_present(l, i)) return 0;
    s->facets++;
    int err = sweep_shade(s, l, i);
    if (err == 0) err = clip_bare(s, l, i, side_near_edges(c, i, far, fresh));
    if (err != 0) return err;
    if (fresh || i == c->i0) return facet(s, l, i, l->seen);
    return corner_facet(s, l, i, far, i > c->i0);
}

int holes_row(sweep_t *s, int far, bool fresh) {
    const int32_t nx = s->edges.chart.grid->nx, i0 = s->edges.chart.i0;
    int err = 0;
    for (int32_t i = 0; i < nx; i++) s->layer->column_done[i] = 0;
    for (int32_t i = i0; i < nx - 1 && err == 0; i++) err = cell(s, i, far, fresh);
    for (int32_t i = i0 - 1; i >= 0 && err == 0; i--) err = cell(s, i, far, fresh);
    return err;
}
