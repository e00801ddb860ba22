/* profiles_cache.c - see profiles_cache.h. */
#include "scene/profiles_cache.h"

static int32_t points(void *ctx, int32_t k) {
    const profiles_cache_t *c = ctx;
    return c->first[k + 1] - c->first[k];
}

static void point(void *ctx, int32_t k, int32_t v, num_t xyz[3]) {
    const profiles_cache_t *c = ctx;
    const num_t *at = c->xyz + (size_t)(c->first[k] + v) * 3;
    for (int axis = 0; axis < 3; axis++) xyz[axis] = at[axis];
}

size_t profiles_cache_fill(profiles_cache_t *c, profiles_t *p, void *mem, size_t bytes,
                           void (*tick)(void *ctx, int32_t done, int32_t of), void *tick_ctx) {
    const size_t vertex_bytes = 3 * sizeof(num_t);
    size_t head = (((size_t)p->count + 1) * sizeof(int32_t) + 15) & ~(size_t)15;
    if (head > bytes) return 0;
    c->first = mem;
    c->xyz = (num_t *)((uint8_t *)mem + head);
    size_t room = (bytes - head) / vertex_bytes, used = 0;
    for (int32_t k = 0; k < p->count; k++) {
        int32_t n = p->points(p->ctx, k);
        c->first[k] = (int32_t)used;
        if (tick) tick(tick_ctx, k, p->count);
        if ((size_t)n > room - used) return 0;
        for (int32_t v = 0; v < n; v++) p->point(p->ctx, k, v, c->xyz + 3 * used++);
    }
    c->first[p->count] = (int32_t)used;
    p->ctx = c;
    p->points = points;
    p->point = point;
    return head + used * vertex_bytes;
}
