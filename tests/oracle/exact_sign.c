/* Two determinants, 2x2 and 3x3, of differences of doubles: long double first, rationals when in doubt.
 *
 * A difference of two doubles is rounded once (2^-64 relative), products and sums a few times more, so an error of
 * 2^-58 times the sum of the absolute terms is a safe bound for both sizes. */
#include "tests/oracle/exact_sign.h"

#include <gmp.h>
#include <math.h>

#define DOUBT 0x1p-58L

/* Entries are differences a - b, so that the rational path starts from what was given. */
typedef struct entry {
    double a, b;
} entry_t;

static long double value(entry_t e) {
    return (long double)e.a - (long double)e.b;
}

static void exact_entry(mpq_t r, entry_t e) {
    mpq_t b;
    mpq_init(b);
    mpq_set_d(r, e.a);
    mpq_set_d(b, e.b);
    mpq_sub(r, r, b);
    mpq_clear(b);
}

static long double to_long_double(mpq_t r) {
    double hi = mpq_get_d(r);
    if (hi == 0 && mpq_sgn(r) != 0) return mpq_sgn(r) > 0 ? 0x1p-16000L : -0x1p-16000L;
    mpq_t h;
    mpq_init(h);
    mpq_set_d(h, hi);
    mpq_sub(r, r, h);
    long double v = (long double)hi + (long double)mpq_get_d(r);
    mpq_clear(h);
    return v;
}

/* m[0] m[3] - m[1] m[2] */
static void det2_exact(mpq_t out, mpq_t *m) {
    mpq_t t;
    mpq_init(t);
    mpq_mul(out, m[0], m[3]);
    mpq_mul(t, m[1], m[2]);
    mpq_sub(out, out, t);
    mpq_clear(t);
}

static long double det2(const entry_t e[4]) {
    long double p = value(e[0]) * value(e[3]), q = value(e[1]) * value(e[2]), d = p - q;
    if (fabsl(d) > DOUBT * (fabsl(p) + fabsl(q))) return d;
    if (p == 0 && q == 0) return 0;
    mpq_t m[4], r;
    for (int i = 0; i < 4; i++) mpq_init(m[i]), exact_entry(m[i], e[i]);
    mpq_init(r);
    det2_exact(r, m);
    d = to_long_double(r);
    for (int i = 0; i < 4; i++) mpq_clear(m[i]);
    mpq_clear(r);
    return d;
}

static long double det3_exact(const entry_t e[9]) {
    mpq_t m[9], minor[4], r, sum;
    for (int i = 0; i < 9; i++) mpq_init(m[i]), exact_entry(m[i], e[i]);
    for (int i = 0; i < 4; i++) mpq_init(minor[i]);
    mpq_init(r);
    mpq_init(sum);
    for (int c = 0; c < 3; c++) { /* along the first row; the cyclic minors carry their own signs */
        int u = (c + 1) % 3, v = (c + 2) % 3;
        mpq_set(minor[0], m[3 + u]);
        mpq_set(minor[1], m[3 + v]);
        mpq_set(minor[2], m[6 + u]);
        mpq_set(minor[3], m[6 + v]);
        det2_exact(r, minor);
        mpq_mul(r, r, m[c]);
        mpq_add(sum, sum, r);
    }
    long double d = to_long_double(sum);
    for (int i = 0; i < 9; i++) mpq_clear(m[i]);
    for (int i = 0; i < 4; i++) mpq_clear(minor[i]);
    mpq_clear(r);
    mpq_clear(sum);
    return d;
}

static long double det3(const entry_t e[9]) {
    long double m[9], d = 0, mag = 0;
    for (int i = 0; i < 9; i++) m[i] = value(e[i]);
    for (int c = 0; c < 3; c++) {
        int u = (c + 1) % 3, v = (c + 2) % 3;
        long double p = m[3 + u] * m[6 + v], q = m[3 + v] * m[6 + u];
        d += m[c] * (p - q);
        mag += fabsl(m[c]) * (fabsl(p) + fabsl(q));
    }
    if (fabsl(d) > DOUBT * mag) return d;
    return mag > 0 ? det3_exact(e) : 0;
}

static entry_t sub(double a, double b) {
    return (entry_t){a, b};
}

long double exact_side(const exact_eye_t *e, const exact_point_t *p, const exact_point_t *q) {
    if (e->h) {
        entry_t m[4] = {sub(p->x, e->x), sub(p->y, e->y), sub(q->x, e->x), sub(q->y, e->y)};
        return det2(m);
    }
    /* The eye at s times the direction, s to infinity: the leading term is (q - p) x direction. */
    entry_t m[4] = {sub(q->x, p->x), sub(q->y, p->y), sub(e->x, 0), sub(e->y, 0)};
    return det2(m);
}

long double exact_left(const exact_point_t *p, const exact_point_t *q, const exact_point_t *r) {
    entry_t m[4] = {sub(q->x, p->x), sub(q->y, p->y), sub(r->x, p->x), sub(r->y, p->y)};
    return det2(m);
}

long double exact_ahead(const exact_eye_t *e, const exact_point_t *p, const exact_point_t *q) {
    if (!e->h) return 1;
    entry_t m[4] = {sub(p->x, e->x), sub(e->y, p->y), sub(q->y, e->y), sub(q->x, e->x)};
    return det2(m);
}

long double exact_plane(const exact_eye_t *e, const exact_point_t *p, const exact_point_t *q, const exact_point_t *r) {
    if (e->h) {
        entry_t m[9] = {sub(p->x, e->x), sub(p->y, e->y), sub(p->z, e->z), sub(q->x, e->x), sub(q->y, e->y),
                        sub(q->z, e->z), sub(r->x, e->x), sub(r->y, e->y), sub(r->z, e->z)};
        return det3(m);
    }
    /* Leading term again: -direction . ((q - p) x (r - p)). */
    entry_t m[9] = {sub(0, e->x),    sub(0, e->y),    sub(0, e->z),    sub(q->x, p->x), sub(q->y, p->y),
                    sub(q->z, p->z), sub(r->x, p->x), sub(r->y, p->y), sub(r->z, p->z)};
    return det3(m);
}

long double exact_above(const exact_point_t *a, const exact_point_t *b, const exact_point_t *c,
                        const exact_point_t *r) {
    entry_t m[9] = {sub(b->x, a->x), sub(b->y, a->y), sub(b->z, a->z), sub(c->x, a->x), sub(c->y, a->y),
                    sub(c->z, a->z), sub(r->x, a->x), sub(r->y, a->y), sub(r->z, a->z)};
    return det3(m);
}
