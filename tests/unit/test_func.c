/* func.h against MPFR: random and hard arguments of every function; prints and limits the worst relative
 * error of each domain. */
#include <math.h>
#include <mpfr.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "num/func.h"
#include "num/ints.h"

/* Arguments per line. `make test` has to be quick; RIDGELINE_TEST_SCALE=20 makes the numbers in func.h. */
static int random_count = 10000;
enum { PRECISION = 160 };

static uint64_t seed = 0xda942042e4dd58b5u;
static uint64_t next(void) {
    seed ^= seed << 13;
    seed ^= seed >> 7;
    seed ^= seed << 17;
    return seed;
}

static void set_num(mpfr_t r, num_t a) {
    mpfr_set_si_2exp(r, (long)a.m, a.e, MPFR_RNDN);
}

/* Exactly the double (tests are allowed to have them). */
static num_t from_double(double d) {
    int e;
    double f = frexp(d, &e);
    return num_from_fixed((int64_t)ldexp(f, 60), 60 - e);
}

/* Uniform in [lo, hi] with 63 random bits. */
static num_t uniform(double lo, double hi) {
    num_t t = num_from_fixed((int64_t)(next() >> 1), 63);
    return num_add(from_double(lo), num_mul(t, num_sub(from_double(hi), from_double(lo))));
}

/* Random sign and size, |a| between 2^lo and 2^hi. */
static num_t any_size(int lo, int hi) {
    int64_t m = (int64_t)(next() >> 2 | (uint64_t)1 << 62);
    return num_from_fixed(next() & 1 ? m : -m, 62 - lo - (int)(next() % (unsigned)(hi - lo)));
}

/* The worst error of one line of the table so far. */
typedef struct worst {
    double error;
    num_t at;
} worst_t;

static void note(worst_t *w, num_t got, mpfr_t exact, num_t at, bool absolute) {
    static mpfr_t d;
    static bool ready;
    if (!ready) mpfr_init2(d, PRECISION);
    ready = true;
    double error = INFINITY;
    if (!got.undef) {
        set_num(d, got);
        mpfr_sub(d, d, exact, MPFR_RNDN);
        if (!absolute && !mpfr_zero_p(d)) mpfr_div(d, d, exact, MPFR_RNDN);
        error = fabs(mpfr_get_d(d, MPFR_RNDN));
    }
    if (!(error <= w->error)) *w = (worst_t){error, at};
}

static void report(const char *name, const char *domain, worst_t w, double limit_log2, bool absolute) {
    printf("# %-7s %-34s worst %s error 2^%.1f at %.17g\n", name, domain, absolute ? "absolute" : "relative",
           log2(w.error), ldexp((double)w.at.m, w.at.e));
    assert_true(w.error <= exp2(limit_log2));
}

typedef num_t (*unary_t)(num_t);
typedef int (*mpfr_unary_t)(mpfr_t, mpfr_srcptr, mpfr_rnd_t);

typedef struct row {
    const char *name, *domain;
    unary_t f;
    mpfr_unary_t exact;
    double lo, hi;     /* uniform arguments ... */
    int elo, ehi;      /* ... or, when different, any size of argument */
    double limit_log2; /* of the relative error, or of the absolute one: */
    bool absolute;
} row_t;

static int exact_norm(mpfr_t r, mpfr_srcptr a, mpfr_rnd_t rnd) {
    mpfr_t t;
    mpfr_init2(t, PRECISION + 40);
    mpfr_sqrt_ui(t, 2, rnd);
    mpfr_div(t, a, t, rnd);
    mpfr_neg(t, t, rnd);
    mpfr_erfc(r, t, rnd);
    mpfr_div_ui(r, r, 2, rnd);
    mpfr_clear(t);
    return 0;
}

static void run(const row_t *row) {
    mpfr_t x, y;
    mpfr_inits2(PRECISION, x, y, NULL);
    worst_t w = {0, {0, 0, false}};
    int count =
        row->exact == mpfr_j0 || row->exact == mpfr_j1 || row->exact == mpfr_gamma ? random_count / 5 : random_count;
    for (int i = 0; i < count; i++) {
        num_t a = row->elo != row->ehi ? any_size(row->elo, row->ehi) : uniform(row->lo, row->hi);
        if (row->f == func_log || row->f == func_log10) a = num_abs(a);
        set_num(x, a);
        row->exact(y, x, MPFR_RNDN);
        note(&w, row->f(a), y, a, row->absolute);
    }
    report(row->name, row->domain, w, row->limit_log2, row->absolute);
    mpfr_clears(x, y, NULL);
}

