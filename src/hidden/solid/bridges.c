/* bridges.c - see bridges.h. The chain is v0 ... v0 h0 ... h0 v0 g0 ... g0: the outline, and for each hole a block that
 * begins with v0. Blocks are moved into the outline one by one, each behind a corner that sees one of the hole's. */
#include "hidden/solid/bridges.h"

#include "config.h"
#include <string.h>

flat_t flat_of(const solid_t *s, const solid_normal_t *normal) {
    int axis = 0;
    for (int k = 1; k < 3; k++)
        if (solid_abs(normal->n[k]) > solid_abs(normal->n[axis])) axis = k;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    return normal->n[axis] < 0 ? (flat_t){s, v, u, 0} : (flat_t){s, u, v, 0};
}

int flat_turn(void *ctx, int32_t a, int32_t b, int32_t c) {
    const flat_t *f = ctx;
    const int32_t *p = f->s->vertex[a].at, *q = f->s->vertex[b].at, *r = f->s->vertex[c].at;
    const int64_t x = q[f->u] - p[f->u], y = q[f->v] - p[f->v];
    const int64_t t = x * (r[f->v] - p[f->v]) - y * (r[f->u] - p[f->u]);
    const int64_t on = f->slack * (int64_t)(solid_abs(x) + solid_abs(y));
    return (t > on) - (t < -on);
}

int64_t flat_dot(const flat_t *f, int32_t a, int32_t b, int32_t c) {
    const int32_t *p = f->s->vertex[a].at, *q = f->s->vertex[b].at, *r = f->s->vertex[c].at;
    return (int64_t)(p[f->u] - q[f->u]) * (r[f->u] - q[f->u]) + (int64_t)(p[f->v] - q[f->v]) * (r[f->v] - q[f->v]);
}

static bool is_same(const flat_t *f, int32_t a, int32_t b) {
    const int32_t *p = f->s->vertex[a].at, *q = f->s->vertex[b].at;
    return p[f->u] == q[f->u] && p[f->v] == q[f->v];
}

/* Does the edge from x to y, or x itself, lie across the way from p to q? */
static bool is_across(flat_t *f, int32_t x, int32_t y, int32_t p, int32_t q) {
    const int side = flat_turn(f, p, q, x);
    if (side == 0) return flat_dot(f, p, x, q) < 0;
    return side * flat_turn(f, p, q, y) < 0 && flat_turn(f, x, y, p) * flat_turn(f, x, y, q) < 0;
}

/* Does the way from p, which lies between a and b on a contour, to q begin on the inside, to the left of it? */
static bool starts_inside(flat_t *f, int32_t a, int32_t p, int32_t b, int32_t q) {
    const bool behind_a = flat_turn(f, a, p, q) > 0, before_b = flat_turn(f, p, b, q) > 0;
    return flat_turn(f, a, p, b) > 0 ? behind_a && before_b : behind_a || before_b;
}

/* The corners [from, to) of a closed contour. */
typedef struct contour {
    int32_t *c, from, to;
} contour_t;

static int32_t before(const contour_t *k, int32_t at) {
    return k->c[at > k->from ? at - 1 : k->to - 1];
}
static int32_t behind(const contour_t *k, int32_t at) {
    return k->c[at + 1 < k->to ? at + 1 : k->from];
}

static bool is_in_way(flat_t *f, const contour_t *k, int32_t p, int32_t q) {
    for (int32_t i = k->from; i < k->to; i++)
        if (is_across(f, k->c[i], behind(k, i), p, q)) return true;
    return false;
}

/* Does the corner at h of a hole lie in a corner of k? Or on an edge, and the hole behind that, as an island in k? */
static bool is_at(flat_t *f, const contour_t *k, const contour_t *hole, int32_t h) {
    for (int32_t i = k->from; i < k->to; i++) {
        const int32_t x = k->c[i], y = behind(k, i), q = hole->c[h];
        if (is_same(f, x, q)) return true;
        if (flat_turn(f, x, y, q) == 0 && flat_dot(f, x, q, y) < 0 && flat_turn(f, x, y, before(hole, h)) <= 0 &&
            flat_turn(f, x, y, behind(hole, h)) <= 0)
            return true;
    }
    return false;
}

