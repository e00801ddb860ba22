/* brute_convex.c - see brute_convex.h. */
#include "tests/bench/brute_convex.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define FLAT 1e-6   /* of the scene's size: so near to a plane is in it */
#define PARTS 1024  /* of an edge at most */
#define OUTLINES 64 /* edges of a body's outline, and front faces of a body, at most */

typedef struct plane {
    double n[3], c; /* n . p < c inside */
} plane_t;

typedef struct body {
    double lo[2], hi[2], near; /* near: largest z */
    plane_t plane[OUTLINES];
    int32_t planes;
} body_t;

struct brute {
    const solid_t *s;
    double (*vertex)[3], (*at)[3]; /* as given, and in the view */
    double (*normal)[3];           /* of faces, in the view */
    body_t *body;
};

brute_t *brute_new(const solid_t *s) {
    brute_t *b = calloc(1, sizeof *b);
    if (!b) return NULL;
    b->s = s;
    b->vertex = calloc((size_t)s->nv, sizeof *b->vertex);
    b->at = calloc((size_t)s->nv, sizeof *b->at);
    b->normal = calloc((size_t)s->nf, sizeof *b->normal);
    b->body = calloc((size_t)s->no, sizeof *b->body);
    if (!b->vertex || !b->at || !b->normal || !b->body) {
        brute_free(b);
        return NULL;
    }
    for (int32_t v = 0; v < s->nv; v++)
        for (int k = 0; k < 3; k++) b->vertex[v][k] = ldexp(s->vertex[v].at[k], 1 - SOLID_BITS);
    return b;
}

void brute_free(brute_t *b) {
    if (!b) return;
    free(b->vertex);
    free(b->at);
    free(b->normal);
    free(b->body);
    free(b);
}

void brute_view(brute_t *b, const double view[3][3]) {
    for (int32_t v = 0; v < b->s->nv; v++)
        for (int k = 0; k < 3; k++)
            b->at[v][k] = view[k][0] * b->vertex[v][0] + view[k][1] * b->vertex[v][1] + view[k][2] * b->vertex[v][2];
}

static void add_plane(body_t *body, double x, double y, double z, const double p[3]) {
    body->plane[body->planes++] = (plane_t){{x, y, z}, x * p[0] + y * p[1] + z * p[2]};
}

static void find_bodies(brute_t *b) {
    const solid_t *s = b->s;
    for (int32_t o = 0; o < s->no; o++)
        b->body[o] = (body_t){.lo = {INFINITY, INFINITY}, .hi = {-INFINITY, -INFINITY}, .near = -INFINITY};
    for (int32_t f = 0; f < s->nf; f++) {
        const int32_t *c = s->corner + s->face[f].corner;
        const double *p = b->at[c[0]], *q = b->at[c[1]], *r = b->at[c[2]];
        const double u[3] = {q[0] - p[0], q[1] - p[1], q[2] - p[2]}, v[3] = {r[0] - p[0], r[1] - p[1], r[2] - p[2]};
        double *n = b->normal[f];
        n[0] = u[1] * v[2] - u[2] * v[1];
        n[1] = u[2] * v[0] - u[0] * v[2];
        n[2] = u[0] * v[1] - u[1] * v[0];
        body_t *body = &b->body[s->face[f].object];
        for (int32_t k = 0; k < s->face[f].n; k++) {
            const double *at = b->at[c[k]];
            for (int i = 0; i < 2; i++) {
                if (at[i] < body->lo[i]) body->lo[i] = at[i];
                if (at[i] > body->hi[i]) body->hi[i] = at[i];
            }
            if (at[2] > body->near) body->near = at[2];
        }
        if (n[2] > 0) add_plane(body, n[0], n[1], n[2], p);
    }
    for (int32_t e = 0; e < s->ne; e++) {
        const solid_edge_t *edge = &s->edge[e];
        const bool up = b->normal[edge->face[0]][2] > 0;
        if (up == (b->normal[edge->face[1]][2] > 0)) continue;
        const double *p = b->at[edge->v[!up]], *q = b->at[edge->v[up]];
        add_plane(&b->body[s->face[edge->face[0]].object], q[1] - p[1], p[0] - q[0], 0, p);
    }
}

typedef struct part {
    double from, to;
} part_t;

/* The part of a line that is inside of all planes of a body; false if there is none. */
static bool is_behind(const body_t *body, const double *p, const double *q, part_t *c) {
    *c = (part_t){0, 1};
    for (int32_t k = 0; k < body->planes; k++) {
        const plane_t *m = &body->plane[k];
        const double a = m->n[0] * p[0] + m->n[1] * p[1] + m->n[2] * p[2] - m->c,
                     b = m->n[0] * q[0] + m->n[1] * q[1] + m->n[2] * q[2] - m->c;
        if (a > -FLAT && b > -FLAT) return false;
        if (a > 0 && a / (a - b) > c->from) c->from = a / (a - b);
        if (b > 0 && a / (a - b) < c->to) c->to = a / (a - b);
        if (c->from >= c->to) return false;
    }
    return true;
}

static int32_t take_off(part_t *part, int32_t parts, part_t c) {
    int32_t n = 0;
    for (int32_t k = 0; k < parts; k++) {
        const part_t p = part[k];
        if (p.to <= c.from || p.from >= c.to) {
            part[n++] = p;
            continue;
        }
        if (p.from < c.from && c.to < p.to) {
            memmove(&part[k + 1], &part[k], (size_t)(parts - k) * sizeof *part);
            part[k].to = c.from;
            part[k + 1].from = c.to;
            return parts + 1;
        }
        if (p.from < c.from) part[n++] = (part_t){p.from, c.from};
        if (c.to < p.to) part[n++] = (part_t){c.to, p.to};
    }
    return n;
}

int32_t brute_hide(brute_t *b, double *ink) {
    const solid_t *s = b->s;
    int32_t pieces = 0;
    *ink = 0;
    find_bodies(b);
    for (int32_t e = 0; e < s->ne; e++) {
        const solid_edge_t *edge = &s->edge[e];
        if (b->normal[edge->face[0]][2] <= 0 && b->normal[edge->face[1]][2] <= 0) continue;
        const double *p = b->at[edge->v[0]], *q = b->at[edge->v[1]];
        const double x0 = fmin(p[0], q[0]), x1 = fmax(p[0], q[0]), y0 = fmin(p[1], q[1]), y1 = fmax(p[1], q[1]),
                     far = fmin(p[2], q[2]);
        const int32_t own = s->face[edge->face[0]].object;
        part_t part[PARTS], c;
        part[0] = (part_t){0, 1};
        int32_t parts = 1;
        for (int32_t o = 0; o < s->no && parts > 0; o++) {
            const body_t *body = &b->body[o];
            if (body->lo[0] > x1 || body->hi[0] < x0 || body->lo[1] > y1 || body->hi[1] < y0 || body->near < far ||
                o == own)
                continue;
            if (is_behind(body, p, q, &c) && parts < PARTS) parts = take_off(part, parts, c);
        }
        for (int32_t k = 0; k < parts; k++) *ink += part[k].to - part[k].from;
        pieces += parts;
    }
    return pieces;
}
