/* cut.c - see cut.h. */
#include "view/cut.h"

#include "num/ints.h"

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

/* The part [*from, *to] of one cell's stretch that is inside; false if none is. */
static bool clip_cell(const line_space_t *s, const ink_piece_t *p, int64_t *from, int64_t *to) {
    page_h_t h0, h1;
    if (!s->at(s->ctx, p->family, p->line, *from, &h0)) return false;
    if (!s->at(s->ctx, p->family, p->line, *to, &h1)) return false;
    return cut_between(s, s->window, &h0, &h1, from, to);
}

static int cut_piece(void *ctx, const ink_piece_t *p) {
    cut_t *c = ctx;
    const line_space_t *s = &c->lines[p->surface];
    ink_piece_t out = *p;
    bool open = false;
    for (int64_t at = p->from_q30; at < p->to_q30;) {
        int64_t end = (at & ~(INK_ONE - 1)) + INK_ONE;
        if (end > p->to_q30) end = p->to_q30;
        int64_t from = at, to = end;
        bool some = clip_cell(s, p, &from, &to);
        if (open && (!some || from > at)) {
            int err = c->next.piece(c->next.ctx, &out);
            if (err) return err;
            open = false;
        }
        if (some) {
            if (!open) out.from_q30 = from;
            out.to_q30 = to;
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
