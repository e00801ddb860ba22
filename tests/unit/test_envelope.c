/* The envelope against brute force: visible fractions of random edges, and the horizon's height everywhere. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "error.h"
#include "hidden/surface/horizons.h"
#define DICE_SEED 3
#include "tests/unit/dice.h"

#define EDGES 300
#define SAMPLES 64

typedef struct parts {
    envelope_part_t p[200];
    bool first[200];
    int n;
} parts_t;

static int take(void *ctx, envelope_part_t part, bool first) {
    parts_t *t = ctx;
    assert_true(t->n < 200 && part.from_q30 < part.to_q30);
    t->first[t->n] = first;
    t->p[t->n++] = part;
    return 0;
}

static double at(pencil_t p, pencil_t q, double a) {
    return p.w + ((double)q.w - p.w) * (a - p.a) / ((double)q.a - p.a);
}

/* The highest of the first n edges at a. */
static double top(const pencil_t e[][2], int n, double a) {
    double w = -INFINITY;
    for (int k = 0; k < n; k++) {
        if (a >= e[k][0].a && a <= e[k][1].a) w = fmax(w, at(e[k][0], e[k][1], a));
    }
    return w;
}

/* Lengths: from the whole lattice down to a few thousand units; some edges share a vertex with the one before. */
static void test_random_edges(void **state) {
    (void)state;
    static pencil_t e[EDGES][2], pool[4000];
    int judged = 0;
    for (int round = 0; round < 60; round++) {
        envelope_t h;
        envelope_count_t count = {0, 0};
        const int32_t wide = round % 3 == 0 ? 1 << 30 : round % 3 == 1 ? 1 << 26 : 1 << 20;
        assert_int_equal(envelope_init(&h, NULL, pool, 4000), 0);
        for (int k = 0; k < EDGES; k++) {
            pencil_t p = {below(2 * (PENCIL_LIMIT - wide / 2) - 1) - PENCIL_LIMIT, below(1 << 30) - (1 << 29)};
            if (k > 0 && below(3) == 0) p = e[k - 1][1];
            pencil_t q = {p.a + 1 + below(wide / 2), below(1 << 30) - (1 << 29)};
            if (q.a > PENCIL_LIMIT) q.a = PENCIL_LIMIT, p.a -= p.a == q.a;
            e[k][0] = p, e[k][1] = q;
            parts_t t = {.n = 0};
            int any = envelope_clip(&h, p, q, take, &t, &count);
            assert_true(any >= 0 && (any > 0 || t.n == 0));
            for (int i = 0; i < SAMPLES; i++) {
                double u = (i + 0.5) / SAMPLES, a = p.a + u * ((double)q.a - p.a), w = at(p, q, a);
                double reach = top(e, k, a);
                /* a unit along or across the edge, whichever is worse */
                double slack = 40 * (1 + fabs((double)q.w - p.w) / ((double)q.a - p.a)) + 40;
                if (fabs(w - reach) < 300 * slack) continue;
                bool seen = false;
                for (int m = 0; m < t.n; m++)
                    seen |= u >= ldexp(t.p[m].from_q30, -30) && u <= ldexp(t.p[m].to_q30, -30);
                judged++;
                assert_int_equal(seen, w > reach);
            }
        }
        for (const pencil_t *v = h.base; v < h.l; v++) { /* in order, and no three at one abscissa */
            assert_true(v + 1 >= h.l || v[0].a <= v[1].a);
            assert_true(v + 2 >= h.l || v[0].a < v[2].a);
        }
        assert_true(envelope_size(&h) <= h.peak);
    }
    print_message("# envelope: %d points of %d random edges judged\n", judged, 60 * EDGES);
    assert_true(judged > 500000);
}

