/* bands.c - clipping against a cover with gaps. */
#include "error.h"
#include "hidden/bands_strip.h"

#define ONE_Q30 (INT32_C(1) << 30)

int bands_init(bands_t *b, int32_t narrow, int32_t *pool, size_t words, envelope_take_t take, void *ctx) {
    if (words < 32) return ERR_FULL;
    *b = (bands_t){.narrow = narrow, .base = pool, .l = pool, .end = pool + words, .take = take, .ctx = ctx};
    b->r = b->end - 2 * BANDS_WORDS(0);
    const int32_t strips[2 * BANDS_WORDS(0)] = {-ENVELOPE_LIMIT, 0, 0, ENVELOPE_LIMIT, 0, 0};
    for (int k = 0; k < 2 * BANDS_WORDS(0); k++) b->r[k] = strips[k];
    b->peak = 2 * BANDS_WORDS(0);
    return 0;
}

/* One clip: everything before `seen` has been decided. */
typedef struct clip {
    pencil_t p, q;
    int32_t seen_q30;
    int32_t units; /* of the edge's longer side */
    bool flip;
} clip_t;

/* The part [clip->seen, to] is visible; it is given away unless it is noise. */
static int visible_to(bands_t *b, const clip_t *c, int32_t to_q30) {
    int32_t from = c->seen_q30, to = to_q30;
    if (((int64_t)(to - from) * c->units) >> 30 <= ENVELOPE_NOISE && (from != 0 || to != ONE_Q30)) return 0;
    envelope_part_t part = c->flip ? (envelope_part_t){.from_q30 = ONE_Q30 - to, .to_q30 = ONE_Q30 - from}
                                   : (envelope_part_t){.from_q30 = from, .to_q30 = to};
    return b->take(b->ctx, part);
}

static int32_t fraction_of_crossing(bands_t *b, const clip_t *c, pencil_t v, pencil_t w, bool emerges) {
    return envelope_fraction_at(c->p, c->q, envelope_crossing(c->p, c->q, v, w, emerges, &b->count));
}

/* Is the edge above (sign 1), below (-1) the line v-w, seen at the left (right) end of what they share? */
static bool beyond(bands_t *b, const clip_t *c, pencil_t v, pencil_t w, bool right, int sign) {
    pencil_t end = right ? w : v, own = right ? c->q : c->p;
    if (right ? w.a <= c->q.a : v.a >= c->p.a) {
        return sign > 0 ? envelope_below(c->p, c->q, end, &b->count) : envelope_above(c->p, c->q, end, &b->count);
    }
    return sign > 0 ? envelope_above(v, w, own, &b->count) : envelope_below(v, w, own, &b->count);
}

/* The interval of the edge that band k of the strip at r hides; false if none. */
static bool hidden_by(bands_t *b, const clip_t *c, const int32_t *r, int32_t k, int32_t *from, int32_t *to) {
    const int32_t s0 = r[0], s1 = bands_end(r);
    band_t v = bands_at(r, k);
    int32_t high = pencil_max(c->p.w, c->q.w), low = pencil_min(c->p.w, c->q.w);
    if (low > pencil_max(v.hi0, v.hi1) + ENVELOPE_NOISE || high < pencil_min(v.lo0, v.lo1) - ENVELOPE_NOISE)
        return false;
    pencil_t h0 = {s0, v.hi0}, h1 = {s1, v.hi1}, l0 = {s0, v.lo0}, l1 = {s1, v.lo1};
    bool above0 = beyond(b, c, h0, h1, false, 1), above1 = beyond(b, c, h0, h1, true, 1);
    if (above0 && above1) return false;
    bool below0 = beyond(b, c, l0, l1, false, -1), below1 = beyond(b, c, l0, l1, true, -1);
    if (below0 && below1) return false;
    *from = above0         ? fraction_of_crossing(b, c, h0, h1, false)
            : below0       ? fraction_of_crossing(b, c, l0, l1, false)
            : s0 <= c->p.a ? 0
                           : (int32_t)pencil_fraction((uint32_t)(s0 - c->p.a), (uint32_t)(c->q.a - c->p.a));
    *to = above1         ? fraction_of_crossing(b, c, h0, h1, true)
          : below1       ? fraction_of_crossing(b, c, l0, l1, true)
          : s1 >= c->q.a ? ONE_Q30
                         : (int32_t)pencil_fraction((uint32_t)(s1 - c->p.a), (uint32_t)(c->q.a - c->p.a));
    return *from < *to;
}

