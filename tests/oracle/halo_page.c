/* halo_page.c - see halo_page.h. */
#include "tests/oracle/halo_page.h"

#include <math.h>
#include <stdlib.h>

#define NEAR_MM 0.01 /* ink lies on a line */
#define SPARE_MM 0.04
#define STEP_MM 0.25
#define CONTACT_MM (100.0 / 32768)

typedef struct gap {
    double from, to;
    bool sure;
} gap_t;

/* A line on the page: its ends, and w there: greater is nearer, linear between. */
typedef struct flat {
    double x[2], y[2], w[2];
    bool seen;
    gap_t *gap;
    int gaps;
} flat_t;

static double depth(const page_view_t *v, exact_point_t p) {
    if (v->eye.h == 0) return p.x * v->eye.x + p.y * v->eye.y + p.z * v->eye.z;
    return 1 / (v->m[2][0] * p.x + v->m[2][1] * p.y + v->m[2][2] * p.z + v->m[2][3]);
}

static void flatten(const page_view_t *v, const halo_page_line_t *l, double width, flat_t *f) {
    page_view_t wide = *v;
    double t0 = 0, t1 = 1;
    wide.x0 -= width, wide.y0 -= width, wide.x1 += width, wide.y1 += width;
    f->seen = page_view_clip(&wide, l->end, &t0, &t1);
    if (!f->seen) return;
    for (int k = 0; k < 2; k++) {
        const double t = k ? t1 : t0;
        const exact_point_t p = {l->end[0].x + t * (l->end[1].x - l->end[0].x),
                                 l->end[0].y + t * (l->end[1].y - l->end[0].y),
                                 l->end[0].z + t * (l->end[1].z - l->end[0].z)};
        if (!page_view_point(v, p, &f->x[k], &f->y[k])) f->seen = false;
        f->w[k] = depth(v, p);
    }
}

/* The part of far within the halo of near; false if none. */
static bool strip(const flat_t *far, const flat_t *near, double width, gap_t *g) {
    const double dx = far->x[1] - far->x[0], dy = far->y[1] - far->y[0];
    double ux = near->x[1] - near->x[0], uy = near->y[1] - near->y[0];
    const double length = hypot(ux, uy), x = far->x[0] - near->x[0], y = far->y[0] - near->y[0];
    ux /= length, uy /= length;
    const double a[4] = {y * ux - x * uy, x * uy - y * ux, x * ux + y * uy, -x * ux - y * uy};
    const double b[4] = {dy * ux - dx * uy, dx * uy - dy * ux, dx * ux + dy * uy, -dx * ux - dy * uy};
    const double most[4] = {width, width, length + width, width};
    g->from = 0, g->to = 1;
    for (int k = 0; k < 4; k++) {
        if (b[k] > 0) g->to = fmin(g->to, (most[k] - a[k]) / b[k]);
        if (b[k] < 0) g->from = fmax(g->from, (most[k] - a[k]) / b[k]);
        if (b[k] == 0 && a[k] > most[k]) return false;
    }
    return g->from <= g->to;
}

/* What b takes of a. */
static void meet(flat_t *a, const flat_t *b, double width, double deep) {
    const double ax = a->x[1] - a->x[0], ay = a->y[1] - a->y[0], bx = b->x[1] - b->x[0], by = b->y[1] - b->y[0];
    const double la = hypot(ax, ay), lb = hypot(bx, by), of = ax * by - ay * bx, sine = fabs(of) / (la * lb);
    if (la < 1e-3 || lb < 1e-3) return; /* a dot */
    gap_t g = {0, 1, false};
    if (sine < 1e-3) { /* hardly crossing, and if, then for a long way: open where they are close */
        if (strip(a, b, width + .1, &g)) a->gap[a->gaps++] = (gap_t){g.from, g.to, false};
        return;
    }
    const double x = b->x[0] - a->x[0], y = b->y[0] - a->y[0], s = (x * by - y * bx) / of, t = (x * ay - y * ax) / of;
    const double spare = .02 / sine; /* how far the crossing may be off along either */
    if (s < -spare / la || s > 1 + spare / la || t < -spare / lb || t > 1 + spare / lb) return;
    const double wa = a->w[1] - a->w[0], wb = b->w[1] - b->w[0];
    const double behind = b->w[0] + t * wb - a->w[0] - s * wa;
    const double contact = 2 * CONTACT_MM * (fabs(wa) / la + fabs(wb) / lb) * 1.5 / sine + 2e-4 * deep;
    if (behind < -3 * contact) return;
    const bool inside = s * la > spare && (1 - s) * la > spare && t * lb > spare && (1 - t) * lb > spare;
    gap_t wide;
    if (!strip(a, b, width, &g)) return;
    if (behind > 3 * contact && inside && sine > .05) {
        const double less = .02 / sine / la;
        a->gap[a->gaps++] = (gap_t){g.from + less, g.to - less, true};
    }
    if (strip(a, b, width + .02 / sine, &wide)) a->gap[a->gaps++] = (gap_t){wide.from, wide.to, false};
}

