/* test_expr.c - the expression language case by case. What a value should print was asked of gnuplot 5.4, line by
 * line; tests/property/test_gnuplot_print.c asks it again where it is installed, at random. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "lang/expr.h"
#include "num/func.h"

static lang_t lang;

static int setup(void **state) {
    (void)state;
    memset(&lang, 0xA5, sizeof lang); /* names_reset must not rely on zeros */
    names_reset(&lang);
    return 0;
}

static lexer_t start(const char *text) {
    lexer_t lx;
    lexer_start(&lx, text, strlen(text));
    return lx;
}

/* Carries out `name = ...; name(x) = ...; ...`. */
static void define(const char *text) {
    lang_error_t err = {0};
    lexer_t lx = start(text);
    do {
        if (expr_define(&lang, &lx, &err) != 1) fail_msg("%s: column %d: %s", text, err.column, err.message);
    } while (lexer_accept(&lx, ';'));
    assert_int_equal(lx.tok.kind, TOKEN_END);
}

static void assert_print(const char *text, const char *expected) {
    lang_error_t err = {0};
    lexer_t lx = start(text);
    value_t v;
    char buf[VALUE_TEXT_MAX];
    int r = expr_value(&lang, &lx, &v, &err);
    if (r < 0) fail_msg("%s: column %d: %s", text, err.column, err.message);
    value_format(v, buf);
    if (strcmp(buf, expected) != 0) fail_msg("%s gives %s, not %s", text, buf, expected);
    if (lx.tok.kind != TOKEN_END) fail_msg("%s: read only up to column %d", text, lexer_column(&lx));
}

static void assert_error(const char *text, int code, int32_t column, const char *message) {
    lang_error_t err = {0};
    lexer_t lx = start(text);
    value_t v;
    uint16_t symbols = lang.symbols;
    int r = expr_define(&lang, &lx, &err);
    if (r == 0) r = expr_value(&lang, &lx, &v, &err);
    if (r >= 0) fail_msg("%s is no error", text);
    if (strcmp(err.message, message) != 0) fail_msg("%s: the message is: %s", text, err.message);
    assert_int_equal(r, code);
    assert_int_equal(err.code, code);
    if (err.column != column) fail_msg("%s: column %d, not %d", text, err.column, column);
    assert_int_equal(lang.symbols, symbols); /* a mistake leaves no symbols behind */
}

static void check_prints(const char *const (*cases)[2]) {
    for (; (*cases)[0]; cases++) assert_print((*cases)[0], (*cases)[1]);
}

static void integers_are_gnuplots(void **state) {
    (void)state;
    static const char *const cases[][2] = {
        {"7/2", "3"},
        {"-7/2", "-3"},
        {"7/-2", "-3"},
        {"-7%3", "-1"},
        {"7%-3", "1"},
        {"2**3", "8"},
        {"2**-1", "0.5"},
        {"1**-1", "1.0"},
        {"(-1)**-3", "-1.0"},
        {"(-2)**-3", "-0.125"},
        {"0**0", "1"},
        {"0.0**0", "1.0"},
        {"(-2)**3", "-8"},
        {"3**39", "4052555153018976267"},
        {"3**41", "3.64729963771708e+19"},
        {"7**22", "3909821048582988049"},
        {"10**20", "1e+20"},
        {"2**62", "4611686018427387904"},
        {"2**63", "9.22337203685478e+18"},
        {"9223372036854775807+1", "9.22337203685478e+18"},
        {"-9223372036854775807-1", "-9223372036854775808"},
        {"-9223372036854775807-2", "-9.22337203685478e+18"},
        {"9223372036854775807*2", "1.84467440737096e+19"},
        {"9223372036854775807*-1", "-9223372036854775807"},
        {"4611686018427387904*-2", "-9.22337203685478e+18"},
        {"-(-9223372036854775807-1)", "-9223372036854775808"},
        {"3037000499*3037000499", "9223372030926249001"},
        {"5!", "120"},
        {"20!", "2432902008176640000"},
        {"21!", "5.10909421717094e+19"},
        {"100!", "9.33262154439442e+157"},
        {"(-3)!", "1"},
        {"1<<3", "8"},
        {"1<<62", "4611686018427387904"},
        {"1<<64", "1"},
        {"1>>65", "0"},
        {"1<<-1", "-9223372036854775808"},
        {"-1>>1", "9223372036854775807"},
        {"~5", "-6"},
        {"6^3", "5"},
        {"6&3|8", "10"},
        {"!3", "0"},
        {"!!5", "1"},
        {"7/2*2.0", "6.0"},
        {"7/2.", "3.5"},
        {"1==1.0", "1"},
        {"9007199254740993 == 9007199254740992.0", "1"}, /* doubles are compared */
        {"9007199254740993 - 9007199254740992", "1"},
        {0},
    };
    check_prints(cases);
}

