/* bands.c - see bands.h. */
#include "hidden/bands.h"

#include "error.h"

#define ONE_Q30 (INT32_C(1) << 30)
#define CLOSE 3 /* bands whose gap is no wider touch: two roundings of one line, and one more */
#define HEAD 2  /* words before a strip's bands */
#define WORDS(n) (HEAD + 4 * (n) + 1)

/* A band between the left and right end of a strip. */
typedef struct band {
    int32_t lo0, lo1, hi0, hi1;
} band_t;

_Static_assert(sizeof(band_t) == 4 * sizeof(int32_t), "a band is four words of a strip");

/* The strip at r: */
static inline int32_t bands_of(const int32_t *r) {
    return r[1];
}
static inline int32_t end_of(const int32_t *r) {
    return r[WORDS(r[1])];
}
static inline band_t band_at(const int32_t *r, int32_t k) {
    const int32_t *v = r + HEAD + 4 * k;
    return (band_t){v[0], v[1], v[2], v[3]};
}

int bands_init(bands_t *b, int32_t narrow, int32_t *pool, size_t words, envelope_take_t take, void *ctx) {
    if (words < 32) return ERR_FULL;
    *b = (bands_t){.narrow = narrow, .base = pool, .l = pool, .end = pool + words, .take = take, .ctx = ctx};
    b->r = b->end - 2 * WORDS(0);
    const int32_t strips[2 * WORDS(0)] = {-ENVELOPE_LIMIT, 0, 0, ENVELOPE_LIMIT, 0, 0};
    for (int k = 0; k < 2 * WORDS(0); k++) b->r[k] = strips[k];
    b->peak = 2 * WORDS(0);
    return 0;
}

static void move_right(bands_t *b) {
    for (int32_t n = WORDS(bands_of(b->r)); n > 0; n--) *b->l++ = *b->r++;
}

static void move_left(bands_t *b) {
    for (int32_t n = WORDS(b->l[-1]); n > 0; n--) *--b->r = *--b->l;
}

/* Moves the gap before the strip that begins at or before a and ends after it. */
static void seek(bands_t *b, int32_t a) {
    while (b->r[0] > a) move_left(b);
    while (end_of(b->r) <= a) move_right(b);
}

/* The ordinate at x of the line from (x0, v0) to (x1, v1), to nearest. */
static int32_t ordinate(int32_t x0, int32_t v0, int32_t x1, int32_t v1, int32_t x) {
    if (x == x0 || v0 == v1) return v0;
    if (x == x1) return v1;
    uint32_t run = (uint32_t)(x1 - x0), rise = v1 < v0 ? (uint32_t)(v0 - v1) : (uint32_t)(v1 - v0);
    int32_t part = (int32_t)(((uint64_t)rise * (uint32_t)(x - x0) + run / 2) / run);
    return v1 < v0 ? v0 - part : v0 + part;
}

static int32_t line_at(const bands_line_t *s, int32_t x) {
    return ordinate(s->p.a, s->p.w, s->q.a, s->q.w, x);
}

/* The part [x0, x1] of the strip at r with its band k. */
static band_t band_between(const int32_t *r, int32_t k, int32_t x0, int32_t x1) {
    const int32_t s0 = r[0], s1 = end_of(r);
    band_t v = band_at(r, k);
    return (band_t){ordinate(s0, v.lo0, s1, v.lo1, x0), ordinate(s0, v.lo0, s1, v.lo1, x1),
                    ordinate(s0, v.hi0, s1, v.hi1, x0), ordinate(s0, v.hi0, s1, v.hi1, x1)};
}

