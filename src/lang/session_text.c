/* session_text.c - texts that are put together: "n = ".n, file.'.dat', sprintf("%03d", i).
 *
 * A text is items with dots between them; an item is a text in quotes, a variable that holds text, sprintf(), a number
 * or a variable that holds one. */
#include "lang/format.h"
#include "lang/session_parts.h"

static int too_long(session_t *s, const lexer_t *lx, size_t size) {
    return lang_error_set_number(&s->error, ERR_FULL, lexer_column(lx), "too long for its buffer", (int32_t)size - 1);
}

#if CONFIG_CONTROL
static bool is_sprintf(const lexer_t *lx) {
    lexer_t next = *lx;
    lexer_next(&next);
    return (lexer_is_name(lx, "sprintf") || lexer_is_name(lx, "gprintf")) && next.tok.kind == '(';
}

static const char *variable(const session_t *s, const lexer_t *lx) {
    return lx->tok.kind == TOKEN_NAME ? texts_get(&s->texts, lexer_text(lx), lx->tok.len) : NULL;
}

bool session_is_text(const session_t *s, const lexer_t *lx) {
    return lx->tok.kind == TOKEN_STRING || variable(s, lx) || is_sprintf(lx);
}

/* A quoted text, or a variable's, behind what is in t; the lexer goes on. */
static int simple(session_t *s, lexer_t *lx, text_t *t) {
    const char *held = variable(s, lx);
    if (held) {
        if (strlen(held) >= t->size - t->len) return too_long(s, lx, t->size);
        text_add(t, held);
    } else {
        const int n = lexer_string(lx, t->buf + t->len, t->size - t->len);
        if (n < 0) return too_long(s, lx, t->size);
        t->len += (size_t)n;
    }
    lexer_next(lx);
    return 0;
}

/* The next argument of sprintf, as f says. */
static int argument(session_t *s, lexer_t *lx, const format_t *f, text_t *t) {
    if (!lexer_accept(lx, ',')) return lexer_unexpected(lx, &s->error, "a value for each % of the format expected");
    if (f->type == 's') {
        char *copy = s->scratch;
        text_t c = text_start(copy, sizeof s->scratch);
        if (!session_is_text(s, lx) || is_sprintf(lx)) return lexer_unexpected(lx, &s->error, "a text for %s expected");
        int err = simple(s, lx, &c);
        if (!err) format_text(t, f, copy, c.len);
        return err;
    }
    value_t v;
    int err = expr_value(&s->lang, lx, &v, &s->error);
    if (!err) format_number(t, f, v);
    return err;
}

/* sprintf(format, ...), at its name. */
static int formatted(session_t *s, lexer_t *lx, text_t *t) {
    char format[256];
    text_t pattern = text_start(format, sizeof format);
    const lexer_t at = *lx;
    lexer_next(lx);
    lexer_next(lx);
    if (lx->tok.kind != TOKEN_STRING && !variable(s, lx))
        return lexer_unexpected(lx, &s->error, "a format in quotes expected");
    int err = simple(s, lx, &pattern);
    for (const char *p = format; *p && !err;) {
        const size_t n = strcspn(p, "%");
        text_add_bytes(t, p, n);
        p += n;
        if (!*p) break;
        format_t f;
        const size_t used = format_read(++p, &f);
        if (used == 0) return session_fail(s, &at, ERR_UNSUPPORTED, "this conversion of the format is not supported");
        p += used;
        if (f.type == '%')
            text_add(t, "%");
        else
            err = argument(s, lx, &f, t);
    }
    if (err) return err;
    if (t->len + 1 >= t->size) return too_long(s, &at, t->size);
    return lexer_accept(lx, ')') ? 0 : lexer_unexpected(lx, &s->error, "')' expected");
}

/* A number, or a variable that holds one, behind a dot. */
static int number(session_t *s, lexer_t *lx, text_t *t) {
    value_t v = lx->tok.value;
    char digits[VALUE_TEXT_MAX];
    if (lx->tok.kind == TOKEN_NAME) {
        const int k = names_find(&s->lang, SYMBOL_VARIABLE, lexer_text(lx), lx->tok.len);
        if (k < 0 || !s->lang.symbol[k].defined)
            return lang_error_set_name(&s->error, ERR_NAME, lexer_column(lx), "undefined variable", lexer_text(lx),
                                       lx->tok.len);
        v = s->lang.symbol[k].u.value;
    } else if (lx->tok.kind != TOKEN_NUMBER) {
        return lexer_unexpected(lx, &s->error, "a text expected");
    }
    value_format(v, digits);
    if (strlen(digits) >= t->size - t->len) return too_long(s, lx, t->size);
    text_add(t, digits);
    lexer_next(lx);
    return 0;
}

int session_string(session_t *s, lexer_t *lx, char *out, size_t size, const char *expected) {
    if (!session_is_text(s, lx)) return lexer_unexpected(lx, &s->error, expected);
    text_t t = text_start(out, size);
    int err;
    do {
        if (is_sprintf(lx))
            err = formatted(s, lx, &t);
        else if (session_is_text(s, lx))
            err = simple(s, lx, &t);
        else
            err = number(s, lx, &t);
    } while (!err && lexer_accept(lx, '.'));
    return err;
}

int session_define_text(session_t *s, lexer_t *lx) {
    const lexer_t name = *lx;
    lexer_t after = *lx;
    if (lx->tok.kind != TOKEN_NAME) return 0;
    lexer_next(&after);
    if (!lexer_accept(&after, '=')) return 0;
    if (!session_is_text(s, &after)) {
        texts_set(&s->texts, lexer_text(&name), name.tok.len, NULL); /* it will hold a number */
        return 0;
    }
    char *text = s->frame_name[0]; /* lent: no data file is open now */
    int err = session_string(s, &after, text, CONFIG_NAME_MAX + 1, "");
    if (err) return err;
    if (!texts_set(&s->texts, lexer_text(&name), name.tok.len, text))
        return lang_error_set_number(&s->error, ERR_FULL, lexer_column(&name), "no memory for this text; bytes for all",
                                     CONFIG_TEXTS);
    *lx = after;
    return 1;
}
#else
int session_string(session_t *s, lexer_t *lx, char *out, size_t size, const char *expected) {
    if (lx->tok.kind != TOKEN_STRING) return lexer_unexpected(lx, &s->error, expected);
    if (lexer_string(lx, out, size) < 0) return too_long(s, lx, size);
    lexer_next(lx);
    return 0;
}
#endif
