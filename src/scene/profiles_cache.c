/* profiles_cache.c - see profiles_cache.h. */
#include "scene/profiles_cache.h"

static num_t *vertex_of(const profiles_cache_t *c, int32_t k, int32_t v) {
    return c->xyz + ((size_t)k * (size_t)c->src.max_points + (size_t)v) * 3;
}

static int32_t points(void *ctx, int32_t k) {
    const profiles_cache_t *c = ctx;
    return c->src.points(c->src.ctx, k);
}

static void point(void *ctx, int32_t k, int32_t v, num_t xyz[3]) {
    const num_t *at = vertex_of(ctx, k, v);
    for (int axis = 0; axis < 3; axis++) xyz[axis] = at[axis];
}

void profiles_cache_fill(profiles_cache_t *c, profiles_t *p, void *mem) {
    c->src = *p;
    c->xyz = mem;
    for (int32_t k = 0; k < p->count; k++) {
        int32_t n = p->points(p->ctx, k);
        for (int32_t v = 0; v < n; v++) p->point(p->ctx, k, v, vertex_of(c, k, v));
    }
    p->ctx = c;
    p->points = points;
    p->point = point;
}
