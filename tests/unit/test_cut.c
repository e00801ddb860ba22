/* Cutting to the window, against a dense walk along random polylines in homogeneous space. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "view/cut.h"

#define VERTICES 6
#define PIECES 64

static const page_window_t WINDOW = {327680, 327680, 9404416, 6553600}; /* A4, margin 10 mm */

typedef struct scene {
    page_h_t vertex[VERTICES];
    ink_piece_t out[PIECES];
    int n;
} scene_t;

static uint64_t rng = 1;

static int64_t random_in(int64_t lo, int64_t hi) {
    rng = rng * 6364136223846793005u + 1442695040888963407u;
    return lo + (int64_t)((rng >> 11) % (uint64_t)(hi - lo + 1));
}

static bool scene_at(void *ctx, uint8_t family, int32_t line, int64_t t, page_h_t *h) {
    (void)family, (void)line;
    scene_t *s = ctx;
    const int32_t at = (int32_t)(t >> INK_GRID_BITS);
    const int64_t f = t & (INK_GRID_ONE - 1);
    *h = f ? line_space_mix_fine(&s->vertex[at], &s->vertex[at + 1], f) : s->vertex[at];
    return true;
}

static int collect(void *ctx, const ink_piece_t *p) {
    scene_t *s = ctx;
    assert_true(s->n < PIECES);
    assert_true(p->from < p->to);
    assert_true(s->n == 0 || s->out[s->n - 1].to <= p->from);
    s->out[s->n++] = *p;
    return 0;
}

/* How far inside (positive) the window a point is, in lat; behind the eye is far outside. */
static double inside_by(const line_space_t *lines, int64_t t) {
    page_h_t h;
    lines->at(lines->ctx, 0, 0, t, &h);
    if (h.e < lines->near_e) return -1e9;
    double x = (double)h.x / (double)h.e, y = (double)h.y / (double)h.e;
    return fmin(fmin(x - WINDOW.x0_lat, WINDOW.x1_lat - x), fmin(y - WINDOW.y0_lat, WINDOW.y1_lat - y));
}

static void cuts_at_the_window(void **state) {
    (void)state;
    for (int k = 0; k < 3000; k++) {
        static scene_t s;
        memset(&s, 0, sizeof s);
        bool perspective = k & 1;
        line_space_t lines = {.ctx = &s,
                              .at = scene_at,
                              .window = &WINDOW,
                              .perspective = perspective,
                              .frac_bits = 20,
                              .near_e = perspective ? 1 << 14 : 1};
        for (int v = 0; v < VERTICES; v++) {
            page_h_t *h = &s.vertex[v];
            h->e = perspective ? random_in(-((int64_t)1 << 33), (int64_t)1 << 34) : 1 << 20;
            h->x = random_in(-9000000, 19000000) * (perspective ? llabs(h->e) : h->e);
            h->y = random_in(-9000000, 15000000) * (perspective ? llabs(h->e) : h->e);
        }
        cut_t cut = {&lines, {&s, collect}};
        ink_sink_t sink = cut_sink(&cut);
        ink_piece_t all = {.from = random_in(0, INK_GRID_ONE),
                           .to = random_in(INK_GRID_ONE + 1, (VERTICES - 1) * INK_GRID_ONE)};
        assert_int_equal(sink.piece(sink.ctx, &all), 0);

        for (int64_t t = all.from; t < all.to; t += INK_GRID_ONE / 257) {
            bool drawn = false, at_end = false;
            for (int n = 0; n < s.n; n++) {
                drawn = drawn || (t >= s.out[n].from && t <= s.out[n].to);
                at_end = at_end || llabs(t - s.out[n].from) < 4 || llabs(t - s.out[n].to) < 4;
            }
            double by = inside_by(&lines, t);
            if (at_end || fabs(by) < 2) continue;
            assert_int_equal(drawn, by > 0);
        }
        for (int n = 0; n < s.n; n++) {
            page_point_t p;
            assert_true(line_space_point(&lines, 0, 0, s.out[n].from, &p));
            assert_true(line_space_point(&lines, 0, 0, s.out[n].to, &p));
            assert_true(p.x_lat >= WINDOW.x0_lat && p.x_lat <= WINDOW.x1_lat);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(cuts_at_the_window)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
