/* plot_data.c - from a file or inline rows of a plot command to grids, curves or solids in the session's pool. */
#include "lang/plot_options.h"
#include "lang/session_parts.h"

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
    /* Parameters of what is sampled are its columns. */
    const session_source_t *src = &s->plot.source[s->plot.next];
    int err = expr_eval(&s->lang, &src->part[part], s->plot.reader.column + 1, &v);
    if (err && !s->plot.data_error) s->plot.data_error = expr_fault(&s->lang, &src->name, &s->error); /* the first */
    return value_num(v);
}

/* What is not supported in a file of solids. */
static void notice(void *ctx, int32_t line, const char *text, int32_t len) {
    session_t *s = ctx;
    char where[40 + CONFIG_NAME_MAX];
    text_t t = text_start(where, sizeof where);
    text_add(&t, "line ");
    text_add_int(&t, line);
    text_add(&t, " of ");
    text_add(&t, s->plot.obj.inline_data ? "the data" : s->frame_name[0]);
    text_add(&t, ": ");
    session_warn(s, where, text, (size_t)len, " is not supported, and left out");
}

static int start_solid(session_t *s, session_source_t *src, bool inline_data, int32_t first_line) {
    src->grids = 0;
    affine_identity(&s->plot.affine);
    lexer_t lx;
    lexer_start(&lx, src->name.text + src->moves, src->moves ? src->name.len - src->moves : 0);
    char *names = NULL;
#if CONFIG_AREA
    names = s->plot.clear_names;
    names[0] = '\0';
#endif
    int err = plot_options_moves(s, &lx, &s->plot.affine, src, names);
    obj_reader_start(&s->plot.obj, &s->pool, src->moves ? &s->plot.affine : NULL, inline_data, first_line);
#if CONFIG_AREA
    if (names[0]) {
        s->plot.obj.clear = names;
        s->plot.obj.clear_now = true; /* as mesh_t.clear says */
    }
#endif
    s->plot.obj.notice = notice;
    s->plot.obj.notice_ctx = s;
    return err;
}

#if CONFIG_64BIT
static void find_columns(const session_t *s, session_source_t *src) {
    data_spec_t *spec = &src->spec;
    spec->known = true;
    for (int k = 0; k < spec->parts; k++)
        if (spec->part[k] == USING_EXPR) spec->known &= expr_is_of_columns(&s->lang, &src->part[k], &spec->looks[k]);
}
#endif

int plot_data_start(session_t *s, session_source_t *src, bool inline_data, int32_t first_line) {
    s->rows_bytes = 0;
#if CONFIG_PARAMETRIC
    src->curved = false;
#endif
    if (src->solid) return start_solid(s, src, inline_data, first_line);
    src->first_grid = s->plot.grids;
    src->spec.compute = compute;
    src->spec.ctx = s;
#if CONFIG_SCATTERED
    src->spec.scattered = s->scattered.on && !src->spec.flat ? &s->scattered : NULL;
#endif
#if CONFIG_SAMPLED
    src->spec.mapping = !src->spec.flat ? s->mapping : s->axes == AXES_POLAR ? DATA_POLAR : DATA_CARTESIAN;
    src->spec.degrees = s->lang.degrees;
#endif
#if CONFIG_LOGSCALE
    src->spec.log_base = s->settings.log_axes ? s->log_base : NULL;
#endif
#if CONFIG_64BIT
    find_columns(s, src);
#endif
    s->lang.column = column_value;
    s->lang.column_ctx = s;
    s->plot.data_error = 0;
    data_reader_start(&s->plot.reader, &src->spec, &s->pool, s->plot.grid + s->plot.grids,
                      s->plot.curve + s->plot.grids, CONFIG_PLOT_ITEMS - s->plot.grids, inline_data, first_line);
#if CONFIG_PARAMETRIC
    isolines_init(&s->plot.isolines);
    plot_limits(s, &s->plot.isolines);
    s->plot.reader.isolines = s->settings.hidden == HIDDEN_HORIZON ? NULL : &s->plot.isolines;
#endif
    return 0;
}

int plot_data_feed(session_t *s, const char *text, size_t n, bool *stopped) {
    const session_source_t *src = &s->plot.source[s->plot.next];
    int err = src->solid ? obj_reader_feed(&s->plot.obj, text, n) : data_reader_feed(&s->plot.reader, text, n);
    *stopped = src->solid ? s->plot.obj.stopped : s->plot.reader.stopped;
    return err ? plot_data_failed(s, src, err) : 0;
}

/* A reader's error, in the data's own lines. */
static int trouble(session_t *s, const session_source_t *src, int err, enum data_grid_trouble why, int32_t line,
                   int32_t at) {
    if (why == DATA_OK) return plot_fail(s, src, err, err == ERR_EMPTY ? "no data" : error_text(err));
    if (CONFIG_BINARY && line == 0 && why != DATA_FULL) return plot_fail(s, src, err, data_grid_text(why));
    if (why == DATA_FULL) {
        s->rows_bytes = (int32_t)(s->pool_size * sizeof(packed_t));
        lang_error_set_number(&s->error, err, at, "more data than the memory for it holds; most bytes", s->rows_bytes);
    } else
        lang_error_set(&s->error, err, at, data_grid_text(why));
    s->error.line = line;
    return err;
}

