/* Intervals of numbered lines, and hatching: ink by tone, exact ends, lines that run on from polygon to polygon. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "error.h"
#include "hidden/hatch.h"

/* ---- intervals ---- */

typedef struct got {
    interval_t part[64];
    int n;
    int32_t least;
} got_t;

static int32_t least_of(void *ctx, int32_t line) {
    (void)line;
    return ((got_t *)ctx)->least;
}

static int take(void *ctx, const interval_t *part) {
    got_t *g = ctx;
    if (g->n == 64) return ERR_FULL;
    g->part[g->n++] = *part;
    return 0;
}

static void intervals_are_united(void **state) {
    (void)state;
    interval_t mem[32];
    intervals_t s;
    got_t g = {.least = 0};
    const interval_use_t use = {&g, least_of, take};
    intervals_init(&s, mem, sizeof mem);
    const interval_t in[] = {{3, 50, 60}, {1, 10, 20}, {3, 0, 10}, {1, 20, 30}, {1, 5, 12}, {3, 55, 58}, {2, 7, 7}};
    for (size_t k = 0; k < sizeof in / sizeof in[0]; k++)
        assert_int_equal(intervals_add(&s, in[k].line, in[k].from_q30, in[k].to_q30), 0);
    assert_int_equal(intervals_finish(&s, &use), 0);
    const interval_t out[] = {{1, 5, 30}, {3, 0, 10}, {3, 50, 60}};
    assert_int_equal(g.n, 3);
    assert_memory_equal(g.part, out, sizeof out);
}

static void gaps_close_and_crumbs_go(void **state) {
    (void)state;
    interval_t mem[32];
    intervals_t s;
    got_t g = {.least = 5};
    const interval_use_t use = {&g, least_of, take};
    intervals_init(&s, mem, sizeof mem);
    const interval_t in[] = {{0, 0, 100}, {0, 105, 200}, {0, 206, 300}, {1, 40, 45}, {1, 60, 66}};
    for (size_t k = 0; k < sizeof in / sizeof in[0]; k++) intervals_add(&s, in[k].line, in[k].from_q30, in[k].to_q30);
    assert_int_equal(intervals_finish(&s, &use), 0);
    const interval_t out[] = {{0, 0, 200}, {0, 206, 300}, {1, 60, 66}};
    assert_int_equal(g.n, 3);
    assert_memory_equal(g.part, out, sizeof out);
}

/* Memory for eight: 100 pieces of one line that touch fit, ten that do not are refused. */
static void full_memory_is_united_first(void **state) {
    (void)state;
    interval_t mem[8];
    intervals_t s;
    got_t g = {.least = 0};
    const interval_use_t use = {&g, least_of, take};
    intervals_init(&s, mem, sizeof mem);
    for (int k = 0; k < 100; k++) assert_int_equal(intervals_add(&s, 7, k * 37 % 100, k * 37 % 100 + 1 + 30), 0);
    assert_int_equal(intervals_finish(&s, &use), 0);
    assert_int_equal(g.n, 1);
    assert_true(g.part[0].from_q30 == 0 && g.part[0].to_q30 == 130);
    intervals_init(&s, mem, sizeof mem);
    int err = 0;
    for (int k = 0; k < 10 && !err; k++) err = intervals_add(&s, k, 0, 10);
    assert_int_equal(err, ERR_FULL);
}

/* ---- hatching ---- */

#define BITS 5

static const page_window_t window = {0, 0, 200 * LAT_PER_MM, 150 * LAT_PER_MM};

static poly_vertex_t at_mm(double x, double y) {
    const double unit = (double)LAT_PER_MM * (1 << BITS);
    return (poly_vertex_t){{(int32_t)lround(x * unit), (int32_t)lround(y * unit)}, 0};
}

/* Every piece's ends in mm, and the length of all. */
typedef struct ink {
    const hatch_t *h;
    double length, end[4096][4];
    int32_t n;
} ink_t;

static void place(const hatch_t *h, int32_t line, int32_t t, double out[2]) {
    page_h_t p;
    assert_true(h->lines.at(h->lines.ctx, INK_CURVE, line, t, &p));
    out[0] = (double)p.x / (double)p.e / LAT_PER_MM;
    out[1] = (double)p.y / (double)p.e / LAT_PER_MM;
}

static int measure(void *ctx, const interval_t *part) {
    ink_t *k = ctx;
    double *e = k->end[k->n++];
    assert_true(k->n < 4096);
    place(k->h, part->line, part->from_q30, e);
    place(k->h, part->line, part->to_q30, e + 2);
    k->length += hypot(e[2] - e[0], e[3] - e[1]);
    return 0;
}

static int32_t nothing(void *ctx, int32_t line) {
    (void)ctx, (void)line;
    return 0;
}

static interval_t memory[1 << 16];

static void hatch_all(ink_t *ink, hatch_t *h, const poly_t *p, const enum hatch_tone *tone, int n) {
    intervals_t parts;
    intervals_init(&parts, memory, sizeof memory);
    for (int k = 0; k < n; k++) assert_int_equal(hatch_polygon(h, &p[k], tone[k], 0, &parts), 0);
    *ink = (ink_t){.h = h};
    const interval_use_t use = {ink, nothing, measure};
    assert_int_equal(intervals_finish(&parts, &use), 0);
}

