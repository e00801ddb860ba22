/* test_hoist.c - an expression taken apart for a grid gives every point the value that it has as a whole, bit for bit.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "lang/hoist.h"
#include "lang/inline.h"
#include "num/noise.h"

enum { COLUMNS = 21, ROWS = 7 };

static lang_t lang;
static const int32_t SEED[2] = {4711, 1000000007};
static uint8_t code[2000];
static uint64_t mem[8192];

static int setup(void **state) {
    (void)state;
    names_reset(&lang);
    return 0;
}

static void define(const char *text) {
    lang_error_t err = {0};
    lexer_t lx;
    lexer_start(&lx, text, strlen(text));
    assert_int_equal(expr_define(&lang, &lx, &err), 1);
}

static expr_t compiled(const char *text) {
    static const expr_params_t XY = {.count = 2, .name = {{"x", 1}, {"y", 1}}};
    lang_error_t err = {0};
    lexer_t lx;
    expr_t x;
    lexer_start(&lx, text, strlen(text));
    int r = expr_compile(&lang, &lx, &XY, code, sizeof code, &x, &err);
    if (r < 0) fail_msg("%s: %s", text, err.message);
    return x;
}

static num_t at(int i, int n) {
    return num_div(num_from_i64(2 * i - n + 1), num_from_i64(4)); /* zero is among them */
}

/* The values of all points; how many of a column and a row were taken out. */
static void assert_same(const char *text, int per_column, int per_row) {
    expr_t x = compiled(text);
    const int32_t *seed = expr_is_impure(&lang, &x) ? SEED : NULL;
    size_t need = hoist_init(&lang, &x, seed, COLUMNS, mem, sizeof mem);
    assert_true(need > 0);
    if (!inline_is_call(&x)) assert_int_equal(hoist_init(&lang, &x, seed, COLUMNS, mem, need - 1), 0);
    memset(mem, 0x5a, sizeof mem);
    size_t lent = inline_is_call(&x) ? sizeof mem : need;
    hoist_init(&lang, &x, seed, COLUMNS, mem, lent);
    hoist_t *h = (hoist_t *)(void *)mem;
    if (per_column >= 0 && (h->per_column != per_column || h->per_row != per_row))
        fail_msg("%s: %d of a column, %d of a row", text, h->per_column, h->per_row);
    int first = 0; /* error */
    for (int i = 0; i < COLUMNS; i++) first = hoist_column(h, i, at(i, COLUMNS)) | first;
    for (int j = 0; j < ROWS; j++) {
        first = hoist_row(h, at(j, ROWS)) | first;
        num_t all[COLUMNS];
        const int error_at_once = hoist_points(h, 0, COLUMNS, all);
        int error = 0;
        for (int i = 0; i < COLUMNS; i++) {
            value_t a, b;
            const num_t place[2] = {hoist_x(h, i), at(j, ROWS)};
            assert_memory_equal(&place[0].m, &(int64_t){at(i, COLUMNS).m}, 8);
            const int failed = hoist_point(h, i, &b);
            first = failed | first;
            if (!error) error = failed;
            const num_t one = value_num(b);
            if (one.undef != all[i].undef || (!one.undef && (one.m != all[i].m || one.e != all[i].e)))
                fail_msg("%s at column %d, row %d with others at once", text, i, j);
            if (seed) noise_seeds(noise_at(noise_at(noise_hash(SEED), place[0]), place[1]), lang.seed);
            int err = expr_eval(&lang, &x, place, &a);
            if (a.kind != b.kind || (a.kind != VALUE_UNDEF && (a.m != b.m || a.e != b.e)))
                fail_msg("%s at column %d, row %d", text, i, j);
            if (err) assert_true(first < 0);
        }
        assert_int_equal(error_at_once, error);
    }
    for (size_t k = (lent + 7) / 8; k < sizeof mem / 8; k++) assert_int_equal(mem[k], 0x5a5a5a5a5a5a5a5au);
}

