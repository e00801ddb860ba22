/* plot_parametric.c - splot x(u,v), y(u,v), z(u,v) as a mesh: a facet for each cell of the grid of u and v, or without
 * hidden lines the isolines alone, as finely as samples says. */
#include "lang/session_parts.h"

#if CONFIG_PARAMETRIC
typedef struct build {
    session_t *s;
    session_source_t *src;
    mesh_t *mesh;
    packed_t *vertex;
    int32_t *top;
    int error;
} build_t;

/* The ends of u (k = 0) or v. */
static void ends(const session_t *s, int k, num_t out[2]) {
    const range_t *r = &s->plot.uv[k];
    out[0] = r->auto_lo ? num_from_i64(-5) : r->reverse ? r->hi : r->lo;
    out[1] = r->auto_hi ? num_from_i64(5) : r->reverse ? r->lo : r->hi;
}

static num_t place(const num_t end[2], int32_t i, int32_t n) {
    num_t part = num_div(num_mul(num_sub(end[1], end[0]), num_from_i64(i)), num_from_i64(n - 1));
    return i == n - 1 ? end[1] : num_add(end[0], part);
}

static bool is_within(const range_t *r, num_t v) {
    return !v.undef && (r->auto_lo || num_cmp(v, r->lo) >= 0) && (r->auto_hi || num_cmp(v, r->hi) <= 0);
}

/* Whatever else is left out of a point, gnuplot's axes are as long as this. */
static void widen(num_t extent[2], num_t v) {
    if (v.undef) return;
    if (extent[0].undef || num_cmp(v, extent[0]) < 0) extent[0] = v;
    if (extent[1].undef || num_cmp(v, extent[1]) > 0) extent[1] = v;
}

/* The next vertex; a hole where it is undefined or outside of the ranges. */
static void add_vertex(build_t *b, num_t u, num_t v) {
    const num_t at[2] = {u, v};
    packed_t *out = b->vertex + (size_t)b->mesh->nv++ * 3;
    bool good = true;
    for (int k = 0; k < 3 && !b->error; k++) { /* the first error stays where expr_fault() finds it */
        value_t value;
        b->error = expr_eval(&b->s->lang, &b->src->part[k], at, &value);
        const num_t n = value_num(value);
        if (k < 2 && !b->error && is_within(&b->s->plot.range[k], n)) widen(b->src->extent[k], n);
        good &= is_within(&b->s->plot.range[k], n);
        out[k] = good ? packed_from_num(n) : PACKED_HOLE;
    }
    if (!good || b->error) out[0] = PACKED_HOLE;
}

static bool is_hole(const build_t *b, int32_t v) {
    return b->vertex[(size_t)v * 3] == PACKED_HOLE;
}

static void add_word(build_t *b, int32_t word) {
    b->top[-1 - b->mesh->words++] = word;
}

/* Is there room for so many vertices and words? */
static bool fits(const session_t *s, int64_t vertices, int64_t words) {
    return vertices * 3 + (words + 1) / 2 <= (int64_t)(s->pool.high - s->pool.low);
}

/* A line of n points; holes interrupt it. */
static void add_line(build_t *b, int32_t n) {
    const int32_t first = b->mesh->nv - n;
    for (int32_t from = 0, to; from < n; from = to + 1) {
        for (to = from; to < n && !is_hole(b, first + to);) to++;
        if (to - from < 2) continue;
        add_word(b, (to - from) << 2 | MESH_LINE);
        for (int32_t k = from; k < to; k++) add_word(b, first + k);
        b->mesh->segments += to - from - 1;
    }
}

static int lines(build_t *b, const num_t u[2], const num_t v[2]) {
    const int32_t *iso = b->s->settings.isosamples, *along = b->s->settings.samples;
    const int64_t points = (int64_t)iso[0] * along[1] + (int64_t)iso[1] * along[0];
    if (!fits(b->s, points, 2 * points)) return ERR_FULL;
    for (int32_t i = 0; i < iso[0]; i++) {
        for (int32_t j = 0; j < along[1]; j++) add_vertex(b, place(u, i, iso[0]), place(v, j, along[1]));
        add_line(b, along[1]);
    }
    for (int32_t j = 0; j < iso[1]; j++) {
        for (int32_t i = 0; i < along[0]; i++) add_vertex(b, place(u, i, along[0]), place(v, j, iso[1]));
        add_line(b, along[0]);
    }
    return 0;
}

static int facets(build_t *b, const num_t u[2], const num_t v[2]) {
    const int32_t nu = b->s->settings.isosamples[0], nv = b->s->settings.isosamples[1];
    if (!fits(b->s, (int64_t)nu * nv, 5 * (int64_t)nu * nv)) return ERR_FULL;
    for (int32_t j = 0; j < nv; j++)
        for (int32_t i = 0; i < nu; i++) add_vertex(b, place(u, i, nu), place(v, j, nv));
    for (int32_t j = 0; j + 1 < nv; j++)
        for (int32_t i = 0; i + 1 < nu; i++) {
            const int32_t k = j * nu + i, corner[4] = {k, k + 1, k + 1 + nu, k + nu};
            bool whole = true;
            for (int c = 0; c < 4; c++) whole &= !is_hole(b, corner[c]);
            if (!whole) continue;
            add_word(b, 4 << 2 | MESH_FACE);
            for (int c = 0; c < 4; c++) add_word(b, corner[c]);
            b->mesh->faces++;
            b->mesh->corners += 4;
        }
    return 0;
}

int plot_parametric(session_t *s, session_source_t *src) {
    mesh_t *m = &s->plot.mesh[s->plot.next];
    build_t b = {s, src, m, s->pool.base + s->pool.low, (int32_t *)(void *)(s->pool.base + s->pool.high), 0};
    num_t u[2], v[2];
    const int32_t seed[2] = {s->lang.seed[0], s->lang.seed[1]};
    *m = (mesh_t){.vertex = (const packed_t(*)[3])(const void *)b.vertex, .top = b.top};
    for (int k = 0; k < 2; k++) src->extent[k][0] = src->extent[k][1] = num_undef();
    ends(s, 0, u);
    ends(s, 1, v);
    int err = s->settings.hidden == HIDDEN_NONE ? lines(&b, u, v) : facets(&b, u, v);
    s->lang.seed[0] = seed[0];
    s->lang.seed[1] = seed[1];
    if (b.error) {
        err = expr_fault(&s->lang, &src->name, &s->error);
        if (s->error.column == 0) s->error.column = src->column;
        return err;
    }
    if (err) return plot_fail(s, src, err, "more points than the memory for data holds; try fewer isosamples");
    if (m->words == 0) return plot_fail(s, src, ERR_EMPTY, "nothing to draw");
    s->pool.low += (size_t)m->nv * 3;
    s->pool.high -= ((size_t)m->words + 1) / 2;
    src->grids = 0;
    s->plot.next++;
    return 0;
}
#endif
