/* data_binary.c - see data_binary.h. */
#include "scene/data_binary.h"
#include "error.h"
#include <string.h>

#if CONFIG_BINARY
static const binary_field_t FLOAT = {4, BINARY_FLOAT, false};

void binary_spec_default(binary_spec_t *spec) {
    *spec = (binary_spec_t){.n = {-1, -1}};
    for (int k = 0; k < 3; k++) spec->first[k] = num_from_i64(0);
    spec->step[0] = spec->step[1] = num_from_i64(1);
    spec->big_endian = __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__;
}

void data_binary_start(data_binary_t *b, const binary_spec_t *spec, data_reader_t *reader) {
    *b = (data_binary_t){.spec = spec, .reader = reader, .skip = spec->skip};
    if (spec->layout == BINARY_ARRAY) reader->implied = b->implied;
}

static int refuse(const data_binary_t *b, enum data_grid_trouble why) {
    b->reader->trouble = why;
    b->reader->line = b->reader->at = 0;
    return why == DATA_FULL ? ERR_FULL : ERR_DATA;
}

static num_t from_float(uint32_t w) {
    const uint32_t exponent = w >> 23 & 0xff, fraction = w & 0x7fffff;
    if (exponent == 0xff) return num_undef();
    const int64_t m = (int64_t)(exponent ? fraction | 0x800000 : fraction);
    return num_from_fixed(w >> 31 ? -m : m, 150 - (int)(exponent ? exponent : 1));
}

static num_t number(const binary_field_t *f, bool big_endian, const uint8_t *p) {
    uint64_t w = 0;
    for (int k = 0; k < f->bytes; k++) w = w << 8 | p[big_endian ? k : f->bytes - 1 - k];
    if (f->kind == BINARY_FLOAT) return f->bytes == 4 ? from_float((uint32_t)w) : packed_num(w);
    if (f->kind == BINARY_SIGNED) {
        const int unused = 64 - 8 * f->bytes;
        return num_from_i64((int64_t)(w << unused) >> unused);
    }
    return w >> 63 ? num_from_wide((wide_t){0, w}, 0) : num_from_i64((int64_t)w);
}

/* A number of a matrix. */
static int cell(data_binary_t *b, num_t v) {
    data_reader_t *r = b->reader;
    if (b->columns == 0) { /* the first */
        bool ok = true;
        const int64_t n = num_to_fixed(v, 0, &ok);
        if (!ok || n < 1 || n >= INT32_MAX || !num_is_integer(v)) return refuse(b, DATA_BINARY_COUNT);
        b->columns = (int32_t)n;
        b->axis = r->pool->base + r->pool->high;
        b->at = 1;
        return 0;
    }
    int err = 0;
    if (b->row == 0) {
        if (r->pool->low >= r->pool->high) return refuse(b, DATA_FULL);
        r->pool->base[--r->pool->high] = packed_from_num(v);
    } else if (b->at == 0) {
        b->value[1] = v;
    } else {
        b->value[0] = packed_num(b->axis[-b->at]);
        b->value[2] = v;
        err = data_reader_row(r, b->value, 3);
    }
    if (err || b->at++ < b->columns) return err;
    b->at = 0;
    return b->row++ ? data_reader_break(r) : 0;
}

/* Where point `at` of row `row` of an array is. */
static void imply(data_binary_t *b) {
    const binary_spec_t *s = b->spec;
    for (int k = 0; k < 2; k++) {
        const bool along = (k == 0) != s->transposed;
        const int32_t i = along ? b->at : b->row, n = s->n[along ? 0 : 1];
        b->implied[k] = num_add(s->first[k], num_mul(s->step[k], num_from_i64(s->down[k] ? n - 1 - i : i)));
    }
    b->implied[2] = s->first[2];
}

/* A field of a point. */
static int field(data_binary_t *b, num_t v) {
    const binary_spec_t *s = b->spec;
    if (!s->field[b->field].dropped) b->value[b->columns++] = v;
    if (++b->field < s->fields) return 0;
    if (s->layout == BINARY_ARRAY) imply(b);
    int err = data_reader_row(b->reader, b->value, b->columns);
    b->field = b->columns = 0;
    if (err || ++b->at != s->n[0]) return err;
    b->at = 0;
    b->row++;
    return data_reader_break(b->reader);
}

bool data_binary_is_complete(const data_binary_t *b) {
    const binary_spec_t *s = b->spec;
    return s->layout != BINARY_MATRIX && s->n[1] >= 0 && b->row >= s->n[1];
}

int data_binary_feed(data_binary_t *b, const char *bytes, size_t n) {
    const binary_spec_t *s = b->spec;
    const uint8_t *p = (const uint8_t *)bytes, *end = p + n;
    if ((size_t)b->skip >= n) {
        b->skip -= (int32_t)n;
        return 0;
    }
    p += b->skip;
    b->skip = 0;
    while (p < end && !data_binary_is_complete(b)) {
        const binary_field_t *f = s->layout == BINARY_MATRIX ? &FLOAT : &s->field[b->field];
        const uint8_t *at = p;
        if (b->part_n || end - p < f->bytes) { /* a number that is cut */
            while (p < end && b->part_n < f->bytes) b->part[b->part_n++] = *p++;
            if (b->part_n < f->bytes) return 0;
            at = b->part;
            b->part_n = 0;
        } else {
            p += f->bytes;
        }
        const num_t v = number(f, s->big_endian, at);
        int err = s->layout == BINARY_MATRIX ? cell(b, v) : field(b, v);
        if (err) return err;
    }
    return 0;
}

int data_binary_finish(data_binary_t *b) {
    const binary_spec_t *s = b->spec;
    if (b->part_n || b->field) return refuse(b, DATA_BINARY_SHORT);
    if (s->layout == BINARY_MATRIX) return b->row == 0 || b->at ? refuse(b, DATA_BINARY_SHORT) : 0;
    if (data_binary_is_complete(b)) return 0;
    return s->n[1] >= 0 || (s->n[0] >= 0 && b->at) ? refuse(b, DATA_BINARY_SHORT) : 0;
}
#endif
