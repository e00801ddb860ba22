/* planner.h: laws that every plan obeys, the limits of single corners, and independence of the ring. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "motion/planner.h"

#define TOP (1310720u) /* 5 mm: 100 mm/s at 1000 mm/s^2 */

static uint32_t seed = 1;
static int32_t random_below(int32_t n) {
    seed = seed * 1664525u + 1013904223u;
    return (int32_t)((uint64_t)seed * (uint32_t)n >> 32);
}

static page_point_t lat(double x_mm, double y_mm) {
    return (page_point_t){(int32_t)lround(x_mm * LAT_PER_MM), (int32_t)lround(y_mm * LAT_PER_MM)};
}

static void test_height(void **state) {
    (void)state;
    assert_int_equal(planner_height_q3(100000, 1000000), TOP);
    assert_int_equal(planner_height_q3(0, 1), 0);
    assert_int_equal(planner_height_q3(4000000, 1), PLANNER_HEIGHT_MAX_Q3);
}

/* Plans points with a ring of `size`; returns the moves in out[]. */
static size_t run(planner_t *p, planner_block_t *ring, uint32_t size, const page_point_t *pt, size_t n,
                  planner_move_t *out) {
    size_t k = 0;
    planner_init(p, ring, size, 10);
    planner_begin(p, pt[0], TOP);
    for (size_t i = 1; i < n; i++) {
        while (planner_full(p) && planner_take(p, false, &out[k])) k++;
        planner_add(p, pt[i]);
        assert_true(p->count <= size);
    }
    while (planner_take(p, true, &out[k])) k++;
    return k;
}

/* Moves join up, start and end at rest, and never change speed by more than their length allows. */
static void check_laws(const planner_move_t *mv, size_t n, page_point_t from) {
    assert_int_equal(mv[0].in_q3, 0);
    assert_int_equal(mv[n - 1].out_q3, 0);
    for (size_t i = 0; i < n; i++) {
        page_point_t start = i ? mv[i - 1].to : from;
        assert_memory_equal(&mv[i].from, &start, sizeof start);
        assert_int_equal(mv[i].in_q3, i ? mv[i - 1].out_q3 : 0);
        assert_int_equal(mv[i].last, i + 1 == n);
        if (i + 1 < n) assert_memory_equal(&mv[i].then, &mv[i + 1].to, sizeof start);
        assert_true(mv[i].in_q3 <= TOP && mv[i].out_q3 <= TOP);
        int64_t change = (int64_t)mv[i].out_q3 - mv[i].in_q3;
        assert_true(llabs(change) <= (int64_t)mv[i].length_q3);
    }
}

static void test_laws(void **state) {
    (void)state;
    enum { N = 3000 };
    static page_point_t pt[N];
    static planner_move_t mv[N], big[N];
    static planner_block_t ring[N];
    planner_t p;
    static const uint32_t size[] = {2, 3, 8, 31, 200, N};
    static const int32_t extent[] = {4, 300, 5000, 100000, PLANNER_REACH_LAT - 1};
    for (size_t e = 0; e < 5; e++) {
        int32_t x = 0, y = 0;
        for (int i = 0; i < N; i++) {
            int32_t step = extent[e] > 100000 ? extent[e] : 2 * extent[e] + 1;
            x = (extent[e] > 100000 ? 0 : x) + random_below(step) - (step - 1) / 2;
            y = (extent[e] > 100000 ? 0 : y) + random_below(step) - (step - 1) / 2;
            pt[i] = (page_point_t){x, y};
        }
        size_t n_big = run(&p, ring, N, pt, N, big);
        assert_int_equal(p.forced, 0);
        for (size_t s = 0; s < 6; s++) {
            size_t n = run(&p, ring, size[s], pt, N, mv);
            assert_int_equal(n, n_big);
            check_laws(mv, n, pt[0]);
            uint64_t slower = 0;
            for (size_t i = 0; i < n; i++) {
                assert_true(mv[i].out_q3 <= big[i].out_q3);
                slower += big[i].out_q3 - mv[i].out_q3;
            }
            if (p.forced == 0) assert_true(slower == 0); /* nothing forced: the plan of infinite look-ahead */
        }
    }
}

/* The height at which the vertex between two lines may be passed. */
static double corner_mm(double length1, double length2, double degrees) {
    planner_block_t ring[4];
    planner_move_t mv[2];
    planner_t p;
    double t = degrees * 3.14159265358979323846 / 180;
    page_point_t pt[3] = {lat(-length1, 0), lat(0, 0), lat(length2 * cos(t), length2 * sin(t))};
    assert_int_equal(run(&p, ring, 4, pt, 3, mv), 2);
    return mv[0].out_q3 / 8.0 / LAT_PER_MM;
}

static void test_corners(void **state) {
    (void)state;
    for (int degrees = -180; degrees <= 180; degrees++) {
        double t = abs(degrees) * 3.14159265358979323846 / 180, s = cos(t / 2);
        double junction = 0.005 * s / (1 - s), got = corner_mm(20, 30, degrees);
        double want = fmin(5, fmin(junction, 50 / (8 * tan(t / 2))));
        assert_true(fabs(got - want) < 1e-4 + want * 3e-4);
    }
    assert_true(corner_mm(20, 20, 180) == 0);
    assert_true(fabs(corner_mm(20, 20, 90) - 0.01207) < 1e-4);
}

/* A circle cut as finely as one likes keeps the speed that its radius allows: h = R/2. */
static void test_centripetal(void **state) {
    (void)state;
    static page_point_t pt[20001];
    static planner_move_t mv[20001];
    static planner_block_t ring[512];
    planner_t p;
    static const double cut_mm[] = {0.4, 0.2, 0.1, 0.05};
    for (size_t c = 0; c < 4; c++) {
        double radius = 4;
        size_t n = (size_t)(100 / cut_mm[c]), stroke;
        for (size_t i = 0; i <= n; i++) {
            double a = (double)i * cut_mm[c] / radius;
            pt[i] = lat(radius * cos(a), radius * sin(a));
        }
        stroke = run(&p, ring, 512, pt, n + 1, mv);
        double sum = 0;
        size_t count = 0;
        for (size_t i = stroke / 4; i < 3 * stroke / 4; i++, count++) sum += mv[i].in_q3 / 8.0 / LAT_PER_MM;
        assert_true(fabs(sum / (double)count - radius / 2) < 0.03 * radius / 2);
    }
}

static void test_equal_points(void **state) {
    (void)state;
    planner_block_t ring[4];
    planner_move_t mv;
    planner_t p;
    planner_init(&p, ring, 4, 10);
    planner_begin(&p, lat(1, 1), TOP);
    assert_int_equal(planner_add(&p, lat(1, 1)), 0);
    assert_false(planner_take(&p, true, &mv));
    assert_int_equal(planner_add(&p, lat(2, 1)), 8 * LAT_PER_MM);
    assert_int_equal(planner_add(&p, lat(2, 1)), 0);
    assert_false(planner_take(&p, false, &mv));
    assert_true(planner_take(&p, true, &mv) && mv.last);
    assert_false(planner_take(&p, true, &mv));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_height),      cmocka_unit_test(test_laws),         cmocka_unit_test(test_corners),
        cmocka_unit_test(test_centripetal), cmocka_unit_test(test_equal_points),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
