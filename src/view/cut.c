/* cut.c - see cut.h. */
#include "view/cut.h"

#include "num/ints.h"

#include <stddef.h>

#define PLANES 5

/* Signed distances to the window's planes; >= 0 is inside. |h| < 2^60 and window * E < 2^60. */
static void distances(const line_space_t *s, const page_window_t *w, const page_h_t *h, int64_t out[PLANES]) {
    out[0] = h->x - w->x0_lat * h->e;
    out[1] = w->x1_lat * h->e - h->x;
    out[2] = h->y - w->y0_lat * h->e;
    out[3] = w->y1_lat * h->e - h->y;
    out[4] = h->e - s->near_e;
}

bool cut_between(const line_space_t *s, const page_window_t *w, const page_h_t *h0, const page_h_t *h1, int64_t *from,
                 int64_t *to) {
    int64_t d0[PLANES], d1[PLANES], a = *from, b = *to, length = b - a;
    distances(s, w, h0, d0);
    distances(s, w, h1, d1);
    for (int k = 0; k < PLANES; k++) {
        if (d0[k] >= 0 && d1[k] >= 0) continue;
        if (d0[k] < 0 && d1[k] < 0) return false;
        /* d0 / (d0 - d1) of the way; halved, the difference of opposite signs fits */
        int64_t n = d0[k] / 2, d = d0[k] / 2 - d1[k] / 2;
        if (d == 0) return false;
        int64_t at = ints_muldiv_round(length, n, d);
        if (d0[k] < 0) {
            if (*from + at + 1 > a) a = *from + at + 1;
        } else if (*from + at - 1 < b) {
            b = *from + at - 1;
        }
    }
    *from = a;
    *to = b;
    return a < b;
}

/* How far a point is inside of plane k. */
static num_t exact_distance(const page_window_t *w, const num_t h[3], int k) {
    const int32_t border[PLANES - 1] = {w->x0_lat, w->x1_lat, w->y0_lat, w->y1_lat};
    if (k == PLANES - 1) return h[2];
    const num_t d = num_sub(h[k / 2], num_mul(num_from_i64(border[k]), h[2]));
    return k & 1 ? num_neg(d) : d;
}

/* clip_cell in scaled integers, for lines that come close to the eye. Not inline: its stack is not the usual case's. */
static __attribute__((noinline)) bool clip_close(const line_space_t *s, const ink_piece_t *p, int64_t *from,
                                                 int64_t *to) {
    num_t h0[3], h1[3];
    int64_t a = *from, b = *to;
    if (!s->exact(s->ctx, p->family, p->line, a, h0) || !s->exact(s->ctx, p->family, p->line, b, h1)) return false;
    for (int k = 0; k < PLANES; k++) {
        const num_t d0 = exact_distance(s->window, h0, k), d1 = exact_distance(s->window, h1, k);
        if (num_sign(d0) >= 0 && num_sign(d1) >= 0) continue;
        if (num_sign(d0) < 0 && num_sign(d1) < 0) return false;
        const num_t part = num_div(d0, num_sub(d0, d1));
        const int64_t at = *from + num_to_fixed(num_mul(num_from_i64(*to - *from), part), 0, NULL);
        if (num_sign(d0) < 0) {
            if (at + 1 > a) a = at + 1;
        } else if (at - 1 < b) {
            b = at - 1;
        }
    }
    *from = a;
    *to = b;
    return a < b;
}

/* The part [*from, *to] of one cell's stretch that is inside; false if none is. */
static __attribute__((noinline)) bool clip_cell(const line_space_t *s, const ink_piece_t *p, int64_t *from,
                                                int64_t *to) {
    page_h_t h0, h1;
    if (!s->at(s->ctx, p->family, p->line, *from, &h0)) return false;
    if (!s->at(s->ctx, p->family, p->line, *to, &h1)) return false;
    if (line_space_is_close(s, h0.e) || line_space_is_close(s, h1.e)) return clip_close(s, p, from, to);
    return cut_between(s, s->window, &h0, &h1, from, to);
}

static int cut_piece(void *ctx, const ink_piece_t *p) {
    cut_t *c = ctx;
    const line_space_t *s = &c->lines[p->surface];
    ink_piece_t out = *p;
    bool open = false;
    for (int64_t at = p->from; at < p->to;) {
        const int64_t end = ink_next(p->family, at, p->to);
        int64_t from = at, to = end;
        bool some = clip_cell(s, p, &from, &to);
        if (open && (!some || from > at)) {
            int err = c->next.piece(c->next.ctx, &out);
            if (err) return err;
            open = false;
        }
        if (some) {
            if (!open) out.from = from;
            out.to = to;
            open = true;
            if (to < end) {
                int err = c->next.piece(c->next.ctx, &out);
                if (err) return err;
                open = false;
            }
        }
        at = end;
    }
    return open ? c->next.piece(c->next.ctx, &out) : 0;
}

ink_sink_t cut_sink(cut_t *c) {
    return (ink_sink_t){c, cut_piece};
}
