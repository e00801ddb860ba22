/* page_map.c - see page_map.h. */
#include "view/page_map.h"

#include "config.h"
#include "error.h"
#include "hidden/ink.h"
#include "num/ints.h"

_Static_assert(GRID_SIDE_MAX <= INK_GRID_POINTS, "a parameter counts all points of a line");

static page_h_t to_h(const page_map_t *m, const num_t v[3]) {
    int f = m->lines.frac_bits;
    return (page_h_t){num_to_fixed(v[0], f, NULL), num_to_fixed(v[1], f, NULL), num_to_fixed(v[2], f, NULL)};
}

/* a * b * 2^frac_bits to nearest, below 2^61 as all shares are: the 61 bits or more of the product's upper word are
 * enough, and nothing is normalised on the way. */
static int64_t product(num_t a, num_t b, int frac_bits) {
    const int32_t drop = -(a.e + b.e + 64 + frac_bits);
    const int64_t p = wide_mulhi_s64(a.m, b.m);
    if (drop <= 0 || drop > 62) return drop == 0 ? p : num_to_fixed(num_mul(a, b), frac_bits, NULL);
    return (p + ((int64_t)1 << (drop - 1))) >> drop; /* |p| <= 2^62 */
}

/* What dx along axis k adds. */
static page_h_t share(const page_map_t *m, int axis, num_t dx) {
    const int f = m->lines.frac_bits;
    return (page_h_t){product(m->cam->m[0][axis], dx, f), product(m->cam->m[1][axis], dx, f),
                      product(m->cam->m[2][axis], dx, f)};
}

/* Shares are taken from the middle of the grid, so that a scene far from the world's origin loses nothing. */
static page_h_t col_share(const page_map_t *m, int32_t i) {
    return share(m, 0, num_sub(m->grid->src->x_of(m->grid->src->ctx, i), m->origin[0]));
}

/* The row's share, and the constant one. */
static page_h_t row_share(const page_map_t *m, int32_t j) {
    const page_h_t r = share(m, 1, num_sub(m->grid->src->y_of(m->grid->src->ctx, j), m->origin[1]));
    const page_h_t o = to_h(m, m->origin_h);
    return (page_h_t){r.x + o.x, r.y + o.y, r.e + o.e};
}

/* Both together, all of a vertex but its height. */
static inline page_h_t base_h(const page_map_t *m, int32_t i, int32_t j) {
    page_h_t c, r;
    if (m->table) {
        c = m->table[i];
        r = m->table[m->grid->nx + j];
    } else {
        c = col_share(m, i);
        r = row_share(m, j);
    }
    return (page_h_t){c.x + r.x, c.y + r.y, c.e + r.e};
}

/* zi * z_mul / 2^(32 + z_shift), z_mul of 63 bits in two halves: the height's share is as exact as the others even
 * where depths differ by a million. Budget: |zi| <= 2^30, so the halves' products stay below 2^61 and 2^62. */
static inline int64_t height_share(const page_map_t *m, int k, int32_t zi) {
    int64_t high = zi * (m->z_mul[k] >> 32), low = zi * (m->z_mul[k] & 0xffffffff);
    return (high + (low >> 32)) >> ints_count(m->z_shift[k]);
}

static page_h_t value_share(const page_map_t *m, num_t z) {
    return share(m, 2, num_sub(z, m->origin[2]));
}

static __attribute__((noinline)) void tall_vertex_at(const page_map_t *m, int32_t i, int32_t j, num_t z, page_h_t *h) {
    page_h_t b = base_h(m, i, j), s = value_share(m, z);
    *h = (page_h_t){b.x + s.x, b.y + s.y, b.e + s.e};
}

/* A vertex whose height is evaluated. Little is on the stack while heights are: here and below what follows is done
 * apart. */
static __attribute__((noinline)) bool tall_vertex_h(page_map_t *m, int32_t i, int32_t j, page_h_t *h) {
    num_t z;
    if (!grid_value(m->grid, i, j, &z)) return false;
    tall_vertex_at(m, i, j, z, h);
    return true;
}