static void precedence_is_gnuplots(void **state) {
    (void)state;
    static const char *const cases[][2] = {
        {"-2**2", "-4"},
        {"2**3**2", "512"},
        {"2**-2**2", "0.0625"},
        {"2**2!", "4"},
        {"2!**2", "4"},
        {"3!!", "720"},
        {"-3!", "-6"},
        {"!2!", "0"},
        {"~2**2", "-5"},
        {"-~2", "3"},
        {"- - 2", "2"},
        {"2--3", "5"},
        {"2*-3", "-6"},
        {"2-+3", "-1"},
        {"!0+1", "2"},
        {"2!=2", "0"},
        {"2! == 2", "1"},
        {"10-4-3", "3"},
        {"64/4/2", "8"},
        {"1+2<<1", "6"},
        {"1<<2+1", "8"},
        {"3>2>1", "0"},
        {"1<2<3", "1"},
        {"1|2^3&1", "3"},
        {"1 ? 2 : 3 ? 4 : 5", "2"},
        {"0 ? 2 : 0 ? 4 : 5", "5"},
        {"1 ? 0 ? 1 : 2 : 3", "2"},
        {"0||1&&0", "0"},
        {"2&&3", "1"},
        {"0||0", "0"},
        {"1||0/0", "1"},
        {"0&&0/0", "0"},
        {"1?2:1/0", "2"},
        {"(1,2,3)", "3"},
        {"2*(3+4)*-5", "-70"},
        {"1?a=2:3", "2"},
        {"a=b=3", "3"},
        {"(a=3)+a", "6"},
        {"1+(a=b=4)*a+b", "21"},
        {"sqrt(a=4)", "2.0"},
        {"(a=1) ? (a=2, a+5) : a", "7"},
        {0},
    };
    check_prints(cases);
    define("x = 2; y = 3.5");
    assert_print("(x > 1 && y < 4) ? x*y : -1", "7.0");
    /* The values of && || and ?: are not constants even when their parts are. */
    assert_print("1 + (1 && 2) + (0 || 3) * 2 + (1 ? 5 : 6)**2", "29");
    /* A constant made real moves the code behind it: all of it, also what lies before a jump or a comma. */
    assert_print("0 + ((1 ? 6 : x) - sqrt(y*y))", "2.5");
    assert_print("1 * ((1 || x) + sqrt(y*y))", "4.5");
    assert_print("1 * ((x, x, 6) + sqrt(y*y))", "9.5");
}

static void functions_keep_kinds(void **state) {
    (void)state;
    static const char *const cases[][2] = {
        {"abs(-3)", "3"},
        {"abs(-3.5)", "3.5"},
        {"int(2.7)", "2"},
        {"int(-2.7)", "-2"},
        {"int(5)", "5"},
        {"floor(-2.5)", "-3"},
        {"ceil(2.1)", "3"},
        {"ceil(-5.7)", "-5"},
        {"floor(5)", "5"},
        {"floor(-9e18)", "-9000000000000000000"},
        {"floor(1e20)", "NaN"},
        {"sgn(-2.5)", "-1"},
        {"sgn(0.0)", "0"},
        {"sgn(7)", "1"},
        {"real(3)", "3.0"},
        {"max(1,2)", "2"},
        {"min(1,2.5)", "1"},
        {"max(1.5,-2,3,2)", "3"},
        {"sqrt(4)", "2.0"},
        {"sqrt(2)", "1.4142135623731"},
        {"exp(0)", "1.0"},
        {"log(1)", "0.0"},
        {"log10(1000)", "3.0"},
        {"atan2(1,-1)", "2.35619449019234"},
        {"gamma(5)", "24.0"},
        {"norm(0)", "0.5"},
        {"erf(0)", "0.0"},
        {"besj0(0)", "1.0"},
        {"besj1(0)", "0.0"},
        {"sin(0)+cos(0)+tan(0)+asin(0)+acos(1)+atan(0)+sinh(0)+cosh(0)+tanh(0)", "2.0"},
        {"pi", "3.14159265358979"},
        {"2.0**3", "8.0"},
        {"4**0.5", "2.0"},
        {"2**1.5", "2.82842712474619"},
        {"2.0**10.0", "1024.0"},
        {"1.0001**10000", "2.71814592682493"},
        {0},
    };
    check_prints(cases);
}

