/* Windows: opened by bare edges above a horizon, closed by facets, looked through; against a raster of columns. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "error.h"
#include "hidden/surface/windows.h"
#define DICE_SEED 5
#include "tests/unit/dice.h"

#define COLUMNS 40
#define WIDTH 100 /* units of a in a column: looked at in its middle */
#define CLEAR 40  /* what is nearer than that to a border is not judged */

/* The model: an open interval of each column is what the edge left, minus the facets. */
#define HEIGHT 4000
static unsigned char open[COLUMNS][HEIGHT];

/* Columns next to whose middle something ends or crosses: a window narrower than the noise may be there. */
static bool doubtful[COLUMNS];

static int32_t at(const outline_line_t *s, int32_t x) {
    return pencil_ordinate(s->p, s->q, x);
}

static bool is_over(const outline_line_t *s, int32_t x) {
    return x >= s->p.a && x <= s->q.a;
}

static void doubt(const outline_line_t *lo, const outline_line_t *hi) {
    for (int32_t c = 0; c < COLUMNS; c++) {
        const int32_t x = c * WIDTH + WIDTH / 2 + 1, l = x - 2 * ENVELOPE_NOISE, r = x + 2 * ENVELOPE_NOISE;
        if (is_over(lo, l) != is_over(lo, r) || is_over(hi, l) != is_over(hi, r)) {
            doubtful[c] = true;
        } else if (is_over(lo, l) && is_over(hi, l)) {
            doubtful[c] |= (at(lo, l) < at(hi, l)) != (at(lo, r) < at(hi, r));
        }
    }
}

static void mark(const outline_line_t *lo, const outline_line_t *hi, unsigned char value) {
    doubt(lo, hi);
    for (int32_t c = 0; c < COLUMNS; c++) {
        const int32_t x = c * WIDTH + WIDTH / 2 + 1;
        if (x < lo->p.a || x > lo->q.a || x < hi->p.a || x > hi->q.a) continue;
        int32_t l = at(lo, x), h = at(hi, x);
        for (int32_t w = l < h ? l : h; w < (l < h ? h : l); w++)
            if (w >= 0 && w < HEIGHT) open[c][w] = value;
    }
}

static bool is_clear(int32_t c, int32_t w) {
    for (int32_t k = -CLEAR; k <= CLEAR; k++)
        if (w + k < 0 || w + k >= HEIGHT || open[c][w + k] != open[c][w]) return false;
    return true;
}

static outline_line_t random_line(int32_t a0, int32_t a1) {
    return (outline_line_t){{a0 & ~1, below(HEIGHT)}, {a1 & ~1, below(HEIGHT)}}; /* columns are at odd abscissae */
}

static int close_facet(windows_t *w, const outline_line_t *line, int32_t n, int down) {
    windows_span_t span[WINDOWS_SPANS];
    return windows_close(w, span, windows_spans(line, n, span), down);
}

static int judge(const windows_t *w) {
    int judged = 0;
    for (int k = 0; k < 40; k++) {
        const int32_t a0 = below(COLUMNS * WIDTH / 2) & ~1, a1 = (a0 + WIDTH + below(COLUMNS * WIDTH / 2 - WIDTH)) & ~1;
        const outline_line_t e = random_line(a0, a1);
        windows_part_t part[WINDOWS_PARTS];
        const int32_t n = windows_clip(w, e.p, e.q, part);
        if (n == WINDOWS_PARTS) continue;
        for (int32_t i = 0; i + 1 < n; i++) assert_true(part[i].to_q30 < part[i + 1].from_q30);
        for (int32_t c = a0 / WIDTH + 1; c < a1 / WIDTH; c++) {
            const int32_t x = c * WIDTH + WIDTH / 2 + 1, v = at(&e, x);
            const int32_t slope = abs(e.q.w - e.p.w) / (a1 - a0);
            if (slope > CLEAR / 8 || doubtful[c] || !is_clear(c, v)) continue;
            const int32_t f = (int32_t)(((int64_t)(x - a0) << 30) / (a1 - a0));
            const int32_t near = (1 << 30) / (a1 - a0) * 2;
            bool seen = false, close = false;
            for (int32_t i = 0; i < n; i++) {
                seen |= f >= part[i].from_q30 && f <= part[i].to_q30;
                close |= abs(f - part[i].from_q30) < near || abs(f - part[i].to_q30) < near;
            }
            if (close) continue;
            assert_int_equal(seen, open[c][v]);
            if (seen) assert_true(windows_any(w, x, x, v, v));
            judged++;
        }
    }
    return judged;
}