/* --- clipping --- */

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
    const int32_t s0 = r[0], s1 = end_of(r);
    band_t v = band_at(r, k);
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
    seek(b, x);
    for (int32_t k = 0; k < bands_of(b->r); k++) {
        band_t v = band_between(b->r, k, x, x);
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
    seek(b, c.p.a);
    for (const int32_t *r = b->r; r[0] < c.q.a; r += WORDS(bands_of(r))) {
        int err = clip_strip(b, &c, r);
        if (err != 0) return err;
    }
    return c.seen_q30 < ONE_Q30 ? visible_to(b, &c, ONE_Q30) : 0;
}

bool bands_hide(bands_t *b, int32_t a0, int32_t a1, int32_t low, int32_t high) {
    seek(b, a0);
    for (const int32_t *r = b->r; r[0] <= a1; r += WORDS(bands_of(r))) {
        int32_t k = bands_of(r) - 1;
        while (k >= 0) {
            const band_t v = band_at(r, k);
            if (pencil_max(v.lo0, v.lo1) <= low && pencil_min(v.hi0, v.hi1) >= high) break;
            k--;
        }
        if (k < 0) return false;
    }
    return true;
}

/* --- adding --- */

/* Does the strip under construction at l, which ends at x1, continue the one before it straight? Then the two become
 * one. */
static void join(bands_t *b, int32_t *l, int32_t x1) {
    const int32_t n = l[1];
    int32_t *before = l - (l > b->base ? WORDS(l[-1]) : 0);
    if (before == l || before[1] != n) return;
    for (int32_t k = 0; k < 4 * n; k += 2) {
        const int32_t *u = before + HEAD + k, *v = l + HEAD + k;
        int32_t middle = ordinate(before[0], u[0], x1, v[1], l[0]);
        if (middle - u[1] > 1 || u[1] - middle > 1 || middle - v[0] > 1 || v[0] - middle > 1) return;
    }
    for (int32_t k = 0; k < 4 * n; k += 2) before[HEAD + k + 1] = l[HEAD + k + 1];
    b->l = l;
}

/* Appends a strip [x0, x1]: the n bands are at b->l + HEAD already. */
static void finish_strip(bands_t *b, int32_t x0, int32_t n, int32_t x1) {
    int32_t *l = b->l;
    l[0] = x0;
    l[1] = n;
    l[HEAD + 4 * n] = n;
    b->l = l + WORDS(n);
    join(b, l, x1);
}

static inline bool room(const bands_t *b, int32_t n) {
    return b->r - b->l >= WORDS(n);
}

static inline void put(bands_t *b, int32_t k, band_t v) {
    int32_t *w = b->l + HEAD + 4 * k;
    w[0] = v.lo0, w[1] = v.lo1, w[2] = v.hi0, w[3] = v.hi1;
}

/* Appends the part [x0, x1] of the strip at r as it is. */
static int copy_part(bands_t *b, int32_t x0, int32_t x1) {
    const int32_t n = bands_of(b->r);
    if (x0 >= x1) return 0;
    if (!room(b, n)) return ERR_FULL;
    for (int32_t k = 0; k < n; k++) put(b, k, band_between(b->r, k, x0, x1));
    finish_strip(b, x0, n, x1);
    return 0;
}

/* Where two lines cross strictly between x0 and x1, rounded; x1 if they do not. */
static int32_t crossing_before(int32_t x0, int32_t x1, int32_t u0, int32_t u1, int32_t v0, int32_t v1) {
    int64_t d0 = (int64_t)u0 - v0, d1 = (int64_t)u1 - v1;
    if (d0 == 0 || d1 == 0 || (d0 < 0) == (d1 < 0)) return x1;
    uint64_t n = (uint64_t)(d0 < 0 ? -d0 : d0), m = (uint64_t)(d1 < 0 ? -d1 : d1);
    int32_t x = x0 + (int32_t)((n * (uint32_t)(x1 - x0) + (n + m) / 2) / (n + m));
    return x <= x0 ? x1 : x;
}

