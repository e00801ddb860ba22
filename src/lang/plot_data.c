/* plot_data.c - from a file or inline rows of a plot command to grids, curves or a terrain in the session's pool. */
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
    int err = expr_eval(&s->lang, &s->plot.source[s->plot.next].part[part], NULL, &v);
    if (err && !s->plot.data_error) s->plot.data_error = err;
    return value_num(v);
}

void plot_data_start(session_t *s, session_source_t *src, bool inline_data, int32_t first_line) {
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
    if (why == DATA_OK) return plot_fail(s, src, err, err == ERR_EMPTY ? "no data" : error_text(err));
    lang_error_set(&s->error, err, at, data_grid_text(why));
    s->error.line = line;
    return err;
}

int plot_data_failed(session_t *s, const session_source_t *src, int err) {
    const data_reader_t *r = &s->plot.reader;
    s->lang.column = NULL;
    return trouble(s, src, err, r->trouble, r->line, r->at);
}

/* The data of source[next] are complete. */
int plot_data_done(session_t *s) {
    session_source_t *src = &s->plot.source[s->plot.next];
    int n = data_reader_finish(&s->plot.reader);
    if (n < 0) return plot_data_failed(s, src, n);
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
    plot_data_start(s, src, false, 0);
    int err = 0;
    for (int n; !err && (n = port->read(port->ctx, handle, c->bytes, CONFIG_READ_CHUNK)) != 0;)
        err = n < 0 ? n : data_reader_feed(&s->plot.reader, c->bytes, (size_t)n);
    return err ? plot_data_failed(s, src, err) : plot_data_done(s);
}

int plot_data_read(session_t *s, session_source_t *src) {
    char *name = s->frame_name[0];
    lexer_string(&src->name, name, CONFIG_NAME_MAX + 1);
    int handle = s->port->open(s->port->ctx, name);
    if (handle < 0)
        return lang_error_set_name(&s->error, handle, src->column, "cannot read the data file", name, strlen(name));
    int err = src->kind == SOURCE_MESH ? read_mesh(s, src, handle) : read_grids(s, src, handle);
    s->port->close(s->port->ctx, handle);
    return err;
}
