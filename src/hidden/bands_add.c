/* bands_add.c - uniting a cover with gaps and one more facet.
 *
 * The facet becomes trapezoids between the abscissae of its corners. Each is united strip by strip: a strip is read at
 * the right of the gap, cut where the trapezoid's sides cross its bands, and what comes of it written to the left,
 * where it joins the strip before if the two continue each other straight. */
#include "error.h"
#include "hidden/bands_strip.h"

#define CLOSE 3 /* bands whose gap is no wider touch: two roundings of one line, and one more */

static int32_t line_at(const bands_line_t *s, int32_t x) {
    return bands_ordinate(s->p.a, s->p.w, s->q.a, s->q.w, x);
}

/* Does the strip under construction at l, which ends at x1, continue the one before it straight? Then the two become
 * one. */
static void join(bands_t *b, int32_t *l, int32_t x1) {
    const int32_t n = l[1];
    int32_t *before = l - (l > b->base ? BANDS_WORDS(l[-1]) : 0);
    if (before == l || before[1] != n) return;
    for (int32_t k = 0; k < 4 * n; k += 2) {
        const int32_t *u = before + BANDS_HEAD + k, *v = l + BANDS_HEAD + k;
        int32_t middle = bands_ordinate(before[0], u[0], x1, v[1], l[0]);
        if (middle - u[1] > 1 || u[1] - middle > 1 || middle - v[0] > 1 || v[0] - middle > 1) return;
    }
    for (int32_t k = 0; k < 4 * n; k += 2) before[BANDS_HEAD + k + 1] = l[BANDS_HEAD + k + 1];
    b->l = l;
}

/* Appends a strip [x0, x1]: the n bands are at b->l + BANDS_HEAD already. */
static void finish_strip(bands_t *b, int32_t x0, int32_t n, int32_t x1) {
    int32_t *l = b->l;
    l[0] = x0;
    l[1] = n;
    l[BANDS_HEAD + 4 * n] = n;
    b->l = l + BANDS_WORDS(n);
    join(b, l, x1);
}

static inline bool room(const bands_t *b, int32_t n) {
    return b->r - b->l >= BANDS_WORDS(n);
}

static inline void put(bands_t *b, int32_t k, band_t v) {
    int32_t *w = b->l + BANDS_HEAD + 4 * k;
    w[0] = v.lo0, w[1] = v.lo1, w[2] = v.hi0, w[3] = v.hi1;
}

/* Appends the part [x0, x1] of the strip at r as it is. */
static int copy_part(bands_t *b, int32_t x0, int32_t x1) {
    const int32_t n = bands_of(b->r);
    if (x0 >= x1) return 0;
    if (!room(b, n)) return ERR_FULL;
    for (int32_t k = 0; k < n; k++) put(b, k, bands_between(b->r, k, x0, x1));
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
    *at = bands_ordinate(x0, flat[0], x1, flat[1], x);
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
    band_t v = bands_between(r, k, x0, x1);
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
        head.lo1 = tail.lo0 = bands_ordinate(x0, t.lo0, x1, t.lo1, x);
        head.hi1 = tail.hi0 = bands_ordinate(x0, t.hi0, x1, t.hi1, x);
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
    bands_seek(b, x0);
    int err = copy_part(b, b->r[0], x0);
    for (int32_t x = x0; x < x1 && err == 0;) {
        const int32_t stop = pencil_min(bands_end(b->r), x1), whole = bands_end(b->r);
        band_t part = {bands_ordinate(x0, t.lo0, x1, t.lo1, x), bands_ordinate(x0, t.lo0, x1, t.lo1, stop),
                       bands_ordinate(x0, t.hi0, x1, t.hi1, x), bands_ordinate(x0, t.hi0, x1, t.hi1, stop)};
        err = unite_cut(b, x, stop, part);
        if (err == 0 && stop < whole) err = copy_part(b, stop, whole);
        b->r += BANDS_WORDS(bands_of(b->r));
        x = stop;
    }
    b->peak = pencil_max(b->peak, (int32_t)((b->l - b->base) + (b->end - b->r)));
    return err;
}

/* The same less `inset` at the top and the bottom; where nothing is left of an end it is a point. */
static int add_inset(bands_t *b, int32_t x0, int32_t x1, band_t t, int32_t inset) {
    if (inset == 0) return add_trapezoid(b, x0, x1, t);
    const int32_t d0 = pencil_min(inset, (t.hi0 - t.lo0) / 2), d1 = pencil_min(inset, (t.hi1 - t.lo1) / 2);
    if (d0 < inset && d1 < inset) return 0;
    return add_trapezoid(b, x0, x1, (band_t){t.lo0 + d0, t.lo1 + d1, t.hi0 - d0, t.hi1 - d1});
}

int bands_add(bands_t *b, const bands_line_t *line, int32_t n, int below, int32_t inset) {
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
                    int err = add_inset(b, x0, x, (band_t){pencil_min(f0, v0), w, pencil_max(f0, v0), w}, inset);
                    if (err != 0) return err;
                    x0 = x;
                    t = (band_t){w, pencil_min(f1, v1), w, pencil_max(f1, v1)};
                }
            }
        }
        if (found == 1 && below > 0) t.lo0 = t.lo1 = ENVELOPE_FLOOR;
        if (found == 1 && below < 0) t.hi0 = t.hi1 = ENVELOPE_LIMIT;
        if (found == 0 || (found == 1 && below == 0)) continue;
        int err = add_inset(b, x0, x1, t, inset);
        if (err != 0) return err;
    }
    return 0;
}
