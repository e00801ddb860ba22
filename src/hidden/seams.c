/* seams.c - see seams.h. */
#include "hidden/seams.h"

#include "error.h"
#include "hidden/heap_sort.h"
#include "hidden/triangulate.h"
#include "num/ints.h"
#include <string.h>

#define FINE_BITS 8                 /* of a lattice unit: how ends of seams are compared */
#define LEAST_FINE (4 << FINE_BITS) /* what is shorter is none */

typedef struct box {
    int32_t lo[3], hi[3];
} box_t;

/* A convex face, or a triangle of one that is not. */
typedef struct piece {
    int32_t face;
    int32_t v[3]; /* v[0] < 0: the whole face */
    box_t box;
} piece_t;

/* Something with a box, where that begins along the axis. */
typedef struct begin {
    int32_t group, at, index;
} begin_t;

typedef struct seam {
    solid_vertex_t end[2];
} seam_t;

typedef struct seams {
    const solid_t *s;
    uint8_t *low, *high; /* memory: seams grow from below, the rest is at the upper end */
    bool full;
    int axis;       /* of the sweeps */
    box_t *box;     /* of each object */
    begin_t *order; /* objects */
    bool cut;       /* into pieces; not before boxes of two objects overlap */
    piece_t *piece;
    int32_t pieces, most;
    begin_t *begin;  /* pieces, by object */
    int32_t *first;  /* of each object, in begin; and one more */
    int32_t *length; /* of each object, of its longest piece */
    int32_t face;    /* being cut */
    seam_t *seam;
    int32_t n;
} seams_t;

static bool is_before(const begin_t *a, const begin_t *b) {
    if (a->group != b->group) return a->group < b->group;
    return a->at != b->at ? a->at < b->at : a->index < b->index;
}
HEAP_SORT(begin_t, is_before)

static void *take(seams_t *t, int64_t n, size_t size) {
    const size_t bytes = ((size_t)n * size + 7) & ~(size_t)7;
    t->full |= bytes > (size_t)(t->high - t->low);
    return t->full ? NULL : (t->high -= bytes);
}

static void stretch(box_t *b, const solid_vertex_t *v) {
    for (int k = 0; k < 3; k++) {
        if (v->at[k] < b->lo[k]) b->lo[k] = v->at[k];
        if (v->at[k] > b->hi[k]) b->hi[k] = v->at[k];
    }
}

static const box_t nowhere = {{INT32_MAX, INT32_MAX, INT32_MAX}, {INT32_MIN, INT32_MIN, INT32_MIN}};

static bool meet(const box_t *a, const box_t *b) {
    return a->lo[0] <= b->hi[0] && b->lo[0] <= a->hi[0] && a->lo[1] <= b->hi[1] && b->lo[1] <= a->hi[1] &&
           a->lo[2] <= b->hi[2] && b->lo[2] <= a->hi[2];
}

/* Boxes of objects, and the axis along which there is most room for them. */
static void measure(seams_t *t) {
    const solid_t *s = t->s;
    box_t all = nowhere;
    for (int32_t k = 0; k < s->no; k++) t->box[k] = nowhere;
    for (int32_t f = 0; f < s->nf; f++)
        for (int32_t c = 0; c < s->face[f].n; c++)
            stretch(&t->box[s->face[f].object], &s->vertex[s->corner[s->face[f].corner + c]]);
    for (int32_t v = 0; v < s->nv; v++) stretch(&all, &s->vertex[v]);
    for (int k = 1; k < 3; k++)
        if (all.hi[k] - all.lo[k] > all.hi[t->axis] - all.lo[t->axis]) t->axis = k;
    for (int32_t k = 0; k < s->no; k++) t->order[k] = (begin_t){0, t->box[k].lo[t->axis], k};
    heap_sort(t->order, s->no);
}

static int32_t corners(const seams_t *t, const piece_t *p) {
    return p->v[0] < 0 ? t->s->face[p->face].n : 3;
}
static int32_t corner(const seams_t *t, const piece_t *p, int32_t k) {
    return p->v[0] < 0 ? t->s->corner[t->s->face[p->face].corner + k] : p->v[k];
}

static void add_piece(void *ctx, const int32_t v[3]) {
    seams_t *t = ctx;
    t->full |= t->pieces == t->most;
    if (t->full) return;
    piece_t *p = &t->piece[t->pieces++];
    *p = (piece_t){t->face, {v[0], v[1], v[2]}, nowhere};
    for (int32_t k = 0; k < corners(t, p); k++) stretch(&p->box, &t->s->vertex[corner(t, p, k)]);
}

static int32_t object_of(const seams_t *t, int32_t piece) {
    return t->s->face[t->piece[piece].face].object;
}

