/* page_lines.c - see page_lines.h. Each segment is the axis of its own coordinates: t along, d aside. */
#include "tests/oracle/page_lines.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

void page_lines_add(page_lines_t *l, page_line_t line) {
    if (l->n == l->cap) {
        l->cap = l->cap ? 2 * l->cap : 64;
        l->line = realloc(l->line, l->cap * sizeof *l->line);
        if (!l->line) abort();
    }
    l->line[l->n++] = line;
}

void page_lines_free(page_lines_t *l) {
    free(l->line);
    *l = (page_lines_t){0};
}

static double length(const page_line_t *a) {
    return hypot(a->x1 - a->x0, a->y1 - a->y0);
}

double page_lines_length(const page_lines_t *l) {
    double sum = 0;
    for (size_t k = 0; k < l->n; k++) sum += length(&l->line[k]);
    return sum;
}

/* b from the axis a: t[0] <= t[1]. */
typedef struct seen {
    double t[2], d[2];
} seen_t;

static seen_t look(const page_line_t *a, const page_line_t *b) {
    const double n = length(a), ux = (a->x1 - a->x0) / n, uy = (a->y1 - a->y0) / n;
    const double x[2] = {b->x0 - a->x0, b->x1 - a->x0}, y[2] = {b->y0 - a->y0, b->y1 - a->y0};
    seen_t s;
    for (int k = 0; k < 2; k++) {
        s.t[k] = x[k] * ux + y[k] * uy;
        s.d[k] = y[k] * ux - x[k] * uy;
    }
    if (s.t[0] > s.t[1]) s = (seen_t){{s.t[1], s.t[0]}, {s.d[1], s.d[0]}};
    return s;
}

/* The part of b within `near` of the axis; false if there is none. */
static bool narrow(seen_t *s, double near) {
    double from = 0, to = 1, step = s->d[1] - s->d[0];
    for (int side = -1; side <= 1; side += 2) { /* side * (d0 + u step) <= near */
        double room = near - side * s->d[0], slope = side * step;
        if (slope == 0 && room < 0) return false;
        if (slope > 0) to = fmin(to, room / slope);
        if (slope < 0) from = fmax(from, room / slope);
    }
    if (from >= to) return false;
    const double t = s->t[0], way = s->t[1] - t;
    s->t[0] = t + from * way;
    s->t[1] = t + to * way;
    return true;
}

void page_lines_along(const page_line_t *a, const page_lines_t *by, double near, spans_t *out) {
    const double all = length(a);
    spans_clear(out);
    for (size_t i = 0; i < by->n && all > 0; i++) {
        seen_t s = look(a, &by->line[i]);
        if (s.t[1] < -near || s.t[0] > all + near || !narrow(&s, near)) continue;
        spans_add(out, fmax(0, s.t[0] - near) / all, fmin(all, s.t[1] + near) / all);
    }
    spans_tidy(out);
}

double page_lines_uncovered(const page_lines_t *what, const page_lines_t *by, double near) {
    spans_t covered = {0}, bare = {0};
    double worst = 0;
    for (size_t k = 0; k < what->n; k++) {
        const double all = length(&what->line[k]);
        if (all == 0) continue;
        page_lines_along(&what->line[k], by, near, &covered);
        spans_complement(&covered, 0, 1, &bare);
        for (size_t i = 0; i < bare.n; i++) worst = fmax(worst, all * (double)(bare.s[i].b - bare.s[i].a));
    }
    spans_free(&covered);
    spans_free(&bare);
    return worst;
}

double page_lines_twice(const page_lines_t *p, const page_lines_t *q, double near, double least) {
    double worst = 0;
    for (size_t k = 0; k < p->n; k++) {
        const double all = length(&p->line[k]);
        for (size_t i = 0; i < q->n && all >= least; i++) {
            if ((p == q && i >= k) || length(&q->line[i]) < least) continue;
            seen_t s = look(&p->line[k], &q->line[i]);
            const double lo = fmax(0, s.t[0]), hi = fmin(all, s.t[1]), way = s.t[1] - s.t[0];
            if (hi - lo <= worst || hi - lo < least) continue;
            const double slope = (s.d[1] - s.d[0]) / way;
            if (fabs(s.d[0] + slope * (lo - s.t[0])) > near || fabs(s.d[0] + slope * (hi - s.t[0])) > near) continue;
            worst = hi - lo;
        }
    }
    return worst;
}
