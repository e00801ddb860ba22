/* test_num_double.c - arithmetic rounds as the machine's doubles do, bit for bit. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "num/num_double.h"

static double to_double(num_t a) {
    return ldexp((double)a.m, a.e);
} /* exact: 53 bits are in use */

static num_t of_double(double x) {
    int e;
    double m = frexp(x, &e);
    return num_ldexp(num_from_i64((int64_t)ldexp(m, 53)), e - 53);
}

static uint64_t random_state = 1;
static uint64_t draw(void) {
    random_state = random_state * 6364136223846793005u + 1442695040888963407u;
    return random_state ^ random_state >> 33;
}

/* A double whose significand has few bits, or runs of equal bits, or is anything: what ties and carries need. */
static double odd_double(void) {
    uint64_t bits = draw() >> 11;
    switch (draw() % 4) {
    case 0:
        bits &= ~(uint64_t)0 << draw() % 53;
        break;
    case 1:
        bits |= ((uint64_t)1 << draw() % 53) - 1;
        break;
    case 2:
        bits = ((uint64_t)1 << draw() % 53) + draw() % 3;
        break;
    default:
        break;
    }
    double x = ldexp((double)(bits & (((uint64_t)1 << 53) - 1)), (int)(draw() % 120) - 113);
    return draw() % 2 ? -x : x;
}

static void assert_same(num_t got, double expected, double a, char op, double b) {
    if (got.undef || to_double(got) != expected)
        fail_msg("%.17g %c %.17g: %.17g, not %.17g", a, op, b, to_double(got), expected);
}

static void arithmetic_is_ieee(void **state) {
    (void)state;
    enum { PAIRS = 400000 };
    for (int i = 0; i < PAIRS; i++) {
        double a = odd_double(), b = odd_double();
        num_t na = of_double(a), nb = of_double(b);
        assert_same(num_double_add(na, nb), a + b, a, '+', b);
        assert_same(num_double_mul(na, nb), a * b, a, '*', b);
        if (b == 0) continue;
#if CONFIG_DOUBLE_WORDS
        num_t factor = nb;
        factor.m = ints_with_sign(ints_abs64(nb.m) & ~(uint64_t)UINT32_MAX, nb.m);
        if (a != 0) assert_same(double_words_mul_short(na, factor), a * to_double(factor), a, '*', to_double(factor));
#endif
        assert_same(num_double_div(na, nb), a / b, a, '/', b);
        assert_same(num_double_sqrt(num_abs(nb)), sqrt(fabs(b)), b, 'r', b);
        /* exact quotients and roots, and those next to a middle */
        num_t product = num_double_mul(na, nb);
        assert_same(num_double_div(product, nb), a * b / b, a * b, '/', b);
        assert_same(num_double_sqrt(num_double_mul(nb, nb)), sqrt(b * b), b, 'q', b);
    }
    print_message("# sums, products, quotients, roots: %d pairs as IEEE\n", PAIRS);
}

static void rounding_is_to_even(void **state) {
    (void)state;
    int64_t one = (int64_t)1 << 53;
    for (int64_t k = -9; k <= 9; k++) {
        double x = (double)(one * 8 + k); /* the compiler's own rounding */
        assert_true(to_double(num_double(num_from_i64(one * 8 + k))) == x);
        assert_true(to_double(num_double(num_from_i64(-one * 8 - k))) == -x);
        x = (double)(INT64_MAX + (k < 0 ? k : 0));
        assert_true(to_double(num_double(num_from_i64(INT64_MAX + (k < 0 ? k : 0)))) == x);
    }
    assert_true(num_double(num_from_i64(0)).m == 0);
    assert_true(num_double(num_undef()).undef);
}

static void range_is_that_of_doubles(void **state) {
    (void)state;
    num_t one = num_from_i64(1), top = num_ldexp(num_from_i64(((int64_t)1 << 53) - 1), 971);
    assert_true(to_double(num_double(top)) == 0x1.fffffffffffffp1023);
    assert_true(num_double_add(top, top).undef);
    assert_true(num_double_mul(top, num_from_fixed(3, 1)).undef);
    assert_true(num_double_add(top, num_ldexp(one, 970)).undef); /* carries over the limit */
    assert_false(num_double_add(top, num_ldexp(one, 969)).undef);
    assert_true(num_double(num_ldexp(one, 1024)).undef);
    assert_false(num_double(num_ldexp(one, 1023)).undef);
    assert_true(num_double(num_ldexp(one, -1075)).m == 0);
    assert_true(num_double(num_ldexp(one, -1074)).m != 0);
    num_t zero = num_from_i64(0);
    assert_true(num_double_add(zero, one).m == one.m && num_double_add(one, zero).m == one.m);
    assert_true(num_double_mul(zero, one).m == 0);
    assert_true(num_double_mul(num_undef(), zero).undef && num_double_add(one, num_undef()).undef);
    assert_true(num_double_add(one, num_neg(one)).m == 0);
    assert_true(num_double_add(num_ldexp(one, -64), one).m == one.m);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(arithmetic_is_ieee),
        cmocka_unit_test(rounding_is_to_even),
        cmocka_unit_test(range_is_that_of_doubles),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
