/* obj_reader.c - words of an OBJ file; a line's first word says what the others are. */
#include "scene/obj_reader.h"
#include "error.h"
#include "scene/field.h"
#include <string.h>

_Static_assert(sizeof(packed_t) == 2 * sizeof(int32_t), "a triangle is one and a half units of the pool");

void obj_reader_start(obj_reader_t *r, data_pool_t *pool) {
    *r = (obj_reader_t){.pool = pool, .line = 1};
}

static int refuse(obj_reader_t *r, enum data_grid_trouble why) {
    r->trouble = why;
    r->at = r->token_at;
    return why == DATA_FULL ? ERR_FULL : ERR_DATA;
}

/* Pool units that f triangles take at the upper end. */
static size_t face_units(int32_t f) {
    return ((size_t)f * 3 + 1) / 2;
}

static bool has_room(const obj_reader_t *r, int32_t nv, int32_t nf) {
    return (size_t)nv * 3 + face_units(nf) <= r->pool->high - r->pool->low;
}

static int32_t *face(const obj_reader_t *r, int32_t k) {
    return (int32_t *)(void *)(r->pool->base + r->pool->high) - 3 * ((size_t)k + 1);
}

static int number(obj_reader_t *r) {
    field_t f;
    field_start(&f, '\n', false, 0); /* a separator that cannot occur: the whole word is one field */
    const char *p = r->token;
    field_next(&f, &p, r->token + r->token_len);
    num_t a = field_finish(&f) == FIELD_VALUE ? field_num(&f) : num_undef();
    if (a.undef) return refuse(r, DATA_TEXT);
    r->vertex[r->words - 1] = packed_from_num(a);
    if (r->vertex[r->words - 1] == PACKED_HOLE) return refuse(r, DATA_TEXT);
    if (r->words < 3) return 0;
    if (r->nv == INT32_MAX / 3 || !has_room(r, r->nv + 1, r->nf)) return refuse(r, DATA_FULL);
    memcpy(r->pool->base + r->pool->low + (size_t)r->nv * 3, r->vertex, sizeof r->vertex);
    r->nv++;
    return 0;
}

static int corner(obj_reader_t *r) {
    int32_t i = 0, v = 0;
    bool negative = r->token[0] == '-';
    if (negative) i++;
    int32_t digits = i;
    for (; i < r->token_len && r->token[i] >= '0' && r->token[i] <= '9'; i++) {
        if (v > INT32_MAX / 16) return refuse(r, DATA_VERTEX);
        v = v * 10 + (r->token[i] - '0');
    }
    if (i == digits || (i < r->token_len && r->token[i] != '/')) return refuse(r, DATA_TEXT);
    v = negative ? r->nv - v : v - 1;
    if (v < 0 || v >= r->nv) return refuse(r, DATA_VERTEX);
    if (r->words == 1) r->first = v;
    if (r->words >= 3 && v != r->first && v != r->before && r->first != r->before) {
        if (r->nf == INT32_MAX / 3 || !has_room(r, r->nv, r->nf + 1)) return refuse(r, DATA_FULL);
        int32_t *f = face(r, r->nf++);
        f[0] = r->first;
        f[1] = r->before;
        f[2] = v;
    }
    r->before = v;
    return 0;
}

static int end_word(obj_reader_t *r) {
    if (r->token_len == 0) return 0;
    int err = 0;
    if (r->words == 0) {
        bool known = r->token_len == 1 && (r->token[0] == 'v' || r->token[0] == 'f');
        r->what = known ? r->token[0] : '\0';
    } else if (r->what == 'v' && r->words <= 3) {
        err = number(r);
    } else if (r->what == 'f') {
        err = corner(r);
    }
    r->words++;
    r->token_len = 0;
    return err;
}

static int end_line(obj_reader_t *r) {
    int err = end_word(r);
    if (!err && r->what && r->words > 0 && r->words <= 3) {
        r->token_at = 0;
        err = refuse(r, DATA_SHORT);
    }
    if (err) return err;
    r->line++;
    r->at = r->words = 0;
    r->what = '\0';
    r->comment = false;
    return 0;
}

int obj_reader_feed(obj_reader_t *r, const char *text, size_t n) {
    for (size_t i = 0; i < n; i++) {
        char c = text[i];
        int err = 0;
        r->at++;
        if (c == '\n') {
            err = end_line(r);
        } else if (r->comment) {
            continue;
        } else if (c == ' ' || c == '\t' || c == '\r' || c == '#') {
            err = end_word(r);
            r->comment = c == '#';
        } else {
            if (r->token_len == 0) r->token_at = r->at;
            if (r->token_len < (int32_t)sizeof r->token)
                r->token[r->token_len++] = c;
            else if (r->what)
                err = refuse(r, DATA_TEXT);
        }
        if (err) return err;
    }
    return 0;
}

int obj_reader_finish(obj_reader_t *r, mesh_t *out) {
    int err = end_line(r);
    if (err) return err;
    if (r->nf == 0) return ERR_EMPTY;
    out->nv = r->nv;
    out->nf = r->nf;
    out->vertex = (const packed_t(*)[3])(const void *)(r->pool->base + r->pool->low);
    out->face = (const int32_t(*)[3])(const void *)face(r, r->nf - 1);
    r->pool->low += (size_t)r->nv * 3;
    r->pool->high -= face_units(r->nf);
    return 0;
}