static void cut_faces(seams_t *t) {
    const solid_t *s = t->s;
    t->cut = true;
    t->most = s->nc - 2 * s->nf;
    t->piece = take(t, t->most, sizeof *t->piece);
    for (t->face = 0; t->face < s->nf && !t->full; t->face++) {
        const solid_normal_t n = solid_face_normal(s, t->face);
        if (solid_face_is_convex(s, t->face, &n)) {
            add_piece(t, (int32_t[]){-1, 0, 0});
        } else if (n.n[0] != 0 || n.n[1] != 0 || n.n[2] != 0) {
            t->full |= triangulate(s, t->face, &n, t->low, (size_t)(t->high - t->low), add_piece, t) != 0;
        }
    }
    t->begin = take(t, t->pieces, sizeof *t->begin);
    t->first = take(t, (int64_t)s->no + 1, sizeof *t->first);
    t->length = take(t, s->no, sizeof *t->length);
    if (t->full) return;
    for (int32_t k = 0; k <= s->no; k++) t->first[k] = 0;
    for (int32_t k = 0; k < s->no; k++) t->length[k] = 0;
    for (int32_t k = 0; k < t->pieces; k++) {
        const box_t *b = &t->piece[k].box;
        const int32_t o = object_of(t, k), length = b->hi[t->axis] - b->lo[t->axis];
        t->begin[k] = (begin_t){o, b->lo[t->axis], k};
        t->first[o + 1]++;
        if (length > t->length[o]) t->length[o] = length;
    }
    for (int32_t k = 0; k < s->no; k++) t->first[k + 1] += t->first[k];
    heap_sort(t->begin, t->pieces);
}

/* The first piece of an object that begins at `at` or later. */
static int32_t first_from(const seams_t *t, int32_t object, int32_t at) {
    int32_t from = t->first[object], to = t->first[object + 1];
    while (from < to) {
        const int32_t mid = from + (to - from) / 2;
        if (t->begin[mid].at < at)
            from = mid + 1;
        else
            to = mid;
    }
    return from;
}

/* Place on a seam's line, in 2^-FINE_BITS of a lattice unit. */
typedef struct fine {
    int64_t at[3];
} fine_t;

typedef struct plane {
    solid_normal_t n;
    wide_t slack;
    const solid_vertex_t *on;
} plane_t;

static plane_t plane_of(const seams_t *t, const piece_t *p) {
    const solid_vertex_t *v = t->s->vertex;
    plane_t plane = {.on = &v[corner(t, p, 0)]};
    plane.n = p->v[0] < 0 ? solid_face_normal(t->s, p->face)
                          : solid_cross(solid_sub(&v[p->v[1]], plane.on), solid_sub(&v[p->v[2]], plane.on));
    plane.slack = solid_slack(&plane.n);
    return plane;
}

static wide_t height(const seams_t *t, const plane_t *plane, int32_t v) {
    return solid_dot(&plane->n, solid_sub(&t->s->vertex[v], plane->on));
}

/* Where the edge from v to w, which are on either side, goes through a plane: the same place whichever way it runs. */
static fine_t pierce(const seams_t *t, int32_t v, int32_t w, wide_t dv, wide_t dw) {
    if (v > w) {
        const int32_t u = v;
        v = w;
        w = u;
        const wide_t d = dv;
        dv = dw;
        dw = d;
    }
    if (wide_sign(dv) < 0) dv = wide_neg(dv);
    if (wide_sign(dw) < 0) dw = wide_neg(dw);
    wide_t sum = wide_add(dv, dw);
    const int shift = sum.hi != 0 ? 66 - ints_clz64((uint64_t)sum.hi) : sum.lo >> 62 != 0 ? 2 : 0;
    const int64_t part = (int64_t)wide_sar(dv, shift).lo, all = (int64_t)wide_sar(sum, shift).lo;
    const solid_vertex_t *a = &t->s->vertex[v], *b = &t->s->vertex[w];
    fine_t p;
    for (int k = 0; k < 3; k++) {
        const int64_t from = (int64_t)a->at[k] * (1 << FINE_BITS),
                      way = (int64_t)(b->at[k] - a->at[k]) * (1 << FINE_BITS);
        p.at[k] = from + ints_muldiv_round(way, part, all);
    }
    return p;
}

/* The two places where a piece's border goes through a plane; false if the piece does not reach beyond it on both
 * sides. */
static bool pierce_twice(const seams_t *t, const piece_t *p, const plane_t *plane, fine_t at[2]) {
    const int32_t n = corners(t, p);
    int places = 0;
    bool above = false, below = false;
    int32_t v = corner(t, p, n - 1);
    wide_t d = height(t, plane, v);
    for (int32_t k = 0; k < n; k++) {
        const int32_t w = corner(t, p, k);
        const wide_t e = height(t, plane, w);
        above |= wide_cmp(e, plane->slack) > 0;
        below |= wide_cmp(e, wide_neg(plane->slack)) < 0;
        if ((wide_sign(d) < 0) != (wide_sign(e) < 0)) {
            if (places == 2) return false;
            at[places++] = pierce(t, v, w, d, e);
        }
        v = w;
        d = e;
    }
    return above && below && places == 2;
}

static int32_t to_lattice(int64_t fine) {
    return (int32_t)((fine + (1 << (FINE_BITS - 1))) >> FINE_BITS);
}

