/* slab_area.c - see slab_area.h. */
#include "tests/oracle/slab_area.h"

#include <gmp.h>
#include <math.h>
#include <stdlib.h>

typedef struct slab_edge {
    int64_t x0, y0, x1, y1; /* x0 < x1 */
    int poly, up;
} slab_edge_t;

static int collect(const slab_scene_t *s, slab_edge_t **edges) {
    int n = 0, all = 0;
    for (int k = 0; k < s->polys; k++) all += poly_vertices(s->poly[k]);
    slab_edge_t *e = *edges = malloc((size_t)(all + 1) * sizeof *e);
    if (!e) abort();
    for (int k = 0; k < s->polys; k++) {
        const poly_t *p = s->poly[k];
        for (int c = 0, first = 0; c < p->contours; first = p->end[c++])
            for (int i = first; i < p->end[c]; i++) {
                poly_point_t a = p->v[i].at, b = p->v[i + 1 < p->end[c] ? i + 1 : first].at;
                if (a.x < b.x) e[n++] = (slab_edge_t){a.x, a.y, b.x, b.y, k, 1};
                if (a.x > b.x) e[n++] = (slab_edge_t){b.x, b.y, a.x, a.y, k, -1};
            }
    }
    return n;
}

static unsigned bits(const slab_scene_t *s, const int *wind) {
    unsigned in = 0;
    for (int k = 0; k < s->polys; k++) in |= (unsigned)(s->nonzero[k] ? wind[k] != 0 : wind[k] & 1) << k;
    return in;
}

static int by_value(const void *a, const void *b) {
    long double x = *(const long double *)a, y = *(const long double *)b;
    return (x > y) - (x < y);
}

typedef struct slab_hit {
    long double y;
    const slab_edge_t *e;
} slab_hit_t;

double slab_area(const slab_scene_t *s, slab_test_t test, const void *ctx) {
    slab_edge_t *e;
    int n = collect(s, &e), xs = 0;
    long double *x = malloc((size_t)(n * (n + 2) + 1) * sizeof *x), sum = 0;
    slab_hit_t *hit = malloc((size_t)(n + 1) * sizeof *hit);
    if (!x || !hit) abort();
    for (int i = 0; i < n; i++) {
        x[xs++] = e[i].x0;
        x[xs++] = e[i].x1;
        for (int j = 0; j < i; j++) {
            long double ax = e[i].x1 - e[i].x0, ay = e[i].y1 - e[i].y0, bx = e[j].x1 - e[j].x0, by = e[j].y1 - e[j].y0;
            long double den = ax * by - ay * bx, num = (e[j].x0 - e[i].x0) * by - (e[j].y0 - e[i].y0) * bx;
            if (den == 0) continue;
            long double at = e[i].x0 + ax * (num / den);
            if (at > e[i].x0 && at < e[i].x1 && at > e[j].x0 && at < e[j].x1) x[xs++] = at;
        }
    }
    qsort(x, (size_t)xs, sizeof *x, by_value);
    for (int k = 0; k + 1 < xs; k++) {
        long double width = x[k + 1] - x[k], mid = (x[k] + x[k + 1]) / 2;
        int hits = 0, wind[4] = {0};
        if (width <= 0) continue;
        for (int i = 0; i < n; i++)
            if (e[i].x0 < mid && mid < e[i].x1)
                hit[hits++] = (slab_hit_t){
                    e[i].y0 + (e[i].y1 - e[i].y0) * (mid - e[i].x0) / (long double)(e[i].x1 - e[i].x0), &e[i]};
        qsort(hit, (size_t)hits, sizeof *hit, by_value);
        for (int i = 0; i + 1 < hits; i++) {
            wind[hit[i].e->poly] += hit[i].e->up;
            if (test(bits(s, wind), ctx)) sum += width * (hit[i + 1].y - hit[i].y);
        }
    }
    free(e);
    free(x);
    free(hit);
    return (double)sum;
}

/* ---- the same in rationals ---- */

static int by_rational(const void *a, const void *b) {
    return mpq_cmp(*(const mpq_t *)a, *(const mpq_t *)b);
}

