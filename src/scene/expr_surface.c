/* expr_surface.c - points of an expression, computed on demand. */
#include "scene/expr_surface.h"
#include "error.h"
#include "num/noise.h"
#include "num/num_double.h"

void expr_surface_source(expr_source_t *s, lang_t *lang, const expr_t *expr) {
    *s = (expr_source_t){.lang = lang, .expr = *expr, .random = expr_is_impure(lang, expr)};
    s->seed[0] = lang->seed[0];
    s->seed[1] = lang->seed[1];
}

static void note_error(expr_source_t *s, int err) {
    if (err && !s->error) s->error = err;
}

/* A text is no height; as a hole it would be passed over in silence. */
static inline num_t number(expr_source_t *s, value_t v) {
    if (CONFIG_CONTROL && v.kind == VALUE_TEXT) note_error(s, ERR_VALUE);
    return value_num(v);
}

static __attribute__((noinline)) void seed_for(const expr_source_t *s, const num_t *at, int n) {
    uint64_t hash = noise_hash(s->seed);
    for (int k = 0; k < n; k++) hash = noise_at(hash, at[k]);
    noise_seeds(hash, s->lang->seed);
}

static num_t evaluate(expr_source_t *s, const num_t *at, int n) {
    value_t v;
    if (s->random) seed_for(s, at, n);
    note_error(s, expr_eval(s->lang, &s->expr, at, &v));
    return number(s, v);
}

static num_t place(const expr_grid_t *g, int k, int32_t i) {
    if (i == 0) return g->lo[k];
    if (i == g->n[k] - 1) return g->hi[k];
    return num_double_add(g->lo[k], num_double_mul(num_from_i64(i), g->step[k]));
}

static num_t x_of(void *ctx, int32_t i) {
    return place(ctx, 0, i);
}

static num_t y_of(void *ctx, int32_t j) {
    return place(ctx, 1, j);
}

static size_t lend_anywhere(void *ctx, void *mem, size_t bytes) {
    expr_grid_t *g = ctx;
    expr_source_t *s = g->source;
    size_t used = mem && !s->random ? hoist_init(s->lang, &s->expr, NULL, 1, mem, bytes) : 0;
    g->hoist = used ? mem : NULL;
    if (used) g->hoist->anywhere = true;
    return used;
}

/* Each way to a height is a function of its own, and what is done before it another: little may be on the stack where
 * expressions are evaluated. */
static __attribute__((noinline)) num_t z_anywhere(const expr_grid_t *g, const num_t at[2]) {
    value_t v;
    if (!hoist_has_column(g->hoist, 0, at[0])) note_error(g->source, hoist_column(g->hoist, 0, at[0]));
    if (!hoist_has_row(g->hoist, at[1])) note_error(g->source, hoist_row(g->hoist, at[1]));
    note_error(g->source, hoist_point(g->hoist, 0, &v));
    return number(g->source, v);
}

static inline num_t z_there(const expr_grid_t *g, const num_t at[2]) {
    return g->hoist && g->hoist->anywhere ? z_anywhere(g, at) : evaluate(g->source, at, 2);
}

static num_t z_at(void *ctx, num_t x, num_t y) {
    const num_t at[2] = {x, y};
    return z_there(ctx, at);
}

static __attribute__((noinline)) num_t z_hoisted(const expr_grid_t *g, int32_t i) {
    value_t v;
    note_error(g->source, hoist_point(g->hoist, i, &v));
    return number(g->source, v);
}

/* Rows are mostly asked for as a whole. */
static __attribute__((noinline)) void enter_row(expr_grid_t *g, int32_t j) {
    g->row = j;
    g->row_y = place(g, 1, j);
    if (g->hoist && !g->hoist->anywhere) note_error(g->source, hoist_row(g->hoist, g->row_y));
}

static __attribute__((noinline)) num_t z_not_hoisted(const expr_grid_t *g, int32_t i) {
    const num_t at[2] = {place(g, 0, i), g->row_y};
    return z_there(g, at);
}

static num_t z_of(void *ctx, int32_t i, int32_t j) {
    expr_grid_t *g = ctx;
    if (j != g->row) enter_row(g, j);
    return !g->hoist || g->hoist->anywhere ? z_not_hoisted(g, i) : z_hoisted(g, i);
}

#if CONFIG_ROW_POINTS > 1
static void z_row(void *ctx, int32_t i, int32_t j, int32_t n, num_t *z) {
    expr_grid_t *g = ctx;
    if (g->hoist && g->hoist->width && !g->hoist->anywhere) {
        if (j != g->row) enter_row(g, j);
        note_error(g->source, hoist_points(g->hoist, i, n, z));
    } else {
        for (int32_t k = 0; k < n; k++) z[k] = z_of(g, i + k, j);
    }
}
#endif

const surface_anywhere_t EXPR_SURFACE_ANYWHERE = {z_at, lend_anywhere};

static size_t lend(void *ctx, void *mem, size_t bytes) {
    expr_grid_t *g = ctx;
    expr_source_t *s = g->source;
    g->hoist = NULL;
    g->row = -1;
    size_t used = mem ? hoist_init(s->lang, &s->expr, s->random ? s->seed : NULL, g->n[0], mem, bytes) : 0;
    if (!used) return 0;
    g->hoist = mem;
    for (int32_t i = 0; i < g->n[0]; i++) note_error(s, hoist_column(g->hoist, i, place(g, 0, i)));
    return used;
}

static num_t y_at(void *ctx, int32_t i) {
    expr_grid_t *g = ctx;
    num_t x = place(g, 0, i);
    return evaluate(g->source, &x, 1);
}

/* Steps below this part of the larger end could leave two points on one double. */
#define STEP_SHIFT (-51)

static int sample(expr_grid_t *g, int k, num_t lo, num_t hi, int32_t n) {
    g->lo[k] = lo;
    g->hi[k] = hi;
    g->n[k] = n;
    g->step[k] = num_double_div(num_double_add(hi, num_neg(lo)), num_from_i64(n - 1));
    num_t a = num_abs(lo), b = num_abs(hi), least = num_ldexp(num_cmp(a, b) < 0 ? b : a, STEP_SHIFT);
    return g->step[k].undef || num_cmp(g->step[k], least) <= 0 ? ERR_VALUE : 0;
}

int expr_surface_grid(expr_grid_t *g, expr_source_t *source, const num_t lo[2], const num_t hi[2], const int32_t n[2],
                      surface_t *out) {
    g->source = source;
    g->row = -1;
    g->hoist = NULL;
    *out = (surface_t){.nx = n[0], .ny = n[1], .ctx = g, .x_of = x_of, .y_of = y_of, .z_of = z_of, .lend = lend};
#if CONFIG_ROW_POINTS > 1
    out->z_row = z_row;
#endif
    int err = sample(g, 0, lo[0], hi[0], n[0]);
    return err ? err : sample(g, 1, lo[1], hi[1], n[1]);
}

int expr_surface_curve(expr_grid_t *g, expr_source_t *source, num_t lo, num_t hi, int32_t n, curve_t *out) {
    g->source = source;
    *out = (curve_t){n, g, x_of, y_at};
    return sample(g, 0, lo, hi, n);
}
