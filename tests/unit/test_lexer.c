/* test_lexer.c - tokens, their columns, numbers at the edges, strings, and the pictures of errors. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "lang/lexer.h"

static lexer_t start(const char *text) {
    lexer_t lx;
    lexer_start(&lx, text, strlen(text));
    return lx;
}

/* One word for each token: kind or text, and the column. */
static void assert_tokens(const char *text, const char *expected) {
    static const char *const names[] = {
        "name", "number", "string", "**", "<<", ">>", "<=", ">=", "==", "!=", "&&", "||", "bad"};
    char got[400] = "";
    size_t n = 0;
    lexer_t lx = start(text);
    for (; lx.tok.kind != TOKEN_END; lexer_next(&lx)) {
        if (lx.tok.kind >= 256)
            n += (size_t)snprintf(got + n, sizeof got - n, "%s@%d ", names[lx.tok.kind - 256], lexer_column(&lx));
        else
            n += (size_t)snprintf(got + n, sizeof got - n, "%c@%d ", lx.tok.kind, lexer_column(&lx));
    }
    snprintf(got + n, sizeof got - n, "end@%d", lexer_column(&lx));
    assert_string_equal(got, expected);
}

static void tokens_have_kinds_and_columns(void **state) {
    (void)state;
    assert_tokens("", "end@1");
    assert_tokens("  ", "end@1");
    assert_tokens("a=1;b", "name@1 =@2 number@3 ;@4 name@5 end@6");
    assert_tokens("x**2<=3", "name@1 **@2 number@4 <=@5 number@7 end@8");
    assert_tokens("!a!=b!", "!@1 name@2 !=@3 name@5 !@6 end@7");
    assert_tokens("1<<2>>3&&4||5&6|7^8", "number@1 <<@2 number@4 >>@5 number@7 &&@8 number@10 ||@11 number@13 &@14 "
                                         "number@15 |@16 number@17 ^@18 number@19 end@20");
    assert_tokens("a  # b ; c", "name@1 end@2");
    assert_tokens("'#' \"#\" x", "string@1 string@5 name@9 end@10");
    assert_tokens("[-2:2] $1:(\t$2)",
                  "[@1 -@2 number@3 :@4 number@5 ]@6 $@8 number@9 :@10 (@11 $@13 number@14 )@15 end@16");
    assert_tokens("\xc3\xa4_1x y", "name@1 name@7 end@8");
    assert_tokens("a\x01", "name@1 bad@2 end@3");
}

static void assert_number(const char *text, const char *expected, uint32_t len) {
    char buf[VALUE_TEXT_MAX];
    lexer_t lx = start(text);
    assert_int_equal(lx.tok.kind, TOKEN_NUMBER);
    value_format(lx.tok.value, buf);
    assert_string_equal(buf, expected);
    assert_int_equal(lx.tok.len, len);
}

static void numbers_read_as_in_gnuplot(void **state) {
    (void)state;
    assert_number("12", "12", 2);
    assert_number("0x1F", "31", 4);
    assert_number("0XabcdefG", "11259375", 8);
    assert_number("0x", "0", 1);
    assert_number("017", "15", 3);
    assert_number("08", "0", 1);
    assert_number("018.5", "18.5", 5);
    assert_number("1.", "1.0", 2);
    assert_number(".5", "0.5", 2);
    assert_number("1..2", "1.0", 2);
    assert_number("1.2.3", "1.2", 3);
    assert_number("1.e3", "1000.0", 4);
    assert_number("1E5", "100000.0", 3);
    assert_number("1.5E-3", "0.0015", 6);
    assert_number("1e+5x", "100000.0", 4);
    assert_number("9223372036854775807", "9223372036854775807", 19);
    assert_number("9223372036854775808", "9.22337203685478e+18", 19);
    assert_number("0xffffffffffffffff", "1.84467440737096e+19", 18);
    assert_number("0777777777777777777777", "9223372036854775807", 22);
    assert_number("123456789012345678901234567890.5", "1.23456789012346e+29", 32);
    assert_number("0.000000000000000000000000000001234567890123456789", "1.23456789012346e-30", 50);
    assert_number("1e-400", "0.0", 6);
    assert_number("1e99999999999", "NaN", 13);
    lexer_t lx = start("2e+");
    assert_int_equal(lx.tok.kind, TOKEN_BAD);
}

