/* set_range.c - axis ranges: [lo:hi], [hi:lo], [*:5], [:5], [0<*<2:], [u=0:1]; and autoscale. */
#include "lang/session_parts.h"

/* What was typed for one end. */
typedef struct range_end {
    bool automatic, given; /* a number was */
    num_t value;
#if CONFIG_BOUNDED
    uint8_t bounded; /* 1: least, 2: most, of an automatic one */
    num_t bound[2];
#endif
} range_end_t;

/* A number, `*` for autoscale, `a<*<b` for that within bounds, or nothing for as it was. */
static int range_end(session_t *s, lexer_t *lx, range_end_t *e) {
    e->given = false;
    if (lx->tok.kind == ':' || lx->tok.kind == ']') return 0;
    num_t v;
    if (lx->tok.kind != '*') {
        int err = expr_number(&s->lang, lx, &v, &s->error);
        if (err) return err;
#if CONFIG_BOUNDED
        if (lexer_accept(lx, '<')) {
            *e = (range_end_t){.bounded = 1, .bound = {v}};
        } else
#endif
        {
            *e = (range_end_t){.given = true, .value = v};
            return 0;
        }
    } else {
        *e = (range_end_t){0};
    }
    e->automatic = true;
    lexer_next(lx);
#if CONFIG_BOUNDED
    if (lexer_accept(lx, '<')) {
        e->bounded |= 2;
        return expr_number(&s->lang, lx, &e->bound[1], &s->error);
    }
#endif
    return 0;
}

/* The end of a range as it was. */
static range_end_t end_of(const range_t *r, bool high) {
    range_end_t e = {.automatic = high ? r->auto_hi : r->auto_lo, .value = high ? r->hi : r->lo};
#if CONFIG_BOUNDED
    e.bounded = r->bounded >> 2 * high & 3;
    for (int k = 0; k < 2; k++) e.bound[k] = r->bound[2 * high + k];
#endif
    return e;
}

int set_range(session_t *s, lexer_t *lx, range_t *r, lexer_t *name, num_t *step) {
    lexer_t bracket = *lx;
    if (!lexer_accept(lx, '[')) return lexer_unexpected(lx, &s->error, "a range [from:to] expected");
    if (name && lx->tok.kind == TOKEN_NAME) {
        lexer_t after = *lx;
        lexer_next(&after);
        if (after.tok.kind == '=') {
            *name = *lx;
            lexer_next(&after);
            *lx = after;
        }
    }
    /* The ends in the order they are typed. */
    range_end_t from = end_of(r, r->reverse), to = end_of(r, !r->reverse);
    int err = range_end(s, lx, &from);
    if (err) return err;
    if (lexer_accept(lx, ':')) {
        err = range_end(s, lx, &to);
        if (err) return err;
        if (step && lexer_accept(lx, ':')) err = expr_number(&s->lang, lx, step, &s->error);
        if (err) return err;
    } else if (from.given) {
        return lexer_unexpected(lx, &s->error, "':' expected");
    }
    if (!lexer_accept(lx, ']')) return lexer_unexpected(lx, &s->error, "']' expected");
    bool reverse = r->reverse;
    if (from.automatic || to.automatic) {
        reverse = false;
    } else if (from.given || to.given) {
        int order = num_cmp(from.value, to.value);
        if (order == 0) return session_fail(s, &bracket, ERR_VALUE, "this range is empty");
        reverse = order > 0;
    }
    const range_end_t *lo = reverse ? &to : &from, *hi = reverse ? &from : &to;
    *r = (range_t){
        .auto_lo = lo->automatic, .auto_hi = hi->automatic, .reverse = reverse, .lo = lo->value, .hi = hi->value};
#if CONFIG_BOUNDED
    r->bounded = (uint8_t)(lo->bounded | hi->bounded << 2);
    for (int k = 0; k < 2; k++) {
        r->bound[k] = lo->bound[k];
        r->bound[2 + k] = hi->bound[k];
    }
#endif
    return 0;
}

int set_range_option(session_t *s, lexer_t *lx, range_t *out) {
    range_t r = *out;
    if (lexer_is_almost(lx, "re$store")) {
        lexer_next(lx);
        r = (range_t){.auto_lo = true, .auto_hi = true};
    } else if (lx->tok.kind == '[') {
        int err = set_range(s, lx, &r, NULL, NULL);
        if (err) return err;
    }
    while (!session_at_end(lx)) {
        if (lexer_is_almost(lx, "rev$erse"))
            r.reverse = true;
        else if (!lexer_is_almost(lx, "norev$erse") && !lexer_is_almost(lx, "wr$iteback") &&
                 !lexer_is_almost(lx, "nowri$teback") && !lexer_is_almost(lx, "ext$end") &&
                 !lexer_is_almost(lx, "noext$end"))
            return lexer_unexpected(lx, &s->error, "a range [from:to] expected");
        lexer_next(lx);
    }
    *out = r;
    return 0;
}

/* set autoscale [x|y|z|xy|xyz, with min, max or fix]. */
int set_autoscale(session_t *s, lexer_t *lx) {
    range_t *axis[3] = {&s->settings.x, &s->settings.y, &s->settings.z};
    const range_t all = {.auto_lo = true, .auto_hi = true};
    if (session_at_end(lx)) {
        for (int k = 0; k < 3; k++) *axis[k] = all;
        return 0;
    }
    do {
        const char *p = lexer_text(lx);
        size_t n = lx->tok.kind == TOKEN_NAME ? lx->tok.len : 0;
        size_t axes = 0;
        while (axes < n && p[axes] >= 'x' && p[axes] <= 'z') axes++;
        bool min = words_match("min", p + axes, n - axes), max = words_match("max", p + axes, n - axes);
        bool both = n == axes || words_match("fix", p + axes, n - axes);
        bool other = words_match("cb", p, n) || words_match("x2", p, n) || words_match("y2", p, n) ||
                     words_match("noext$end", p, n) || words_match("keepfix", p, n) || words_match("fix", p, n);
        if (n == 0 || (!other && (axes == 0 || (!min && !max && !both))))
            return lexer_unexpected(lx, &s->error, "axes expected, such as x, xy or zmax");
        for (size_t i = 0; !other && i < axes; i++) {
            range_t *r = axis[p[i] - 'x'];
            if (both) {
                *r = all;
            } else {
                if (min) r->auto_lo = true;
                if (max) r->auto_hi = true;
            }
        }
        lexer_next(lx);
    } while (lexer_accept(lx, ',') || lx->tok.kind == TOKEN_NAME);
    return session_expect_end(s, lx);
}
