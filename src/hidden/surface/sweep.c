/* sweep.c - memory and order of a sweep. */
#include "hidden/surface/sweep.h"

#include "error.h"

/* Per column and layer: an open run, two rows of points; in CHART_AROUND two rows of heights; with windows six flags.
 */
#define LAYER_BYTES (sizeof(run_t) + 2 * sizeof(pencil_t))
#define AROUND_BYTES (2 * sizeof(int64_t))
#define FLAGS 6

/* Several surfaces: what the others hide of a vertical edge, their facets in a cell, what those hide of a line. */
#define OTHER_BYTES (2 * sizeof(shade_t) + sizeof(edges_sheet_t) + WINDOWS_SPANS * sizeof(windows_span_t))
#define OTHERS_BYTES(n) ((n) > 1 ? (size_t)(n)*OTHER_BYTES + WINDOWS_PARTS * sizeof(windows_part_t) : 0)

#define OUTLINE_EDGES 4 /* lines of a facet where every edge is one */

typedef struct lender {
    uint8_t *mem;
    size_t left, asked;
} lender_t;

static void *lend(lender_t *l, size_t bytes) {
    const size_t whole = (bytes + 7) / 8 * 8;
    void *at = l->mem;
    l->asked += whole;
    if (l->mem == NULL || l->left < whole) {
        l->mem = NULL;
        return NULL;
    }
    l->mem += whole;
    l->left -= whole;
    return at;
}

size_t sweep_bytes(int32_t nx, int32_t layers, bool windows) {
    const size_t column = LAYER_BYTES + AROUND_BYTES + (windows ? FLAGS : 0), rounding = 8 * (5 + FLAGS);
    const size_t outline = windows ? OUTLINE_LINES * sizeof(outline_line_t) : 0;
    return (size_t)layers * (sizeof(layer_t) + outline + (size_t)nx * column + rounding) +
           (size_t)nx * sizeof(chart_column_t) + 32 + OTHERS_BYTES(layers);
}

/* points: to a row, if not nx. */
static void lay_out(layer_t *l, lender_t *from, size_t nx, size_t points, bool around, bool windows) {
    l->column_run = lend(from, nx * sizeof(run_t));
    for (int k = 0; k < 2; k++) {
        l->line[k].at = lend(from, points * sizeof(pencil_t));
        l->line[k].first = 0;
        if (around) l->line[k].z = lend(from, nx * sizeof(int64_t));
        if (windows) {
            l->line[k].hole = lend(from, nx);
            l->row_done[k] = lend(from, nx);
        }
    }
    if (windows) {
        l->column_done = lend(from, nx);
        l->kept_done = lend(from, nx);
        l->outline = lend(from, (around ? OUTLINE_LINES : OUTLINE_EDGES) * sizeof(outline_line_t));
    }
}

/* Abscissae beyond a strip's borders whose points are needed. */
#define REACH (2 * STRIP_MARGIN)

/* The abscissae of a grid seen from outside of it end at its corners. */
static void set_strip(sweep_t *s) {
    const chart_t *c = &s->edges.chart;
    const grid_t *g = c->grid;
    int32_t lo = -(2 << CHART_SECTOR_BITS), hi = 2 << CHART_SECTOR_BITS;
    if (c->kind != CHART_AROUND) {
        lo = INT32_MAX, hi = INT32_MIN;
        for (int k = 0; k < 4; k++) {
            const int32_t a = chart_abscissa(c, k % 2 ? g->nx - 1 : 0, k / 2 ? g->ny - 1 : 0);
            lo = pencil_min(lo, a), hi = pencil_max(hi, a);
        }
    }
    strip_init(&s->edges.strip, lo, hi, s->from, s->to);
}

