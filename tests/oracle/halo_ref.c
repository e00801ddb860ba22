/* halo_ref.c - see halo_ref.h. */
#include "tests/oracle/halo_ref.h"

#include <gmp.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef long double real;

typedef struct interval {
    double from, to;
    bool open; /* either answer is right */
} interval_t;

static int by_from(const void *a, const void *b) {
    const interval_t *x = a, *y = b;
    return (x->from > y->from) - (x->from < y->from);
}

/* The part of far within the halo of near. */
static bool clip(const halo_edge_t *far, const halo_edge_t *near, real width, interval_t *out) {
    const real dx = (real)far->q.x - far->p.x, dy = (real)far->q.y - far->p.y;
    real ux = (real)near->q.x - near->p.x, uy = (real)near->q.y - near->p.y, length = hypotl(ux, uy);
    if (length == 0) { /* a disc, taken as the square that lies along the other edge */
        const real l = hypotl(dx, dy);
        ux = l > 0 ? dx / l : 1;
        uy = l > 0 ? dy / l : 0;
    } else {
        ux /= length;
        uy /= length;
    }
    const real x = (real)far->p.x - near->p.x, y = (real)far->p.y - near->p.y;
    const real along = x * ux + y * uy, beside = y * ux - x * uy;
    const real by = dx * ux + dy * uy, across = dy * ux - dx * uy;
    /* value at p, change, largest allowed: a + b t <= most */
    const real side[4][3] = {
        {beside, across, width}, {-beside, -across, width}, {along, by, length + width}, {-along, -by, width}};
    real t0 = 0, t1 = 1;
    for (int k = 0; k < 4; k++) {
        const real a = side[k][2] - side[k][0], b = side[k][1];
        if (fabsl(b) < 1e-9L) {
            if (a < 0) return false;
        } else if (b > 0) {
            if (a / b < t1) t1 = a / b;
        } else if (a / b > t0) {
            t0 = a / b;
        }
    }
    *out = (interval_t){(double)t0, (double)t1, false};
    return t0 <= t1;
}

static void set_cross(mpz_t out, int64_t ax, int64_t ay, int64_t bx, int64_t by) {
    mpz_t t;
    mpz_init_set_si(t, ay);
    mpz_mul_si(t, t, bx);
    mpz_set_si(out, ax);
    mpz_mul_si(out, out, by);
    mpz_sub(out, out, t);
    mpz_clear(t);
}

enum meeting { APART, CONTACT, A_NEARER, B_NEARER, PARALLEL };

static real changes(const halo_edge_t *e) {
    return fabsl((real)e->q.x - e->p.x) + fabsl((real)e->q.y - e->p.y);
}

/* How two edges meet: the common point, if there is just one, and their depths there. */
static enum meeting meet(const halo_edge_t *a, const halo_edge_t *b, int32_t contact) {
    mpz_t of, on_a, on_b;
    mpq_t s, t, za, zb, slack;
    enum meeting m = APART;
    mpz_inits(of, on_a, on_b, NULL);
    mpq_inits(s, t, za, zb, slack, NULL);
    const int64_t ax = (int64_t)a->q.x - a->p.x, ay = (int64_t)a->q.y - a->p.y, bx = (int64_t)b->q.x - b->p.x;
    const int64_t by = (int64_t)b->q.y - b->p.y, x = (int64_t)b->p.x - a->p.x, y = (int64_t)b->p.y - a->p.y;
    set_cross(of, ax, ay, bx, by);
    if (mpz_sgn(of) == 0) {
        m = PARALLEL;
    } else {
        set_cross(on_a, x, y, bx, by);
        set_cross(on_b, x, y, ax, ay);
        mpq_set_num(s, on_a), mpq_set_den(s, of), mpq_canonicalize(s);
        mpq_set_num(t, on_b), mpq_set_den(t, of), mpq_canonicalize(t);
        if (mpq_sgn(s) >= 0 && mpq_cmp_si(s, 1, 1) <= 0 && mpq_sgn(t) >= 0 && mpq_cmp_si(t, 1, 1) <= 0) {
            mpq_set_si(slack, (int64_t)a->q.z - a->p.z, 1);
            mpq_mul(za, s, slack);
            mpq_set_si(slack, a->p.z, 1);
            mpq_add(za, za, slack);
            mpq_set_si(slack, (int64_t)b->q.z - b->p.z, 1);
            mpq_mul(zb, t, slack);
            mpq_set_si(slack, b->p.z, 1);
            mpq_add(zb, zb, slack);
            mpq_sub(za, za, zb);
            m = mpq_sgn(za) > 0 ? A_NEARER : B_NEARER;
            /* contact: |difference| <= 2 contact (1 + (|dz_a| |d_b| + |dz_b| |d_a|) / |of|) */
            mpq_abs(za, za);
            mpz_abs(of, of);
            mpq_set_num(slack, of), mpz_set_si(mpq_denref(slack), 1);
            mpq_mul(za, za, slack);
            mpz_t sum, term;
            mpz_inits(sum, term, NULL);
            mpz_set_d(term, (double)changes(b)); /* below 2^53 */
            mpz_mul_si(term, term, labs((long)a->q.z - a->p.z));
            mpz_add(sum, of, term);
            mpz_set_d(term, (double)changes(a));
            mpz_mul_si(term, term, labs((long)b->q.z - b->p.z));
            mpz_add(sum, sum, term);
            mpz_mul_ui(sum, sum, 2 * (unsigned long)contact);
            mpq_set_z(slack, sum);
            if (mpq_cmp(za, slack) <= 0) m = CONTACT;
            mpz_clears(sum, term, NULL);
        }
    }
    mpz_clears(of, on_a, on_b, NULL);
    mpq_clears(s, t, za, zb, slack, NULL);
    return m;
}

