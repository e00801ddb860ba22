/* num.h against MPFR: every operation within one unit in the last place, results normalised, rare cases
 * (zero, undefined, overflow, cancellation) as the header says. */
#include <math.h>
#include <mpfr.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "num/num.h"
#include "num/num_fast.h"

static uint64_t seed = 0x853c49e6748fea9bu;
static uint64_t next(void) {
    seed ^= seed << 13;
    seed ^= seed >> 7;
    seed ^= seed << 17;
    return seed;
}

/* Random values with exponents within +-span of 1 and few or many significant bits. */
static num_t random_num(int span) {
    int64_t m = (int64_t)next();
    if (next() % 4 == 0) m &= -((int64_t)1 << (next() % 62));
    return num_from_fixed(m, 63 + (int)(next() % (unsigned)(2 * span + 1)) - span);
}

static void set_num(mpfr_t r, num_t a) {
    mpfr_set_si_2exp(r, (long)a.m, a.e, MPFR_RNDN);
}

static bool is_normal(num_t a) {
    if (a.m == 0) return a.e == 0;
    uint64_t u = ints_abs64(a.m);
    return !a.undef && u >> 62 == 1 && a.e >= NUM_FAST_E_MIN && a.e <= NUM_FAST_E_MAX;
}

/* |a - exact| in units of the last place of a. */
static double ulps(num_t a, mpfr_t exact) {
    static mpfr_t d;
    static bool ready;
    if (!ready) mpfr_init2(d, 300);
    ready = true;
    set_num(d, a);
    mpfr_sub(d, d, exact, MPFR_RNDN);
    mpfr_mul_2si(d, d, -a.e, MPFR_RNDN);
    return fabs(mpfr_get_d(d, MPFR_RNDN));
}

static void assert_same(num_t a, num_t b) {
    assert_true(a.m == b.m && a.e == b.e && a.undef == b.undef);
}

enum { RANDOM = 300000 };

typedef num_t (*binary_t)(num_t, num_t);
typedef int (*mpfr_binary_t)(mpfr_t, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);

static void check_binary(const char *name, binary_t f, mpfr_binary_t exact, int span) {
    mpfr_t x, y, z;
    mpfr_inits2(300, x, y, z, NULL);
    double worst = 0;
    for (int i = 0; i < RANDOM; i++) {
        num_t a = random_num(span), b = random_num(span);
        if (i % 8 == 0 && span < 10) b = num_add(a, num_from_fixed((int64_t)(next() % 9) - 4, -a.e)); /* cancels */
        if (i % 16 == 0) b.e += (i & 32) != 0;
        set_num(x, a);
        set_num(y, b);
        num_t r = f(a, b);
        if (mpfr_zero_p(y) && f == num_div) continue;
        assert_true(is_normal(r));
        exact(z, x, y, MPFR_RNDN);
        double u = ulps(r, z);
        if (u > worst) worst = u;
        if (mpfr_zero_p(z)) assert_true(r.m == 0);
        /* symmetric in sign */
        assert_same(f(num_neg(a), f == num_add || f == num_sub ? num_neg(b) : b), num_neg(r));
    }
    printf("# num_%s worst error %.3f ulp of 2^-62\n", name, worst);
    assert_true(worst < 1);
    mpfr_clears(x, y, z, NULL);
}

static void sums(void **state) {
    (void)state;
    check_binary("add", num_add, mpfr_add, 2);
    check_binary("add", num_add, mpfr_add, 70);
    check_binary("sub", num_sub, mpfr_sub, 3);
    check_binary("sub", num_sub, mpfr_sub, 90);
}

static void products(void **state) {
    (void)state;
    check_binary("mul", num_mul, mpfr_mul, 4);
    check_binary("mul", num_mul, mpfr_mul, 500);
    check_binary("div", num_div, mpfr_div, 4);
    check_binary("div", num_div, mpfr_div, 500);
}

