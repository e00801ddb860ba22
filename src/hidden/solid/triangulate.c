/* triangulate.c - see triangulate.h. In the plane of the two axes that the normal leans on least, or as it is seen;
 * signs are exact. */
#include "hidden/solid/triangulate.h"

#include "config.h"
#include "error.h"
#include "hidden/solid/bridges.h"

/* The corners of what is left, and what tells left from right. */
typedef struct rest {
    int32_t *c, n;
    triangle_turn_t *turn;
    void *ctx;
    flat_t *flat; /* NULL: as it is seen */
    bool slivers;
} rest_t;

static int turn_at(const rest_t *r, int32_t a, int32_t b, int32_t c) {
    return r->turn(r->ctx, a, b, c);
}

static void corner(const rest_t *r, int32_t k, int32_t v[3]) {
    v[0] = r->c[k ? k - 1 : r->n - 1];
    v[1] = r->c[k];
    v[2] = r->c[k + 1 < r->n ? k + 1 : 0];
}

/* The sides of v's edges that p is not inside of, a bit each. */
static int beyond(const rest_t *r, const int32_t v[3], int32_t p) {
    int out = 0;
    for (int k = 0; k < 3; k++)
        if (turn_at(r, v[k], v[k < 2 ? k + 1 : 0], p) <= 0) out |= 1 << k;
    return out;
}

/* Are all of v on one side of the line from p to q, or on it? */
static bool is_passed(const rest_t *r, const int32_t v[3], int32_t p, int32_t q) {
    int side = 0;
    for (int k = 0; k < 3; k++) {
        const int turn = turn_at(r, p, q, v[k]);
        if (turn * side < 0) return false;
        side |= turn;
    }
    return true;
}

/* May the corner v be cut off? It must turn left, and no edge may pass through what is cut off: one that passes along
 * its border or ends there is in nobody's way, so holes may touch. A line apart from both is one of their own. */
static bool is_ear(const rest_t *r, const int32_t v[3]) {
    if (turn_at(r, v[0], v[1], v[2]) <= 0) return false;
    int32_t p = r->c[r->n - 1];
    int at_p = beyond(r, v, p);
    for (int32_t i = 0; i < r->n; i++) {
        const int32_t q = r->c[i];
        const int at_q = beyond(r, v, q);
        if (!(at_p & at_q) && !is_passed(r, v, p, q)) return false;
        p = q;
        at_p = at_q;
    }
    return true;
}

/* Does the border turn back at the corner v? Then it is gone along both ways there, and what is beyond is nothing. */
static bool is_spike(const rest_t *r, const int32_t v[3]) {
    return v[0] == v[2] || (r->flat && turn_at(r, v[0], v[1], v[2]) == 0 && flat_dot(r->flat, v[0], v[1], v[2]) > 0);
}

/* Has the corner v, which is straight or turns back, a width in space? */
static bool is_sliver(const rest_t *r, const int32_t v[3]) {
    if (!r->slivers) return false;
    const solid_vertex_t *at = r->flat->s->vertex, *p = &at[v[0]];
    const solid_normal_t n = solid_cross(solid_sub(&at[v[1]], p), solid_sub(&at[v[2]], p));
    return (n.n[0] | n.n[1] | n.n[2]) != 0;
}

/* The next corner from k on that may be cut off: a spike, or else an ear, or else what is straight; -1: none. */
static int32_t find_corner(const rest_t *r, int32_t k) {
    enum { SPIKE, EAR, STRAIGHT };
    int32_t v[3];
    for (int what = CONFIG_HOLES ? SPIKE : EAR; what <= STRAIGHT; what++)
        for (int32_t tried = 0; tried < r->n; tried++, k = k + 1 < r->n ? k + 1 : 0) {
            corner(r, k, v);
            if (what == SPIKE ? is_spike(r, v) : what == EAR ? is_ear(r, v) : turn_at(r, v[0], v[1], v[2]) == 0)
                return k;
        }
    return -1;
}

/* Cuts corners off, with `anyhow` also those of a border that crosses itself; true if that is all of it. */
static bool cut_ears(rest_t *r, bool anyhow, void (*take)(void *ctx, const int32_t v[3]), void *ctx) {
    int32_t k = 0, v[3];
    for (; r->n >= 3; k++) {
        const int32_t from = k < r->n ? k : 0;
        k = find_corner(r, from);
        if (k < 0 && CONFIG_HOLES && r->flat && r->flat->slack == 0) { /* what touches may be rounded into each other */
            r->flat->slack = FLAT_SLACK;
            continue;
        }
        if (k < 0 && !anyhow) return false;
        if (k < 0) k = from;
        corner(r, k, v);
        if (take && (turn_at(r, v[0], v[1], v[2]) != 0 || is_sliver(r, v))) take(ctx, v);
        for (int32_t i = k; i + 1 < r->n; i++) r->c[i] = r->c[i + 1];
        r->n--;
    }
    return true;
}

int triangulate(const solid_t *s, int32_t face, const solid_normal_t *normal, bool slivers, void *mem, size_t bytes,
                void (*take)(void *ctx, const int32_t v[3]), void *ctx) {
    if (bytes / sizeof(int32_t) < (size_t)s->face[face].n) return ERR_FULL;
    flat_t f = flat_of(s, normal);
    int32_t *c = mem;
    const int32_t n = s->face[face].n;
    int32_t done = bridges_lay(&f, face, c);
    rest_t rest = {c, done, flat_turn, &f, &f, slivers};
    cut_ears(&rest, true, take, ctx);
    while (done < n) {
        const int32_t from = done + 1;
        done = bridges_island(c, done, n);
        rest = (rest_t){c + from, done - from - 1, flat_turn, &f, &f, slivers};
        cut_ears(&rest, true, take, ctx);
    }
    return 0;
}

int triangulate_seen(const solid_t *s, int32_t face, const solid_normal_t *normal, triangle_turn_t *turn, void *mem,
                     size_t bytes, void (*take)(void *ctx, const int32_t v[3]), void *ctx) {
    if (bytes / sizeof(int32_t) < (size_t)s->face[face].n) return ERR_FULL;
    flat_t f = flat_of(s, normal);
    for (int give = 0; give < 2; give++) {
        rest_t rest = {mem, bridges_lay(&f, face, mem), turn, ctx, NULL, false};
        if (rest.n < s->face[face].n || !cut_ears(&rest, false, give ? take : NULL, ctx)) return 1;
    }
    return 0;
}
