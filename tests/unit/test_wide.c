/* wide.h against GMP: edge operands times edge operands, then seeded random ones of every width. */
#include <gmp.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "num/wide.h"

static uint64_t seed = 0x9e3779b97f4a7c15u;
static uint64_t next(void) {
    seed ^= seed << 13;
    seed ^= seed >> 7;
    seed ^= seed << 17;
    return seed;
}

static const int64_t edge[] = {0,
                               1,
                               -1,
                               2,
                               -2,
                               INT32_MAX,
                               INT32_MIN,
                               (int64_t)UINT32_MAX,
                               (int64_t)1 << 32,
                               -((int64_t)1 << 32),
                               ((int64_t)1 << 62) - 1,
                               (int64_t)1 << 62,
                               INT64_MAX,
                               INT64_MAX - 1,
                               INT64_MIN,
                               INT64_MIN + 1};
enum { EDGES = sizeof edge / sizeof *edge, RANDOM = 200000 };

/* Operand i of a sequence that first runs through the edges. */
static int64_t operand(int i, int stride) {
    if (i < EDGES * EDGES) return edge[i / stride % EDGES];
    return (int64_t)next() >> (next() & 63);
}

static void set_wide(mpz_t z, wide_t w) {
    mpz_set_si(z, (long)w.hi);
    mpz_mul_2exp(z, z, 64);
    mpz_add_ui(z, z, w.lo);
}

static void products_are_exact(void **state) {
    (void)state;
    mpz_t p, q;
    mpz_inits(p, q, NULL);
    for (int i = 0; i < EDGES * EDGES + RANDOM; i++) {
        int64_t a = operand(i, 1), b = operand(i, EDGES);
        set_wide(p, wide_mul_s64(a, b));
        mpz_set_si(q, (long)a);
        mpz_mul_si(q, q, (long)b);
        assert_int_equal(mpz_cmp(p, q), 0);
        wide_u_t u = wide_mul_u64((uint64_t)a, (uint64_t)b);
        mpz_set_ui(p, u.hi);
        mpz_mul_2exp(p, p, 64);
        mpz_add_ui(p, p, u.lo);
        mpz_set_ui(q, (uint64_t)a);
        mpz_mul_ui(q, q, (uint64_t)b);
        assert_int_equal(mpz_cmp(p, q), 0);
        assert_true(wide_mulhi_u64((uint64_t)a, (uint64_t)b) == u.hi);
    }
    mpz_clears(p, q, NULL);
}

/* Words made of halves at their limits, then any. */
static void products_of_words_are_exact(void **state) {
    static const uint16_t half[] = {0, 1, 2, 0x1234, 0x7fff, 0x8000, 0x8001, 0xfffe, 0xffff};
    enum { HALVES = sizeof half / sizeof *half, WORDS = HALVES * HALVES };
    (void)state;
    for (int i = 0; i < WORDS * WORDS + RANDOM; i++) {
        uint32_t a = (uint32_t)next() >> (next() & 31), b = (uint32_t)next();
        if (i < WORDS * WORDS) {
            a = (uint32_t)half[i % HALVES] << 16 | half[i / HALVES % HALVES];
            b = (uint32_t)half[i / WORDS % HALVES] << 16 | half[i / WORDS / HALVES];
        }
        assert_true(wide_mul_u32(a, b) == (uint64_t)a * b);
        assert_true(wide_mul_s32((int32_t)a, (int32_t)b) == (int64_t)(int32_t)a * (int32_t)b);
    }
}

static void sums_shifts_and_comparisons_agree(void **state) {
    (void)state;
    mpz_t x, y, z;
    mpz_inits(x, y, z, NULL);
    for (int i = 0; i < RANDOM; i++) {
        /* halved, so that the sum does not wrap */
        wide_t a = wide_sar((wide_t){operand(i, 1), next()}, 1 + (int)(next() % 127));
        wide_t b = wide_sar((wide_t){operand(i, EDGES), next()}, 1 + (int)(next() % 127));
        if (next() % 8 == 0) b = a;
        if (next() % 8 == 0) b.hi = a.hi;
        set_wide(x, a);
        set_wide(y, b);
        assert_int_equal(wide_cmp(a, b), (mpz_cmp(x, y) > 0) - (mpz_cmp(x, y) < 0));
        assert_int_equal(wide_sign(a), mpz_sgn(x));
        mpz_add(z, x, y);
        wide_t s = wide_add(a, b);
        mpz_t t;
        mpz_init(t);
        set_wide(t, s);
        assert_int_equal(mpz_cmp(t, z), 0);
        mpz_sub(z, x, y);
        set_wide(t, wide_sub(a, b));
        assert_int_equal(mpz_cmp(t, z), 0);
        mpz_neg(z, x);
        set_wide(t, wide_neg(a));
        assert_int_equal(mpz_cmp(t, z), 0);
        int n = (int)(next() % 128);
        mpz_fdiv_q_2exp(z, x, (mp_bitcnt_t)n);
        set_wide(t, wide_sar(a, n));
        assert_int_equal(mpz_cmp(t, z), 0);
        /* back up again: what fell off at the bottom is gone, nothing else */
        mpz_mul_2exp(z, z, (mp_bitcnt_t)n);
        set_wide(t, wide_shl(wide_sar(a, n), n));
        assert_int_equal(mpz_cmp(t, z), 0);
        mpz_clear(t);
    }
    mpz_clears(x, y, z, NULL);
}

