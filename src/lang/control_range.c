/* control_range.c - [i=1:9:2] and [w in "one two"]: the values that a variable goes through, in loops and in plots. */
#include "lang/session_parts.h"
#include "lang/text_funcs.h"

#if CONFIG_CONTROL
/* The variable of a range, and what it held before. */
static int begin(session_t *s, const lexer_t *name, control_range_t *r) {
    lang_t *l = &s->lang;
    r->now = r->first;
    r->symbol = names_intern(l, SYMBOL_VARIABLE, lexer_text(name), name->tok.len, lexer_column(name), &s->error);
    if (r->symbol < 0) return r->symbol;
    r->was_defined = names_value(l, r->symbol, &r->before);
    return r->was_defined ? session_keep(s, name, &r->before) : 0;
}

/* Behind `in`: a text, whose words are counted through. */
static int words(session_t *s, lexer_t *lx, control_range_t *r) {
    const lexer_t at = *lx;
    value_t v;
    int err = expr_value(&s->lang, lx, &v, &s->error);
    if (err) return err;
    if (v.kind != VALUE_TEXT) return lexer_unexpected(&at, &s->error, "a text with words expected");
    err = session_keep(s, &at, &v);
    if (err) return err;
    r->words = value_chars(v);
    text_words(&s->lang, &v, 1);
    r->first = r->step = 1;
    r->last = v.m;
    return lexer_accept(lx, ']') ? 0 : lexer_unexpected(lx, &s->error, "']' expected");
}

int control_range(session_t *s, lexer_t *lx, control_range_t *r) {
    int32_t v[3] = {0, 0, 1};
    const lexer_t at = *lx;
    if (!lexer_accept(lx, '[')) return lexer_unexpected(lx, &s->error, "[i=first:last] expected");
    const lexer_t name = *lx;
    if (lx->tok.kind == TOKEN_NAME) lexer_next(lx);
    r->words = NULL;
    r->open = false;
    if (name.tok.kind == TOKEN_NAME && lexer_is_name(lx, "in")) {
        lexer_next(lx);
        int err = words(s, lx, r);
        if (err) return err;
        return begin(s, &name, r);
    }
    if (name.tok.kind != TOKEN_NAME || !lexer_accept(lx, '='))
        return lexer_unexpected(lx, &s->error, "[i=first:last] expected");
    for (int k = 0; k < 3; k++) {
        if (k == 1 && lexer_accept(lx, '*')) {
            v[1] = INT32_MAX;
            r->open = true;
            if (!lexer_accept(lx, ':')) break;
            continue;
        }
        int err = set_integer(s, lx, INT32_MIN, INT32_MAX, &v[k], "this number is out of range");
        if (err) return err;
        if (k > 0 && lx->tok.kind != ':') break;
        if (k < 2 && !lexer_accept(lx, ':')) return lexer_unexpected(lx, &s->error, "':' expected");
    }
    if (!lexer_accept(lx, ']')) return lexer_unexpected(lx, &s->error, "']' expected");
    if (v[2] == 0) return session_fail(s, &at, ERR_VALUE, "the step is 0");
    r->first = v[0];
    r->last = v[1];
    r->step = v[2];
    return begin(s, &name, r);
}

bool control_within(const control_range_t *r) {
    return r->step > 0 ? r->now <= r->last : r->now >= r->last;
}

void control_set(session_t *s, const control_range_t *r) {
    value_t v[2] = {value_int(r->now), value_int(r->now)};
    if (r->words) {
        s->texts.working = 0;
        v[0] = value_text(r->words, strlen(r->words));
        text_word(&s->lang, v, 2);
    }
    names_assign(&s->lang, r->symbol, v[0]); /* a word that finds no room is missed when it is asked for */
}

void control_restore(session_t *s, const control_range_t *r) {
    if (r->was_defined)
        names_assign(&s->lang, r->symbol, r->before);
    else
        names_forget(&s->lang, r->symbol);
}
#endif
