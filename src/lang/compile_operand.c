/* compile_operand.c - what may stand where an operand is expected: numbers, names, calls, brackets, signs. */
#include "lang/builtins.h"
#include "lang/compile.h"
#include "lang/words.h"

static int parameter(const compiler_t *c, const char *name, uint32_t len) {
    for (int i = c->params ? c->params->count - 1 : -1; i >= 0; i--) {
        if (c->params->name[i].len == len && memcmp(c->params->name[i].text, name, len) == 0) return i;
    }
    return -1;
}

/* A name followed by a bracket. */
static int call(compiler_t *c, const char *name, uint32_t len, int32_t column) {
    int b = builtins_find(name, len);
    if (b >= 0 && (BUILTINS[b].flags & BUILTIN_OURS) && names_find_defined(c->e.l, SYMBOL_FUNCTION, name, len) >= 0)
        b = -1;
    if (b >= 0) {
        if (BUILTINS[b].flags & BUILTIN_COLUMNS) c->columns = true;
        return compile_open(c, P_BUILTIN, b, 1);
    }
    int s = names_intern(c->e.l, SYMBOL_FUNCTION, name, len, column, c->err);
    return s < 0 ? s : compile_open(c, P_USER, s, 1);
}

#if CONFIG_CONTROL
static bool is_iterated(const lang_t *l, int symbol) {
    for (int i = 0; i < l->iterations; i++)
        if (l->iterated[i] == symbol) return true;
    return false;
}

/* exists("name"), behind its bracket: known now. */
static int exists(compiler_t *c) {
    lexer_t *lx = c->lx;
    const lang_t *l = c->e.l;
    const char *text = lexer_text(lx) + 1;
    if (lx->tok.kind != TOKEN_STRING) return lexer_unexpected(lx, c->err, "the name of a variable in quotes expected");
    const size_t len = lx->tok.len - 2;
    const bool there = names_find_defined(l, SYMBOL_VARIABLE, text, len) >= 0 ||
                       names_find_defined(l, SYMBOL_ARRAY, text, len) >= 0 ||
                       (l->texts && texts_get(l->texts, text, len));
    emit_constant(&c->e, value_int(there));
    lexer_next(lx);
    return lexer_accept(lx, ')') ? 1 : lexer_unexpected(lx, c->err, "')' expected");
}
#endif

/* Returns 1 when the name was a whole operand, 0 when one is still expected, or an error. */
static int name(compiler_t *c) {
    lexer_t *lx = c->lx;
    const char *text = lexer_text(lx);
    uint32_t len = lx->tok.len;
    int32_t column = lexer_column(lx);
    lexer_next(lx);
#if CONFIG_CONTROL
    if (lx->tok.kind == '(' && words_match("exist$s", text, len)) {
        lexer_next(lx);
        return exists(c);
    }
#endif
    if (lexer_accept(lx, '(')) return call(c, text, len, column);
    /* An assignment may stand wherever an expression starts. */
    bool starts = c->pending == 0 || c->stack[c->pending - 1].kind >= P_SET;
    bool assigned = starts && lx->tok.kind == '=';
    int p = assigned ? -1 : parameter(c, text, len);
    uint32_t start = c->e.len;
    if (p >= 0) {
#if CONFIG_LOGSCALE
        const num_t *base = p < 2 ? c->params->base[p] : NULL;
        if (base) emit_constant(&c->e, value_real(*base));
        start = c->e.len;
#endif
        emit_byte(&c->e, OP_ARG + p);
        emit_pushed(&c->e, start, !c->params->any_kind);
#if CONFIG_LOGSCALE
        if (base) emit_binary(&c->e, OP_POW);
#endif
        return 1;
    }
    int s = names_intern(c->e.l, SYMBOL_VARIABLE, text, len, column, c->err);
    if (s < 0) return s;
    if (assigned) {
        lexer_next(lx);
        return compile_open(c, P_SET, s, 0);
    }
#if CONFIG_CONTROL
    if (is_iterated(c->e.l, s)) return compile_iterated(c, s);
#endif
    emit_byte2(&c->e, OP_VAR, s);
    emit_pushed(&c->e, start, false);
    return 1;
}

/* $3 */
static int dollar(compiler_t *c) {
    lexer_next(c->lx);
    const token_t *t = &c->lx->tok;
    if (t->kind != TOKEN_NUMBER || t->value.kind != VALUE_INT || t->value.m > INT16_MAX)
        return lexer_unexpected(c->lx, c->err, "column number expected");
    emit_constant(&c->e, t->value);
    emit_byte3(&c->e, OP_FUNC, builtins_find("column", 6), 1);
    emit_operated(&c->e, 1, false, false);
    c->columns = true;
    lexer_next(c->lx);
    return 1;
}

int compile_operand(compiler_t *c) {
    lexer_t *lx = c->lx;
    int prefix = 0, r;
#if CONFIG_CONTROL
    if (compile_is_text(c)) return compile_text(c);
#endif
    switch (lx->tok.kind) {
    case TOKEN_NUMBER:
        if (lx->tok.value.kind == VALUE_UNDEF)
            return lang_error_set(c->err, ERR_VALUE, lexer_column(lx), "constant too large");
        emit_constant(&c->e, lx->tok.value);
        lexer_next(lx);
        return 1;
    case TOKEN_NAME:
        return name(c);
    case '$':
        return dollar(c);
    case '(':
        r = compile_open(c, P_GROUP, 0, 0);
        lexer_next(lx);
        return r;
    case '+':
        lexer_next(lx);
        return 0;
    case '-':
        prefix = OP_NEG;
        break;
    case '!':
        prefix = OP_NOT;
        break;
    case '~':
        prefix = OP_BNOT;
        break;
#if !CONFIG_CONTROL
    case TOKEN_STRING:
        return lang_error_set(c->err, ERR_UNSUPPORTED, lexer_column(lx), "strings cannot be computed with");
#endif
    default:
        return lexer_unexpected(lx, c->err, "a value expected");
    }
    r = compile_open(c, P_PREFIX, prefix, 0);
    lexer_next(lx);
    return r;
}
