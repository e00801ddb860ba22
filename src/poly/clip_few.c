/* clip_few.c - crossings of few edges: every one of the subject with every one of the clip polygon. */
#include "poly/clip_inner.h"

#include "error.h"
#include "num/ints.h"

bool clip_do_cross(const clip_seg_t *a, const clip_seg_t *b) {
    if (a->r.x < b->l.x || b->r.x < a->l.x) return false;
    int32_t a0 = a->l.y < a->r.y ? a->l.y : a->r.y, a1 = a->l.y < a->r.y ? a->r.y : a->l.y;
    int32_t b0 = b->l.y < b->r.y ? b->l.y : b->r.y, b1 = b->l.y < b->r.y ? b->r.y : b->l.y;
    if (a1 < b0 || b1 < a0) return false;
    int64_t p = poly_orient(a->l, a->r, b->l), q = poly_orient(a->l, a->r, b->r);
    if (p == 0 || q == 0 || (p > 0) == (q > 0)) return false;
    p = poly_orient(b->l, b->r, a->l);
    q = poly_orient(b->l, b->r, a->r);
    return p != 0 && q != 0 && (p > 0) != (q > 0);
}

poly_point_t clip_crossing(const clip_seg_t *a, const clip_seg_t *b) {
    int64_t ax = a->r.x - a->l.x, ay = a->r.y - a->l.y, bx = b->r.x - b->l.x, by = b->r.y - b->l.y;
    int64_t den = ax * by - ay * bx;
    int64_t num = (b->l.x - a->l.x) * by - (b->l.y - a->l.y) * bx;
    return (poly_point_t){a->l.x + (int32_t)ints_muldiv_round(ax, num, den),
                          a->l.y + (int32_t)ints_muldiv_round(ay, num, den)};
}

/* The second part of an edge that is split at p goes to the end; places where something ends now, and nothing may
 * begin, are marked. */
static int32_t split(clip_seg_t *in, int32_t k, poly_point_t p, int32_t n) {
    clip_seg_t *s = &in[k], first = *s, second = *s;
    if (poly_same(p, s->l) || poly_same(p, s->r)) return n;
    first.r = second.l = p;
    const poly_point_t left = s->l;
    *s = clip_upright(first);
    in[n++] = clip_upright(second);
    bool turned = !poly_same(s->l, left) || !poly_same(in[n - 1].l, p);
    if (turned) {
        in[n++] = (clip_seg_t){.l = p, .r = p};
        in[n++] = (clip_seg_t){.l = left, .r = left};
    }
    return n;
}

int32_t clip_cross_few(clip_t *c, int32_t clip, int32_t n, int32_t most) {
    clip_seg_t *in = c->in;
    int32_t end = n;
    /* More than one for each pair are rounding's: nearly parallel edges creep towards each other, unit by unit. Sweeps
     * draw them together. */
    const int64_t enough = (int64_t)clip * (n - clip) + 16;
    /* Second parts are at the end, of the subject or of the clip polygon: w says which. */
    for (int32_t i = 0; i < end; i = i + 1 == clip ? n : i + 1) {
        if (in[i].w[0] == 0) continue;
        for (int32_t j = clip; j < end; j++) {
            if (c->stats.crossings > enough) return end;
            if (in[j].l.x > in[i].r.x || in[j].w[1] == 0 || !clip_do_cross(&in[i], &in[j])) continue;
            if (end + 6 > most) return ERR_FULL;
            poly_point_t p = clip_crossing(&in[i], &in[j]);
            c->stats.crossings++;
            end = split(in, i, p, end);
            end = split(in, j, p, end);
        }
    }
    return end;
}
