/* plot_run.c - carries out a parsed plot command: has its data read, its surfaces made, and all drawn.
 *
 * The command waits between the rows of inline data, so its progress (source[next]) is in the session. */
#include "lang/log_axes.h"
#include "lang/session_parts.h"

int plot_fail(session_t *s, const session_source_t *src, int code, const char *message) {
    return lang_error_set(&s->error, code, src->column, message);
}

/* Evaluations that failed while drawing: in a branch that was not tried. */
static int evaluation_error(session_t *s, int32_t n) {
    int32_t item = 0;
    for (int32_t k = 0; k < s->plot.sources && item < n; k++) {
        const session_source_t *src = &s->plot.source[k];
        if (src->kind != SOURCE_EXPR || src->parametric) {
            item += session_items(src);
            continue;
        }
        int err = s->plot.work[item++].expr.source.error;
        if (err)
            return plot_fail(
                s, src, err,
                SAID(
                    "some points could not be computed: a name is missing, a text is no number, or recursion ran out"));
    }
    return 0;
}

/* The ranges of the command and those that are set, in each other's place. */
static void swap_ranges(session_t *s) {
    range_t *const axis[3] = {&s->settings.x, &s->settings.y, &s->settings.z};
    for (int k = 0; k < 3; k++) {
        range_t set = *axis[k];
        *axis[k] = s->plot.range[k];
        s->plot.range[k] = set;
    }
}

static int draw(session_t *s) {
    for (int32_t k = 0; k < s->plot.sources; k++)
        if (session_is_curved(&s->plot.source[k])) s->plot.kind = PLOT_SOLIDS; /* as their data turned out */
    int n = CONFIG_BOUNDED ? plot_items_in_bounds(s) : plot_items(s);
    if (n < 0) return n;
    if (CONFIG_PARAMETRIC && n == 0) return plot_fail(s, &s->plot.source[0], ERR_EMPTY, error_text(ERR_EMPTY));
    int32_t seed[2] = {s->lang.seed[0], s->lang.seed[1]};
    swap_ranges(s);
    plot_t plot = {s->plot.kind, n, s->plot.item, &s->settings};
#if CONFIG_LOGSCALE
    log_axes_view_t view;
    int err = log_axes_view(s, &view);
    if (!err) err = s->port->plot(s->port->ctx, &plot);
    log_axes_view_back(s, &view);
    s->settings.log_axes = 0;
#else
    int err = s->port->plot(s->port->ctx, &plot);
#endif
    swap_ranges(s);
    s->lang.seed[0] = seed[0];
    s->lang.seed[1] = seed[1];
    if (err == ERR_UNSUPPORTED && s->plot.kind == PLOT_SOLIDS)
        return plot_fail(s, &s->plot.source[0], err,
                         s->settings.hidden == HIDDEN_HORIZON ? "a terrain is drawn alone; solids want set hidden3d"
                                                              : "this set hidden3d cannot draw this scene");
    if (err == ERR_UNSUPPORTED && n > 1)
        return plot_fail(s, &s->plot.source[s->plot.sources > 1], err,
                         "surfaces cannot hide each other here; try unset hidden3d");
    if (err == ERR_VALUE && s->settings.view.from)
        return plot_fail(s, &s->plot.source[0], err,
                         "nothing can be seen: all is behind the eye, or too far for its size");
    if (err < 0) return plot_fail(s, &s->plot.source[0], err, error_text(err));
    return evaluation_error(s, n);
}

/* It was drawn, or at least begun. */
static void plot_is_last(session_t *s) {
    if (s->coming > 0) memmove(s->last, s->last + s->coming, strlen(s->last + s->coming) + 1);
    s->coming = -1;
    s->last_len = strlen(s->last);
}

#if CONFIG_PARAMETRIC
/* Among others an element may have nothing in the ranges, or be one more than there are data for. */
static int pass_empty(session_t *s, session_source_t *src) {
    s->error = (lang_error_t){0};
    src->grids = 0;
    src->curved = false;
    src->empty = true;
    s->plot.next++;
    return 0;
}
#endif

