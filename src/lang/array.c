/* array.c - array A[3], A[3] = [1, 2, 3], A = [...]; A[2] = 5; print A.
 *
 * Elements of all arrays lie one behind the other; an array made anew moves behind the others, which close its gap
 * (names_forget). */
#include "lang/session_parts.h"

#if CONFIG_CONTROL
/* What an element is to hold. */
static int element(session_t *s, lexer_t *lx, value_t *out) {
    const lexer_t at = *lx;
    int err = expr_value(&s->lang, lx, out, &s->error);
    return err ? err : session_keep(s, &at, out);
}

static int no_cells(session_t *s, const lexer_t *at) {
    return lang_error_set_number(&s->error, ERR_FULL, lexer_column(at), "no memory for this array; elements of all",
                                 CONFIG_CELLS);
}

/* [1, "b", 3]: elements behind those in use. Returns how many, or an error. */
static int list(session_t *s, lexer_t *lx) {
    lang_t *l = &s->lang;
    int n = 0;
    if (!lexer_accept(lx, '[')) return lexer_unexpected(lx, &s->error, "[value, value, ...] expected");
    while (lx->tok.kind != ']') {
        if (l->cells + n == CONFIG_CELLS) return no_cells(s, lx);
        value_t v = value_undef(); /* nothing between two commas */
        int err = lx->tok.kind == ',' ? 0 : element(s, lx, &v);
        if (err) return err;
        l->cell[l->cells + n++] = v;
        if (!lexer_accept(lx, ',') && lx->tok.kind != ']')
            return lexer_unexpected(lx, &s->error, "',' or ']' expected");
    }
    lexer_next(lx);
    return n;
}

int array_command(session_t *s, lexer_t *lx) {
    lang_t *l = &s->lang;
    const lexer_t name = *lx;
    int32_t size = -1;
    int n = 0;
    if (lx->tok.kind != TOKEN_NAME) return lexer_unexpected(lx, &s->error, "the name of an array expected");
    const int symbol = names_intern(l, SYMBOL_ARRAY, lexer_text(lx), lx->tok.len, lexer_column(lx), &s->error);
    if (symbol < 0) return symbol;
    lexer_next(lx);
    if (lexer_accept(lx, '[')) {
        int err = set_integer(s, lx, 1, INT16_MAX, &size, "the size of this array is out of range");
        if (err) return err;
        if (!lexer_accept(lx, ']')) return lexer_unexpected(lx, &s->error, "']' expected");
    }
    if (lexer_accept(lx, '='))
        n = list(s, lx);
    else if (size < 0)
        return lexer_unexpected(lx, &s->error, "[size], or = [value, ...] expected");
    if (n < 0) return n;
    int err = session_expect_end(s, lx);
    if (err) return err;
    if (size < 0) size = n;
    if (n > size) return session_fail(s, &name, ERR_VALUE, "more values than the array has elements");
    for (; n < size; n++) {
        if (l->cells + n == CONFIG_CELLS) return no_cells(s, &name);
        l->cell[l->cells + n] = value_undef();
    }
    l->cells = (uint16_t)(l->cells + size);
    names_forget(l, symbol); /* the new elements move along */
    const int variable = names_find(l, SYMBOL_VARIABLE, lexer_text(&name), name.tok.len);
    if (variable >= 0) names_forget(l, variable);
    symbol_t *a = &l->symbol[symbol];
    a->defined = true;
    a->u.cells.start = (uint16_t)(l->cells - size);
    a->u.cells.len = (uint16_t)size;
    return 0;
}

static const symbol_t *array_at(const session_t *s, const lexer_t *lx) {
    const int symbol =
        lx->tok.kind == TOKEN_NAME ? names_find_defined(&s->lang, SYMBOL_ARRAY, lexer_text(lx), lx->tok.len) : -1;
    return symbol >= 0 ? &s->lang.symbol[symbol] : NULL;
}

int array_assign(session_t *s, lexer_t *lx) {
    lexer_t after = *lx;
    if (lx->tok.kind != TOKEN_NAME) return 0;
    lexer_next(&after);
    if (!lexer_accept(&after, '[')) return 0;
    const symbol_t *a = array_at(s, lx);
    if (!a && words_find(words_command, lx) >= 0) return 0; /* print [ ... */
    if (!a)
        return lang_error_set_name(&s->error, ERR_NAME, lexer_column(lx), "unknown array", lexer_text(lx), lx->tok.len);
    int32_t index;
    int err = set_integer(s, &after, 1, a->u.cells.len, &index, "array index out of range");
    if (err) return err;
    if (!lexer_accept(&after, ']')) return lexer_unexpected(&after, &s->error, "']' expected");
    if (!lexer_accept(&after, '=')) return lexer_unexpected(&after, &s->error, "'=' expected");
    value_t v;
    err = element(s, &after, &v);
    if (err) return err;
    s->lang.cell[a->u.cells.start + index - 1] = v;
    *lx = after;
    return 1;
}

bool array_is_whole(const session_t *s, const lexer_t *lx) {
    lexer_t next = *lx;
    lexer_next(&next);
    return next.tok.kind != '[' && array_at(s, lx) != NULL;
}

int array_print(session_t *s, lexer_t *lx) {
    const symbol_t *a = array_at(s, lx);
    int err = session_say(s, "[");
    for (int i = 0; i < a->u.cells.len && !err; i++) {
        const value_t v = s->lang.cell[a->u.cells.start + i];
        const bool quoted = v.kind == VALUE_TEXT;
        char number[VALUE_TEXT_MAX] = "";
        if (v.kind != VALUE_UNDEF && !quoted) value_format(v, number);
        if (i > 0) err = session_say(s, ",");
        if (!err && quoted) err = session_say(s, "\"");
        if (!err) err = session_say(s, quoted ? value_chars(v) : number);
        if (!err && quoted) err = session_say(s, "\"");
    }
    if (!err) err = session_say(s, "]");
    lexer_next(lx);
    return err;
}
#endif
