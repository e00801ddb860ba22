/* area_body.c - see area_body.h. */
#include "hidden/area/area_body.h"

#include "num/heap_sort.h"
#include "view/solid_side.h"
#include <string.h>

/* What is sorted first, by depth; then faces that are parts of bodies, body by body. */
static bool is_before(const area_face_t *a, const area_face_t *b) {
    if (a->part != b->part) return b->part;
    if (a->part && a->object != b->object) return a->object < b->object;
    return a->z_near != b->z_near ? a->z_near < b->z_near : a->face < b->face;
}

HEAP_SORT(area_face_t, is_before)

static void arrange(area_faces_t *faces, int32_t all) {
    heap_sort(faces->face, all);
    int32_t n = 0;
    while (n < all && !faces->face[n].part) n++;
    faces->n = n;
    faces->parts = all - n;
}

static bool is_body(const solid_object_t *o) {
    return o->kind == SOLID_CONVEX && !o->clear;
}

int32_t area_bodies_most(const solid_map_t *m) {
    int32_t n = 0;
    for (int32_t o = 0; o < m->solid->no && !m->any_behind; o++) n += is_body(&m->solid->object[o]);
    return n;
}

int32_t area_bodies_vertices(area_faces_t *faces) {
    int32_t vertices = 0;
    for (int32_t k = 0; k < faces->n && !faces->lattice.clips; k++) {
        area_face_t *f = &faces->face[k];
        f->part = is_body(&faces->lattice.m->solid->object[f->object]);
        if (f->part) vertices += f->n;
    }
    return vertices;
}

/* ---- which faces an object has ---- */

/* Of object o: list[first[o]] .. list[first[o + 1] - 1], all of its faces. */
static int32_t *firsts(const area_faces_t *faces) {
    return faces->of_object;
}
static int32_t *list(const area_faces_t *faces) {
    return faces->of_object + faces->lattice.m->solid->no + 1;
}

size_t area_bodies_bytes(const solid_t *s) {
    return ((size_t)s->no + 1 + (size_t)s->nf) * sizeof(int32_t);
}

static void list_faces(area_faces_t *faces, void *mem) {
    const solid_t *s = faces->lattice.m->solid;
    faces->of_object = mem;
    int32_t *first = firsts(faces), at = 0;
    memset(first, 0, ((size_t)s->no + 1) * sizeof *first);
    for (int32_t f = 0; f < s->nf; f++) first[s->face[f].object + 1]++;
    for (int32_t o = 0; o < s->no; o++) { /* where the next face of each is to go */
        const int32_t n = first[o + 1];
        first[o + 1] = at;
        at += n;
    }
    for (int32_t f = 0; f < s->nf; f++) list(faces)[first[s->face[f].object + 1]++] = f;
}

/* ---- silhouettes ---- */

/* The union of faces [from, to) as one contour at the end of the vertices. Returns its vertices, or 0. */
static int32_t outline(const area_faces_t *faces, int32_t from, int32_t to, void *mem, size_t bytes) {
    int32_t n = 0;
    for (int32_t k = from; k < to; k++) n += faces->face[k].n;
    const size_t contours = ((size_t)(to - from) * sizeof(int32_t) + 7) & ~(size_t)7;
    const size_t used = contours + (((size_t)n * sizeof(poly_vertex_t) + 7) & ~(size_t)7);
    if (used + CLIP_BYTES(n) > bytes) return 0;
    int32_t *end = mem, at = 0;
    poly_vertex_t *v = (poly_vertex_t *)(void *)((uint8_t *)mem + contours);
    for (int32_t k = from; k < to; k++) {
        const area_face_t *f = &faces->face[k];
        memcpy(v + at, faces->vertex + f->first, (size_t)f->n * sizeof *v);
        at += f->n;
        end[k - from] = at;
    }
    const clip_job_t job = {
        .subject = {v, end, to - from}, .fill = CLIP_EVEN_ODD, .result = {CLIP_SUBJECT, CLIP_NOTHING}};
    clip_t c;
    int32_t last;
    if (clip_run(&c, &job, (uint8_t *)mem + used, bytes - used) || c.stats.sweeps != 1) return 0;
    clip_out_t out = {.v = faces->vertex + faces->vertices, .end = &last, .n_max = n, .contours_max = 1};
    return clip_trace(&c, 0, &out) || out.contours != 1 ? 0 : out.n;
}

static bool make(area_faces_t *faces, int32_t from, int32_t to, area_face_t *body, void *mem, size_t bytes) {
    const int32_t n = outline(faces, from, to, mem, bytes);
    if (n == 0) return false;
    *body = faces->face[from];
    body->body = true;
    body->part = false;
    body->first = faces->vertices;
    body->n = n;
    body->box = area_box_of(faces->vertex + body->first, n);
    for (int32_t k = from; k < to; k++) {
        const area_face_t *f = &faces->face[k];
        body->z_near = f->z_near < body->z_near ? f->z_near : body->z_near;
        body->z_far = f->z_far > body->z_far ? f->z_far : body->z_far;
        body->sharp |= f->sharp;
    }
    faces->vertices += n;
    return true;
}

void area_bodies_make(area_faces_t *faces, void *mem, void *clip_mem, size_t clip_bytes) {
    int32_t all = faces->n, bodies = 0;
    list_faces(faces, mem);
    arrange(faces, all);
    for (int32_t from = faces->n, to; from < all; from = to) {
        for (to = from + 1; to < all && faces->face[to].object == faces->face[from].object;) to++;
        if (to - from > 1 && make(faces, from, to, &faces->face[all + bodies], clip_mem, clip_bytes))
            bodies++;
        else
            for (int32_t k = from; k < to; k++) faces->face[k].part = false;
    }
    arrange(faces, all + bodies);
}