static void nan_travels(void **state) {
    (void)state;
    static const char *const cases[][2] = {
        {"NaN", "NaN"},        {"NaN+1", "NaN"},      {"1/NaN", "NaN"},       {"-NaN", "NaN"},
        {"NaN==NaN", "0"},     {"NaN!=NaN", "1"},     {"NaN>0?1:2", "2"},     {"NaN<=0", "0"},
        {"sqrt(NaN)", "NaN"},  {"abs(NaN)", "NaN"},   {"floor(NaN)", "NaN"},  {"sgn(NaN)", "0"},
        {"NaN**0", "1.0"},     {"NaN**2", "NaN"},     {"2**NaN", "NaN"},      {"atan2(NaN,1)", "NaN"},
        {"max(1,NaN)", "NaN"}, {"min(NaN,1)", "NaN"}, {"1 ? NaN : 2", "NaN"}, {0},
    };
    check_prints(cases);
    define("a = NaN");
    assert_print("a", "NaN");
    static const char *const undefined[] = {
        "1/0",      "1/0.",      "0/0",        "5%0",       "0**-1",       "0.0**-1.5",
        "sqrt(-1)", "log(0)",    "log(-1)",    "log10(0)",  "asin(2)",     "acos(-2)",
        "gamma(0)", "gamma(-1)", "atan2(0,0)", "exp(1000)", "(-8)**.3",    "301!",
        "int(NaN)", "1+0/0",     "0*(1/0)",    "1e300**9",  "(1/0)>0?1:2", "(-9223372036854775807-1)/-1",
    };
    for (size_t i = 0; i < sizeof undefined / sizeof undefined[0]; i++)
        assert_error(undefined[i], ERR_VALUE, 1, "undefined value");
    lang_error_t err;
    num_t n;
    lexer_t lx = start("  NaN");
    assert_int_equal(expr_number(&lang, &lx, &n, &err), ERR_VALUE);
    assert_true(n.undef);
    assert_int_equal(err.column, 3);
    define("f(x) = 1/x");
    assert_error("1 + f(0)", ERR_VALUE, 1, "undefined value");
}

static void numbers_print_as_in_gnuplot(void **state) {
    (void)state;
    static const char *const cases[][2] = {
        {"3.0", "3.0"},
        {"1e10", "10000000000.0"},
        {"1e-5", "1e-05"},
        {"0.0001", "0.0001"},
        {"12345678.9", "12345678.9"},
        {"1e14", "100000000000000.0"},
        {"1e15", "1e+15"},
        {"1e100", "1e+100"},
        {"1.5e-300", "1.5e-300"},
        {"0.1+0.2", "0.3"},
        {"1/3.", "0.333333333333333"},
        {"2/3.", "0.666666666666667"},
        {"999999999999999.5", "1e+15"},
        {"99999999999999.96", "100000000000000.0"},
        {"0.00099999999999999995", "0.001"},
        {"123456789.123456789", "123456789.123457"},
        {"-123456789012345.6", "-123456789012346.0"},
        {"123456789012345678", "123456789012345678"},
        {"-0.5", "-0.5"},
        {"0.0", "0.0"},
        {"100000*100000.", "10000000000.0"},
        {0},
    };
    check_prints(cases);
}

/* Where a last bit decides, it is the double's. */
static void arithmetic_rounds_like_doubles(void **state) {
    (void)state;
    static const char *const cases[][2] = {
        {"int(4.35*100)", "434"},
        {"0.1+0.2==0.3", "0"},
        {"(0.1+0.2-0.3)*1e17", "5.55111512312578"},
        {"1-0.9-0.1", "-2.77555756156289e-17"},
        {"1e16+1-1e16", "0.0"},
        {"floor(log(8)/log(2))", "3"},
        {"int(log10(1000))", "3"},
        {"int(asin(sin(1)))", "1"},
        {"sqrt(49)==7", "1"},
        {"sin(pi)*1e16", "1.22464679914735"},
        {"cos(pi/2)*1e16", "0.612323399573677"},
        {"tan(pi/2)", "1.63312393531954e+16"},
        {"3.3**7.7", "9830.08644634903"},
        {"exp(1)==2.718281828459045", "1"},
        {"sin(1)==0.8414709848078965", "1"},
        {"int(3.999999999999999999)", "4"},
        {"1e308*1e-308", "1.0"},
        {0},
    };
    check_prints(cases);
    assert_error("1e308*10", ERR_VALUE, 1, "undefined value");
    assert_print("1e-320/10000", "0.0");
}