static void run_all(const row_t *rows, size_t n) {
    for (size_t i = 0; i < n; i++) run(&rows[i]);
}
#define RUN(rows) run_all(rows, sizeof rows / sizeof *rows)

static void exponentials(void **state) {
    (void)state;
    static const row_t rows[] = {
        {"exp", "[-1, 1]", func_exp, mpfr_exp, -1, 1, 0, 0, -54, false},
        {"exp", "[-700, 700]", func_exp, mpfr_exp, -700, 700, 0, 0, -53, false},
        {"exp", "any size", func_exp, mpfr_exp, 0, 0, -80, 9, -53, false},
        {"sinh", "[-1.1, 1.1]", func_sinh, mpfr_sinh, -1.1, 1.1, 0, 0, -53, false},
        {"sinh", "any size", func_sinh, mpfr_sinh, 0, 0, -80, 9, -52, false},
        {"cosh", "any size", func_cosh, mpfr_cosh, 0, 0, -80, 9, -53, false},
        {"tanh", "[-2, 2]", func_tanh, mpfr_tanh, -2, 2, 0, 0, -53, false},
        {"tanh", "any size", func_tanh, mpfr_tanh, 0, 0, -80, 30, -53, false},
    };
    RUN(rows);
}

static void logarithms(void **state) {
    (void)state;
    static const row_t rows[] = {
        {"log", "(0, 10]", func_log, mpfr_log, 0, 10, 0, 0, -59, false},
        {"log", "[0.98, 1.02]", func_log, mpfr_log, 0.98, 1.02, 0, 0, -59, false},
        {"log", "any size", func_log, mpfr_log, 0, 0, -1090, 1090, -59, false},
        {"log10", "[0.9, 1.1]", func_log10, mpfr_log10, 0.9, 1.1, 0, 0, -59, false},
        {"log10", "any size", func_log10, mpfr_log10, 0, 0, -1090, 1090, -59, false},
    };
    RUN(rows);
    mpfr_t x, y;
    mpfr_inits2(PRECISION, x, y, NULL);
    worst_t w = {0, {0, 0, false}};
    for (int i = 1; i < 63; i++) { /* 1 +- 2^-i */
        for (int s = -1; s <= 1; s += 2) {
            num_t a = num_add(num_from_i64(1), num_from_fixed(s, i));
            set_num(x, a);
            mpfr_log(y, x, MPFR_RNDN);
            note(&w, func_log(a), y, a, false);
        }
    }
    report("log", "1 +- 2^-i", w, -59, false);
    for (int i = -300; i <= 300; i++) { /* what people test an axis with */
        num_t l = func_log10(num_from_decimal(1, i));
        assert_true(num_cmp(l, num_from_i64(i)) == 0);
    }
    assert_true(func_log(num_from_i64(0)).undef && func_log(num_from_i64(-1)).undef);
    assert_true(func_log10(num_from_i64(0)).undef);
    mpfr_clears(x, y, NULL);
}

