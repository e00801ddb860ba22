/* halo_ink.c - see halo_ink.h. */
#include "hidden/halo/halo_ink.h"

#include "error.h"
#include "hidden/halo/halo.h"
#include "num/ints.h"
#include "view/cut.h"
#include <string.h>

/* Moved by less than this on the page, a quarter of a step, everything looks the same: what lies so close that the
 * order depends on it touches. Files with four digits have bars that cross like that. */
#define CONTACT 100

/* An edge on the page: the part of its ink that is left, and what is at its ends. */
typedef struct view {
    ink_piece_t ink;
    page_h_t h[2];
    int32_t depth[2];
} view_t;

typedef struct halo_ink {
    const halo_source_t *source;
    const hidden_job_t *job;
    hidden_stats_t *stats;
    page_window_t window; /* the paper and a halo around it */
    int frac_bits;        /* E of all surfaces in these units: the coarsest */
    int64_t nearest;      /* the least E */
    int32_t edge;         /* whose view is: */
    view_t view;
} halo_ink_t;

static const line_space_t *lines_of(const halo_ink_t *d, const ink_piece_t *ink) {
    return &d->source->lines[ink->surface];
}

static bool is_perspective(const halo_ink_t *d) {
    return d->source->lines[0].perspective;
}

static int64_t depth_e(const halo_ink_t *d, const view_t *v, int end) {
    const int64_t e = v->h[end].e >> (lines_of(d, &v->ink)->frac_bits - d->frac_bits);
    return e > 0 ? e : 1;
}

/* What is left of edge e within the window; false if nothing. */
static bool see(const halo_ink_t *d, int32_t e, view_t *v) {
    if (!d->source->edge(d->source->ctx, e, &v->ink, v->h, v->depth)) return false;
    const line_space_t *s = lines_of(d, &v->ink);
    const int64_t start = v->ink.from;
    const int64_t one = ink_one(v->ink.family);
    int64_t from = 0, to = one;
    if (!cut_between(s, &d->window, &v->h[0], &v->h[1], &from, &to)) return false;
    const page_h_t h0 = v->h[0], h1 = v->h[1];
    const int64_t deep = (int64_t)v->depth[1] - v->depth[0];
    v->ink.to = start + to;
    if (to < one) {
        v->h[1] = line_space_between(v->ink.family, &h0, &h1, to);
        v->depth[1] = v->depth[0] + (int32_t)ints_muldiv_round(deep, to, one);
    }
    v->ink.from = start + from;
    if (from > 0) {
        v->h[0] = line_space_between(v->ink.family, &h0, &h1, from);
        v->depth[0] += (int32_t)ints_muldiv_round(deep, from, one);
    }
    return v->h[0].e > 0 && v->h[1].e > 0;
}

static halo_point_t point_of(const halo_ink_t *d, const view_t *v, int end) {
    const page_point_t p = line_space_divide(lines_of(d, &v->ink), &v->h[end]);
    int64_t z = v->depth[end];
    if (is_perspective(d)) {
        z = ints_muldiv_round(d->nearest, HALO_INK_DEPTH, depth_e(d, v, end));
        if (z > HALO_INK_DEPTH) z = HALO_INK_DEPTH;
    }
    return (halo_point_t){p.x_lat, p.y_lat, (int32_t)z};
}

/* From a part of the way on the page to the parameter in space. */
static int64_t in_space(const halo_ink_t *d, const view_t *v, uint32_t u_q30) {
    const int64_t way = v->ink.to - v->ink.from;
    if (u_q30 == INK_ONE) return v->ink.to;
    if (is_perspective(d))
        return v->ink.from + line_space_share(u_q30, INK_ONE - (int64_t)u_q30, v->h[0].e, v->h[1].e, way);
    return v->ink.from + ints_muldiv_round(way, u_q30, INK_ONE);
}

static int take(void *ctx, int32_t edge, uint32_t from_q30, uint32_t to_q30) {
    halo_ink_t *d = ctx;
    if (edge != d->edge) see(d, edge, &d->view);
    d->edge = edge;
    ink_piece_t p = d->view.ink;
    p.from = in_space(d, &d->view, from_q30);
    p.to = in_space(d, &d->view, to_q30);
    if (p.from >= p.to) return 0;
    d->stats->pieces++;
    return d->job->sink->piece(d->job->sink->ctx, &p);
}

static void tell(const hidden_job_t *job, int32_t done, int32_t of) {
    if (job->tick != NULL) job->tick(job->tick_ctx, done, of);
}

/* The nearest point that is left; its depth decides the scale of all. */
static void find_nearest(halo_ink_t *d) {
    d->nearest = INT64_MAX;
    for (int32_t e = 0; e < d->source->edges; e++) {
        if (!see(d, e, &d->view)) continue;
        for (int end = 0; end < 2; end++) {
            const int64_t at = depth_e(d, &d->view, end);
            if (at < d->nearest) d->nearest = at;
        }
    }
}

