/* Their horizon in floating point: a list of segments, each with the number of the profile segment it was cut from.
 * Merging a profile cuts both at every abscissa where either has a vertex, and at crossings, and keeps the higher. */
#include "tests/report/collapse.h"

#include <math.h>
#include <stdlib.h>

#include "hidden/surface/envelope.h"
#include "tests/oracle/scenes.h"

#define POINTS 60
#define MOST 100000

typedef struct segment {
    double x0, y0, x1, y1;
    int source;
} segment_t;

typedef struct list {
    segment_t *s;
    int n;
} list_t;

static double noise(int i, int j, int octave) {
    uint64_t rng = ((uint64_t)(uint32_t)i << 40) ^ ((uint64_t)(uint32_t)j << 12) ^ (uint64_t)(uint32_t)octave ^ 1988;
    return scene_uniform(&rng);
}

/* The terrain over u, v in [0, 1]. */
static double terrain(double u, double v) {
    double sum = 0, high = .25;
    for (int k = 0, cells = 3; k < 6; k++, cells *= 2, high /= 2) {
        double x = u * cells, y = v * cells;
        int i = (int)x, j = (int)y;
        x -= i, y -= j;
        sum += high * ((1 - y) * ((1 - x) * noise(i, j, k) + x * noise(i + 1, j, k)) +
                       y * ((1 - x) * noise(i, j + 1, k) + x * noise(i + 1, j + 1, k)));
    }
    return sum;
}

/* Point i of profile k in the view. Profiles of a triangulated terrain have their vertices where it has edges, not in
 * columns: each is shifted by a fraction of a cell. */
static void profile_point(int k, int i, double *x, double *y) {
    double shift = i == 0 || i == POINTS - 1 ? 0 : noise(k, 0, 77) - .5;
    double u = (i + shift) / (POINTS - 1), v = k / 60.;
    *x = u;
    *y = terrain(u, v) + .25 * v;
}

static double at(const segment_t *s, double x) {
    return s->y0 + (s->y1 - s->y0) * (x - s->x0) / (s->x1 - s->x0);
}

/* Adds a part of s; with join, to the last one if that was cut from the same segment. */
static void keep(list_t *to, const segment_t *s, double x0, double x1, bool join) {
    segment_t *last = to->n ? &to->s[to->n - 1] : NULL;
    if (x1 <= x0) return;
    if (join && last && last->source == s->source && last->x1 == x0) {
        last->x1 = x1, last->y1 = at(s, x1);
        return;
    }
    if (to->n == MOST) abort();
    to->s[to->n++] = (segment_t){x0, at(s, x0), x1, at(s, x1), s->source};
}

/* The upper envelope of two lists that both cover [0, 1]. */
static void merge(const list_t *a, const list_t *b, list_t *to, bool join) {
    to->n = 0;
    double x = 0;
    for (int i = 0, j = 0; i < a->n && j < b->n;) {
        const segment_t *p = &a->s[i], *q = &b->s[j];
        double end = fmin(p->x1, q->x1), d0 = at(p, x) - at(q, x), d1 = at(p, end) - at(q, end);
        if ((d0 < 0) != (d1 < 0) && d0 != 0 && d1 != 0) {
            double cross = x + (end - x) * d0 / (d0 - d1);
            keep(to, d0 < 0 ? q : p, x, cross, join);
            keep(to, d0 < 0 ? p : q, cross, end, join);
        } else {
            keep(to, d0 + d1 < 0 ? q : p, x, end, join);
        }
        x = end;
        if (p->x1 <= end) i++;
        if (q->x1 <= end) j++;
    }
}

static int after(int profiles, bool join) {
    list_t a = {malloc(MOST * sizeof(segment_t)), 0}, b = {malloc(MOST * sizeof(segment_t)), 0}, p = a;
    p.s = malloc(POINTS * sizeof(segment_t));
    if (!a.s || !b.s || !p.s) abort();
    for (int k = 0; k < profiles; k++) {
        p.n = 0;
        for (int i = 0; i < POINTS - 1; i++) {
            segment_t *s = &p.s[p.n++];
            profile_point(k, i, &s->x0, &s->y0);
            profile_point(k, i + 1, &s->x1, &s->y1);
            s->source = k * POINTS + i;
        }
        if (k == 0) {
            for (int i = 0; i < p.n; i++) a.s[i] = p.s[i];
            a.n = p.n;
            continue;
        }
        merge(&a, &p, &b, join);
        list_t t = a;
        a = b;
        b = t;
    }
    int n = a.n;
    free(a.s);
    free(b.s);
    free(p.s);
    return n;
}

static int ours_after(int profiles) {
    static pencil_t pool[20000];
    envelope_t h;
    envelope_count_t count = {0, 0};
    if (envelope_init(&h, NULL, pool, sizeof pool / sizeof *pool)) abort();
    for (int k = 0; k < profiles; k++)
        for (int i = 0; i < POINTS - 1; i++) {
            double x[2], y[2];
            pencil_t p[2];
            for (int e = 0; e < 2; e++) {
                profile_point(k, i + e, &x[e], &y[e]);
                p[e] = (pencil_t){(int32_t)lrint((x[e] - .5) * 0x1p30), (int32_t)lrint((y[e] - .4) * 0x1p30)};
            }
            if (envelope_clip(&h, p[0], p[1], NULL, NULL, &count) < 0) abort();
        }
    return envelope_size(&h) - 5; /* n pieces have n + 1 vertices; four more carry the floor on both sides */
}

collapse_t collapse_count(int profiles) {
    return (collapse_t){after(profiles, false), after(profiles, true), ours_after(profiles)};
}