int sweep_init(sweep_t *s, grid_t *const grid[], int32_t n, const camera_t *cam, const hidden_job_t *job,
               enum edges_cover cover) {
    const bool windows = cover == COVER_WINDOWS;
    const size_t nx = (size_t)grid[0]->nx;
    lender_t from = {job->mem, job->bytes, 0};
    edges_t *e = &s->edges;
    s->pause = job->pause;
    s->layers = n;
    s->layer = lend(&from, (size_t)n * sizeof(layer_t));
    chart_column_t *column = lend(&from, nx * sizeof(chart_column_t));
    if (column == NULL) return ERR_FULL;
    chart_init(&e->chart, grid, n, cam, column);
    from.mem = (uint8_t *)(void *)column; /* what it does not use is for the horizons */
    from.left += (nx * sizeof(chart_column_t) + 7) / 8 * 8;
    from.asked -= (nx * sizeof(chart_column_t) + 7) / 8 * 8;
    lend(&from, chart_column_bytes(&e->chart));
    size_t points = nx;
    if (cover == COVER_STRIP) {
        set_strip(s);
        points = (size_t)chart_columns_over(&e->chart, e->strip.from - REACH, e->strip.to + REACH);
    }
    for (int32_t m = 0; m < n; m++) {
        layer_t *l = &s->layer[m];
        *l = (layer_t){.grid = grid[m], .surface = (uint8_t)m};
        lay_out(l, &from, nx, points, e->chart.kind == CHART_AROUND, windows);
        s->fixed = from.asked;
        if (from.mem == NULL) return ERR_FULL;
        for (size_t i = 0; i < nx; i++) l->column_run[i] = (run_t){0, 0};
        l->seen = chart_seen(&e->chart, grid[m]);
    }
    for (int32_t m = 0; m < n && n > 1; m++) s->layer[m].span = lend(&from, WINDOWS_SPANS * sizeof(windows_span_t));
    if (n > 1) {
        s->shade = lend(&from, 2 * (size_t)n * sizeof(shade_t));
        e->sheet = lend(&from, (size_t)n * sizeof(edges_sheet_t));
        e->behind = lend(&from, WINDOWS_PARTS * sizeof(windows_part_t));
    }
    s->fixed = from.asked;
    if (from.mem == NULL) return ERR_FULL;
    e->several = n > 1;
    return edges_init(e, job->sink, cover, s->layer[0].seen, (pencil_t *)(void *)from.mem,
                      from.left / sizeof(pencil_t));
}

static void fill(uint8_t *flag, const uint8_t *from, int32_t n) {
    for (int32_t i = 0; i < n; i++) flag[i] = from != NULL ? from[i] : 0;
}

/* Charts row j into line[k] of every layer; none of its edges is done. */
static void load_lines(sweep_t *s, int k, int32_t j) {
    for (int32_t m = 0; m < s->layers; m++) {
        layer_t *l = &s->layer[m];
        if (s->edges.cover == COVER_STRIP)
            chart_row_over(&s->edges.chart, l->grid, j, s->edges.strip.from - REACH, s->edges.strip.to + REACH,
                           &l->line[k]);
        else
            chart_row(&s->edges.chart, l->grid, j, &l->line[k]);
        if (s->edges.cover == COVER_WINDOWS) fill(l->row_done[k], NULL, l->grid->nx);
    }
}

/* The row of facets that is next: the line nearer to the eye stays, the other one is read. */
static void step(sweep_t *s, int far, int32_t j) {
    for (int32_t m = 0; m < s->layers; m++) {
        layer_t *l = &s->layer[m];
        const chart_line_t stays = l->line[far];
        uint8_t *done = l->row_done[far];
        l->line[far] = l->line[1 - far];
        l->line[1 - far] = stays;
        l->row_done[far] = l->row_done[1 - far];
        l->row_done[1 - far] = done;
    }
    load_lines(s, far, far ? j + 1 : j);
}

/* The eye's lower line is needed once more, on the way down: what of it is done must be known then. */
static void keep_done(sweep_t *s, bool restore) {
    for (int32_t m = 0; m < s->layers && s->edges.cover == COVER_WINDOWS; m++) {
        layer_t *l = &s->layer[m];
        fill(restore ? l->row_done[0] : l->kept_done, restore ? l->kept_done : l->row_done[0], l->grid->nx);
    }
}

static int flush_rows(sweep_t *s) {
    int err = 0;
    for (int32_t m = 0; m < s->layers; m++) {
        layer_t *l = &s->layer[m];
        s->edges.runs.surface = l->surface;
        for (int k = 0; k < 2 && err == 0; k++) {
            err = runs_flush(&s->edges.runs, &l->row_run[k], INK_ROW, l->line[k].j);
        }
    }
    return err;
}

