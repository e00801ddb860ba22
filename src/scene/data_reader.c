/* data_reader.c - what rows, blank lines and matrices mean; the characters are field.c's, the grid data_grid.c's. */
#include "scene/data_reader.h"
#include "error.h"
#include "scene/data_place.h"
#include "scene/data_plain.h"
#include "scene/decimal_scan.h"

void data_spec_default(data_spec_t *spec) {
    *spec = (data_spec_t){.set_step = 1, .last_set = INT32_MAX};
    spec->point_step = spec->block_step = 1;
    spec->last_point = spec->last_block = INT32_MAX;
}

void data_reader_start(data_reader_t *r, const data_spec_t *spec, data_pool_t *pool, data_grid_t *grid,
                       data_curve_t *curve, int32_t grids_max, bool stop_at_e, int32_t first_line) {
    *r = (data_reader_t){.spec = spec,
                         .pool = pool,
                         .grid = grid,
                         .curve = curve,
                         .grids_max = grids_max,
                         .parts = spec->parts,
                         .skip = spec->skip};
    field_start(&r->field, spec->separator, stop_at_e, first_line);
#if CONFIG_SCATTERED
    scattered_start(&r->scattered, pool);
#endif
}

static int refuse(data_reader_t *r, enum data_grid_trouble why, int32_t at) {
    r->trouble = why;
    r->line = r->field.line;
    r->at = at;
    return why == DATA_FULL || why == DATA_SETS ? ERR_FULL : ERR_DATA;
}

static int refused(data_reader_t *r, int err, int32_t at) {
    if (err) refuse(r, r->trouble, at);
    return err;
}

bool data_set_is_wanted(const data_reader_t *r) {
    const data_spec_t *s = r->spec;
    return r->set >= s->first_set && r->set <= s->last_set && (r->set - s->first_set) % s->set_step == 0;
}

static bool chosen(int32_t n, int32_t first, int32_t last, int32_t step) {
    return n >= first && n <= last && (n - first) % step == 0;
}

/* What a grid, or isolines, get: the next point, the end of a block, the end of the set. */
enum step { STEP_POINT, STEP_BREAK, STEP_FINISH };

static int to_grid(data_reader_t *r, enum step step, const num_t p[3]) {
    data_grid_t *g = &r->grid[r->grids - 1];
    if (step == STEP_POINT) return data_grid_point(g, p[0], p[1], p[2], &r->trouble);
    return step == STEP_BREAK ? data_grid_break(g, &r->trouble) : data_grid_finish(g, &r->trouble);
}

#if CONFIG_PARAMETRIC
static int to_isolines(data_reader_t *r, enum step step, const num_t p[3]) {
    isolines_t *s = r->isolines;
    int err = step == STEP_POINT   ? isolines_point(s, p[0], p[1], p[2])
              : step == STEP_BREAK ? isolines_break(s)
                                   : isolines_end_set(s, true);
    return err ? refuse(r, DATA_FULL, 0) : 0;
}

static bool may_be_isolines(const data_reader_t *r) {
    return r->isolines && r->spec->format == DATA_ROWS && !r->spec->flat;
}

/* The grid that is none, and what is to come, are isolines. */
static int adopt(data_reader_t *r) {
    r->in_isolines = true;
    if (r->grid[r->grids - 1].outer_n > 0) r->left_grid_at = r->field.line;
    return isolines_adopt(r->isolines, &r->grid[--r->grids]) ? refuse(r, DATA_FULL, 0) : 0;
}

static int take(data_reader_t *r, enum step step, const num_t p[3]) {
    int err = r->in_isolines ? 0 : to_grid(r, step, p);
    if (err == ERR_DATA && may_be_isolines(r)) err = adopt(r);
    return r->in_isolines && !err ? to_isolines(r, step, p) : refused(r, err, 0);
}
#else
static int take(data_reader_t *r, enum step step, const num_t p[3]) {
    return refused(r, to_grid(r, step, p), 0);
}
#endif

/* The first point of a data set opens its grid; a curve goes on through all sets. */
static int open_set(data_reader_t *r) {
    if (r->set_open || data_is_scattered(r)) return 0;
    if (r->spec->flat && r->grids) {
        r->set_open = true;
        return 0;
    }
#if CONFIG_PARAMETRIC
    if (r->grids == r->grids_max && !r->in_isolines && may_be_isolines(r)) {
        isolines_start(r->isolines, r->pool);
        r->in_isolines = true;
    }
    if (r->in_isolines) {
        r->set_open = true;
        return 0;
    }
#endif
    if (r->grids == r->grids_max) return refuse(r, DATA_SETS, 0);
    if (r->spec->flat)
        data_curve_start(r->curve, r->pool);
    else
        data_grid_start(&r->grid[r->grids], r->pool);
    r->grids++;
    r->set_open = true;
    return 0;
}