/* Little is on the stack while heights are evaluated, where it is short. */
#if CONFIG_64BIT
#define APART inline
#else
#define APART __attribute__((noinline))
#endif

static APART void vertex_at(const page_map_t *m, int32_t i, int32_t j, int32_t zi, page_h_t *h) {
    page_h_t b = base_h(m, i, j);
    h->x = b.x + height_share(m, 0, zi);
    h->y = b.y + height_share(m, 1, zi);
    h->e = b.e + height_share(m, 2, zi);
}

static inline bool vertex_h(page_map_t *m, int32_t i, int32_t j, page_h_t *h) {
    int32_t zi;
    if (m->tall) return tall_vertex_h(m, i, j, h);
    const bool inline_cache = CONFIG_64BIT && m->grid->cache != NULL;
    if (!(inline_cache ? grid_cached_height(m->grid, i, j, &zi) : grid_height(m->grid, i, j, &zi))) return false;
    vertex_at(m, i, j, zi, h);
    return true;
}

static __attribute__((noinline)) void limit_at(const page_map_t *m, const int32_t a[2], const int32_t b[2],
                                               int64_t s_q46, num_t z, page_h_t *h) {
    page_h_t from = base_h(m, a[0], a[1]), to = base_h(m, b[0], b[1]), share = value_share(m, z);
    page_h_t base = line_space_mix_fine(&from, &to, s_q46);
    *h = (page_h_t){base.x + share.x, base.y + share.y, base.e + share.e};
}

/* A line ends where it meets a limit of heights: the limit itself is the height there. a_in: the point at t is within
 * the limits and the next is not; otherwise it is the other way round. */
static __attribute__((noinline)) bool limit_h(page_map_t *m, bool row, int32_t line, int64_t t, bool a_in,
                                              page_h_t *h) {
    const int32_t at = (int32_t)(t >> INK_GRID_BITS);
    const int32_t a[2] = {row ? at : line, row ? line : at}, b[2] = {a[0] + row, a[1] + !row};
    num_t z;
    int64_t at_q46;
    if (!m->grid->to_limits || !grid_edge_limit(m->grid, a_in ? a : b, a_in ? b : a, &z, &at_q46)) return false;
    limit_at(m, a, b, t & (INK_GRID_ONE - 1), z, h);
    return true;
}

static bool lines_at(void *ctx, uint8_t family, int32_t line, int64_t t, page_h_t *h) {
    page_map_t *m = ctx;
    const int32_t at = (int32_t)(t >> INK_GRID_BITS);
    const int row = family == INK_ROW;
    const int32_t i = row ? at : line, j = row ? line : at;
    page_h_t next;
    const bool a_in = vertex_h(m, i, j, h);
    if ((t & (INK_GRID_ONE - 1)) == 0) return a_in;
    const bool b_in = vertex_h(m, i + row, j + 1 - row, &next);
    if (a_in != b_in) return limit_h(m, row, line, t, a_in, h);
    if (a_in) *h = line_space_mix_fine(h, &next, t & (INK_GRID_ONE - 1));
    return a_in;
}

#if CONFIG_FETCH
/* Both ends of what is visible of an edge, as most of a rough surface is: its vertices once. */
static bool lines_span(void *ctx, uint8_t family, int32_t line, int64_t from, int64_t to, page_h_t h[2]) {
    page_map_t *m = ctx;
    const int32_t at = (int32_t)(from >> INK_GRID_BITS);
    const int64_t a_t = (int64_t)at << INK_GRID_BITS;
    const int row = family == INK_ROW;
    const int32_t i = row ? at : line, j = row ? line : at;
    page_h_t a, b;
    if (to <= a_t || to > a_t + INK_GRID_ONE || m->tall || !m->grid->cache) return false;
    if (!vertex_h(m, i, j, &a) || !vertex_h(m, i + row, j + 1 - row, &b)) return false;
    h[0] = from == a_t ? a : line_space_mix_fine(&a, &b, from - a_t);
    h[1] = to == a_t + INK_GRID_ONE ? b : line_space_mix_fine(&a, &b, to - a_t);
    return true;
}
#endif

