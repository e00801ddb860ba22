/* Heights as integers: the same with and without a cache, close to the source, holes and limits kept. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "error.h"
#include "scene/grid.h"
#include "tests/oracle/num_of.h"
#define DICE_SEED 5
#include "tests/unit/dice.h"

#define NX 23
#define NY 17

/* A hole is NAN. */
static num_t height_of(double v) {
    return isnan(v) ? num_undef() : num_of(v);
}

static double heights[NY][NX];

static num_t axis_of(void *ctx, int32_t k) {
    (void)ctx;
    return num_from_i64(k);
}
static num_t z_of(void *ctx, int32_t i, int32_t j) {
    (void)ctx;
    return height_of(heights[j][i]);
}

static const surface_t src = {NX, NY, NULL, axis_of, axis_of, z_of, NULL, NULL};

static void check(const num_t *lo, const num_t *hi, double from, double to) {
    static int32_t cache[NX * NY], row[2][NX];
    static uint8_t hole[2][NX];
    grid_t with, without;
    int64_t holes = 0;
    assert_int_equal(grid_measure(&with, &src, lo, hi, cache, NULL, NULL), 0);
    assert_int_equal(grid_measure(&without, &src, lo, hi, NULL, NULL, NULL), 0);
    assert_int_equal(with.z_exp, without.z_exp);
    double least = INFINITY, most = -INFINITY, origin = ldexp((double)with.z_origin.m, with.z_origin.e);
    for (int32_t j = 0; j < NY; j++) {
        int32_t n = grid_row(&with, j, row[0], hole[0]);
        assert_int_equal(grid_row(&without, j, row[1], hole[1]), n);
        holes += n;
        for (int32_t i = 0; i < NX; i++) {
            double z = heights[j][i];
            bool gone = isnan(z) || z < from || z > to;
            assert_int_equal(hole[0][i], gone);
            assert_int_equal(hole[1][i], gone);
            assert_int_equal(row[0][i], row[1][i]);
            int32_t zi = 0;
            assert_int_equal(grid_height(&with, i, j, &zi), !gone);
            if (gone) continue;
            assert_int_equal(zi, row[0][i]);
            assert_true(zi <= 1 << 30 && zi >= -(1 << 30));
            double unit = ldexp(1, with.z_exp), off = (z - origin) / unit - zi;
            assert_true(off > -1e-5 && off < 1 + 1e-5);
            least = fmin(least, z), most = fmax(most, z);
        }
    }
    assert_int_equal(holes, with.holes);
    assert_true(ldexp((double)with.z_min.m, with.z_min.e) == least);
    assert_true(ldexp((double)with.z_max.m, with.z_max.e) == most);
    if (most > least) assert_true(ldexp(1, with.z_exp) <= (most - least) * 0x1p-29);
    assert_int_equal(with.evaluated, NX * NY);
    assert_int_equal(without.evaluated, 2 * NX * NY);
}

static void test_ranges(void **state) {
    (void)state;
    for (int round = 0; round < 60; round++) {
        double offset = round % 3 ? (uniform() - 0.5) * pow(10, round % 7) : 0, size = pow(10, 3 - round % 10);
        for (int j = 0; j < NY; j++) {
            for (int i = 0; i < NX; i++) {
                heights[j][i] = offset + size * (round % 2 ? uniform() : (j * NX + i) * 1e-3);
                if (round % 5 == 4 && uniform() < 0.2) heights[j][i] = NAN;
            }
        }
        check(NULL, NULL, -INFINITY, INFINITY);
        double lo = offset + 0.2 * size, hi = offset + 0.3 * size;
        num_t limit[2] = {num_of(lo), num_of(hi)};
        check(&limit[0], &limit[1], lo, hi);
    }
}

static void test_degenerate(void **state) {
    (void)state;
    grid_t g;
    int32_t row[NX];
    for (int j = 0; j < NY; j++) {
        for (int i = 0; i < NX; i++) heights[j][i] = NAN;
    }
    assert_int_equal(grid_measure(&g, &src, NULL, NULL, NULL, NULL, NULL), ERR_EMPTY);
    for (int j = 0; j < NY; j++) {
        for (int i = 0; i < NX; i++) heights[j][i] = -0.1;
    }
    assert_int_equal(grid_measure(&g, &src, NULL, NULL, NULL, NULL, NULL), 0);
    assert_int_equal(grid_row(&g, 3, row, NULL), 0);
    for (int i = 0; i < NX; i++) assert_int_equal(row[i], 0);
    /* Differences that grow from the last bit to 10^9: the cache is coarsened again and again. */
    for (int j = 0; j < NY; j++) {
        for (int i = 0; i < NX; i++) heights[j][i] = 1 + pow(2, (j * NX + i) % 82 - 52);
    }
    check(NULL, NULL, -INFINITY, INFINITY);
}

/* Edges that leave the limits meet them where the straight line does. */
static void test_limits_are_met(void **state) {
    (void)state;
    grid_t g;
    num_t limit[2] = {num_of(-1), num_of(2)}, z;
    int64_t s_q46;
    double worst = 0;
    for (int round = 0; round < 300; round++) {
        for (int j = 0; j < NY; j++) {
            for (int i = 0; i < NX; i++) heights[j][i] = (uniform() - 0.4) * pow(10, round % 12);
        }
        heights[0][0] = 0;
        heights[1][0] = NAN;
        assert_int_equal(grid_measure(&g, &src, &limit[0], &limit[1], NULL, NULL, NULL), 0);
        for (int i = 0; i + 1 < NX; i++) {
            const int32_t a[2] = {i, 0}, b[2] = {i + 1, 0};
            double from = heights[0][i], to = heights[0][i + 1];
            if (from < -1 || from > 2 || (to >= -1 && to <= 2)) continue;
            assert_true(to < -1 ? g.below : g.above);
            assert_true(grid_edge_limit(&g, a, b, &z, &s_q46));
            double met = to < -1 ? -1 : 2;
            assert_true(num_cmp(z, num_of(met)) == 0);
            worst = fmax(worst, fabs(ldexp((double)s_q46, -46) - (met - from) / (to - from)));
        }
    }
    assert_false(grid_edge_limit(&g, (const int32_t[]){0, 0}, (const int32_t[]){0, 1}, &z, &s_q46));
    printf("# grid: where limits are met, to %.1e of an edge\n", worst);
    assert_true(worst < 0x1p-45);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_ranges),
        cmocka_unit_test(test_degenerate),
        cmocka_unit_test(test_limits_are_met),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
