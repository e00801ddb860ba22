/* shadow_build.c - which convex parts of a scene hide something, their planes and outlines.
 *
 * Counted first, then laid out, then filled in: a part is known only by its place in the order of faces. */
#include "error.h"
#include "hidden/solid/shadow_sides.h"
#include "hidden/solid/triangulate.h"
#include "num/ints.h"
#include "view/solid_side.h"

#define END_ON 4096 /* lat */
#define OFF_BITS 6

/* Is a side of the face seen, if it is flat? */
static bool is_seen(const shadows_t *s, int32_t f) {
    const int32_t is = s->face[f];
    return is & SHADOW_FRONT || ((is & SHADOW_OPEN) && shadow_side_of(s, f) == SHADOW_AWAY);
}

/* Does the face, by itself, hide anything? */
static bool is_part(const shadows_t *s, int32_t f) {
    const int32_t is = s->face[f];
    return !(is & SHADOW_WHOLE) && (is & SHADOW_BENT || is_seen(s, f));
}

static inline bool is_outline(const shadows_t *s, const solid_edge_t *e) {
    return shadows_is_outline(s, e) && s->face[e->face[0]] & SHADOW_WHOLE;
}

typedef struct counts {
    int64_t parts, planes, outlines;
} counts_t;

/* n . p - c < 0 behind; the slack makes what is near the plane lie in front. */
static inline void set_plane(shadow_plane_t *plane, const solid_normal_t *n, const solid_vertex_t *p, bool turned) {
    solid_normal_t m = *n;
    if (turned)
        for (int k = 0; k < 3; k++) m.n[k] = -m.n[k];
    solid_shorten(&m);
    *plane = (shadow_plane_t){.n = {(int32_t)m.n[0], (int32_t)m.n[1], (int32_t)m.n[2]}};
    plane->c = shadow_plane_dot(plane->n, p->at) - shadow_plane_size(plane->n) * SOLID_FLAT;
}

/* Adds a vertex to the picture's box. */
static void stretch(const shadows_t *s, shadow_t *part, int32_t v) {
    const solid_place_t *p = &s->map->place[v];
    if (!solid_map_is_good(s->map, v)) part->exact = true;
    if (p->x < part->x0) part->x0 = p->x;
    if (p->x > part->x1) part->x1 = p->x;
    if (p->y < part->y0) part->y0 = p->y;
    if (p->y > part->y1) part->y1 = p->y;
    if (p->z < part->z) part->z = p->z;
    if (p->z > part->far) part->far = p->z;
}

static void finish_box(shadow_t *part) {
    if (part->z != INT32_MIN) return;
    part->far = INT32_MAX;
    part->x0 = part->y0 = -SOLID_PLACE_MOST;
    part->x1 = part->y1 = SOLID_PLACE_MOST;
}

static const shadow_t EMPTY = {.x0 = INT32_MAX,
                               .y0 = INT32_MAX,
                               .x1 = INT32_MIN,
                               .y1 = INT32_MIN,
                               .z = INT32_MAX,
                               .far = INT32_MIN,
                               .seen = INT32_MAX,
                               .owner = INT32_MIN};

/* One polygon of n corners; away: its other side is seen. face: whose plane it is in, -1 for a triangle of one that is
 * not flat. */
static void add_polygon(shadows_t *s, counts_t *at, const int32_t *corner, int32_t n, const solid_normal_t *normal,
                        bool away, int32_t face) {
    shadow_t *part = &s->list[at->parts++];
    *part = EMPTY;
    if (face >= 0) part->owner = face;
    part->plane = (int32_t)at->planes++;
    part->planes = 1;
    part->outline = (int32_t)at->outlines;
    part->outlines = n;
    set_plane(&s->plane[part->plane], normal, &s->map->solid->vertex[corner[0]], away);
    s->plane[part->plane].face = face;
    for (int32_t k = 0; k < n; k++) { /* away: the other way round */
        const int32_t from = away && k > 0 ? n - k : k, to = away ? n - 1 - k : k + 1 < n ? k + 1 : 0;
        s->outline[at->outlines++] = (shadow_edge_t){corner[from], corner[to]};
        stretch(s, part, corner[k]);
    }
    finish_box(part);
}

