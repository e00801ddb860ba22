/* session.c - lines and files of lines: continuation, `load`, inline data, the small stack of files.
 *
 * The bottom frame is fed by session_line(), those above it by files. run() executes the top frame's line command by
 * command, replaces it by the file's next line, or takes the frame away at the end of the file; so `load` in the
 * middle of a line, or of a file, needs no recursion. */
#include "lang/session.h"
#include "lang/session_parts.h"

#define NO_END "the data block has no end"

session_frame_t *session_top(session_t *s) {
    return &s->frame[CONFIG_LOAD_DEPTH ? s->frames - 1 : 0];
}

static bool in_block(const session_t *s) {
#if CONFIG_LOAD_DEPTH
    return s->in_block;
#else
    return (void)s, false;
#endif
}

static void forget_line(session_frame_t *f) {
    f->len = 0;
    f->joins = 0;
    f->more = false;
    f->text[0] = '\0';
    lexer_start(&f->lx, f->text, 0);
}

void session_init(session_t *s, const session_port_t *port, void *pool, size_t pool_bytes) {
    memset(s, 0, sizeof *s);
    s->port = port;
    s->pool.base = pool;
    s->pool_size = s->pool.high = pool ? pool_bytes / sizeof(packed_t) : 0;
    s->frames = 1;
    s->frame[0].handle = -1;
    forget_line(&s->frame[0]);
    names_reset(&s->lang);
    set_reset(s);
}

void session_source(session_t *s, const char *name) {
    s->frame[0].name = name;
    s->frame[0].line = 0;
}

const settings_t *session_settings(const session_t *s) {
    return &s->settings;
}

enum session_state session_state(const session_t *s) {
    if (s->quit) return SESSION_QUIT;
    if (s->plot.waiting || in_block(s)) return SESSION_DATA;
    return s->frame[0].more ? SESSION_MORE : SESSION_READY;
}

static void pop(session_t *s) {
    s->port->close(s->port->ctx, session_top(s)->handle);
    s->frames--;
}

void session_cancel(session_t *s) {
    while (s->frames > 1) pop(s);
    forget_line(&s->frame[0]);
    if (s->in_last) s->last[s->last_len] = '\0'; /* what replot added is wrong */
    s->plot.waiting = false;
    s->rows_left = false;
#if CONFIG_LOAD_DEPTH
    s->in_block = false;
#endif
    s->in_last = false;
}

/* Reports err and forgets what was under way. */
static int give_up(session_t *s, int err) {
    if (s->error.code != err) lang_error_set(&s->error, err, 0, error_text(err));
    session_report(s);
    session_cancel(s);
    return err;
}