static void parts_of_one_variable_move(void **state) {
    (void)state;
    assert_same("exp(-x**2-y**2)", 1, 1);
    assert_same("sin(x)*cos(y)", 1, 1);
    assert_same("x*y", 0, 0);
    assert_same("x", 0, 0);
    assert_same("1", 0, 0);
    assert_same("sin(x)", 1, 0);
    assert_same("cos(y)+2", 0, 1);
    assert_same("sin(x)+sin(x)*y+sin(x)/y", 1, 0);
    assert_same("x**2*y+exp(x**2)*y+y/(1+x**2)", 3, 0);
    assert_same("exp(-(x**2+1))*y + (x**2+1)*sin(y)", 2, 1);
    assert_same("(y*2+1)*x+(y*2+1)**3*x**3+(y*2+1)", 1, 2);
    assert_same("sin(sqrt(x**2+y**2))/sqrt(x**2+y**2)", 1, 1);
    assert_same("floor(x)*3/2+int(y)%2", -1, -1);
    assert_same("max(x,1)+min(y,2,x)", 1, 0);
    assert_same("(x>0)+(y>0)*2", 1, 1);
}

static void variables_and_functions(void **state) {
    (void)state;
    define("a = 3");
    define("f(t) = t > 0 ? sqrt(t) : -t");
    define("g(s,t) = f(s)*f(t)");
    assert_same("a*2*x+a*y", 1, 1);
    assert_same("(a*2+1)*x + (a*2+1)*y + (a*2+1)", -1, -1);
    assert_same("f(x)+f(y)", 1, 1);
    assert_same("g(x,y)", 0, 0);
}

static void functions_are_taken_apart_too(void **state) {
    (void)state;
    define("f(x,y) = .5+.5*sin(12345.678*x+54321.987*y)");
    define("r(a,b) = sqrt(a**2+b**2)");
    define("s(t) = sin(t)/t");
    define("q(u,v) = u*u + (u*v+1)*(u*v+1)");
    define("swap(u,v) = v-u");
    define("two(t) = 2*t*t*t + (t+1)*(t+1)");
    define("none(t) = 4");
    define("count(n) = n*count(n-1)");
    assert_same("f(x,y)", 1, 1);
    assert_same("f(y,x)+1", 1, 1);
    assert_same("s(r(x,y))", 1, 1);
    assert_same("s(3*r(2*x,y))", -1, -1);
    assert_same("q(x,y)", -1, -1);
    assert_same("q(x+1,y*2)+q(x+1,y*2)", -1, -1);
    assert_same("q(q(x,2),q(y,3))", -1, -1);
    assert_same("swap(x*y+1,x*y+2)+swap(x,y*2)", -1, -1);
    assert_same("two(two(x)+two(y))", -1, -1);
    assert_same("none(x)+y", 0, 1);
    assert_same("none(nowhere)+y", -1, -1);
    assert_same("none(log(x))+y", -1, -1);
    assert_same("count(x)*y", 1, 0);
    assert_same("f(x)+y", -1, -1);
    assert_same("s(s(s(s(x*y+1))))", -1, -1);
    assert_same("two(two(two(x*y)))+two(two(two(x+y)))", -1, -1);
}

static void undefined_parts_are_holes(void **state) {
    (void)state;
    assert_same("1/x+1/y", 1, 1);
    assert_same("sqrt(x)+y", 1, 0);
    assert_same("max(sqrt(y),x)", 0, 1);
    assert_same("log(x)*log(y)", 1, 1);
    assert_same("NaN*x+y", 1, 0);
    assert_same("max(x+NaN,y)", 1, 0);
}

static void errors_are_told(void **state) {
    (void)state;
    assert_same("nowhere*x+y", 1, 0);
    assert_same("nosuch(y)+x", 0, 1);
    assert_same("(x&1)+y", 1, 0);
}

static void what_is_not_straight_stays_whole(void **state) {
    (void)state;
    assert_same("x>0 ? sin(x) : cos(y)", 0, 0);
    assert_same("x>0 && y>0", 0, 0);
    assert_same("sin(x)*sin(x+y)*sin(2*x)*sin(3*x)*sin(4*x)*sin(5*x)*y*sin(6*x)*y*sin(7*x)*y*sin(8*x)*y*cos(8*x)*y", -1,
                -1);
}