static void trigonometry(void **state) {
    (void)state;
    static const row_t rows[] = {
        {"sin", "[-10, 10]", func_sin, mpfr_sin, -10, 10, 0, 0, -54, false},
        {"sin", "[-1e5, 1e5]", func_sin, mpfr_sin, -1e5, 1e5, 0, 0, -54, false},
        {"sin", "[0, 1e15]", func_sin, mpfr_sin, 0, 1e15, 0, 0, -54, false},
        {"sin", "any size", func_sin, mpfr_sin, 0, 0, -80, 1099, -54, false},
        {"cos", "[-10, 10]", func_cos, mpfr_cos, -10, 10, 0, 0, -54, false},
        {"cos", "any size", func_cos, mpfr_cos, 0, 0, -80, 1099, -54, false},
        {"tan", "[-10, 10]", func_tan, mpfr_tan, -10, 10, 0, 0, -53, false},
        {"tan", "any size", func_tan, mpfr_tan, 0, 0, -80, 1099, -53, false},
    };
    RUN(rows);
    /* the numbers next to multiples of pi/2, and of pi/256 where the table changes */
    mpfr_t x, y, pi;
    mpfr_inits2(PRECISION + 64, x, y, pi, NULL);
    mpfr_const_pi(pi, MPFR_RNDN);
    static const struct {
        const char *name;
        unary_t f;
        mpfr_unary_t exact;
    } f[] = {{"sin", func_sin, mpfr_sin}, {"cos", func_cos, mpfr_cos}, {"tan", func_tan, mpfr_tan}};
    for (int which = 0; which < 3; which++) {
        worst_t w = {0, {0, 0, false}};
        for (int i = 0; i < random_count; i++) {
            int64_t n = (int64_t)next() >> (next() % 60);
            mpfr_mul_si(x, pi, (long)(n >> 1), MPFR_RNDN);
            mpfr_div_ui(x, x, i & 1 ? 2 : 256, MPFR_RNDN);
            if (n == 0 || mpfr_zero_p(x)) continue;
            mpfr_exp_t e = mpfr_get_exp(x);
            mpfr_mul_2si(y, x, 63 - (long)e, MPFR_RNDN);
            int64_t m = mpfr_get_si(y, MPFR_RNDZ);
            num_t a = num_from_fixed(m + (int64_t)(next() % 3) - 1, 63 - (int)e);
            set_num(x, a);
            f[which].exact(y, x, MPFR_RNDN);
            note(&w, f[which].f(a), y, a, false);
        }
        report(f[which].name, "next to n pi/2 and n pi/256", w, -53, false);
    }
    mpfr_clears(x, y, pi, NULL);
}

static void inverse_trigonometry(void **state) {
    (void)state;
    static const row_t rows[] = {
        {"atan", "[-2, 2]", func_atan, mpfr_atan, -2, 2, 0, 0, -55, false},
        {"atan", "any size", func_atan, mpfr_atan, 0, 0, -200, 200, -55, false},
        {"asin", "[-1, 1]", func_asin, mpfr_asin, -1, 1, 0, 0, -55, false},
        {"asin", "any size", func_asin, mpfr_asin, 0, 0, -80, 0, -55, false},
        {"acos", "[-1, 1]", func_acos, mpfr_acos, -1, 1, 0, 0, -55, false},
        {"acos", "[1-1e-9, 1]", func_acos, mpfr_acos, 1 - 1e-9, 1, 0, 0, -55, false},
        {"acos", "any size", func_acos, mpfr_acos, 0, 0, -80, 0, -55, false},
    };
    RUN(rows);
    mpfr_t x, y, z;
    mpfr_inits2(PRECISION, x, y, z, NULL);
    worst_t w = {0, {0, 0, false}};
    for (int i = 0; i < 5 * random_count; i++) {
        num_t a = any_size(-70, 70), b = i & 1 ? any_size(-70, 70) : num_mul(a, uniform(-4, 4));
        if (b.m == 0) continue;
        set_num(y, a);
        set_num(x, b);
        mpfr_atan2(z, y, x, MPFR_RNDN);
        note(&w, func_atan2(a, b), z, a, false);
    }
    report("atan2", "four quadrants, any size", w, -55, false);
    mpfr_clears(x, y, z, NULL);
    num_t zero = num_from_i64(0), one = num_from_i64(1), minus = num_from_i64(-1), pi = func_pi();
    assert_int_equal(num_cmp(func_atan2(zero, zero), zero), 0);
    assert_int_equal(num_cmp(func_atan2(zero, one), zero), 0);
    assert_int_equal(num_cmp(func_atan2(zero, minus), pi), 0);
    assert_int_equal(num_cmp(func_atan2(one, zero), num_ldexp(pi, -1)), 0);
    assert_int_equal(num_cmp(func_atan2(minus, zero), num_ldexp(pi, -1)), -1);
    assert_int_equal(num_cmp(func_acos(minus), pi), 0);
    assert_int_equal(num_cmp(func_acos(one), zero), 0);
    assert_int_equal(num_cmp(func_asin(one), num_ldexp(pi, -1)), 0);
    assert_true(func_asin(num_from_fixed(3, 1)).undef && func_acos(num_from_i64(-2)).undef);
}

