/* plot_run.c - carries out a parsed plot command: reads its data, makes its surfaces, has it drawn.
 *
 * The command waits between the rows of inline data, so its progress (source[next]) is in the session. */
#include "lang/session_parts.h"

static int fail_at(session_t *s, const session_source_t *src, int code, const char *message) {
    return lang_error_set(&s->error, code, src->column, message);
}

/* A using expression asks for a column of the row at hand: what is not there is undefined. */
static value_t column_value(void *ctx, int32_t n) {
    session_t *s = ctx;
    const data_reader_t *r = &s->plot.reader;
    if (n < 0 || n > CONFIG_DATA_COLUMNS) return value_undef();
    int32_t have = r->spec->format == DATA_ROWS ? r->field.count : 3;
    return n > have ? value_undef() : value_real(r->column[n]);
}

static num_t compute(void *ctx, int32_t part) {
    session_t *s = ctx;
    value_t v;
    int err = expr_eval(&s->lang, &s->plot.source[s->plot.next].part[part], NULL, &v);
    if (err && !s->plot.data_error) s->plot.data_error = err;
    return value_num(v);
}

static void start_reader(session_t *s, session_source_t *src, bool inline_data, int32_t first_line) {
    src->first_grid = s->plot.grids;
    src->spec.compute = compute;
    src->spec.ctx = s;
    s->lang.column = column_value;
    s->lang.column_ctx = s;
    s->plot.data_error = 0;
    data_reader_start(&s->plot.reader, &src->spec, &s->pool, s->plot.grid + s->plot.grids,
                      s->plot.curve + s->plot.grids, CONFIG_PLOT_ITEMS - s->plot.grids, inline_data, first_line);
}

/* A reader's error, in the data's own lines. */
static int trouble(session_t *s, const session_source_t *src, int err, enum data_grid_trouble why, int32_t line,
                   int32_t at) {
    if (why == DATA_OK) return fail_at(s, src, err, err == ERR_EMPTY ? "no data" : error_text(err));
    lang_error_set(&s->error, err, at, data_grid_text(why));
    s->error.line = line;
    return err;
}

static int data_failed(session_t *s, const session_source_t *src, int err) {
    const data_reader_t *r = &s->plot.reader;
    s->lang.column = NULL;
    return trouble(s, src, err, r->trouble, r->line, r->at);
}

/* The data of source[next] are complete. */
static int data_done(session_t *s) {
    session_source_t *src = &s->plot.source[s->plot.next];
    int n = data_reader_finish(&s->plot.reader);
    if (n < 0) return data_failed(s, src, n);
    s->lang.column = NULL;
    if (s->plot.data_error) {
        int err = expr_fault(&s->lang, NULL, &s->error);
        s->error.column = src->column;
        return err;
    }
    src->grids = n;
    s->plot.grids += n;
    s->plot.next++;
    return 0;
}

/* A terrain comes alone. */
static int read_mesh(session_t *s, session_source_t *src, int handle) {
    session_chunk_t *c = &s->frame_chunk[0];
    const session_port_t *port = s->port;
    obj_reader_t r;
    obj_reader_start(&r, &s->pool);
    int err = 0;
    for (int n; !err && (n = port->read(port->ctx, handle, c->bytes, CONFIG_READ_CHUNK)) != 0;)
        err = n < 0 ? n : obj_reader_feed(&r, c->bytes, (size_t)n);
    if (!err) err = obj_reader_finish(&r, &s->plot.mesh);
    if (err) return trouble(s, src, err, r.trouble, r.line, r.at);
    s->plot.kind = PLOT_MESH;
    s->plot.next++;
    return 0;
}

static int read_grids(session_t *s, session_source_t *src, int handle) {
    session_chunk_t *c = &s->frame_chunk[0];
    const session_port_t *port = s->port;
    start_reader(s, src, false, 0);
    int err = 0;
    for (int n; !err && (n = port->read(port->ctx, handle, c->bytes, CONFIG_READ_CHUNK)) != 0;)
        err = n < 0 ? n : data_reader_feed(&s->plot.reader, c->bytes, (size_t)n);
    return err ? data_failed(s, src, err) : data_done(s);
}

static int read_file(session_t *s, session_source_t *src) {
    char *name = s->frame_name[0];
    lexer_string(&src->name, name, CONFIG_NAME_MAX + 1);
    int handle = s->port->open(s->port->ctx, name);
    if (handle < 0)
        return lang_error_set_name(&s->error, handle, src->column, "cannot read the data file", name, strlen(name));
    int err = src->kind == SOURCE_MESH ? read_mesh(s, src, handle) : read_grids(s, src, handle);
    s->port->close(s->port->ctx, handle);
    return err;
}

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

