/* The cover with gaps against brute force: random regions between two lines, then random edges. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "error.h"
#include "hidden/bands.h"

static uint64_t rng = 9;

static int32_t below(int32_t n) {
    rng ^= rng << 13, rng ^= rng >> 7, rng ^= rng << 17;
    return (int32_t)((rng >> 11) % (uint64_t)n);
}

#define REGIONS 60
#define SAMPLES 100

typedef struct parts {
    envelope_part_t p[200];
    int n;
} parts_t;

static int take(void *ctx, envelope_part_t part) {
    parts_t *t = ctx;
    assert_true(t->n < 200 && part.from_q30 < part.to_q30);
    t->p[t->n++] = part;
    return 0;
}

static double at(const bands_line_t *l, double a) {
    return l->p.w + ((double)l->q.w - l->p.w) * (a - l->p.a) / ((double)l->q.a - l->p.a);
}

/* +1 covered, -1 not, 0 within `near` of a border. */
static int covered(const bands_line_t r[][2], int n, double a, double w, double near) {
    int inside = -1;
    for (int k = 0; k < n; k++) {
        if (a < r[k][0].p.a - near || a > r[k][0].q.a + near) continue;
        double u = at(&r[k][0], a), v = at(&r[k][1], a), lo = fmin(u, v), hi = fmax(u, v);
        bool aside = a < r[k][0].p.a + near || a > r[k][0].q.a - near;
        if (w < lo - near || w > hi + near) continue;
        if (aside || w < lo + near || w > hi - near) {
            if (inside < 0) inside = 0;
        } else {
            inside = 1;
        }
    }
    return inside;
}

/* Regions as cells make them: two lines over the same abscissae, which may cross. */
static void test_random(void **state) {
    (void)state;
    static bands_line_t r[REGIONS][2];
    static int32_t pool[60000];
    int judged = 0, hidden = 0;
    for (int round = 0; round < 60; round++) {
        bands_t b;
        parts_t t;
        assert_int_equal(bands_init(&b, 2, pool, sizeof pool / sizeof *pool, take, &t), 0);
        for (int k = 0; k < REGIONS; k++) {
            int32_t a0 = below(1 << 30) - (1 << 29), wide = 1000000 + below(round % 2 ? 1 << 28 : 1 << 25);
            for (int s = 0; s < 2; s++) {
                r[k][s].p = (pencil_t){a0, below(1 << 29) - (1 << 28)};
                r[k][s].q = (pencil_t){a0 + wide, below(1 << 29) - (1 << 28)};
            }
            if (k > 0 && below(3) == 0) r[k][0] = r[k - 1][1], r[k][1].p.a = r[k][0].p.a, r[k][1].q.a = r[k][0].q.a;
            assert_int_equal(bands_add(&b, r[k], 2, 0, 0), 0);
            bands_line_t e = {{below(1 << 30) - (1 << 29), below(1 << 29) - (1 << 28)},
                              {0, below(1 << 29) - (1 << 28)}};
            e.q.a = e.p.a + 100 + below(1 << 27);
            t.n = 0;
            bool flip = below(2);
            assert_int_equal(flip ? bands_clip(&b, e.q, e.p, true) : bands_clip(&b, e.p, e.q, true), 0);
            for (int m = 1; m < t.n; m++) { /* from left to right, and disjoint */
                const envelope_part_t *u = &t.p[m - 1], *v = &t.p[m];
                assert_true(flip ? v->to_q30 <= u->from_q30 : u->to_q30 <= v->from_q30);
            }
            if (flip) continue;
            double steep = 1 + fabs((double)e.q.w - e.p.w) / ((double)e.q.a - e.p.a);
            for (int i = 0; i < SAMPLES; i++) {
                double u = (i + 0.5) / SAMPLES, a = e.p.a + u * ((double)e.q.a - e.p.a);
                int want = covered((const bands_line_t(*)[2])r, k + 1, a, at(&e, a), 3000 * steep);
                bool seen = false;
                for (int m = 0; m < t.n; m++)
                    seen |= u >= ldexp(t.p[m].from_q30, -30) && u <= ldexp(t.p[m].to_q30, -30);
                judged += want != 0;
                hidden += want > 0;
                if (want != 0) assert_int_equal(seen, want < 0);
            }
        }
        assert_true(b.peak <= (int32_t)(sizeof pool / sizeof *pool));
    }
    print_message("# bands: %d points judged, %d of them hidden\n", judged, hidden);
    assert_true(judged > 100000 && hidden > 20000);
}

/* Neighbours that share a border leave no crack, and a cover without corners takes one strip. */
static void test_no_cracks(void **state) {
    (void)state;
    static int32_t pool[20000];
    bands_t b;
    parts_t t = {.n = 0};
    assert_int_equal(bands_init(&b, 2, pool, 20000, take, &t), 0);
    int32_t before = 0;
    for (int row = 0; row < 40; row++) {
        for (int k = 0; k < 40; k++) {
            /* a fan of cells between y = row and row + 1, seen through slanted sides */
            int32_t a = k * 7001 - 140020, w = row * 5003;
            bands_line_t cell[2] = {{{a, w + k * 11}, {a + 7001, w + (k + 1) * 11}},
                                    {{a, w + 5003 + k * 11}, {a + 7001, w + 5003 + (k + 1) * 11}}};
            assert_int_equal(bands_add(&b, cell, 2, 0, 0), 0);
        }
        before = (int32_t)((b.l - b.base) + (b.end - b.r));
    }
    assert_true(before < 40);
    for (int k = 0; k < 200; k++) {
        pencil_t p = {below(270000) - 139000, 500 + below(190000)}, q = {below(270000) - 139000, 500 + below(190000)};
        assert_int_equal(bands_clip(&b, p, q, true), 0);
    }
    assert_int_equal(t.n, 0);
}

static void test_full(void **state) {
    (void)state;
    int full = 0, fits = 0;
    for (size_t words = 0; words < 900; words += 3) {
        int32_t *pool = malloc((words + 1) * sizeof *pool);
        bands_t b;
        parts_t t = {.n = 0};
        int err = bands_init(&b, 2, pool, words, take, &t);
        for (int k = 0; k < 20 && err == 0; k++) {
            int32_t a = below(1000) * 1000 - 500000;
            bands_line_t r[2] = {{{a, below(100000)}, {a + 90000, below(100000)}},
                                 {{a, -below(100000)}, {a + 90000, -below(100000)}}};
            err = bands_add(&b, r, 2, k % 3 - 1, 0);
        }
        assert_true(err == 0 || err == ERR_FULL);
        full += err != 0;
        fits += err == 0;
        free(pool);
    }
    assert_true(full > 20 && fits > 20);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random),
        cmocka_unit_test(test_no_cracks),
        cmocka_unit_test(test_full),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
