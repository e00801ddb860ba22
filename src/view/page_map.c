/* page_map.c - see page_map.h. */
#include "view/page_map.h"

#include "error.h"
#include "hidden/ink.h"

enum { K_X, K_Y, K_E };

static num_t row_share(const camera_t *cam, int k, num_t y, num_t z_origin) {
    return num_add(num_add(num_mul(cam->m[k][1], y), num_mul(cam->m[k][2], z_origin)), cam->m[k][3]);
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
    *h = line_space_mix(h, &next, s);
    return true;
}

int page_map_setup(page_map_t *m, grid_t *g, const camera_t *cam, void *memory) {
    *m = (page_map_t){.grid = g, .cam = cam};
    m->lines = (line_space_t){.ctx = m, .at = lines_at};
    const surface_t *src = g->src;
    const num_t lo[3] = {src->x_of(src->ctx, 0), src->y_of(src->ctx, 0), g->z_min};
    const num_t hi[3] = {src->x_of(src->ctx, g->nx - 1), src->y_of(src->ctx, g->ny - 1), g->z_max};
    int err = camera_scale(cam, lo, hi, &m->lines);
    if (err) return err;

    for (int k = 0; k < 3; k++) {
        /* One unit of zi is 2^z_exp; as a 31-bit mantissa and a right shift. */
        num_t share = num_ldexp(cam->m[k][2], g->z_exp + m->lines.frac_bits);
        int shift = share.m == 0 ? 63 : 30 - (share.e + 63);
        if (shift > 62) continue; /* far below one unit in all: no share */
        if (shift < 0) return ERR_VALUE;
        m->z_mul[k] = (int32_t)num_to_fixed(share, shift, NULL);
        m->z_shift[k] = (uint8_t)shift;
    }
    if (memory) {
        page_h_t *t = memory;
        for (int32_t i = 0; i < g->nx; i++) t[i] = col_h(m, i);
        for (int32_t j = 0; j < g->ny; j++) t[g->nx + j] = row_h(m, j);
        m->table = t;
    }
    return 0;
}
