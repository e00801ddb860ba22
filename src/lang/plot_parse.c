/* plot_parse.c - a whole plot command, checked and compiled before anything is read or drawn.
 *
 *     splot [x0:x1] [y0:y1] [z0:z1] f(x,y) with lines title 'f', 'file' using 1:2:($3*2) index 0, '-' matrix ... */
#include "lang/log_axes.h"
#include "lang/plot_options.h"
#include "lang/session_parts.h"

static int compile(session_t *s, lexer_t *lx, const expr_params_t *params, expr_t *out) {
    uint8_t *code = s->plot.code + s->plot.code_len;
    int err = expr_compile(&s->lang, lx, params, code, sizeof s->plot.code - s->plot.code_len, out, &s->error);
    if (!err) s->plot.code_len += out->len;
    return err;
}

int plot_options_expression(session_t *s, lexer_t *lx, expr_t *out) {
#if CONFIG_SAMPLED
    return compile(s, lx, s->plot.using_params, out);
#else
    return compile(s, lx, NULL, out);
#endif
}

#if CONFIG_LOGSCALE
#define NO_AXES SAID("nonlinear axes are not supported")
/* The bases of logarithmic axes that the code of an element needs; part: of a parametric one, or -1. */
static expr_params_t with_bases(const session_t *s, enum plot_kind kind, const expr_params_t *params, int part) {
    expr_params_t p = *params;
    const int result = part >= 0 ? part : kind == PLOT_CURVES ? 1 : 2;
    for (int k = 0; k < 2 && part < 0; k++) p.base[k] = s->log_base[k].m ? &s->log_base[k] : NULL;
    p.result_base = s->log_base[result].m ? &s->log_base[result] : NULL;
    return p;
}
#else
#define NO_AXES SAID("logarithmic axes are not supported; draw log10() of it")
#endif

/* One evaluation finds the names that are defined nowhere, before anything is drawn. */
static int try_out(session_t *s, const session_source_t *src) {
    int32_t seed[2] = {s->lang.seed[0], s->lang.seed[1]};
    num_t at[2];
    for (int k = 0; k < 2; k++) {
        const range_t *r = &s->plot.range[k];
        at[k] = r->auto_lo || r->auto_hi ? num_from_i64(1) : num_ldexp(num_add(r->lo, r->hi), -1);
    }
    value_t v;
    int err = expr_eval(&s->lang, &src->expr, at, &v);
    if (CONFIG_CONTROL && err == ERR_FULL) { /* a recursion that only ends for some numbers */
        for (int k = 0; k < 2; k++) at[k] = s->plot.range[k].auto_lo ? num_from_i64(0) : s->plot.range[k].lo;
        err = expr_eval(&s->lang, &src->expr, at, &v);
    }
    s->lang.seed[0] = seed[0];
    s->lang.seed[1] = seed[1];
    if (CONFIG_CONTROL && !err && v.kind == VALUE_TEXT)
        return plot_fail(s, src, ERR_VALUE, SAID("a number is needed here, not a text"));
    if (!err) return 0;
    err = expr_fault(&s->lang, &src->name, &s->error);
    if (s->error.column == 0) s->error.column = src->column;
    return err;
}

#define FLAT_Q30 1073740189 /* cosine of a tenth of a degree */

static bool ends_in(const char *name, int n, const char *suffix) {
    int m = (int)strlen(suffix);
    return n >= m && memcmp(name + n - m, suffix, (size_t)m) == 0;
}

#if CONFIG_CONTROL
bool plot_is_plain(const lexer_t *lx) {
    lexer_t next = *lx;
    lexer_next(&next);
    return lx->tok.kind == TOKEN_STRING && next.tok.kind != '.' && next.tok.kind != '[';
}

int plot_text(session_t *s, lexer_t *lx, const char **text) {
    char *at = s->plot.texts + s->plot.texts_len;
    *text = at;
    int err = session_string(s, lx, at, sizeof s->plot.texts - s->plot.texts_len, "a text in quotes expected");
    if (!err) s->plot.texts_len += strlen(at) + 1;
    return err;
}
#endif

/* Does an element name a file? What begins with a text may be a formula, as word(c, 1)*x: then it has a number, or
 * names that only its points define. */
static bool is_file(session_t *s, const lexer_t *lx) {
    if (!session_is_text(s, lx)) return false;
#if CONFIG_CONTROL
    if (!plot_is_plain(lx)) {
        lexer_t after = *lx;
        value_t v;
        lang_error_t unused;
        const int err = expr_value(&s->lang, &after, &v, &unused);
        return err ? err != ERR_NAME : v.kind == VALUE_TEXT;
    }
#endif
    return true;
}