static void powers(void **state) {
    (void)state;
    mpfr_t x, y, z;
    mpfr_inits2(PRECISION, x, y, z, NULL);
    static const char *domain[] = {"(0, 10] ** [-20, 20]", "results up to 2^1090", "(1 +- 1e-3) ** large",
                                   "integer exponents"};
    for (int kind = 0; kind < 4; kind++) {
        worst_t w = {0, {0, 0, false}};
        for (int i = 0; i < 2 * random_count; i++) {
            num_t a, b;
            switch (kind) {
            case 0:
                a = uniform(1e-9, 10);
                b = uniform(-20, 20);
                break;
            case 1:
                a = num_abs(any_size(-1000, 1000));
                b = num_div(uniform(-750, 750), func_log(a));
                break;
            case 2:
                a = uniform(1 - 1e-3, 1 + 1e-3);
                b = num_div(uniform(-750, 750), func_log(a));
                break;
            default:
                a = any_size(-8, 8);
                b = num_from_i64((int64_t)(next() % 241) - 120);
            }
            set_num(x, a);
            set_num(y, b);
            mpfr_pow(z, x, y, MPFR_RNDN);
            note(&w, func_pow(a, b), z, a, false);
        }
        report("pow", domain[kind], w, -50, false);
    }
    num_t zero = num_from_i64(0), one = num_from_i64(1), two = num_from_i64(2), third = num_div(one, num_from_i64(3));
    assert_int_equal(num_cmp(func_pow(zero, zero), one), 0);
    assert_int_equal(num_cmp(func_pow(zero, two), zero), 0);
    assert_true(func_pow(zero, num_neg(two)).undef);
    assert_true(func_pow(num_neg(two), third).undef);
    assert_int_equal(num_cmp(func_pow(num_from_i64(-3), num_from_i64(3)), num_from_i64(-27)), 0);
    assert_int_equal(num_cmp(func_pow(num_from_i64(49), num_from_fixed(1, 1)), num_from_i64(7)), 0);
    assert_int_equal(num_sign(func_pow(num_from_fixed(-101, 6), num_from_i64(101))), -1);
    assert_int_equal(num_sign(func_pow(num_from_fixed(-101, 6), num_from_i64(102))), 1);
    assert_true(func_pow(two, num_from_i64(1200)).undef);
    assert_int_equal(num_cmp(func_pow(two, num_from_i64(-1200)), zero), 0);
    mpfr_clears(x, y, z, NULL);
}

static void special_functions(void **state) {
    (void)state;
    static const row_t rows[] = {
        {"erf", "[-3, 3]", func_erf, mpfr_erf, -3, 3, 0, 0, -52, false},
        {"erf", "any size", func_erf, mpfr_erf, 0, 0, -80, 10, -52, false},
        {"norm", "[-5, 5]", func_norm, exact_norm, -5, 5, 0, 0, -51, false},
        {"norm", "[-38, -5]", func_norm, exact_norm, -38, -5, 0, 0, -50, false},
        {"gamma", "(0, 10]", func_gamma, mpfr_gamma, 1e-9, 10, 0, 0, -52, false},
        {"gamma", "[10, 171]", func_gamma, mpfr_gamma, 10, 171, 0, 0, -50, false},
        {"gamma", "[-150, 0]", func_gamma, mpfr_gamma, -150, -1e-9, 0, 0, -50, false},
        {"besj0", "[-8, 8]", func_besj0, mpfr_j0, -8, 8, 0, 0, -53, true},
        {"besj0", "[8, 1e4]", func_besj0, mpfr_j0, 8, 1e4, 0, 0, -53, true},
        {"besj1", "[-8, 8]", func_besj1, mpfr_j1, -8, 8, 0, 0, -53, true},
        {"besj1", "[8, 1e4]", func_besj1, mpfr_j1, 8, 1e4, 0, 0, -53, true},
        {"besj1", "small, any size", func_besj1, mpfr_j1, 0, 0, -60, 0, -53, false},
    };
    RUN(rows);
}

