/* cells.c - see cells.h. */
#include "hidden/cells.h"

/* Which edges of a cell face the eye: a column or -1, a line or -1. */
typedef struct near_edges {
    int32_t column;
    int line;
} near_edges_t;

static bool is_present(const layer_t *l, int32_t i) {
    const uint8_t *h0 = l->line[0].hole, *h1 = l->line[1].hole;
    return !(h0[i] || h0[i + 1] || h1[i] || h1[i + 1]);
}

static void take_layer(sweep_t *s, layer_t *l) {
    s->edges.runs.surface = l->surface;
    s->edges.outline = l->outline;
    s->edges.lines = l->lines;
}

/* Notes the lines that bound a layer's facet. */
static int outline(sweep_t *s, layer_t *l, int32_t i) {
    int err = 0;
    l->lines = 0;
    take_layer(s, l);
    s->edges.outline_only = true;
    for (int k = 0; k < 2 && err == 0; k++) {
        err = sweep_column_edge(s, l, i + k);
        if (err == 0) err = sweep_row_edge(s, l, k, i);
    }
    s->edges.outline_only = false;
    l->lines = s->edges.lines;
    return err;
}

/* Clips those edges of a layer's facet that are new and near (or not near). */
static int clip_edges(sweep_t *s, layer_t *l, int32_t i, near_edges_t near, bool are_near) {
    int err = 0;
    take_layer(s, l);
    for (int k = 0; k < 2 && err == 0; k++) {
        if (!l->column_done[i + k] && (i + k == near.column) == are_near) {
            l->column_done[i + k] = 1;
            err = sweep_column_edge(s, l, i + k);
        }
        if (err == 0 && !l->row_done[k][i] && (k == near.line) == are_near) {
            l->row_done[k][i] = 1;
            err = sweep_row_edge(s, l, k, i);
        }
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
    uint8_t *done[4] = {&l->column_done[i], &l->column_done[i + 1], &l->row_done[0][i], &l->row_done[1][i]};
    for (int k = 0; k < 4; k++) {
        s->edges.clipped += !*done[k];
        *done[k] = 1;
    }
    return true;
}

/* Clips a layer's edges against the cells before, and against the other layers' facets in this one. */
static int clip_among_others(sweep_t *s, int32_t m, int32_t i, near_edges_t near) {
    edges_t *e = &s->edges;
    bool others = false;
    for (int32_t k = 0; k < s->layers; k++) {
        const layer_t *o = &s->layer[k];
        if (k == m || !o->present) continue;
        int err = others ? 0 : edges_filter(e, &s->local, s->local_pool, s->local_words);
        if (err == 0) err = bands_add(&s->local, o->outline, o->lines, o->seen);
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
        l->present = is_present(l, i) && !(s->edges.chart.kind == CHART_VERTICAL && present > 0);
        if (!l->present) continue;
        present++;
        err = outline(s, l, i);
        if (err == 0 && is_hidden(s, l, i)) l->present = false;
    }
    for (int32_t m = 0; m < s->layers && err == 0; m++) {
        if (s->layer[m].present) err = clip_edges(s, &s->layer[m], i, near, true);
    }
    for (int32_t m = 0; m < s->layers && err == 0; m++) {
        if (s->layer[m].present) err = clip_among_others(s, m, i, near);
    }
    for (int32_t m = 0; m < s->layers && err == 0; m++) {
        const layer_t *l = &s->layer[m];
        if (l->present) err = bands_add(&s->edges.bands, l->outline, l->lines, l->seen);
    }
    s->facets += present;
    return err;
}

int cells_row(sweep_t *s, int far, bool fresh) {
    const chart_t *c = &s->edges.chart;
    const int32_t nx = c->grid->nx, i0 = c->i0;
    near_edges_t near = {.line = !fresh ? 1 - far : c->side_y > 0 ? 1 : c->side_y < 0 ? 0 : -1};
    int err = 0;
    for (int32_t m = 0; m < s->layers; m++) {
        for (int32_t i = 0; i < nx; i++) s->layer[m].column_done[i] = 0;
    }
    near.column = c->side_x > 0 ? i0 + 1 : c->side_x < 0 ? i0 : -1;
    err = cell(s, i0, near);
    for (int32_t i = i0 + 1; i < nx - 1 && err == 0; i++) {
        near.column = i;
        err = cell(s, i, near);
    }
    for (int32_t i = i0 - 1; i >= 0 && err == 0; i--) {
        near.column = i + 1;
        err = cell(s, i, near);
    }
    return err;
}
