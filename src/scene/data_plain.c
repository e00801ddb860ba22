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

/* What using says of x, y and z, or 0: a point's x and y are implied. False: more than columns and expressions of them.
 */
static bool direct_parts(const data_reader_t *r, int32_t c[3]) {
    const data_spec_t *s = r->spec;
    if (!is_direct(r) || (r->parts != 1 && r->parts != 3)) return false;
    c[0] = c[1] = 0;
    for (int k = 3 - r->parts; k < 3; k++) {
        c[k] = s->parts ? s->part[k - 3 + r->parts] : k - 2 + r->parts;
        if (c[k] < 1 || (c[k] == USING_EXPR && !s->known)) return false;
    }
    return true;
}

static void counted(data_reader_t *r) {
    r->point++;
    r->kept_point++;
    r->set_points++;
}

static packed_t computed(data_reader_t *r, int32_t part) {
    if (r->spec->looks[part] & 1) r->column[0] = num_from_i64(r->set_points);
    return packed_from_num(r->spec->compute(r->spec->ctx, part));
}

/* What was computed from a column last: along a row of a grid one of x and y stays. */
typedef struct last {
    decimal_t from;
    packed_t value;
    bool known;
} last_t;

static packed_t computed_of(data_reader_t *r, int32_t part, const decimal_t *v, int32_t n, last_t *last) {
    const uint64_t looks = r->spec->looks[part];
    const decimal_t *one = NULL;
    for (uint64_t rest = looks & ~(uint64_t)1; rest; rest &= rest - 1) {
        const int32_t column = __builtin_ctzll(rest);
        if (column > n) continue;
        one = &v[column - 1];
        r->column[column] = decimal_num(*one);
    }
    if (!one || looks & (looks - 1)) return computed(r, part);
    const decimal_t d = last->from;
    if (!last->known || one->mantissa != d.mantissa || one->exp10 != d.exp10 || one->negative != d.negative)
        *last = (last_t){*one, computed(r, part), true};
    return last->value;
}

static bool direct(data_reader_t *r, const int32_t c[3], const decimal_t *v, int32_t n, last_t last[3]) {
    packed_t p[3];
    r->field.count = n;
    for (int k = 0; k < 3; k++) {
        if (c[k] == 0) {
            const int32_t place = k == 0 ? r->kept_point : r->kept_block;
            p[k] = decimal_packed((decimal_t){(uint64_t)place, 0, false});
        } else if (c[k] == USING_EXPR) {
            p[k] = computed_of(r, k - 3 + r->parts, v, n, &last[k]);
        } else {
            if (c[k] > n) return false;
            p[k] = decimal_packed(v[c[k] - 1]);
        }
    }
    if (!data_grid_usual(&r->grid[r->grids - 1], p[0], p[1], p[2])) return false;
    counted(r);
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
    last_t last[3] = {0};
    int32_t c[3], n, enough = enough_columns(r);
    bool straight = direct_parts(r, c) && data_set_is_wanted(r);
    for (const char *next; (next = line(*p, text, f->separator, enough, v, &n)) != NULL; *p = next, f->lines++) {
        r->blanks = 0;
        if (straight && direct(r, c, v, n, last)) continue;
        f->line = f->lines + 1;
        int err = indirect(r, v, n);
        if (err) return err;
        straight = direct_parts(r, c) && data_set_is_wanted(r);
        enough = enough_columns(r);
    }
    f->count = 0;
    return 0;
}

/* Does part k follow from this column alone? */
static bool follows(const data_spec_t *s, int k, int32_t column) {
    return s->part[k] == column || (s->part[k] == USING_EXPR && s->known && !(s->looks[k] & ~((uint64_t)1 << column)));
}

/* Are the places of a matrix those of its columns and rows, whatever using makes of them? */
static bool is_direct_matrix(const data_reader_t *r) {
    const data_spec_t *s = r->spec;
    if (!is_direct(r) || !data_set_is_wanted(r)) return false;
    if (!s->parts) return true;
    const int last = s->parts - 1;
    if (s->part[last] != 3 && (s->part[last] != USING_EXPR || !s->known)) return false;
    if (last == 0) return true;
    return last == 2 && ((follows(s, 0, 1) && follows(s, 1, 2)) || (follows(s, 0, 2) && follows(s, 1, 1)));
}

/* The field is a height of a row whose place is known. */
static bool direct_cell(data_reader_t *r) {
    const field_t *f = &r->field;
    const data_spec_t *s = r->spec;
    const bool uniform = s->format == DATA_MATRIX;
    data_grid_t *g = &r->grid[r->grids - 1];
    const int32_t at = f->count - (uniform ? 1 : 2);
    if (at < 1 || at != g->at || at >= g->inner_n || (!uniform && at >= r->axis_n)) return false;
    data_pool_t *pool = g->pool;
    if (pool->low >= pool->high) return false;
    const decimal_t d = {f->mantissa, f->exp10, f->negative};
    packed_t z;
    if (s->parts && s->part[s->parts - 1] == USING_EXPR) {
        r->column[1] = uniform ? num_from_i64(at) : packed_num(r->axis[-1 - at]);
        r->column[2] = uniform ? num_from_i64(r->block) : r->row_y;
        r->column[3] = decimal_num(d);
        z = computed(r, s->parts - 1);
    } else {
        z = decimal_packed(d);
    }
    pool->base[pool->low++] = z;
    g->at++;
    counted(r);
    return true;
}

static int cells(data_reader_t *r, const char **p, data_text_t text) {
    bool straight = is_direct_matrix(r);
    while (field_plain(&r->field, p, text.end, text.limit)) {
        if (straight && direct_cell(r)) continue;
        int err = data_cell(r);
        if (err) return err;
        straight = is_direct_matrix(r);
    }
    return 0;
}

int data_plain(data_reader_t *r, const char **p, data_text_t text) {
    return r->spec->format == DATA_ROWS ? rows(r, p, text) : cells(r, p, text);
}
#endif