static void assert_text(const char *text, const char *expected) {
    char buf[40];
    lexer_t lx = start(text);
    assert_int_equal(lx.tok.kind, TOKEN_STRING);
    assert_int_equal(lexer_string(&lx, buf, sizeof buf), (int)strlen(expected));
    assert_string_equal(buf, expected);
}

static void strings_are_unquoted(void **state) {
    (void)state;
    assert_text("''", "");
    assert_text("'it''s'", "it's");
    assert_text("'a\\n'", "a\\n");
    assert_text("\"a\\n\\t\\\"b\\\\\\101\"", "a\n\t\"b\\A");
    assert_text("\"it's\" 'x'", "it's");
    lexer_t lx = start("'abc'");
    char buf[4];
    assert_int_equal(lexer_string(&lx, buf, 4), 3);
    assert_int_equal(lexer_string(&lx, buf, 3), ERR_FULL);
    lang_error_t err;
    lx = start("x 'abc");
    lexer_next(&lx);
    assert_int_equal(lexer_unexpected(&lx, &err, "a file name"), ERR_SYNTAX);
    assert_string_equal(err.message, "string without its closing quote");
    assert_int_equal(err.column, 3);
    assert_int_equal(start("\"abc\\\"").tok.kind, TOKEN_BAD);
    assert_int_equal(start("'").tok.kind, TOKEN_BAD);
}

static void abbreviations(void **state) {
    (void)state;
    lexer_t lx = start("spl");
    assert_true(lexer_is_almost(&lx, "sp$lot"));
    assert_false(lexer_is_almost(&lx, "splo$t"));
    assert_false(lexer_is_almost(&lx, "p$lot"));
    lx = start("splots");
    assert_false(lexer_is_almost(&lx, "sp$lot"));
    lx = start("splot");
    assert_true(lexer_is_almost(&lx, "sp$lot"));
    assert_true(lexer_is_almost(&lx, "splot"));
    assert_true(lexer_is_name(&lx, "splot"));
    assert_false(lexer_is_name(&lx, "splo"));
    lx = start("spl");
    assert_false(lexer_is_almost(&lx, "splot"));
    lx = start("1");
    assert_false(lexer_is_almost(&lx, "1$2"));
}

static void errors_are_drawn(void **state) {
    (void)state;
    char out[LANG_PICTURE_MAX];
    lang_error_t err;
    const char *text = "\tsplot sin(x";
    lang_error_set(&err, ERR_SYNTAX, 13, "')' expected");
    err.line = 3;
    lang_error_picture(&err, text, strlen(text), out, sizeof out);
    assert_string_equal(out, "\tsplot sin(x\n\t           ^\nline 3, column 13: ')' expected");
    lang_error_set_name(&err, ERR_NAME, 0, "undefined variable", "foobar", 3);
    assert_int_equal(lang_error_picture(&err, text, strlen(text), out, sizeof out), 23);
    assert_string_equal(out, "undefined variable: foo");
    lang_error_set_number(&err, ERR_FULL, 2, "too many (levels)", -2147483647 - 1);
    assert_string_equal(err.message, "too many (levels) (-2147483648)");

    /* A message longer than its buffer, a line longer than the picture: cut, and the caret is still below its column.
     */
    char longer[300];
    memset(longer, 'm', sizeof longer);
    lang_error_set_name(&err, ERR_NAME, 250, "name", longer, sizeof longer);
    assert_int_equal(strlen(err.message), LANG_ERROR_MAX - 1);
    longer[249] = '!';
    size_t len = lang_error_picture(&err, longer, sizeof longer, out, sizeof out);
    assert_true(len < sizeof out);
    const char *mark = strchr(out, '!'), *feed = strchr(out, '\n'), *caret = strchr(out, '^');
    assert_non_null(mark);
    assert_int_equal(mark - out, caret - feed - 1);
    for (size_t size = 0; size < 60; size++) {
        memset(out, 'z', sizeof out);
        len = lang_error_picture(&err, longer, sizeof longer, out, size);
        assert_true(len == 0 || len < size);
        assert_int_equal(out[size], 'z');
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tokens_have_kinds_and_columns),
        cmocka_unit_test(numbers_read_as_in_gnuplot),
        cmocka_unit_test(strings_are_unquoted),
        cmocka_unit_test(abbreviations),
        cmocka_unit_test(errors_are_drawn),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
