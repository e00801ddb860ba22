/* plot_iteration.c - `for` in front of an element of a plot command: the element once for each value of a variable.
 *
 * What is compiled for the element takes the variable's value of then (compile.c). Functions that it calls look at the
 * variable itself, so the element's code sets it first; all variables get their own values back when all is drawn. */
#include "lang/session_parts.h"

#if CONFIG_CONTROL
/* for [i=a:b] for [...]: *n ranges. */
static int ranges(session_t *s, lexer_t *lx, control_range_t *range, int *n) {
    const lexer_t at = *lx;
    while (lexer_is_name(lx, "for")) {
        if (*n == LANG_ITERATED || s->plot.iterations == CONFIG_BLOCKS)
            return session_fail(s, lx, ERR_FULL, "too many `for` in one plot");
        lexer_next(lx);
        int err = control_range(s, lx, &range[*n]);
        if (err) return err;
        if (!control_within(&range[*n])) return session_fail(s, &at, ERR_VALUE, "no value is in this range");
        s->plot.iterated[s->plot.iterations++] = range[*n];
        control_set(s, &range[*n]);
        s->lang.iterated[*n] = (uint8_t)range[*n].symbol;
        ++*n;
    }
    return 0;
}

/* The next values, the last range first; false after the last ones. */
static bool advance(control_range_t *range, int n) {
    for (int k = n - 1; k >= 0; k--) {
        range[k].now += range[k].step;
        if (control_within(&range[k])) return true;
        range[k].now = range[k].first;
    }
    return false;
}

int plot_iteration(session_t *s, lexer_t *lx, enum plot_kind kind, const expr_params_t *params) {
    control_range_t range[LANG_ITERATED];
    int n = 0, err = ranges(s, lx, range, &n);
    const lexer_t body = *lx;
    bool open = false;
    for (int k = 0; k < n; k++) open |= range[k].open;
    s->lang.iterations = (uint8_t)n;
    bool more = !err;
    while (more) {
        for (int k = 0; k < n; k++) control_set(s, &range[k]);
        *lx = body;
        err = plot_element(s, lx, kind, params);
        if (!err) s->plot.source[s->plot.sources - 1].open_ended = open;
        more = !err && advance(range, n) && !(open && s->plot.sources == CONFIG_PLOT_ITEMS);
    }
    s->lang.iterations = 0;
    while (n > 0) control_restore(s, &range[--n]);
    return err;
}

int plot_iteration_check(session_t *s) {
    for (int32_t k = 0; k < s->plot.sources; k++) {
        const session_source_t *src = &s->plot.source[k];
        const expr_t *const e[4] = {&src->expr, &src->part[0], &src->part[1], &src->part[2]};
        for (int32_t i = 0; i < s->plot.iterations && !src->iterated; i++)
            for (int p = 0; p < 4; p++)
                if (e[p]->code && expr_mentions(&s->lang, e[p], s->plot.iterated[i].symbol))
                    return plot_fail(s, src, ERR_UNSUPPORTED, "this uses a variable that `for` changes elsewhere");
    }
    return 0;
}

void plot_iteration_end(session_t *s) {
    while (s->plot.iterations > 0) control_restore(s, &s->plot.iterated[--s->plot.iterations]);
}
#endif