static void tones_are_ink_per_area(void **state) {
    (void)state;
    static ink_t ink;
    static const double ink_per_area[] = {0, .25, .5, 1, 1.5, 2};
    const poly_vertex_t square[4] = {at_mm(20, 20), at_mm(120, 20), at_mm(120, 120), at_mm(20, 120)};
    const int32_t end = 4;
    const poly_t p = {square, &end, 1};
    hatch_t h;
    for (int angle = -90; angle <= 180; angle += 15) {
        hatch_setup(&h, &window, num_from_i64(angle), LAT_PER_MM / 2);
        h.bits = BITS;
        for (int tone = HATCH_NONE; tone <= HATCH_DARK; tone++) {
            enum hatch_tone all = (enum hatch_tone)tone;
            hatch_all(&ink, &h, &p, &all, 1);
            double want = ink_per_area[tone] * 100 * 100 / .5;
            assert_true(fabs(ink.length - want) <= .021 * want); /* a line more or less of 200 */
        }
    }
}

/* Ends lie on the border of an annulus with an octagon as its hole, by arithmetic. */
static void ends_lie_on_the_border(void **state) {
    (void)state;
    static ink_t ink;
    poly_vertex_t v[12] = {at_mm(20, 20), at_mm(140, 20), at_mm(140, 130), at_mm(20, 130)};
    for (int k = 0; k < 8; k++) v[4 + k] = at_mm(80 + 30 * cos(k * .785398163), 75 + 30 * sin(k * .785398163));
    const int32_t end[2] = {4, 12};
    const poly_t p = {v, end, 2};
    hatch_t h;
    hatch_setup(&h, &window, num_from_i64(37), LAT_PER_MM);
    h.bits = BITS;
    hatch_all(&ink, &h, &p, &(enum hatch_tone){HATCH_DARK}, 1);
    double worst = 0, octagon = 2 * sqrt(2) * 900;
    for (int32_t k = 0; k < ink.n; k++)
        for (int e = 0; e < 4; e += 2) {
            double x = ink.end[k][e], y = ink.end[k][e + 1], near = HUGE_VAL;
            double side[4] = {x - 20, 140 - x, y - 20, 130 - y};
            for (int i = 0; i < 4; i++) near = fmin(near, fabs(side[i]));
            for (int i = 0; i < 8; i++) {
                double a = (i + .5) * .785398163, far = 30 * cos(.3926990817);
                near = fmin(near, fabs((x - 80) * cos(a) + (y - 75) * sin(a) - far));
            }
            worst = fmax(worst, near);
        }
    print_message("# hatch: ends lie within %.2g mm of the border\n", worst);
    assert_true(worst < 1e-5);
    double want = 2 * (120 * 110 - octagon);
    assert_true(fabs(ink.length - want) < .01 * want);
}

/* Two facets of one tone, side by side: their lines are one, with no seam; of two tones they are the same lines. */
static void lines_run_on(void **state) {
    (void)state;
    static ink_t whole, parts, mixed;
    const poly_vertex_t v[8] = {at_mm(20, 20),   at_mm(77.7, 20), at_mm(61.3, 120), at_mm(20, 120),
                                at_mm(77.7, 20), at_mm(120, 20),  at_mm(120, 120),  at_mm(61.3, 120)};
    const poly_vertex_t all[4] = {at_mm(20, 20), at_mm(120, 20), at_mm(120, 120), at_mm(20, 120)};
    const int32_t end = 4;
    const poly_t p[2] = {{v, &end, 1}, {v + 4, &end, 1}}, one = {all, &end, 1};
    hatch_t h;
    hatch_setup(&h, &window, num_from_i64(20), LAT_PER_MM);
    h.bits = BITS;
    hatch_all(&whole, &h, &one, &(enum hatch_tone){HATCH_MIDDLE}, 1);
    hatch_all(&parts, &h, p, (const enum hatch_tone[]){HATCH_MIDDLE, HATCH_MIDDLE}, 2);
    assert_int_equal(parts.n, whole.n);
    assert_true(fabs(parts.length - whole.length) < 1e-6);
    hatch_all(&mixed, &h, p, (const enum hatch_tone[]){HATCH_MIDDLE, HATCH_FAINT}, 2);
    int through[2] = {0, 0}; /* every fourth goes on */
    for (int which = 0; which < 2; which++) {
        const ink_t *ink = which ? &mixed : &whole;
        for (int32_t k = 0; k < ink->n; k++) through[which] += ink->end[k][0] < 55 && ink->end[k][2] > 85;
    }
    assert_true(mixed.n <= whole.n);
    assert_true(through[0] > 60 && abs(through[0] - 4 * through[1]) <= 4);
}

static void brightness_makes_tones(void **state) {
    (void)state;
    static const int percent[] = {0, 1, 24, 25, 44, 45, 64, 65, 84, 85, 100};
    static const enum hatch_tone tone[] = {HATCH_DARK,   HATCH_DEEP,  HATCH_DEEP,  HATCH_MIDDLE,
                                           HATCH_MIDDLE, HATCH_LIGHT, HATCH_LIGHT, HATCH_FAINT,
                                           HATCH_FAINT,  HATCH_NONE,  HATCH_NONE};
    for (size_t k = 0; k < sizeof percent / sizeof percent[0]; k++)
        assert_int_equal(hatch_tone_of(INK_ONE / 100 * percent[k]), tone[k]);
    assert_int_equal(hatch_tone_of(-INK_ONE), HATCH_DARK);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(intervals_are_united),        cmocka_unit_test(gaps_close_and_crumbs_go),
        cmocka_unit_test(full_memory_is_united_first), cmocka_unit_test(tones_are_ink_per_area),
        cmocka_unit_test(ends_lie_on_the_border),      cmocka_unit_test(lines_run_on),
        cmocka_unit_test(brightness_makes_tones),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