typedef struct filling {
    shadows_t *s;
    counts_t at;
    bool open;                  /* the face at hand is seen from both sides */
    bool away;                  /* it looks away */
    const solid_normal_t *flat; /* it is flat, and this is its normal: of all its triangles, none of which hides its
                                   edges then */
    int32_t face;
} filling_t;

static void add_triangle(void *ctx, const int32_t v[3]) {
    filling_t *fill = ctx;
    if (fill->flat) {
        add_polygon(fill->s, &fill->at, v, 3, fill->flat, fill->away, fill->face);
        return;
    }
    const solid_vertex_t *vertex = fill->s->map->solid->vertex;
    solid_normal_t n = solid_cross(solid_sub(&vertex[v[1]], &vertex[v[0]]), solid_sub(&vertex[v[2]], &vertex[v[0]]));
    int side = solid_side(fill->s->map, &n, &vertex[v[0]]);
    if (side > 0 || (side < 0 && fill->open)) add_polygon(fill->s, &fill->at, v, 3, &n, side < 0, -1);
}

static int triangle_side(const shadows_t *s, const int32_t v[3]) {
    const solid_vertex_t *vertex = s->map->solid->vertex;
    solid_normal_t n = solid_cross(solid_sub(&vertex[v[1]], &vertex[v[0]]), solid_sub(&vertex[v[2]], &vertex[v[0]]));
    return solid_side(s->map, &n, &vertex[v[0]]);
}

/* A quadrilateral that is not flat or not convex. Of its two diagonals the one is taken whose triangles look the same
 * way: then no diagonal, which is no ink, is an outline. */
static void add_cell(filling_t *fill, const int32_t c[4]) {
    const int32_t one[2][3] = {{c[0], c[1], c[2]}, {c[0], c[2], c[3]}},
                  other[2][3] = {{c[1], c[2], c[3]}, {c[1], c[3], c[0]}};
    bool good = triangle_side(fill->s, one[0]) == triangle_side(fill->s, one[1]);
    for (int k = 0; k < 2; k++) add_triangle(fill, good ? one[k] : other[k]);
}

/* How the eye sees it, on the side of the face that it sees. */
static int turn_seen(void *ctx, int32_t a, int32_t b, int32_t c) {
    const filling_t *fill = ctx;
    const int side = triangle_side(fill->s, (const int32_t[3]){a, b, c});
    return fill->away ? -side : side;
}

/* The same for polygons: their picture is cut, if it does not cross itself. */
static int add_bent(filling_t *fill, int32_t f, const solid_normal_t *n, void *spare, size_t bytes) {
    const solid_t *solid = fill->s->map->solid;
    const solid_face_t *face = &solid->face[f];
    fill->open = fill->s->face[f] & SHADOW_OPEN;
    fill->away = shadow_side_of(fill->s, f) == SHADOW_AWAY;
    fill->flat = NULL;
    if (face->n == 4) {
        add_cell(fill, solid->corner + face->corner);
        return 0;
    }
    if (!solid_face_is_flat(solid, f, n)) {
        const int err = triangulate_seen(solid, f, n, turn_seen, spare, bytes, add_triangle, fill);
        if (err != 1) return err;
    } else {
        if (!is_seen(fill->s, f)) return 0;
        fill->flat = n;
        fill->face = f;
    }
    return triangulate(solid, f, n, true, spare, bytes, add_triangle, fill);
}