/* Adds a physical line's characters to the frame's logical line. */
static int append(session_t *s, session_frame_t *f, const char *text, size_t n) {
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
static void end_line(session_frame_t *f) {
    if (f->line == 1) skip_byte_order_mark(f);
    if (f->len > 0 && f->text[f->len - 1] == '\r') f->len--;
    f->more = f->len > 0 && f->text[f->len - 1] == '\\';
    if (f->more) {
        f->len--;
        if (f->joins < CONFIG_JOINS) f->join[f->joins++] = (uint16_t)f->len;
        return;
    }
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
static int next_line(session_t *s, session_frame_t *f) {
    forget_line(f);
    f->first_line = f->line + 1;
    bool any = false;
    for (;;) {
        const char *text = NULL;
        int n = some_of_line(s, f, &text);
        if (n < 0) return n;
        bool ended = n > 0 && text[n - 1] == '\n';
        if (n > 0) {
            int err = append(s, f, text, (size_t)(ended ? n - 1 : n));
            if (err) return err;
            any = true;
            if (!ended) continue;
        }
        if (!any) return 0;
        f->line++;
        end_line(f);
        if (!f->more) return 1;
        if (n == 0) { /* the file ends in a backslash */
            f->text[f->len] = '\0';
            lexer_start(&f->lx, f->text, f->len);
            return 1;
        }
    }
}

/* One line, or piece of a line, of inline data in a loaded file. */
static int file_data(session_t *s, session_frame_t *f) {
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
static int file_block(session_t *s, session_frame_t *f) {
    const char *text = NULL;
    int n;
    forget_line(f);
    f->first_line = ++f->line;
    while ((n = some_of_line(s, f, &text)) > 0) {
        const bool ended = text[n - 1] == '\n';
        int err = append(s, f, text, (size_t)(n - ended));
        if (err) return err;
        if (ended) break;
    }
    if (n == 0 && f->len == 0) return lang_error_set(&s->error, ERR_SYNTAX, 0, NO_END);
    if (n >= 0) n = block_line(s, f->text, f->len);
    forget_line(f);
    return n;
}
#endif

static int run(session_t *s) {
    for (;;) {
        session_frame_t *f = session_top(s);
        int err = 0;
        if (s->quit) {
            while (s->frames > 1) pop(s);
            forget_line(&s->frame[0]);
            return 0;
        }
        if (s->plot.waiting) {
            if (f->handle < 0) return 0;
            err = file_data(s, f);
#if CONFIG_LOAD_DEPTH
        } else if (s->in_block) {
            if (f->handle < 0) {
                forget_line(f);
                return 0;
            }
            err = file_block(s, f);
#endif
        } else if (f->lx.tok.kind == TOKEN_END) {
            if (f->handle < 0) {
                forget_line(f);
                return 0;
            }
            err = next_line(s, f);
            if (err == 0) pop(s);
        } else if (!lexer_accept(&f->lx, ';')) {
            err = command_execute(s, &f->lx);
        }
        if (err < 0) return err;
    }
}

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
    forget_line(f);
    return 0;
}

/* Whether a line can only be a row of inline data, or of a solid: a number, or one letter or two and a number. */
static bool is_row(const char *text) {
    text += strspn(text, " \t");
    if (*text == '\0' || *text == '#') return true;
    if (strchr("vfldog", *text)) {
        if (text[1] == 'n' || text[1] == 't') text++;
        text++;
        if (*text != ' ' && *text != '\t') return false;
        const bool named = text[-1] == 'o' || text[-1] == 'g';
        text += strspn(text, " \t");
        if (named) return *text != '=';
    }
    return *text && strchr("+-.0123456789", *text);
}

/* After an error in inline data come the rest of its rows, if they are sent by a program: they are passed over, up to
 * and with the line `e`, or up to what is no row. */
static bool pass_over(session_t *s, const char *text) {
    if (!s->rows_left) return false;
    const char *e = text + strspn(text, " \t");
    const bool ends = (*e == 'e' || *e == 'E') && e[1 + strspn(e + 1, " \t\r\n")] == '\0';
    s->rows_left = !ends && is_row(text);
    return ends || s->rows_left;
}

int session_line(session_t *s, const char *text) {
    session_frame_t *f = &s->frame[0];
    size_t n = strlen(text);
    while (n > 0 && (text[n - 1] == '\n' || text[n - 1] == '\r')) n--;
    int err = 0;
    bool rows_left = false;
    s->error = (lang_error_t){0};
    f->line++;
    if (s->quit || pass_over(s, text)) return 0;
    if (s->plot.waiting) {
        bool stopped = false;
        err = plot_feed(s, text, n, &stopped);
        if (!err && !stopped) err = plot_feed(s, "\n", 1, &stopped);
        rows_left = err && !stopped;
#if CONFIG_LOAD_DEPTH
    } else if (s->in_block) {
        err = block_line(s, text, n);
#endif
    } else {
        if (!f->more) {
            forget_line(f);
            f->first_line = f->line;
        }
        err = append(s, f, text, n);
        if (!err) {
            end_line(f);
            if (f->more) return 0;
        }
    }
    if (!err) err = run(s);
    if (err >= 0) return 0;
    give_up(s, err);
    s->rows_left = rows_left;
    return err;
}

int session_end(session_t *s) {
    session_frame_t *f = &s->frame[0];
    int err = 0;
    s->error = (lang_error_t){0};
    while (!err && s->plot.waiting) err = plot_feed_end(s);
    if (!err && in_block(s)) err = lang_error_set(&s->error, ERR_SYNTAX, 0, NO_END);
    if (!err && f->more) {
        forget_line(f);
        err = lang_error_set(&s->error, ERR_SYNTAX, 0, "the last line is to be continued, but nothing follows");
    }
    if (!err) err = run(s);
    return err < 0 ? give_up(s, err) : 0;
}
