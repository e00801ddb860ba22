/* clip_snap.c - which edges pass by a vertex so closely that they are drawn to it, and those that a sweep cannot see.
 *
 * A sweep meets a vertex while the edges that span its place in the order of points are active. A steep edge that falls
 * also passes by points above its right end and below its left end, in whose order it has not begun or has ended: those
 * are looked for here, between sweeps. */
#include "poly/clip_inner.h"

#include "num/ints.h"

bool clip_is_near(const clip_seg_t *s, poly_point_t v) {
    int64_t width = (int64_t)s->r.x - s->l.x, height = (int64_t)s->r.y - s->l.y;
    if (v.x < s->l.x || v.x > s->r.x) return false;
    if (height < 0 ? v.y > s->l.y || v.y < s->r.y : v.y < s->l.y || v.y > s->r.y) return false;
    return 2 * ints_abs64(poly_orient(s->l, s->r, v)) <= (uint64_t)width + ints_abs64(height);
}

clip_seg_t clip_upright(clip_seg_t s) {
    return poly_before(s.l, s.r) ? s : (clip_seg_t){s.r, s.l, {(int16_t)-s.w[0], (int16_t)-s.w[1]}, s.tag};
}

/* The first waiting edge that does not begin before p. */
static int32_t find(const clip_t *c, int32_t from, poly_point_t p) {
    int32_t to = c->in_to;
    while (from < to) {
        int32_t middle = from + (to - from) / 2;
        if (poly_before(c->in[middle].l, p))
            from = middle + 1;
        else
            to = middle;
    }
    return from;
}

/* Puts a new edge, or with from == to a mark that something ends there, before all others. */
static void add(clip_t *c, clip_seg_t s, poly_point_t from, poly_point_t to) {
    if (c->in_from == 0) {
        c->full = true;
        return;
    }
    s.l = from;
    s.r = to;
    if (poly_same(from, to)) s.w[0] = s.w[1] = 0;
    c->in[--c->in_from] = clip_upright(s);
}

void clip_snap_columns(clip_t *c) {
    int32_t sorted = c->in_from;
    for (int32_t k = sorted; k < c->in_to && !c->full; k++) {
        clip_seg_t *s = &c->in[k], whole = *s;
        if (whole.l.y - whole.r.y <= whole.r.x - whole.l.x) continue;
        /* upwards from the right end */
        for (int32_t j = find(c, sorted, whole.r); j < c->in_to; j++) {
            poly_point_t v = c->in[j].l;
            if (v.x != whole.r.x || !clip_is_near(&whole, v)) break;
            if (poly_same(v, s->r)) continue;
            add(c, whole, v, s->r);
            s->r = v;
        }
        if (whole.l.x == whole.r.x) continue;
        /* downwards from the left end */
        whole.r = s->r;
        for (int32_t j = find(c, sorted, whole.l); j-- > sorted;) {
            poly_point_t v = c->in[j].l;
            if (v.x != whole.l.x || !clip_is_near(&whole, v)) break;
            if (poly_same(v, s->l)) continue;
            add(c, whole, s->l, v);
            add(c, whole, s->l, s->l); /* where an edge began, one ends now */
            s->l = v;
        }
    }
    int32_t n = c->in_to - c->in_from;
    if (c->in_from < n)
        c->full = true;
    else if (c->in_from < sorted)
        clip_sort(c->in + c->in_from, n, c->in);
}
