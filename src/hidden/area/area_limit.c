/* area_limit.c - see area_limit.h. */
#include "hidden/area/area_limit.h"

#include "error.h"
#include "num/ints.h"

#if CONFIG_AREA

void area_limit_init(area_limit_t *l, const area_box_t *box, int32_t tag, clip_out_t *out) {
    *l = (area_limit_t){.box = *box, .tag = tag, .out = out, .begun = out->n};
}

static int32_t border_at(const area_limit_t *l, int32_t border) {
    const int32_t at[AREA_LIMIT_BORDERS] = {l->box.x0, l->box.x1, l->box.y0, l->box.y1};
    return at[border];
}

static bool is_inside(const area_limit_t *l, int32_t border, const poly_point_t *p) {
    const int32_t c = border < 2 ? p->x : p->y, at = border_at(l, border);
    return border & 1 ? c <= at : c >= at;
}

/* Where the line through a and b, which are on different sides, crosses the border: counted from the lower one. */
static poly_point_t crossing(const area_limit_t *l, int32_t border, const poly_point_t *a, const poly_point_t *b) {
    const int64_t at = border_at(l, border);
    const bool x = border < 2;
    if (x ? a->x > b->x : a->y > b->y) {
        const poly_point_t *swap = a;
        a = b;
        b = swap;
    }
    const int64_t dx = (int64_t)b->x - a->x, dy = (int64_t)b->y - a->y;
    if (x) return (poly_point_t){(int32_t)at, a->y + (int32_t)ints_muldiv_round(dy, at - a->x, dx)};
    return (poly_point_t){a->x + (int32_t)ints_muldiv_round(dx, at - a->y, dy), (int32_t)at};
}

/* Are three points on one line along an axis? What lies in the middle, or beyond, bounds nothing. */
static bool is_spur(poly_point_t a, poly_point_t b, poly_point_t c) {
    return (a.x == b.x && b.x == c.x) || (a.y == b.y && b.y == c.y);
}

static int write(area_limit_t *l, const poly_point_t *p) {
    clip_out_t *out = l->out;
    poly_vertex_t *v = out->v;
    while (out->n > l->begun && (poly_same(v[out->n - 1].at, *p) ||
                                 (out->n - l->begun >= 2 && is_spur(v[out->n - 2].at, v[out->n - 1].at, *p))))
        out->n--;
    if (out->n == out->n_max) return ERR_FULL;
    v[out->n++] = (poly_vertex_t){*p, l->tag};
    return 0;
}

REENTRANT(area_limit_t, poly_point_t, AREA_LIMIT_BORDERS)

int area_limit_put(area_limit_t *l, poly_point_t at) {
    return put(l, 0, at);
}

int area_limit_close(area_limit_t *l) {
    clip_out_t *out = l->out;
    const int err = put_end(l, 0);
    if (err) return err;
    while (out->n > l->begun && poly_same(out->v[out->n - 1].at, out->v[l->begun].at)) out->n--;
    if (out->n - l->begun < 3) {
        out->n = l->begun;
        return 0;
    }
    if (out->contours == out->contours_max) return ERR_FULL;
    out->end[out->contours++] = l->begun = out->n;
    return 0;
}

#endif
