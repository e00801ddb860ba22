/* perimeter.c - the sweep: facets in occlusion-compatible order, two rows of the grid at a time.
 *
 *      . . . . . . .      Rows outward from the eye's cell, first up, then down; in a row columns outward,
 *      . 5 4 3 6 7 .      first right, then left. Each facet clips those of its edges that nobody has clipped,
 *      . . . 2 . . .      the near ones first. They cover disjoint ranges of the abscissa, so a facet is a
 *      . . . E 1 . .      tiny profile that raises the horizons.
 */
#include "hidden/perimeter.h"

#include "error.h"
#include "hidden/edges.h"

/* What became of a facet's far edges: both wholly above the upper horizon, below the lower one, both hidden, or
 * something else. */
enum facet_kind { FACET_CUT, FACET_ABOVE, FACET_BELOW, FACET_HIDDEN };

typedef struct sweep {
    edges_t edges;
    enum facet_kind last; /* of the corner facet before */
    chart_line_t line[2]; /* [0] has the smaller j, between two rows of facets one of them is refilled */
    run_t *column_run;    /* one per column */
    run_t row_run[2];     /* of line[0] and line[1] */
    uint8_t *row_done[2]; /* holes: which edges of line[0] and line[1] have been clipped */
    uint8_t *column_done; /* holes: which columns' edges between the lines */
    uint8_t *kept_done;   /* holes: which edges of row j0, for the way down */
    int64_t facets;
} sweep_t;

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
    int32_t top = q->l.w > q->r.w ? q->l.w : q->r.w, bottom = q->l.w < q->r.w ? q->l.w : q->r.w;
    if (q->f.w > top) top = q->f.w;
    if (q->f.w < bottom) bottom = q->f.w;
    h->skip_upper = h->has_upper && envelope_hides(&h->upper, q->l.a, q->r.a, top);
    h->skip_lower = h->has_lower && envelope_hides(&h->lower, q->l.a, q->r.a, -bottom);
    if ((h->skip_upper || !h->has_upper) && (h->skip_lower || !h->has_lower)) return FACET_HIDDEN;
    if (!h->skip_upper && s->last != FACET_ABOVE && advance_upper(s, q)) return FACET_ABOVE;
    if (!h->skip_lower && s->last != FACET_BELOW && advance_lower(s, q)) return FACET_BELOW;
    return FACET_CUT;
}

/* Two of its edges are new, the column `out` and the row `far`. */
static int corner_facet(sweep_t *s, int32_t i, int far, bool rightward) {
    edges_t *e = &s->edges;
    const chart_line_t *lf = &s->line[far], *ln = &s->line[1 - far];
    const int32_t in = rightward ? i : i + 1, out = rightward ? i + 1 : i;
    corner_t q = {ln->at[in], lf->at[in], ln->at[out], lf->at[out], rightward != (far == 1)};
    if (!q.ascending) {
        pencil_t r = q.l;
        q.l = q.r;
        q.r = r;
    }
    /* In CHART_AROUND an edge may bend at a diagonal, and in a plan nothing is hidden. */
    const bool straight = e->chart.kind < CHART_AROUND || edges_in_one_sector(q.l, q.r);
    e->horizons.skip_upper = e->horizons.skip_lower = false;
    s->last = straight ? judge_corner(s, &q) : FACET_CUT;
    if (s->last == FACET_HIDDEN) {
        e->clipped += 2;
        return 0;
    }
    if (s->last != FACET_CUT) {
        int err = edges_whole(e, INK_COL, out, s->line[0].j, &s->column_run[out]);
        return err != 0 ? err : edges_whole(e, INK_ROW, lf->j, i, &s->row_run[far]);
    }
    const bool row_first = edges_row_is_vertical(e, lf, i);
    int err = row_first ? edges_row(e, lf, i, &s->row_run[far]) : 0;
    if (err == 0) err = edges_column(e, &s->line[0], &s->line[1], out, &s->column_run[out]);
    if (err == 0 && !row_first) err = edges_row(e, lf, i, &s->row_run[far]);
    return err;
}

static int column_edge(sweep_t *s, int32_t i) {
    return edges_column(&s->edges, &s->line[0], &s->line[1], i, &s->column_run[i]);
}

static int row_edge(sweep_t *s, int which, int32_t i) {
    return edges_row(&s->edges, &s->line[which], i, &s->row_run[which]);
}

/* The first facet of a row, and every facet of the eye's row: near edges first, then those that are vertical in the
 * chart, then the rest. inner is -1 for the first facet, otherwise the column that is already done. fresh: both row
 * edges are new; else line `far`. */