/* An end of a and the closest point of b. */
typedef struct near_place {
    real distance, ahead, slack; /* z of a minus z of b; by how much it may be off */
    int end_a, end_b;            /* which end it is: 0, 1, or -1 for a place between */
} near_place_t;

static near_place_t place(const halo_edge_t *a, const halo_edge_t *b, int end) {
    const halo_point_t *p = end ? &a->q : &a->p;
    const real dx = (real)b->q.x - b->p.x, dy = (real)b->q.y - b->p.y, dz = (real)b->q.z - b->p.z;
    const real square = dx * dx + dy * dy;
    /* an edge seen end-on counts with its front */
    real t = square > 0 ? (((real)p->x - b->p.x) * dx + ((real)p->y - b->p.y) * dy) / square : dz > 0;
    int end_b = t <= 0 ? 0 : t >= 1 ? 1 : -1;
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    near_place_t n = {hypotl(p->x - (b->p.x + t * dx), p->y - (b->p.y + t * dy)), p->z - (b->p.z + t * dz),
                      3 + fabsl(dz) * 1e-8L, end, end_b};
    return n;
}

static bool same(const halo_point_t *p, const halo_point_t *q) {
    return p->x == q->x && p->y == q->y && p->z == q->z;
}

static bool goes_on(const halo_edge_t *edge, int n, int e, int end) {
    if (end < 0) return false;
    const halo_point_t *p = end ? &edge[e].q : &edge[e].p;
    for (int k = 0; k < n; k++)
        if (k != e && (same(p, &edge[k].p) || same(p, &edge[k].q))) return true;
    return false;
}

/* Do two edges that are not nearly parallel lie in one plane, to the contact? 1 yes, 0 no, -1 too close to say. */
static int one_plane(const halo_edge_t *a, const halo_edge_t *b, int32_t contact) {
    const real ax = (real)a->q.x - a->p.x, ay = (real)a->q.y - a->p.y, az = (real)a->q.z - a->p.z;
    const real bx = (real)b->q.x - b->p.x, by = (real)b->q.y - b->p.y, bz = (real)b->q.z - b->p.z;
    const real x = (real)b->p.x - a->p.x, y = (real)b->p.y - a->p.y, z = (real)b->p.z - a->p.z;
    const real of = fabsl(ax * by - ay * bx),
               volume = fabsl(x * (ay * bz - az * by) + y * (az * bx - ax * bz) + z * (ax * by - ay * bx));
    const real most = 2 * (real)contact * (of + fabsl(az) * changes(b) + fabsl(bz) * changes(a));
    const real lengths = hypotl(ax, ay) * hypotl(bx, by), unsure = 10 + hypotl(ax, ay) + hypotl(bx, by);
    if (of == 0 || 8 * of < lengths - unsure) return 0;
    if (fabsl(volume - most) < 1e-12L * most) return -1;
    if (volume > most) return 0;
    return 8 * of > lengths + unsure ? 1 : -1;
}

/* The gaps of edge f because of edge k, not crossing, by the rule for ends; appended. */
static int near_gap(const halo_edge_t *edge, int n, int f, int k, real width, int32_t contact, interval_t *gap) {
    interval_t g;
    const int plane = one_plane(&edge[f], &edge[k], contact);
    if (plane == 1 || !clip(&edge[f], &edge[k], width, &g)) return 0;
    near_place_t p[4] = {place(&edge[f], &edge[k], 0), place(&edge[f], &edge[k], 1), place(&edge[k], &edge[f], 0),
                         place(&edge[k], &edge[f], 1)};
    real least = INFINITY;
    int yes = 0, no = 0;
    for (int i = 0; i < 4; i++)
        if (p[i].distance < least) least = p[i].distance;
    for (int i = 0; i < 4; i++) {
        /* p[0], p[1]: of the farther edge; ahead is its z minus the other's */
        const real ahead = i < 2 ? p[i].ahead : -p[i].ahead;
        const int end = i < 2 ? p[i].end_b : p[i].end_a;
        if (p[i].distance > least + 2) continue;
        const bool takes = ahead < 0 && !goes_on(edge, n, k, end);
        const bool clear = fabsl(ahead) > 2 * contact + p[i].slack;
        const bool touch = fabsl(ahead) < 2 * contact - p[i].slack;
        yes += !touch && (takes || !clear);
        no += !takes || !clear;
    }
    if (yes == 0) return 0;
    g.open = no > 0 || plane < 0;
    *gap = g;
    return 1;
}

