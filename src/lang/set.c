/* set.c - `set`: which option, and the options that are one number or one text. */
#include "lang/log_axes.h"
#include "lang/session_parts.h"
#include "scene/grid.h"

void set_reset(session_t *s) {
    settings_default(&s->settings);
    s->separator = 0;
    s->axes = AXES_XY;
    s->nonlinear = false;
#if CONFIG_LOGSCALE
    log_axes_reset(s);
#endif
#if CONFIG_PARAMETRIC
    s->uv[0] = s->uv[1] = (range_t){.auto_lo = true, .auto_hi = true};
#if CONFIG_SAMPLED
    s->t = s->uv[0];
    s->mapping = DATA_CARTESIAN;
#endif
#endif
#if CONFIG_SCATTERED
    scattered_default(&s->scattered);
#endif
    s->lang.degrees = false;
#if CONFIG_LOAD_DEPTH
    s->print_to[0] = '\0';
#endif
    memcpy(s->dummy[0], "x", 2);
    memcpy(s->dummy[1], "y", 2);
}

int set_integer(session_t *s, lexer_t *lx, int32_t lo, int32_t hi, int32_t *out, const char *message) {
    lexer_t at = *lx;
    num_t v;
    int err = expr_number(&s->lang, lx, &v, &s->error);
    if (err) return err;
    bool fits = true;
    int64_t i = num_to_fixed(num_trunc(v), 0, &fits); /* 3.7 samples are 3, as in gnuplot */
    if (!fits || i < lo || i > hi) return session_fail(s, &at, ERR_VALUE, message);
    *out = (int32_t)i;
    return 0;
}

int set_scaled(session_t *s, lexer_t *lx, int decimals, int64_t lo, int64_t hi, int64_t *out, const char *message) {
    lexer_t at = *lx;
    num_t v;
    int err = expr_number(&s->lang, lx, &v, &s->error);
    if (err) return err;
    bool fits = true;
    int64_t i = num_to_fixed(num_mul(v, num_from_decimal(1, decimals)), 0, &fits);
    if (!fits || i < lo || i > hi) return session_fail(s, &at, ERR_VALUE, message);
    *out = i;
    return 0;
}

/* set samples a[,b]: one number counts for both. */
static int set_pair(session_t *s, lexer_t *lx, int32_t pair[2], const char *message) {
    int32_t a = pair[0], b = pair[1];
    if (lx->tok.kind != ',') {
        int err = set_integer(s, lx, 2, GRID_SIDE_MAX, &a, message);
        if (err) return err;
        b = a;
    }
    if (lexer_accept(lx, ',')) {
        int err = set_integer(s, lx, 2, GRID_SIDE_MAX, &b, message);
        if (err) return err;
    }
    int err = session_expect_end(s, lx);
    if (err) return err;
    pair[0] = a;
    pair[1] = b;
    return 0;
}

/* Everything is drawn with lines already: asking for that is no reason to warn. */
static bool is_lines_style(lexer_t lx) {
    if (!lexer_is_almost(&lx, "d$ata") && !lexer_is_almost(&lx, "f$unction")) return false;
    lexer_next(&lx);
    if (!lexer_is_almost(&lx, "l$ines")) return false;
    lexer_next(&lx);
    return session_at_end(&lx);
}

/* The tics that option `id` of gnuplot is about, or 0. */
uint8_t set_tics_of(uint8_t id) {
    switch (id) {
    case SET_XTICS:
        return SETTINGS_TICS_X;
    case SET_YTICS:
        return SETTINGS_TICS_Y;
    case SET_ZTICS:
        return SETTINGS_TICS_Z;
    case SET_TICS:
        return SETTINGS_TICS_ALL;
    default:
        return 0;
    }
}

/* set border [BITS ...]: the four lowest bits are the base plane's edges. */
static int set_border(session_t *s, lexer_t *lx) {
    num_t bits = num_from_i64(31);
    if (lx->tok.kind == TOKEN_NUMBER) {
        int err = expr_number(&s->lang, lx, &bits, &s->error);
        if (err) return err;
    }
    s->settings.border_base = (num_to_fixed(bits, 0, NULL) & 15) != 0;
    return 0;
}

int set_find_option(session_t *s, lexer_t *lx, const char *missing) {
    int index = words_find(words_set, lx);
    if (index >= 0) return index;
    if (lx->tok.kind != TOKEN_NAME) return lexer_unexpected(lx, &s->error, missing);
    return lang_error_set_name(&s->error, ERR_NAME, lexer_column(lx), "unknown option", lexer_text(lx), lx->tok.len);
}

int set_unknown(session_t *s, const lexer_t *word) {
    return lang_error_set_name(&s->error, ERR_NAME, lexer_column(word), "an option of `show` only", lexer_text(word),
                               word->tok.len);
}

/* set noXXX: gnuplot's old way to say unset XXX. The token is XXX then. */
static bool is_negated(lexer_t *lx) {
    const lexer_t whole = *lx;
    const char *p = lexer_text(lx);
    if (lx->tok.kind != TOKEN_NAME || lx->tok.len < 4 || p[0] != 'n' || p[1] != 'o' || words_find(words_set, lx) >= 0)
        return false;
    lx->tok.start += 2;
    lx->tok.len -= 2;
    if (words_find(words_set, lx) >= 0) return true;
    *lx = whole;
    return false;
}

