/* Matching segments to edges through a coarse raster of the page, then the judge of pieces for what is missing. */
#include "tests/oracle/judge_seg.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define BESIDE (0.5 * JUDGE_STEP_MM) /* how far from an edge its ink may run */
#define ROUNDED 1e-4                 /* what rounding may turn, mm across */
#define BIN_MM 2.0
#define BINS 512

typedef struct bins {
    int *head; /* BINS * BINS lists of entries */
    int *next, *item;
    int n, cap;
} bins_t;

static int bin_of(double mm) {
    double b = floor(mm / BIN_MM);
    return b < 0 ? 0 : b >= BINS ? BINS - 1 : (int)b;
}

static void put(bins_t *b, int bx, int by, int item) {
    if (b->n == b->cap) {
        b->cap = b->cap ? 2 * b->cap : 4096;
        b->next = realloc(b->next, (size_t)b->cap * sizeof(int));
        b->item = realloc(b->item, (size_t)b->cap * sizeof(int));
        if (!b->next || !b->item) abort();
    }
    b->item[b->n] = item;
    b->next[b->n] = b->head[by * BINS + bx];
    b->head[by * BINS + bx] = b->n++;
}

/* Enters a segment into the bins that samples of it, a half bin apart, fall into. */
static void enter(bins_t *b, const page_seg_t *s, int item) {
    int steps = 1 + (int)(hypot(s->x1 - s->x0, s->y1 - s->y0) / (BIN_MM / 2));
    int last = -1;
    for (int k = 0; k <= steps; k++) {
        int bx = bin_of(s->x0 + (s->x1 - s->x0) * k / steps), by = bin_of(s->y0 + (s->y1 - s->y0) * k / steps);
        if (by * BINS + bx != last) put(b, bx, by, item);
        last = by * BINS + bx;
    }
}

/* The part of segment b that runs beside segment a, as [*f0, *f1] of a's length and [*g0, *g1] of b's. */
static bool beside(const page_seg_t *a, const page_seg_t *b, double *f0, double *f1, double *g0, double *g1) {
    double ux = a->x1 - a->x0, uy = a->y1 - a->y0, len = hypot(ux, uy);
    if (len == 0) return false;
    ux /= len;
    uy /= len;
    double s0 = (b->x0 - a->x0) * ux + (b->y0 - a->y0) * uy, s1 = (b->x1 - a->x0) * ux + (b->y1 - a->y0) * uy;
    double d0 = (b->y0 - a->y0) * ux - (b->x0 - a->x0) * uy, d1 = (b->y1 - a->y0) * ux - (b->x1 - a->x0) * uy;
    /* A piece of a step or less would fit across the strip, too: it must run along. Ends are rounded to the lattice. */
    if (fabs(d1 - d0) > .05 * fabs(s1 - s0) + ROUNDED) return false;
    if (s0 == s1) return false;
    double ga = -s0 / (s1 - s0), gb = (len - s0) / (s1 - s0); /* of b, where a begins and ends */
    *g0 = fmax(0, fmin(ga, gb));
    *g1 = fmin(1, fmax(ga, gb));
    if (!(*g0 < *g1)) return false;
    if (fabs(d0 + *g0 * (d1 - d0)) > BESIDE || fabs(d0 + *g1 * (d1 - d0)) > BESIDE) return false;
    double fa = (s0 + *g0 * (s1 - s0)) / len, fb = (s0 + *g1 * (s1 - s0)) / len;
    *f0 = fmax(0, fmin(fa, fb));
    *f1 = fmin(1, fmax(fa, fb));
    return *f0 < *f1;
}

/* Depth-wise position t in space of the fraction f of a segment's length on the page, and back. */
static double to_space(double f, double e0, double e1) {
    return f * e0 / (e1 + f * (e0 - e1));
}
static double to_page(double t, double e0, double e1) {
    return t * e1 / (e0 + t * (e1 - e0));
}

typedef struct work {
    const judge_subject_t *what;
    const page_view_t *v;
    const page_seg_t *seg;
    bins_t bins;
    spans_t *good; /* per segment: fractions that draw something visible */
    judge_piece_t *piece;
    size_t pieces, cap;
    int *seen; /* last edge that looked at a segment */
    int edge;
} work_t;