/* Both lines get the same ordinate at their crossing: that of the flatter one. */
static void meet(int32_t x0, int32_t x1, int32_t x, const int32_t u[2], const int32_t v[2], int32_t *at) {
    int64_t du = (int64_t)u[1] - u[0], dv = (int64_t)v[1] - v[0];
    const int32_t *flat = (du < 0 ? -du : du) <= (dv < 0 ? -dv : dv) ? u : v;
    *at = ordinate(x0, flat[0], x1, flat[1], x);
}

/* Which of two lines that do not cross is higher. */
static inline bool higher(int32_t u0, int32_t u1, int32_t v0, int32_t v1) {
    return (int64_t)u0 + u1 > (int64_t)v0 + v1;
}

/* The boundary that was cut short at a crossing goes on from the common ordinate. */
typedef struct bend {
    int32_t band; /* -1: none */
    bool high;
    int32_t w;
} bend_t;

static band_t bent(const int32_t *r, int32_t k, int32_t x0, int32_t x1, const bend_t *from) {
    band_t v = band_between(r, k, x0, x1);
    if (from->band == k) *(from->high ? &v.hi0 : &v.lo0) = from->w;
    return v;
}

/* Appends [x0, x1] of the strip at r united with the trapezoid t; no lines cross in between. */
static int unite(bands_t *b, int32_t x0, int32_t x1, band_t t, const bend_t *from, const bend_t *to) {
    const int32_t n = bands_of(b->r);
    int32_t out = 0;
    bool placed = false;
    if (!room(b, n + 1)) return ERR_FULL;
    for (int32_t k = 0; k < n; k++) {
        band_t v = bent(b->r, k, x0, x1, from);
        if (to->band == k) *(to->high ? &v.hi1 : &v.lo1) = to->w;
        bool below = higher(t.lo0, t.lo1, v.hi0, v.hi1) && (t.lo0 - v.hi0 > CLOSE || t.lo1 - v.hi1 > CLOSE);
        bool above = higher(v.lo0, v.lo1, t.hi0, t.hi1) && (v.lo0 - t.hi0 > CLOSE || v.lo1 - t.hi1 > CLOSE);
        if (!below && !above) {
            if (higher(t.lo0, t.lo1, v.lo0, v.lo1)) t.lo0 = v.lo0, t.lo1 = v.lo1;
            if (higher(v.hi0, v.hi1, t.hi0, t.hi1)) t.hi0 = v.hi0, t.hi1 = v.hi1;
            continue;
        }
        if (above && !placed) {
            put(b, out++, t);
            placed = true;
        }
        put(b, out++, v);
    }
    if (!placed) put(b, out++, t);
    finish_strip(b, x0, out, x1);
    return 0;
}

/* Unites [x0, x1] of the strip at r with the trapezoid t, cut where its sides cross boundaries of the strip. */
static int unite_cut(bands_t *b, int32_t x0, int32_t x1, band_t t) {
    bend_t from = {.band = -1};
    for (;;) {
        int32_t x = x1;
        bend_t to = {.band = -1};
        bool t_high = false;
        for (int32_t k = 0; k < bands_of(b->r); k++) {
            band_t v = bent(b->r, k, x0, x1, &from);
            for (int side = 0; side < 4; side++) {
                const bool high = side & 1, th = side >> 1;
                const int32_t v2[2] = {high ? v.hi0 : v.lo0, high ? v.hi1 : v.lo1};
                const int32_t t2[2] = {th ? t.hi0 : t.lo0, th ? t.hi1 : t.lo1};
                int32_t c = crossing_before(x0, x1, t2[0], t2[1], v2[0], v2[1]);
                if (c >= x) continue;
                x = c;
                to = (bend_t){.band = k, .high = high};
                t_high = th;
                meet(x0, x1, x, t2, v2, &to.w);
            }
        }
        band_t head = t, tail = t;
        head.lo1 = tail.lo0 = ordinate(x0, t.lo0, x1, t.lo1, x);
        head.hi1 = tail.hi0 = ordinate(x0, t.hi0, x1, t.hi1, x);
        if (to.band >= 0) *(t_high ? &head.hi1 : &head.lo1) = *(t_high ? &tail.hi0 : &tail.lo0) = to.w;
        int err = unite(b, x0, x, head, &from, &to);
        if (err != 0 || x == x1) return err;
        x0 = x;
        t = tail;
        from = to;
    }
}