static int outer_facet(sweep_t *s, int32_t i, int32_t inner, int far, bool fresh) {
    const edges_t *e = &s->edges;
    const chart_t *c = &e->chart;
    const int32_t near_column = c->side_x > 0 ? i + 1 : c->side_x < 0 ? i : -1;
    const int near_row = c->side_y > 0 ? 1 : c->side_y < 0 ? 0 : -1;
    int rank[4]; /* of columns i, i + 1 and lines 0, 1 */
    for (int k = 0; k < 2; k++) {
        bool vertical = edges_column_is_vertical(e, &s->line[0], &s->line[1], i + k);
        rank[k] = i + k == inner ? -1 : i + k == near_column ? 0 : vertical ? 1 : 2;
        rank[2 + k] = !fresh && k != far ? -1 : k == near_row ? 0 : edges_row_is_vertical(e, &s->line[k], i) ? 1 : 2;
    }
    int err = 0;
    for (int turn = 0; turn < 3; turn++) {
        for (int k = 0; k < 4 && err == 0; k++) {
            if (rank[k] == turn) err = k < 2 ? column_edge(s, i + k) : row_edge(s, k - 2, i);
        }
    }
    return err;
}

/* A facet of a surface with holes: edges that no facet has clipped before, then the facet covers. */
static int facet_among_holes(sweep_t *s, int32_t i) {
    edges_t *e = &s->edges;
    const uint8_t *h0 = s->line[0].hole, *h1 = s->line[1].hole;
    int err = 0;
    if (h0[i] || h0[i + 1] || h1[i] || h1[i + 1]) return 0;
    e->lines = 0;
    for (int pass = 0; pass < 2; pass++) { /* the outline, then what of it has not been clipped */
        e->outline_only = pass == 0;
        for (int32_t k = i; k <= i + 1 && err == 0; k++) {
            if (pass == 0 || !s->column_done[k]) err = column_edge(s, k);
            s->column_done[k] |= (uint8_t)pass;
        }
        for (int k = 0; k < 2 && err == 0; k++) {
            if (pass == 0 || !s->row_done[k][i]) err = row_edge(s, k, i);
            s->row_done[k][i] |= (uint8_t)pass;
        }
    }
    s->facets++;
    return err != 0 ? err : bands_add(&e->bands, e->outline, e->lines, e->chart.seen);
}

static int row_among_holes(sweep_t *s) {
    const chart_t *c = &s->edges.chart;
    const int32_t nx = c->grid->nx;
    int err = 0;
    for (int32_t i = 0; i < nx; i++) s->column_done[i] = 0;
    for (int32_t i = c->i0; i < nx - 1 && err == 0; i++) err = facet_among_holes(s, i);
    for (int32_t i = c->i0 - 1; i >= 0 && err == 0; i--) err = facet_among_holes(s, i);
    return err;
}

static int flush_rows(sweep_t *s) {
    int err = 0;
    for (int k = 0; k < 2 && err == 0; k++) {
        err = runs_flush(&s->edges.runs, &s->row_run[k], INK_ROW, s->line[k].j);
    }
    return err;
}

/* One row of facets between line[0] and line[1]; `far` is the line away from the eye. */
static int sweep_row(sweep_t *s, int far, bool fresh) {
    const chart_t *c = &s->edges.chart;
    const int32_t nx = c->grid->nx, i0 = c->i0;
    s->edges.horizons.skip_upper = s->edges.horizons.skip_lower = false;
    if (s->edges.gaps) {
        int err = row_among_holes(s);
        return err != 0 ? err : flush_rows(s);
    }
    int err = outer_facet(s, i0, -1, far, fresh);
    for (int32_t i = i0 + 1; i < nx - 1 && err == 0; i++) {
        err = fresh ? outer_facet(s, i, i, far, true) : corner_facet(s, i, far, true);
    }
    for (int32_t i = i0 - 1; i >= 0 && err == 0; i--) {
        err = fresh ? outer_facet(s, i, i + 1, far, true) : corner_facet(s, i, far, false);
    }
    s->facets += nx - 1;
    return err != 0 ? err : flush_rows(s);
}

/* What a column needs besides the chart: two rows of points, an open run. */
#define COLUMN_BYTES (2 * sizeof(pencil_t) + sizeof(run_t) + sizeof(chart_column_t))
#define AROUND_COLUMN_BYTES (2 * sizeof(int32_t))
#define HOLE_COLUMN_BYTES 6 /* flags: two lines' holes and done edges, done columns, row j0's done edges */

size_t perimeter_bytes(int32_t nx, int32_t vertices) {
    return (size_t)nx * (COLUMN_BYTES + AROUND_COLUMN_BYTES + HOLE_COLUMN_BYTES) + (size_t)vertices * sizeof(pencil_t) +
           16;
}