static void add_piece(work_t *w, judge_piece_t p) {
    if (w->pieces == w->cap) {
        w->cap = w->cap ? 2 * w->cap : 4096;
        w->piece = realloc(w->piece, w->cap * sizeof *w->piece);
        if (!w->piece) abort();
    }
    w->piece[w->pieces++] = p;
}

/* One edge as it is on the page. */
typedef struct edge_match {
    int family, line, k;
    double t0, t1;   /* the part on the page */
    double depth[2]; /* at its ends */
    page_seg_t on;
    spans_t visible, hidden;
    spans_t maybe; /* what a drawing may show when moved by a step; asked for when needed */
    bool asked;
} edge_match_t;

static double overlap(const spans_t *s, double a, double b) {
    double sum = 0;
    for (size_t n = 0; n < s->n; n++) sum += fmax(0, fmin(b, (double)s->s[n].b) - fmax(a, (double)s->s[n].a));
    return sum;
}

/* Credits segment i with what it draws of the edge, and the edge with the segment. */
static void match_segment(work_t *w, edge_match_t *e, int i) {
    const page_seg_t *s = &w->seg[i];
    double f0, f1, g0, g1;
    if (!beside(&e->on, s, &f0, &f1, &g0, &g1)) return;
    double a = e->t0 + (e->t1 - e->t0) * to_space(f0, e->depth[0], e->depth[1]);
    double b = fmin(1, e->t0 + (e->t1 - e->t0) * to_space(f1, e->depth[0], e->depth[1]));
    double hidden = overlap(&e->hidden, a, b);
    if (hidden > 0 && !e->asked) {
        spans_t visible = {0}, sure = {0};
        judge_edge(w->what, w->v, e->family, e->line, e->k, 1, &visible, &sure);
        spans_complement(&sure, 0, 1, &e->maybe);
        e->asked = true;
        spans_free(&visible);
        spans_free(&sure);
    }
    bool forward = (s->x1 - s->x0) * (e->on.x1 - e->on.x0) + (s->y1 - s->y0) * (e->on.y1 - e->on.y0) > 0;
    for (size_t n = 0; n < e->maybe.n; n++) {
        double p = fmax(a, (double)e->maybe.s[n].a), q = fmin(b, (double)e->maybe.s[n].b);
        if (!(p < q)) continue;
        double fp = to_page((p - e->t0) / (e->t1 - e->t0), e->depth[0], e->depth[1]);
        double fq = to_page((q - e->t0) / (e->t1 - e->t0), e->depth[0], e->depth[1]);
        double gp = (fp - f0) / (f1 - f0), gq = (fq - f0) / (f1 - f0);
        if (forward)
            spans_add(&w->good[i], g0 + gp * (g1 - g0), g0 + gq * (g1 - g0));
        else
            spans_add(&w->good[i], g1 - gq * (g1 - g0), g1 - gp * (g1 - g0));
    }
    /* Ink beside an edge that is mostly hidden is some other line's, but covers what is visible. */
    if (hidden < .5 * (b - a)) {
        add_piece(w, (judge_piece_t){e->family, e->line, e->k + a, e->k + b});
        return;
    }
    for (size_t n = 0; n < e->visible.n; n++) {
        double p = fmax(a, (double)e->visible.s[n].a), q = fmin(b, (double)e->visible.s[n].b);
        if (p < q) add_piece(w, (judge_piece_t){e->family, e->line, e->k + p, e->k + q});
    }
}

static void match_edge(work_t *w, int family, int line, int k) {
    edge_match_t e = {.family = family, .line = line, .k = k};
    exact_point_t end[2], c[2];
    w->what->ends(w->what->ref, family, line, k, end);
    if (!page_view_clip(w->v, end, &e.t0, &e.t1)) return;
    for (int s = 0; s < 2; s++) {
        double t = s ? e.t1 : e.t0;
        c[s] = (exact_point_t){end[0].x + t * (end[1].x - end[0].x), end[0].y + t * (end[1].y - end[0].y),
                               end[0].z + t * (end[1].z - end[0].z)};
        e.depth[s] = w->v->m[2][0] * c[s].x + w->v->m[2][1] * c[s].y + w->v->m[2][2] * c[s].z + w->v->m[2][3];
    }
    if (!page_view_point(w->v, c[0], &e.on.x0, &e.on.y0) || !page_view_point(w->v, c[1], &e.on.x1, &e.on.y1)) return;
    judge_edge(w->what, w->v, family, line, k, 0, &e.visible, &e.hidden);
    spans_complement(&e.hidden, 0, 1, &e.maybe);
    w->edge++;
    int x0 = bin_of(fmin(e.on.x0, e.on.x1) - BIN_MM), x1 = bin_of(fmax(e.on.x0, e.on.x1) + BIN_MM);
    int y0 = bin_of(fmin(e.on.y0, e.on.y1) - BIN_MM), y1 = bin_of(fmax(e.on.y0, e.on.y1) + BIN_MM);
    for (int by = y0; by <= y1; by++)
        for (int bx = x0; bx <= x1; bx++)
            for (int at = w->bins.head[by * BINS + bx]; at >= 0; at = w->bins.next[at]) {
                int i = w->bins.item[at];
                if (w->seen[i] != w->edge) match_segment(w, &e, i);
                w->seen[i] = w->edge;
            }
    spans_free(&e.visible);
    spans_free(&e.hidden);
    spans_free(&e.maybe);
}

