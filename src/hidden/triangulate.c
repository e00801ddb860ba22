/* triangulate.c - see triangulate.h. In the plane of the two axes that the normal leans on least; signs are exact. */
#include "hidden/triangulate.h"

#include "error.h"

typedef struct flat {
    const solid_t *s;
    int u, v; /* axes, in the order that makes the polygon run counter-clockwise */
} flat_t;

static int64_t turn(const flat_t *f, int32_t a, int32_t b, int32_t c) {
    const int32_t *p = f->s->vertex[a].at, *q = f->s->vertex[b].at, *r = f->s->vertex[c].at;
    return (int64_t)(q[f->u] - p[f->u]) * (r[f->v] - p[f->v]) - (int64_t)(q[f->v] - p[f->v]) * (r[f->u] - p[f->u]);
}

static bool is_within(const flat_t *f, int32_t a, int32_t b, int32_t c, int32_t p) {
    return turn(f, a, b, p) >= 0 && turn(f, b, c, p) >= 0 && turn(f, c, a, p) >= 0;
}

/* May the corner at k be cut off? strict: not if it is flat. */
static bool is_ear(const flat_t *f, const int32_t *c, int32_t n, int32_t k) {
    int32_t a = c[k ? k - 1 : n - 1], b = c[k], d = c[k + 1 < n ? k + 1 : 0];
    if (turn(f, a, b, d) <= 0) return false;
    for (int32_t i = 0; i < n; i++) {
        int32_t p = c[i];
        if (p != a && p != b && p != d && is_within(f, a, b, d, p)) return false;
    }
    return true;
}

int triangulate(const solid_t *s, int32_t face, const solid_normal_t *normal, void *mem, size_t bytes,
                void (*take)(void *ctx, const int32_t v[3]), void *ctx) {
    int32_t n = s->face[face].n, *c = mem;
    if (bytes / sizeof *c < (size_t)n) return ERR_FULL;
    int axis = 0;
    for (int k = 1; k < 3; k++)
        if (solid_abs(normal->n[k]) > solid_abs(normal->n[axis])) axis = k;
    flat_t f = {s, (axis + 1) % 3, (axis + 2) % 3};
    if (normal->n[axis] < 0) f = (flat_t){s, (axis + 2) % 3, (axis + 1) % 3};
    for (int32_t k = 0; k < n; k++) c[k] = s->corner[s->face[face].corner + k];
    int32_t k = 0;
    for (int32_t tried = 0; n > 3; k++) {
        if (k >= n) k = 0;
        /* A polygon that crosses itself may have no ear: then any corner will do. */
        if (tried < n && !is_ear(&f, c, n, k)) {
            tried++;
            continue;
        }
        const int32_t v[3] = {c[k ? k - 1 : n - 1], c[k], c[k + 1 < n ? k + 1 : 0]};
        take(ctx, v);
        for (int32_t i = k; i + 1 < n; i++) c[i] = c[i + 1];
        n--;
        tried = 0;
    }
    take(ctx, c);
    return 0;
}