/* Lays the working memory out: runs and points per column first, the horizons take the rest. */
static int lay_out(sweep_t *s, grid_t *g, const camera_t *cam, const hidden_job_t *job, size_t *fixed) {
    const size_t nx = (size_t)g->nx;
    edges_t *e = &s->edges;
    uint8_t *mem = job->mem;
    *fixed = nx * COLUMN_BYTES;
    if (job->bytes < *fixed) return ERR_FULL;
    s->column_run = (run_t *)(void *)mem;
    mem += nx * sizeof(run_t);
    for (int k = 0; k < 2; k++) {
        s->line[k].at = (pencil_t *)(void *)mem;
        mem += nx * sizeof(pencil_t);
    }
    chart_init(&e->chart, g, cam, (chart_column_t *)(void *)mem);
    mem += nx * sizeof(chart_column_t);
    if (e->chart.kind == CHART_AROUND) {
        *fixed += nx * AROUND_COLUMN_BYTES;
        if (job->bytes < *fixed) return ERR_FULL;
        for (int k = 0; k < 2; k++) {
            s->line[k].z = (int32_t *)(void *)mem;
            mem += nx * sizeof(int32_t);
        }
    }
    if (g->holes > 0) {
        const size_t flags = (nx * HOLE_COLUMN_BYTES + 7) / 8 * 8;
        *fixed += flags;
        if (job->bytes < *fixed) return ERR_FULL;
        for (int k = 0; k < 2; k++) {
            s->line[k].hole = mem + (size_t)k * nx;
            s->row_done[k] = mem + (size_t)(2 + k) * nx;
        }
        s->column_done = mem + 4 * nx;
        s->kept_done = mem + 5 * nx;
        mem += flags;
    }
    for (size_t i = 0; i < nx; i++) s->column_run[i] = (run_t){0, 0};
    return edges_init(e, job->sink, g->holes > 0, (pencil_t *)(void *)mem, (job->bytes - *fixed) / sizeof(pencil_t));
}

/* Charts row j into line[k]; none of its edges is done. */
static void load_line(sweep_t *s, int k, int32_t j) {
    chart_row(&s->edges.chart, j, &s->line[k]);
    if (s->edges.gaps) {
        for (int32_t i = 0; i < s->edges.chart.grid->nx; i++) s->row_done[k][i] = 0;
    }
}

/* The eye's row has been swept: its lower line will be needed once more, on the way down. */
static void keep_done(sweep_t *s) {
    for (int32_t i = 0; s->edges.gaps && i < s->edges.chart.grid->nx; i++) s->kept_done[i] = s->row_done[0][i];
}

static void restore_done(sweep_t *s) {
    for (int32_t i = 0; s->edges.gaps && i < s->edges.chart.grid->nx; i++) s->row_done[0][i] = s->kept_done[i];
}

/* The sweep proper. line[0] and line[1] always hold rows j and j + 1. */
static int sweep_all(sweep_t *s, const hidden_job_t *job) {
    chart_t *c = &s->edges.chart;
    const int32_t rows = c->grid->ny - 1;
    int32_t rows_done = 0;
    int err = 0;
    for (int up = 1; up >= (c->j0 > 0 ? 0 : 1) && err == 0; up--) {
        load_line(s, 0, c->j0);
        if (up) load_line(s, 1, c->j0 + 1);
        if (!up) restore_done(s);
        for (int32_t j = up ? c->j0 : c->j0 - 1; j >= 0 && j < rows && err == 0; j += up ? 1 : -1) {
            if (j != c->j0) { /* the line that is nearer to the eye stays */
                chart_line_t stays = s->line[up];
                s->line[up] = s->line[1 - up];
                s->line[1 - up] = stays;
                uint8_t *done = s->row_done[up];
                s->row_done[up] = s->row_done[1 - up];
                s->row_done[1 - up] = done;
                load_line(s, up, up ? j + 1 : j);
            }
            err = sweep_row(s, up, j == c->j0);
            if (j == c->j0) keep_done(s);
            if (err == 0 && job->tick != NULL) job->tick(job->tick_ctx, ++rows_done, rows);
        }
    }
    for (int32_t i = 0; i < c->grid->nx && err == 0; i++) {
        err = runs_flush(&s->edges.runs, &s->column_run[i], INK_COL, i);
    }
    return err;
}

int perimeter_draw(grid_t *g, const camera_t *cam, const hidden_job_t *job, hidden_stats_t *stats) {
    sweep_t s = {0};
    edges_t *e = &s.edges;
    const int64_t before = g->evaluated;
    size_t fixed = 0;
    *stats = (hidden_stats_t){0};
    int err = lay_out(&s, g, cam, job, &fixed);
    if (err == 0) err = sweep_all(&s, job);
    stats->facets = s.facets;
    stats->edges = e->clipped;
    stats->tests = e->horizons.count.tests + e->bands.count.tests;
    stats->crossings = e->horizons.count.crossings + e->bands.count.crossings;
    stats->pieces = e->runs.pieces;
    stats->evaluated = g->evaluated - before;
    stats->peak_upper = e->horizons.has_upper ? e->horizons.upper.peak : 0;
    stats->peak_lower = e->horizons.has_lower ? e->horizons.lower.peak : 0;
    stats->bytes = fixed + (size_t)(stats->peak_upper + stats->peak_lower) * sizeof(pencil_t);
    stats->bytes += (size_t)e->bands.peak * sizeof(int32_t);
    return err;
}
