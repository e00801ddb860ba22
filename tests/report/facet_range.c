/* The sweep for an eye beyond both borders, written out plainly on the chart and the envelope of src/: every facet
 * raises both horizons by its far edges, and is counted before it does. */
#include "tests/report/facet_range.h"

#include <math.h>
#include <stdlib.h>

#include "hidden/surface/envelope.h"
#include "tests/oracle/run_kernel.h"
#include "tests/report/lattice.h"
#include "view/chart.h"

#define OCTAVES 11

typedef struct heights {
    int n;
    const double *z;
} heights_t;

typedef struct sweep {
    envelope_t upper, lower;
    envelope_count_t count;
    double sum;
    int most;
} sweep_t;

static double coordinate(int n, int i) {
    return -2 + 4.0 * i / (n - 1);
}
static num_t coordinate_of(void *ctx, int32_t i) {
    return run_num(coordinate(((const heights_t *)ctx)->n, i));
}
static num_t height_of(void *ctx, int32_t i, int32_t j) {
    const heights_t *h = ctx;
    return run_num(h->z[(size_t)j * (size_t)h->n + (size_t)i]);
}

/* A number in [0, 1) for a lattice point. */
static double hash(int32_t i, int32_t j, int32_t octave) {
    uint64_t rng = ((uint64_t)(uint32_t)i << 40) ^ ((uint64_t)(uint32_t)j << 12) ^ (uint64_t)(uint32_t)octave;
    return scene_uniform(&rng);
}

/* Value noise, half as high at twice the frequency: the same surface on every grid. */
static double fractal(double x, double y) {
    double sum = 0, high = 1, cells = 2;
    for (int k = 0; k < OCTAVES; k++, high /= 2, cells *= 2) {
        double u = (x + 2) / 4 * cells, v = (y + 2) / 4 * cells;
        int i = (int)u, j = (int)v;
        u -= i, v -= j;
        sum += high * ((1 - v) * ((1 - u) * hash(i, j, k) + u * hash(i + 1, j, k)) +
                       v * ((1 - u) * hash(i, j + 1, k) + u * hash(i + 1, j + 1, k)));
    }
    return sum;
}

static double *make(enum facet_range_shape shape, int n) {
    double *z = malloc((size_t)n * (size_t)n * sizeof *z), *at = z;
    uint64_t rng = 1982;
    if (!z) abort();
    for (int j = 0; j < n; j++)
        for (int i = 0; i < n; i++) {
            double x = coordinate(n, i), y = coordinate(n, j);
            *at++ = shape == RANGE_SMOOTH   ? exp(-x * x - y * y)
                    : shape == RANGE_RANDOM ? scene_uniform(&rng)
                                            : fractal(x, y);
        }
    return z;
}

static int vertices_within(envelope_t *h, int32_t a0, int32_t a1) {
    int sum = 0;
    envelope_seek(h, a0);
    for (const pencil_t *p = h->r; p->a < a1; p++) sum++;
    return sum;
}

static void raise(sweep_t *s, pencil_t p, pencil_t q) {
    pencil_t l = p.a < q.a ? p : q, r = p.a < q.a ? q : p;
    if (l.a == r.a) return;
    int err = envelope_clip(&s->upper, l, r, NULL, NULL, &s->count);
    l.w = -l.w, r.w = -r.w;
    if (err >= 0) err = envelope_clip(&s->lower, l, r, NULL, NULL, &s->count);
    if (err < 0) abort();
}

/* near and far are rows, i the column that is nearer, from which the facet goes to i - 1. */
static void facet(sweep_t *s, const pencil_t *near, const pencil_t *far, int i) {
    const pencil_t p[4] = {near[i], near[i - 1], far[i], far[i - 1]};
    int32_t lo = p[0].a, hi = p[0].a;
    for (int k = 1; k < 4; k++) lo = p[k].a < lo ? p[k].a : lo, hi = p[k].a > hi ? p[k].a : hi;
    int in = vertices_within(&s->upper, lo, hi) + vertices_within(&s->lower, lo, hi);
    s->sum += in;
    s->most = in > s->most ? in : s->most;
    raise(s, far[i], far[i - 1]);
    raise(s, near[i - 1], far[i - 1]);
}

facet_range_t facet_range_measure(enum facet_range_shape shape, int n) {
    size_t points = (size_t)n * (size_t)n, vertices = (size_t)n * 60 + 1000;
    double *z = make(shape, n);
    int32_t *cache = malloc(points * sizeof *cache);
    pencil_t *row[2] = {malloc((size_t)n * sizeof **row), malloc((size_t)n * sizeof **row)};
    pencil_t *pool = malloc(vertices * sizeof *pool);
    chart_column_t *column = malloc((size_t)n * sizeof *column);
    if (!cache || !row[0] || !row[1] || !pool || !column) abort();
    heights_t h = {n, z};
    surface_t surface = {n, n, &h, coordinate_of, coordinate_of, height_of, NULL, NULL};
    camera_t cam = run_camera(&(exact_eye_t){6, 8, 3, 1});
    grid_t g, *grids[1] = {&g};
    chart_t chart;
    sweep_t s = {0};
    lattice_shift = 0;
    if (grid_measure(&g, &surface, NULL, NULL, cache, NULL, NULL)) abort();
    chart_init(&chart, grids, 1, &cam, column);
    if (envelope_init(&s.upper, &s.lower, pool, vertices)) abort();
    for (int j = n - 1; j >= 0; j--) {
        chart_line_t line = {.at = row[j & 1]};
        chart_row(&chart, &g, j, &line);
        const pencil_t *far = row[j & 1], *near = row[(j + 1) & 1];
        if (j == n - 1) {
            for (int i = n - 1; i > 0; i--) raise(&s, far[i], far[i - 1]);
            continue;
        }
        raise(&s, near[n - 1], far[n - 1]);
        for (int i = n - 1; i > 0; i--) facet(&s, near, far, i);
    }
    double facets = (n - 1.) * (n - 1.);
    facet_range_t out = {s.sum / facets, s.most, s.upper.peak + s.lower.peak};
    free(z);
    free(cache);
    free(row[0]);
    free(row[1]);
    free(pool);
    free(column);
    return out;
}