static void square_roots(void **state) {
    (void)state;
    mpfr_t x;
    mpfr_init2(x, 300);
    double worst = 0;
    for (int i = 0; i < RANDOM; i++) {
        num_t a = num_abs(random_num(i & 1 ? 2 : 1000));
        num_t r = num_sqrt(a);
        assert_true(is_normal(r));
        set_num(x, a);
        mpfr_sqrt(x, x, MPFR_RNDN);
        double u = ulps(r, x);
        if (u > worst) worst = u;
        int64_t n = (int64_t)(next() >> 33);
        assert_same(num_sqrt(num_from_i64(n * n)), num_from_i64(n));
    }
    for (int i = 0; i < 64; i++) { /* both ends of the significand */
        num_t a = {i & 1 ? INT64_MAX - i / 4 : ((int64_t)1 << 62) + i / 4, i >> 1 & 1, false};
        num_t r = num_sqrt(a);
        assert_true(is_normal(r));
        set_num(x, a);
        mpfr_sqrt(x, x, MPFR_RNDN);
        double u = ulps(r, x);
        if (u > worst) worst = u;
    }
    printf("# num_sqrt worst error %.3f ulp of 2^-62\n", worst);
    assert_true(worst < 1);
    assert_true(num_sqrt(num_from_i64(-1)).undef);
    assert_true(num_sqrt(num_undef()).undef);
    assert_same(num_sqrt(num_from_i64(0)), num_from_i64(0));
    mpfr_clear(x);
}

static void integers_are_exact(void **state) {
    (void)state;
    for (int i = 0; i < RANDOM; i++) {
        int64_t a = (int64_t)next() >> (33 + next() % 30), b = (int64_t)next() >> (33 + next() % 30);
        num_t x = num_from_i64(a), y = num_from_i64(b);
        assert_same(num_mul(x, y), num_from_i64(a * b));
        assert_same(num_add(x, y), num_from_i64(a + b));
        assert_same(num_sub(x, y), num_from_i64(a - b));
        if (b != 0) assert_same(num_div(num_from_i64(a * b), y), x);
        assert_int_equal(num_cmp(x, y), (a > b) - (a < b));
        assert_true(num_to_fixed(x, 0, NULL) == a);
    }
    assert_same(num_ipow(num_from_i64(-3), 39), num_from_i64(-4052555153018976267));
    assert_same(num_ipow(num_from_i64(2), -3), num_from_fixed(1, 3));
    assert_same(num_ipow(num_from_i64(0), 0), num_from_i64(1));
    assert_true(num_ipow(num_from_i64(0), -1).undef);
    assert_true(num_ipow(num_from_i64(10), 400).undef);
    assert_same(num_ipow(num_from_i64(10), -400), num_from_i64(0));
}

static void undefined_travels(void **state) {
    (void)state;
    num_t u = num_undef(), one = num_from_i64(1), zero = num_from_i64(0);
    bool ok = true;
    assert_true(num_add(u, one).undef && num_add(one, u).undef && num_add(zero, u).undef);
    assert_true(num_sub(u, one).undef && num_sub(zero, u).undef && num_mul(zero, u).undef);
    assert_true(num_mul(u, one).undef && num_div(u, one).undef && num_div(one, u).undef);
    assert_true(num_div(one, zero).undef && num_div(zero, zero).undef);
    assert_true(num_neg(u).undef && num_abs(u).undef && num_ldexp(u, 3).undef && num_floor(u).undef);
    assert_true(num_ceil(u).undef && num_trunc(u).undef && num_ipow(u, 0).undef);
    assert_false(num_is_integer(u));
    assert_true(num_to_fixed(u, 20, &ok) == 0 && !ok);
    ok = true;
    assert_true(num_to_fixed(u, -100, &ok) == 0 && !ok);
    assert_same(num_div(zero, one), zero);
    assert_same(num_sub(one, one), zero);
}