typedef struct slab_hit_q {
    mpq_t y;
    const slab_edge_t *e;
} slab_hit_q_t;

static void set_q(mpq_t q, int64_t num, int64_t den) {
    mpq_set_si(q, (long)num, 1);
    if (den == 1) return;
    mpq_t d;
    mpq_init(d);
    mpq_set_si(d, (long)den, 1);
    mpq_div(q, q, d);
    mpq_clear(d);
}

double slab_area_exact(const slab_scene_t *s, slab_test_t test, const void *ctx) {
    slab_edge_t *e;
    int n = collect(s, &e), xs = 0, most = n * (n + 2) + 1;
    mpq_t *x = malloc((size_t)most * sizeof *x), sum, width, mid, t, u;
    slab_hit_q_t *hit = malloc((size_t)(n + 1) * sizeof *hit);
    if (!x || !hit) abort();
    mpq_inits(sum, width, mid, t, u, NULL);
    for (int k = 0; k < most; k++) mpq_init(x[k]);
    for (int i = 0; i <= n; i++) mpq_init(hit[i].y);
    for (int i = 0; i < n; i++) {
        set_q(x[xs++], e[i].x0, 1);
        set_q(x[xs++], e[i].x1, 1);
        for (int j = 0; j < i; j++) {
            int64_t ax = e[i].x1 - e[i].x0, ay = e[i].y1 - e[i].y0, bx = e[j].x1 - e[j].x0, by = e[j].y1 - e[j].y0;
            int64_t den = ax * by - ay * bx, num = (e[j].x0 - e[i].x0) * by - (e[j].y0 - e[i].y0) * bx;
            if (den == 0) continue;
            set_q(t, num, den);
            set_q(u, ax, 1);
            mpq_mul(t, t, u);
            set_q(u, e[i].x0, 1);
            mpq_add(x[xs++], t, u);
        }
    }
    qsort(x, (size_t)xs, sizeof *x, by_rational);
    for (int k = 0; k + 1 < xs; k++) {
        int hits = 0, wind[4] = {0};
        mpq_sub(width, x[k + 1], x[k]);
        if (mpq_sgn(width) == 0) continue;
        mpq_add(mid, x[k], x[k + 1]);
        mpq_div_2exp(mid, mid, 1);
        for (int i = 0; i < n; i++) {
            set_q(t, e[i].x0, 1);
            set_q(u, e[i].x1, 1);
            if (mpq_cmp(t, mid) >= 0 || mpq_cmp(mid, u) >= 0) continue;
            mpq_sub(t, mid, t);
            set_q(u, e[i].y1 - e[i].y0, e[i].x1 - e[i].x0);
            mpq_mul(t, t, u);
            set_q(u, e[i].y0, 1);
            mpq_add(hit[hits].y, t, u);
            hit[hits++].e = &e[i];
        }
        qsort(hit, (size_t)hits, sizeof *hit, by_rational);
        for (int i = 0; i + 1 < hits; i++) {
            wind[hit[i].e->poly] += hit[i].e->up;
            if (!test(bits(s, wind), ctx)) continue;
            mpq_sub(t, hit[i + 1].y, hit[i].y);
            mpq_mul(t, t, width);
            mpq_add(sum, sum, t);
        }
    }
    double area = mpq_get_d(sum);
    for (int k = 0; k < most; k++) mpq_clear(x[k]);
    for (int i = 0; i <= n; i++) mpq_clear(hit[i].y);
    mpq_clears(sum, width, mid, t, u, NULL);
    free(e);
    free(x);
    free(hit);
    return area;
}

double slab_border(const poly_t *p) {
    double sum = 0;
    for (int c = 0, first = 0; c < p->contours; first = p->end[c++])
        for (int i = first; i < p->end[c]; i++) {
            poly_point_t a = p->v[i].at, b = p->v[i + 1 < p->end[c] ? i + 1 : first].at;
            sum += hypot((double)b.x - a.x, (double)b.y - a.y);
        }
    return sum;
}