/* The point at `part` of an edge from (i, j) whose ends have heights z. Interpolated in the world, before it is
 * projected: less stack, and as exact. */
static __attribute__((noinline)) void exact_between(const page_map_t *m, bool row, int32_t i, int32_t j,
                                                    const num_t z[2], int64_t part_q46, num_t h[3]) {
    const surface_t *src = m->grid->src;
    const num_t part = num_from_fixed(part_q46, INK_GRID_BITS);
    num_t p[3] = {src->x_of(src->ctx, i), src->y_of(src->ctx, j), z[0]};
    if (part_q46 != 0) {
        p[2] = num_add(p[2], num_mul(num_sub(z[1], p[2]), part));
        const num_t next = row ? src->x_of(src->ctx, i + 1) : src->y_of(src->ctx, j + 1);
        p[!row] = num_add(p[!row], num_mul(num_sub(next, p[!row]), part));
    }
    camera_project(m->cam, p, h);
}

static bool exact_at(void *ctx, uint8_t family, int32_t line, int64_t t, num_t h[3]) {
    const page_map_t *m = ctx;
    const bool row = family == INK_ROW;
    const int32_t at = (int32_t)(t >> INK_GRID_BITS), i = row ? at : line, j = row ? line : at;
    const int64_t part_q46 = t & (INK_GRID_ONE - 1);
    num_t z[2];
    if (!grid_value(m->grid, i, j, &z[0])) return false;
    if (part_q46 != 0 && !grid_value(m->grid, i + row, j + !row, &z[1])) return false;
    exact_between(m, row, i, j, z, part_q46, h);
    return true;
}

int page_map_setup(page_map_t *m, grid_t *g, const camera_t *cam, void *memory) {
    *m = (page_map_t){.grid = g, .cam = cam, .tall = cam->perspective && grid_is_tall(g, cam->eye)};
    m->lines = (line_space_t){.ctx = m, .at = lines_at};
#if CONFIG_FETCH
    m->lines.span = lines_span;
#endif
    const surface_t *src = g->src;
    const num_t z_lo = g->to_limits && g->below ? g->z_lo : g->z_min,
                z_hi = g->to_limits && g->above ? g->z_hi : g->z_max;
    const num_t lo[3] = {src->x_of(src->ctx, 0), src->y_of(src->ctx, 0), z_lo};
    const num_t hi[3] = {src->x_of(src->ctx, g->nx - 1), src->y_of(src->ctx, g->ny - 1), z_hi};
    int err = camera_scale(cam, lo, hi, &m->lines);
    if (err) return err;
    if (cam->perspective) m->lines.exact = exact_at;
    for (int k = 0; k < 2; k++) m->origin[k] = num_ldexp(num_add(lo[k], hi[k]), -1);
    m->origin[2] = g->z_origin;
    camera_project(cam, m->origin, m->origin_h);

    for (int k = 0; k < 3 && num_cmp(g->z_min, g->z_max) != 0; k++) { /* a level surface has heights of zero only */
        num_t share = num_ldexp(cam->m[k][2], g->z_exp + m->lines.frac_bits); /* of one unit of zi */
        int shift = share.m == 0 ? 63 : -(share.e + 32);
        if (shift > 62) continue; /* far below one unit in all: no share */
        if (shift < 0) return ERR_VALUE;
        m->z_mul[k] = share.m;
        m->z_shift[k] = (uint8_t)shift;
    }
    if (memory) {
        page_h_t *t = memory;
        for (int32_t i = 0; i < g->nx; i++) t[i] = col_share(m, i);
        for (int32_t j = 0; j < g->ny; j++) t[g->nx + j] = row_share(m, j);
        m->table = t;
    }
    return 0;
}
