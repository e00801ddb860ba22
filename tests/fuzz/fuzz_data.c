/* fuzz_data.c - the data reader alone: any bytes, cut anywhere, in every format; and that it does not matter where. */
#include <stdlib.h>
#include <string.h>

#include "error.h"
#include "scene/data_binary.h"
#include "scene/data_reader.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { POOL = 512, GRIDS = 3 };

static num_t compute(void *ctx, int32_t part) {
    const data_reader_t *r = ctx;
    return num_mul(r->column[1 + part], r->column[CONFIG_DATA_COLUMNS]);
}

static packed_t memory[POOL];
static data_grid_t grid[GRIDS];
static data_reader_t reader;
static data_curve_t curve;
static data_pool_t pool;

/* All of it, in pieces. Where there is no error the end is left to the caller. */
static int feed(const data_spec_t *spec, bool inline_data, size_t room, const uint8_t *data, size_t size,
                size_t chunk) {
    pool = (data_pool_t){memory, 0, room};
    memset(memory, 0, sizeof memory);
    data_reader_start(&reader, spec, &pool, grid, &curve, GRIDS, inline_data, 0);
    int err = 0;
    for (size_t at = 0; !err && at < size; at += chunk)
        err = data_reader_feed(&reader, (const char *)data + at, size - at < chunk ? size - at : chunk);
    return err;
}

/* One character at a time nothing is read as a whole. */
static int feed_both(const data_spec_t *spec, bool inline_data, size_t room, const uint8_t *data, size_t size,
                     size_t chunk) {
    static packed_t words[POOL];
    const int slow = feed(spec, inline_data, room, data, size, 1);
    const data_pool_t end = pool;
    const int32_t line = reader.line, at = reader.at;
    const enum data_grid_trouble trouble = reader.trouble;
    memcpy(words, memory, sizeof words);
    const int err = feed(spec, inline_data, room, data, size, chunk);
    if (err != slow || pool.low != end.low || pool.high != end.high || memcmp(words, memory, sizeof words) != 0)
        abort();
    if (reader.trouble != trouble || reader.line != line || reader.at != at) abort();
    return err;
}

