/* plot_sampled.c - what is computed from a parameter and then treated as data: the files '+' and '++', and `plot` of
 * parametric and polar curves.
 *
 *     plot sample [t=0:20:0.5] '+' using (t):(sin(t)), [10:30] x
 *     splot '++' using 1:2:($1*$2)
 *     set parametric; plot sin(3*t), cos(5*t)      set polar; plot 1+cos(t) */
#include "lang/log_axes.h"
#include "lang/plot_options.h"
#include "lang/session_parts.h"
#include "num/func.h"
#include "num/num_double.h"

#if CONFIG_SAMPLED
/* [t=0:10:2] at its bracket, for parameter k. */
static int sampling_range(session_t *s, lexer_t *lx, int k, expr_params_t *params, session_source_t *src) {
    lexer_t name = *lx;
    plot_sampling_t *to = &src->sampling[k];
    to->range = (range_t){.auto_lo = true, .auto_hi = true};
    to->step = num_from_i64(0);
    int err = set_range(s, lx, &to->range, &name, &to->step);
    if (err) return err;
    to->given = true;
    if (name.tok.kind != TOKEN_NAME) return 0;
    params->name[k].text = lexer_text(&name);
    params->name[k].len = (uint8_t)name.tok.len;
    return 0;
}

int plot_sampling(session_t *s, lexer_t *lx, expr_params_t *params, session_source_t *src) {
    if (lexer_is_name(lx, "sample")) lexer_next(lx);
    for (int k = 0; k < 2 && lx->tok.kind == '['; k++) {
        int err = sampling_range(s, lx, k, params, src);
        if (err) return err;
    }
    return 0;
}

void plot_sampled_file(session_t *s, session_source_t *src, bool surface, expr_params_t *params) {
    static const char uv[] = "uv";
    src->sampled = surface ? 2 : 1;
    params->count = src->sampled;
    for (int k = 0; surface && k < 2; k++)
        if (params->name[k].text == s->dummy[k]) {
            params->name[k].text = uv + k;
            params->name[k].len = 1;
        }
    s->plot.using_params = params;
}

int plot_sampled_curve(session_t *s, lexer_t *lx, const expr_params_t *params, session_source_t *src) {
    expr_params_t of_t = *params;
    const bool polar = s->axes == AXES_POLAR;
    of_t.count = 1;
    s->plot.using_params = &of_t;
    src->kind = SOURCE_FILE;
    src->sampled = 1;
    src->spec.flat = true;
    src->spec.parts = 2;
    src->spec.part[0] = polar ? 1 : USING_EXPR;
    src->spec.part[1] = USING_EXPR;
    src->spec.wanted = polar ? 2 : 0;
    int err = 0;
    for (int k = polar; k < 2 && !err; k++) {
        if (k == 1 && !polar && !lexer_accept(lx, ','))
            err = lexer_unexpected(lx, &s->error, "a parametric curve needs two expressions: x, y");
        else
            err = plot_options_expression(s, lx, &src->part[k]);
    }
    s->plot.using_params = NULL;
    return err;
}

static void apply(const range_t *r, num_t end[2]) {
    if (!r->auto_lo) end[r->reverse] = r->lo;
    if (!r->auto_hi) end[!r->reverse] = r->hi;
}

/* Where parameter k begins and ends: its own range; else that of t, or u and v; else, of '+', that of x. Is it that? */
static bool parameter_ends(const session_t *s, const session_source_t *src, int k, num_t end[2]) {
    const range_t *r = src->sampled == 1 ? &s->plot.t : &s->plot.uv[k];
    const bool of_x = src->sampled == 1 && s->axes == AXES_XY && r->auto_lo && r->auto_hi;
    end[0] = num_from_i64(of_x ? -10 : -5);
    end[1] = num_neg(end[0]);
    if (s->axes == AXES_POLAR && src->sampled == 1) {
        end[0] = num_from_i64(0);
        end[1] = s->lang.degrees ? num_from_i64(360) : num_ldexp(func_pi(), 1);
    }
    if (of_x) r = &s->plot.range[0];
#if CONFIG_LOGSCALE
    if (of_x) log_axes_open_range(s, 0, end);
#endif
    apply(r, end);
#if CONFIG_LOGSCALE
    /* A range of its own is taken in equal steps also over a logarithmic axis, whose ends are logarithms. */
    for (int i = 0; i < 2 && of_x && src->sampling[k].given && s->log_base[0].m; i++)
        end[i] = num_double(func_pow(s->log_base[0], end[i]));
#endif
    if (src->sampling[k].given) apply(&src->sampling[k].range, end);
    return of_x && !src->sampling[k].given;
}

/* Parameters are spread evenly over logarithmic axes where these give the range. */
typedef struct spread {
    num_t from, step, to, base;
    int32_t n;
    bool by_n; /* to is the last */
} spread_t;

static int spread(const session_t *s, const session_source_t *src, int k, spread_t *out) {
    num_t end[2];
    const bool of_x = parameter_ends(s, src, k, end);
    *out = (spread_t){.from = end[0], .to = end[1], .by_n = true, .base = num_from_i64(0)};
    out->n = k ? s->settings.isosamples[1] : s->settings.samples[0];
#if CONFIG_LOGSCALE
    if (of_x) out->base = s->log_base[0]; /* the plot's range of x holds logarithms */
#else
    (void)of_x;
#endif
    const num_t step = src->sampling[k].given ? src->sampling[k].step : num_from_i64(0),
                span = num_sub(out->to, out->from);
    if (num_sign(step)) {
        bool fits = true;
        const int64_t n = num_to_fixed(num_add(num_div(span, step), num_from_decimal(1, -9)), 0, &fits);
        if (!fits || n < 0 || n >= INT32_MAX) return ERR_VALUE;
        out->n = (int32_t)n + 1;
        out->by_n = false;
        out->step = step;
    } else {
        out->step = num_div(span, num_from_i64(out->n - 1));
    }
    return 0;
}

static num_t spread_at(const spread_t *p, int32_t i) {
    const bool last = p->by_n && i == p->n - 1;
    const num_t v = last ? p->to : num_add(p->from, num_mul(p->step, num_from_i64(i)));
    return p->base.m ? func_pow(p->base, v) : num_double(v);
}

int plot_sampled_read(session_t *s, session_source_t *src) {
    spread_t u, v = {.n = 1};
    int err = spread(s, src, 0, &u);
    if (!err && src->sampled == 2) err = spread(s, src, 1, &v);
    if (err) return plot_fail(s, src, err, "this range and its step do not go together");
    err = plot_data_start(s, src, false, 0);
    for (int32_t j = 0; j < v.n && !err; j++) {
        for (int32_t i = 0; i < u.n && !err; i++) {
            const num_t row[2] = {spread_at(&u, i), src->sampled == 2 ? spread_at(&v, j) : num_undef()};
            err = data_reader_row(&s->plot.reader, row, src->sampled);
        }
        if (!err && src->sampled == 2) err = data_reader_break(&s->plot.reader);
    }
    return err ? plot_data_failed(s, src, err) : plot_data_done(s);
}
#endif
