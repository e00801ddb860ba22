/* plot_items.c - from the elements of a plot command to surfaces and curves: over which ranges, how many points. */
#include "lang/log_axes.h"
#include "lang/session_parts.h"
#include "scene/log_scale.h"

/* The extent of one set of data along x (k = 0) or y. */
static void set_extent(session_t *s, int32_t i, int k, num_t out[2]) {
    data_view_t v;
    surface_t u;
    curve_t c;
    if (s->plot.kind == PLOT_CURVES) {
        data_curve_get(&s->plot.curve[i], &c, out);
    } else {
        data_grid_surface(&s->plot.grid[i], NULL, NULL, &v, &u);
        out[0] = k ? u.y_of(&v, 0) : u.x_of(&v, 0);
        out[1] = k ? u.y_of(&v, u.ny - 1) : u.x_of(&v, u.nx - 1);
    }
}

static bool widen(num_t out[2], const num_t e[2], bool any) {
    if (!any || num_cmp(e[0], out[0]) < 0) out[0] = e[0];
    if (!any || num_cmp(e[1], out[1]) > 0) out[1] = e[1];
    return true;
}

/* The extent of all data, in which functions beside them are drawn. */
static bool data_extent(session_t *s, int k, num_t out[2]) {
    bool any = false;
    for (int32_t i = 0; i < s->plot.grids; i++) {
        num_t e[2];
        set_extent(s, i, k, e);
        any = widen(out, e, any);
    }
#if CONFIG_PARAMETRIC
    for (int32_t i = 0; i < s->plot.sources; i++)
        if (session_is_curved(&s->plot.source[i])) any = widen(out, s->plot.source[i].extent[k], any);
#endif
    return any;
}

void plot_extent(session_t *s, int k, num_t out[2]) {
    out[0] = num_from_i64(-10);
    out[1] = num_from_i64(10);
#if CONFIG_LOGSCALE
    log_axes_open_range(s, k, out);
#endif
    data_extent(s, k, out);
}

/* Where functions are drawn along axis k: the range, its automatic ends being those of the data, else -10 and 10. */
static int function_range(session_t *s, int k, num_t *lo, num_t *hi) {
    const range_t *r = &s->plot.range[k];
    num_t all[2];
    plot_extent(s, k, all);
    *lo = r->auto_lo ? all[0] : r->lo;
    *hi = r->auto_hi ? all[1] : r->hi;
    if (num_cmp(*lo, *hi) < 0) return 0;
    return plot_fail(s, &s->plot.source[0], ERR_VALUE, k ? "the y range is empty" : "the x range is empty");
}

/* The limits that data are cut to, for a range with one or two ends set. */
static const num_t *data_limits(session_t *s, int k, num_t out[2]) {
    const range_t *r = &s->plot.range[k];
    if ((r->auto_lo && r->auto_hi) || !data_extent(s, k, out)) return NULL;
    /* A border written as 2.0000001 is still inside of [-2:2]. */
    num_t slack = num_ldexp(num_sub(out[1], out[0]), -20);
    if (!r->auto_lo) out[0] = num_sub(r->lo, slack);
    if (!r->auto_hi) out[1] = num_add(r->hi, slack);
    return out;
}

#if CONFIG_SAMPLED
/* [0:1] in front of an element. */
static void own_range(const session_t *s, const range_t *r, num_t end[2]) {
    if (!r->auto_lo) end[0] = r->lo;
    if (!r->auto_hi) end[1] = r->hi;
#if CONFIG_LOGSCALE
    if (!r->auto_lo) end[0] = log_scale(s->log_base[0], end[0]);
    if (!r->auto_hi) end[1] = log_scale(s->log_base[0], end[1]);
#endif
    (void)s;
}
#endif

