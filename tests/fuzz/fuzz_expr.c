/* fuzz_expr.c - libFuzzer target: any bytes as lines of definitions and expressions.
 *
 *     make fuzz
 *
 * Whatever the text is, nothing crashes or hangs, the lexer always gets further, an error has a code, a message and a
 * column inside of the line, and the pool stays in order. Each line is evaluated as a definition, or as
 * a function of x and y at four points. */
#include "lang/expr.h"
#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static lang_t lang;
static texts_t texts;

static void check(bool fine) {
    if (!fine) abort();
}

static void check_error(int code, const lang_error_t *err, size_t len) {
    check(code < 0 && err->code == code && err->message[0]);
    check(err->column >= 0 && (size_t)err->column <= len + 1);
    check(memchr(err->message, 0, sizeof err->message) != NULL);
}

static void check_pool(void) {
    check(lang.bodies_end <= lang.names_start && lang.names_start <= CONFIG_POOL);
    for (int i = 0; i < lang.symbols; i++) {
        const symbol_t *s = &lang.symbol[i];
        check(s->name >= lang.names_start && s->name + s->name_len <= CONFIG_POOL);
        if (s->kind == SYMBOL_FUNCTION && s->defined) check(s->u.code.start + s->u.code.len <= lang.bodies_end);
    }
}

static value_t column(void *ctx, int32_t n) {
    (void)ctx;
    return n < 0 ? value_undef() : value_int(n);
}

static void evaluate(const lexer_t *at, lexer_t *lx, size_t len) {
    static const expr_params_t xy = {.count = 2, .name = {{"x", 1}, {"y", 1}}};
    static const int64_t points[] = {0, 0, 1, -3, 1000000007, 7, -1, 1};
    uint8_t code[300];
    expr_t e;
    lang_error_t err = {0};
    char text[VALUE_TEXT_MAX];
    int r = expr_compile(&lang, lx, &xy, code, sizeof code, &e, &err);
    if (r < 0) {
        check_error(r, &err, len);
        return;
    }
    for (size_t i = 0; i < sizeof points / sizeof points[0]; i += 2) {
        num_t args[2] = {num_from_fixed(points[i], 3), num_from_fixed(points[i + 1], 1)};
        value_t v;
        r = expr_eval(&lang, &e, args, &v);
        if (r < 0) check_error(expr_fault(&lang, at, &err), &err, len);
        if (v.kind == VALUE_TEXT)
            check(strlen(value_chars(v)) == (size_t)v.e);
        else
            check(value_format(v, text) < VALUE_TEXT_MAX);
        if (r < 0) break; /* it would only take as long again */
    }
    expr_is_impure(&lang, &e);
}

static void line(const char *text, size_t len) {
    lexer_t lx;
    lang_error_t err = {0};
    char out[LANG_PICTURE_MAX], string[20];
    lexer_start(&lx, text, len);
    for (;;) {
        lexer_t at = lx;
        int r = expr_define(&lang, &lx, &err);
        if (r < 0) {
            check_error(r, &err, len);
            lang_error_picture(&err, text, len, out, sizeof out);
        }
        if (r <= 0) evaluate(&at, &lx, len);
        check_pool();
        /* Go on behind the next separator. */
        while (lx.tok.kind != TOKEN_END && lx.tok.kind != ';') {
            uint32_t before = lx.pos;
            if (lx.tok.kind == TOKEN_STRING) lexer_string(&lx, string, sizeof string);
            lexer_unexpected(&lx, &err, NULL);
            lexer_next(&lx);
            check(lx.pos > before || lx.tok.kind == TOKEN_END);
        }
        if (!lexer_accept(&lx, ';')) return;
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    names_reset(&lang);
    texts_reset(&texts);
    lang.texts = size % 2 ? &texts : NULL; /* tests of expressions alone have none */
    lang.column = column;
    const char *text = (const char *)data;
    while (size) {
        const char *feed = memchr(text, '\n', size);
        size_t len = feed ? (size_t)(feed - text) : size;
        line(text, len);
        if (!feed) break;
        size -= len + 1;
        text = feed + 1;
    }
    return 0;
}
