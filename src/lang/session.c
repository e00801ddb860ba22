/* session.c - the conversation: what a line that comes in is taken for, and who executes it.
 *
 * The bottom frame is fed by session_line(), those above it by files. run() executes the top frame's line command by
 * command, replaces it by the file's next line, or takes the frame away at the end of the file; so `load` in the
 * middle of a line, or of a file, needs no recursion. */
#include "lang/session.h"
#include "lang/session_parts.h"

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

void session_forget_names(session_t *s) {
    names_reset(&s->lang);
#if CONFIG_CONTROL
    texts_reset(&s->texts);
    s->lang.texts = &s->texts;
    texts_set(&s->texts, "GPVAL_ENCODING", 14, "utf8"); /* which many scripts save and set again */
    lang_error_t ignored;
    names_set(&s->lang, "GPVAL_VERSION", 13, value_real(num_from_decimal(54, -1)), &ignored);
    texts_set(&s->texts, "GPVAL_COMPILE_OPTIONS", 21, "");
    texts_set(&s->texts, "GPVAL_TERM", 10, "unknown");
    names_set(&s->lang, "ARGC", 4, value_int(0), &ignored);
#endif
}

void session_start(session_t *s, const session_port_t *port, void *pool, size_t pool_bytes) {
    s->port = port;
    s->pool.base = pool;
    s->pool_size = s->pool.high = pool ? pool_bytes / sizeof(packed_t) : 0;
    s->frames = 1;
    s->frame[0].handle = -1;
    s->coming = -1;
    session_forget_line(&s->frame[0]);
    session_forget_names(s);
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
    session_forget_line(&s->frame[0]);
    if (s->in_last) s->last[s->last_len] = '\0'; /* what replot added is wrong */
    plot_forget_coming(s);
    s->plot.waiting = false;
#if CONFIG_CONTROL
    plot_iteration_end(s);
    s->alternative = ALTERNATIVE_PASSED; /* of what was under way */
#endif
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

static int run(session_t *s) {
    for (;;) {
        session_frame_t *f = session_top(s);
        int err = 0;
        if (s->quit) {
            while (s->frames > 1) pop(s);
            session_forget_line(&s->frame[0]);
            return 0;
        }
        if (s->plot.waiting) {
            if (f->handle < 0) return 0;
            err = session_file_data(s, f);
#if CONFIG_LOAD_DEPTH
        } else if (s->in_block) {
            if (f->handle < 0) {
                session_forget_line(f);
                return 0;
            }
            err = session_file_block(s, f);
#endif
        } else if (f->lx.tok.kind == TOKEN_END) {
            if (f->handle < 0) {
                session_forget_line(f);
                return 0;
            }
            err = session_next_line(s, f);
            if (err == 0) pop(s);
        } else if (!lexer_accept(&f->lx, ';')) {
            err = command_execute(s, &f->lx);
        }
        if (err < 0) return err;
    }
}

int session_line(session_t *s, const char *text) {
    session_frame_t *f = &s->frame[0];
    size_t n = strlen(text);
    while (n > 0 && (text[n - 1] == '\n' || text[n - 1] == '\r')) n--;
    int err = 0;
    bool rows_left = false;
    s->error = (lang_error_t){0};
#if CONFIG_CONTROL
    s->turns = 0;
#endif
    f->line++;
    if (s->quit || session_pass_over(s, text)) return 0;
#if CONFIG_LOAD_DEPTH
    s->row = s->plot.waiting ? text : NULL;
#endif
    if (s->plot.waiting) {
        bool stopped = false;
        char *whole = s->frame_chunk[0].bytes; /* no data file is open now */
        if (CONFIG_64BIT && n < CONFIG_READ_CHUNK) {
            memcpy(whole, text, n);
            whole[n] = '\n';
            err = plot_feed(s, whole, n + 1, &stopped);
        } else {
            err = plot_feed(s, text, n, &stopped);
            if (!err && !stopped) err = plot_feed(s, "\n", 1, &stopped);
        }
        rows_left = err && !stopped;
#if CONFIG_LOAD_DEPTH
    } else if (s->in_block) {
        err = block_line(s, text, n);
#endif
    } else {
        if (!f->more) {
            session_forget_line(f);
            f->first_line = f->line;
        }
        err = session_append(s, f, text, n);
        if (!err) {
            session_end_line(f);
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
    if (!err && in_block(s)) err = lang_error_set(&s->error, ERR_SYNTAX, 0, SESSION_NO_END);
    if (!err && f->more) {
#if CONFIG_CONTROL
        const bool block = f->braces > 0;
#else
        const bool block = false;
#endif
        session_forget_line(f);
        err = lang_error_set(&s->error, ERR_SYNTAX, 0,
                             block ? SESSION_NO_BRACE : "the last line is to be continued, but nothing follows");
    }
    if (!err) err = run(s);
    return err < 0 ? give_up(s, err) : 0;
}