static void limits(void **state) {
    (void)state;
    num_t one = num_from_i64(1), large = num_ldexp(one, NUM_EXP_LIMIT - 1), small = num_ldexp(one, -NUM_EXP_LIMIT);
    assert_false(large.undef);
    assert_true(num_add(large, large).undef);
    assert_true(num_mul(large, large).undef);
    assert_true(num_div(large, small).undef);
    assert_true(num_ldexp(one, NUM_EXP_LIMIT).undef);
    assert_true(small.m != 0);
    assert_same(num_mul(small, num_from_fixed(1, 1)), num_from_i64(0));
    assert_same(num_mul(small, small), num_from_i64(0));
    assert_same(num_from_fixed(INT64_MIN, 63), num_from_i64(-1));
    assert_true(num_from_i64(INT64_MIN).m == -((int64_t)1 << 62));
    assert_true(num_from_i64(INT64_MAX).m == INT64_MAX);
}

static void to_fixed_rounds_and_saturates(void **state) {
    (void)state;
    mpfr_t x;
    mpfr_init2(x, 300);
    for (int i = 0; i < RANDOM; i++) {
        num_t a = random_num(80);
        int frac = (int)(next() % 160) - 40;
        bool ok = true;
        int64_t v = num_to_fixed(a, frac, &ok);
        set_num(x, a);
        mpfr_mul_2si(x, x, frac, MPFR_RNDN);
        mpfr_round(x, x);
        mpfr_t limit;
        mpfr_init2(limit, 64);
        mpfr_set_ui_2exp(limit, 1, 63, MPFR_RNDN);
        if (mpfr_cmpabs(x, limit) >= 0) {
            assert_false(ok);
            assert_true(v == (a.m < 0 ? -INT64_MAX : INT64_MAX));
        } else {
            assert_true(ok);
            assert_true(v == mpfr_get_si(x, MPFR_RNDN));
        }
        mpfr_clear(limit);
    }
    mpfr_clear(x);
}

static void rounding_to_integers(void **state) {
    (void)state;
    mpfr_t x, y;
    mpfr_inits2(300, x, y, NULL);
    for (int i = 0; i < RANDOM; i++) {
        num_t a = random_num(70);
        set_num(x, a);
        set_num(y, num_floor(a));
        mpfr_t z;
        mpfr_init2(z, 63); /* floor may need to round: -2^62 - tiny */
        mpfr_floor(z, x);
        assert_true(mpfr_equal_p(z, y));
        set_num(y, num_ceil(a));
        mpfr_ceil(z, x);
        assert_true(mpfr_equal_p(z, y));
        set_num(y, num_trunc(a));
        mpfr_trunc(z, x);
        assert_true(mpfr_equal_p(z, y));
        assert_int_equal(num_is_integer(a), mpfr_integer_p(x));
        assert_true(is_normal(num_floor(a)) && is_normal(num_ceil(a)) && is_normal(num_trunc(a)));
        num_t b = next() % 2 ? random_num(70) : a;
        set_num(y, b);
        assert_int_equal(num_cmp(a, b), (mpfr_cmp(x, y) > 0) - (mpfr_cmp(x, y) < 0));
        mpfr_clear(z);
    }
    mpfr_clears(x, y, NULL);
}

