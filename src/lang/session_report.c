/* session_report.c - what goes wrong, told to people: unexpected tokens, warnings, the place of an error. */
#include "lang/session_parts.h"

bool session_at_end(const lexer_t *lx) {
    return lx->tok.kind == TOKEN_END || lx->tok.kind == ';' || (CONFIG_CONTROL && lx->tok.kind == '}');
}

int session_expect_end(session_t *s, const lexer_t *lx) {
    return session_at_end(lx) ? 0 : lexer_unexpected(lx, &s->error, "the end of the command expected");
}

void session_skip(lexer_t *lx) {
    for (int32_t open = 0; !session_at_end(lx) || (open > 0 && lx->tok.kind == '}'); lexer_next(lx))
        open += (lx->tok.kind == '{') - (lx->tok.kind == '}');
}

int session_fail(session_t *s, const lexer_t *lx, int code, const char *message) {
    return lang_error_set(&s->error, code, lexer_column(lx), message);
}

void session_warn(session_t *s, const char *what, const char *word, size_t len, const char *why) {
    char buf[160];
    text_t t = text_start(buf, sizeof buf - 1);
    const session_frame_t *f = session_top(s);
    if (f->name) {
        text_add(&t, "\"");
        text_add(&t, f->name);
        text_add(&t, "\", ");
    }
    if (f->first_line) {
        text_add(&t, "line ");
        text_add_int(&t, f->first_line);
        text_add(&t, ": ");
    }
    text_add(&t, "warning: ");
    text_add(&t, what);
    text_add_shown(&t, word, len);
    text_add_said(&t, why);
    t.size++; /* the line feed was kept back */
    text_add(&t, "\n");
    s->port->warn(s->port->ctx, buf);
}

void session_warn_once(session_t *s, uint8_t *bits, int index, const char *what, const lexer_t *lx, const char *why) {
    uint8_t bit = (uint8_t)(1u << (index & 7));
    if (bits[index >> 3] & bit) return;
    bits[index >> 3] |= bit;
    session_warn(s, what, lexer_text(lx), lx->tok.len, why);
}

/* The error's column counts in the joined line; people want the physical line and its own column. */
static void place_error(session_t *s, const char **text, size_t *len) {
    lang_error_t *e = &s->error;
    const session_frame_t *f = session_top(s);
    if (s->in_last) {
        *text = s->last;
        *len = strlen(s->last);
        e->line = f->first_line;
        return;
    }
    uint32_t start = 0, end = f->len;
    int32_t k = 0;
    while (k < f->joins && e->column > f->join[k]) start = f->join[k++];
    if (k < f->joins) end = f->join[k];
    if (end > start && f->text[end - 1] == '\n') end--;
    *text = f->text + start;
    *len = end - start;
    if (e->column > 0) e->column -= (int32_t)start;
    e->line = f->first_line + k;
}

static void report(session_t *s, const char *name, const char *text, size_t len) {
    char buf[LANG_PICTURE_MAX];
    size_t n = lang_error_picture(&s->error, text, len, buf, sizeof buf);
    while (n > 0 && buf[n - 1] == '\n') buf[--n] = '\0';
    size_t last = n;
    while (last > 0 && buf[last - 1] != '\n') last--;
    const session_port_t *port = s->port;
    char reason[LANG_ERROR_MAX + 48];
    text_t t = text_start(reason, sizeof reason - 1);
    text_add(&t, buf + last);
    t.size++;
    text_add(&t, "\n");
    buf[last] = '\0';
    port->warn(port->ctx, buf);
    if (name) {
        port->warn(port->ctx, "\"");
        port->warn(port->ctx, name);
        port->warn(port->ctx, "\", ");
    }
    port->warn(port->ctx, reason);
}

#if CONFIG_LOAD_DEPTH
/* Line number `line` of a file, as much of it as fits, up to its LF; NULL if it cannot be had again. */
static const char *line_of_file(session_t *s, const char *name, int32_t line, char *out, size_t size) {
    session_chunk_t *c = &s->frame_chunk[0]; /* no data file is open now */
    const session_port_t *port = s->port;
    const int handle = port->open(port->ctx, name);
    if (handle < 0) return NULL;
    text_t t = text_start(out, size);
    int32_t at = 1;
    for (int n; at <= line && (n = port->read(port->ctx, handle, c->bytes, CONFIG_READ_CHUNK)) > 0;) {
        for (const char *p = c->bytes, *end = p + n; p < end && at <= line;) {
            const char *stop = memchr(p, '\n', (size_t)(end - p));
            if (!stop) stop = end;
            if (at == line) text_add_bytes(&t, p, (size_t)(stop - p));
            at += stop < end;
            p = stop + 1;
        }
    }
    port->close(port->ctx, handle);
    return t.len > 0 ? out : NULL;
}

/* The row of data that the error is about, or NULL. */
static const char *row_of_error(session_t *s, const char *name, char *out, size_t size) {
    if (s->error.column == 0) return NULL;
    if (s->plot.waiting && s->frames == 1) return s->row;
    return name ? line_of_file(s, name, s->error.line, out, size) : NULL;
}
#endif

void session_report(session_t *s) {
    if (s->error.line == 0) { /* in the text, not in data */
        const char *text;
        size_t len;
        place_error(s, &text, &len);
        report(s, session_top(s)->name, text, len);
    } else {
        const char *name = s->plot.waiting ? session_top(s)->name : s->frame_name[0], *row = NULL;
#if CONFIG_LOAD_DEPTH
        char line[400];
        row = row_of_error(s, name, line, sizeof line);
#endif
        report(s, name, row, row ? strcspn(row, "\r\n") : 0);
    }
}