void judge_segments(const judge_subject_t *what, const page_view_t *v, const page_seg_t *seg, size_t n,
                    judge_seg_report_t *out) {
    *out = (judge_seg_report_t){0};
    work_t w = {.what = what, .v = v, .seg = seg};
    w.bins.head = malloc(sizeof(int) * BINS * BINS);
    w.good = calloc(n + 1, sizeof *w.good);
    w.seen = calloc(n + 1, sizeof *w.seen);
    if (!w.bins.head || !w.good || !w.seen) abort();
    memset(w.bins.head, 0xff, sizeof(int) * BINS * BINS);
    for (size_t i = 0; i < n; i++) {
        enter(&w.bins, &seg[i], (int)i);
        out->drawn_mm += hypot(seg[i].x1 - seg[i].x0, seg[i].y1 - seg[i].y0);
    }
    for (int family = 0; family < 2; family++)
        for (int line = 0; line < what->lines(what->ref, family); line++)
            for (int k = 0; k < what->edges(what->ref, family, line); k++)
                if (what->exists(what->ref, family, line, k)) match_edge(&w, family, line, k);
    for (size_t i = 0; i < n; i++) {
        spans_t bad = {0};
        double len = hypot(seg[i].x1 - seg[i].x0, seg[i].y1 - seg[i].y0);
        spans_tidy(&w.good[i]);
        spans_complement(&w.good[i], 0, 1, &bad);
        for (size_t k = 0; k < bad.n; k++) {
            double d = len * (double)(bad.s[k].b - bad.s[k].a);
            if (d > JUDGE_STEP_MM) out->false_total_mm += d;
            if (d > out->false_mm) out->false_mm = d, out->false_seg = seg[i];
        }
        spans_free(&bad);
        spans_free(&w.good[i]);
    }
    judge_pieces(what, v, w.piece, w.pieces, &out->pieces);
    free(w.bins.head);
    free(w.bins.next);
    free(w.bins.item);
    free(w.good);
    free(w.seen);
    free(w.piece);
}

page_seg_t *judge_seg_read(const char *name, page_view_t *v, size_t *n) {
    FILE *f = fopen(name, "r");
    char line[1024];
    page_seg_t *seg = NULL;
    size_t cap = 0;
    bool camera = false;
    *n = 0;
    *v = (page_view_t){.x0 = -1e6, .y0 = -1e6, .x1 = 1e6, .y1 = 1e6};
    while (f && fgets(line, sizeof line, f)) {
        double c[12];
        page_seg_t s;
        if (sscanf(line, "# camera %lf %lf %lf %lf %lf %lf %lf %lf %lf %lf %lf %lf", c, c + 1, c + 2, c + 3, c + 4,
                   c + 5, c + 6, c + 7, c + 8, c + 9, c + 10, c + 11) == 12) {
            memcpy(v->m, c, sizeof c);
            camera = true;
        }
        if (sscanf(line, "%lf %lf %lf %lf", &s.x0, &s.y0, &s.x1, &s.y1) != 4) continue;
        if (*n == cap) {
            cap = cap ? 2 * cap : 1024;
            seg = realloc(seg, cap * sizeof *seg);
            if (!seg) abort();
        }
        seg[(*n)++] = s;
    }
    if (f) fclose(f);
    if (!camera) {
        free(seg);
        return NULL;
    }
    v->eye = page_view_eye_of((const double(*)[4])v->m);
    return seg ? seg : calloc(1, sizeof *seg);
}