/* What coincides with the horizon is hidden, whole or in part, and leaves it as it was. */
static void test_ties(void **state) {
    (void)state;
    pencil_t pool[64];
    envelope_t h;
    envelope_count_t count = {0, 0};
    parts_t t = {.n = 0};
    assert_int_equal(envelope_init(&h, NULL, pool, 64), 0);
    const pencil_t p = {-1000000, 5000}, q = {2000000, 65000}, m = {500000, 35000};
    assert_int_equal(envelope_clip(&h, p, q, take, &t, &count), 1);
    assert_int_equal(t.n, 1);
    assert_true(t.p[0].from_q30 == 0 && t.p[0].to_q30 == 1 << 30 && t.first[0]);
    int32_t size = envelope_size(&h);
    assert_int_equal(envelope_clip(&h, p, q, take, &t, &count), 0);
    assert_int_equal(envelope_clip(&h, p, m, take, &t, &count), 0);
    assert_int_equal(envelope_clip(&h, m, q, take, &t, &count), 0);
    const pencil_t near = {500000, 35000 + ENVELOPE_NOISE - 1};
    assert_int_equal(envelope_clip(&h, p, near, take, &t, &count), 0);
    assert_int_equal(envelope_size(&h), size);
    assert_int_equal(t.n, 1);
    /* Two edges that leave in a vertex: visible from the vertex on, no sliver before. */
    const pencil_t up = {2000000, 900000};
    assert_int_equal(envelope_clip(&h, m, up, take, &t, &count), 1);
    assert_int_equal(t.n, 2);
    assert_true(t.p[1].from_q30 == 0 && t.p[1].to_q30 == 1 << 30 && !t.first[1]);
}

/* A vertical line in the eye's own plane is hidden by what either neighbour reaches, another only by what both do. */
static void test_vertical(void **state) {
    (void)state;
    pencil_t pool[64];
    horizons_t h;
    parts_t t = {.n = 0};
    assert_int_equal(horizons_init(&h, true, true, pool, 64, take, &t), 0);
    assert_int_equal(horizons_clip(&h, (pencil_t){-5000, 100000}, (pencil_t){0, 100000}), 0);
    assert_int_equal(horizons_clip(&h, (pencil_t){0, 100000}, (pencil_t){5000, 100000}), 0);
    t.n = 0;
    assert_int_equal(horizons_clip(&h, (pencil_t){0, 100000}, (pencil_t){0, 200000}), 0);
    assert_int_equal(t.n, 1);
    assert_int_equal(t.p[0].to_q30 - t.p[0].from_q30, 1 << 30);
    assert_int_equal(horizons_clip(&h, (pencil_t){0, 200000}, (pencil_t){-5000, 200000}), 0);
    for (int run = 0; run < 2; run++) {
        t.n = 0;
        assert_int_equal(horizons_clip(&h, (pencil_t){0, 300000}, (pencil_t){run, -100000}), 0);
        assert_int_equal(t.n, 2); /* they meet where the line to the right is */
        assert_true(t.p[0].from_q30 == 0 && t.p[0].to_q30 == 1 << 29);
        assert_true(t.p[1].from_q30 == 1 << 29 && t.p[1].to_q30 == 1 << 30);
    }
    assert_int_equal(horizons_init(&h, true, true, pool, 64, take, &t), 0);
    assert_int_equal(horizons_clip(&h, (pencil_t){-5000, 200000}, (pencil_t){0, 200000}), 0);
    assert_int_equal(horizons_clip(&h, (pencil_t){0, 100000}, (pencil_t){-5000, 100000}), 0);
    t.n = 0;
    h.in_plane = true;
    assert_int_equal(horizons_clip(&h, (pencil_t){0, 300000}, (pencil_t){0, -100000}), 0);
    assert_int_equal(t.n, 2);
    assert_true(t.p[0].from_q30 == 0 && abs(t.p[0].to_q30 - (1 << 28)) < 1000);
    assert_true(t.p[1].to_q30 == 1 << 30 && abs(t.p[1].from_q30 - (1 << 29)) < 1000);
}

/* Every size of pool, the smallest included: it ends with ERR_FULL or it works; neighbours share their room. */
static void test_full(void **state) {
    (void)state;
    int full = 0, fits = 0;
    for (size_t count = 0; count < 200; count++) {
        pencil_t *pool = malloc((count + 1) * sizeof *pool);
        horizons_t h;
        parts_t t = {.n = 0};
        int err = horizons_init(&h, true, true, pool, count, take, &t);
        for (int k = 0; k < 12 && err == 0; k++) {
            int32_t a = below(1000) * 1000 - 500000;
            t.n = 0;
            err = horizons_clip(&h, (pencil_t){a, below(100000)}, (pencil_t){a + 30000, -below(100000)});
        }
        assert_true(err == 0 || err == ERR_FULL);
        full += err != 0;
        fits += err == 0;
        free(pool);
    }
    print_message("# envelope: %d pools too small, %d large enough\n", full, fits);
    assert_true(full > 20 && fits > 20);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random_edges),
        cmocka_unit_test(test_ties),
        cmocka_unit_test(test_vertical),
        cmocka_unit_test(test_full),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
