/* page_map.c - see page_map.h. */
#include "view/page_map.h"

#include "error.h"
#include "hidden/ink.h"

/* |H| stays below 2^60, so that H - w * E with |w| < 2^25 lat keeps clear of 2^63 when E < 2^35. */
#define H_BITS 60
#define E_BITS 35
#define NEAR_SHIFT 20 /* nearest depth drawn: 2^-20 of the farthest */

enum { K_X, K_Y, K_E };

static num_t row_share(const camera_t *cam, int k, num_t y, num_t z_origin) {
    return num_add(num_add(num_mul(cam->m[k][1], y), num_mul(cam->m[k][2], z_origin)), cam->m[k][3]);
}

/* Smallest b with |v| < 2^b. */
static int bits_of(num_t v) {
    return v.m == 0 ? -NUM_EXP_LIMIT : v.e + 63;
}

static page_h_t col_h(const page_map_t *m, int32_t i) {
    if (m->table) return m->table[i];
    num_t x = m->grid->src->x_of(m->grid->src->ctx, i);
    page_h_t h = {num_to_fixed(num_mul(m->cam->m[K_X][0], x), m->lines.frac_bits, NULL),
                  num_to_fixed(num_mul(m->cam->m[K_Y][0], x), m->lines.frac_bits, NULL),
                  num_to_fixed(num_mul(m->cam->m[K_E][0], x), m->lines.frac_bits, NULL)};
    return h;
}

static page_h_t row_h(const page_map_t *m, int32_t j) {
    if (m->table) return m->table[m->grid->nx + j];
    num_t y = m->grid->src->y_of(m->grid->src->ctx, j), z = m->grid->z_origin;
    page_h_t h = {num_to_fixed(row_share(m->cam, K_X, y, z), m->lines.frac_bits, NULL),
                  num_to_fixed(row_share(m->cam, K_Y, y, z), m->lines.frac_bits, NULL),
                  num_to_fixed(row_share(m->cam, K_E, y, z), m->lines.frac_bits, NULL)};
    return h;
}

/* The corners of the grid's box, in num_t: how large does H get, and is all of it inside the window? */
typedef struct extent {
    int bits_xy, bits_e; /* of single shares and of sums */
    bool inside;
} extent_t;

static void extent_corner(extent_t *x, const camera_t *cam, const num_t p[3]) {
    num_t h[3];
    camera_project(cam, p, h);
    for (int k = 0; k < 3; k++) {
        int *most = k == K_E ? &x->bits_e : &x->bits_xy;
        if (bits_of(h[k]) > *most) *most = bits_of(h[k]);
        for (int n = 0; n < 3; n++) {
            int b = bits_of(num_mul(cam->m[k][n], p[n]));
            if (b > *most) *most = b;
        }
    }
    const page_window_t *w = &cam->window;
    const int32_t lo[2] = {w->x0_lat, w->y0_lat}, hi[2] = {w->x1_lat, w->y1_lat};
    if (num_sign(h[K_E]) <= 0) {
        x->inside = false;
        return;
    }
    for (int k = 0; k < 2; k++)
        if (num_cmp(h[k], num_mul(num_from_i64(lo[k] - 1), h[K_E])) < 0 ||
            num_cmp(h[k], num_mul(num_from_i64(hi[k] + 1), h[K_E])) > 0)
            x->inside = false;
}

static extent_t extent_of(const grid_t *g, const camera_t *cam) {
    const surface_t *s = g->src;
    const num_t lo[3] = {s->x_of(s->ctx, 0), s->y_of(s->ctx, 0), g->z_min};
    const num_t hi[3] = {s->x_of(s->ctx, g->nx - 1), s->y_of(s->ctx, g->ny - 1), g->z_max};
    extent_t x = {-NUM_EXP_LIMIT, -NUM_EXP_LIMIT, true};
    for (int c = 0; c < 8; c++) {
        const num_t p[3] = {c & 1 ? hi[0] : lo[0], c & 2 ? hi[1] : lo[1], c & 4 ? hi[2] : lo[2]};
        extent_corner(&x, cam, p);
    }
    return x;
}

static inline int64_t height_share(const page_map_t *m, int k, int32_t zi) {
    return (int64_t)zi * m->z_mul[k] >> m->z_shift[k];
}

static bool vertex_h(page_map_t *m, int32_t i, int32_t j, page_h_t *h) {
    int32_t zi;
    if (!grid_height(m->grid, i, j, &zi)) return false;
    page_h_t c = col_h(m, i), r = row_h(m, j);
    h->x = c.x + r.x + height_share(m, K_X, zi);
    h->y = c.y + r.y + height_share(m, K_Y, zi);
    h->e = c.e + r.e + height_share(m, K_E, zi);
    return true;
}

static bool lines_at(void *ctx, uint8_t family, int32_t line, int64_t t_q30, page_h_t *h) {
    page_map_t *m = ctx;
    int32_t at = (int32_t)(t_q30 >> 30), s = (int32_t)(t_q30 & (INK_ONE - 1));
    bool row = family == INK_ROW;
    if (!vertex_h(m, row ? at : line, row ? line : at, h)) return false;
    if (s == 0) return true;
    page_h_t next;
    if (!vertex_h(m, row ? at + 1 : line, row ? line : at + 1, &next)) return false;
    h->x = line_space_lerp(h->x, next.x, s);
    h->y = line_space_lerp(h->y, next.y, s);
    h->e = line_space_lerp(h->e, next.e, s);
    return true;
}

int page_map_setup(page_map_t *m, grid_t *g, const camera_t *cam, void *memory) {
    *m = (page_map_t){.grid = g, .cam = cam};
    m->lines = (line_space_t){.ctx = m, .at = lines_at, .window = &cam->window, .perspective = cam->perspective};
    extent_t x = extent_of(g, cam);
    /* Two spare bits: a sum of three shares, and interpolation. */
    int by_xy = H_BITS - 2 - x.bits_xy, by_e = E_BITS - x.bits_e;
    m->lines.frac_bits = by_xy < by_e ? by_xy : by_e;
    /* A parallel view has E == 1: fewer bits than none means a page of 2^58 lat. */
    if (m->lines.frac_bits < (cam->perspective ? -900 : 1) || m->lines.frac_bits > 1000) return ERR_VALUE;
    m->lines.all_inside = x.inside;

    for (int k = 0; k < 3; k++) {
        /* One unit of zi is 2^z_exp; as a 31-bit mantissa and a right shift. */
        num_t share = num_ldexp(cam->m[k][2], g->z_exp + m->lines.frac_bits);
        int shift = 30 - bits_of(share);
        if (shift > 62) continue; /* far below one unit in all: no share */
        if (shift < 0) return ERR_VALUE;
        m->z_mul[k] = (int32_t)num_to_fixed(share, shift, NULL);
        m->z_shift[k] = (uint8_t)shift;
    }
    int64_t far_e = num_to_fixed(num_ldexp(num_from_i64(1), x.bits_e), m->lines.frac_bits, NULL);
    m->lines.near_e = cam->perspective ? far_e >> NEAR_SHIFT : 1;
    if (memory) {
        page_h_t *t = memory;
        for (int32_t i = 0; i < g->nx; i++) t[i] = col_h(m, i);
        for (int32_t j = 0; j < g->ny; j++) t[g->nx + j] = row_h(m, j);
        m->table = t;
    }
    return 0;
}
