/* data_curve.c - pairs of packed numbers. */
#include "scene/data_curve.h"
#include "error.h"

void data_curve_start(data_curve_t *c, data_pool_t *pool) {
    *c = (data_curve_t){.pool = pool, .point = (packed_t(*)[2])(void *)(pool->base + pool->low)};
}

static int append(data_curve_t *c, packed_t x, packed_t y) {
    if (c->pool->high - c->pool->low < 2 || c->n == INT32_MAX) return ERR_FULL;
    c->point[c->n][0] = x;
    c->point[c->n][1] = y;
    c->n++;
    c->pool->low += 2;
    return 0;
}

int data_curve_gap(data_curve_t *c) {
    if (c->n == 0 || c->point[c->n - 1][1] == PACKED_HOLE) return 0;
    return append(c, c->point[c->n - 1][0], PACKED_HOLE);
}

int data_curve_point(data_curve_t *c, num_t x, num_t y) {
    packed_t px = packed_from_num(x), py = packed_from_num(y);
    if (px == PACKED_HOLE || py == PACKED_HOLE) return data_curve_gap(c);
    c->any = true;
    return append(c, px, py);
}

int data_curve_finish(data_curve_t *c) {
    if (!c->any) return ERR_EMPTY;
    if (c->n == 1) return data_curve_gap(c); /* a curve has two points */
    if (c->n > 2 && c->point[c->n - 1][1] == PACKED_HOLE) {
        c->n--;
        c->pool->low -= 2;
    }
    return 0;
}

static num_t x_of(void *ctx, int32_t i) {
    const data_curve_t *c = ctx;
    return packed_num(c->point[i][0]);
}

static num_t y_of(void *ctx, int32_t i) {
    const data_curve_t *c = ctx;
    return packed_num(c->point[i][1]);
}

void data_curve_get(data_curve_t *c, curve_t *out, num_t extent[2]) {
    *out = (curve_t){c->n, c, x_of, y_of};
    if (!extent) return;
    extent[0] = extent[1] = packed_num(c->point[0][0]);
    for (int32_t i = 1; i < c->n; i++) {
        num_t x = packed_num(c->point[i][0]);
        if (num_cmp(x, extent[0]) < 0) extent[0] = x;
        if (num_cmp(x, extent[1]) > 0) extent[1] = x;
    }
}
