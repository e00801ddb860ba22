/* Every entry of func_tables.c computed again with MPFR: the exact value rounded to nearest. */
#include <mpfr.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "num/func_tables.h"

enum { PRECISION = 300 };

/* x * 2^q to nearest is `entry`. */
static void assert_rounds_to_u64(mpfr_t x, int q, uint64_t entry) {
    mpfr_t scaled;
    mpfr_init2(scaled, PRECISION);
    mpfr_mul_2si(scaled, x, q, MPFR_RNDN);
    mpfr_round(scaled, scaled);
    assert_int_equal(mpfr_cmp_ui(scaled, entry), 0);
    mpfr_clear(scaled);
}

static void assert_rounds_to(mpfr_t x, int q, int64_t entry) {
    mpfr_t scaled;
    mpfr_init2(scaled, PRECISION);
    mpfr_mul_2si(scaled, x, q, MPFR_RNDN);
    mpfr_round(scaled, scaled);
    assert_int_equal(mpfr_cmp_si(scaled, (long)entry), 0);
    mpfr_clear(scaled);
}

static void elementary_tables(void **state) {
    (void)state;
    mpfr_t x, pi;
    mpfr_inits2(PRECISION, x, pi, NULL);
    mpfr_const_pi(pi, MPFR_RNDN);
    for (int j = 0; j < 64; j++) {
        mpfr_set_si_2exp(x, j, -6, MPFR_RNDN);
        mpfr_exp2(x, x, MPFR_RNDN);
        assert_rounds_to_u64(x, 62, func_tables_exp2[j]);
    }
    for (int j = 0; j < 65; j++) {
        mpfr_mul_si(x, pi, j, MPFR_RNDN);
        mpfr_div_ui(x, x, 128, MPFR_RNDN);
        mpfr_sin(x, x, MPFR_RNDN);
        assert_rounds_to_u64(x, 62, func_tables_sin[j]);
        mpfr_set_si_2exp(x, j, -6, MPFR_RNDN);
        mpfr_atan(x, x, MPFR_RNDN);
        assert_rounds_to_u64(x, 64, func_tables_atan[j]);
    }
    mpfr_clears(x, pi, NULL);
}

static void logarithm_tables(void **state) {
    (void)state;
    mpfr_t x, y, log2;
    mpfr_inits2(PRECISION, x, y, log2, NULL);
    mpfr_const_log2(log2, MPFR_RNDN);
    for (int j = 0; j < 65; j++) {
        mpfr_set_si(x, 2048 * 64, MPFR_RNDN);
        mpfr_div_ui(x, x, (unsigned long)(64 + j), MPFR_RNDN);
        assert_rounds_to(x, 0, func_tables_log_factor[j]);
        mpfr_set_si_2exp(x, func_tables_log_factor[j], -11, MPFR_RNDN);
        mpfr_log(x, x, MPFR_RNDN);
        mpfr_neg(x, x, MPFR_RNDN);
        if (j >= FUNC_TABLES_LOG_HALF) mpfr_sub(x, x, log2, MPFR_RNDN);
        mpfr_mul_2si(x, x, 116, MPFR_RNDN);
        mpfr_round(x, x);
        mpfr_set_si_2exp(y, (long)func_tables_log[j].hi, 64, MPFR_RNDN);
        mpfr_add_ui(y, y, func_tables_log[j].lo, MPFR_RNDN);
        assert_int_equal(mpfr_cmp(x, y), 0);
    }
    mpfr_clears(x, y, log2, NULL);
}

static void digits_of_a_turn(void **state) {
    (void)state;
    mpfr_t x, word;
    mpfr_init2(x, 1400);
    mpfr_init2(word, 64);
    mpfr_const_pi(x, MPFR_RNDN);
    mpfr_mul_2ui(x, x, 1, MPFR_RNDN);
    mpfr_ui_div(x, 1, x, MPFR_RNDN);
    for (int i = 0; i < 20; i++) {
        mpfr_mul_2ui(x, x, 64, MPFR_RNDN);
        mpfr_rint_floor(word, x, MPFR_RNDZ);
        assert_true(mpfr_get_ui(word, MPFR_RNDZ) == func_tables_turn[i]);
        mpfr_sub(x, x, word, MPFR_RNDN);
    }
    mpfr_clears(x, word, NULL);
}