static void named_values(void **state) {
    (void)state;
    static const struct {
        unary_t f;
        mpfr_unary_t exact;
        double at[8];
    } cases[] = {
        {func_sin, mpfr_sin, {1e5, 1e15, 1e22, 3.141592653589793, 1e-300, -1e300, 0.5, 355}},
        {func_cos, mpfr_cos, {1e5, 1e15, 1e22, 1.5707963267948966, 1e-300, -1e300, 11, 0}},
        {func_tan, mpfr_tan, {1e5, 1e15, 1.5707963267948966, -1.5707963267948966, 4.71238898038469, 355, 1e-9, 11}},
        {func_exp, mpfr_exp, {-700, 700, -750, 1e-18, 0, 1, -1, 709.78}},
        {func_log, mpfr_log, {1e300, 1e-300, 0.9999999999999999, 1.0000000000000002, 2, 0.5, 10, 1}},
        {func_erf, mpfr_erf, {6, -6, 10, 1e-10, 0.5, 1, 27, -2}},
        {func_gamma, mpfr_gamma, {0.5, -0.5, 170, 100.5, -100.5, -20.25, 5, 1e-6}},
    };
    mpfr_t x, y;
    mpfr_inits2(PRECISION, x, y, NULL);
    worst_t w = {0, {0, 0, false}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        for (int k = 0; k < 8; k++) {
            mpfr_set_d(x, cases[i].at[k], MPFR_RNDN);
            cases[i].exact(y, x, MPFR_RNDN);
            num_t a = from_double(cases[i].at[k]);
            note(&w, cases[i].f(a), y, a, false);
        }
    }
    report("all", "named arguments", w, -50, false);
    mpfr_clears(x, y, NULL);
    /* integers stay integers */
    assert_int_equal(num_cmp(num_div(func_gamma(num_from_i64(15)), func_gamma(num_from_i64(14))), num_from_i64(14)), 0);
    assert_int_equal(num_cmp(func_gamma(num_from_i64(21)), num_from_i64(2432902008176640000)), 0);
    assert_true(func_gamma(num_from_i64(0)).undef && func_gamma(num_from_i64(-3)).undef);
    assert_true(func_gamma(num_from_i64(500)).undef);
    assert_int_equal(num_cmp(func_besj0(num_from_i64(0)), num_from_i64(1)), 0);
    assert_int_equal(num_sign(func_besj1(num_from_i64(0))), 0);
}

/* f(-a) is f(a) or -f(a), bit for bit. */
static void symmetry(void **state) {
    (void)state;
    static const unary_t odd[] = {func_sin, func_tan, func_asin, func_atan, func_sinh, func_tanh, func_erf, func_besj1};
    static const unary_t even[] = {func_cos, func_cosh, func_besj0};
    for (int i = 0; i < 2000; i++) {
        num_t a = i % 2 ? uniform(-1, 1) : any_size(-20, 9);
        for (size_t k = 0; k < sizeof odd / sizeof *odd; k++) {
            num_t x = odd[k](a), y = num_neg(odd[k](num_neg(a)));
            assert_true(x.m == y.m && x.e == y.e && x.undef == y.undef);
        }
        for (size_t k = 0; k < sizeof even / sizeof *even; k++) {
            num_t x = even[k](a), y = even[k](num_neg(a));
            assert_true(x.m == y.m && x.e == y.e && x.undef == y.undef);
        }
    }
}

static void undefined_travels(void **state) {
    (void)state;
    static const unary_t f[] = {func_exp,  func_log,  func_log10, func_sin,   func_cos,  func_tan,
                                func_asin, func_acos, func_atan,  func_sinh,  func_cosh, func_tanh,
                                func_erf,  func_norm, func_gamma, func_besj0, func_besj1};
    for (size_t i = 0; i < sizeof f / sizeof *f; i++) assert_true(f[i](num_undef()).undef);
    num_t one = num_from_i64(1), u = num_undef();
    assert_true(func_pow(u, one).undef && func_pow(one, u).undef);
    assert_true(func_atan2(u, one).undef && func_atan2(one, u).undef);
    assert_true(func_exp(num_from_i64(800)).undef && func_exp(num_from_i64(2000)).undef);
    assert_true(func_exp(num_from_i64(-2000)).m == 0 && func_exp(num_from_i64(-800)).m == 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exponentials),         cmocka_unit_test(logarithms), cmocka_unit_test(trigonometry),
        cmocka_unit_test(inverse_trigonometry), cmocka_unit_test(powers),     cmocka_unit_test(special_functions),
        cmocka_unit_test(named_values),         cmocka_unit_test(symmetry),   cmocka_unit_test(undefined_travels),
    };
    const char *scale = getenv("RIDGELINE_TEST_SCALE");
    if (scale && atoi(scale) > 0) random_count *= atoi(scale);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
