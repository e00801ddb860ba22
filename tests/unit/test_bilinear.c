/* Heights between grid points, and profiles that are evaluated once. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

#include "scene/bilinear.h"
#include "scene/profiles_cache.h"

#define N 5

static double to_double(num_t a) {
    return ldexp((double)a.m, a.e);
}

static num_t grid_x(void *ctx, int32_t i) {
    (void)ctx;
    return num_from_i64(i * i); /* uneven cells */
}

static num_t grid_z(void *ctx, int32_t i, int32_t j) {
    (void)ctx;
    if (i == 4 && j == 4) return num_undef();
    return num_from_i64(7 * i - 3 * j + 2 * i * j);
}

static const surface_t SURFACE = {.nx = N, .ny = N, .x_of = grid_x, .y_of = grid_x, .z_of = grid_z};

static void meets_the_points_and_is_linear_between(void **state) {
    (void)state;
    for (int k = 0; k < 2000; k++) {
        double x = (k * 37 % 1001) / 1001.0 * 16, y = (k * 91 % 997) / 997.0 * 16;
        int i = x >= 9 ? 3 : (int)sqrt(x), j = y >= 9 ? 3 : (int)sqrt(y);
        double u = (x - i * i) / (2 * i + 1), v = (y - j * j) / (2 * j + 1), z[2][2];
        for (int a = 0; a < 2; a++)
            for (int b = 0; b < 2; b++) z[a][b] = 7 * (i + a) - 3 * (j + b) + 2 * (i + a) * (j + b);
        double want = (1 - v) * ((1 - u) * z[0][0] + u * z[1][0]) + v * ((1 - u) * z[0][1] + u * z[1][1]);
        num_t got =
            bilinear_at(&SURFACE, num_from_fixed((int64_t)ldexp(x, 40), 40), num_from_fixed((int64_t)ldexp(y, 40), 40));
        assert_int_equal(got.undef, i == 3 && j == 3); /* the cell at the hole */
        if (!got.undef) assert_true(fabs(to_double(got) - want) < 1e-9);
    }
    assert_true(bilinear_at(&SURFACE, num_from_i64(17), num_from_i64(1)).undef);
    assert_true(bilinear_at(&SURFACE, num_from_i64(1), num_from_i64(-1)).undef);
}

static int asked;

static int32_t count_points(void *ctx, int32_t k) {
    (void)ctx;
    return k == 1 ? 0 : k + 2;
}

static void give_point(void *ctx, int32_t k, int32_t v, num_t xyz[3]) {
    (void)ctx;
    asked++;
    for (int axis = 0; axis < 3; axis++) xyz[axis] = num_from_i64(100 * k + 10 * v + axis);
    if (v == 1) xyz[2] = num_undef();
}

static void cache_gives_the_same_points(void **state) {
    (void)state;
    static _Alignas(16) unsigned char mem[1000];
    const profiles_t src = {.count = 4, .max_points = 6, .points = count_points, .point = give_point};
    profiles_t p = src;
    profiles_cache_t cache;
    const size_t need = 32 + 11 * 3 * sizeof(num_t); /* 2 + 0 + 4 + 5 points */
    assert_int_equal(profiles_cache_fill(&cache, &p, mem, need - 1, NULL, NULL), 0);
    assert_memory_equal(&p, &src, sizeof p);
    assert_int_equal(profiles_cache_fill(&cache, &p, mem, sizeof mem, NULL, NULL), need);
    asked = 0;
    for (int32_t k = 0; k < 4; k++) {
        assert_int_equal(p.points(p.ctx, k), count_points(NULL, k));
        for (int32_t v = 0; v < p.points(p.ctx, k); v++) {
            num_t got[3];
            p.point(p.ctx, k, v, got);
            assert_int_equal(num_to_fixed(got[0], 0, NULL), 100 * k + 10 * v);
            assert_int_equal(got[2].undef, v == 1);
        }
    }
    assert_int_equal(asked, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(meets_the_points_and_is_linear_between),
        cmocka_unit_test(cache_gives_the_same_points),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