static int close_set(data_reader_t *r) {
    if (!r->set_open) return 0;
    r->set_open = false;
    if (r->spec->flat) return 0;
    return take(r, STEP_FINISH, NULL);
}

static int end_block(data_reader_t *r) {
    if (r->point == 0) return 0;
    if (r->kept_point > 0) r->kept_block++;
    r->block++;
    r->point = r->kept_point = 0;
    if (!r->set_open) return 0;
    if (r->spec->flat) return data_curve_gap(r->curve) ? refuse(r, DATA_FULL, 0) : 0;
    return take(r, STEP_BREAK, NULL);
}

static int end_set(data_reader_t *r) {
    r->set++;
    r->block = r->kept_block = r->set_points = 0;
    r->row_known = false;
    r->axis_n = 0;
    return close_set(r);
}

static num_t part_value(data_reader_t *r, int32_t k) {
    if (!r->spec->parts) return r->column[k + 1];
    int32_t c = r->spec->part[k];
    if (c == USING_EXPR) return r->spec->compute(r->spec->ctx, k);
    if (c == USING_BLOCK) return num_from_i64(r->kept_block);
    if (c == USING_SET) return num_from_i64(r->set);
    return r->column[c];
}

/* x (0) or y (1) of a point that has none of its own. */
static num_t implied(const data_reader_t *r, int axis) {
#if CONFIG_BINARY
    if (r->implied) return r->implied[axis];
#endif
    return num_from_i64(axis ? r->kept_block : r->kept_point);
}

/* One point of the wanted set: its columns are in place. */
static int point(data_reader_t *r) {
    const data_spec_t *s = r->spec;
    bool keep = chosen(r->point, s->first_point, s->last_point, s->point_step) &&
                chosen(r->block, s->first_block, s->last_block, s->block_step);
    r->point++;
    if (!keep) return 0;
    int err = open_set(r);
    if (err) return err;
    r->column[0] = num_from_i64(r->set_points++);
    num_t x, y, z;
    if (r->spec->flat) {
        x = r->parts == 1 ? implied(r, 0) : part_value(r, 0);
        y = part_value(r, r->parts - 1);
        r->kept_point++;
        num_t p[3] = {x, y, y};
        data_place(s, p);
        return data_curve_point(r->curve, p[0], p[1]) ? refuse(r, DATA_FULL, 0) : 0;
    }
    if (r->parts == 1) {
        x = implied(r, 0);
        y = implied(r, 1);
        z = part_value(r, 0);
#if CONFIG_BINARY
        if (r->implied) z = num_add(z, r->implied[2]);
#endif
    } else {
        x = part_value(r, 0);
        y = part_value(r, 1);
        if (CONFIG_SAMPLED && r->parts == 2) /* on a sphere or cylinder of radius 1 */
            z = num_from_i64(1);
        else
            z = part_value(r, 2);
    }
    r->kept_point++;
    num_t p[3] = {x, y, z};
    data_place(s, p);
#if CONFIG_SCATTERED
    if (s->scattered) return scattered_point(&r->scattered, p) ? refuse(r, DATA_FULL, 0) : 0;
#endif
    return take(r, STEP_POINT, p);
}

static uint64_t wanted_columns(const data_reader_t *r) {
    if (r->spec->parts) return r->spec->wanted;
    return (2u << r->parts) - 2; /* columns 1 to parts */
}

int data_row(data_reader_t *r) {
    const data_spec_t *s = r->spec;
    if (!data_set_is_wanted(r)) {
        r->point++;
        return 0;
    }
    if (!r->parts) {
        const bool two = r->field.count == 2 && !s->flat;
        if (two && !data_is_mapped(s)) return refuse(r, DATA_TWO_COLUMNS, 0);
        r->parts = r->field.count == 1 ? 1 : two || s->flat ? 2 : 3;
    }
    uint64_t wanted = wanted_columns(r);
    for (int32_t c = 1; c <= CONFIG_DATA_COLUMNS; c++) {
        if (!(wanted >> c & 1)) continue;
        if (c > r->field.count) return refuse(r, DATA_SHORT, 0);
        if (r->is_text >> c & 1) {
            bool heading = !r->row_known && (r->is_text & wanted) == wanted;
            r->row_known = true;
            return heading ? 0 : refuse(r, DATA_TEXT, r->column_at[c]);
        }
    }
    r->row_known = true;
    return point(r);
}

static int end_row(data_reader_t *r) {
    if (r->field.count == 0) {
        r->blanks++;
        if (r->blanks == 1 && r->spec->format == DATA_ROWS) return end_block(r);
        return r->blanks == 2 && (r->row_known || r->block > 0) ? end_set(r) : 0;
    }
    r->blanks = 0;
    if (r->spec->format == DATA_ROWS) {
        int err = data_row(r);
        r->is_text = 0;
        return err;
    }
    bool was_axis = r->spec->format == DATA_NONUNIFORM && !r->row_known;
    r->row_known = true;
    return was_axis ? 0 : end_block(r);
}

