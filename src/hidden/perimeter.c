/* perimeter.c - a surface without holes against two horizons: the common case, and the fast one.
 *
 * Each facet clips those of its edges that nobody has clipped, the near ones first. They cover disjoint ranges of the
 * abscissa, so a facet is a tiny profile that raises the horizons. */
#include "hidden/perimeter.h"

#include "error.h"
#include "hidden/cells.h"

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
static enum facet_kind judge_corner(sweep_t *s, const corner_t *q) {
    horizons_t *h = &s->edges.horizons;
    if (s->last == FACET_ABOVE && advance_upper(s, q)) return FACET_ABOVE;
    if (s->last == FACET_BELOW && advance_lower(s, q)) return FACET_BELOW;
    const int32_t top = pencil_max(q->f.w, pencil_max(q->l.w, q->r.w));
    const int32_t bottom = pencil_min(q->f.w, pencil_min(q->l.w, q->r.w));
    h->skip_upper = h->has_upper && envelope_hides(&h->upper, q->l.a, q->r.a, top);
    h->skip_lower = h->has_lower && envelope_hides(&h->lower, q->l.a, q->r.a, -bottom);
    if ((h->skip_upper || !h->has_upper) && (h->skip_lower || !h->has_lower)) return FACET_HIDDEN;
    if (!h->skip_upper && s->last != FACET_ABOVE && advance_upper(s, q)) return FACET_ABOVE;
    if (!h->skip_lower && s->last != FACET_BELOW && advance_lower(s, q)) return FACET_BELOW;
    return FACET_CUT;
}

/* CHART_AROUND: is it in one sector and one zone? */
static bool is_straight(const corner_t *q) {
    if (q->n.a == CHART_NONE || q->f.a == CHART_NONE) return false;
    const int32_t low = pencil_min(pencil_min(q->n.w, q->f.w), pencil_min(q->l.w, q->r.w));
    const int32_t high = pencil_max(pencil_max(q->n.w, q->f.w), pencil_max(q->l.w, q->r.w));
    return edges_is_straight(q->l, q->r) && chart_in_one_zone(low, high);
}

/* Two of its edges are new, the column `out` and the row `far`. */
static int corner_facet(sweep_t *s, int32_t i, int far, bool rightward) {
    edges_t *e = &s->edges;
    layer_t *l = s->layer;
    const chart_line_t *lf = &l->line[far], *ln = &l->line[1 - far];
    const int32_t in = rightward ? i : i + 1, out = rightward ? i + 1 : i;
    corner_t q = {ln->at[in], lf->at[in], ln->at[out], lf->at[out], rightward != (far == 1)};
    if (!q.ascending) {
        pencil_t r = q.l;
        q.l = q.r;
        q.r = r;
    }
    /* In CHART_AROUND an edge may bend at a diagonal, and in a plan nothing is hidden. */
    const bool straight = e->chart.kind < CHART_AROUND || (e->chart.kind == CHART_AROUND && is_straight(&q));
    e->horizons.skip_upper = e->horizons.skip_lower = false;
    s->last = straight ? judge_corner(s, &q) : FACET_CUT;
    if (s->last == FACET_HIDDEN) {
        e->clipped += 2;
        return 0;
    }
    if (s->last != FACET_CUT) {
        int err = edges_whole(e, INK_COL, out, l->line[0].j, &l->column_run[out]);
        return err != 0 ? err : edges_whole(e, INK_ROW, lf->j, i, &l->row_run[far]);
    }
    const bool row_first = edges_row_is_vertical(e, lf, i);
    int err = row_first ? sweep_row_edge(s, l, far, i) : 0;
    if (err == 0) err = sweep_column_edge(s, l, out);
    if (err == 0 && !row_first) err = sweep_row_edge(s, l, far, i);
    return err;
}

/* The first facet of a row, and every facet of the eye's row: near edges first, then those that are vertical in the
 * chart, then the rest. inner is -1 for the first facet, otherwise the column that is already done. fresh: both row
 * edges are new; else line `far`. */