/* set logscale, nonlinear: none, or names and numbers of axes, of which x, y and z are drawn here. */
static bool is_of_xyz(const lexer_t *lx) {
    const char *p = lexer_text(lx);
    bool any = session_at_end(lx) || lx->tok.kind != TOKEN_NAME;
    for (uint32_t k = 0; k < lx->tok.len && !any; k++)
        any = p[k] >= 'x' && p[k] <= 'z' && (k + 1 == lx->tok.len || p[k + 1] != '2');
    return any;
}

/* What makes axes of another kind: on or off. Is it such an option? */
bool set_axes(session_t *s, uint8_t id, bool on) {
    if (id == SET_NONLINEAR) s->nonlinear = on;
    if (id == SET_POLAR) s->axes = on ? AXES_POLAR : AXES_XY;
    if (id == SET_PARAMETRIC) s->axes = on ? AXES_PARAMETRIC : AXES_XY;
    return id == SET_NONLINEAR || id == SET_POLAR || id == SET_PARAMETRIC;
}

int set_command(session_t *s, lexer_t *lx) {
    if (is_negated(lx)) return set_unset_command(s, lx);
    lexer_t word = *lx;
    int index = set_find_option(s, lx, "an option expected; try `help set`");
    if (index < 0) return index;
    settings_t *set = &s->settings;
    lexer_next(lx);
#if CONFIG_LOAD_DEPTH
    if (words_set_id[index] == SET_PRINT && (lx->tok.kind == '$' || session_at_end(lx))) return block_print(s, lx);
    if (words_set_id[index] == SET_PALETTE) block_of_palette(s, *lx);
#endif
    switch (words_set_id[index]) {
    case SET_ANGLES:
        return set_angles(s, lx);
    case SET_AUTOSCALE:
        return set_autoscale(s, lx);
    case SET_DATAFILE:
        return set_datafile(s, lx, index, &word);
#if CONFIG_SCATTERED
    case SET_DGRID:
        return set_dgrid(s, lx);
#endif
    case SET_DUMMY:
        return set_dummy(s, lx);
    case SET_HALO:
        return set_halo(s, lx);
#if CONFIG_AREA
    case SET_CREASE:
        return set_crease(s, lx);
    case SET_PEN:
        return set_pen(s, lx);
    case SET_HATCH:
        return set_hatch(s, lx);
    case SET_LIGHT:
        return set_light(s, lx);
    case SET_SHADOW:
        return set_shadow(s, lx);
#endif
    case SET_HIDDEN3D:
        return set_hidden3d(s, lx);
    case SET_ISOSAMPLES:
        return set_pair(s, lx, set->isosamples, "isosamples must be between 2 and 65536");
#if CONFIG_LOGSCALE
    case SET_LOGSCALE:
        return log_axes_set(s, lx, true);
#endif
    case SET_MACHINE:
        return set_machine(s, lx);
    case SET_PAPER:
        return set_paper(s, lx);
    case SET_SAMPLES:
        return set_pair(s, lx, set->samples, "samples must be between 2 and 65536");
    case SET_TITLE:
        return set_title(s, lx);
    case SET_VIEW:
        return set_view(s, lx);
    case SET_XRANGE:
        return set_range_option(s, lx, &set->x);
    case SET_YRANGE:
        return set_range_option(s, lx, &set->y);
    case SET_ZRANGE:
        return set_range_option(s, lx, &set->z);
#if CONFIG_PARAMETRIC
    case SET_PARAMETRIC: {
        const int err = session_expect_end(s, lx);
        if (!err) s->axes = AXES_PARAMETRIC;
        return err;
    }
    case SET_URANGE:
    case SET_VRANGE:
        return set_range_option(s, lx, &s->uv[words_set_id[index] == SET_VRANGE]);
#endif
#if CONFIG_SAMPLED
    case SET_TRANGE:
        return set_range_option(s, lx, &s->t);
    case SET_MAPPING:
        return set_mapping(s, lx);
    case SET_POLAR:
        s->axes = AXES_POLAR;
        session_skip(lx); /* grid options */
        return 0;
#endif
    case SET_XYPLANE:
    case SET_TICSLEVEL:
        return set_xyplane(s, lx);
    case SET_STYLE:
        if (is_lines_style(*lx)) {
            session_skip(lx);
            return 0;
        } /* fall through */
    case SET_BORDER:
    case SET_TICS:
    case SET_XTICS:
    case SET_YTICS:
    case SET_ZTICS:
        set->tics |= set_tics_of(words_set_id[index]);
        if (words_set_id[index] == SET_BORDER) {
            int err = set_border(s, lx);
            if (err) return err;
        } /* fall through */
    case SET_IGNORED:
    case SET_PRINT:
    case SET_PALETTE:
#if !CONFIG_SAMPLED
    case SET_POLAR:
#endif
#if !CONFIG_PARAMETRIC
    case SET_PARAMETRIC:
#endif
    case SET_NONLINEAR:
    case SET_FUNCTIONS: /* set function style, long gone from gnuplot */
        if (words_set_id[index] == SET_NONLINEAR && is_of_xyz(lx)) {
            session_skip(lx);
            s->nonlinear = true; /* a picture without it would be another one: plots are refused */
            return 0;
        }
        if (words_set_id[index] != SET_NONLINEAR) set_axes(s, words_set_id[index], true);
        session_warn_once(s, s->warned_set, index, "set ", &word, " is ignored");
        session_skip(lx);
        return 0;
    default:
        return set_unknown(s, &word);
    }
}