/* What two pieces have of the line in common in which their planes meet. */
static void cross(seams_t *t, const piece_t *a, const plane_t *pa, const piece_t *b) {
    const plane_t pb = plane_of(t, b);
    fine_t p[2], q[2];
    if (!pierce_twice(t, a, &pb, p) || !pierce_twice(t, b, pa, q)) return;
    int axis = 0;
    int64_t most = -1;
    for (int k = 0; k < 3; k++) {
        const int64_t way = (int64_t)(ints_abs64(p[1].at[k] - p[0].at[k]) + ints_abs64(q[1].at[k] - q[0].at[k]));
        if (way > most) most = way, axis = k;
    }
    const int pl = p[1].at[axis] < p[0].at[axis], ql = q[1].at[axis] < q[0].at[axis];
    const fine_t from = p[pl].at[axis] > q[ql].at[axis] ? p[pl] : q[ql];
    const fine_t to = p[!pl].at[axis] < q[!ql].at[axis] ? p[!pl] : q[!ql];
    if (to.at[axis] - from.at[axis] < LEAST_FINE) return;
    if (sizeof *t->seam > (size_t)(t->high - t->low)) {
        t->full = true;
        return;
    }
    seam_t *seam = &t->seam[t->n++];
    t->low += sizeof *seam;
    for (int k = 0; k < 3; k++) {
        seam->end[0].at[k] = to_lattice(from.at[k]);
        seam->end[1].at[k] = to_lattice(to.at[k]);
    }
}

static void cross_objects(seams_t *t, int32_t a, int32_t b) {
    box_t common;
    if (!t->cut) cut_faces(t);
    if (t->full) return;
    for (int k = 0; k < 3; k++) {
        common.lo[k] = t->box[a].lo[k] > t->box[b].lo[k] ? t->box[a].lo[k] : t->box[b].lo[k];
        common.hi[k] = t->box[a].hi[k] < t->box[b].hi[k] ? t->box[a].hi[k] : t->box[b].hi[k];
    }
    for (int32_t i = first_from(t, a, common.lo[t->axis] - t->length[a]);
         i < t->first[a + 1] && t->begin[i].at <= common.hi[t->axis] && !t->full; i++) {
        const piece_t *p = &t->piece[t->begin[i].index];
        if (!meet(&p->box, &common)) continue;
        const plane_t plane = plane_of(t, p);
        for (int32_t j = first_from(t, b, p->box.lo[t->axis] - t->length[b]);
             j < t->first[b + 1] && t->begin[j].at <= p->box.hi[t->axis] && !t->full; j++) {
            const piece_t *q = &t->piece[t->begin[j].index];
            if (meet(&p->box, &q->box)) cross(t, p, &plane, q);
        }
    }
}

/* Vertices and edges with the seams' behind them. */
static void append(seams_t *t, solid_t *s) {
    const size_t vertices = (((size_t)s->nv + 2 * (size_t)t->n) * sizeof(solid_vertex_t) + 7) & ~(size_t)7;
    const size_t edges = ((size_t)s->ne + (size_t)t->n) * sizeof(solid_edge_t);
    t->full |= vertices + edges > (size_t)(t->high - t->low);
    if (t->full) return;
    solid_vertex_t *vertex = (solid_vertex_t *)(void *)t->low;
    solid_edge_t *edge = (solid_edge_t *)(void *)(t->low + vertices);
    t->low += vertices + edges;
    memcpy(vertex, s->vertex, (size_t)s->nv * sizeof *vertex);
    memcpy(edge, s->edge, (size_t)s->ne * sizeof *edge);
    for (int32_t k = 0; k < t->n; k++) {
        for (int end = 0; end < 2; end++) vertex[s->nv + end] = t->seam[k].end[end];
        edge[s->ne] = (solid_edge_t){{s->nv, s->nv + 1}, {-1, -1}, -1, s->ne};
        s->nv += 2;
        s->ne++;
    }
    s->vertex = vertex;
    s->edge = edge;
}

int seams_add(solid_t *s, void *mem, size_t bytes, size_t *kept) {
    seams_t t = {.s = s, .low = mem, .high = (uint8_t *)mem + (bytes & ~(size_t)7), .seam = mem};
    *kept = 0;
    if (s->no < 2) return 0;
    t.box = take(&t, s->no, sizeof *t.box);
    t.order = take(&t, s->no, sizeof *t.order);
    if (t.full) return ERR_FULL;
    measure(&t);
    for (int32_t i = 0; i < s->no; i++) {
        const int32_t a = t.order[i].index;
        for (int32_t j = i + 1; j < s->no && t.order[j].at <= t.box[a].hi[t.axis]; j++)
            if (meet(&t.box[a], &t.box[t.order[j].index])) cross_objects(&t, a, t.order[j].index);
    }
    t.high = (uint8_t *)mem + (bytes & ~(size_t)7);
    if (!t.full && t.n > 0) append(&t, s);
    if (t.full) return ERR_FULL;
    if (t.n > 0) *kept = (size_t)(t.low - (uint8_t *)mem);
    return 0;
}
