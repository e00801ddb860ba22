/* horizons.c - see horizons.h. */
#include "hidden/surface/horizons.h"

#define ONE_Q30 (INT32_C(1) << 30)

int horizons_init(horizons_t *h, bool upper, bool lower, pencil_t *pool, size_t count, envelope_take_t take,
                  void *ctx) {
    *h = (horizons_t){.has_upper = upper, .has_lower = lower, .take = take, .ctx = ctx};
    return envelope_init(upper ? &h->upper : &h->lower, upper && lower ? &h->lower : NULL, pool, count);
}

void horizons_lend(horizons_t *h, uint16_t *mem, int bits) {
    if (h->has_upper) h->lowest_upper = lowest_make(mem, bits);
    if (h->has_lower) h->lowest_lower = lowest_make(mem + (INT32_C(1) << bits), bits);
}

/* Hands a part on, turned round if the line runs from right to left. */
static int pass_on(horizons_t *h, envelope_part_t part, bool first) {
    if (h->flip) {
        int32_t from = ONE_Q30 - part.to_q30;
        part.to_q30 = ONE_Q30 - part.from_q30;
        part.from_q30 = from;
    }
    return h->take(h->ctx, part, first);
}

static int take_upper(void *ctx, envelope_part_t part, bool first) {
    horizons_t *h = ctx;
    h->whole = part.from_q30 == 0 && part.to_q30 == ONE_Q30 && !first;
    return pass_on(h, part, first);
}

/* What is first at its abscissae has been taken by the upper horizon already, if there is one. */
static int take_lower(void *ctx, envelope_part_t part, bool first) {
    horizons_t *h = ctx;
    return first && h->has_upper ? 0 : pass_on(h, part, first);
}

/* A horizon's limits on both sides of a vertical line as one: the higher one for a line in the eye's own plane, which
 * both sides bound; otherwise the line is on one of them, and rounding does not say on which: the lower one, rather
 * drawn than not. */
static int32_t limit_at(envelope_t *h, pencil_t l, pencil_t r, bool in_plane) {
    const int32_t left = envelope_limits(h, l.a).left, right = envelope_limits(h, r.a).right;
    return in_plane ? pencil_max(left, right) : pencil_min(left, right);
}

/* A vertical line covers an interval of w at one abscissa. */
static int clip_vertical(horizons_t *h, pencil_t l, pencil_t r) {
    int32_t lo = pencil_min(l.w, r.w), hi = pencil_max(l.w, r.w), height = hi - lo;
    int32_t top = h->has_upper ? limit_at(&h->upper, l, r, h->in_plane) : ENVELOPE_LIMIT;
    int32_t bottom = h->has_lower ? -limit_at(&h->lower, l, r, h->in_plane) : -ENVELOPE_LIMIT;
    int32_t from = 0, to = ONE_Q30;
    const bool falling = r.w < l.w;
    if (height == 0) return 0;
    if (h->has_upper && h->has_lower && bottom > top + 2 * ENVELOPE_NOISE)
        top = -ENVELOPE_LIMIT; /* nothing hides it on both sides */
    if (hi > top + ENVELOPE_NOISE) {
        if (top > lo + ENVELOPE_NOISE) from = (int32_t)pencil_fraction((uint32_t)(top - lo), (uint32_t)height);
        int err = pass_on(h,
                          falling ? (envelope_part_t){.to_q30 = ONE_Q30 - from}
                                  : (envelope_part_t){.from_q30 = from, .to_q30 = ONE_Q30},
                          false);
        if (err != 0 || from == 0) return err;
    }
    if (lo < bottom - ENVELOPE_NOISE) {
        if (bottom < hi - ENVELOPE_NOISE) to = (int32_t)pencil_fraction((uint32_t)(bottom - lo), (uint32_t)height);
        return pass_on(h,
                       falling ? (envelope_part_t){.from_q30 = ONE_Q30 - to, .to_q30 = ONE_Q30}
                               : (envelope_part_t){.to_q30 = to},
                       false);
    }
    return 0;
}

int horizons_raise(horizons_t *h, pencil_t l, pencil_t r) {
    int n = h->has_upper ? envelope_clip(&h->upper, l, r, NULL, NULL, &h->count) : 0;
    l.w = -l.w, r.w = -r.w;
    if (n >= 0 && h->has_lower) n = envelope_clip(&h->lower, l, r, NULL, NULL, &h->count);
    return n < 0 ? n : 0;
}

int horizons_look(horizons_t *h, pencil_t p0, pencil_t p1) {
    h->flip = p1.a < p0.a;
    h->whole = false;
    pencil_t l = h->flip ? p1 : p0, r = h->flip ? p0 : p1;
    if (envelope_vertical(l, r)) return clip_vertical(h, l, r);
    int n = h->has_upper ? envelope_look(&h->upper, l, r, take_upper, h, &h->count) : 0;
    if (n < 0 || !h->has_lower || h->whole) return n < 0 ? n : 0;
    l.w = -l.w, r.w = -r.w;
    n = envelope_look(&h->lower, l, r, take_lower, h, &h->count);
    return n < 0 ? n : 0;
}

int horizons_clip(horizons_t *h, pencil_t p0, pencil_t p1) {
    h->flip = p1.a < p0.a;
    h->whole = false;
    pencil_t l = h->flip ? p1 : p0, r = h->flip ? p0 : p1;
    if (envelope_vertical(l, r)) {
        int err = clip_vertical(h, l, r);
        return err != 0 || l.a == r.a ? err : horizons_raise(h, l, r);
    }
    if (l.a == r.a) return 0;
    const int32_t top = pencil_max(l.w, r.w), bottom = pencil_min(l.w, r.w);
    if (h->has_upper && !h->skip_upper && !lowest_hides(&h->lowest_upper, l.a, r.a, top)) {
        int n = envelope_clip(&h->upper, l, r, take_upper, h, &h->count);
        if (n < 0) return n;
    }
    if (!h->has_lower || h->skip_lower || h->whole) return 0;
    if (lowest_hides(&h->lowest_lower, l.a, r.a, -bottom)) return 0;
    l.w = -l.w, r.w = -r.w;
    int n = envelope_clip(&h->lower, l, r, take_lower, h, &h->count);
    return n < 0 ? n : 0;
}