/* 'file', '-' for inline data, '' for the file before. */
static int data_name(session_t *s, lexer_t *lx, session_source_t *src, expr_params_t *params) {
    char *name = s->frame_name[0];
    int n = 0;
    const lexer_t at = *lx;
#if CONFIG_CONTROL
    if (!plot_is_plain(lx)) {
        int err = plot_text(s, lx, &src->file_name);
        if (err) return err;
        n = (int)strlen(src->file_name);
        memcpy(name, src->file_name, (size_t)n + 1);
    } else
#endif
        n = lexer_string(lx, name, CONFIG_NAME_MAX + 1);
    if (n < 0)
        return lang_error_set_number(&s->error, ERR_FULL, lexer_column(lx), "the file's name is too long; most bytes",
                                     CONFIG_NAME_MAX);
    static const char *const solid[] = {".obj", ".OBJ", ".stl", ".STL", ".off", ".OFF"};
    for (size_t k = 0; k < sizeof solid / sizeof solid[0]; k++) src->solid |= ends_in(name, n, solid[k]);
    src->kind = SOURCE_FILE;
    /* An STL cuts flat faces into triangles: their diagonals are none of its edges. */
    if (!src->smooth_q30 && (ends_in(name, n, ".stl") || ends_in(name, n, ".STL"))) src->smooth_q30 = FLAT_Q30;
    if (strcmp(name, "-") == 0) {
        src->kind = SOURCE_INLINE;
    } else if (strcmp(name, "+") == 0 || strcmp(name, "++") == 0) {
#if CONFIG_SAMPLED
        plot_sampled_file(s, src, name[1] != '\0', params);
#else
        (void)params;
        return session_fail(s, lx, ERR_UNSUPPORTED, "the pseudo file is not supported; plot an expression");
#endif
    } else if (name[0] == '<') {
        return session_fail(s, lx, ERR_UNSUPPORTED, "programs cannot be run for data");
    } else if (n == 0) {
        const session_source_t *before = src - 1;
        while (before >= s->plot.source && before->kind != SOURCE_FILE) before--;
        if (before < s->plot.source) return session_fail(s, lx, ERR_VALUE, "no file was named before this");
        src->name = before->name;
#if CONFIG_CONTROL
        src->file_name = before->file_name;
#endif
        src->solid = before->solid;
#if CONFIG_SAMPLED
        if (before->sampled) plot_sampled_file(s, src, before->sampled == 2, params);
#endif
    }
    if (lx->tok.start == at.tok.start) lexer_next(lx);
    return 0;
}

/* translate, rotate and scale, tried out here; plot_data.c reads them again. */
static int moves(session_t *s, lexer_t *lx, session_source_t *src) {
    affine_t a;
    affine_identity(&a);
    lexer_t at = *lx;
    int err = plot_options_moves(s, lx, &a, src, NULL);
    if (err || at.tok.start == lx->tok.start) return err;
    if (!src->solid) return session_fail(s, &at, ERR_UNSUPPORTED, "only solids can be moved or have a crease");
    src->moves = at.tok.start;
    return 0;
}

static void title_as_typed(session_source_t *src, const lexer_t *lx) {
    src->title_len = (int32_t)(lexer_text(lx) - src->title);
    while (src->title_len > 0 && src->title[src->title_len - 1] == ' ') src->title_len--;
}

