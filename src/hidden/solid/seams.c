/* seams.c - see seams.h. */
#include "hidden/solid/seams.h"
#include "hidden/solid/seams_cross.h"

#include "error.h"
#include "hidden/solid/triangulate.h"
#include "num/heap_sort.h"
#include "num/ints.h"
#include <string.h>

/* Something with a box, where that begins along the axis. */
typedef struct begin {
    int32_t group, at, index;
} begin_t;

typedef struct seams {
    const solid_t *s;
    uint8_t *low, *high; /* memory: seams grow from below, the rest is at the upper end */
    bool full;
    int axis;        /* of the sweeps */
    seam_box_t *box; /* of each object */
    begin_t *order;  /* objects */
    bool cut;        /* into pieces; not before boxes of two objects overlap */
    seam_piece_t *piece;
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

static void stretch(seam_box_t *b, const solid_vertex_t *v) {
    for (int k = 0; k < 3; k++) {
        if (v->at[k] < b->lo[k]) b->lo[k] = v->at[k];
        if (v->at[k] > b->hi[k]) b->hi[k] = v->at[k];
    }
}

static const seam_box_t nowhere = {{INT32_MAX, INT32_MAX, INT32_MAX}, {INT32_MIN, INT32_MIN, INT32_MIN}};

static bool meet(const seam_box_t *a, const seam_box_t *b) {
    return a->lo[0] <= b->hi[0] && b->lo[0] <= a->hi[0] && a->lo[1] <= b->hi[1] && b->lo[1] <= a->hi[1] &&
           a->lo[2] <= b->hi[2] && b->lo[2] <= a->hi[2];
}

/* Boxes of objects, and the axis along which there is most room for them. */
static void measure(seams_t *t) {
    const solid_t *s = t->s;
    seam_box_t all = nowhere;
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

static void add_piece(void *ctx, const int32_t v[3]) {
    seams_t *t = ctx;
    t->full |= t->pieces == t->most;
    if (t->full) return;
    seam_piece_t *p = &t->piece[t->pieces++];
    *p = (seam_piece_t){t->face, {v[0], v[1], v[2]}, nowhere};
    for (int32_t k = 0; k < seam_corners(t->s, p); k++) stretch(&p->box, &t->s->vertex[seam_corner(t->s, p, k)]);
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
            t->full |= triangulate(s, t->face, &n, false, t->low, (size_t)(t->high - t->low), add_piece, t) != 0;
        }
    }
    t->begin = take(t, t->pieces, sizeof *t->begin);
    t->first = take(t, (int64_t)s->no + 1, sizeof *t->first);
    t->length = take(t, s->no, sizeof *t->length);
    if (t->full) return;
    for (int32_t k = 0; k <= s->no; k++) t->first[k] = 0;
    for (int32_t k = 0; k < s->no; k++) t->length[k] = 0;
    for (int32_t k = 0; k < t->pieces; k++) {
        const seam_box_t *b = &t->piece[k].box;
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

static void cross(seams_t *t, const seam_piece_t *a, const seam_plane_t *pa, const seam_piece_t *b) {
    seam_t seam;
    if (!seam_cross(t->s, a, pa, b, &seam)) return;
    t->full |= sizeof seam > (size_t)(t->high - t->low);
    if (t->full) return;
    t->seam[t->n++] = seam;
    t->low += sizeof seam;
}

static void cross_objects(seams_t *t, int32_t a, int32_t b) {
    seam_box_t common;
    if (!t->cut) cut_faces(t);
    if (t->full) return;
    for (int k = 0; k < 3; k++) {
        common.lo[k] = t->box[a].lo[k] > t->box[b].lo[k] ? t->box[a].lo[k] : t->box[b].lo[k];
        common.hi[k] = t->box[a].hi[k] < t->box[b].hi[k] ? t->box[a].hi[k] : t->box[b].hi[k];
    }
    for (int32_t i = first_from(t, a, common.lo[t->axis] - t->length[a]);
         i < t->first[a + 1] && t->begin[i].at <= common.hi[t->axis] && !t->full; i++) {
        const seam_piece_t *p = &t->piece[t->begin[i].index];
        if (!meet(&p->box, &common)) continue;
        const seam_plane_t plane = seam_plane(t->s, p);
        for (int32_t j = first_from(t, b, p->box.lo[t->axis] - t->length[b]);
             j < t->first[b + 1] && t->begin[j].at <= p->box.hi[t->axis] && !t->full; j++) {
            const seam_piece_t *q = &t->piece[t->begin[j].index];
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