/* Makes a shadow of each convex object, counts its planes and outlines, and all polygons'. */
static counts_t count(shadows_t *s) {
    const solid_t *solid = s->map->solid;
    counts_t c = {0, 0, 0};
    for (int32_t o = 0; o < solid->no; o++) {
        if (!(s->object[o] & SHADOW_WHOLE)) continue;
        s->part[o] = (int32_t)c.parts;
        s->list[c.parts] = EMPTY;
        s->list[c.parts++].owner = ~o;
    }
    for (int32_t f = 0; f < solid->nf; f++) {
        const uint8_t is = s->face[f] |= s->object[solid->face[f].object];
        if (is & SHADOW_WHOLE) {
            s->list[s->part[solid->face[f].object]].planes += is & SHADOW_FRONT;
            c.planes += is & SHADOW_FRONT;
        } else if (is_part(s, f)) {
            const int32_t n = solid->face[f].n;
            const bool bent = is & SHADOW_BENT;
            c.parts += bent ? n - 2 : 1;
            c.planes += bent ? n - 2 : 1;
            c.outlines += bent ? 3 * (n - 2) : n;
        }
    }
    for (int32_t k = 0; k < solid->ne; k++) {
        const solid_edge_t *e = &solid->edge[k];
        if (!is_outline(s, e)) continue;
        s->list[s->part[solid->face[e->face[0]].object]].outlines++;
        c.outlines++;
    }
    return c;
}

/* Lays out the planes and outlines of the first `parts`, which are objects; those of polygons follow. */
static counts_t lay_out(shadows_t *s, int32_t parts) {
    counts_t at = {parts, 0, 0};
    for (int32_t k = 0; k < parts; k++) {
        shadow_t *of = &s->list[k];
        of->plane = (int32_t)at.planes;
        of->outline = (int32_t)at.outlines;
        at.planes += of->planes;
        at.outlines += of->outlines;
        of->planes = 0; /* in place so far */
        of->outlines = 0;
    }
    return at;
}

static void fill_face(shadows_t *s, shadow_t *of, int32_t f) {
    const solid_face_t *face = &s->map->solid->face[f];
    /* of what is in front of the eye, the outline and the nearest vertex are ends of faces that look at it */
    if (s->face[f] & SHADOW_FRONT || s->map->any_behind)
        for (int32_t k = 0; k < face->n; k++) stretch(s, of, s->map->solid->corner[face->corner + k]);
    if (!(s->face[f] & SHADOW_FRONT)) return;
    const solid_normal_t n = solid_face_normal(s->map->solid, f);
    shadow_plane_t *plane = &s->plane[of->plane + of->planes++];
    set_plane(plane, &n, shadow_corner(s, f, 0), false);
    plane->face = f;
}

/* Planes and boxes, and of faces one by one, cut into triangles where they must be, all. spare: what triangulate()
 * needs. */
static int fill_faces(filling_t *fill, void *spare, size_t bytes) {
    shadows_t *s = fill->s;
    const solid_t *solid = s->map->solid;
    for (int32_t f = 0; f < solid->nf; f++) {
        const solid_face_t *face = &solid->face[f];
        if (s->face[f] & SHADOW_WHOLE) {
            fill_face(s, &s->list[s->part[face->object]], f);
        } else if (is_part(s, f)) {
            solid_normal_t n = solid_face_normal(solid, f);
            int err = 0;
            if (s->face[f] & SHADOW_BENT)
                err = add_bent(fill, f, &n, spare, bytes);
            else
                add_polygon(s, &fill->at, solid->corner + face->corner, face->n, &n,
                            shadow_side_of(s, f) == SHADOW_AWAY, f);
            if (err) return err;
        }
    }
    return 0;
}

static void fill_outlines(shadows_t *s) {
    const solid_t *solid = s->map->solid;
    for (int32_t k = 0; k < solid->ne; k++) {
        const solid_edge_t *e = &solid->edge[k];
        if (!is_outline(s, e)) continue;
        shadow_t *of = &s->list[s->part[solid->face[e->face[0]].object]];
        const int up = s->face[e->face[0]] & SHADOW_FRONT;
        s->outline[of->outline + of->outlines++] = (shadow_edge_t){e->v[!up], e->v[up]};
    }
}

/* Puts an outline's edges one after the other, as far as they are a ring. */
static void chain(shadow_edge_t *e, int32_t n) {
    for (int32_t k = 1; k < n; k++)
        for (int32_t i = k; i < n; i++) {
            if (e[i].p != e[k - 1].q) continue;
            const shadow_edge_t next = e[i];
            e[i] = e[k];
            e[k] = next;
            break;
        }
}

