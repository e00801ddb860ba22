/* obj_reader.c - words of an OBJ file; a line's first word says what the others are. */
#include "scene/obj_words.h"

#include "config.h"
#include "error.h"
#include "scene/field.h"
#include <string.h>

_Static_assert(sizeof(packed_t) == 2 * sizeof(int32_t), "two words are a unit of the pool");

void obj_reader_start(obj_reader_t *r, data_pool_t *pool, const affine_t *affine, bool inline_data,
                      int32_t first_line) {
    *r = (obj_reader_t){.pool = pool, .affine = affine, .inline_data = inline_data, .line = first_line + 1};
    r->mesh.top = (const int32_t *)(const void *)(pool->base + pool->high);
    r->mesh.vertex = (const packed_t(*)[3])(const void *)(pool->base + pool->low);
}

static int number(obj_reader_t *r) {
    field_t f;
    field_start(&f, '\n', false, 0); /* a separator that cannot occur: the whole word is one field */
    const char *p = r->token;
    field_next(&f, &p, r->token + r->token_len);
    num_t a = field_finish(&f) == FIELD_VALUE ? field_num(&f) : num_undef();
    if (a.undef || packed_from_num(a) == PACKED_HOLE) return obj_refuse(r, DATA_TEXT);
    r->vertex[r->words - 1] = a;
    if (r->words < 3) return 0;
    mesh_t *m = &r->mesh;
    if (m->nv == INT32_MAX / 3 || !obj_has_room(r, m->nv + 1, m->words)) return obj_refuse(r, DATA_FULL);
    if (r->affine) affine_apply(r->affine, r->vertex);
    packed_t *to = r->pool->base + r->pool->low + (size_t)m->nv * 3;
    for (int axis = 0; axis < 3; axis++) {
        to[axis] = packed_from_num(r->vertex[axis]);
        if (to[axis] == PACKED_HOLE) return obj_refuse(r, DATA_TEXT);
    }
    m->nv++;
    return 0;
}

/* Twice the area of a contour: words from <= k < to, as a vector square to it (Newell). */
static void area_of(const obj_reader_t *r, int32_t from, int32_t to, num_t area[3]) {
    for (int axis = 0; axis < 3; axis++) area[axis] = num_from_i64(0);
    for (int32_t k = from; k < to; k++) {
        const packed_t *p = r->mesh.vertex[*obj_word(r, k)],
                       *q = r->mesh.vertex[*obj_word(r, k + 1 < to ? k + 1 : from)];
        const packed_t *o = r->mesh.vertex[*obj_word(r, from)];
        for (int axis = 0; axis < 3; axis++) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            const num_t pu = num_sub(packed_num(p[u]), packed_num(o[u])),
                        qv = num_sub(packed_num(q[v]), packed_num(o[v]));
            const num_t pv = num_sub(packed_num(p[v]), packed_num(o[v])),
                        qu = num_sub(packed_num(q[u]), packed_num(o[u]));
            area[axis] = num_add(area[axis], num_sub(num_mul(pu, qv), num_mul(pv, qu)));
        }
    }
}

/* Holes run the other way round than the polygon, so that what fills one runs like the polygon. */
static void turn_hole(obj_reader_t *r) {
    int32_t outer = r->head + 2, last = r->mesh.words - 1;
    while (*obj_word(r, outer) != *obj_word(r, r->head + 1)) outer++; /* the way back to where the contour began */
    num_t around[3], hole[3], same = num_from_i64(0);
    area_of(r, r->head + 1, outer, around);
    area_of(r, r->contour, last + 1, hole);
    for (int axis = 0; axis < 3; axis++) same = num_add(same, num_mul(around[axis], hole[axis]));
    if (num_sign(same) <= 0) return;
    for (int32_t k = r->contour; k < last; k++, last--) {
        const int32_t swap = *obj_word(r, k);
        *obj_word(r, k) = *obj_word(r, last);
        *obj_word(r, last) = swap;
    }
}

/* The end of a face's contour. A hole is joined to the outer contour by a cut that is gone along both ways, v0 ... h0
 * h1
 * ... h0, so that a face stays one chain; edges of one face on both sides are no lines (solid_is_cut). */
static int end_contour(obj_reader_t *r) {
    int32_t count = r->mesh.words - r->contour;
    if (count < 3) return obj_refuse(r, DATA_SHORT);
    if (!CONFIG_HOLES || r->contour == r->head + 1) return 0;
    turn_hole(r);
    return obj_push(r, *obj_word(r, r->contour));
}