static void mistakes_are_reported(void **state) {
    (void)state;
    static const struct {
        const char *text;
        int code;
        int32_t column;
        const char *message;
    } cases[] = {
        {"", ERR_SYNTAX, 1, "a value expected"},
        {"2*", ERR_SYNTAX, 3, "a value expected"},
        {"2***3", ERR_SYNTAX, 4, "a value expected"},
        {"(1", ERR_SYNTAX, 3, "')' expected"},
        {"(1,", ERR_SYNTAX, 4, "a value expected"},
        {"()", ERR_SYNTAX, 2, "a value expected"},
        {"sin()", ERR_SYNTAX, 5, "a value expected"},
        {"sin(1", ERR_SYNTAX, 6, "')' expected"},
        {"sin(1,2)", ERR_SYNTAX, 8, "wrong number of arguments: sin"},
        {"max(1)", ERR_SYNTAX, 6, "wrong number of arguments: max"},
        {"1?2", ERR_SYNTAX, 4, "expecting ':'"},
        {"(1?2)", ERR_SYNTAX, 5, "expecting ':'"},
        {"1?2,3:4", ERR_SYNTAX, 4, "expecting ':'"},
        {"(1:2)", ERR_SYNTAX, 3, "')' expected"},
        {"1e", ERR_SYNTAX, 1, "expecting exponent"},
        {"3+'a'", ERR_UNSUPPORTED, 3, "strings cannot be computed with"},
        {"3+'a", ERR_SYNTAX, 3, "string without its closing quote"},
        {"1e9999", ERR_VALUE, 1, "constant too large"},
        {"$x", ERR_SYNTAX, 2, "column number expected"},
        {"1+$1", ERR_VALUE, 1, "a column of data makes no sense here"},
        {"1+foo*2", ERR_NAME, 3, "undefined variable: foo"},
        {"2+bar(1)", ERR_NAME, 3, "undefined function: bar"},
        {"sin", ERR_NAME, 1, "undefined variable: sin"},
        {"5.0%3", ERR_VALUE, 1, "non-integer operand for %"},
        {"1.5<<2", ERR_VALUE, 1, "bit shift applied to non-INT"},
        {"1.5&3", ERR_VALUE, 1, "non-integer passed to boolean operator"},
        {"1.5&&2", ERR_VALUE, 1, "non-integer passed to boolean operator"},
        {"0.0||0", ERR_VALUE, 1, "non-integer passed to boolean operator"},
        {"1.5?2:3", ERR_VALUE, 1, "non-integer passed to boolean operator"},
        {"!0.0", ERR_VALUE, 1, "non-integer passed to boolean operator"},
        {"~5.0", ERR_VALUE, 1, "non-integer passed to boolean operator"},
        {"NaN&&1", ERR_VALUE, 1, "non-integer passed to boolean operator"},
        {"5.0!", ERR_VALUE, 1, "factorial (!) argument must be an integer"},
        {"rand(1e10)", ERR_VALUE, 1, "illegal seed value"},
        {"sin(x)=3", ERR_NAME, 1, "cannot redefine a built-in function: sin"},
        {"f(a,b,c,d,e,f,g,h,i)=a", ERR_FULL, 19, "function has too many parameters (8)"},
        {"f(x)=", ERR_SYNTAX, 6, "a value expected"},
        {"f(x)=x+*2", ERR_SYNTAX, 8, "a value expected"},
        {"a=1/0", ERR_VALUE, 3, "undefined value"},
        {"f(1,2,3,4,5,6,7,8,9)", ERR_FULL, 18, "too many arguments (8)"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
        assert_error(cases[i].text, cases[i].code, cases[i].column, cases[i].message);
    /* An expression ends where it can go no further; what follows is the command's. */
    lang_error_t err;
    lexer_t lx = start("3 + 4 with lines");
    value_t v;
    assert_int_equal(expr_value(&lang, &lx, &v, &err), 0);
    assert_int_equal(v.m, 7);
    assert_true(lexer_is_name(&lx, "with"));
    static const char *const ends[] = {"1 2", "1,2", "1:2", "1)", "1]", "1;2", "1 'a'", "1 {", "1 = 2", "1 # 2"};
    for (size_t i = 0; i < sizeof ends / sizeof ends[0]; i++) {
        lx = start(ends[i]);
        assert_int_equal(expr_value(&lang, &lx, &v, &err), 0);
        assert_int_equal(v.m, 1);
    }
}

static void user_functions(void **state) {
    (void)state;
    define("f(x,y) = x**2 + y; g(x) = f(x, a); a = 1; f = 10");
    assert_print("f(2,3)", "7");
    assert_print("f(2.0,3)", "7.0");
    assert_print("g(3)+f", "20");
    define("a = 2; f(x,y) = x - y"); /* g sees both changes */
    assert_print("g(3)", "1");
    assert_error("f(1)", ERR_VALUE, 1, "wrong number of arguments for function: f");
    define("h(x) = later(x) + 1");
    assert_error("2*h(1)", ERR_NAME, 1, "undefined function: later");
    define("later(x) = x*10");
    assert_print("2*h(1)", "22");
    define("s(a,b,c,d,e,f,g,h) = a+2*b+3*c+4*d+5*e+6*f+7*g+8*h");
    assert_print("s(1,2,3,4,5,6,7,8)", "204");
    define("p(pi) = pi; set(x) = (last = x)");
    assert_print("p(2)", "2");
    assert_print("set(5) + last", "10");
    assert_print("f(f(5,1), f(f(2,1),-3)*2)", "-4");
    define("max(a,b) = a > b ? a : 100"); /* gnuplot has none: scripts define their own */
    assert_print("max(1,2)", "100");
    /* A name is a new function, a name of a parameter hides a variable. */
    define("x = 50; id(x) = x");
    assert_print("id(3) + x", "53");
}

static void recursion_has_a_limit(void **state) {
    (void)state;
    define("fac(n) = n < 2 ? 1 : n*fac(n-1)");
    assert_print("fac(20)", "2432902008176640000");
    assert_print("fac(25)", "1.5511210043331e+25");
    assert_print("fac(100)", "9.33262154439441e+157"); /* 100! is more accurate */
    define("deep(n) = n < 1 ? 0 : deep(n-1) + 1");
    assert_print("deep(240)", "240");
    assert_error("deep(1000)", ERR_FULL, 1, "recursion too deep in function: deep");
    define("wide(a,b,c,d,e,f,g,h) = a < 1 ? 0 : 1 + (1 + (1 + wide(a-1,b,c,d,e,f,g,h)))");
    assert_error("wide(1000,0,0,0,0,0,0,0)", ERR_FULL, 1, "out of stack in function: wide");
    assert_print("wide(10,0,0,0,0,0,0,0)", "30"); /* and it works again */
    define("even(n) = n == 0 ? 1 : odd(n-1); odd(n) = n == 0 ? 0 : even(n-1)");
    assert_print("even(101)", "0");
    define("twice(n) = n < 1 ? 0 : twice(n-1) + twice(n-1)");
    assert_error("twice(60)", ERR_FULL, 1, "too many calls in one evaluation");
}

static void redefinition_gives_memory_back(void **state) {
    (void)state;
    define("f(x) = x + 1; g(x) = x*3.25 + 1.0/3; h(x) = g(f(x))");
    uint16_t used = lang.bodies_end, symbols = lang.symbols;
    char text[80];
    for (int i = 0; i < 2000; i++) {
        snprintf(text, sizeof text, "f(x) = x + %d%s; g(x) = x*%s", 1 + i % 100, i % 3 ? "" : " + 1.23456789e8",
                 i % 7 ? "2" : "(3.75 + x)/3");
        define(text);
    }
    assert_int_equal(lang.symbols, symbols);
    define("f(x) = x + 1; g(x) = x*3.25 + 1.0/3");
    assert_int_equal(lang.bodies_end, used);
    assert_print("h(3)", "13.3333333333333");
    lang_error_t err;
    lexer_t lx = start("f(x) = x +");
    assert_int_equal(expr_define(&lang, &lx, &err), ERR_SYNTAX); /* a mistake leaves the old function */
    assert_print("f(1)", "2");
}

static void capacities_are_ordinary_errors(void **state) {
    (void)state;
    char text[4 * CONFIG_NESTING + 20];
    lang_error_t err;
    value_t v;
    /* Brackets: as many as promised, and one more. */
    for (int n = CONFIG_NESTING - 1; n <= CONFIG_NESTING + 1; n++) {
        size_t len = 0;
        for (int i = 0; i < n; i++) text[len++] = '(';
        text[len++] = '1';
        for (int i = 0; i < n; i++) text[len++] = ')';
        lexer_t lx;
        lexer_start(&lx, text, len);
        int r = expr_value(&lang, &lx, &v, &err);
        assert_int_equal(r, n <= CONFIG_NESTING ? 0 : ERR_FULL);
        if (r < 0) assert_string_equal(err.message, "expression too deeply nested (levels) (64)");
        if (r < 0) assert_int_equal(err.column, CONFIG_NESTING + 1);
    }
    /* Symbols. */
    int made = 0, r = 0;
    while (made < 1000) {
        int len = snprintf(text, sizeof text, "v%d", made);
        r = names_set(&lang, text, (size_t)len, value_int(made), &err);
        if (r < 0) break;
        made++;
    }
    assert_int_equal(r, ERR_FULL);
    assert_int_equal(made, CONFIG_SYMBOLS - 2); /* pi and NaN */
    assert_string_equal(err.message, "too many variables and functions (128)");
    assert_print("v0 + v100", "100");
    assert_error("v0 + nosuch", ERR_FULL, 6, "too many variables and functions (128)");
    /* The pool: functions until it is full; then shorter things still work. */
    names_reset(&lang);
    made = 0;
    static const char tail[] = "(x) = 1.1*x + 2.2*x + 3.3*x + 4.4*x + 5.5*x + 6.6*x + 7.7*x + 8.8*x";
    do {
        snprintf(text, sizeof text, "f%d%s", made++, tail);
        lexer_t lx = start(text);
        r = expr_define(&lang, &lx, &err);
    } while (r == 1 && made < 1000);
    assert_int_equal(r, ERR_FULL);
    assert_non_null(strstr(err.message, "no memory for"));
    assert_print("f0(1)", "39.6");
    snprintf(text, sizeof text, "f%d(1)", made - 2);
    assert_print(text, "39.6");
    /* A buffer of the caller's: every size up to the one it needs is refused, and nothing is written behind it. */
    uint8_t code[64];
    expr_t e;
    size_t size = 0;
    for (r = ERR_FULL; r < 0; size++) {
        memset(code, 0xEE, sizeof code);
        lexer_t lx = start("exp(-1.5*pi**2 + sqrt(2*pi) - max(1.1, pi)) + (pi > 3 ? pi : 2*3.3)");
        r = expr_compile(&lang, &lx, NULL, code, size, &e, &err);
        for (size_t i = size; i < sizeof code; i++) assert_int_equal(code[i], 0xEE);
        if (r < 0) assert_int_equal(r, ERR_FULL);
    }
    assert_true(e.len <= size - 1);
    assert_int_equal(expr_eval(&lang, &e, NULL, &v), 0);
}

static void points_of_a_surface(void **state) {
    (void)state;
    static const expr_params_t xy = {.count = 2, .name = {{"x", 1}, {"y", 1}}};
    uint8_t code[100];
    expr_t e;
    lang_error_t err;
    lexer_t lx = start("exp(-x**2-y**2), x*y");
    assert_int_equal(expr_compile(&lang, &lx, &xy, code, sizeof code, &e, &err), 0);
    assert_int_equal(lx.tok.kind, ',');
    assert_int_equal(e.len, 9);
    assert_int_equal(e.params, 2);
    assert_false(e.columns);
    assert_false(expr_is_impure(&lang, &e));
    num_t at[2] = {num_from_i64(1), num_from_i64(0)};
    value_t v;
    char buf[VALUE_TEXT_MAX];
    assert_int_equal(expr_eval(&lang, &e, at, &v), 0);
    value_format(v, buf);
    assert_string_equal(buf, "0.367879441171442");
    /* Holes are values, mistakes are errors. */
    lx = start("1/x");
    assert_int_equal(expr_compile(&lang, &lx, &xy, code, sizeof code, &e, &err), 0);
    at[0] = num_from_i64(0);
    assert_int_equal(expr_eval(&lang, &e, at, &v), 0);
    assert_int_equal(v.kind, VALUE_UNDEF);
    at[0] = num_undef();
    assert_int_equal(expr_eval(&lang, &e, at, &v), 0);
    assert_int_equal(v.kind, VALUE_UNDEF);
    lx = start("x + nowhere(y)");
    lexer_t from = lx;
    assert_int_equal(expr_compile(&lang, &lx, &xy, code, sizeof code, &e, &err), 0);
    assert_int_equal(expr_eval(&lang, &e, at, &v), ERR_NAME);
    assert_int_equal(v.kind, VALUE_UNDEF);
    assert_int_equal(expr_fault(&lang, &from, &err), ERR_NAME);
    assert_string_equal(err.message, "undefined function: nowhere");
    assert_int_equal(err.column, 5);
    assert_int_equal(expr_fault(&lang, NULL, &err), ERR_NAME);
    assert_int_equal(err.column, 0);
}

/* The value of an expression at x = 1.25, y = 0.5, and how many bytes its code takes. */
static void assert_at_point(const char *text, size_t room, const char *expected, int len) {
    static const expr_params_t xy = {.count = 2, .name = {{"x", 1}, {"y", 1}}};
    uint8_t code[400];
    expr_t e;
    lang_error_t err;
    value_t v;
    char buf[VALUE_TEXT_MAX];
    lexer_t lx = start(text);
    num_t at[2] = {num_from_fixed(5, 2), num_from_fixed(1, 1)};
    assert_int_equal(expr_compile(&lang, &lx, &xy, code, room, &e, &err), 0);
    assert_int_equal(expr_eval(&lang, &e, at, &v), 0);
    value_format(v, buf);
    if (strcmp(buf, expected) != 0) fail_msg("%s gives %s, not %s", text, buf, expected);
    if (len) assert_int_equal(e.len, len);
}

static void common_parts_are_shared(void **state) {
    (void)state;
    /* frame, x x* y y* +, root, kept, sin, the root again, /, end */
    assert_at_point("sin(sqrt(x*x+y*y))/sqrt(x*x+y*y)", 400, "0.724140807105579", 17);
    assert_at_point("sin(sqrt(x*x+y*y))/sqrt(x*x+y*y)", 21, "0.724140807105579", 17);
    assert_at_point("sin(sqrt(x*x+y*y))/sqrt(x*x+y*y)", 20, "0.724140807105579", 18);
    assert_at_point("x*y + x*y", 400, "1.25", 0);
    assert_at_point("x*y + x*y", 8, "1.25", 8); /* no room to share */
    assert_at_point("(x+y)*(x-y)*(x+y)*(x-y)/((x+y)*(x-y))", 400, "1.3125", 0);
    assert_at_point("exp(x)+exp(x)*exp(-x)+exp(-x)", 400, "4.77684775432203", 0);
    assert_at_point("sin(x)-sin(x)+cos(x)-cos(x)+tan(x)-tan(x)+exp(x)-exp(x)+sqrt(x)-sqrt(x)+log(x)-log(x)"
                    "+atan(x)-atan(x)+sinh(x)-sinh(x)",
                    400, "0.0", 0);
    /* What may change in between is computed again. */
    assert_at_point("(x > 1 ? x*y : 0) + (y > 1 ? 0 : x*y)", 400, "1.25", 0);
    define("a = 1; f(x) = (a = a + x)");
    assert_at_point("a*2.5 + f(1) + a*2.5", 400, "9.5", 0);
    assert_at_point("rand(0) == rand(0)", 400, "0", 0);
    assert_at_point("(a = 7) + a*a*a + (a = 2) + a*a*a", 400, "360", 0);
    /* A function's own kept values lie between its arguments and its operands. */
    define("g(u,v) = sqrt(u+v)*sqrt(u+v) + (u-v)*(u-v)*(u-v); h(u) = g(u,1)*g(u,1) + g(g(u,2), u)");
    assert_print("h(3.0)", "180.0");
}

static void invnorm_inverts_norm(void **state) {
    (void)state;
    assert_print("invnorm(0.3)", "-0.524400512708041");
    assert_print("invnorm(0.5)", "0.0");
    assert_print("invnorm(0.975)", "1.95996398454005");
    assert_error("invnorm(0)", ERR_VALUE, 1, "undefined value");
    assert_error("invnorm(1)", ERR_VALUE, 1, "undefined value");
    int32_t worst = -100;
    for (int i = 1; i < 4000; i++) {
        num_t p = num_from_fixed(i, 12);
        if (i % 3 == 0) p = num_ldexp(p, -(i % 700)); /* the far tail too */
        num_t d = num_sub(func_norm(func_invnorm(p)), p);
        if (d.m != 0 && d.e - p.e > worst) worst = d.e - p.e;
    }
    print_message("# norm(invnorm(p)) - p: below 2^%d p\n", worst + 1);
    assert_true(worst < -52);
}

static value_t third_times(void *ctx, int32_t n) {
    return n > 5 ? value_undef() : value_real(num_from_fixed(*(int *)ctx * n, 1));
}

static void columns_of_data(void **state) {
    (void)state;
    uint8_t code[100];
    expr_t e;
    lang_error_t err;
    value_t v;
    int factor = 3;
    lexer_t lx = start("($1 + column(2))*2:3");
    assert_int_equal(expr_compile(&lang, &lx, NULL, code, sizeof code, &e, &err), 0);
    assert_int_equal(lx.tok.kind, ':');
    assert_true(e.columns);
    lang.column = third_times;
    lang.column_ctx = &factor;
    assert_int_equal(expr_eval(&lang, &e, NULL, &v), 0);
    char buf[VALUE_TEXT_MAX];
    value_format(v, buf);
    assert_string_equal(buf, "9.0");
    lx = start("$6");
    assert_int_equal(expr_compile(&lang, &lx, NULL, code, sizeof code, &e, &err), 0);
    assert_int_equal(expr_eval(&lang, &e, NULL, &v), 0);
    assert_int_equal(v.kind, VALUE_UNDEF);
    lang.column = NULL;
}

#if CONFIG_64BIT
/* What is evaluated only where its columns change must depend on nothing else. */
static void columns_of_an_expression(void **state) {
    (void)state;
    static const struct {
        const char *text;
        bool known;
        uint64_t columns;
    } CASES[] = {
        {"$1*4/999. - 2", true, 2},
        {"$2 > 0 ? $3 : 1", true, 12},
        {"column(0) + f($2)", true, 5},
        {"pi", true, 0},
        {"a*$1 + column(2)", true, 6},
        {"$1 && $4 || $2", true, 22},
        {"column($1)", false, 0},
        {"column(a > 1 ? 1 : 2)", false, 0},
        {"column(a > 1 || 2)", false, 0},
        {"column(-1)", false, 0},
        {"$33", false, 0},
        {"$1 + rand(0)", false, 0},
        {"(a = $1)", false, 0},
        {"g($1)", false, 0},
        {"h($1)", false, 0},
        {"strlen(strcol(2))", false, 0},
    };
    define("a = 2; f(x) = x*a; g(x) = x + rand(0); h(x) = g(x)");
    for (size_t k = 0; k < sizeof CASES / sizeof CASES[0]; k++) {
        uint8_t code[100];
        expr_t e;
        lang_error_t err;
        uint64_t columns;
        lexer_t lx = start(CASES[k].text);
        assert_int_equal(expr_compile(&lang, &lx, NULL, code, sizeof code, &e, &err), 0);
        if (expr_is_of_columns(&lang, &e, &columns) != CASES[k].known) fail_msg("%s", CASES[k].text);
        if (CASES[k].known && columns != CASES[k].columns) fail_msg("%s: %d", CASES[k].text, (int)columns);
    }
}
#endif

static void random_numbers_are_gnuplots(void **state) {
    (void)state;
    assert_print("rand(0)", "0.222457440974512");
    assert_print("rand(0)", "0.133348129368619");
    assert_print("rand(0)", "0.535989057953577");
    assert_print("rand(-1)", "0.222457440974512");
    assert_print("rand(5)", "0.999998420858381");
    assert_print("rand(0)", "0.87259793840962");
    /* Whatever the seed's bits are, the result is inside ]0, 1[. */
    static const int32_t seeds[] = {1, 2, INT32_MAX, INT32_MIN, -1, 2147483562, 2147483563, 12345};
    enum { SEEDS = sizeof seeds / sizeof seeds[0] };
    for (int i = 0; i < SEEDS * SEEDS; i++) {
        lang.seed[0] = seeds[i % SEEDS];
        lang.seed[1] = seeds[i / SEEDS];
        lang_error_t err;
        num_t n;
        for (int k = 0; k < 20; k++) {
            lexer_t lx = start("rand(0)");
            assert_int_equal(expr_number(&lang, &lx, &n, &err), 0);
            assert_true(num_sign(n) > 0 && num_cmp(n, num_from_i64(1)) < 0);
        }
    }
    define("f(x) = 1 + g(x); g(x) = h(x)*2; h(x) = x + rand(0); pure(x) = x + other(x); other(x) = pure(x)");
    uint8_t code[40];
    expr_t e;
    lang_error_t err;
    static const struct {
        const char *text;
        bool impure;
    } cases[] = {{"1+f(2)", true},  {"g(1)", true},  {"pure(1)", false},
                 {"rand(0)", true}, {"(a=1)", true}, {"sin(1)", false}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        lexer_t lx = start(cases[i].text);
        assert_int_equal(expr_compile(&lang, &lx, NULL, code, sizeof code, &e, &err), 0);
        assert_int_equal(expr_is_impure(&lang, &e), cases[i].impure);
    }
}

static void numbers_for_settings(void **state) {
    (void)state;
    lang_error_t err;
    int32_t i;
    lexer_t lx = start("2*25, 7");
    assert_int_equal(expr_integer(&lang, &lx, 2, 100, &i, &err), 0);
    assert_int_equal(i, 50);
    assert_int_equal(lx.tok.kind, ',');
    lx = start("60.0");
    assert_int_equal(expr_integer(&lang, &lx, 2, 100, &i, &err), 0);
    assert_int_equal(i, 60);
    lx = start("  1");
    assert_int_equal(expr_integer(&lang, &lx, 2, 100, &i, &err), ERR_VALUE);
    assert_string_equal(err.message, "number out of range, the least is (2)");
    assert_int_equal(err.column, 3);
    lx = start("1e30");
    assert_int_equal(expr_integer(&lang, &lx, 2, 100, &i, &err), ERR_VALUE);
    assert_string_equal(err.message, "number out of range, the greatest is (100)");
    lx = start("-1e30");
    assert_int_equal(expr_integer(&lang, &lx, 2, 100, &i, &err), ERR_VALUE);
    assert_string_equal(err.message, "number out of range, the least is (2)");
    lx = start("2.5");
    assert_int_equal(expr_integer(&lang, &lx, 2, 100, &i, &err), ERR_VALUE);
    assert_string_equal(err.message, "a whole number is needed");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(integers_are_gnuplots, setup),
        cmocka_unit_test_setup(precedence_is_gnuplots, setup),
        cmocka_unit_test_setup(functions_keep_kinds, setup),
        cmocka_unit_test_setup(nan_travels, setup),
        cmocka_unit_test_setup(numbers_print_as_in_gnuplot, setup),
        cmocka_unit_test_setup(arithmetic_rounds_like_doubles, setup),
        cmocka_unit_test_setup(mistakes_are_reported, setup),
        cmocka_unit_test_setup(user_functions, setup),
        cmocka_unit_test_setup(recursion_has_a_limit, setup),
        cmocka_unit_test_setup(redefinition_gives_memory_back, setup),
        cmocka_unit_test_setup(capacities_are_ordinary_errors, setup),
        cmocka_unit_test_setup(points_of_a_surface, setup),
        cmocka_unit_test_setup(common_parts_are_shared, setup),
        cmocka_unit_test_setup(invnorm_inverts_norm, setup),
        cmocka_unit_test_setup(columns_of_data, setup),
#if CONFIG_64BIT
        cmocka_unit_test_setup(columns_of_an_expression, setup),
#endif
        cmocka_unit_test_setup(random_numbers_are_gnuplots, setup),
        cmocka_unit_test_setup(numbers_for_settings, setup),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