static void test_random(void **state) {
    (void)state;
    static int64_t mem[40000];
    static pencil_t horizon[64];
    int judged = 0;
    for (int round = 0; round < 300; round++) {
        windows_t w;
        envelope_t h;
        envelope_count_t count = {0};
        memset(open, 0, sizeof open);
        memset(doubtful, 0, sizeof doubtful);
        assert_int_equal(windows_init(&w, COLUMNS, mem, sizeof mem), 0);
        assert_int_equal(envelope_init(&h, NULL, horizon, 64), 0);
        const bool lower = round & 1;
        const outline_line_t ground = {{0, lower ? HEIGHT - 200 : 200}, {COLUMNS * WIDTH, lower ? HEIGHT - 300 : 300}};
        const outline_line_t rim = random_line(below(800), COLUMNS * WIDTH - below(800));
        const int sign = lower ? -1 : 1;
        envelope_clip(&h, (pencil_t){ground.p.a, sign * ground.p.w}, (pencil_t){ground.q.a, sign * ground.q.w}, NULL,
                      NULL, &count);
        assert_int_equal(
            windows_open(&w, &h, (pencil_t){rim.p.a, sign * rim.p.w}, (pencil_t){rim.q.a, sign * rim.q.w}, lower), 0);
        for (int32_t c = 0; c < COLUMNS; c++) { /* above the ground and below the rim, or the other way round */
            const int32_t x = c * WIDTH + WIDTH / 2 + 1;
            if (x < rim.p.a || x > rim.q.a) continue;
            const int32_t lo = at(lower ? &rim : &ground, x), hi = at(lower ? &ground : &rim, x);
            for (int32_t v = lo; v < hi; v++)
                if (v >= 0 && v < HEIGHT) open[c][v] = 1;
        }
        doubt(&ground, &rim);
        judged += judge(&w);
        for (int k = 0; k < 12; k++) {
            const int32_t a0 = below(COLUMNS * WIDTH - 2 * WIDTH),
                          a1 = a0 + WIDTH + below(COLUMNS * WIDTH - a0 - WIDTH);
            const outline_line_t side[2] = {random_line(a0, a1), random_line(a0, a1)};
            assert_int_equal(close_facet(&w, side, 2, 0), 0);
            mark(&side[0], &side[1], 0);
            judged += judge(&w);
        }
        const outline_line_t sill = random_line(0, COLUMNS * WIDTH);
        const outline_line_t floor = {{0, -1}, {COLUMNS * WIDTH, -1}};
        assert_int_equal(close_facet(&w, &sill, 1, 1), 0);
        mark(&floor, &sill, 0);
        judged += judge(&w);
        const outline_line_t all[2] = {{{0, -1}, {COLUMNS * WIDTH, -1}}, {{0, HEIGHT}, {COLUMNS * WIDTH, HEIGHT}}};
        assert_int_equal(close_facet(&w, all, 2, 0), 0);
        assert_int_equal(w.present, 0);
    }
    print_message("# windows: %d points of lines judged\n", judged);
    assert_true(judged > 100000);
}

/* What has been cut joins again. */
static void test_joins(void **state) {
    (void)state;
    static int64_t mem[4000];
    static pencil_t horizon[64];
    windows_t w;
    envelope_t h;
    envelope_count_t count = {0};
    windows_init(&w, 4, mem, sizeof mem);
    envelope_init(&h, NULL, horizon, 64);
    envelope_clip(&h, (pencil_t){0, 0}, (pencil_t){1000000, 0}, NULL, NULL, &count);
    assert_int_equal(windows_open(&w, &h, (pencil_t){0, 500000}, (pencil_t){1000000, 600000}, false), 0);
    const int32_t before = w.present;
    /* Row by row from below, each with corners of its own. */
    for (int32_t row = 1; row < 200; row++) {
        const int32_t corner = 1000 + row * 4999;
        for (int k = 0; k < 2; k++) {
            const int32_t a0 = k ? corner : 0, a1 = k ? 1000000 : corner;
            const outline_line_t side[2] = {{{a0, row * 1000 - 1000}, {a1, row * 1000 - 1000}},
                                            {{a0, row * 1000}, {a1, row * 1000}}};
            assert_int_equal(close_facet(&w, side, 2, 0), 0);
        }
        assert_true(w.present <= before + 4);
    }
}

/* Opens windows from a steep horizon up to a rim so much above it. Returns how many. */
static int32_t open_above_steep(int32_t by) {
    static int64_t mem[1000];
    static pencil_t horizon[64];
    const outline_line_t ground = {{1000, -100000}, {2000001, 33000000}}; /* a slope of 16.6 */
    windows_t w;
    envelope_t h;
    envelope_count_t count = {0};
    assert_int_equal(windows_init(&w, COLUMNS, mem, sizeof mem), 0);
    assert_int_equal(envelope_init(&h, NULL, horizon, 64), 0);
    envelope_clip(&h, ground.p, ground.q, NULL, NULL, &count);
    const pencil_t p = {ground.p.a, ground.p.w + by}, q = {ground.q.a, ground.q.w + by};
    assert_int_equal(windows_open(&w, &h, p, q, false), 0);
    return w.present;
}

/* Steep edges that fall together are several units apart in w for one in a: nothing shows between them. */
static void test_steep(void **state) {
    (void)state;
    assert_int_equal(open_above_steep(6), 0);
    assert_int_equal(open_above_steep(60), 0);
    assert_true(open_above_steep(70) > 0);
}

static void test_memory(void **state) {
    (void)state;
    static int64_t mem[100];
    static pencil_t horizon[64];
    windows_t w;
    envelope_t h;
    envelope_count_t count = {0};
    assert_int_equal(windows_init(&w, 4, mem, 16), ERR_FULL);
    assert_int_equal(windows_init(&w, 4, mem, sizeof mem), 0);
    envelope_init(&h, NULL, horizon, 64);
    envelope_clip(&h, (pencil_t){0, 0}, (pencil_t){1000000, 0}, NULL, NULL, &count);
    int err = 0;
    for (int32_t k = 0; k < 40 && err == 0; k++)
        err = windows_open(&w, &h, (pencil_t){k * 1000, 5000}, (pencil_t){k * 1000 + 900, 7000 + k}, false);
    assert_int_equal(err, ERR_FULL);
    assert_true(windows_bytes(&w) <= sizeof mem);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random),
        cmocka_unit_test(test_joins),
        cmocka_unit_test(test_steep),
        cmocka_unit_test(test_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
