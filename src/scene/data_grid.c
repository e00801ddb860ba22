/* data_grid.c - recognises a separable grid while its points arrive, one comparison of packed words per point. */
#include "scene/data_grid.h"
#include "config.h"
#include "error.h"
#include "said.h"

#define TOLERANCE_SHIFT (-12)   /* of the first step: far below a pen's width on any paper */
#define NEARLY_SAME_SHIFT (-20) /* |dx| against |dy|, where rounding noise hides which of them stays */

static const char *const TEXT[] = {
    [DATA_OK] = SAID("no error"),
    [DATA_FULL] = SAID("more data than the memory for it holds"),
    [DATA_NO_PLACE] = SAID("x or y is missing or undefined"),
    [DATA_NO_GRID] = SAID("not a grid: neither x nor y stays the same along this isoline"),
    [DATA_TURNS] = SAID("not a grid: coordinates must keep increasing or keep decreasing"),
    [DATA_OFF_GRID] = SAID("not a grid: the corresponding point of the first isoline has another coordinate"),
    [DATA_RAGGED] = SAID("not a grid: this isoline has another number of points than the first"),
    [DATA_TOO_SMALL] = SAID("a surface needs at least 2 x 2 points"),
    [DATA_SETS] = SAID("more data sets than can be drawn at once; choose with `index`"),
    [DATA_TWO_COLUMNS] = SAID("a surface needs one column (z) or three (x y z), not two"),
    [DATA_SHORT] = SAID("this line lacks a number that is needed"),
    [DATA_TEXT] = SAID("not a number"),
    [DATA_DETAIL] = SAID("a line on a face needs a face before it"),
#if CONFIG_AREA
    [DATA_TONE] = SAID("a tone is one number from 0 to 100"),
#endif
    [DATA_VERTEX] = SAID("there is no vertex of this number before this line"),
#if CONFIG_BINARY
    [DATA_BINARY_COUNT] = SAID("no binary matrix: its first number, a float, must be how many columns follow"),
    [DATA_BINARY_SHORT] = SAID("the file ends before its data are complete"),
#endif
};

const char *data_grid_text(enum data_grid_trouble trouble) {
    return TEXT[trouble];
}

void data_grid_start(data_grid_t *g, data_pool_t *pool) {
    *g = (data_grid_t){.pool = pool, .z = pool->base + pool->low, .inner = pool->base + pool->high};
}

static int refuse(enum data_grid_trouble why, enum data_grid_trouble *trouble) {
    *trouble = why;
    return why == DATA_FULL ? ERR_FULL : ERR_DATA;
}

static bool take_coordinate(data_grid_t *g, packed_t c) {
    data_pool_t *pool = g->pool;
    if (pool->low >= pool->high) return false;
    pool->base[--pool->high] = c;
    return true;
}

static num_t distance(packed_t a, packed_t b) {
    return num_abs(num_sub(packed_num(a), packed_num(b)));
}

static bool within(num_t a, num_t limit) {
    return num_cmp(a, limit) <= 0;
}

/* The second point of the first block says which coordinate runs along blocks. */
static bool orient(data_grid_t *g, packed_t x, packed_t y) {
    num_t dx = distance(x, g->first_x), dy = distance(y, g->first_y);
    bool x_stays = within(dx, num_ldexp(dy, NEARLY_SAME_SHIFT)), y_stays = within(dy, num_ldexp(dx, NEARLY_SAME_SHIFT));
    if (x_stays == y_stays) return false; /* both: a repeated point */
    g->inner_is_x = y_stays;
    g->oriented = true;
    g->inner[-1] = y_stays ? g->first_x : g->first_y;
    packed_t first = g->inner[-1], second = y_stays ? x : y;
    g->inner_down = num_cmp(packed_num(second), packed_num(first)) < 0;
    g->tolerance = num_ldexp(distance(first, second), TOLERANCE_SHIFT);
    return true;
}

static bool same(const data_grid_t *g, packed_t a, packed_t b) {
    return a == b || within(distance(a, b), g->tolerance);
}