static wide_t wide_size(wide_t a) {
    return wide_sign(a) < 0 ? wide_neg(a) : a;
}

/* Is vertex v on the outer side of the plane through the eye and an edge of an outline, by more than rounding is worth?
 */
static bool is_beyond(const shadows_t *s, const shadow_edge_t *e, int32_t v) {
    const solid_vertex_t *vertex = s->map->solid->vertex, *p = &vertex[e->p];
    const solid_delta_t u = solid_sub(&vertex[e->q], p);
    int64_t eye[3];
    wide_t size = {0, 0};
    solid_to_eye(s->map, p, eye);
    for (int k = 0; k < 3; k++) { /* of the plane's normal */
        const int i = k < 2 ? k + 1 : 0, j = 3 - k - i;
        size = wide_add(size, wide_size(wide_sub(wide_mul_s64(u.d[i], eye[j]), wide_mul_s64(u.d[j], eye[i]))));
    }
    return wide_cmp(wide_dot3_s64(solid_cross(solid_sub(&vertex[v], p), u).n, eye), wide_shl(size, OFF_BITS)) > 0;
}

static bool is_bound(const shadows_t *s, const shadow_t *of, const shadow_edge_t *edge) {
    const solid_place_t *p = &s->map->place[edge->p], *q = &s->map->place[edge->q];
    const shadow_edge_t *e = &s->outline[of->outline];
    if (of->exact || (solid_abs((int64_t)p->x - q->x) | solid_abs((int64_t)p->y - q->y)) >= END_ON) return true;
    for (int32_t k = 0; k < of->outlines; k++)
        if (e[k].p != edge->p && e[k].p != edge->q && is_beyond(s, edge, e[k].p)) return false;
    return true;
}

/* Takes edges that are seen end-on, or nearly, out of an outline if others begin beyond them: where the eye is on an
 * edge's line, rounding turns the plane through both as it likes. Their neighbours meet in one point of the page. */
static void prune(const shadows_t *s, shadow_t *of) {
    shadow_edge_t *e = &s->outline[of->outline];
    for (int32_t k = of->outlines - 1; k >= 0; k--)
        if (!is_bound(s, of, &e[k])) e[k] = e[--of->outlines];
}

static void *take(uint8_t **at, const uint8_t *end, int64_t n, size_t size) {
    size_t bytes = ((size_t)n * size + 7) & ~(size_t)7;
    if (!*at || bytes > (size_t)(end - *at)) {
        *at = NULL;
        return NULL;
    }
    void *p = *at;
    *at += bytes;
    return p;
}

int shadows_build(shadows_t *s, const solid_map_t *map, void *mem, size_t bytes) {
    const solid_t *solid = map->solid;
    *s = (shadows_t){.map = map};
    uint8_t *at = mem, *end = at + bytes;
    s->face = take(&at, end, solid->nf, 1);
    s->object = take(&at, end, solid->no, 1);
    s->part = take(&at, end, solid->no, sizeof *s->part);
    if (!at) return ERR_FULL;
    const int32_t whole = shadow_sides_find(s);
    s->list = (shadow_t *)(void *)at;
    if ((size_t)(end - at) < (size_t)whole * sizeof *s->list) return ERR_FULL;
    const counts_t c = count(s);
    take(&at, end, c.parts, sizeof *s->list);
    s->plane = take(&at, end, c.planes, sizeof *s->plane);
    s->outline = take(&at, end, c.outlines, sizeof *s->outline);
    if (!at) return ERR_FULL;
    filling_t fill = {.s = s, .at = lay_out(s, whole)};
    int err = fill_faces(&fill, at, (size_t)(end - at));
    fill_outlines(s);
    for (int32_t k = 0; k < whole; k++) {
        finish_box(&s->list[k]);
        prune(s, &s->list[k]);
        if (CONFIG_MANY_BODIES) chain(&s->outline[s->list[k].outline], s->list[k].outlines);
    }
    s->whole = whole;
    s->n = (int32_t)fill.at.parts;
    s->bytes = (size_t)(at - (uint8_t *)mem);
    return err;
}
