/* dash.c - see dash.h. */
#include "view/dash.h"

#include "num/ints.h"

#define GAP_LAT (DASH_LAT / 4 * 3)

static int64_t length_lat(page_point_t a, page_point_t b) {
    int64_t dx = (int64_t)a.x_lat - b.x_lat, dy = (int64_t)a.y_lat - b.y_lat;
    return ints_sqrt_u64((uint64_t)(dx * dx) + (uint64_t)(dy * dy));
}

/* The parameter at the part u = num / den of the way on the page from the piece's start to its end. */
static int64_t parameter(const ink_piece_t *p, const page_h_t h[2], int64_t num, int64_t den) {
    /* s = u E0 / (u E0 + (1 - u) E1); E is below 2^35, lengths below 2^27 */
    int64_t a = num * h[0].e, b = (den - num) * h[1].e;
    return p->from + ints_muldiv_round(p->to - p->from, a, a + b);
}

static int dash_piece(void *ctx, const ink_piece_t *p) {
    dash_t *d = ctx;
    const line_space_t *s = &d->lines[p->surface];
    page_h_t h[2];
    if (!s->at(s->ctx, p->family, p->line, p->from, &h[0]) || !s->at(s->ctx, p->family, p->line, p->to, &h[1]))
        return 0;
    if (!s->perspective) h[0].e = h[1].e = 1;
    if (h[0].e <= 0 || h[1].e <= 0) return 0;
    page_h_t from = h[0], to = h[1];
    int64_t length = length_lat(line_space_divide(s, &from), line_space_divide(s, &to));
    int64_t dashes = (length + GAP_LAT) / (DASH_LAT + GAP_LAT);
    if (dashes < 2) return d->next.piece(d->next.ctx, p);
    /* parts of the length in sevenths: a dash is four, a gap three */
    int64_t parts = 7 * dashes - 3;
    for (int64_t k = 0; k < dashes; k++) {
        ink_piece_t dash = *p;
        dash.from = parameter(p, h, 7 * k, parts);
        dash.to = parameter(p, h, 7 * k + 4, parts);
        if (dash.from >= dash.to) continue;
        int err = d->next.piece(d->next.ctx, &dash);
        if (err) return err;
    }
    return 0;
}

ink_sink_t dash_sink(dash_t *d) {
    return (ink_sink_t){d, dash_piece};
}