static int element(session_t *s, lexer_t *lx, enum plot_kind kind, expr_params_t *params) {
    session_source_t *src = &s->plot.source[s->plot.sources];
    int32_t first_grid = src->first_grid, grids = src->grids; /* of the last plot: replot may need them */
#if CONFIG_PARAMETRIC
    const session_source_t last = *src;
#endif
    *src = (session_source_t){.column = lexer_column(lx), .first_grid = first_grid, .grids = grids};
#if CONFIG_PARAMETRIC
    src->curved = last.curved;
    src->empty = last.empty;
    memcpy(src->extent, last.extent, sizeof src->extent);
#endif
#if CONFIG_AREA
    src->smooth_q30 = plot_options_cosine(num_mul(num_from_i64(s->settings.crease_mdeg), num_from_decimal(1, -3)));
#endif
#if CONFIG_CONTROL
    src->iterated = s->lang.iterations > 0;
#endif
    data_spec_default(&src->spec);
    src->spec.separator = s->separator;
    int err = 0;
#if CONFIG_SAMPLED
    s->plot.using_params = NULL;
    err = plot_sampling(s, lx, params, src);
    if (err) return err;
#endif
    src->name = *lx;
    src->title = lexer_text(lx);
    if (is_file(s, lx)) {
        src->spec.flat = kind == PLOT_CURVES;
        err = data_name(s, lx, src, params);
        src->title_len = (int32_t)(src->name.tok.len);
#if CONFIG_CONTROL
        if (!err && src->file_name) {
            src->title = src->file_name;
            src->title_len = (int32_t)strlen(src->title);
        }
#endif
        if (!err) err = plot_options_data(s, lx, src);
        if (!err) err = moves(s, lx, src);
#if CONFIG_LOAD_DEPTH
    } else if (lx->tok.kind == '$') {
        src->spec.flat = kind == PLOT_CURVES;
        src->kind = SOURCE_FILE;
        err = block_name(s, lx, s->frame_name[0], CONFIG_NAME_MAX + 1);
        title_as_typed(src, lx);
        if (!err) err = plot_options_data(s, lx, src);
        if (!err) err = moves(s, lx, src);
#endif
    } else if (CONFIG_SAMPLED && lexer_is_name(lx, "keyentry")) { /* only gnuplot's key would show it */
        lexer_next(lx);
        return plot_options_style(s, lx, src);
    } else if ((!CONFIG_CONTROL && lexer_is_name(lx, "for")) ||
               (!CONFIG_SAMPLED && (lexer_is_name(lx, "keyentry") || lexer_is_name(lx, "sample")))) {
        return lang_error_set_name(&s->error, ERR_UNSUPPORTED, lexer_column(lx), "not supported", lexer_text(lx),
                                   lx->tok.len);
#if CONFIG_SAMPLED
    } else if (kind == PLOT_CURVES && s->axes != AXES_XY) {
        err = plot_sampled_curve(s, lx, params, src);
        title_as_typed(src, lx);
#endif
    } else {
        src->kind = SOURCE_EXPR;
        src->parametric = CONFIG_PARAMETRIC && s->axes == AXES_PARAMETRIC && kind == PLOT_SURFACES;
        if (s->axes != AXES_XY && !src->parametric)
            return session_fail(s, lx, ERR_UNSUPPORTED,
                                "plots of this kind are not supported with polar or parametric axes");
        if (src->parametric && s->settings.hidden == HIDDEN_HORIZON)
            return session_fail(s, lx, ERR_UNSUPPORTED, "parametric surfaces want set hidden3d, or unset hidden3d");
        src->solid = src->parametric;
        expr_t *out = src->parametric ? src->part : &src->expr;
        for (int k = 0; k < (src->parametric ? 3 : 1); k++) {
            if (k > 0 && !lexer_accept(lx, ','))
                return lexer_unexpected(lx, &s->error, "a parametric surface needs three expressions: x, y, z");
#if CONFIG_LOGSCALE
            const expr_params_t of_axes = with_bases(s, kind, params, src->parametric ? k : -1);
            err = compile(s, lx, &of_axes, &out[k]);
#else
            err = compile(s, lx, params, &out[k]);
#endif
            if (err) return err;
            if (out[k].columns) return lang_error_set(&s->error, ERR_SYNTAX, src->column, "$ belongs into using");
        }
        title_as_typed(src, lx);
    }
    if (!err) err = plot_options_style(s, lx, src);
    if (err) return err;
    s->plot.sources++;
    return 0;
}

int plot_element(session_t *s, lexer_t *lx, enum plot_kind kind, const expr_params_t *params) {
    if (s->plot.sources == CONFIG_PLOT_ITEMS)
        return lang_error_set_number(&s->error, ERR_FULL, lexer_column(lx), "too much for one plot; most elements",
                                     CONFIG_PLOT_ITEMS);
    expr_params_t own = *params; /* its ranges may have names of their own */
    return element(s, lx, kind, &own);
}

int plot_parse(session_t *s, lexer_t *lx, enum plot_kind kind) {
    lexer_t word = *lx;
    expr_params_t params = {0};
    s->plot.kind = kind;
    s->plot.sources = 0;
    s->plot.code_len = 0;
#if CONFIG_CONTROL
    s->plot.iterations = s->lang.iterations = 0;
    s->plot.texts_len = 0;
#endif
    if (s->nonlinear) return session_fail(s, lx, ERR_UNSUPPORTED, NO_AXES);
    int err = plot_ranges(s, lx, kind, &params);
#if CONFIG_LOGSCALE
    if (!err) err = log_axes_ranges(s, &word);
#endif
    if (err) return err;
    do {
        if (session_at_end(lx) && s->plot.sources > 0) break; /* a comma at the end, as gnuplot allows */
        if (session_at_end(lx)) return session_fail(s, lx, ERR_SYNTAX, "an expression or a file to draw expected");
        lexer_t at = *lx;
        int defined = expr_define(&s->lang, lx, &s->error);
        if (defined < 0) return defined;
        if (defined && s->plot.sources > 0) /* it would hold for the elements before it too */
            return session_fail(s, &at, ERR_UNSUPPORTED, "definitions belong in front of the first element");
        if (defined) continue;
#if CONFIG_CONTROL
        err = lexer_is_name(lx, "for") ? plot_iteration(s, lx, kind, &params) : plot_element(s, lx, kind, &params);
#else
        err = plot_element(s, lx, kind, &params);
#endif
        if (err) return err;
    } while (lexer_accept(lx, ','));
    err = session_expect_end(s, lx);
    if (err) return err;
    if (s->plot.sources == 0) return session_fail(s, &word, ERR_SYNTAX, "an expression or a file to draw expected");
#if CONFIG_CONTROL
    err = plot_iteration_check(s);
#endif
    for (int32_t k = 0; k < s->plot.sources && !err; k++) {
        const session_source_t *src = &s->plot.source[k];
        if (src->kind == SOURCE_EXPR && !src->parametric) err = try_out(s, src);
        if (src->solid && kind == PLOT_CURVES)
            err = lang_error_set(&s->error, ERR_UNSUPPORTED, src->column, "solids are drawn by splot");
        if (src->solid) s->plot.kind = PLOT_SOLIDS;
    }
    return err;
}
