/* compile_text.c - texts in quotes, a . b, a eq b, a[2:3]; elements of arrays and |A|. All are calls of functions that
 * have no name (text_funcs.h). */
#include "lang/builtins.h"
#include "lang/compile.h"
#include "lang/text_funcs.h"

#if CONFIG_CONTROL
void compile_builtin(compiler_t *c, const char *name, int n) {
    emit_byte3(&c->e, OP_FUNC, builtins_find(name, strlen(name)), n);
    emit_operated(&c->e, n, false, false);
}

static int no_room(const compiler_t *c) {
    return lang_error_set_number(c->err, ERR_FULL, lexer_column(c->lx), "no memory for texts in quotes; bytes for all",
                                 CONFIG_LITERALS);
}

/* A text that code will find again. */
static int literal(compiler_t *c, const char *text, size_t len) {
    const int at = texts_keep(c->e.l->texts, text, len);
    if (at < 0) return no_room(c);
    emit_constant(&c->e, value_int(at));
    compile_builtin(c, BUILTIN_IS_TEXT, 1);
    return 1;
}

static int quoted(compiler_t *c) {
    const texts_t *x = c->e.l->texts;
    if (!x) return lang_error_set(c->err, ERR_UNSUPPORTED, lexer_column(c->lx), "strings cannot be computed with");
    char *room = c->e.l->texts->literal + x->literals;
    const int n = lexer_string(c->lx, room, sizeof x->literal - x->literals);
    const int r = n < 0 ? no_room(c) : literal(c, room, (size_t)n); /* it stays there if it is new */
    if (r > 0) lexer_next(c->lx);
    return r;
}

int compile_iterated(compiler_t *c, int symbol) {
    lang_t *l = c->e.l;
    value_t v;
    names_value(l, symbol, &v);
    if (v.kind == VALUE_TEXT) return literal(c, value_chars(v), (size_t)v.e);
    emit_constant(&c->e, v);
    return 1;
}

/* The array called so, if one is; behind: and this stands behind the name. */
static int array(const compiler_t *c, const lexer_t *lx, int behind) {
    lexer_t next = *lx;
    if (lx->tok.kind != TOKEN_NAME) return -1;
    lexer_next(&next);
    if (next.tok.kind != behind) return -1;
    return names_find_defined(c->e.l, SYMBOL_ARRAY, lexer_text(lx), lx->tok.len);
}

/* In a slice a bound may be missing, or be a star. */
static bool is_open_bound(const compiler_t *c) {
    const int token = c->lx->tok.kind;
    return c->pending > 0 && c->stack[c->pending - 1].kind == P_SLICE && (token == '*' || token == ':' || token == ']');
}

bool compile_is_text(const compiler_t *c) {
    const int token = c->lx->tok.kind;
    return token == TOKEN_STRING || token == '|' || is_open_bound(c) || array(c, c->lx, '[') >= 0;
}

static int size(compiler_t *c) {
    lexer_t *lx = c->lx;
    lexer_next(lx);
    const int symbol = array(c, lx, '|');
    if (symbol < 0) return lexer_unexpected(lx, c->err, "the name of an array expected, as in |A|");
    lexer_next(lx);
    lexer_next(lx);
    emit_constant(&c->e, value_int(symbol));
    compile_builtin(c, BUILTIN_IS_SIZE, 1);
    return 1;
}

int compile_text(compiler_t *c) {
    lexer_t *lx = c->lx;
    if (lx->tok.kind == TOKEN_STRING) return quoted(c);
    if (is_open_bound(c)) {
        emit_constant(&c->e, value_int(c->stack[c->pending - 1].at ? INT32_MAX : 1));
        lexer_accept(lx, '*');
        return 1;
    }
    if (lx->tok.kind == '|') return size(c);
    emit_constant(&c->e, value_int(array(c, lx, '[')));
    lexer_next(lx);
    lexer_next(lx);
    return compile_open(c, P_ELEMENT, 0, 0);
}

static int operator(compiler_t *c, const char *name, int precedence) {
    compile_reduce(c, precedence);
    return compile_open(c, P_TEXT, builtins_find(name, strlen(name)), (uint16_t)precedence);
}

int compile_behind(compiler_t *c, pending_t *in) {
    lexer_t *lx = c->lx;
    int r = COMPILE_NOT_TEXT;
    if (lx->tok.kind == '.') {
        r = operator(c, BUILTIN_IS_CONCAT, SUM);
    } else if (lexer_is_name(lx, "eq")) {
        r = operator(c, BUILTIN_IS_EQ, EQUAL);
    } else if (lexer_is_name(lx, "ne")) {
        r = operator(c, BUILTIN_IS_NE, EQUAL);
    } else if (lx->tok.kind == '[') {
        r = compile_open(c, P_SLICE, 0, 0);
    } else if (lx->tok.kind == ':' && in && in->kind == P_SLICE && in->at == 0) {
        compile_reduce(c, LOOSE);
        in->at = 1;
        r = 0;
    } else if (lx->tok.kind == ']' && in && (in->kind == P_ELEMENT || (in->kind == P_SLICE && in->at > 0))) {
        compile_reduce(c, LOOSE);
        const bool element = in->kind == P_ELEMENT;
        c->pending--;
        compile_builtin(c, element ? BUILTIN_IS_ELEMENT : BUILTIN_IS_SLICE, element ? 2 : 3);
        r = 1;
    }
    if (r >= 0 && r != COMPILE_NOT_TEXT) lexer_next(lx);
    return r;
}
#endif
