/* ints.h at the edges of its range, and against GMP for random operands. */
#include <gmp.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "num/ints.h"

static uint64_t seed = 0x2545f4914f6cdd1du;
static uint64_t next(void) {
    seed ^= seed << 13;
    seed ^= seed >> 7;
    seed ^= seed << 17;
    return seed;
}
static int64_t any_width(void) {
    return (int64_t)next() >> (next() & 63);
}

static void signs_and_zeros(void **state) {
    (void)state;
    assert_int_equal(ints_clz64(1), 63);
    assert_int_equal(ints_clz64(UINT64_MAX), 0);
    assert_int_equal(ints_clz32(1u << 16), 15);
    assert_true(ints_abs64(INT64_MIN) == (uint64_t)1 << 63);
    assert_true(ints_abs64(-5) == 5 && ints_abs64(5) == 5 && ints_abs64(0) == 0);
    assert_true(ints_with_sign(7, -1) == -7 && ints_with_sign(7, 0) == 7 && ints_with_sign(0, -3) == 0);
}

static void root_is_floor(void **state) {
    (void)state;
    assert_int_equal(ints_sqrt_u64(0), 0);
    assert_int_equal(ints_sqrt_u64(UINT64_MAX), UINT32_MAX);
    for (int i = 0; i < 200000; i++) {
        uint64_t a = next() >> (next() & 63);
        if (i % 3 == 0) { /* around a square, where floor changes */
            uint64_t r = a >> 32;
            a = r * r + (next() % 3) - 1;
        }
        uint64_t r = ints_sqrt_u64(a);
        assert_true(r * r <= a);
        assert_true(r == UINT32_MAX || (r + 1) * (r + 1) > a);
    }
}

/* n / d to nearest, ties away from zero, limited to 64 bits. */
static int64_t expected(mpz_t n, int64_t d) {
    mpz_t q, m;
    mpz_inits(q, m, NULL);
    mpz_set_si(m, (long)d);
    int sign = mpz_sgn(n) * mpz_sgn(m);
    mpz_abs(q, n);
    mpz_abs(m, m);
    mpz_mul_2exp(q, q, 1);
    mpz_add(q, q, m);
    mpz_mul_2exp(m, m, 1);
    mpz_fdiv_q(q, q, m);
    int64_t r = mpz_sizeinbase(q, 2) > 63 ? INT64_MAX : (int64_t)mpz_get_ui(q);
    mpz_clears(q, m, NULL);
    return sign < 0 ? -r : r;
}

static void divisions_round_to_nearest(void **state) {
    (void)state;
    assert_int_equal(ints_div_round(5, 2), 3);
    assert_int_equal(ints_div_round(-5, 2), -3);
    assert_int_equal(ints_div_round(4, -3), -1);
    assert_true(ints_div_round(INT64_MIN, INT64_MAX) == -1);
    assert_true(ints_div_round(INT64_MAX, INT64_MIN) == -1);
    assert_true(ints_muldiv_round(INT64_MAX, INT64_MAX, INT64_MAX) == INT64_MAX);
    assert_true(ints_muldiv_round(INT64_MAX, -2, 1) == -INT64_MAX);
    assert_true(ints_muldiv_round(INT64_MIN, INT64_MIN, INT64_MIN) == -INT64_MAX);
    assert_true(ints_muldiv_round(3, 1, -2) == -2);
    mpz_t n;
    mpz_init(n);
    for (int i = 0; i < 200000; i++) {
        int64_t a = any_width(), b = any_width(), c = any_width();
        if (c == 0) continue;
        if (i % 4 == 0 && c > INT64_MIN / 2 && c < INT64_MAX / 2) c *= 2, b = c / 2; /* ties when a is odd */
        mpz_set_si(n, (long)a);
        if (!(a == INT64_MIN && c == -1)) assert_true(ints_div_round(a, c) == expected(n, c));
        mpz_mul_si(n, n, (long)b);
        assert_true(ints_muldiv_round(a, b, c) == expected(n, c));
    }
    mpz_clear(n);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(signs_and_zeros),
        cmocka_unit_test(root_is_floor),
        cmocka_unit_test(divisions_round_to_nearest),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
