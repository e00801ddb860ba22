/* session_text.c - texts where commands want one: names of files, titles. */
#include "lang/builtins.h"
#include "lang/session_parts.h"

static int too_long(session_t *s, const lexer_t *lx, size_t size) {
    return lang_error_set_number(&s->error, ERR_FULL, lexer_column(lx), "too long for its buffer", (int32_t)size - 1);
}

#if CONFIG_CONTROL
bool session_is_text(const session_t *s, const lexer_t *lx) {
    const char *name = lexer_text(lx);
    const size_t len = lx->tok.len;
    lexer_t next = *lx;
    if (lx->tok.kind == TOKEN_STRING) return true;
    if (lx->tok.kind != TOKEN_NAME) return false;
    lexer_next(&next);
    if (next.tok.kind == '[' && names_find_defined(&s->lang, SYMBOL_ARRAY, name, len) >= 0) return true;
    if (next.tok.kind != '(') return texts_get(&s->texts, name, len) != NULL;
    const int b = builtins_find(name, len);
    return b >= 0 && (BUILTINS[b].flags & BUILTIN_TEXT);
}

bool session_may_be_text(const session_t *s, const lexer_t *lx) {
    lexer_t next = *lx;
    lexer_next(&next);
    return session_is_text(s, lx) || (lx->tok.kind == TOKEN_NAME && next.tok.kind == '(');
}

int session_keep(session_t *s, const lexer_t *at, value_t *v) {
    if (v->kind != VALUE_TEXT) return 0;
    const int kept = texts_keep(&s->texts, value_chars(*v), (size_t)v->e);
    if (kept < 0)
        return lang_error_set_number(&s->error, ERR_FULL, lexer_column(at), "no memory for this text; bytes for all",
                                     CONFIG_LITERALS);
    *v = value_text(s->texts.literal + kept, (size_t)v->e);
    return 0;
}

int session_string(session_t *s, lexer_t *lx, char *out, size_t size, const char *expected) {
    const lexer_t at = *lx;
    value_t v;
    if (lx->tok.kind == TOKEN_BAD || session_at_end(lx)) return lexer_unexpected(lx, &s->error, expected);
    int err = expr_value(&s->lang, lx, &v, &s->error);
    if (err) return err;
    if (v.kind != VALUE_TEXT) return lexer_unexpected(&at, &s->error, expected);
    if ((size_t)v.e >= size) return too_long(s, &at, size);
    memcpy(out, value_chars(v), (size_t)v.e + 1);
    return 0;
}
#else
int session_string(session_t *s, lexer_t *lx, char *out, size_t size, const char *expected) {
    if (lx->tok.kind != TOKEN_STRING) return lexer_unexpected(lx, &s->error, expected);
    if (lexer_string(lx, out, size) < 0) return too_long(s, lx, size);
    lexer_next(lx);
    return 0;
}
#endif
