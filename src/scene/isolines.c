/* isolines.c - points to the lower end of the pool, lines and facets to the upper; lines are written as they end, and
 * are taken back when their set turns out to have facets. */
#include "scene/isolines.h"
#include "error.h"

void isolines_init(isolines_t *s) {
    *s = (isolines_t){.even = true};
    for (int k = 0; k < 3; k++) s->lo[k] = s->hi[k] = num_undef();
    for (int k = 0; k < 2; k++) s->extent[k][0] = s->extent[k][1] = num_undef();
}

void isolines_start(isolines_t *s, data_pool_t *pool) {
    s->pool = pool;
    s->vertex = pool->base + pool->low;
    s->top = (int32_t *)(void *)(pool->base + pool->high);
}

/* Is there room for so many more points and words? */
static bool fits(const isolines_t *s, int64_t points, int64_t words) {
    const data_pool_t *p = s->pool;
    return points * 3 + (s->mesh.words + words + 1) / 2 <= (int64_t)(p->high - p->low);
}

static void add_word(isolines_t *s, int32_t word) {
    s->top[-1 - s->mesh.words++] = word;
}

static bool is_within(const isolines_t *s, int k, num_t v) {
    return !v.undef && (s->lo[k].undef || num_cmp(v, s->lo[k]) >= 0) && (s->hi[k].undef || num_cmp(v, s->hi[k]) <= 0);
}

/* Whatever else is left out of a point, gnuplot's axes are as long as this. */
static void widen(num_t extent[2], num_t v) {
    if (extent[0].undef || num_cmp(v, extent[0]) < 0) extent[0] = v;
    if (extent[1].undef || num_cmp(v, extent[1]) > 0) extent[1] = v;
}

/* The limits are applied to the point at out. */
static void settle(isolines_t *s, packed_t out[3]) {
    bool good = true;
    for (int k = 0; k < 3; k++) {
        const num_t v = out[k] == PACKED_HOLE ? num_undef() : packed_num(out[k]);
        const bool within = is_within(s, k, v);
        if (k < 2 && within) widen(s->extent[k], v);
        good &= within;
    }
    if (!good) out[0] = PACKED_HOLE;
}

int isolines_point(isolines_t *s, num_t x, num_t y, num_t z) {
    if (!fits(s, 1, 0)) return ERR_FULL;
    packed_t *out = s->vertex + (size_t)s->mesh.nv++ * 3;
    out[0] = packed_from_num(x);
    out[1] = packed_from_num(y);
    out[2] = packed_from_num(z);
    settle(s, out);
    s->pool->low += 3;
    return 0;
}

static bool is_hole(const isolines_t *s, int32_t v) {
    return s->vertex[(size_t)v * 3] == PACKED_HOLE;
}

/* The line of points [first, end), in as many pieces as holes make of it. */
static void add_line(isolines_t *s, int32_t first, int32_t end) {
    for (int32_t from = first, to; from < end; from = to + 1) {
        for (to = from; to < end && !is_hole(s, to);) to++;
        if (to - from < 2) continue;
        add_word(s, (to - from) << 2 | MESH_LINE);
        for (int32_t k = from; k < to; k++) add_word(s, k);
        s->mesh.segments += to - from - 1;
    }
}

int isolines_break(isolines_t *s) {
    const int32_t end = s->mesh.nv, n = end - s->line_first;
    if (n == 0) return 0;
    if (!fits(s, 0, (int64_t)n + n / 2)) return ERR_FULL;
    if (s->lines++ == 0) s->length = n;
    s->even &= n == s->length;
    add_line(s, s->line_first, end);
    s->line_first = end;
    return 0;
}

static int add_facets(isolines_t *s) {
    const int32_t n = s->length;
    if (!fits(s, 0, 5 * (int64_t)(n - 1) * (s->lines - 1))) return ERR_FULL;
    for (int32_t j = 0; j + 1 < s->lines; j++)
        for (int32_t i = 0; i + 1 < n; i++) {
            const int32_t k = s->first + j * n + i, corner[4] = {k, k + 1, k + 1 + n, k + n};
            bool whole = true;
            for (int c = 0; c < 4; c++) whole &= !is_hole(s, corner[c]);
            if (!whole) continue;
            add_word(s, 4 << 2 | MESH_FACE);
            for (int c = 0; c < 4; c++) add_word(s, corner[c]);
            s->mesh.faces++;
            s->mesh.corners += 4;
        }
    return 0;
}

int isolines_end_set(isolines_t *s, bool facets) {
    int err = isolines_break(s);
    if (err) return err;
    if (facets && s->even && s->lines > 1 && s->length > 1) {
        s->mesh.words = s->set_words;
        s->mesh.segments = s->set_segments;
        err = add_facets(s);
    }
    s->set_words = s->mesh.words;
    s->set_segments = s->mesh.segments;
    s->first = s->mesh.nv;
    s->lines = 0;
    s->even = true;
    return err;
}

int isolines_adopt(isolines_t *s, const data_grid_t *g) {
    data_pool_t *pool = g->pool;
    const int32_t whole = g->outer_n * g->inner_n, n = whole + g->at;
    const size_t start = (size_t)(g->z - pool->base);
    if (start + 3 * (size_t)n > pool->high) return ERR_FULL;
    /* From the last point on each moves up, over heights that have moved already. */
    for (int32_t k = n - 1; k >= 0; k--) {
        const int32_t j = g->outer_n ? k / g->inner_n : 0, i = k - j * g->inner_n;
        packed_t x = g->first_x, y = g->first_y;
        const packed_t z = g->z[k];
        if (g->oriented) *(g->inner_is_x ? &x : &y) = g->inner[-1 - i];
        if (g->outer_n) *(g->inner_is_x ? &y : &x) = g->outer[-1 - j];
        packed_t *out = g->z + (size_t)k * 3;
        out[0] = x;
        out[1] = y;
        out[2] = z;
    }
    pool->low = start;
    pool->high = (size_t)(g->inner - pool->base);
    isolines_start(s, pool);
    pool->low += 3 * (size_t)n;
    for (int32_t k = 0; k < n; k++) {
        settle(s, s->vertex + (size_t)k * 3);
        s->mesh.nv++;
        if ((k + 1) % (g->inner_n ? g->inner_n : n + 1) == 0 && k < whole && isolines_break(s)) return ERR_FULL;
    }
    return 0;
}

int isolines_finish(isolines_t *s, mesh_t *out) {
    *out = s->mesh;
    out->vertex = (const packed_t(*)[3])(const void *)s->vertex;
    out->top = s->top;
    s->pool->high -= ((size_t)s->mesh.words + 1) / 2;
    return out->words ? 0 : ERR_EMPTY;
}
