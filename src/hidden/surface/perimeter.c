/* perimeter.c - a surface without holes against two horizons: the common case, and the fast one.
 *
 * Each facet clips those of its edges that nobody has clipped, the near ones first. They cover disjoint ranges of the
 * abscissa, so a facet is a tiny profile that raises the horizons. */
#include "hidden/surface/perimeter.h"

#include "config.h"
#include "error.h"
#include "hidden/surface/ahead.h"
#include "hidden/surface/cells.h"
#include "hidden/surface/corner.h"
#include "hidden/surface/holes.h"
#include "hidden/surface/shaded.h"
#include <string.h>

/* Two of its edges are new, the column `out` and the row `far`. */
static int corner_facet(sweep_t *s, int32_t i, int far, bool rightward) {
    edges_t *e = &s->edges;
    layer_t *l = s->layer;
    const chart_line_t *lf = &l->line[far];
    const int32_t out = rightward ? i + 1 : i;
    const corner_t q = corner_of_facet(l, i, far, rightward);
    e->horizons.skip_upper = e->horizons.skip_lower = false;
    if (e->cover == COVER_STRIP && strip_lacks(&e->strip, q.l.a, q.r.a) && corner_is_straight(&e->chart, &q)) {
        e->clipped += 2;
        return 0;
    }
    const bool whole = e->cover != COVER_STRIP || strip_has(&e->strip, q.l.a, q.r.a);
    if (!whole || !corner_is_straight(&e->chart, &q))
        s->last = FACET_CUT;
    else
        s->last = CONFIG_LOWEST ? corner_judge_here(s, &q) : corner_judge(s, &q);
    if (s->last == FACET_HIDDEN) {
        e->clipped += 2;
        return 0;
    }
    if (s->last != FACET_CUT) {
        int err = edges_whole(e, INK_COL, out, l->line[0].j, &l->column_run[out]);
        return err != 0 ? err : edges_whole(e, INK_ROW, lf->j, i, &l->row_run[far]);
    }
    const bool row_first =
        e->chart.kind == CHART_AROUND ? edges_row_is_vertical(e, lf, i) : envelope_vertical(lf->at[i], lf->at[i + 1]);
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

/* Facets from i on outward, as far as the one before `end`. */
static int facets_outward(sweep_t *s, int32_t i, int32_t end, int far, bool fresh, bool rightward) {
    const int32_t by = rightward ? 1 : -1;
    int err = 0;
    while (i != end && err == 0) {
        uint64_t shown = 1;
        int32_t n = 1;
        if (!fresh && ahead_is_wanted(s)) {
            n = pencil_min((end - i) * by, AHEAD_FACETS);
            shown = ahead_shown(s, i, n, far, rightward);
        }
        do { /* those that are hidden, and one more */
            const int32_t hidden = !AHEAD ? 0 : shown == 0 ? n : __builtin_ctzll(shown);
            if (hidden > 0) {
                s->edges.clipped += 2 * hidden;
                s->last = FACET_HIDDEN;
                i += by * hidden;
                n -= hidden;
                if (n == 0) break;
            }
            err = sweep_shade(s, s->layer, i);
            if (err == 0)
                err = fresh ? outer_facet(s, i, rightward ? i : i + 1, far, true) : corner_facet(s, i, far, rightward);
            i += by;
            n--;
            if (AHEAD) shown = shown >> hidden >> 1;
        } while (AHEAD && n > 0 && err == 0 && (s->last == FACET_CUT || s->last == FACET_HIDDEN));
    }
    return err;
}

/* A sweep_row_t: see sweep.h. */
static int facets_row(sweep_t *s, int far, bool fresh) {
    const chart_t *c = &s->edges.chart;
    const int32_t nx = c->grid->nx, i0 = c->i0;
    const chart_line_t *line = s->layer->line; /* what the strip lacks is passed over */
    const int32_t first = pencil_max(line[0].first, line[1].first), end = pencil_min(line[0].last, line[1].last);
    s->edges.horizons.skip_upper = s->edges.horizons.skip_lower = false;
    int err = sweep_shade(s, s->layer, i0);
    if (err == 0 && i0 >= first && i0 < end) err = outer_facet(s, i0, -1, far, fresh);
    const int32_t right = pencil_max(0, end - pencil_max(i0 + 1, first)),
                  left = pencil_max(0, pencil_min(i0, end) - first);
    if (err == 0 && right > 0) err = facets_outward(s, end - right, end, far, fresh, true);
    if (err == 0 && left > 0) err = facets_outward(s, first + left - 1, first - 1, far, fresh, false);
    s->facets += nx - 1;
    s->edges.clipped += (nx - 2 - right - left) * (fresh ? 3 : 2);
    if (i0 < first || i0 >= end) s->edges.clipped += fresh ? 4 : 3;
    return err;
}

size_t perimeter_bytes(int32_t nx, int32_t vertices) {
    return HIDDEN_LENT(sweep_t) + sweep_bytes(nx, 1, true) + (size_t)vertices * sizeof(pencil_t);
}

size_t perimeter_bytes_least(int32_t nx, int32_t vertices) {
    return HIDDEN_LENT(sweep_t) + sweep_bytes(nx, 1, false) + (size_t)vertices * sizeof(pencil_t);
}

bool perimeter_same_points(const surface_t *s, const surface_t *t) {
    if (s->nx != t->nx || s->ny != t->ny) return false;
    for (int32_t i = 0; i < s->nx; i++) {
        if (num_cmp(s->x_of(s->ctx, i), t->x_of(t->ctx, i)) != 0) return false;
    }
    for (int32_t j = 0; j < s->ny; j++) {
        if (num_cmp(s->y_of(s->ctx, j), t->y_of(t->ctx, j)) != 0) return false;
    }
    return true;
}

static int end_of(const hidden_strips_t *s, int from) {
    while (!(s->ends >> from & 1)) from++;
    return from + 1;
}

static int draw(grid_t *const grid[], int32_t n, const camera_t *cam, const hidden_job_t *job, struct shaded *shaded,
                hidden_stats_t *stats) {
    int64_t evaluated = 0;
    const bool several = n > 1 && CONFIG_PLOT_ITEMS > 1; /* else it need not be there */
    const bool windows = n > 1 || grid[0]->holes > 0;
    hidden_strips_t whole = {1, false}, *strips = windows || job->strips == NULL ? &whole : job->strips;
    const int of = strips == &whole ? 1 : HIDDEN_STRIPS;
    *stats = (hidden_stats_t){0};
    hidden_job_t rest = *job;
    HIDDEN_STATE(sweep_t, s, rest);
    if (s == NULL) return ERR_FULL;
    job = &rest;
    if (n > 1 && !several) return ERR_UNSUPPORTED;
    for (int32_t k = 0; k < n; k++) {
        if (k > 0 && !perimeter_same_points(grid[0]->src, grid[k]->src)) return ERR_UNSUPPORTED;
        evaluated -= grid[k]->evaluated;
    }
    const sweep_row_t row = several ? cells_row : windows ? holes_row : facets_row;
    int err = 0;
    for (int from = 0; from < of && err == 0;) {
        const int to = end_of(strips, from);
        const enum edges_cover cover = windows ? COVER_WINDOWS : to - from < of ? COVER_STRIP : COVER_HORIZONS;
        memset(s, 0, sizeof *s);
        s->from = from;
        s->to = to;
        s->of = of;
        err = sweep_init(s, grid, n, cam, job, cover);
#if CONFIG_AREA
        s->shaded = shaded;
#else
        (void)shaded;
#endif
        if (err == 0) err = sweep_all(s, job, row);
        if (s->layer != NULL) sweep_account(s, stats);
        if (err == ERR_FULL && strips->divide && to - from > 1) {
            strips->ends |= (uint16_t)(1u << ((from + to) / 2 - 1));
            err = 0;
        } else {
            if (err == ERR_FULL) {
                const size_t needs = HIDDEN_LENT(sweep_t) + sweep_needs(s, grid[0], job, n);
                if (stats->needs < needs) stats->needs = needs;
                if (strips->divide && to < of) err = 0; /* the next one may need more */
            }
            from = to;
            stats->strips++;
        }
    }
    if (err == 0 && stats->needs > 0) err = ERR_FULL;
    stats->bytes += HIDDEN_LENT(sweep_t);
    for (int32_t k = 0; k < n; k++) evaluated += grid[k]->evaluated;
    stats->evaluated = evaluated;
    return err;
}

int perimeter_draw_several(grid_t *const grid[], int32_t n, const camera_t *cam, const hidden_job_t *job,
                           hidden_stats_t *stats) {
    return draw(grid, n, cam, job, NULL, stats);
}

#if CONFIG_AREA
int perimeter_draw_shaded(grid_t *const grid[], int32_t n, const camera_t *cam, const hidden_job_t *job,
                          struct shaded *shaded, hidden_stats_t *stats) {
    int err = draw(grid, n, cam, job, shaded, stats);
    if (err == 0) err = shaded_finish(shaded);
    stats->pieces += shaded->pieces;
    return err;
}
#endif

int perimeter_draw(grid_t *g, const camera_t *cam, const hidden_job_t *job, hidden_stats_t *stats) {
    return perimeter_draw_several(&g, 1, cam, job, stats);
}
