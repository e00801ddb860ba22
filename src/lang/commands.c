/* commands.c - which command a line holds; the small ones are carried out here. */
#include "lang/session_parts.h"

/* What is printed, which `set print` may send to a data block. */
int session_say(session_t *s, const char *text) {
#if CONFIG_LOAD_DEPTH
    if (s->print_to[0]) return s->port->keep(s->port->ctx, s->print_to, text, strlen(text));
#endif
    s->port->print(s->port->ctx, text);
    return 0;
}

/* print a, "text", b: one line, a blank between values. Values go out as they are computed, so a line has no limit. */
static int print_command(session_t *s, lexer_t *lx) {
    bool first = true;
    int err = 0;
    do {
        char number[VALUE_TEXT_MAX];
        const char *text = number;
#if CONFIG_CONTROL
        if (array_is_whole(s, lx)) {
            if (!first) err = session_say(s, " ");
            if (!err) err = array_print(s, lx);
            first = false;
            continue;
        }
#else
        if (lx->tok.kind == TOKEN_STRING) {
            text = s->frame_name[0]; /* lent: no data file is open now */
            err = session_string(s, lx, s->frame_name[0], CONFIG_NAME_MAX + 1, "");
        } else
#endif
        {
            value_t v;
            err = expr_value(&s->lang, lx, &v, &s->error);
            if (!err && v.kind == VALUE_TEXT)
                text = value_chars(v);
            else if (!err)
                value_format(v, number);
        }
        if (err) break;
        if (!first) err = session_say(s, " ");
        if (!err) err = session_say(s, text);
        first = false;
    } while (!err && lexer_accept(lx, ','));
    const int ended = first ? 0 : session_say(s, "\n"); /* what went out before a mistake has its line, too */
    if (!err) err = ended;
    return err ? err : session_expect_end(s, lx);
}

static int pause_command(session_t *s, lexer_t *lx) {
    char *prompt = s->frame_name[0];
    int64_t ms = -1;
    prompt[0] = '\0';
    if (lexer_is_almost(lx, "mou$se")) { /* there is none: a key will do */
        lexer_next(lx);
        while (lx->tok.kind == TOKEN_NAME || lx->tok.kind == ',') lexer_next(lx);
    } else {
        num_t seconds;
        int err = expr_number(&s->lang, lx, &seconds, &s->error);
        if (err) return err;
        if (num_sign(seconds) >= 0) {
            ms = num_to_fixed(num_mul(seconds, num_from_i64(1000)), 0, NULL);
            if (ms > INT32_MAX) ms = INT32_MAX;
        }
    }
    if (!session_at_end(lx)) {
        int err = session_string(s, lx, prompt, CONFIG_NAME_MAX + 1, "a text in quotes expected");
        if (!err) err = session_expect_end(s, lx);
        if (err) return err;
    }
    return s->port->pause(s->port->ctx, prompt, (int32_t)ms);
}

static int load_command(session_t *s, lexer_t *lx) {
    lexer_t at = *lx;
    char *name = s->frame_name[0];
    int err = session_string(s, lx, name, CONFIG_NAME_MAX + 1, "the name of a file in quotes expected");
    if (!err) err = session_expect_end(s, lx);
    return err ? err : session_load(s, name, &at);
}

static int reset_command(session_t *s, lexer_t *lx) {
    bool session = lexer_is_almost(lx, "s$ession");
    if (session || lexer_is_almost(lx, "b$ind") || lexer_is_almost(lx, "err$orstate")) lexer_next(lx);
    int err = session_expect_end(s, lx);
    if (err) return err;
    set_reset(s);
    if (session) {
        session_forget_names(s);
        s->last[0] = '\0';
        s->last_len = 0;
    }
    return 0;
}

static int exit_command(session_t *s, lexer_t *lx) {
    session_skip(lx); /* as gnuplot: `quit` quits, whatever follows */
    s->quit = true;
    return 0;
}

/* Those that ask for their own word. Apart from plots, which need the stack. */
static __attribute__((noinline)) int other_command(session_t *s, lexer_t *lx, int index) {
    const lexer_t word = *lx;
    lexer_next(lx);
    switch (words_command_id[index]) {
#if CONFIG_CONTROL
    case CMD_CONTROL:
        return control_command(s, lx, &word);
    case CMD_UNDEFINE:
        return undefine_command(s, lx);
    case CMD_ARRAY:
        return array_command(s, lx);
#if CONFIG_LOAD_DEPTH
    case CMD_EVALUATE:
        return block_evaluate(s, lx);
#endif
#endif
    case CMD_UNSUPPORTED:
        return lang_error_set_name(&s->error, ERR_UNSUPPORTED, lexer_column(&word), "a command of gnuplot's only",
                                   lexer_text(&word), word.tok.len);
    default:
        session_warn_once(s, s->warned_command, index, "", &word, " is ignored");
        session_skip(lx);
        return 0;
    }
}

static int named_command(session_t *s, lexer_t *lx, int index) {
    const enum command_id id = words_command_id[index];
    if (id >= CMD_CONTROL) return other_command(s, lx, index);
    const uint32_t from = lx->tok.start;
    lexer_next(lx);
    switch (id) {
    case CMD_EXIT:
        return exit_command(s, lx);
    case CMD_HELP:
        return help_command(s, lx);
    case CMD_LOAD:
        return load_command(s, lx);
    case CMD_PAUSE:
        return pause_command(s, lx);
    case CMD_PLOT:
        return plot_command(s, lx, PLOT_CURVES, from);
    case CMD_PRINT:
        return print_command(s, lx);
    case CMD_REPLOT:
        return plot_replot(s, lx);
    case CMD_RESET:
        return reset_command(s, lx);
    case CMD_SET:
        return set_command(s, lx);
    case CMD_SHOW:
        return show_command(s, lx);
    case CMD_SPLOT:
        return plot_command(s, lx, PLOT_SURFACES, from);
    default: /* CMD_UNSET */
        return set_unset_command(s, lx);
    }
}

int command_execute(session_t *s, lexer_t *lx) {
    if (lexer_accept(lx, '?')) return help_command(s, lx);
#if CONFIG_CONTROL
    if (lx->tok.kind == '}') return control_close(s, lx);
    if (lx->tok.kind == '{') return control_open(s, lx);
#endif
#if CONFIG_LOAD_DEPTH
    if (lx->tok.kind == '$') return block_command(s, lx);
#endif
#if CONFIG_CONTROL
    int assigned = array_assign(s, lx);
    if (assigned) return assigned < 0 ? assigned : session_expect_end(s, lx);
#endif
    int defined = expr_define(&s->lang, lx, &s->error);
    if (defined < 0) return defined;
    if (defined) return session_expect_end(s, lx);
    int index = words_find(words_command, lx);
    if (index >= 0) return named_command(s, lx, index);
    if (lx->tok.kind != TOKEN_NAME) return lexer_unexpected(lx, &s->error, "a command expected");
    return lang_error_set_name(&s->error, ERR_NAME, lexer_column(lx), "unknown command", lexer_text(lx), lx->tok.len);
}