static size_t bytes_for(int64_t edges, int64_t crossings) {
    return (size_t)(HALO_BYTES_PER_EDGE_LEAST * edges + HALO_BYTES_PER_CROSSING * crossings) + HIDDEN_LENT(halo_ink_t) +
           HIDDEN_LENT(halo_t);
}

size_t halo_ink_needs(int32_t edges, int32_t loose, int32_t bodies) {
    const int64_t of_faces = edges - loose, own = of_faces * (int64_t)ints_sqrt_u64((uint64_t)(of_faces / bodies)) / 5;
    return bytes_for(edges, own + (bodies > 1 ? edges : loose) / 2);
}

/* Edges are dealt into heaps; those of one go to h, as long as there is room. Returns how many there are, *err tells
 * whether there was. */
static int32_t add_heap(halo_ink_t *d, halo_t *h, const hidden_job_t *rest, int32_t heap, int32_t heaps, uint32_t deal,
                        int *err) {
    int32_t n = 0;
    *err = 0;
    halo_init(h, rest->mem, rest->bytes);
    for (int32_t e = 0; e < d->source->edges; e++) {
        if (e % 256 == 0) tell(d->job, 0, 1);
        if ((int32_t)(((uint32_t)e * deal >> 16) * (uint32_t)heaps >> 16) != heap || !see(d, e, &d->view)) continue;
        n++;
        if (*err == 0) *err = halo_add(h, e, point_of(d, &d->view, 0), point_of(d, &d->view, 1));
    }
    return n;
}

#define DEALS 4
#define HEAPS_MOST 4096

/* Edges there is no room for: how often they cross, about. They are dealt at random into heaps that there is room for,
 * and those of each heap cross as often as their share of all pairs. */
static int64_t guess_crossings(halo_ink_t *d, halo_t *h, const hidden_job_t *rest) {
    const size_t each = rest->bytes / HALO_BYTES_PER_EDGE + 1;
    const int32_t heaps = (int32_t)((size_t)d->stats->edges / each) + 2;
    int64_t sum = 0;
    int32_t counted = 0;
    if (heaps > HEAPS_MOST) return d->stats->edges;
    for (int32_t k = 0; k < DEALS * heaps; k++) {
        int err;
        add_heap(d, h, rest, k % heaps, heaps, 0x9e3779b1u + (uint32_t)(k / heaps) * 0x7feb352cu, &err);
        if (err == 0) halo_cut(h, 0);
        if (err != 0 || h->crossings < 0) continue;
        sum += h->crossings;
        counted++;
    }
    return counted == 0 ? d->stats->edges : sum * heaps / counted * heaps;
}

/* All but drawing, apart from it for the stack. */
static __attribute__((noinline)) int find_crossings(halo_ink_t *d, halo_t *h, int32_t width, bool ends,
                                                    const hidden_job_t *rest) {
    const halo_source_t *source = d->source;
    const hidden_job_t *job = d->job;
    hidden_stats_t *stats = d->stats;
    const page_window_t *w = source->lines[0].window;
    d->window = (page_window_t){w->x0_lat - width, w->y0_lat - width, w->x1_lat + width, w->y1_lat + width};
    d->frac_bits = INT32_MAX;
    for (int32_t k = 0; k < source->surfaces; k++) {
        if (source->lines[k].frac_bits < d->frac_bits) d->frac_bits = source->lines[k].frac_bits;
    }
    if (is_perspective(d)) find_nearest(d);
    int err;
    stats->edges = add_heap(d, h, rest, 0, 1, 0, &err);
    h->contact = CONTACT;
    h->tick = job->tick;
    h->tick_ctx = job->tick_ctx;
    if (err == 0) err = halo_cut(h, ends ? width : 0);
    stats->tests = h->tests;
    stats->crossings = err == 0 || h->crossings > 0 ? h->crossings : 0;
    stats->bytes = h->used;
    if (err != 0 && h->crossings <= 0) /* it came to the edges, or to their grid */
        stats->bytes = bytes_for(stats->edges, guess_crossings(d, h, rest));
    else
        stats->bytes += HIDDEN_LENT(halo_ink_t) + HIDDEN_LENT(halo_t);
    d->edge = -1;
    return err;
}

int halo_ink_draw(const halo_source_t *source, int32_t width, bool ends, const hidden_job_t *job,
                  hidden_stats_t *stats) {
    *stats = (hidden_stats_t){0};
    if (source->edges == 0) return 0;
    hidden_job_t rest = *job;
    HIDDEN_STATE(halo_ink_t, d, rest);
    HIDDEN_STATE(halo_t, h, rest);
    if (d == NULL || h == NULL) return ERR_FULL;
    memset(d, 0, sizeof *d);
    d->source = source;
    d->job = job;
    d->stats = stats;
    d->edge = -1;
    const halo_sink_t sink = {d, take};
    int err = find_crossings(d, h, width, ends, &rest);
    if (err != 0) return err;
    err = halo_draw(h, width, &sink);
    tell(job, 1, 1);
    return err;
}
