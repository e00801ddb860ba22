/* clip_trace.c - the contours of a result, from the links that the last sweep made. */
#include "poly/clip_inner.h"

#include "error.h"

static int push(clip_out_t *out, int32_t first, poly_vertex_t v) {
    int32_t n = out->n;
    if (n - first >= 2) {
        const poly_vertex_t *a = &out->v[n - 2];
        poly_vertex_t *b = &out->v[n - 1];
        if (a->tag == b->tag && poly_orient(a->at, b->at, v.at) == 0) {
            *b = v;
            return 0;
        }
    }
    if (n == out->n_max) return ERR_FULL;
    out->v[out->n++] = v;
    return 0;
}

/* The vertices of a stretch, but for the last, on the way that begins at one of its ends. */
static int push_stretch(const clip_t *c, clip_stretch_t t, poly_point_t from, clip_out_t *out, int32_t first) {
    int err = 0;
    if (poly_same(from, c->v[t.from].at))
        for (int32_t k = t.from; k < t.to && !err; k++) err = push(out, first, c->v[k]);
    else
        for (int32_t k = t.to; k > t.from && !err; k--)
            err = push(out, first, (poly_vertex_t){c->v[k].at, c->v[k - 1].tag});
    return err;
}

/* The contour that the edge bounds, as its number among those of this trace. */
static int32_t contour_of(const clip_edge_t *e, int which) {
    return CLIP_TRACED - e->next[which];
}

/* The outer contour around a hole that starts with edge e: that of the next border below it, or the one that border is
 * itself a hole of. Edges in between have the same face on both sides. */
static int32_t find_outer(const clip_t *c, int which, const clip_edge_t *e, const clip_out_t *out, int32_t base) {
    int32_t k = e->under;
    while (k >= 0 && c->edge[k].next[which] > CLIP_TRACED) k = c->edge[k].under;
    if (k < 0) return -1;
    int32_t contour = base + contour_of(&c->edge[k], which);
    return out->outer[contour] >= 0 ? out->outer[contour] : contour;
}

static int trace_contour(clip_t *c, int which, int32_t start, int32_t number, clip_out_t *out) {
    int32_t first = out->n, k = start;
    do {
        clip_edge_t *e = &c->edge[k];
        poly_point_t at = clip_is_in_above(c, which, e) ? e->s.l : e->s.r;
        int err = e->s.tag > CLIP_STRETCH ? push(out, first, (poly_vertex_t){at, e->s.tag})
                                          : push_stretch(c, clip_stretch_of(c, &e->s), at, out, first);
        if (err) return err;
        k = e->next[which];
        e->next[which] = CLIP_TRACED - number;
    } while (k != start);
    /* The first vertex is the leftmost of all, a corner; the last may be on a straight edge to it. */
    const poly_vertex_t *v = out->v;
    int32_t n = out->n;
    if (n - first > 3 && v[n - 2].tag == v[n - 1].tag && poly_orient(v[n - 2].at, v[n - 1].at, v[first].at) == 0)
        out->n--;
    return 0;
}

int32_t clip_count(const clip_t *c, int which) {
    int32_t n = 0;
    for (int32_t k = 0; k < c->edges; k++) {
        const clip_edge_t *e = &c->edge[k];
        if (e->next[which] < 0) continue;
        n++;
        if (e->s.tag > CLIP_STRETCH) continue;
        clip_stretch_t t = clip_stretch_of(c, &e->s);
        n += t.to - t.from - 1;
    }
    return n;
}

int clip_trace(clip_t *c, int which, clip_out_t *out) {
    int32_t base = out->contours;
    for (int32_t k = 0; k < c->edges; k++) {
        clip_edge_t *e = &c->edge[k];
        if (e->next[which] < 0) continue;
        if (out->contours == out->contours_max) return ERR_FULL;
        bool hole = !clip_is_in_above(c, which, e);
        int err = trace_contour(c, which, k, out->contours - base, out);
        if (err) return err;
        if (out->outer) {
            out->outer[out->contours] = -1;
            if (hole) out->outer[out->contours] = find_outer(c, which, e, out, base);
        }
        out->end[out->contours++] = out->n;
    }
    return 0;
}
