/* session_lines.c - from characters to logical lines: continuation, files being loaded, their inline data. */
#include "lang/session_parts.h"

void session_forget_line(session_frame_t *f) {
    f->len = 0;
    f->joins = 0;
    f->more = false;
#if CONFIG_CONTROL
    f->blocks = f->braces = 0;
    f->counted = 0;
#endif
    f->text[0] = '\0';
    lexer_start(&f->lx, f->text, 0);
}

/* Adds a physical line's characters to the frame's logical line. */
int session_append(session_t *s, session_frame_t *f, const char *text, size_t n) {
    if (n > CONFIG_LINE_MAX - f->len) {
        f->first_line = f->line;
        return lang_error_set_number(&s->error, ERR_FULL, 0, "the line is too long; most bytes", CONFIG_LINE_MAX);
    }
    memcpy(f->text + f->len, text, n);
    f->len += (uint32_t)n;
    return 0;
}

/* Some programs begin a file of UTF-8 with a mark. */
static void skip_byte_order_mark(session_frame_t *f) {
    if (f->len < 3 || memcmp(f->text, "\xef\xbb\xbf", 3) != 0) return;
    f->len -= 3;
    memmove(f->text, f->text + 3, f->len);
}

/* A physical line is complete: either it is continued or the logical line begins to be executed. */
void session_end_line(session_frame_t *f) {
    if (f->line == 1) skip_byte_order_mark(f);
    if (f->len > 0 && f->text[f->len - 1] == '\r') f->len--;
    f->more = f->len > 0 && f->text[f->len - 1] == '\\';
    if (f->more) {
        f->len--;
        if (f->joins < CONFIG_JOINS) f->join[f->joins++] = (uint16_t)f->len;
        return;
    }
#if CONFIG_CONTROL
    f->more = control_is_open(f);
    if (f->more && f->len < CONFIG_LINE_MAX) {
        f->text[f->len++] = '\n';
        f->counted = f->len;
        if (f->joins < CONFIG_JOINS) f->join[f->joins++] = (uint16_t)f->len;
        return;
    }
#endif
    f->text[f->len] = '\0';
    lexer_start(&f->lx, f->text, f->len);
}

static int refill(session_t *s, session_frame_t *f) {
    session_chunk_t *c = &s->frame_chunk[s->frames - 1];
    int n = s->port->read(s->port->ctx, f->handle, c->bytes, CONFIG_READ_CHUNK);
    c->at = 0;
    c->len = n > 0 ? n : 0;
    return n;
}

/* Characters of a loaded file up to and with the next line feed, as many as are at hand: *text, or an error; 0 at the
 * end of the file. */
static int some_of_line(session_t *s, session_frame_t *f, const char **text) {
    session_chunk_t *c = &s->frame_chunk[s->frames - 1];
    if (c->at == c->len) {
        int n = refill(s, f);
        if (n <= 0) return n;
    }
    *text = c->bytes + c->at;
    int n = 0;
    while (c->at < c->len) {
        n++;
        if (c->bytes[c->at++] == '\n') break;
    }
    return n;
}

/* The next logical line of a loaded file: 1, 0 at its end, or an error. */
int session_next_line(session_t *s, session_frame_t *f) {
    session_forget_line(f);
    f->first_line = f->line + 1;
    bool any = false;
    for (;;) {
        const char *text = NULL;
        int n = some_of_line(s, f, &text);
        if (n < 0) return n;
        bool ended = n > 0 && text[n - 1] == '\n';
        if (n > 0) {
            int err = session_append(s, f, text, (size_t)(ended ? n - 1 : n));
            if (err) return err;
            any = true;
            if (!ended) continue;
        }
        if (!any) return 0;
        f->line++;
        session_end_line(f);
        if (!f->more) return 1;
#if CONFIG_CONTROL
        if (n == 0 && f->braces > 0) return lang_error_set(&s->error, ERR_SYNTAX, 0, SESSION_NO_BRACE);
#endif
        if (n == 0) { /* the file ends in a backslash */
            f->text[f->len] = '\0';
            lexer_start(&f->lx, f->text, f->len);
            return 1;
        }
    }
}

/* One line, or piece of a line, of inline data in a loaded file. */
int session_file_data(session_t *s, session_frame_t *f) {
    const char *text = NULL;
    int n = some_of_line(s, f, &text);
    if (n < 0) return n;
    if (n == 0) return plot_feed_end(s);
    bool stopped, ended = text[n - 1] == '\n';
    if (ended) f->line++;
    int err = plot_feed(s, text, (size_t)n, &stopped);
    if (err || !stopped) return err;
    while (!ended) { /* what is left of the line `e` */
        n = some_of_line(s, f, &text);
        if (n <= 0) return n;
        ended = text[n - 1] == '\n';
        if (ended) f->line++;
    }
    return 0;
}

#if CONFIG_LOAD_DEPTH
/* One line of a data block in a loaded file. */
int session_file_block(session_t *s, session_frame_t *f) {
    const char *text = NULL;
    int n;
    session_forget_line(f);
    f->first_line = ++f->line;
    while ((n = some_of_line(s, f, &text)) > 0) {
        const bool ended = text[n - 1] == '\n';
        int err = session_append(s, f, text, (size_t)(n - ended));
        if (err) return err;
        if (ended) break;
    }
    if (n == 0 && f->len == 0) return lang_error_set(&s->error, ERR_SYNTAX, 0, SESSION_NO_END);
    if (n >= 0) n = block_line(s, f->text, f->len);
    session_forget_line(f);
    return n;
}
#endif

int session_load(session_t *s, const char *name, const lexer_t *at) {
    if (s->frames > CONFIG_LOAD_DEPTH)
        return lang_error_set_number(&s->error, ERR_FULL, lexer_column(at), "files load each other too deeply; most",
                                     CONFIG_LOAD_DEPTH);
    int handle = s->port->open(s->port->ctx, name);
    if (handle < 0) return lang_error_set_name(&s->error, handle, lexer_column(at), "cannot load", name, strlen(name));
    char *own = s->frame_name[s->frames];
    text_t t = text_start(own, CONFIG_NAME_MAX + 1);
    text_add(&t, name);
    s->frame_chunk[s->frames].at = s->frame_chunk[s->frames].len = 0;
    session_frame_t *f = &s->frame[s->frames++];
    f->handle = handle;
    f->name = own;
    f->line = 0;
    session_forget_line(f);
    return 0;
}