/* The functions behind the Chebyshev sums, of t. */
static void erf_inner(mpfr_t r, mpfr_t t) {
    mpfr_t x;
    mpfr_init2(x, PRECISION);
    mpfr_add_ui(x, t, 1, MPFR_RNDN);
    mpfr_div_ui(x, x, 2, MPFR_RNDN);
    mpfr_sqrt(x, x, MPFR_RNDN);
    mpfr_erf(r, x, MPFR_RNDN);
    mpfr_div(r, r, x, MPFR_RNDN);
    mpfr_clear(x);
}

static void erfc_outer(mpfr_t r, mpfr_t t) { /* x = 7 / (1 - t) - 5/2 */
    mpfr_t x, y;
    mpfr_inits2(2 * PRECISION, x, y, NULL);
    mpfr_ui_sub(x, 1, t, MPFR_RNDN);
    mpfr_ui_div(x, 7, x, MPFR_RNDN);
    mpfr_sub_d(y, x, 2.5, MPFR_RNDN);
    mpfr_erfc(r, y, MPFR_RNDN);
    mpfr_mul(r, r, x, MPFR_RNDN);
    mpfr_sqr(y, y, MPFR_RNDN);
    mpfr_exp(y, y, MPFR_RNDN);
    mpfr_mul(r, r, y, MPFR_RNDN);
    mpfr_clears(x, y, NULL);
}

static void rgamma(mpfr_t r, mpfr_t t) {
    mpfr_add_ui(r, t, 3, MPFR_RNDN);
    mpfr_div_ui(r, r, 2, MPFR_RNDN);
    mpfr_gamma(r, r, MPFR_RNDN);
    mpfr_ui_div(r, 1, r, MPFR_RNDN);
}

static void bessel_inner(mpfr_t r, mpfr_t t, int n) {
    mpfr_t x;
    mpfr_init2(x, PRECISION);
    mpfr_add_ui(x, t, 1, MPFR_RNDN);
    mpfr_mul_ui(x, x, 32, MPFR_RNDN);
    mpfr_sqrt(x, x, MPFR_RNDN);
    mpfr_jn(r, n, x, MPFR_RNDN);
    if (n == 1) mpfr_div(r, r, x, MPFR_RNDN);
    mpfr_clear(x);
}
static void j0_inner(mpfr_t r, mpfr_t t) {
    bessel_inner(r, t, 0);
}
static void j1_inner(mpfr_t r, mpfr_t t) {
    bessel_inner(r, t, 1);
}

