/* root.h against bitwise and floating-point square roots: exact at the edges and everywhere else. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "motion/root.h"

static uint64_t seed = 0x9e3779b97f4a7c15u;
static uint64_t next(void) {
    seed ^= seed << 13;
    seed ^= seed >> 7;
    return seed ^= seed << 17;
}

static void check(uint64_t x) {
    uint64_t r = root_u64(x);
    assert_true(r * r <= x);
    assert_true(r == UINT32_MAX || (r + 1) * (r + 1) > x);
}

static void test_root_is_exact(void **state) {
    (void)state;
    for (uint64_t x = 0; x < 70000; x++) check(x);
    for (uint64_t r = 1; r <= UINT32_MAX; r += 1 + r / 64) {
        check(r * r);
        check(r * r - 1);
        check(r * r + 1);
        check(r * r + 2 * r);
    }
    for (int i = 0; i < 2000000; i++) check(next() >> (next() & 63));
    check(UINT64_MAX);
}

static void test_normal(void **state) {
    (void)state;
    for (int i = 0; i < 200000; i++) {
        uint64_t x = next() >> (next() & 63);
        if (x == 0) continue;
        unsigned s;
        uint64_t r = root_normal(x, &s), m = x << (2 * s);
        assert_true(r >> 31 == 1 && m >> (2 * s) == x);
        assert_true(r * r <= m && (r == UINT32_MAX || (r + 1) * (r + 1) > m));
    }
}

static void test_vector(void **state) {
    (void)state;
    double worst_length = 0, worst_unit = 0;
    for (int i = 0; i < 500000; i++) {
        int32_t limit = 1 << 28, shift = (int32_t)(next() % 29);
        int32_t dx = (int32_t)(next() % (2u * (unsigned)limit + 1)) - limit,
                dy = (int32_t)(next() % (2u * (unsigned)limit + 1)) - limit;
        dx >>= shift, dy >>= next() % 4 ? shift : 0;
        if (i == 0) dx = limit, dy = -limit;
        if ((dx | dy) == 0) continue;
        int32_t ux, uy;
        uint32_t length = root_vector(dx, dy, &ux, &uy);
        double exact = hypot(dx, dy);
        worst_length = fmax(worst_length, fabs(length / 8.0 - exact));
        worst_unit = fmax(worst_unit, fmax(fabs(ux - dx / exact * 1073741824), fabs(uy - dy / exact * 1073741824)));
    }
    printf("# root_vector: length within %.4f, direction within %.2f * 2^-30\n", worst_length, worst_unit);
    assert_true(worst_length <= 0.125 && worst_unit <= 4);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_root_is_exact),
        cmocka_unit_test(test_normal),
        cmocka_unit_test(test_vector),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