static int begin_hole(obj_reader_t *r) {
    int err = end_contour(r);
    if (!err) err = obj_push(r, *obj_word(r, r->head + 1));
    r->contour = r->mesh.words;
    return err;
}

static int corner(obj_reader_t *r) {
    if (CONFIG_HOLES && r->what == 'f' && r->token_len == 1 && r->token[0] == 'h') return begin_hole(r);
    if (r->what == 'd' && obj_detail_word(r)) return obj_detail_take(r);
    int32_t i = 0, v = 0;
    bool negative = r->token[0] == '-';
    if (negative) i++;
    int32_t digits = i;
    for (; i < r->token_len && r->token[i] >= '0' && r->token[i] <= '9'; i++) {
        if (v > INT32_MAX / 16) return obj_refuse(r, DATA_VERTEX);
        v = v * 10 + (r->token[i] - '0');
    }
    if (i == digits || (i < r->token_len && r->token[i] != '/')) return obj_refuse(r, DATA_TEXT);
    v = negative ? r->mesh.nv - v : v - 1;
    if (v < 0 || v >= r->mesh.nv) return obj_refuse(r, DATA_VERTEX);
    return obj_push(r, v);
}

/* Lines that only concern looks. */
static bool is_passed(const char *word, size_t n) {
    static const char *const passed[] = {"vt",  "vn", "s",     "usemtl",   "mtllib",   "usemap",     "maplib",
                                         "lod", "mg", "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj"};
    for (size_t k = 0; k < sizeof passed / sizeof passed[0]; k++)
        if (strlen(passed[k]) == n && memcmp(passed[k], word, n) == 0) return true;
    return false;
}

/* Names a word once. Those that are not OBJ's at all share what bits are left, so a few words are not named if there
 * are many. */
static void name_unsupported(obj_reader_t *r) {
    static const char *const known[] = {"p",     "vp",   "deg",  "bmat", "step",  "cstype", "curv",
                                        "curv2", "surf", "parm", "trim", "hole",  "scrv",   "sp",
                                        "end",   "con",  "call", "csh",  "ctech", "stech",  "merge"};
    size_t k = 0, n = sizeof known / sizeof known[0], len = (size_t)r->token_len;
    while (k < n && !(strlen(known[k]) == len && memcmp(known[k], r->token, len) == 0)) k++;
    if (k == n)
        for (size_t i = 0; i < len; i++) k = n + (k * 31 + (uint8_t)r->token[i]) % (32 - n);
    uint32_t bit = (uint32_t)1 << k;
    if (!(r->named & bit) && r->notice) r->notice(r->notice_ctx, r->line, r->token, r->token_len);
    r->named |= bit;
}

#if CONFIG_AREA
/* Is the word one of the translucent names? */
static bool is_clear(const obj_reader_t *r) {
    const size_t len = (size_t)r->token_len;
    for (const char *name = r->clear; *name; name += strlen(name) + 1)
        if (strlen(name) == len && memcmp(name, r->token, len) == 0) return true;
    return false;
}

/* Says so before the first face that is translucent, or is not any more. */
static int say_clear(obj_reader_t *r) {
    const bool clear = r->clear_group || r->clear_material;
    r->clear_any |= clear;
    if (clear == r->clear_now) return 0;
    r->clear_now = clear;
    int err = obj_push(r, 1 << 2 | MESH_OBJECT);
    return err ? err : obj_push(r, clear);
}

static int name(obj_reader_t *r) {
    if (r->clear) *(r->what == 'u' ? &r->clear_material : &r->clear_group) |= is_clear(r);
    return 0;
}

/* usemtl, o, g: none of what follows is translucent until a name says so; f: says what it is. */
static int clear_word(obj_reader_t *r) {
    if (!r->clear) return 0;
    if (r->token_len == 6 && memcmp(r->token, "usemtl", 6) == 0) {
        r->what = 'u';
        r->clear_material = false;
    }
    if (r->what == 'o' || r->what == 'g') r->clear_group = false;
    return r->what == 'f' ? say_clear(r) : 0;
}
#else
static int name(obj_reader_t *r) {
    (void)r;
    return 0;
}
static int clear_word(obj_reader_t *r) {
    (void)r;
    return 0;
}
#endif

