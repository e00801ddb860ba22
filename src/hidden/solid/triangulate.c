/* triangulate.c - see triangulate.h. In the plane of the two axes that the normal leans on least, or as it is seen;
 * signs are exact. */
#include "hidden/solid/triangulate.h"

#include "error.h"
#include <string.h>

/* The corners of what is left, and what tells left from right. */
typedef struct rest {
    int32_t *c, n;
    triangle_turn_t *turn;
    void *ctx;
} rest_t;

static int turn_at(const rest_t *r, int32_t a, int32_t b, int32_t c) {
    return r->turn(r->ctx, a, b, c);
}

static bool is_within(const rest_t *r, int32_t a, int32_t b, int32_t c, int32_t p) {
    return turn_at(r, a, b, p) >= 0 && turn_at(r, b, c, p) >= 0 && turn_at(r, c, a, p) >= 0;
}

static void corner(const rest_t *r, int32_t k, int32_t v[3]) {
    v[0] = r->c[k ? k - 1 : r->n - 1];
    v[1] = r->c[k];
    v[2] = r->c[k + 1 < r->n ? k + 1 : 0];
}

/* May the corner at k be cut off? Not if it is flat. */
static bool is_ear(const rest_t *r, int32_t k) {
    int32_t v[3];
    corner(r, k, v);
    if (turn_at(r, v[0], v[1], v[2]) <= 0) return false;
    for (int32_t i = 0; i < r->n; i++) {
        int32_t p = r->c[i];
        if (p != v[0] && p != v[1] && p != v[2] && is_within(r, v[0], v[1], v[2], p)) return false;
    }
    return true;
}

/* Cuts ears off while there are any; true if that is all of it. anyhow: then any corner will do. */
static bool cut_ears(rest_t *r, bool anyhow, void (*take)(void *ctx, const int32_t v[3]), void *ctx) {
    int32_t k = 0, v[3];
    for (int32_t tried = 0; r->n > 3; k++) {
        if (k >= r->n) k = 0;
        if (tried == r->n && !anyhow) return false;
        if (tried < r->n && !is_ear(r, k)) {
            tried++;
            continue;
        }
        corner(r, k, v);
        if (take) take(ctx, v);
        for (int32_t i = k; i + 1 < r->n; i++) r->c[i] = r->c[i + 1];
        r->n--;
        tried = 0;
    }
    if (take) take(ctx, r->c);
    return anyhow || turn_at(r, r->c[0], r->c[1], r->c[2]) > 0;
}

static void start(rest_t *r, const solid_t *s, int32_t face) {
    r->n = s->face[face].n;
    memcpy(r->c, s->corner + s->face[face].corner, (size_t)r->n * sizeof *r->c);
}

typedef struct flat {
    const solid_t *s;
    int u, v; /* axes, in the order that makes the polygon run counter-clockwise */
} flat_t;

static int flat_turn(void *ctx, int32_t a, int32_t b, int32_t c) {
    const flat_t *f = ctx;
    const int32_t *p = f->s->vertex[a].at, *q = f->s->vertex[b].at, *r = f->s->vertex[c].at;
    const int64_t t =
        (int64_t)(q[f->u] - p[f->u]) * (r[f->v] - p[f->v]) - (int64_t)(q[f->v] - p[f->v]) * (r[f->u] - p[f->u]);
    return (t > 0) - (t < 0);
}

int triangulate(const solid_t *s, int32_t face, const solid_normal_t *normal, void *mem, size_t bytes,
                void (*take)(void *ctx, const int32_t v[3]), void *ctx) {
    if (bytes / sizeof(int32_t) < (size_t)s->face[face].n) return ERR_FULL;
    int axis = 0;
    for (int k = 1; k < 3; k++)
        if (solid_abs(normal->n[k]) > solid_abs(normal->n[axis])) axis = k;
    flat_t f = {s, (axis + 1) % 3, (axis + 2) % 3};
    if (normal->n[axis] < 0) f = (flat_t){s, (axis + 2) % 3, (axis + 1) % 3};
    rest_t rest = {mem, 0, flat_turn, &f};
    start(&rest, s, face);
    cut_ears(&rest, true, take, ctx);
    return 0;
}

int triangulate_seen(const solid_t *s, int32_t face, triangle_turn_t *turn, void *mem, size_t bytes,
                     void (*take)(void *ctx, const int32_t v[3]), void *ctx) {
    if (bytes / sizeof(int32_t) < (size_t)s->face[face].n) return ERR_FULL;
    rest_t rest = {mem, 0, turn, ctx};
    start(&rest, s, face);
    if (!cut_ears(&rest, false, NULL, NULL)) return 1;
    start(&rest, s, face);
    cut_ears(&rest, false, take, ctx);
    return 0;
}
