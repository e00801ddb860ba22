/* log_axes.c - set logscale: what is drawn are logarithms.
 *
 * Behind the language all axes are linear. Expressions get a logarithm of x and give one of what they yield (the code
 * for that is made with them), data are converted as they are read, and ranges and places of the view when a plot
 * begins. The unit is then one power of the base, which is what axes with tics are rounded outward to. */
#include "lang/log_axes.h"
#include "lang/session_parts.h"
#include "scene/log_scale.h"

#if CONFIG_LOGSCALE
/* Names of axes in one word, as in xy or zcb; *mask gets those that are drawn. */
static int names(session_t *s, const lexer_t *lx, uint8_t *mask) {
    static const char *const others[] = {"x2", "y2", "cb", "r"};
    const char *p = lexer_text(lx), *const end = p + lx->tok.len;
    while (p < end) {
        size_t n = 0;
        for (size_t k = 0; k < sizeof others / sizeof others[0] && !n; k++) {
            const size_t len = strlen(others[k]);
            if ((size_t)(end - p) >= len && memcmp(p, others[k], len) == 0) n = len;
        }
        if (n == 0 && (*p < 'x' || *p > 'z'))
            return session_fail(s, lx, ERR_NAME, "names of axes expected, such as x, yz or zcb");
        if (n == 0) *mask |= (uint8_t)(1 << (*p - 'x'));
        p += n ? n : 1;
    }
    return 0;
}

int log_axes_set(session_t *s, lexer_t *lx, bool on) {
    uint8_t mask = 0;
    num_t base = num_from_i64(on ? 10 : 0);
    if (session_at_end(lx)) mask = 7;
    while (lx->tok.kind == TOKEN_NAME) {
        int err = names(s, lx, &mask);
        if (err) return err;
        lexer_next(lx);
    }
    if (on && !session_at_end(lx)) {
        const lexer_t at = *lx;
        int err = expr_number(&s->lang, lx, &base, &s->error);
        if (err) return err;
        if (num_cmp(base, num_from_i64(1)) <= 0) return session_fail(s, &at, ERR_VALUE, "a base above 1 expected");
    }
    int err = session_expect_end(s, lx);
    for (int k = 0; k < 3 && !err; k++)
        if (mask >> k & 1) s->log_base[k] = base;
    return err;
}

void log_axes_reset(session_t *s) {
    for (int k = 0; k < 3; k++) s->log_base[k] = num_from_i64(0);
}

/* The ranges of the plot. One that is open begins as a range of -10 to 10 would: a lower end that has no logarithm is
 * 0.1, as gnuplot has it. */
int log_axes_ranges(session_t *s, const lexer_t *at) {
    s->settings.log_axes = 0;
    for (int k = 0; k < 3; k++) {
        range_t *r = &s->plot.range[k];
        const num_t base = s->log_base[k];
        if (base.m == 0) continue;
        s->settings.log_axes |= (uint8_t)(1 << k);
        if (!r->auto_lo && num_sign(r->lo) <= 0) r->lo = num_from_decimal(1, -1);
        if (!r->auto_hi && (num_sign(r->hi) <= 0 || (!r->auto_lo && num_cmp(r->lo, r->hi) >= 0)))
            return session_fail(s, at, ERR_VALUE, "a logarithmic axis has no values but above 0; see its range");
        if (!r->auto_lo) r->lo = log_scale(base, r->lo);
        if (!r->auto_hi) r->hi = log_scale(base, r->hi);
#if CONFIG_BOUNDED
        for (int i = 0; i < 4; i++)
            if ((r->bounded >> i & 1) && num_sign(r->bound[i]) > 0)
                r->bound[i] = log_scale(base, r->bound[i]);
            else
                r->bounded &= (uint8_t) ~(1 << i);
#endif
    }
    return 0;
}

void log_axes_open_range(const session_t *s, int k, num_t range[2]) {
    if (s->log_base[k].m == 0) return;
    range[0] = log_scale(s->log_base[k], num_from_decimal(1, -1));
    range[1] = log_scale(s->log_base[k], range[1]);
}

int log_axes_view(session_t *s, log_axes_view_t *was) {
    settings_t *set = &s->settings;
    bool good = true;
    for (int k = 0; k < 3; k++) {
        was->eye[k] = set->view.eye[k];
        was->to[k] = set->view.to[k];
        set->view.eye[k] = log_scale(s->log_base[k], set->view.eye[k]);
        set->view.to[k] = log_scale(s->log_base[k], set->view.to[k]);
        good &= !set->view.from || (!set->view.eye[k].undef && (!set->view.has_to || !set->view.to[k].undef));
    }
    was->xyplane = set->xyplane;
    if (set->xyplane_at) set->xyplane = log_scale(s->log_base[2], set->xyplane);
    return good && !set->xyplane.undef ? 0 : ERR_VALUE;
}

void log_axes_view_back(session_t *s, const log_axes_view_t *was) {
    memcpy(s->settings.view.eye, was->eye, sizeof was->eye);
    memcpy(s->settings.view.to, was->to, sizeof was->to);
    s->settings.xyplane = was->xyplane;
}
#endif