int plot_data_failed(session_t *s, const session_source_t *src, int err) {
    const data_reader_t *r = &s->plot.reader;
    const obj_reader_t *obj = &s->plot.obj;
    if (src->solid) return trouble(s, src, err, obj->trouble, obj->line, obj->at);
    s->lang.column = NULL;
    return trouble(s, src, err, r->trouble, r->line, r->at);
}

#if CONFIG_PARAMETRIC
/* Points that are no grid are drawn, with facets where each line has as many points. */
static int finish_isolines(session_t *s, session_source_t *src) {
    mesh_t *mesh = &s->plot.mesh[s->plot.next];
    if (isolines_finish(&s->plot.isolines, mesh))
        return plot_fail(s, src, ERR_EMPTY, "nothing to draw: neither two points of a line nor a facet are in range");
    memcpy(src->extent, s->plot.isolines.extent, sizeof src->extent);
    if (s->plot.reader.left_grid_at) {
        char where[24];
        text_t t = text_start(where, sizeof where);
        text_add(&t, "its line ");
        text_add_int(&t, s->plot.reader.left_grid_at);
        text_add(&t, ": ");
        const char *why = data_grid_text(s->plot.reader.trouble);
        session_warn(s, where, "", 0, why);
    }
    if (mesh->faces == 0)
        session_warn(s, "", "lines", 5, " are drawn: isolines of one length, or set dgrid3d, would make a surface");
    src->curved = true;
    return 0;
}
#endif

/* The data of source[next] are complete. */
int plot_data_done(session_t *s) {
    session_source_t *src = &s->plot.source[s->plot.next];
    if (src->solid) {
        int err = obj_reader_finish(&s->plot.obj, &s->plot.mesh[s->plot.next]);
        if (err) return plot_data_failed(s, src, err);
        s->plot.mesh[s->plot.next].smooth_q30 = src->smooth_q30;
        s->plot.mesh[s->plot.next].clear = src->clear;
#if CONFIG_AREA
        const obj_reader_t *obj = &s->plot.obj;
        if (obj->clear && !obj->clear_any) {
            s->plot.mesh[s->plot.next].clear = false;
            session_warn(s, "no face in the data belongs to ", obj->clear, strlen(obj->clear), "");
        }
#endif
        s->plot.next++;
        return 0;
    }
    int n = data_reader_finish(&s->plot.reader);
    s->lang.column = NULL;
    if (s->plot.data_error && (n >= 0 || n == ERR_EMPTY)) {
        if (s->error.column == 0) s->error.column = src->column;
        return s->plot.data_error;
    }
    if (n < 0) return plot_data_failed(s, src, n);
    src->grids = n;
    s->plot.grids += n;
#if CONFIG_PARAMETRIC
    int err = s->plot.reader.in_isolines ? finish_isolines(s, src) : 0;
    if (err) return err;
#endif
    s->plot.next++;
    return 0;
}

static int read_all(session_t *s, session_source_t *src, int handle) {
    session_chunk_t *c = &s->frame_chunk[0];
    const session_port_t *port = s->port;
    int err = plot_data_start(s, src, false, 0);
    bool stopped;
#if CONFIG_BINARY
    data_binary_t *b = &s->plot.binary;
    if (src->binary) {
        if (!err) data_binary_start(b, &src->layout, &s->plot.reader);
        for (int n; !err && !data_binary_is_complete(b) &&
                    (n = port->read(port->ctx, handle, c->bytes, CONFIG_READ_CHUNK)) != 0;)
            err = n < 0 ? n : data_binary_feed(b, c->bytes, (size_t)n);
        if (!err) err = data_binary_finish(b);
        return err ? plot_data_failed(s, src, err) : plot_data_done(s);
    }
#endif
    for (int n; !err && (n = port->read(port->ctx, handle, c->bytes, CONFIG_READ_CHUNK)) != 0;)
        err = n < 0 ? plot_data_failed(s, src, n) : plot_data_feed(s, c->bytes, (size_t)n, &stopped);
    return err ? err : plot_data_done(s);
}

int plot_data_read(session_t *s, session_source_t *src) {
    char *name = s->frame_name[0];
#if CONFIG_SAMPLED
    if (src->sampled) return plot_sampled_read(s, src);
#endif
#if CONFIG_LOAD_DEPTH
    if (src->name.tok.kind == '$') {
        lexer_t lx = src->name;
        block_name(s, &lx, name, CONFIG_NAME_MAX + 1);
    } else
#endif
        if (src->name.tok.kind == TOKEN_STRING)
        lexer_string(&src->name, name, CONFIG_NAME_MAX + 1);
#if CONFIG_CONTROL
    if (src->file_name) memcpy(name, src->file_name, strlen(src->file_name) + 1);
#endif
#if CONFIG_BINARY
    int handle = (src->binary ? s->port->open_binary : s->port->open)(s->port->ctx, name);
#else
    int handle = s->port->open(s->port->ctx, name);
#endif
    if (handle < 0)
        return lang_error_set_name(&s->error, handle, src->column, "cannot read the data file", name, strlen(name));
    int err = read_all(s, src, handle);
    s->port->close(s->port->ctx, handle);
    return err;
}