/* Where the block at b ends; b + 1 if it is none: a hole that touches v0 itself, or no hole. */
static int32_t block_end(const int32_t *c, int32_t b, int32_t n) {
    for (int32_t k = b + 2; k < n; k++)
        if (c[k] == c[b + 1]) return k + 1;
    return b + 1;
}

static void reverse(int32_t *c, int32_t n) {
    for (int32_t i = 0, j = n - 1; i < j; i++, j--) {
        const int32_t swap = c[i];
        c[i] = c[j];
        c[j] = swap;
    }
}

/* What is at `by` comes first. */
static void rotate(int32_t *c, int32_t n, int32_t by) {
    reverse(c, by);
    reverse(c + by, n - by);
    reverse(c, n);
}

/* Does the corner at p, of the outline of `done` corners, see the one at h of the hole of the block [b, end)? Where the
 * two are one place, the hole must be inside of the outline there. */
static bool sees(flat_t *f, int32_t *c, int32_t done, int32_t n, int32_t b, int32_t end, int32_t p, int32_t h) {
    const contour_t outline = {c, 0, done}, hole = {c, b + 1, end - 1};
    const int32_t around[2] = {before(&outline, p), behind(&outline, p)};
    if (is_same(f, c[p], c[h]))
        return starts_inside(f, around[0], c[p], around[1], before(&hole, h)) &&
               starts_inside(f, around[0], c[p], around[1], behind(&hole, h));
    if (!starts_inside(f, around[0], c[p], around[1], c[h]) ||
        !starts_inside(f, before(&hole, h), c[h], behind(&hole, h), c[p]) || is_in_way(f, &outline, c[p], c[h]) ||
        is_at(f, &outline, &hole, h))
        return false;
    for (int32_t k = done, to; k < n; k = to) {
        to = block_end(c, k, n);
        const contour_t other = {c, k + 1, to - 1};
        if (is_in_way(f, &other, c[p], c[h]) || (k != b && is_at(f, &other, &hole, h))) return false;
    }
    return true;
}

/* Moves a block, of which the corner at h shall be the first, behind the corner at p. */
static void join(int32_t *c, int32_t b, int32_t end, int32_t p, int32_t h) {
    const int32_t hole = end - b - 2;
    rotate(c + b + 1, hole, h - b - 1);
    memmove(c + b, c + b + 1, (size_t)hole * sizeof *c);
    c[end - 2] = c[b];
    c[end - 1] = c[p];
    rotate(c + p + 1, end - p - 1, b - p - 1);
}

/* Finds a hole that a corner of the outline sees, and joins it. Returns the outline's corners then: no more if there is
 * none. */
static int32_t join_one(flat_t *f, int32_t *c, int32_t done, int32_t n) {
    for (int32_t b = done, end; b < n; b = end) {
        end = block_end(c, b, n);
        if (end < b + 5) return b == done ? end : done;
        for (int32_t p = 0; p < done; p++)
            for (int32_t h = b + 1; h < end - 1; h++)
                if (sees(f, c, done, n, b, end, p, h)) {
                    join(c, b, end, p, h);
                    return done + end - b;
                }
    }
    return done;
}

static int32_t times(const int32_t *c, int32_t n, int32_t v) {
    int32_t count = 0;
    for (int32_t k = 0; k < n; k++) count += c[k] == v;
    return count;
}

int32_t bridges_lay(flat_t *f, int32_t face, int32_t *c) {
    const int32_t n = f->s->face[face].n;
    memcpy(c, f->s->corner + f->s->face[face].corner, (size_t)n * sizeof *c);
    const int32_t last = times(c, n, c[n - 1]), first = times(c, n, c[0]);
    if (!CONFIG_HOLES || first < 2) return n;
    int32_t done = n - 1;
    if (last > first) { /* turned round: v0 is at the end, and the outline behind the last hole */
        while (c[done - 1] != c[n - 1]) done--;
        rotate(c, n, done - 1);
    }
    for (done = 1; c[done] != c[0];) done++;
    for (int32_t more; (more = join_one(f, c, done, n)) > done;) done = more;
    return done;
}

int32_t bridges_island(int32_t *c, int32_t from, int32_t n) {
    const int32_t end = block_end(c, from, n);
    if (end < from + 5) return n;
    reverse(c + from + 1, end - from - 2);
    return end;
}