/* Adds the trapezoid t over [x0, x1]. */
static int add_trapezoid(bands_t *b, int32_t x0, int32_t x1, band_t t) {
    seek(b, x0);
    int err = copy_part(b, b->r[0], x0);
    for (int32_t x = x0; x < x1 && err == 0;) {
        const int32_t stop = pencil_min(end_of(b->r), x1), whole = end_of(b->r);
        band_t part = {ordinate(x0, t.lo0, x1, t.lo1, x), ordinate(x0, t.lo0, x1, t.lo1, stop),
                       ordinate(x0, t.hi0, x1, t.hi1, x), ordinate(x0, t.hi0, x1, t.hi1, stop)};
        err = unite_cut(b, x, stop, part);
        if (err == 0 && stop < whole) err = copy_part(b, stop, whole);
        b->r += WORDS(bands_of(b->r));
        x = stop;
    }
    b->peak = pencil_max(b->peak, (int32_t)((b->l - b->base) + (b->end - b->r)));
    return err;
}

int bands_add(bands_t *b, const bands_line_t *line, int32_t n, int below) {
    int32_t cut[2 * BANDS_LINES], cuts = 0;
    for (int32_t k = 0; k < n; k++) { /* sorted insertion: there are few */
        for (int e = 0; e < 2; e++) {
            int32_t a = e ? line[k].q.a : line[k].p.a, at = cuts;
            while (at > 0 && cut[at - 1] >= a) at--;
            if (at < cuts && cut[at] == a) continue;
            for (int32_t m = cuts++; m > at; m--) cut[m] = cut[m - 1];
            cut[at] = a;
        }
    }
    for (int32_t c = 0; c + 1 < cuts; c++) {
        int32_t x0 = cut[c], x1 = cut[c + 1], found = 0;
        band_t t = {0, 0, 0, 0};
        const bands_line_t *first = NULL;
        for (int32_t k = 0; k < n; k++) {
            if (line[k].p.a > x0 || line[k].q.a < x1) continue;
            int32_t v0 = line_at(&line[k], x0), v1 = line_at(&line[k], x1);
            if (found++ == 0) {
                t = (band_t){v0, v1, v0, v1};
                first = &line[k];
            } else {
                t = (band_t){pencil_min(t.lo0, v0), pencil_min(t.lo1, v1), pencil_max(t.hi0, v0),
                             pencil_max(t.hi1, v1)};
                int32_t f0 = line_at(first, x0), f1 = line_at(first, x1);
                int32_t x = crossing_before(x0, x1, f0, f1, v0, v1);
                if (found == 2 && x < x1) { /* a twisted facet: two triangles */
                    int32_t w;
                    meet(x0, x1, x, (const int32_t[2]){f0, f1}, (const int32_t[2]){v0, v1}, &w);
                    int err = add_trapezoid(b, x0, x, (band_t){pencil_min(f0, v0), w, pencil_max(f0, v0), w});
                    if (err != 0) return err;
                    x0 = x;
                    t = (band_t){w, pencil_min(f1, v1), w, pencil_max(f1, v1)};
                }
            }
        }
        if (found == 1 && below > 0) t.lo0 = t.lo1 = ENVELOPE_FLOOR;
        if (found == 1 && below < 0) t.hi0 = t.hi1 = ENVELOPE_LIMIT;
        if (found == 0 || (found == 1 && below == 0)) continue;
        int err = add_trapezoid(b, x0, x1, t);
        if (err != 0) return err;
    }
    return 0;
}
