/* envelope.h - a horizon: a polyline over the abscissa a of a chart, raised by whatever rises above it.
 *
 *      w |        .-*              *  vertex, 8 bytes, no links: the vertices lie in a gap buffer,
 *        |   *---*   |                two stacks that face each other; the gap is where the last clip ended.
 *        |   |       *-----*       |  two vertices of equal a: a jump
 *        +---*-------------*---- a    the floor is ENVELOPE_FLOOR, below everything
 *
 * A sweep over a surface moves along the horizon by a vertex or two at a time, and so does the gap. The two
 * horizons of a scene share one pool of vertices; the one that runs out of room takes half of the other's. The lower
 * horizon is the same thing with w negated.
 *
 * Bit budget: |a|, |w| < 2^30, so differences take 31 bits and sign, products 62, and an orientation (the difference
 * of two products) 63 and sign. Every sign is exact.
 * Error: a vertex is rounded once, when the crossing that makes it is found, to the nearest lattice point: at most
 * 0.71 units off both lines. A line cut k times along its way ends at most 0.71 k units off. Lines closer than
 * ENVELOPE_NOISE units count as coincident, and what coincides is hidden: whatever was drawn first wins. */
#ifndef ENVELOPE_H
#define ENVELOPE_H

#include "config.h"
#include "view/pencil.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define ENVELOPE_LIMIT ((INT32_C(1) << 30) - 1) /* beyond PENCIL_LIMIT by more than the noise */
#define ENVELOPE_FLOOR (-ENVELOPE_LIMIT)
#define ENVELOPE_NOISE 4 /* two lines through vertices that are a unit off each, and a crossing on each */

/* Memory right below the upper horizon that nobody uses: windows (windows.h) and horizons take of it, and of each
 * other.
 */
typedef struct envelope_spare {
    uint8_t *from, *to;
} envelope_spare_t;

/* A horizon: [base, l) ascending, then the gap, then [r, end) ascending. */
typedef struct envelope {
    pencil_t *base, *l, *r, *end;
    struct envelope *peer;   /* shares the pool, or NULL */
    envelope_spare_t *spare; /* of both, or NULL */
    int32_t peak;            /* most vertices so far */
} envelope_t;

/* An interval of an edge, as fractions of its way in the chart from its left to its right end. */
typedef struct envelope_part {
    int32_t from_q30, to_q30;
} envelope_part_t;

typedef struct envelope_count {
    int64_t tests, crossings;
} envelope_count_t;

/* Takes visible parts from left to right; first: it rose from the floor, nothing has been at these abscissae yet.
 * Returns 0 or an error that ends the clip. (A flag among the fractions would send them through memory, and a processor
 * waits for what is read in larger pieces than it was written.) */
typedef int (*envelope_take_t)(void *ctx, envelope_part_t part, bool first);

/* Makes an empty upper horizon, and a lower one unless lower is NULL, in pool[0..count). count >= 16.
 * Returns 0 or ERR_FULL when count is too small. */
int envelope_init(envelope_t *upper, envelope_t *lower, pencil_t *pool, size_t count);

/* Both horizons may take of `spare`, which ends at the upper one's pool. */
void envelope_lend(envelope_t *upper, envelope_spare_t *spare);
/* The upper horizon gives so many bytes to what it has been lent, or more. False if it has not so many. */
bool envelope_give_back(envelope_t *upper, size_t bytes);

/* Clips the edge p-q, p.a < q.a, against h: gives what is above to take (may be NULL: nobody is interested), and
 * raises h by it. Returns 1 if any of it was above, 0 if none, ERR_FULL, or take's error.
 * Cost: the vertices of h between the end of the last clip and q; two products per sign that comparing does not
 * decide, two divisions per crossing. */
int envelope_clip(envelope_t *h, pencil_t p, pencil_t q, envelope_take_t take, void *ctx, envelope_count_t *count);

/* The same, but h stays as it is. */
int envelope_look(envelope_t *h, pencil_t p, pencil_t q, envelope_take_t take, void *ctx, envelope_count_t *count);

/* The height of h at abscissa a, seen from its left and from its right. */
typedef struct envelope_limits {
    int32_t left, right;
} envelope_limits_t;
envelope_limits_t envelope_limits(envelope_t *h, int32_t a);

/* Where x lies on the edge p-q, measured along its longer side (q30). */
int32_t envelope_fraction_at(pencil_t p, pencil_t q, pencil_t x);

/* Vertices of h, the two that carry the floor included. */
static inline int32_t envelope_size(const envelope_t *h) {
    return (int32_t)((h->l - h->base) + (h->end - h->r));
}

/* Twice the signed area of the triangle o, p, q: positive if q is above the line from o to p (o.a < p.a). */
static inline int64_t envelope_orient(pencil_t o, pencil_t p, pencil_t q) {
    return (int64_t)(p.a - o.a) * (q.w - o.w) - (int64_t)(p.w - o.w) * (q.a - o.a);
}

/* Signed area beyond which a point is off the line p-q by more than noise. */
static inline int64_t envelope_noise(pencil_t p, pencil_t q) {
    return (int64_t)pencil_max(q.a - p.a, pencil_abs(q.w - p.w)) * ENVELOPE_NOISE;
}