/* Does the sequence go on in its direction from a to b? */
static bool goes_on(packed_t a, packed_t b, bool down) {
    int sign = num_cmp(packed_num(b), packed_num(a));
    return down ? sign < 0 : sign > 0;
}

static int first_of_block(data_grid_t *g, packed_t x, packed_t y, enum data_grid_trouble *trouble) {
    g->first_x = x;
    g->first_y = y;
    if (g->outer_n == 0) /* room for an inner coordinate; orient() decides which */
        return take_coordinate(g, x) ? 0 : refuse(DATA_FULL, trouble);
    packed_t inner = g->inner_is_x ? x : y, outer = g->inner_is_x ? y : x;
    if (!same(g, inner, g->inner[-1])) return refuse(DATA_OFF_GRID, trouble);
    packed_t before = g->outer[-g->outer_n];
    if (g->outer_n == 1) g->outer_down = num_cmp(packed_num(outer), packed_num(before)) < 0;
    if (!goes_on(before, outer, g->outer_down)) return refuse(DATA_TURNS, trouble);
    return take_coordinate(g, outer) ? 0 : refuse(DATA_FULL, trouble);
}

static int next_of_block(data_grid_t *g, packed_t x, packed_t y, enum data_grid_trouble *trouble) {
    if (!g->oriented && !orient(g, x, y)) return refuse(DATA_NO_GRID, trouble);
    packed_t inner = g->inner_is_x ? x : y, outer = g->inner_is_x ? y : x;
    packed_t stays = g->inner_is_x ? g->first_y : g->first_x;
    if (outer != stays) {
        /* The step between blocks is not known in the first one: measure by the inner step, then by the value. */
        num_t d = distance(outer, stays);
        if (!within(d, g->tolerance) && !within(d, num_ldexp(num_abs(packed_num(stays)), NEARLY_SAME_SHIFT)))
            return refuse(DATA_NO_GRID, trouble);
    }
    if (g->outer_n == 0) {
        if (!goes_on(g->inner[-g->at], inner, g->inner_down)) return refuse(DATA_TURNS, trouble);
        return take_coordinate(g, inner) ? 0 : refuse(DATA_FULL, trouble);
    }
    if (g->at >= g->inner_n) return refuse(DATA_RAGGED, trouble);
    if (!same(g, inner, g->inner[-1 - g->at])) return refuse(DATA_OFF_GRID, trouble);
    return 0;
}

/* A file without blank lines: the first isoline is over where its first inner coordinate comes again. */
static bool begins_again(const data_grid_t *g, packed_t x, packed_t y) {
    if (!g->oriented || g->at < 2) return false;
    if (g->outer_n > 0 && g->at != g->inner_n) return false;
    packed_t inner = g->inner_is_x ? x : y, outer = g->inner_is_x ? y : x;
    return outer != (g->inner_is_x ? g->first_y : g->first_x) && same(g, inner, g->inner[-1]);
}

int data_grid_point(data_grid_t *g, num_t x, num_t y, num_t z, enum data_grid_trouble *trouble) {
    packed_t px = packed_from_num(x), py = packed_from_num(y);
    if (px == PACKED_HOLE || py == PACKED_HOLE) return refuse(DATA_NO_PLACE, trouble);
    if (begins_again(g, px, py)) {
        int err = data_grid_break(g, trouble);
        if (err) return err;
    }
    int err = g->at == 0 ? first_of_block(g, px, py, trouble) : next_of_block(g, px, py, trouble);
    if (err) return err;
    data_pool_t *pool = g->pool;
    if (pool->low >= pool->high) return refuse(DATA_FULL, trouble);
    pool->base[pool->low++] = packed_from_num(z);
    g->at++;
    return 0;
}

