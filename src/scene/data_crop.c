/* data_crop.c - see data_crop.h. */
#include "scene/data_crop.h"
#include "error.h"

#if CONFIG_CROP
/* Coordinate along the lines of point k of them, uncut. */
static num_t along(const data_crop_t *c, int32_t k) {
    return c->along_y ? data_view_y(&c->all, k) : data_view_x(&c->all, k);
}

static num_t height(const data_crop_t *c, int32_t line, int32_t k) {
    return c->along_y ? data_view_z(&c->all, line, k) : data_view_z(&c->all, k, line);
}

/* Which end of the line point k is, if it is cut there, or -1. */
static int cut_end(const data_crop_t *c, int32_t k) {
    const int end = k == 0 ? 0 : k == c->n - 1 ? 1 : -1;
    return end >= 0 && !c->end[end].undef ? end : -1;
}

static num_t place(const data_crop_t *c, int32_t k) {
    const int end = cut_end(c, k);
    return end >= 0 ? c->end[end] : along(c, c->first + k);
}

static num_t x_of(void *ctx, int32_t i) {
    const data_crop_t *c = ctx;
    return c->along_y ? data_view_x(&c->all, i) : place(c, i);
}

static num_t y_of(void *ctx, int32_t j) {
    const data_crop_t *c = ctx;
    return c->along_y ? place(c, j) : data_view_y(&c->all, j);
}

static num_t z_of(void *ctx, int32_t i, int32_t j) {
    const data_crop_t *c = ctx;
    const int32_t line = c->along_y ? i : j, k = c->first + (c->along_y ? j : i);
    const int end = cut_end(c, k - c->first);
    const num_t z = height(c, line, k);
    if (end < 0) return z;
    const int32_t inside = end ? k - 1 : k + 1;
    const num_t near = along(c, inside), base = height(c, line, inside);
    const num_t part = num_div(num_sub(c->end[end], near), num_sub(along(c, k), near));
    /* Undefined, if one of both is. */
    return num_add(base, num_mul(num_sub(z, base), part));
}

int data_crop_lines(const data_grid_t *g, const num_t *x_lim, const num_t *y_lim, const num_t *at, bool along_y,
                    data_crop_t *c, surface_t *out) {
    const num_t *lim = along_y ? y_lim : x_lim;
    surface_t whole;
    int err = data_grid_surface(g, along_y ? x_lim : NULL, along_y ? NULL : y_lim, &c->all, &whole);
    if (err) return err;
    c->along_y = along_y;
    c->end[0] = c->end[1] = num_undef();
    const int32_t all = along_y ? whole.ny : whole.nx;
    int32_t first = 0, last = all - 1;
    while (lim && first <= last && num_cmp(along(c, first), lim[0]) < 0) first++;
    while (lim && last >= first && num_cmp(along(c, last), lim[1]) > 0) last--;
    /* Within the slack of the limit a line ends already. */
    if (first > 0 && num_cmp(along(c, first), num_add(at[0], num_sub(at[0], lim[0]))) > 0) {
        c->end[0] = at[0];
        first--;
    }
    if (last < all - 1 && num_cmp(along(c, last), num_sub(at[1], num_sub(lim[1], at[1]))) < 0) {
        c->end[1] = at[1];
        last++;
    }
    c->first = first;
    c->n = last - first + 1;
    *out = (surface_t){.ctx = c, .x_of = x_of, .y_of = y_of, .z_of = z_of, .nx = whole.nx, .ny = whole.ny};
    *(along_y ? &out->ny : &out->nx) = c->n;
    return c->n < 2 ? ERR_EMPTY : 0;
}
#endif