static int first_word(obj_reader_t *r) {
    static const char taken[] = "vflogd";
    const char *c = r->token_len == 1 ? memchr(taken, r->token[0], sizeof taken - 1) : NULL;
    r->what = c ? *c : '\0';
    if (r->inline_data && r->token_len == 1 && (r->token[0] == 'e' || r->token[0] == 'E')) {
        r->what = 'e';
        return 0;
    }
    if (r->what == 'd' && r->mesh.faces == 0) return obj_refuse(r, DATA_DETAIL);
    r->rings = 0;
    r->detail = r->mesh.words;
    int err = clear_word(r);
    if (err || r->what == 'u') return err;
    if (r->what && r->what != 'v') {
        r->head = r->mesh.words;
        err = obj_push(r, 0);
        if (err) return err;
        obj_set_head(r, MESH_OBJECT, 0);
        r->contour = r->mesh.words;
    } else if (!r->what && !is_passed(r->token, (size_t)r->token_len)) {
        name_unsupported(r);
    }
    return 0;
}

static int end_word(obj_reader_t *r) {
    if (r->token_len == 0) return 0;
    int err = 0;
    if (r->words == 0)
        err = first_word(r);
    else if (r->what == 'v' && r->words <= 3)
        err = number(r);
    else if (r->what == 'f' || r->what == 'l' || r->what == 'd')
        err = corner(r);
    else if (r->what == OBJ_TONE)
        err = obj_detail_tone(r);
    else if (r->what && r->what != 'v')
        err = name(r);
    r->words++;
    r->token_len = 0;
    return err;
}

static int end_element(obj_reader_t *r) {
    mesh_t *m = &r->mesh;
    int32_t count = r->words - 1;
    r->token_at = r->at; /* what is missing is missing there */
    if (r->what == 'e' && r->words == 1) r->stopped = true;
    if (r->what == 'v' && count < 3) return obj_refuse(r, DATA_SHORT);
    if (r->what == 'f') {
        int err = end_contour(r);
        if (err) return err;
        count = m->words - r->head - 1;
        obj_set_head(r, MESH_FACE, count);
        m->faces++;
        m->corners += count;
    } else if (r->what == 'l') {
        if (count < 2) return obj_refuse(r, DATA_SHORT);
        obj_set_head(r, MESH_LINE, count);
        m->segments += count - 1;
    } else if (r->what == 'd' || r->what == OBJ_TONE) {
        return obj_detail_end(r);
    }
    return 0;
}

static int end_line(obj_reader_t *r) {
    int err = end_word(r);
    if (!err && r->words > 0) err = end_element(r);
    if (err) return err;
    r->line++;
    r->at = r->words = 0;
    r->what = '\0';
    r->comment = false;
    return 0;
}

static int take(obj_reader_t *r, char c) {
    r->at++;
    if (r->line == 1 && r->at <= 3 && c == "\xef\xbb\xbf"[r->at - 1]) return 0; /* the mark of UTF-8 */
    if (r->joins && c != '\r') {
        r->joins = false;
        if (c == '\n') {
            r->line++;
            r->at = 0;
            return 0;
        }
        r->token_at = r->at - 1;
        if (r->what) return obj_refuse(r, DATA_TEXT);
    }
    if (c == '\n') return end_line(r);
    if (r->comment) return 0;
    if (c == ' ' || c == '\t' || c == '\r' || c == '#' || c == '\\') {
        r->comment = c == '#';
        if (c == '\\') r->joins = true;
        return end_word(r);
    }
    if (r->token_len == 0) r->token_at = r->at;
    if (r->token_len < OBJ_WORD_MAX)
        r->token[r->token_len++] = c;
    else if (r->what && !strchr("ogu", r->what))
        return obj_refuse(r, DATA_TEXT);
    return 0;
}

int obj_reader_feed(obj_reader_t *r, const char *text, size_t n) {
    for (size_t i = 0; i < n && !r->stopped; i++) {
        int err = take(r, text[i]);
        if (err) return err;
    }
    return 0;
}

int obj_reader_finish(obj_reader_t *r, mesh_t *out) {
    int err = r->stopped ? 0 : end_line(r);
    if (err) return err;
    if (r->mesh.faces == 0 && r->mesh.segments == 0) return ERR_EMPTY;
    *out = r->mesh;
    r->pool->low += (size_t)r->mesh.nv * 3;
    r->pool->high -= obj_word_units(r->mesh.words);
    return 0;
}
