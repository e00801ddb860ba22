/* emit.c - from runs back to points. See emit.h. */
#include "path/emit.h"
#include "path/dist.h"

/* Walks the vertices of a stroke: end, whole parameters between, end, next run. */
typedef struct walk {
    const pool_t *pool;
    const page_point_t *point; /* of the ends, or NULL */
    int32_t end;               /* where the present run is entered, or negative at the end of the stroke */
    int64_t t, last;
    bool started;
} walk_t;

static void enter(walk_t *w, int32_t end) {
    w->end = end;
    w->started = false;
    if (end < 0) return;
    w->t = pool_end_t(w->pool, end);
    w->last = pool_end_t(w->pool, pool_other_end(end));
}

/* The next vertex; false at the end of the stroke. */
static bool next(walk_t *w, const ink_map_t *map, page_point_t *p, bool *known) {
    if (w->started && w->t == w->last) enter(w, w->pool->mate[pool_other_end(w->end)]);
    if (w->end < 0) return false;
    if (w->started) w->t = ink_next(run_family(&w->pool->run[w->end >> 1]), w->t, w->last);
    if (w->point && (!w->started || w->t == w->last)) {
        *p = w->point[w->started ? pool_other_end(w->end) : w->end];
        w->started = *known = true;
        return true;
    }
    w->started = true;
    const run_t *r = &w->pool->run[w->end >> 1];
    *known = map->point(map->ctx, run_family(r), run_surface(r), run_line(r), w->t, p);
    return true;
}

int emit_plain(const page_point_t *point, int32_t start, simplify_t *out, int64_t *vertices) {
    *vertices += 2;
    return simplify_line(out, point[start], point[pool_other_end(start)]);
}

int emit_stroke(pool_t *pool, const ink_map_t *map, const page_point_t *point, int32_t start, simplify_t *out,
                int64_t *vertices) {
    if (CONFIG_64BIT && point && pool->mate[pool_other_end(start)] < 0 && run_is_plain(&pool->run[start >> 1])) {
        pool->run[start >> 1].to_hi |= RUN_DRAWN;
        return emit_plain(point, start, out, vertices);
    }
    walk_t w = {.pool = pool, .point = point};
    page_point_t p;
    bool known, begun = false;
    enter(&w, start);
    while (next(&w, map, &p, &known)) {
        pool->run[w.end >> 1].to_hi |= RUN_DRAWN;
        ++*vertices;
        if (!known) continue;
        int err = begun ? simplify_draw(out, p) : simplify_move(out, p);
        if (err) return err;
        begun = true;
    }
    return simplify_finish(out);
}

void emit_drop(pool_t *pool, int32_t start) {
    for (int32_t e = start; e >= 0; e = pool->mate[pool_other_end(e)]) pool->run[e >> 1].to_hi |= RUN_DRAWN;
}

bool emit_is_dot(const pool_t *pool, const ink_map_t *map, const page_point_t *point, int32_t start, int32_t dot_lat) {
    walk_t w = {.pool = pool, .point = point};
    page_point_t p, last;
    uint32_t length = 0;
    bool known, begun = false;
    enter(&w, start);
    while (next(&w, map, &p, &known)) {
        if (!known) continue;
        if (begun) length += dist_between(last, p);
        if (length >= (uint32_t)dot_lat) return false;
        last = p;
        begun = true;
    }
    return true;
}