/* The longest stretch of [0, 1] in `in` (n of them) and in none of `out`, times length. */
static double longest_without(const interval_t *in, int n, const interval_t *out, int m) {
    double most = 0;
    for (int i = 0; i < n; i++) {
        double at = in[i].from;
        for (int k = 0; k < m && at < in[i].to; k++) {
            if (out[k].to <= at) continue;
            if (out[k].from >= in[i].to) break;
            if (out[k].from - at > most) most = out[k].from - at;
            at = out[k].to;
        }
        if (in[i].to - at > most) most = in[i].to - at;
    }
    return most;
}

/* Sorts and unites. */
static int unite(interval_t *v, int n) {
    int out = 0;
    if (n > 0) qsort(v, (size_t)n, sizeof *v, by_from);
    for (int i = 0; i < n; i++) {
        if (out > 0 && v[i].from <= v[out - 1].to) {
            if (v[i].to > v[out - 1].to) v[out - 1].to = v[i].to;
        } else {
            v[out++] = v[i];
        }
    }
    return out;
}

halo_ref_report_t halo_ref_judge(const halo_edge_t *edge, int n, int32_t width, bool ends, int32_t contact,
                                 const halo_ref_piece_t *piece, int pieces) {
    halo_ref_report_t r = {.edge = -1};
    const size_t most = (size_t)n + (size_t)pieces + 2;
    interval_t *sure = malloc(most * sizeof *sure), *any = malloc(most * sizeof *any),
               *ink = malloc(most * sizeof *ink);
    for (int f = 0; f < n; f++) {
        const double length = (double)hypotl((real)edge[f].q.x - edge[f].p.x, (real)edge[f].q.y - edge[f].p.y);
        int n_sure = 0, n_any = 0, n_ink = 0;
        for (int k = 0; k < n && width > 0; k++) {
            if (k == f) continue;
            interval_t g;
            const enum meeting m = meet(&edge[f], &edge[k], contact);
            r.contacts += m == CONTACT;
            if (m == B_NEARER) {
                r.crossings++;
                if (!clip(&edge[f], &edge[k], width, &g)) continue;
            } else if (!ends || (m != APART && m != PARALLEL) || !near_gap(edge, n, f, k, width, contact, &g)) {
                continue;
            }
            r.open += g.open;
            any[n_any++] = g;
            if (!g.open) sure[n_sure++] = g;
        }
        for (int i = 0; i < pieces; i++) {
            if (piece[i].edge != f) continue;
            ink[n_ink++] = (interval_t){piece[i].from, piece[i].to, false};
            r.drawn += (piece[i].to - piece[i].from) * length;
        }
        r.whole += length;
        n_sure = unite(sure, n_sure);
        n_any = unite(any, n_any);
        n_ink = unite(ink, n_ink);
        const interval_t all = {0, 1, false};
        /* missing: in [0, 1], in no gap, not drawn */
        interval_t *both = malloc((size_t)(n_any + n_ink + 1) * sizeof *both);
        memcpy(both, any, (size_t)n_any * sizeof *both);
        memcpy(both + n_any, ink, (size_t)n_ink * sizeof *both);
        const int n_both = unite(both, n_any + n_ink);
        double missing = longest_without(&all, 1, both, n_both) * length;
        if (length == 0) missing = n_ink == 0 && n_any == 0 ? 100 : 0;
        /* false: in a gap that is sure, and drawn: the ink without what is outside of gaps */
        int n_free = 0;
        double at = 0;
        interval_t *outside = malloc((size_t)(n_sure + 1) * sizeof *outside);
        for (int k = 0; k < n_sure; k++) {
            if (sure[k].from > at) outside[n_free++] = (interval_t){at, sure[k].from, false};
            if (sure[k].to > at) at = sure[k].to;
        }
        if (at < 1) outside[n_free++] = (interval_t){at, 1, false};
        const double falsely = longest_without(ink, n_ink, outside, n_free) * length;
        const double allowed = 2 + length * width * 0x1p-36 + length * 0x1p-26;
        const double worse = (missing > falsely ? missing : falsely) - allowed;
        if (missing > r.missing) r.missing = missing;
        if (falsely > r.falsely) r.falsely = falsely;
        if (worse > r.beyond) {
            r.beyond = worse;
            r.edge = f;
        }
        free(outside);
        free(both);
    }
    free(ink);
    free(any);
    free(sure);
    return r;
}