int data_grid_break(data_grid_t *g, enum data_grid_trouble *trouble) {
    if (g->at == 0) return 0;
    if (g->outer_n == 0) {
        if (g->at < 2) return refuse(DATA_TOO_SMALL, trouble);
        g->inner_n = g->at;
        g->outer = g->inner - g->inner_n;
        if (!take_coordinate(g, g->inner_is_x ? g->first_y : g->first_x)) return refuse(DATA_FULL, trouble);
    } else if (g->at != g->inner_n) {
        return refuse(DATA_RAGGED, trouble);
    }
    g->outer_n++;
    g->at = 0;
    return 0;
}

int data_grid_finish(data_grid_t *g, enum data_grid_trouble *trouble) {
    int err = data_grid_break(g, trouble);
    if (err) return err;
    return g->outer_n < 2 ? refuse(DATA_TOO_SMALL, trouble) : 0;
}

num_t data_view_x(const data_view_t *v, int32_t i) {
    return packed_num(v->x[(int64_t)i * v->x_step]);
}

num_t data_view_y(const data_view_t *v, int32_t j) {
    return packed_num(v->y[(int64_t)j * v->y_step]);
}

num_t data_view_z(const data_view_t *v, int32_t i, int32_t j) {
    return packed_num(v->z[i * v->step_i + j * v->step_j]);
}

static num_t x_of(void *ctx, int32_t i) {
    return data_view_x(ctx, i);
}

static num_t y_of(void *ctx, int32_t j) {
    return data_view_y(ctx, j);
}

static num_t z_of(void *ctx, int32_t i, int32_t j) {
    return data_view_z(ctx, i, j);
}

/* Narrows the n increasing coordinates c[0], c[step], ... to those in lim: the first of them, and how many in *n. */
static int32_t crop(const packed_t *c, int32_t step, const num_t *lim, int32_t *n) {
    if (!lim) return 0;
    int32_t first = 0, end = *n;
    while (first < end && num_cmp(packed_num(c[(int64_t)first * step]), lim[0]) < 0) first++;
    while (end > first && num_cmp(packed_num(c[(int64_t)(end - 1) * step]), lim[1]) > 0) end--;
    *n = end - first;
    return first;
}

int data_grid_surface(const data_grid_t *g, const num_t *x_lim, const num_t *y_lim, data_view_t *v, surface_t *out) {
    /* Coordinates lie downwards in memory: the k-th is at [-1 - k]. Increasing ones have step -1. */
    const packed_t *inner = g->inner_down ? g->inner - g->inner_n : g->inner - 1;
    const packed_t *outer = g->outer_down ? g->outer - g->outer_n : g->outer - 1;
    int32_t inner_step = g->inner_down ? 1 : -1, outer_step = g->outer_down ? 1 : -1;
    int32_t inner_n = g->inner_n, outer_n = g->outer_n;
    int32_t inner_first = crop(inner, inner_step, g->inner_is_x ? x_lim : y_lim, &inner_n);
    int32_t outer_first = crop(outer, outer_step, g->inner_is_x ? y_lim : x_lim, &outer_n);
    if (inner_n < 2 || outer_n < 2) return ERR_EMPTY;
    int64_t z_inner = g->inner_down ? -1 : 1, z_outer = g->outer_down ? -(int64_t)g->inner_n : g->inner_n;
    const packed_t *z = g->z;
    if (g->inner_down) z += g->inner_n - 1;
    if (g->outer_down) z += (int64_t)(g->outer_n - 1) * g->inner_n;
    z += inner_first * z_inner + outer_first * z_outer;
    inner += (int64_t)inner_first * inner_step;
    outer += (int64_t)outer_first * outer_step;
    *v = g->inner_is_x ? (data_view_t){g, z, z_inner, z_outer, inner, outer, inner_step, outer_step}
                       : (data_view_t){g, z, z_outer, z_inner, outer, inner, outer_step, inner_step};
    *out = (surface_t){.ctx = v, .x_of = x_of, .y_of = y_of, .z_of = z_of};
    out->nx = g->inner_is_x ? inner_n : outer_n;
    out->ny = g->inner_is_x ? outer_n : inner_n;
    return 0;
}