/* Is x, p.a <= x.a <= q.a, below (above) the line p-q by more than noise? */
static inline bool envelope_below(pencil_t p, pencil_t q, pencil_t x, envelope_count_t *count) {
    int32_t lo = pencil_min(p.w, q.w), hi = pencil_max(p.w, q.w);
    if (x.w >= hi) return false;
    if (x.w + ENVELOPE_NOISE < lo) return true;
    count->tests++;
    return -envelope_orient(p, q, x) > envelope_noise(p, q);
}

static inline bool envelope_above(pencil_t p, pencil_t q, pencil_t x, envelope_count_t *count) {
    int32_t lo = pencil_min(p.w, q.w), hi = pencil_max(p.w, q.w);
    if (x.w <= lo) return false;
    if (x.w - ENVELOPE_NOISE > hi) return true;
    count->tests++;
    return envelope_orient(p, q, x) > envelope_noise(p, q);
}

/* Is the line p-q vertical, or so nearly that rounding its ends may have turned it over? */
static inline bool envelope_vertical(pencil_t p, pencil_t q) {
    const int32_t run = pencil_abs(q.a - p.a), rise = pencil_abs(q.w - p.w);
    return run <= 2 && rise >> 6 >= run;
}

static inline bool envelope_same(pencil_t p, pencil_t q) {
    return p.a == q.a && p.w == q.w;
}

#define ENVELOPE_NEAR 64 /* vertices, a power of two: the gap goes farther by leaps */

/* Moves the gap farther than that, as envelope_seek does. */
void envelope_leap(envelope_t *h, int32_t a);

static inline bool envelope_is_far(const envelope_t *h, int32_t a) {
    return (h->end - h->r > ENVELOPE_NEAR && h->r[ENVELOPE_NEAR].a <= a) ||
           (h->l - h->base > ENVELOPE_NEAR && h->l[-1 - ENVELOPE_NEAR].a > a);
}

/* Moves the gap so that everything up to and including a is on its left. */
static inline void envelope_seek(envelope_t *h, int32_t a) {
    pencil_t *l = h->l, *r = h->r;
    if (CONFIG_LOWEST && envelope_is_far(h, a)) {
        envelope_leap(h, a);
        return;
    }
    while (r->a <= a) *l++ = *r++;
    while (CONFIG_64BIT && l - h->base > 4 && l[-4].a > a) { /* a sweep goes back by many */
        for (int k = 1; k <= 4; k++) r[-k] = l[-k];
        r -= 4;
        l -= 4;
    }
    while (l[-1].a > a) *--r = *--l;
    h->l = l;
    h->r = r;
}

/* Is everything from abscissa a0 to a1 that is no higher than `top` hidden? (Rather no than wrongly yes.) Cost: a
 * comparison per vertex, up to the first that says no. */
static inline bool envelope_hides(envelope_t *h, int32_t a0, int32_t a1, int32_t top) {
    envelope_seek(h, a0);
    if (h->l[-1].w < top) return false;
    const pencil_t *p = h->r;
    while (p->w >= top) {
        if (p->a >= a1) return true;
        p++;
    }
    return false;
}

/* How low h is from abscissa a0 to a1, or lower: the least of its vertices there and of those on either side. If one of
 * them is below top, that one will do. */
static inline int32_t envelope_lowest(envelope_t *h, int32_t a0, int32_t a1, int32_t top) {
    envelope_seek(h, a0);
    const pencil_t *p = h->r;
    int32_t least = pencil_min(h->l[-1].w, p->w);
    while (p->a < a1 && least >= top) least = pencil_min(least, (++p)->w);
    return least;
}

/* After a look from l.a on: are l, n and r vertices of h, one after the other? */
static inline bool envelope_passes(const envelope_t *h, pencil_t l, pencil_t n, pencil_t r) {
    return envelope_same(h->l[-1], l) && envelope_same(h->r[0], n) && envelope_same(h->r[1], r);
}

/* The common case of a surface that faces the eye: the horizon passes through n between its vertices l and r, and a
 * facet's far chain l-f-r rises above l-n-r everywhere. Then f takes the place of n and nothing else changes. True if
 * so; otherwise only the gap has moved. The sweep's direction says on which side of the gap n is: `ascending` for
 * facets taken in ascending a. Cost: six comparisons of ordinates, at most two orientations; nothing moves. */
static inline bool envelope_advance(envelope_t *h, bool ascending, pencil_t l, pencil_t n, pencil_t r, pencil_t f,
                                    envelope_count_t *count) {
    envelope_seek(h, ascending ? n.a - 1 : n.a);
    const pencil_t *before = h->l - (ascending ? 1 : 2), *after = h->r + (ascending ? 1 : 0);
    const pencil_t *middle = ascending ? h->r : h->l - 1;
    if (!envelope_same(*middle, n) || !envelope_same(*before, l) || !envelope_same(*after, r)) return false;
    if (f.a <= l.a || f.a >= r.a || n.a <= l.a || n.a >= r.a) return false;
    if (f.a < n.a) {
        if (!envelope_above(l, n, f, count) || !envelope_below(f, r, n, count)) return false;
    } else if (f.a > n.a) {
        if (!envelope_above(n, r, f, count) || !envelope_below(l, f, n, count)) return false;
    } else if (f.w <= n.w + ENVELOPE_NOISE) {
        return false;
    }
    if (ascending) {
        *h->l++ = f;
        h->r++;
    } else {
        h->l--;
        *--h->r = f;
    }
    return true;
}

#endif
