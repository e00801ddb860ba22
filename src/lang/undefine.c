/* undefine.c - undefine a, b*, f(): variables, those that begin so, functions. What mentions them goes on doing so. */
#include "lang/session_parts.h"

#if CONFIG_CONTROL
static bool is_named(const char *name, size_t name_len, const char *text, size_t len, bool begins) {
    return (begins ? name_len >= len : name_len == len) && memcmp(name, text, len) == 0;
}

static void forget(session_t *s, enum symbol_kind kind, const char *text, size_t len, bool begins) {
    lang_t *l = &s->lang;
    for (int i = 0; i < l->symbols; i++) {
        symbol_t *y = &l->symbol[i];
        if (y->kind != kind || !is_named((const char *)l->pool + y->name, y->name_len, text, len, begins)) continue;
        if (kind == SYMBOL_FUNCTION) names_define_function(l, i, 0, 0, 0); /* its body goes */
        y->defined = false;
    }
    if (kind == SYMBOL_FUNCTION) return;
    for (size_t at = 0; at < s->texts.used;) {
        const char *name = s->texts.store + at;
        const size_t n = strlen(name);
        if (is_named(name, n, text, len, begins))
            texts_set(&s->texts, name, n, NULL); /* the next one is here now */
        else
            at += n + strlen(name + n + 1) + 2;
    }
}

int undefine_command(session_t *s, lexer_t *lx) {
    if (session_at_end(lx)) return lexer_unexpected(lx, &s->error, "the name of a variable or function expected");
    while (!session_at_end(lx)) {
        if (lx->tok.kind != TOKEN_NAME) return lexer_unexpected(lx, &s->error, "a name expected");
        const lexer_t name = *lx;
        lexer_next(lx);
        const bool begins = lexer_accept(lx, '*'), function = !begins && lexer_accept(lx, '(');
        if (function && !lexer_accept(lx, ')')) return lexer_unexpected(lx, &s->error, "')' expected");
        forget(s, function ? SYMBOL_FUNCTION : SYMBOL_VARIABLE, lexer_text(&name), name.tok.len, begins);
        lexer_accept(lx, ',');
    }
    return 0;
}
#endif