static int flush_columns(sweep_t *s) {
    int err = 0;
    for (int32_t m = 0; m < s->layers; m++) {
        s->edges.runs.surface = s->layer[m].surface;
        for (int32_t i = 0; i < s->layer[m].grid->nx && err == 0; i++) {
            err = hidden_pause(s->pause);
            if (err == 0) err = runs_flush(&s->edges.runs, &s->layer[m].column_run[i], INK_COL, i);
        }
    }
    return err;
}

int sweep_all(sweep_t *s, const hidden_job_t *job, sweep_row_t row) {
    const chart_t *c = &s->edges.chart;
    const int32_t rows = c->grid->ny - 1, of = s->of * rows, each = s->to - s->from;
    int32_t done = s->from * rows;
    int err = 0;
    for (int up = 1; up >= (c->j0 > 0 ? 0 : 1) && err == 0; up--) {
        load_lines(s, 0, c->j0);
        if (up) load_lines(s, 1, c->j0 + 1);
        if (!up) keep_done(s, true);
        for (int32_t j = up ? c->j0 : c->j0 - 1; j >= 0 && j < rows && err == 0; j += up ? 1 : -1) {
            if (j != c->j0) step(s, up, j);
            err = row(s, up, j == c->j0);
            s->rows += err == 0;
            if (err == 0) err = hidden_pause(s->pause);
            if (err == 0) err = flush_rows(s);
            if (j == c->j0) keep_done(s, false);
            if (err == 0 && job->tick != NULL) job->tick(job->tick_ctx, done += each, of);
        }
    }
    return err != 0 ? err : flush_columns(s);
}

/* Horizons are soon nearly as long as they get. Windows grow with the rows, on random heights with holes up to this
 * (measured). */
#define WINDOWS_MOST(lines, layers) ((100 * (uint64_t)(lines) + 1500) * (uint64_t)(layers))

size_t sweep_needs(const sweep_t *s, const grid_t *g, const hidden_job_t *job, int32_t layers) {
    const int32_t strips = s->of / (s->to - s->from), usual = (layers > 1 ? 18 : 6) * (g->nx + g->ny) / strips;
    size_t fixed = s->fixed, more = (size_t)usual * sizeof(pencil_t);
    if (fixed == 0) /* it did not come to its rows */
        fixed = (size_t)layers * (size_t)g->nx * (sizeof(run_t) + 2 * sizeof(pencil_t) / (size_t)strips) +
                (size_t)g->nx * sizeof(chart_column_t);
    if (s->rows > 0) {
        const uint64_t had = job->bytes - fixed, rows = (uint64_t)g->ny - 1, done = (uint64_t)s->rows;
        const uint64_t most = WINDOWS_MOST(g->nx + g->ny, layers), grown = had * rows / done;
        if (s->edges.cover != COVER_WINDOWS)
            more = (size_t)(had + had * (rows - done) / (4 * rows));
        else
            more = (size_t)(grown < most || most < had ? grown : most);
    }
    return fixed + more;
}

void sweep_account(const sweep_t *s, hidden_stats_t *stats) {
    const horizons_t *h = &s->edges.horizons;
    int32_t upper = h->has_upper ? h->upper.peak : 0, lower = h->has_lower ? h->lower.peak : 0;
    size_t bytes = s->fixed + (size_t)(upper + lower) * sizeof(pencil_t);
    bytes += lowest_bytes(&h->lowest_upper) + lowest_bytes(&h->lowest_lower);
    if (s->edges.cover == COVER_WINDOWS) {
        bytes += windows_bytes(&s->edges.windows);
        stats->windows = s->edges.windows.used;
    }
    stats->facets = s->facets;
    if (s->from == 0) stats->edges = s->edges.clipped; /* the next strip meets the same ones */
    stats->tests += h->count.tests;
    stats->crossings += h->count.crossings;
    stats->pieces += s->edges.runs.pieces;
    stats->peak_upper = pencil_max(stats->peak_upper, upper);
    stats->peak_lower = pencil_max(stats->peak_lower, lower);
    if (stats->bytes < bytes) stats->bytes = bytes;
}