/* Takes what the strip at r leaves of the edge. The edge crosses the lines of a strip all upward or all downward, so
 * the bands hide intervals in that order. */
static int clip_strip(bands_t *b, clip_t *c, const int32_t *r) {
    const int32_t n = bands_of(r);
    bool down = false;
    if (n > 1) {
        int32_t from = 0, to = 0, first = -1;
        for (int32_t k = 0; k < n; k++) {
            if (!hidden_by(b, c, r, k, &from, &to)) continue;
            down = first >= 0 && from < first;
            if (first >= 0) break;
            first = from;
        }
    }
    for (int32_t i = 0; i < n; i++) {
        int32_t from, to;
        if (!hidden_by(b, c, r, down ? n - 1 - i : i, &from, &to)) continue;
        if (from > c->seen_q30) {
            int err = visible_to(b, c, from);
            if (err != 0) return err;
        }
        c->seen_q30 = pencil_max(c->seen_q30, to);
    }
    return 0;
}

/* Bands at abscissa x of the strip there: raises *w to the top of one that holds it; otherwise lowers *next to the
 * bottom of the first one above it. */
static bool climb(bands_t *b, int32_t x, int32_t *w, int32_t *next) {
    bands_seek(b, x);
    for (int32_t k = 0; k < bands_of(b->r); k++) {
        band_t v = bands_between(b->r, k, x, x);
        if (v.lo0 - ENVELOPE_NOISE > *w) {
            *next = pencil_min(*next, v.lo0);
        } else if (v.hi0 > *w) {
            *w = v.hi0;
            return true;
        }
    }
    return false;
}

/* A vertical edge: hidden where the strip a unit to its left or right hides it. */
static int clip_vertical(bands_t *b, pencil_t p0, pencil_t p1, bool right) {
    const int32_t low = pencil_min(p0.w, p1.w), high = pencil_max(p0.w, p1.w);
    const uint32_t height = (uint32_t)(high - low);
    const int32_t x = right ? pencil_max(p0.a, p1.a) + 1 : pencil_min(p0.a, p1.a) - 1;
    int32_t w = low;
    while (w < high) {
        int32_t next = high;
        if (climb(b, x, &w, &next)) continue;
        if (next - w > ENVELOPE_NOISE) {
            int32_t from = (int32_t)pencil_fraction((uint32_t)(w - low), height);
            int32_t to = next == high ? ONE_Q30 : (int32_t)pencil_fraction((uint32_t)(next - low), height);
            envelope_part_t part = p1.w < p0.w ? (envelope_part_t){.from_q30 = ONE_Q30 - to, .to_q30 = ONE_Q30 - from}
                                               : (envelope_part_t){.from_q30 = from, .to_q30 = to};
            int err = b->take(b->ctx, part);
            if (err != 0) return err;
        }
        w = next + 1;
    }
    return 0;
}

int bands_clip(bands_t *b, pencil_t p0, pencil_t p1, bool right) {
    clip_t c = {.p = p0, .q = p1, .flip = p1.a < p0.a};
    if (c.flip) {
        c.p = p1;
        c.q = p0;
    }
    if (envelope_vertical(p0, p1, b->narrow)) return clip_vertical(b, p0, p1, right);
    if (p0.a == p1.a) return 0; /* a point, all but */
    c.units = pencil_max(c.q.a - c.p.a, c.q.w < c.p.w ? c.p.w - c.q.w : c.q.w - c.p.w);
    bands_seek(b, c.p.a);
    for (const int32_t *r = b->r; r[0] < c.q.a; r += BANDS_WORDS(bands_of(r))) {
        int err = clip_strip(b, &c, r);
        if (err != 0) return err;
    }
    return c.seen_q30 < ONE_Q30 ? visible_to(b, &c, ONE_Q30) : 0;
}

bool bands_hide(bands_t *b, int32_t a0, int32_t a1, int32_t low, int32_t high) {
    bands_seek(b, a0);
    for (const int32_t *r = b->r; r[0] <= a1; r += BANDS_WORDS(bands_of(r))) {
        int32_t k = bands_of(r) - 1;
        while (k >= 0) {
            const band_t v = bands_at(r, k);
            if (pencil_max(v.lo0, v.lo1) <= low && pencil_min(v.hi0, v.hi1) >= high) break;
            k--;
        }
        if (k < 0) return false;
    }
    return true;
}