/* Binary data, whole and byte by byte. */
static int binary(const uint8_t *data, size_t size) {
    static packed_t words[POOL];
    static data_binary_t b;
    static const uint8_t bytes[] = {1, 2, 4, 8};
    data_spec_t spec;
    binary_spec_t layout;
    data_spec_default(&spec);
    binary_spec_default(&layout);
    layout.layout = (enum binary_layout)(data[0] % 3);
    if (layout.layout == BINARY_ARRAY) spec.parts = spec.part[0] = 1, spec.wanted = 2;
    layout.n[0] = data[0] & 64 ? -1 : data[1] % 8 + 1;
    layout.n[1] = data[0] & 64 || data[0] & 128 ? -1 : data[1] / 8 % 8;
    layout.big_endian = data[0] & 4;
    layout.skip = data[2] & 3;
    layout.fields = layout.layout == BINARY_ARRAY ? 1 + (data[2] >> 6) : 3;
    for (int k = 0; k < layout.fields; k++) {
        binary_field_t *f = &layout.field[k];
        f->kind = (uint8_t)(data[2] % 3);
        f->bytes = bytes[data[2] / 4 % 4];
        if (f->kind == BINARY_FLOAT && f->bytes < 4) f->bytes = 4;
    }
    int err[2];
    for (int way = 0; way < 2; way++) {
        const size_t chunk = way ? 1 : size;
        pool = (data_pool_t){memory, 0, data[0] & 8 ? POOL : 16};
        memset(memory, 0, sizeof memory);
        data_reader_start(&reader, &spec, &pool, grid, &curve, GRIDS, false, 0);
        data_binary_start(&b, &layout, &reader);
        err[way] = 0;
        for (size_t at = 3; !err[way] && at < size; at += chunk)
            err[way] = data_binary_feed(&b, (const char *)data + at, size - at < chunk ? size - at : chunk);
        if (!err[way]) err[way] = data_binary_finish(&b);
        if (!err[way]) err[way] = data_reader_finish(&reader);
        if (err[way] < 0 && err[way] != ERR_EMPTY && reader.trouble == DATA_OK) abort();
        if (way == 0) memcpy(words, memory, sizeof words);
    }
    if (err[0] != err[1] || memcmp(words, memory, sizeof words) != 0) abort();
    return 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    if (size < 4) return 0;
    if (size > 8 && data[3] == 255 && data[2] == 255) return binary(data + 4, size - 4);
    const size_t room = data[0] & 1 ? POOL : 16;
    data_spec_t spec;
    data_spec_default(&spec);
    spec.format = (enum data_format)(data[0] / 2 % 3);
    spec.separator = data[0] & 8 ? ";.e5"[data[2] >> 6] : '\0';
    if (data[0] & 16) {
        spec.parts = data[1] & 1 ? 1 : data[0] & 128 ? 2 : 3;
        for (int k = 0; k < 3; k++) {
            spec.part[k] = (data[1] >> (2 * k + 1) & 3) + k - 2;
            if (spec.part[k] > 0) spec.wanted |= (uint64_t)1 << spec.part[k];
        }
        if (data[1] & 128) {
            spec.part[spec.parts - 1] = USING_EXPR;
            spec.all = true;
        }
        spec.compute = compute;
        spec.ctx = &reader;
    }
    if (data[0] & 32) {
        spec.first_set = data[2] & 1;
        spec.last_set = data[2] >> 1 & 3;
        spec.point_step = 1 + (data[2] >> 3 & 1);
        spec.block_step = 1 + (data[2] >> 4 & 1);
        spec.first_point = data[2] >> 5 & 1;
    }
    spec.flat = data[0] & 128 && spec.format == DATA_ROWS && spec.parts < 3;
    const size_t chunk = data[3] & 128 ? 1 + (size_t)data[3] % 32 : 40 + 40 * (size_t)data[3];
    const int err = feed_both(&spec, data[0] & 64, room, data + 4, size - 4, chunk);
    if (err) {
        if (reader.trouble == DATA_OK || !data_grid_text(reader.trouble) || reader.line < 1) abort();
        return 0;
    }
    int n = data_reader_finish(&reader);
    if (spec.flat && n > 0) {
        curve_t c;
        num_t extent[2];
        data_curve_get(&curve, &c, extent);
        if (c.n < 2) abort();
        for (int32_t i = 0; i < c.n; i++) {
            num_t x = c.x_of(c.ctx, i);
            if (num_cmp(x, extent[0]) < 0 || num_cmp(x, extent[1]) > 0) abort();
            c.y_of(c.ctx, i);
        }
        return 0;
    }
    for (int k = 0; k < n; k++) {
        data_view_t v;
        surface_t s;
        if (data_grid_surface(&grid[k], NULL, NULL, &v, &s)) abort();
        if (s.nx < 2 || s.ny < 2) abort();
        for (int32_t i = 1; i < s.nx; i++)
            if (num_cmp(s.x_of(s.ctx, i - 1), s.x_of(s.ctx, i)) >= 0) abort();
        for (int32_t j = 1; j < s.ny; j++)
            if (num_cmp(s.y_of(s.ctx, j - 1), s.y_of(s.ctx, j)) >= 0) abort();
        for (int32_t j = 0; j < s.ny; j++)
            for (int32_t i = 0; i < s.nx; i++) s.z_of(s.ctx, i, j);
        num_t lim[2] = {s.x_of(s.ctx, 0), s.x_of(s.ctx, 1)};
        if (data_grid_surface(&grid[k], lim, NULL, &v, &s) || s.nx != 2) abort();
    }
    return 0;
}