static int outer_facet(sweep_t *s, int32_t i, int32_t inner, int far, bool fresh) {
    const edges_t *e = &s->edges;
    const chart_t *c = &e->chart;
    layer_t *l = s->layer;
    const int32_t near_column = c->side_x > 0 ? i + 1 : c->side_x < 0 ? i : -1;
    const int near_row = c->side_y > 0 ? 1 : c->side_y < 0 ? 0 : -1;
    int rank[4]; /* of columns i, i + 1 and lines 0, 1 */
    for (int k = 0; k < 2; k++) {
        bool vertical = edges_column_is_vertical(e, &l->line[0], &l->line[1], i + k);
        rank[k] = i + k == inner ? -1 : i + k == near_column ? 0 : vertical ? 1 : 2;
        rank[2 + k] = !fresh && k != far ? -1 : k == near_row ? 0 : edges_row_is_vertical(e, &l->line[k], i) ? 1 : 2;
    }
    int err = 0;
    for (int turn = 0; turn < 3; turn++) {
        for (int k = 0; k < 4 && err == 0; k++) {
            if (rank[k] == turn) err = k < 2 ? sweep_column_edge(s, l, i + k) : sweep_row_edge(s, l, k - 2, i);
        }
    }
    return err;
}

/* A sweep_row_t: see sweep.h. */
static int facets_row(sweep_t *s, int far, bool fresh) {
    const chart_t *c = &s->edges.chart;
    const int32_t nx = c->grid->nx, i0 = c->i0;
    s->edges.horizons.skip_upper = s->edges.horizons.skip_lower = false;
    int err = outer_facet(s, i0, -1, far, fresh);
    for (int32_t i = i0 + 1; i < nx - 1 && err == 0; i++) {
        err = fresh ? outer_facet(s, i, i, far, true) : corner_facet(s, i, far, true);
    }
    for (int32_t i = i0 - 1; i >= 0 && err == 0; i--) {
        err = fresh ? outer_facet(s, i, i + 1, far, true) : corner_facet(s, i, far, false);
    }
    s->facets += nx - 1;
    return err;
}

size_t perimeter_bytes(int32_t nx, int32_t vertices) {
    return sweep_bytes(nx, 1, true) + (size_t)vertices * sizeof(pencil_t);
}

static bool same_points(const grid_t *a, const grid_t *b) {
    if (a->nx != b->nx || a->ny != b->ny) return false;
    const surface_t *s = a->src, *t = b->src;
    for (int32_t i = 0; i < a->nx; i++) {
        if (num_cmp(s->x_of(s->ctx, i), t->x_of(t->ctx, i)) != 0) return false;
    }
    for (int32_t j = 0; j < a->ny; j++) {
        if (num_cmp(s->y_of(s->ctx, j), t->y_of(t->ctx, j)) != 0) return false;
    }
    return true;
}

/* Of two sweeps over the same facets. */
static void add_sweep(hidden_stats_t *stats, const hidden_stats_t *before) {
    stats->tests += before->tests;
    stats->crossings += before->crossings;
    stats->pieces += before->pieces;
    stats->peak_upper = before->peak_upper;
    if (stats->bytes < before->bytes) stats->bytes = before->bytes;
}

int perimeter_draw_several(grid_t *const grid[], int32_t n, const camera_t *cam, const hidden_job_t *job,
                           hidden_stats_t *stats) {
    sweep_t s = {0};
    int64_t evaluated = 0;
    bool gaps = n > 1;
    *stats = (hidden_stats_t){0};
    for (int32_t k = 0; k < n; k++) {
        if (k > 0 && !same_points(grid[0], grid[k])) return ERR_UNSUPPORTED;
        if (grid[k]->holes > 0) gaps = true;
        evaluated -= grid[k]->evaluated;
    }
    int err = 0, turn = job->in_turn ? 1 : 0;
    do {
        hidden_stats_t before = *stats;
        s = (sweep_t){0};
        err = sweep_init(&s, grid, n, cam, job, gaps, turn);
        if (err == 0) err = sweep_all(&s, job, gaps ? cells_row : facets_row);
        if (s.layer != NULL) sweep_account(&s, stats);
        if (s.turn < 0) add_sweep(stats, &before);
        turn = -s.turn;
    } while (err == 0 && turn < 0);
    for (int32_t k = 0; k < n; k++) evaluated += grid[k]->evaluated;
    stats->evaluated = evaluated;
    return err;
}

int perimeter_draw(grid_t *g, const camera_t *cam, const hidden_job_t *job, hidden_stats_t *stats) {
    return perimeter_draw_several(&g, 1, cam, job, stats);
}