int data_cell(data_reader_t *r) {
    const field_t *f = &r->field;
    if (!data_set_is_wanted(r)) return 0;
    if (f->kind == FIELD_TEXT) return refuse(r, DATA_TEXT, f->column);
    int32_t column = f->count - 1;
    if (r->spec->format == DATA_NONUNIFORM) {
        if (!r->row_known) {
            if (column == 0) return 0; /* the number of columns, or nothing */
            if (r->pool->low >= r->pool->high) return refuse(r, DATA_FULL, f->column);
            if (column == 1) r->axis = r->pool->base + r->pool->high;
            r->pool->base[--r->pool->high] = packed_from_num(field_num(f));
            r->axis_n++;
            return 0;
        }
        if (column == 0) {
            r->row_y = field_num(f);
            return 0;
        }
        if (column > r->axis_n) return refuse(r, DATA_RAGGED, f->column);
        r->column[1] = packed_num(r->axis[-column]);
        r->column[2] = r->row_y;
    } else {
        r->column[1] = num_from_i64(column);
        r->column[2] = num_from_i64(r->block);
    }
    r->column[3] = field_num(f);
    if (!r->spec->parts) r->parts = 3;
    return point(r);
}

static int value(data_reader_t *r) {
    const field_t *f = &r->field;
    if (r->spec->format != DATA_ROWS) return data_cell(r);
    if (f->count > CONFIG_DATA_COLUMNS) return 0;
    uint64_t bit = (uint64_t)1 << f->count;
    r->column_at[f->count] = f->column;
    if (f->kind == FIELD_TEXT) r->is_text |= bit;
    /* Columns nobody asked for are not converted; without `using` the first row decides what is asked for. */
    if (r->spec->parts ? r->spec->all || (r->spec->wanted & bit) != 0 : f->count <= 3)
        r->column[f->count] = field_num(f);
    return 0;
}

static int happen(data_reader_t *r, enum field_event event) {
    if (event == FIELD_VALUE) return value(r);
    if (event == FIELD_LINE) return end_row(r);
    r->stopped = true;
    return 0;
}

static int feed(data_reader_t *r, const char *p, data_text_t text) {
    while (r->skip > 0 && p < text.end)
        if (*p++ == '\n') {
            r->skip--;
            r->field.lines++;
        }
#if CONFIG_64BIT
    const bool plain = !decimal_has(r->field.separator); /* else one could be taken for a part of a number */
#endif
    while (!r->stopped) {
#if CONFIG_64BIT
        int failed = plain ? data_plain(r, &p, text) : 0;
        if (failed) return failed;
#endif
        enum field_event event = field_next(&r->field, &p, text.end);
        if (event == FIELD_MORE) break;
        int err = happen(r, event);
        if (err) return err;
    }
    return 0;
}

int data_reader_feed(data_reader_t *r, const char *text, size_t n) {
#if CONFIG_64BIT
    /* A line or two: to where the characters behind them can be read. */
    char copy[256];
    if (n <= sizeof copy - DECIMAL_SCAN_MARGIN) {
        memcpy(copy, text, n);
        memset(copy + n, '\n', DECIMAL_SCAN_MARGIN);
        return feed(r, copy, (data_text_t){copy + n, copy + n + DECIMAL_SCAN_MARGIN});
    }
#endif
    return feed(r, text, (data_text_t){text + n, text + n});
}

#if CONFIG_SAMPLED
int data_reader_row(data_reader_t *r, const num_t *v, int32_t n) {
    for (int32_t c = 1; c <= n; c++) r->column[c] = v[c - 1];
    r->field.count = n;
    return data_row(r);
}

int data_reader_break(data_reader_t *r) {
    return end_block(r);
}
#endif

int data_reader_finish(data_reader_t *r) {
    while (!r->stopped) {
        enum field_event event = field_finish(&r->field);
        if (event == FIELD_MORE) break;
        int err = happen(r, event);
        if (err) return err;
    }
    int err = end_block(r);
    if (!err) err = close_set(r);
    if (err) return err;
#if CONFIG_SCATTERED
    if (data_is_scattered(r)) {
        if (r->grids == r->grids_max) return refuse(r, DATA_SETS, 0);
        err = scattered_grid(&r->scattered, r->spec->scattered, &r->grid[r->grids]);
        r->grids += !err;
        if (err == ERR_FULL) return refuse(r, DATA_FULL, 0);
        return err ? err : 1;
    }
#endif
    if (r->spec->flat && r->grids) err = data_curve_finish(r->curve);
    if (err == ERR_FULL) return refuse(r, DATA_FULL, 0);
    if (err) return err;
#if CONFIG_PARAMETRIC
    if (r->in_isolines) return r->grids;
#endif
    return r->grids ? r->grids : ERR_EMPTY;
}