static void random_numbers_belong_to_places(void **state) {
    (void)state;
    define("wild(t) = t + rand(0)");
    assert_same("rand(0)", 0, 0);
    assert_same("rand(0)*10 + floor(x)*rand(0) - y", 0, 0);
    assert_same("rand(x) + rand(0)", 0, 0); /* some are seeds, and some illegal ones */
    assert_same("rand(-1)*x + rand(0)*y + rand(x*y)", 0, 0);
    assert_same("rand(sqrt(x)) + rand(0)", 0, 0);
    assert_same("wild(x) + wild(y)", 0, 0);
    assert_same("(rand(0) > 0.5 ? x : y) + rand(0)", 0, 0);
    assert_same("(t = rand(0), t*t)", 0, 0);
}

/* Calls by the dozen, whose values kept run out at some number. */
static void many_calls(void **state) {
    (void)state;
    define("two(t) = 2*t*t*t + (t+1)*(t+1)");
    define("pair(s,t) = s*t + s - t");
    for (int n = 1; n < 80; n += 3) {
        char text[4000], *to = text;
        for (int k = 0; k < n; k++) {
            to += sprintf(to, k % 2 ? "+two(x*y+%d)" : "+pair(two(x)+%d,two(y)*x)", k);
        }
        assert_same(text + 1, -1, -1);
    }
}

/* Random expressions of a small grammar, deep enough for shared parts. */
static uint32_t seed = 1;
static uint32_t pick(uint32_t n) {
    seed = seed * 1664525u + 1013904223u;
    return (seed >> 8) % n;
}

static char *random_expression(char *to, int depth) {
    static const char *const LEAF[] = {"x", "y", "x", "y", "2", "0.3", "a", "x**2", "y**2"};
    static const char *const CALL[] = {"sin(", "sqrt(", "exp(", "abs(", "floor(", "-(", "g(", "h("};
    static const char OPERATION[] = "+-*/+*";
    uint32_t kind = depth <= 0 ? 0 : pick(5);
    if (kind == 0) return to + sprintf(to, "%s", LEAF[pick(9)]);
    if (kind == 1) {
        to = random_expression(to + sprintf(to, "%s", CALL[pick(8)]), depth - 1);
        return to + sprintf(to, ")");
    }
    *to++ = '(';
    char *left = to;
    to = random_expression(to, depth - 1);
    size_t len = (size_t)(to - left);
    *to++ = OPERATION[pick(6)];
    if (kind == 2) { /* the left side again, inside a call */
        to += sprintf(to, "cos(");
        memcpy(to, left, len);
        to += len;
        to += sprintf(to, "*%s)", LEAF[pick(9)]);
    } else {
        to = random_expression(to, depth - 1);
    }
    return to + sprintf(to, ")");
}

static void random_ones(void **state) {
    (void)state;
    define("a = 1.5");
    define("g(t) = t*t+a*t");
    define("k(u,v) = u*(v+1)-(v+1)");
    define("h(t) = k(t,g(t))+0.5");
    int apart = 0;
    for (int n = 0; n < 4000; n++) {
        char text[4000];
        *random_expression(text, 2 + (int)pick(3)) = '\0';
        assert_same(text, -1, -1);
        const hoist_t *h = (const hoist_t *)(const void *)mem;
        apart += h->per_column + h->per_row > 0;
    }
    printf("# 4000 random expressions, %d taken apart: the same values\n", apart);
    assert_true(apart > 1000);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(parts_of_one_variable_move, setup),
        cmocka_unit_test_setup(variables_and_functions, setup),
        cmocka_unit_test_setup(functions_are_taken_apart_too, setup),
        cmocka_unit_test_setup(undefined_parts_are_holes, setup),
        cmocka_unit_test_setup(errors_are_told, setup),
        cmocka_unit_test_setup(what_is_not_straight_stays_whole, setup),
        cmocka_unit_test_setup(random_numbers_belong_to_places, setup),
        cmocka_unit_test_setup(many_calls, setup),
        cmocka_unit_test_setup(random_ones, setup),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
