/* solid_convex.c - which closed objects are convex, in time linear in their faces.
 *
 * No edge bends inward, the centre of the vertices lies behind every face, and a ray from there leaves through one face
 * only: then faces cover the sphere around the centre once, so the surface is the boundary of what is behind all faces.
 * (Without the ray, a star body that winds twice round its vertices would pass.) */
#include "scene/solid_build.h"
#include "scene/solid_math.h"
#include <string.h>

/* What is summed up about one object. */
typedef struct centre {
    union {
        int64_t sum[3]; /* of the corners, until all are there */
        struct {
            solid_vertex_t at; /* the centre */
            solid_delta_t ray; /* from there to the middle of the first face */
        };
    };
    int64_t corners; /* 0: at and ray are set */
    int32_t first;   /* face; -1: none yet */
    int32_t hits;    /* faces that the ray meets */
} centre_t;

static bool is_candidate(const solid_build_t *b, int32_t face) {
    return b->object[b->face[face].object].kind == SOLID_CONVEX;
}

static void demote(solid_build_t *b, int32_t face) {
    b->object[b->face[face].object].kind = SOLID_CLOSED;
}

static void check_faces(solid_build_t *b) {
    for (int32_t f = 0; f < b->s->nf; f++) {
        if (!is_candidate(b, f)) continue;
        solid_normal_t n = solid_face_normal(b->s, f);
        if (!solid_face_is_convex(b->s, f, &n)) demote(b, f);
    }
}

/* Is all of face g, which meets face f in an edge, behind the plane of f, or in it? */
static bool is_behind(const solid_t *s, const solid_edge_t *e, int32_t f, int32_t g) {
    const solid_normal_t n = solid_face_normal(s, f);
    const wide_t slack = solid_slack(&n);
    const solid_vertex_t *at = &s->vertex[s->corner[s->face[f].corner]];
    for (int32_t k = 0; k < s->face[g].n; k++) {
        const int32_t v = s->corner[s->face[g].corner + k];
        if (v == e->v[0] || v == e->v[1]) continue;
        if (wide_cmp(solid_dot(&n, solid_sub(&s->vertex[v], at)), slack) > 0) return false;
    }
    return true;
}

static void check_edges(solid_build_t *b) {
    for (int32_t e = 0; e < b->s->ne; e++) {
        const int32_t *f = b->edge[e].face;
        if (f[0] < 0 || f[1] < 0 || !is_candidate(b, f[0])) continue;
        if (!is_behind(b->s, &b->edge[e], f[0], f[1])) demote(b, f[0]);
    }
}

static solid_vertex_t mean(const int64_t sum[3], int64_t n) {
    return (solid_vertex_t){{(int32_t)(sum[0] / n), (int32_t)(sum[1] / n), (int32_t)(sum[2] / n)}};
}

static void add_corners(const solid_t *s, int32_t f, int64_t sum[3]) {
    for (int32_t k = 0; k < s->face[f].n; k++)
        for (int i = 0; i < 3; i++) sum[i] += s->vertex[s->corner[s->face[f].corner + k]].at[i];
}

/* Does the ray from c along d leave through face f or its border? */
static bool leaves_through(const solid_t *s, int32_t f, const solid_vertex_t *c, solid_delta_t d) {
    const solid_face_t *face = &s->face[f];
    for (int32_t k = 0; k < face->n; k++) {
        const solid_vertex_t *p = &s->vertex[s->corner[face->corner + k]],
                             *q = &s->vertex[s->corner[face->corner + (k + 1 < face->n ? k + 1 : 0)]];
        solid_normal_t n = solid_cross(solid_sub(p, c), solid_sub(q, c));
        if (wide_sign(solid_dot(&n, d)) < 0) return false;
    }
    return true;
}

static void set_ray(const solid_t *s, centre_t *t) {
    int64_t first[3] = {0, 0, 0};
    add_corners(s, t->first, first);
    const solid_vertex_t at = mean(t->sum, t->corners), target = mean(first, s->face[t->first].n);
    t->at = at;
    t->ray = solid_sub(&target, &at);
    t->corners = 0;
}

static void check_centre(solid_build_t *b, int32_t f, centre_t *t) {
    const solid_t *s = b->s;
    if (t->corners) set_ray(s, t);
    const solid_normal_t n = solid_face_normal(s, f);
    const solid_vertex_t *at = &s->vertex[s->corner[s->face[f].corner]];
    bool behind = wide_cmp(solid_dot(&n, solid_sub(&t->at, at)), wide_neg(solid_slack(&n))) < 0;
    t->hits += leaves_through(s, f, &t->at, t->ray);
    if (!behind || t->hits > 1) demote(b, f);
}

/* Objects from .. to - 1, with memory for so many. */
static void check_centres(solid_build_t *b, int32_t from, int32_t to, centre_t *t) {
    for (int32_t o = from; o < to; o++) t[o - from] = (centre_t){.first = -1};
    for (int pass = 0; pass < 2; pass++) {
        for (int32_t f = 0; f < b->s->nf; f++) {
            int32_t o = b->face[f].object;
            if (o < from || o >= to || !is_candidate(b, f)) continue;
            centre_t *c = &t[o - from];
            if (pass == 1) {
                check_centre(b, f, c);
                continue;
            }
            if (c->first < 0) c->first = f;
            add_corners(b->s, f, c->sum);
            c->corners += b->face[f].n;
        }
    }
}

void solid_find_convex(solid_build_t *b) {
    check_faces(b);
    check_edges(b);
    /* in the memory of the hash table, which is not needed any more */
    int32_t room = (int32_t)(b->slots * sizeof *b->slot / sizeof(centre_t));
    if (room < 1) return;
    for (int32_t from = 0; from < b->s->no; from += room) {
        int32_t to = b->s->no - from < room ? b->s->no : from + room;
        check_centres(b, from, to, (centre_t *)(void *)b->slot);
    }
}