void area_body_parts(const area_faces_t *faces, int32_t body, int32_t *from, int32_t *to) {
    const int32_t object = faces->face[body].object, end = faces->n + faces->parts;
    int32_t lo = faces->n;
    for (int32_t left = faces->parts; left > 0;) {
        const int32_t half = left / 2;
        const bool before = faces->face[lo + half].object < object;
        lo = before ? lo + half + 1 : lo;
        left = before ? left - half - 1 : half;
    }
    *from = lo;
    while (lo < end && faces->face[lo].object == object) lo++;
    *to = lo;
}

bool area_bodies_break(area_faces_t *faces, bool all) {
    int32_t n = faces->n + faces->parts, kept = 0;
    for (int32_t k = 0; k < faces->n; k++) {
        if (!faces->face[k].body || (!all && !faces->face[k].broken)) continue;
        int32_t from, to;
        area_body_parts(faces, k, &from, &to);
        for (int32_t i = from; i < to; i++) faces->face[i].part = false;
    }
    for (int32_t k = 0; k < n; k++)
        if (!faces->face[k].body || (!all && !faces->face[k].broken)) faces->face[kept++] = faces->face[k];
    if (kept == n) return false;
    arrange(faces, kept);
    return true;
}

/* ---- which of two is in front ---- */

static const solid_vertex_t *corner(const solid_t *s, int32_t face, int32_t k) {
    return &s->vertex[s->corner[s->face[face].corner + k]];
}

/* On which side of a plane the corners of a face are: 1 in front of it or in it, -1 behind it or in it, 0 on both, 2 in
 * it. Sets *touches if one is in it. */
static int side_of(const solid_t *s, const solid_normal_t *n, const solid_vertex_t *at, const wide_t slack,
                   int32_t face, bool *touches) {
    bool before = false, behind = false;
    for (int32_t k = 0; k < s->face[face].n && !(before && behind); k++) {
        const wide_t d = solid_dot(n, solid_sub(corner(s, face, k), at));
        const bool above = wide_cmp(d, slack) > 0, below = wide_cmp(wide_neg(d), slack) > 0;
        before |= above;
        behind |= below;
        *touches |= !above && !below;
    }
    return before && behind ? 0 : before ? 1 : behind ? -1 : 2;
}

/* The same of a body. */
static int side_of_all(const area_faces_t *faces, const solid_normal_t *n, const solid_vertex_t *at,
                       const area_face_t *f, bool *touches) {
    const solid_t *s = faces->lattice.m->solid;
    const wide_t slack = solid_slack(n);
    *touches = false;
    int side = 2;
    for (int32_t k = firsts(faces)[f->object]; k < firsts(faces)[f->object + 1]; k++) {
        const int here = side_of(s, n, at, slack, list(faces)[k], touches);
        if (here == 0 || here == -side) return 0;
        if (here != 2) side = here;
    }
    return side;
}

/* Is no corner of a face behind a plane? */
static bool is_outside(const solid_t *s, const solid_normal_t *n, const solid_vertex_t *at, const wide_t least,
                       int32_t face) {
    for (int32_t k = 0; k < s->face[face].n; k++)
        if (wide_cmp(solid_dot(n, solid_sub(corner(s, face, k), at)), least) < 0) return false;
    return true;
}

static bool is_all_outside(const area_faces_t *faces, const solid_normal_t *n, const solid_vertex_t *at,
                           const area_face_t *f) {
    const solid_t *s = faces->lattice.m->solid;
    const wide_t least = wide_neg(solid_slack(n));
    if (!f->body) return is_outside(s, n, at, least, f->face);
    for (int32_t k = firsts(faces)[f->object]; k < firsts(faces)[f->object + 1]; k++)
        if (!is_outside(s, n, at, least, list(faces)[k])) return false;
    return true;
}

/* By the planes of body a: where b is to a. */
static int by_planes(const area_faces_t *faces, const area_face_t *a, const area_face_t *b) {
    const solid_map_t *m = faces->lattice.m;
    for (int32_t k = firsts(faces)[a->object]; k < firsts(faces)[a->object + 1]; k++) {
        const int32_t face = list(faces)[k];
        const solid_normal_t n = solid_face_normal(m->solid, face);
        const solid_vertex_t *at = corner(m->solid, face, 0);
        if (is_all_outside(faces, &n, at, b)) return solid_side(m, &n, at);
    }
    return AREA_APART_UNKNOWN;
}

int area_bodies_compare(const area_faces_t *faces, int32_t of, int32_t than) {
    const solid_map_t *m = faces->lattice.m;
    const area_face_t *a = &faces->face[of], *b = &faces->face[than];
    if (!a->body || !b->body) { /* by the polygon's plane */
        const area_face_t *body = a->body ? a : b, *f = a->body ? b : a;
        const solid_normal_t n = solid_face_normal(m->solid, f->face);
        const solid_vertex_t *at = corner(m->solid, f->face, 0);
        if (solid_face_is_flat(m->solid, f->face, &n)) {
            bool touches;
            const int body_side = side_of_all(faces, &n, at, body, &touches), eye = solid_side(m, &n, at);
            /* what of the body is in the polygon's plane is not hidden by it */
            if (touches && body_side != eye) return AREA_APART_UNKNOWN;
            if (body_side != 0) return (a->body ? 1 : -1) * body_side * eye;
        }
    }
    if (a->body) {
        const int b_is = by_planes(faces, a, b);
        if (b_is != AREA_APART_UNKNOWN) return -b_is;
    }
    return b->body ? by_planes(faces, b, a) : AREA_APART_UNKNOWN;
}