/* The extent of all data, in which functions beside them are drawn. */
static bool data_extent(session_t *s, int k, num_t out[2]) {
    for (int32_t i = 0; i < s->plot.grids; i++) {
        num_t e[2];
        set_extent(s, i, k, e);
        if (i == 0 || num_cmp(e[0], out[0]) < 0) out[0] = e[0];
        if (i == 0 || num_cmp(e[1], out[1]) > 0) out[1] = e[1];
    }
    return s->plot.grids > 0;
}

/* Where functions are drawn along axis k: the range, its automatic ends being those of the data, else -10 and 10. */
static int function_range(session_t *s, int k, num_t *lo, num_t *hi) {
    const range_t *r = &s->plot.range[k];
    num_t all[2] = {num_from_i64(-10), num_from_i64(10)};
    data_extent(s, k, all);
    *lo = r->auto_lo ? all[0] : r->lo;
    *hi = r->auto_hi ? all[1] : r->hi;
    if (num_cmp(*lo, *hi) < 0) return 0;
    return fail_at(s, &s->plot.source[0], ERR_VALUE, k ? "the y range is empty" : "the x range is empty");
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

static int function_item(session_t *s, const session_source_t *src, session_work_t *work, plot_item_t *item,
                         const num_t lo[2], const num_t hi[2]) {
    const int32_t *iso = s->settings.isosamples, *samples = s->settings.samples;
    const int32_t along_x[2] = {samples[0], iso[1]}, along_y[2] = {iso[0], samples[1]};
    expr_source_t *source = &work->expr.source;
    expr_surface_source(source, &s->lang, &src->expr);
    int err;
    if (s->plot.kind == PLOT_CURVES) {
        err = expr_surface_curve(&work->expr.grid, source, lo[0], hi[0], samples[0], &item->curve);
    } else {
        err = expr_surface_grid(&work->expr.grid, source, lo, hi, iso, &item->surface);
        if (!err) err = expr_surface_grid(&work->expr.rows, source, lo, hi, along_x, &item->rows);
        if (!err) err = expr_surface_grid(&work->expr.cols, source, lo, hi, along_y, &item->cols);
        item->z_at = expr_surface_z_at;
    }
    return err ? fail_at(s, src, err, "the x or y range is too narrow") : 0;
}

static int data_item(session_t *s, const session_source_t *src, const data_grid_t *grid, session_work_t *work,
                     plot_item_t *item) {
    num_t x[2], y[2];
    int err = data_grid_surface(grid, data_limits(s, 0, x), data_limits(s, 1, y), &work->data, &item->surface);
    if (err) return fail_at(s, src, err, "fewer than 2 x 2 of these points are within the x and y ranges");
    item->rows = item->cols = item->surface;
    item->z_at = NULL;
    return 0;
}

/* All elements as items; the number of them or an error. */
static int make_items(session_t *s) {
    int n = 0;
    num_t lo[2], hi[2];
    if (s->plot.kind == PLOT_MESH) {
        const session_source_t *src = &s->plot.source[0];
        s->plot.item[0] = (plot_item_t){.title = src->title, .title_len = src->title_len, .mesh = s->plot.mesh};
        return 1;
    }
    bool function = false;
    for (int32_t k = 0; k < s->plot.sources; k++) function |= s->plot.source[k].kind == SOURCE_EXPR;
    for (int k = 0; function && k < (s->plot.kind == PLOT_CURVES ? 1 : 2); k++) { /* y is no variable of curves */
        int err = function_range(s, k, &lo[k], &hi[k]);
        if (err) return err;
    }
    for (int32_t k = 0; k < s->plot.sources; k++) {
        const session_source_t *src = &s->plot.source[k];
        bool data = src->kind != SOURCE_EXPR;
        for (int32_t g = 0; g < (data ? src->grids : 1); g++, n++) {
            if (n == CONFIG_PLOT_ITEMS)
                return lang_error_set_number(&s->error, ERR_FULL, src->column, "too much for one plot; most surfaces",
                                             CONFIG_PLOT_ITEMS);
            plot_item_t *item = &s->plot.item[n];
            item->title = src->title;
            item->title_len = src->title_len;
            int err = 0;
            if (data && s->plot.kind == PLOT_CURVES)
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

/* Evaluations that failed while drawing: a name that is defined nowhere, in a branch that was not tried. */
static int evaluation_error(session_t *s, int32_t n) {
    int32_t item = 0;
    for (int32_t k = 0; k < s->plot.sources && item < n; k++) {
        const session_source_t *src = &s->plot.source[k];
        if (src->kind != SOURCE_EXPR) {
            item += src->grids;
            continue;
        }
        int err = s->plot.work[item++].expr.source.error;
        if (err)
            return fail_at(s, src, err, "some points could not be computed: a name is missing or recursion ran out");
    }
    return 0;
}

static int draw(session_t *s) {
    int n = make_items(s);
    if (n < 0) return n;
    range_t *const axis[3] = {&s->settings.x, &s->settings.y, &s->settings.z};
    range_t set[3];
    int32_t seed[2] = {s->lang.seed[0], s->lang.seed[1]};
    for (int k = 0; k < 3; k++) {
        set[k] = *axis[k];
        *axis[k] = s->plot.range[k];
    }
    plot_t plot = {s->plot.kind, n, s->plot.item, &s->settings};
    int err = s->port->plot(s->port->ctx, &plot);
    for (int k = 0; k < 3; k++) *axis[k] = set[k];
    s->lang.seed[0] = seed[0];
    s->lang.seed[1] = seed[1];
    if (err == ERR_UNSUPPORTED && n > 1)
        return fail_at(s, &s->plot.source[s->plot.sources > 1], err,
                       "surfaces cannot hide each other here; try unset hidden3d");
    if (err < 0) return fail_at(s, &s->plot.source[0], err, error_text(err));
    return evaluation_error(s, n);
}

/* Goes on with source[next]; returns 0 when the plot is drawn or waits for inline data. */
static int go_on(session_t *s) {
    while (s->plot.next < s->plot.sources) {
        session_source_t *src = &s->plot.source[s->plot.next];
        int err = 0;
        if (src->kind == SOURCE_EXPR || s->plot.next < s->plot.kept) {
            s->plot.next++;
        } else if (src->kind == SOURCE_INLINE) {
            start_reader(s, src, true, s->frame[s->frames - 1].line);
            s->plot.waiting = true;
            return 0;
        } else {
            err = read_file(s, src);
        }
        if (err) return err;
    }
    s->plot.valid = s->plot.sources;
    int err = draw(s);
    if (err) return err;
    s->last_len = strlen(s->last);
    s->in_last = false;
    return 0;
}

static int start(session_t *s, int32_t kept) {
    s->plot.kept = kept;
    s->plot.next = 0;
    s->plot.valid = kept;
    if (kept == 0) {
        s->pool.low = 0;
        s->pool.high = s->pool_size;
        s->plot.grids = 0;
    }
    return go_on(s);
}

int plot_command(session_t *s, lexer_t *lx, enum plot_kind kind, const lexer_t *word) {
    s->in_last = false;
    int err = plot_parse(s, lx, kind);
    if (err) return err;
    size_t len = lx->tok.start - word->tok.start;
    memcpy(s->last, lexer_text(word), len);
    s->last[len] = '\0';
    s->last_len = len;
    return start(s, 0);
}

/* replot [, more]: the last command again, with its inline data, and with more elements behind it. */
int plot_replot(session_t *s, lexer_t *lx) {
    size_t len = strlen(s->last);
    if (len == 0) return session_fail(s, lx, ERR_EMPTY, "nothing was plotted yet");
    if (!session_at_end(lx)) {
        lexer_t from = *lx;
        session_skip(lx);
        size_t more = lx->tok.start - from.tok.start;
        if (len + 2 + more > CONFIG_LINE_MAX)
            return lang_error_set_number(&s->error, ERR_FULL, lexer_column(&from), "the plot command is too long; most",
                                         CONFIG_LINE_MAX);
        memcpy(s->last + len, ", ", 2);
        memcpy(s->last + len + 2, lexer_text(&from), more);
        s->last[len + 2 + more] = '\0';
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
    return err ? err : start(s, has_inline ? before : 0);
}

int plot_feed(session_t *s, const char *text, size_t n, bool *stopped) {
    *stopped = false;
    int err = data_reader_feed(&s->plot.reader, text, n);
    if (err) return data_failed(s, &s->plot.source[s->plot.next], err);
    if (!s->plot.reader.stopped) return 0;
    *stopped = true;
    return plot_feed_end(s);
}

int plot_feed_end(session_t *s) {
    int err = data_done(s);
    if (err) return err;
    s->plot.waiting = false;
    return go_on(s);
}