static void decimal_literals(void **state) {
    (void)state;
    mpfr_t x;
    mpfr_init2(x, 400);
    double worst = 0;
    for (int i = 0; i < RANDOM; i++) {
        uint64_t m = next() >> (next() & 63);
        int32_t n = (int32_t)(next() % (i & 1 ? 41 : 621)) - (i & 1 ? 20 : 310);
        if (m == 0) continue;
        num_t a = num_from_decimal(m, n);
        mpfr_set_ui(x, 10, MPFR_RNDN);
        mpfr_pow_si(x, x, n, MPFR_RNDN);
        mpfr_mul_ui(x, x, m, MPFR_RNDN);
        assert_true(is_normal(a));
        double u = ulps(a, x);
        if (u > worst) worst = u;
    }
    printf("# num_from_decimal worst error %.4f ulp of 2^-62\n", worst);
    assert_true(worst <= 0.5001);
    assert_same(num_from_decimal(25, -1), num_from_fixed(5, 1));
    assert_same(num_from_decimal(0, 5000), num_from_i64(0));
    assert_same(num_from_decimal(1, -5000), num_from_i64(0));
    assert_true(num_from_decimal(1, 5000).undef && num_from_decimal(1, 335).undef);
    assert_same(num_from_decimal(UINT64_MAX, INT32_MIN), num_from_i64(0));
    mpfr_clear(x);
}

static void decimal_digits(void **state) {
    (void)state;
    char text[64], wanted[64];
    for (int i = 0; i < 100000; i++) {
        num_t a = random_num(i & 1 ? 10 : 1000);
        int digits = 1 + (int)(next() % 18);
        int32_t exp10;
        int64_t v = num_to_decimal(a, digits, &exp10);
        mpfr_t x;
        mpfr_init2(x, 64);
        set_num(x, a);
        snprintf(text, sizeof text, "%lld", (long long)v);
        mpfr_exp_t e;
        /* to nearest: the only ties are short numbers, which mpfr rounds to even and we away from zero */
        mpfr_get_str(wanted, &e, 10, (size_t)digits, x, MPFR_RNDN);
        if (strcmp(text, wanted) != 0) mpfr_get_str(wanted, &e, 10, (size_t)digits, x, MPFR_RNDA);
        if (a.m != 0) {
            assert_string_equal(text, wanted);
            assert_int_equal(exp10, e - digits);
        }
        mpfr_clear(x);
        /* 18 digits survive the way there and back */
        if (a.m == 0) continue;
        int64_t d = num_to_decimal(a, 18, &exp10);
        num_t b = num_from_decimal(ints_abs64(d), exp10);
        int32_t again;
        assert_true(num_to_decimal(b, 18, &again) == (d < 0 ? -d : d));
        assert_int_equal(again, exp10);
    }
    int32_t exp10;
    assert_true(num_to_decimal(num_from_fixed(5, 1), 1, &exp10) == 3 && exp10 == 0);
    assert_true(num_to_decimal(num_from_fixed(-999999, 0), 3, &exp10) == -100 && exp10 == 4);
    assert_true(num_to_decimal(num_from_i64(0), 3, &exp10) == 0 && exp10 == 0);
}

static void fast_forms_are_the_same(void **state) {
    (void)state;
    num_t rare[] = {num_undef(), num_from_i64(0), num_from_i64(1), num_ldexp(num_from_i64(-1), 1099)};
    for (int i = 0; i < 10000; i++) {
        num_t a = next() % 8 ? random_num(40) : rare[next() % 4], b = next() % 8 ? random_num(40) : rare[next() % 4];
        assert_same(num_fast_add(a, b), num_add(a, b));
        assert_same(num_fast_sub(a, b), num_sub(a, b));
        assert_same(num_fast_mul(a, b), num_mul(a, b));
        assert_same(num_fast_neg(a), num_neg(a));
        assert_same(num_mul(a, b), num_mul(b, a));
        assert_same(num_add(a, b), num_add(b, a));
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sums),
        cmocka_unit_test(products),
        cmocka_unit_test(square_roots),
        cmocka_unit_test(integers_are_exact),
        cmocka_unit_test(undefined_travels),
        cmocka_unit_test(limits),
        cmocka_unit_test(to_fixed_rounds_and_saturates),
        cmocka_unit_test(rounding_to_integers),
        cmocka_unit_test(decimal_literals),
        cmocka_unit_test(decimal_digits),
        cmocka_unit_test(fast_forms_are_the_same),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