static bool in_gap(const flat_t *f, double t, bool sure) {
    for (int k = 0; k < f->gaps; k++)
        if (f->gap[k].sure == sure && t > f->gap[k].from && t < f->gap[k].to) return true;
    return false;
}

/* The distance of a point from a segment; where on it. */
static double distance(double px, double py, double x0, double y0, double x1, double y1, double *t) {
    const double dx = x1 - x0, dy = y1 - y0, square = dx * dx + dy * dy;
    *t = square > 0 ? fmin(1, fmax(0, ((px - x0) * dx + (py - y0) * dy) / square)) : 0;
    return hypot(px - x0 - *t * dx, py - y0 - *t * dy);
}

static bool inked(const halo_page_ink_t *ink, int pieces, double x, double y) {
    double t;
    for (int k = 0; k < pieces; k++)
        if (distance(x, y, ink[k].x0, ink[k].y0, ink[k].x1, ink[k].y1, &t) < NEAR_MM) return true;
    return false;
}

static bool allowed(const flat_t *f, int n, double x, double y) {
    double t;
    for (int k = 0; k < n; k++)
        if (f[k].seen && distance(x, y, f[k].x[0], f[k].y[0], f[k].x[1], f[k].y[1], &t) < NEAR_MM &&
            !in_gap(&f[k], t, true))
            return true;
    return false;
}

halo_page_report_t halo_page_judge(const page_view_t *v, const halo_page_line_t *line, int n, double width,
                                   const halo_page_ink_t *ink, int pieces) {
    halo_page_report_t r = {0};
    flat_t *f = calloc((size_t)n, sizeof *f);
    double low = INFINITY, high = -INFINITY;
    for (int k = 0; k < n; k++) {
        flatten(v, &line[k], width, &f[k]);
        for (int end = 0; end < 2 && f[k].seen; end++) low = fmin(low, f[k].w[end]), high = fmax(high, f[k].w[end]);
    }
    const double deep = v->eye.h == 0 ? high - low : high;
    for (int k = 0; k < n; k++) {
        f[k].gap = malloc((size_t)n * 2 * sizeof *f[k].gap);
        for (int j = 0; j < n && f[k].seen; j++)
            if (j != k && f[j].seen) meet(&f[k], &f[j], width, deep);
    }
    for (int k = 0; k < n; k++) {
        if (!f[k].seen) continue;
        const double dx = f[k].x[1] - f[k].x[0], dy = f[k].y[1] - f[k].y[0], length = hypot(dx, dy);
        double run = 0;
        for (double at = SPARE_MM; at < length - SPARE_MM; at += STEP_MM) {
            const double t = at / length, x = f[k].x[0] + t * dx, y = f[k].y[0] + t * dy;
            if (x < v->x0 + SPARE_MM || x > v->x1 - SPARE_MM || y < v->y0 + SPARE_MM || y > v->y1 - SPARE_MM) continue;
            if (in_gap(&f[k], t, true)) r.gaps_mm += STEP_MM;
            const double spare = SPARE_MM / length;
            if (in_gap(&f[k], t, false) || in_gap(&f[k], t - spare, false) || in_gap(&f[k], t + spare, false)) continue;
            r.checked_mm += STEP_MM;
            run = inked(ink, pieces, x, y) ? 0 : run + STEP_MM;
            if (run > r.missing_mm) r.missing_mm = run, r.x = x, r.y = y;
        }
    }
    for (int k = 0; k < pieces; k++) {
        const double dx = ink[k].x1 - ink[k].x0, dy = ink[k].y1 - ink[k].y0, length = hypot(dx, dy);
        double run = 0;
        for (double at = SPARE_MM; at < length - SPARE_MM; at += STEP_MM) {
            const double x = ink[k].x0 + at / length * dx, y = ink[k].y0 + at / length * dy;
            run = allowed(f, n, x, y) ? 0 : run + STEP_MM;
            if (run > r.false_mm) r.false_mm = run, r.x = x, r.y = y;
        }
    }
    for (int k = 0; k < n; k++) free(f[k].gap);
    free(f);
    return r;
}