/* Goes on with source[next]; returns 0 when the plot is drawn or waits for inline data. */
static int go_on(session_t *s) {
    while (s->plot.next < s->plot.sources) {
        session_source_t *src = &s->plot.source[s->plot.next];
        int err = 0;
#if CONFIG_PARAMETRIC
        if (src->parametric && s->plot.next >= s->plot.kept) {
            err = plot_parametric(s, src);
            if (err == ERR_EMPTY && s->plot.sources > 1) err = pass_empty(s, src);
            if (err) return err;
            continue;
        }
#endif
        if (src->kind == SOURCE_EXPR || s->plot.next < s->plot.kept) {
            s->plot.next++;
        } else if (src->kind == SOURCE_INLINE) {
            err = plot_data_start(s, src, true, s->frame[s->frames - 1].line);
            s->plot.waiting = !err;
            return err;
        } else {
            err = plot_data_read(s, src);
#if CONFIG_CONTROL
            if (err == ERR_EMPTY && src->open_ended && s->plot.next > 0) err = pass_empty(s, src);
#endif
        }
        if (err) return err;
    }
    s->plot.valid = s->plot.sources;
#if CONFIG_CONTROL
    const session_source_t *last = &s->plot.source[s->plot.sources - 1];
    if (last->open_ended && !last->empty && s->plot.sources == CONFIG_PLOT_ITEMS)
        return lang_error_set_number(&s->error, ERR_FULL, last->column, "too much for one plot; most elements",
                                     CONFIG_PLOT_ITEMS);
#endif
    int err = draw(s);
#if CONFIG_CONTROL
    plot_iteration_end(s);
#endif
    if (!err || err == ERR_STOPPED || err == ERR_MACHINE) plot_is_last(s);
    if (err) return err;
    s->in_last = false;
    return 0;
}

void plot_forget_coming(session_t *s) {
    if (s->coming < 0) return;
    s->plot.valid = 0;
    if (s->coming == 0) {
        s->last[0] = '\0';
        s->last_len = 0;
    }
    s->coming = -1;
}

static int start(session_t *s, int32_t kept) {
    s->plot.kept = kept;
    s->plot.next = 0;
    s->plot.valid = kept;
#if CONFIG_PARAMETRIC
    for (int32_t k = kept; k < s->plot.sources; k++) s->plot.source[k].empty = false;
#endif
    if (kept == 0) {
        s->pool.low = 0;
        s->pool.high = s->pool_size;
        s->plot.grids = 0;
    }
    return go_on(s);
}

int plot_command(session_t *s, lexer_t *lx, enum plot_kind kind, uint32_t from) {
    s->in_last = false;
    int err = plot_parse(s, lx, kind);
    if (err) return err;
    const size_t len = lx->tok.start - from, behind = strlen(s->last) + 1;
    s->coming = behind > 1 && behind + len < sizeof s->last ? (int32_t)behind : 0;
    memcpy(s->last + s->coming, lx->text + from, len);
    s->last[(size_t)s->coming + len] = '\0';
    return start(s, 0);
}

/* The last command with more elements behind it. */
static int lengthen(session_t *s, lexer_t *lx, size_t len) {
    lexer_t from = *lx;
    session_skip(lx);
    size_t more = lx->tok.start - from.tok.start;
    if (len + 2 + more > CONFIG_LINE_MAX)
        return lang_error_set_number(&s->error, ERR_FULL, lexer_column(&from), "the plot command is too long; most",
                                     CONFIG_LINE_MAX);
    memcpy(s->last + len, ", ", 2);
    memcpy(s->last + len + 2, lexer_text(&from), more);
    s->last[len + 2 + more] = '\0';
    return 0;
}

/* Reads the last command. Returns how many of its sources are kept, or an error. Apart from what follows, for the
 * stack. */
static __attribute__((noinline)) int32_t recall_plot(session_t *s, lexer_t *lx) {
    size_t len = strlen(s->last);
    if (len == 0) return session_fail(s, lx, ERR_EMPTY, "nothing was plotted yet");
    if (!session_at_end(lx)) {
        int err = lengthen(s, lx, len);
        if (err) return err;
    }
    lexer_t again;
    lexer_start(&again, s->last, strlen(s->last));
    enum plot_kind kind = lexer_is_almost(&again, "sp$lot") ? PLOT_SURFACES : PLOT_CURVES;
    lexer_next(&again);
    int32_t before = s->plot.valid;
    s->in_last = true;
    int err = plot_parse(s, &again, kind);
    bool has_inline = false;
    for (int32_t k = 0; !err && k < before; k++) has_inline |= s->plot.source[k].kind == SOURCE_INLINE;
    return err ? err : has_inline ? before : 0;
}

/* replot [, more]: the last command again, with its inline data, and with more elements behind it. */
int plot_replot(session_t *s, lexer_t *lx) {
    const int32_t kept = recall_plot(s, lx);
    return kept < 0 ? kept : start(s, kept);
}

int plot_feed(session_t *s, const char *text, size_t n, bool *stopped) {
    int err = plot_data_feed(s, text, n, stopped);
    return err || !*stopped ? err : plot_feed_end(s);
}

int plot_feed_end(session_t *s) {
    int err = plot_data_done(s);
    if (err) return err;
    s->plot.waiting = false;
    return go_on(s);
}