static void determinant_signs_are_exact(void **state) {
    (void)state;
    mpz_t p, q;
    mpz_inits(p, q, NULL);
    for (int i = 0; i < RANDOM; i++) {
        int64_t a = operand(i, 1), b = operand((int)(next() % (EDGES * EDGES)), EDGES), c = operand(i, EDGES),
                d = (int64_t)next();
        switch (next() % 4) {
        case 0: /* proportional, or off by one: where rounding would decide wrongly */
            a >>= 33;
            b >>= 33;
            c = a * 1234567 + (int64_t)(next() % 3) - 1;
            d = b * 1234567;
            break;
        case 1:
            c = a;
            d = b;
            break;
        default:
            break;
        }
        mpz_set_si(p, (long)a);
        mpz_mul_si(p, p, (long)d);
        mpz_set_si(q, (long)b);
        mpz_mul_si(q, q, (long)c);
        mpz_sub(p, p, q);
        assert_int_equal(wide_det_sign(a, b, c, d), mpz_sgn(p));
    }
    mpz_clears(p, q, NULL);
}

static void products_of_more_are_exact_modulo_2_128(void **state) {
    (void)state;
    mpz_t p, q, t;
    mpz_inits(p, q, t, NULL);
    for (int i = 0; i < EDGES * EDGES + RANDOM; i++) {
        wide_t a = {operand(i, 1), (uint64_t)operand(i, EDGES)};
        int64_t n[3] = {operand(i, 1), operand(i, EDGES), operand(i, 1)};
        int32_t d[3] = {(int32_t)operand(i, EDGES), (int32_t)next(), (int32_t)operand(i, 1)};
        set_wide(p, wide_times_s32(a, d[0]));
        set_wide(q, a);
        mpz_mul_si(q, q, d[0]);
        mpz_sub(q, q, p);
        assert_true(mpz_divisible_2exp_p(q, 128));
        set_wide(p, wide_dot3(n, d));
        mpz_set_si(q, 0);
        for (int k = 0; k < 3; k++) {
            mpz_set_si(t, (long)n[k]);
            mpz_mul_si(t, t, d[k]);
            mpz_add(q, q, t);
        }
        assert_int_equal(mpz_cmp(p, q), 0);
    }
    mpz_clears(p, q, t, NULL);
}

static void division_gives_quotient_and_remainder(void **state) {
    (void)state;
    mpz_t n, q, r;
    mpz_inits(n, q, r, NULL);
    for (int i = 0; i < EDGES * EDGES + RANDOM; i++) {
        uint64_t d = (uint64_t)operand(i, 1), lo = (uint64_t)operand(i, EDGES), hi, rem;
        if (d == 0) continue;
        hi = i & 1 ? d - 1 : next() % d;
        mpz_set_ui(n, hi);
        mpz_mul_2exp(n, n, 64);
        mpz_add_ui(n, n, lo);
        mpz_tdiv_qr_ui(q, r, n, d);
        assert_true(wide_div_u64(hi, lo, d, &rem) == mpz_get_ui(q));
        assert_true(rem == mpz_get_ui(r));
    }
    mpz_clears(n, q, r, NULL);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(products_are_exact),
        cmocka_unit_test(products_of_words_are_exact),
        cmocka_unit_test(sums_shifts_and_comparisons_agree),
        cmocka_unit_test(determinant_signs_are_exact),
        cmocka_unit_test(products_of_more_are_exact_modulo_2_128),
        cmocka_unit_test(division_gives_quotient_and_remainder),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
