/* Test a row, then the edges to the next row, then raise; all sampled at the middles of columns. */
#include "tests/report/naive.h"

#include <math.h>
#include <stdlib.h>

#define EPSILON 1e-3f /* mm: what counts as on the horizon */

typedef struct naive {
    const scene_t *s;
    const ink_sink_t *sink;
    float x0, width; /* of the page in columns */
    float top[NAIVE_COLUMNS], bottom[NAIVE_COLUMNS];
} naive_t;

/* An edge on the page, and the depths of its ends. */
typedef struct edge {
    float x[2], y[2], depth[2];
} edge_t;

static bool look(const naive_t *n, int family, int line, int k, edge_t *e) {
    const surface_ref_t *r = &n->s->ref;
    exact_point_t end[2];
    if (!surface_ref_edge_exists(r, family, line, k)) return false;
    surface_ref_edge_ends(r, family, line, k, end);
    for (int i = 0; i < 2; i++) {
        const double *m = n->s->view.m[2];
        double x, y;
        if (!page_view_point(&n->s->view, end[i], &x, &y)) return false;
        e->x[i] = (float)x, e->y[i] = (float)y;
        e->depth[i] = (float)(m[0] * end[i].x + m[1] * end[i].y + m[2] * end[i].z + m[3]);
    }
    return true;
}

static float column_of(const naive_t *n, float x) {
    return (x - n->x0) / n->width * NAIVE_COLUMNS;
}

/* From a fraction on the page to one in space. */
static double in_space(const edge_t *e, double u) {
    double a = u * (double)e->depth[0], b = (1 - u) * (double)e->depth[1];
    return fmin(1, fmax(0, a + b > 0 ? a / (a + b) : u));
}

static void emit(const naive_t *n, int family, int line, int k, double from, double to) {
    ink_piece_t p = {.family = family == REF_ROW ? INK_ROW : INK_COL, .line = line};
    p.from = k * INK_GRID_ONE + (int64_t)(from * (double)INK_GRID_ONE);
    p.to = k * INK_GRID_ONE + (int64_t)(to * (double)INK_GRID_ONE);
    if (p.from < p.to) n->sink->piece(n->sink->ctx, &p);
}

/* Walks the columns of an edge: emits what is outside of the horizons, or raises them. */
static void walk(naive_t *n, int family, int line, int k, bool raise) {
    edge_t e;
    if (!look(n, family, line, k, &e)) return;
    float c0 = column_of(n, e.x[0]), c1 = column_of(n, e.x[1]);
    int lo = (int)floorf(fminf(c0, c1)), hi = (int)floorf(fmaxf(c0, c1));
    float run = c1 - c0;
    double from = -1;
    const bool forward = run >= 0;
    for (int step = 0; step <= hi - lo; step++) {
        int c = forward ? lo + step : hi - step;
        if (c < 0 || c >= NAIVE_COLUMNS) continue;
        float at = fabsf(run) < 1e-6f ? .5f : ((float)c + .5f - c0) / run;
        at = fminf(1, fmaxf(0, at));
        float y = e.y[0] + at * (e.y[1] - e.y[0]);
        if (raise) {
            float y0 = lo == hi ? fminf(e.y[0], e.y[1]) : y, y1 = lo == hi ? fmaxf(e.y[0], e.y[1]) : y;
            n->top[c] = fmaxf(n->top[c], y1), n->bottom[c] = fminf(n->bottom[c], y0);
            continue;
        }
        bool visible = y >= n->top[c] - EPSILON || y <= n->bottom[c] + EPSILON;
        double begin = fabsf(run) < 1e-6f ? 0 : (double)(((float)(forward ? c : c + 1) - c0) / run);
        if (visible && from < 0) from = fmax(0, begin);
        if (!visible && from >= 0) {
            emit(n, family, line, k, in_space(&e, from), in_space(&e, fmin(1, begin)));
            from = -1;
        }
    }
    if (!raise && from >= 0) emit(n, family, line, k, in_space(&e, from), 1);
}

void naive_draw(const scene_t *s, run_drawing_t *d) {
    const surface_ref_t *r = &s->ref;
    ink_sink_t sink = run_sink(d);
    naive_t *n = malloc(sizeof *n);
    if (!n) abort();
    *n = (naive_t){.s = s, .sink = &sink, .x0 = (float)s->view.x0, .width = (float)(s->view.x1 - s->view.x0)};
    for (int c = 0; c < NAIVE_COLUMNS; c++) n->top[c] = -INFINITY, n->bottom[c] = INFINITY;
    const double middle = (r->y[0] + r->y[r->ny - 1]) / 2;
    const bool down = r->eye.h ? r->eye.y > middle : r->eye.y > 0;
    for (int step = 0; step < r->ny; step++) {
        int j = down ? r->ny - 1 - step : step, cell = down ? j - 1 : j;
        for (int pass = 0; pass < 2; pass++)
            for (int i = 0; i < r->nx - 1; i++) walk(n, REF_ROW, j, i, pass);
        if (step == r->ny - 1) break;
        for (int pass = 0; pass < 2; pass++)
            for (int i = 0; i < r->nx; i++) walk(n, REF_COL, i, cell, pass);
    }
    free(n);
}