/* P (x Q when second): sqrt(pi x / 2) (J cos chi + Y sin chi), sqrt(pi x / 2) (Y cos chi - J sin chi). */
static void bessel_outer(mpfr_t r, mpfr_t t, int n, int second) {
    mpfr_t x, pi, s, c, j, y;
    mpfr_inits2(PRECISION, x, pi, s, c, j, y, NULL);
    mpfr_add_ui(x, t, 1, MPFR_RNDN);
    mpfr_div_ui(x, x, 2, MPFR_RNDN);
    mpfr_sqrt(x, x, MPFR_RNDN);
    mpfr_ui_div(x, 8, x, MPFR_RNDN);
    mpfr_const_pi(pi, MPFR_RNDN);
    mpfr_mul_ui(s, pi, (unsigned long)(2 * n + 1), MPFR_RNDN);
    mpfr_div_ui(s, s, 4, MPFR_RNDN);
    mpfr_sub(s, x, s, MPFR_RNDN);
    mpfr_sin_cos(s, c, s, MPFR_RNDN);
    mpfr_jn(j, n, x, MPFR_RNDN);
    mpfr_yn(y, n, x, MPFR_RNDN);
    mpfr_mul(r, second ? y : j, c, MPFR_RNDN);
    mpfr_mul(s, second ? j : y, s, MPFR_RNDN);
    if (second)
        mpfr_sub(r, r, s, MPFR_RNDN);
    else
        mpfr_add(r, r, s, MPFR_RNDN);
    mpfr_mul(pi, pi, x, MPFR_RNDN);
    mpfr_div_ui(pi, pi, 2, MPFR_RNDN);
    mpfr_sqrt(pi, pi, MPFR_RNDN);
    mpfr_mul(r, r, pi, MPFR_RNDN);
    if (second) mpfr_mul(r, r, x, MPFR_RNDN);
    mpfr_clears(x, pi, s, c, j, y, NULL);
}
static void p0(mpfr_t r, mpfr_t t) {
    bessel_outer(r, t, 0, 0);
}
static void q0(mpfr_t r, mpfr_t t) {
    bessel_outer(r, t, 0, 1);
}
static void p1(mpfr_t r, mpfr_t t) {
    bessel_outer(r, t, 1, 0);
}
static void q1(mpfr_t r, mpfr_t t) {
    bessel_outer(r, t, 1, 1);
}

/* c[k] from the values at `nodes` Chebyshev nodes; with so many nodes the aliasing is below the rounding. */
static void check_series(const int64_t *c, int n, void (*f)(mpfr_t, mpfr_t), int nodes) {
    mpfr_t value[64], angle[64], sum, t;
    mpfr_inits2(PRECISION, sum, t, NULL);
    for (int i = 0; i < nodes; i++) {
        mpfr_inits2(PRECISION, value[i], angle[i], NULL);
        mpfr_const_pi(angle[i], MPFR_RNDN);
        mpfr_mul_ui(angle[i], angle[i], (unsigned long)(2 * i + 1), MPFR_RNDN);
        mpfr_div_ui(angle[i], angle[i], (unsigned long)(2 * nodes), MPFR_RNDN);
        mpfr_cos(t, angle[i], MPFR_RNDN);
        f(value[i], t);
    }
    for (int k = 0; k < nodes; k++) {
        mpfr_set_ui(sum, 0, MPFR_RNDN);
        for (int i = 0; i < nodes; i++) {
            mpfr_mul_ui(t, angle[i], (unsigned long)k, MPFR_RNDN);
            mpfr_cos(t, t, MPFR_RNDN);
            mpfr_fma(sum, t, value[i], sum, MPFR_RNDN);
        }
        mpfr_div_ui(sum, sum, (unsigned long)nodes, MPFR_RNDN);
        if (k > 0) mpfr_mul_2ui(sum, sum, 1, MPFR_RNDN);
        if (k < n)
            assert_rounds_to(sum, 60, c[k]);
        else
            assert_true(mpfr_cmpabs(sum, (mpfr_set_ui_2exp(t, 1, -61, MPFR_RNDN), t)) < 0); /* cut off */
    }
    for (int i = 0; i < nodes; i++) mpfr_clears(value[i], angle[i], NULL);
    mpfr_clears(sum, t, NULL);
}
#define CHECK(table, f, nodes) check_series(table, (int)(sizeof table / sizeof *table), f, nodes)

static void chebyshev_series(void **state) {
    (void)state;
    CHECK(func_tables_erf, erf_inner, 48);
    CHECK(func_tables_erfc, erfc_outer, 64);
    CHECK(func_tables_rgamma, rgamma, 48);
    CHECK(func_tables_j0, j0_inner, 48);
    CHECK(func_tables_j1, j1_inner, 48);
    CHECK(func_tables_p0, p0, 48);
    CHECK(func_tables_q0, q0, 48);
    CHECK(func_tables_p1, p1, 48);
    CHECK(func_tables_q1, q1, 48);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(elementary_tables),
        cmocka_unit_test(logarithm_tables),
        cmocka_unit_test(digits_of_a_turn),
        cmocka_unit_test(chebyshev_series),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