static int function_item(session_t *s, const session_source_t *src, session_work_t *work, plot_item_t *item,
                         const num_t lo[2], const num_t hi[2]) {
    const int32_t *iso = s->settings.isosamples, *samples = s->settings.samples;
    const int32_t along_x[2] = {samples[0], iso[1]}, along_y[2] = {iso[0], samples[1]};
    expr_source_t *source = &work->expr.source;
    expr_surface_source(source, &s->lang, &src->expr);
    int err;
    if (s->plot.kind == PLOT_CURVES) {
        num_t end[2] = {lo[0], hi[0]};
#if CONFIG_SAMPLED
        if (src->sampling[0].given) own_range(s, &src->sampling[0].range, end);
#endif
        err = expr_surface_curve(&work->expr.grid, source, end[0], end[1], samples[0], &item->curve);
    } else {
        err = expr_surface_grid(&work->expr.grid, source, lo, hi, iso, &item->surface);
        if (!err) err = expr_surface_grid(&work->expr.rows, source, lo, hi, along_x, &item->rows);
        if (!err) err = expr_surface_grid(&work->expr.cols, source, lo, hi, along_y, &item->cols);
        item->anywhere = &EXPR_SURFACE_ANYWHERE;
    }
    return err ? plot_fail(s, src, err, "the x or y range is too narrow") : 0;
}

#if CONFIG_CROP
/* The lines along axis k go on to where they are cut. */
static void crop(const session_t *s, int k, const data_grid_t *grid, const num_t *x_lim, const num_t *y_lim,
                 data_crop_t *work, surface_t *out) {
    const range_t *r = &s->plot.range[k];
    const num_t *lim = k ? y_lim : x_lim,
                at[2] = {r->auto_lo && lim ? lim[0] : r->lo, r->auto_hi && lim ? lim[1] : r->hi};
    data_crop_lines(grid, x_lim, y_lim, at, k == 1, work, out);
}
#endif

static int data_item(session_t *s, const session_source_t *src, const data_grid_t *grid, session_work_t *work,
                     plot_item_t *item) {
    num_t x[2], y[2];
    const num_t *x_lim = data_limits(s, 0, x), *y_lim = data_limits(s, 1, y);
    int err = data_grid_surface(grid, x_lim, y_lim, &work->data.data, &item->surface);
    if (err) return plot_fail(s, src, err, "fewer than 2 x 2 of these points are within the x and y ranges");
    item->rows = item->cols = item->surface;
    item->anywhere = NULL;
#if CONFIG_CROP
    item->cropped = s->settings.hidden == HIDDEN_NONE && (x_lim || y_lim);
    if (item->cropped) {
        crop(s, 0, grid, x_lim, y_lim, &work->data.rows, &item->rows);
        crop(s, 1, grid, x_lim, y_lim, &work->data.cols, &item->cols);
    }
#endif
    return 0;
}

/* All elements as items; the number of them or an error. */
int plot_items(session_t *s) {
    int n = 0;
    num_t lo[2], hi[2];
    bool function = false;
    for (int32_t k = 0; k < s->plot.sources; k++)
        function |= s->plot.source[k].kind == SOURCE_EXPR && !s->plot.source[k].solid;
    for (int k = 0; function && k < (s->plot.kind == PLOT_CURVES ? 1 : 2); k++) { /* y is no variable of curves */
        int err = function_range(s, k, &lo[k], &hi[k]);
        if (err) return err;
    }
    for (int32_t k = 0; k < s->plot.sources; k++) {
        const session_source_t *src = &s->plot.source[k];
        bool data = src->kind != SOURCE_EXPR;
        for (int32_t g = 0; g < session_items(src); g++, n++) {
            if (n == CONFIG_PLOT_ITEMS)
                return lang_error_set_number(&s->error, ERR_FULL, src->column, "too much for one plot; most surfaces",
                                             CONFIG_PLOT_ITEMS);
            plot_item_t *item = &s->plot.item[n];
            item->title = src->title;
            item->title_len = (int16_t)src->title_len; /* of a line of CONFIG_LINE_MAX bytes */
            const bool curved = session_is_curved(src) && g == src->grids;
#if CONFIG_CROP
            item->cropped = false;
#endif
            item->solid = src->solid || curved;
            item->parametric = src->parametric || curved;
#if CONFIG_PARAMETRIC
            memcpy(item->extent, src->extent, sizeof item->extent);
#endif
            int err = 0;
            if (item->solid)
                item->mesh = s->plot.mesh[k];
            else if (data && s->plot.kind == PLOT_CURVES)
                data_curve_get(&s->plot.curve[src->first_grid], &item->curve, NULL);
            else if (data)
                err = data_item(s, src, &s->plot.grid[src->first_grid + g], &s->plot.work[n], item);
            else
                err = function_item(s, src, &s->plot.work[n], item, lo, hi);
            if (err) return err;
        }
    }
    return n;
}
