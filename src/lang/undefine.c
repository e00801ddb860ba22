/* undefine.c - undefine a, b*, f(), $d: variables and arrays, those that begin so, functions, data blocks. What
 * mentions them goes on doing so. */
#include "lang/session_parts.h"

#if CONFIG_CONTROL
static bool is_named(const char *name, size_t name_len, const char *text, size_t len, bool begins) {
    return (begins ? name_len >= len : name_len == len) && memcmp(name, text, len) == 0;
}

static void forget(session_t *s, bool functions, const char *text, size_t len, bool begins) {
    lang_t *l = &s->lang;
    for (int i = 0; i < l->symbols; i++) {
        const symbol_t *y = &l->symbol[i];
        if ((y->kind == SYMBOL_FUNCTION) == functions &&
            is_named((const char *)l->pool + y->name, y->name_len, text, len, begins))
            names_forget(l, i);
    }
    for (size_t at = 0; at < s->texts.used && !functions;) { /* texts whose symbol nobody mentioned */
        const char *name = s->texts.store + at;
        const size_t n = strlen(name);
        if (is_named(name, n, text, len, begins))
            texts_set(&s->texts, name, n, NULL); /* the next one is here now */
        else
            at += n + strlen(name + n + 1) + 2;
    }
}

#if CONFIG_LOAD_DEPTH
/* $name, or $na*, or $*. */
static int forget_blocks(session_t *s, lexer_t *lx) {
    char name[32] = "$";
    const lexer_t at = *lx;
    lexer_t next = *lx;
    lexer_next(&next);
    const bool all = next.tok.kind == '*';
    if (all) lexer_next(lx);
    int err = all ? 0 : block_name(s, lx, name, sizeof name);
    if (err) return err;
    const bool begins = lexer_accept(lx, '*');
    if (!s->port->keep) return session_fail(s, &at, ERR_UNSUPPORTED, "there is no place for data blocks here");
    return s->port->keep(s->port->ctx, name, NULL, begins ? 2 : 1);
}
#endif

int undefine_command(session_t *s, lexer_t *lx) {
    if (session_at_end(lx)) return lexer_unexpected(lx, &s->error, "the name of a variable or function expected");
    while (!session_at_end(lx)) {
#if CONFIG_LOAD_DEPTH
        if (lx->tok.kind == '$') {
            int err = forget_blocks(s, lx);
            if (err) return err;
            lexer_accept(lx, ',');
            continue;
        }
#endif
        if (lx->tok.kind != TOKEN_NAME) return lexer_unexpected(lx, &s->error, "a name expected");
        const lexer_t name = *lx;
        lexer_next(lx);
        const bool begins = lexer_accept(lx, '*'), function = !begins && lexer_accept(lx, '(');
        if (function && !lexer_accept(lx, ')')) return lexer_unexpected(lx, &s->error, "')' expected");
        forget(s, function, lexer_text(&name), name.tok.len, begins);
        lexer_accept(lx, ',');
    }
    return 0;
}
#endif
