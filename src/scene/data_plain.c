/* data_plain.c - see data_plain.h. */
#include "scene/data_plain.h"
#include "scene/data_place.h"
#include "scene/decimal_scan.h"

#if CONFIG_64BIT
/* Is a point what its columns say, and every one is taken? */
static bool is_direct(const data_reader_t *r) {
    const data_spec_t *s = r->spec;
    if (!r->set_open || s->flat || !r->grids || data_is_scattered(r) || data_is_placed(s)) return false;
#if CONFIG_PARAMETRIC
    if (r->in_isolines) return false;
#endif
    return s->point_step == 1 && s->block_step == 1 && s->first_point == 0 && s->first_block == 0 &&
           s->last_point == INT32_MAX && s->last_block == INT32_MAX;
}

/* The columns of x, y and z; 0: a point's x and y are implied. False: they are no columns. */
static bool direct_columns(const data_reader_t *r, int32_t c[3]) {
    const data_spec_t *s = r->spec;
    if (!is_direct(r) || (r->parts != 1 && r->parts != 3)) return false;
    c[0] = c[1] = 0;
    for (int k = 3 - r->parts; k < 3; k++) {
        c[k] = s->parts ? s->part[k - 3 + r->parts] : k - 2 + r->parts;
        if (c[k] < 1 || c[k] == USING_EXPR) return false;
    }
    return true;
}

static bool direct(data_reader_t *r, const int32_t c[3], const decimal_t *v, int32_t n) {
    packed_t p[3];
    if (c[2] > n) return false;
    p[2] = decimal_packed(v[c[2] - 1]);
    if (c[0]) {
        if (c[0] > n || c[1] > n) return false;
        p[0] = decimal_packed(v[c[0] - 1]);
        p[1] = decimal_packed(v[c[1] - 1]);
    } else {
        p[0] = decimal_packed((decimal_t){(uint64_t)r->kept_point, 0, false});
        p[1] = decimal_packed((decimal_t){(uint64_t)r->kept_block, 0, false});
    }
    if (!data_grid_usual(&r->grid[r->grids - 1], p[0], p[1], p[2])) return false;
    r->point++;
    r->kept_point++;
    r->set_points++;
    return true;
}

static inline const char *blanks(const char *p, const char *end, char separator) {
    while (p < end && (*p == ' ' || *p == '\t') && *p != separator) p++;
    return p;
}

/* The line at p: its numbers, *n of them; what is behind the first `enough` need not be looked at. Returns where the
 * next begins, or NULL. */
static inline const char *line(const char *p, data_text_t text, char separator, int32_t enough, decimal_t *v,
                               int32_t *n) {
    const char comma = separator ? separator : ',';
    for (int32_t count = 0;;) {
        p = blanks(p, text.end, separator);
        if (text.limit - p < DECIMAL_SCAN_MARGIN || count == CONFIG_DATA_COLUMNS) return NULL;
        p = decimal_scan(p, &v[count++]);
        if (!p || p >= text.end) return NULL;
        const bool ended = *p == comma || (!separator && (*p == ' ' || *p == '\t'));
        *n = count;
        if (ended && count == enough) {
            p = memchr(p, '\n', (size_t)(text.end - p));
            return p ? p + 1 : NULL;
        }
        if (*p == comma) {
            p++;
            continue;
        }
        if (!separator) p = blanks(p, text.end, '\0');
        if (p + 1 < text.end && *p == '\r' && p[1] == '\n') p++;
        if (p >= text.end) return NULL;
        if (*p == '\n') return p + 1;
        if (!ended) return NULL;
    }
}

/* The columns that somebody asks for; as data_reader.c does it where fields come one by one. */
static int indirect(data_reader_t *r, const decimal_t *v, int32_t n) {
    const data_spec_t *s = r->spec;
    for (int32_t c = 1; c <= n; c++)
        if (s->parts ? s->all || s->wanted >> c & 1 : c <= 3) r->column[c] = decimal_num(v[c - 1]);
    r->field.count = n;
    return data_row(r);
}

/* How many columns are to be there: all, if expressions ask for them, or if it is not known yet. */
static int32_t enough_columns(const data_reader_t *r) {
    const data_spec_t *s = r->spec;
    if (!s->parts) return r->parts ? r->parts : CONFIG_DATA_COLUMNS;
    return s->all || s->wanted == 0 ? CONFIG_DATA_COLUMNS : 63 - ints_clz64(s->wanted);
}

static int rows(data_reader_t *r, const char **p, data_text_t text) {
    field_t *f = &r->field;
    if (!field_begins_line(f)) return 0;
    decimal_t v[CONFIG_DATA_COLUMNS];
    int32_t c[3], n, enough = enough_columns(r);
    bool straight = direct_columns(r, c) && data_set_is_wanted(r);
    for (const char *next; (next = line(*p, text, f->separator, enough, v, &n)) != NULL; *p = next, f->lines++) {
        r->blanks = 0;
        if (straight && direct(r, c, v, n)) continue;
        f->line = f->lines + 1;
        int err = indirect(r, v, n);
        if (err) return err;
        straight = direct_columns(r, c) && data_set_is_wanted(r);
        enough = enough_columns(r);
    }
    f->count = 0;
    return 0;
}

/* The field is a height of a row whose place is known. */
static bool direct_cell(data_reader_t *r) {
    const field_t *f = &r->field;
    const bool uniform = r->spec->format == DATA_MATRIX;
    data_grid_t *g = &r->grid[r->grids - 1];
    const int32_t at = f->count - (uniform ? 1 : 2);
    if (at < 1 || at != g->at || at >= g->inner_n || !g->inner_is_x || (!uniform && at >= r->axis_n)) return false;
    data_pool_t *pool = g->pool;
    if (pool->low >= pool->high) return false;
    pool->base[pool->low++] = decimal_packed((decimal_t){f->mantissa, f->exp10, f->negative});
    g->at++;
    r->point++;
    r->kept_point++;
    r->set_points++;
    return true;
}

static int cells(data_reader_t *r, const char **p, data_text_t text) {
    bool straight = is_direct(r) && !r->spec->parts && data_set_is_wanted(r);
    while (field_plain(&r->field, p, text.end, text.limit)) {
        if (straight && direct_cell(r)) continue;
        int err = data_cell(r);
        if (err) return err;
        straight = is_direct(r) && !r->spec->parts && data_set_is_wanted(r);
    }
    return 0;
}

int data_plain(data_reader_t *r, const char **p, data_text_t text) {
    return r->spec->format == DATA_ROWS ? rows(r, p, text) : cells(r, p, text);
}
#endif
