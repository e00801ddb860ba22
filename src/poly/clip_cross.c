/* clip_cross.c - where edges cross, before the first sweep: from left to right, each with those that reach so far.
 *
 * A sweep that finds a crossing has to be repeated. Most crossings are plain ones, and where a vertical line meets few
 * edges, comparing boxes finds them for a fraction of a sweep's cost. What is missed here, the sweep finds. */
#include "poly/clip_inner.h"

#include "num/ints.h"
#include <string.h>

/* So many comparisons of boxes for an edge, on average, may be tried, and so many more. */
#define COMPARISONS 64
#define AT_FIRST 4096

static bool do_cross(const clip_seg_t *a, const clip_seg_t *b) {
    if (poly_same(a->r, b->l)) return false; /* by far the commonest way to meet */
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
    /* Halves are rounded upwards, whichever edges it is computed from: points that are in order along an edge stay so.
     */
    int64_t y = ay >= 0 ? a->l.y + ints_muldiv_round(ay, num, den) : a->r.y + ints_muldiv_round(-ay, den - num, den);
    return (poly_point_t){a->l.x + (int32_t)ints_muldiv_round(ax, num, den), (int32_t)y};
}

/* Where an edge begins, and how high it lies: y1 and -y0, two numbers in one. */
typedef struct band {
    uint64_t height;
    int32_t x0;
} band_t;

/* Of these numbers against those of another edge, -y0 and y1, the sum is how far either reaches above the other's lower
 * end: if the one in the lower word is negative it does not matter that it borrows from the other. */
#define EITHER_NEGATIVE (UINT64_C(0x8000000080000000))

static uint64_t pair_of(int32_t high, int32_t low) {
    return ((uint64_t)(uint32_t)high << 32) + (uint32_t)low;
}

/* Where an edge is to be cut: r, of edge l.x; l.y ascends along it. The sort is that of segments. */
typedef clip_seg_t cut_t;

static void add_cut(const clip_seg_t *in, int32_t of, poly_point_t at, cut_t *cut, int32_t *cuts) {
    const clip_seg_t *s = &in[of];
    if (poly_same(at, s->l) || poly_same(at, s->r)) return;
    int32_t width = s->r.x - s->l.x, height = s->r.y - s->l.y;
    bool steep = height > width || -height > width;
    cut[(*cuts)++] = (cut_t){.l = {of, steep ? (height > 0 ? at.y : -at.y) : at.x}, .r = at};
}

/* Lists the cuts of edges, most of them at the most. band: room for n and one more. */
static int32_t find_cuts(const clip_t *c, int32_t n, cut_t *cut, int32_t most, band_t *band, int32_t *crossings) {
    const clip_seg_t *in = c->in;
    int32_t cuts = 0;
    int64_t left = AT_FIRST;
    for (int32_t k = 0; k < n; k++) {
        bool falls = in[k].r.y < in[k].l.y;
        int32_t y0 = falls ? in[k].r.y : in[k].l.y, y1 = falls ? in[k].l.y : in[k].r.y;
        band[k] = (band_t){pair_of(y1, -y0), in[k].l.x};
    }
    band[n].x0 = INT32_MAX;
    for (int32_t k = 0; k < n; k++) {
        const clip_seg_t *s = &in[k];
        if (poly_same(s->l, s->r)) continue;
        const int32_t x1 = s->r.x;
        const uint64_t own = pair_of((int32_t)(uint32_t)band[k].height, (int32_t)(uint32_t)(band[k].height >> 32));
        const band_t *b = &band[k + 1];
        for (; b->x0 <= x1; b++) {
            if ((b->height + own) & EITHER_NEGATIVE) continue;
            const int32_t j = (int32_t)(b - band);
            if (!do_cross(s, &in[j])) continue;
            if (cuts + 2 > most) return 0;
            poly_point_t at = clip_crossing(s, &in[j]);
            ++*crossings;
            add_cut(in, k, at, cut, &cuts);
            add_cut(in, j, at, cut, &cuts);
        }
        left += COMPARISONS - (b - &band[k]);
        if (left < 0) return 0;
    }
    return cuts;
}

/* Orders the cuts of each edge along it; those whose keys are equal are not yet. */
static void order(const clip_seg_t *in, cut_t *cut, int32_t cuts, cut_t *spare) {
    clip_sort(cut, cuts, spare);
    for (int32_t k = 1; k < cuts; k++) {
        const cut_t moved = cut[k];
        bool falls = in[moved.l.x].r.y < in[moved.l.x].l.y;
        int32_t j = k;
        for (; j > 0 && cut[j - 1].l.x == moved.l.x; j--) {
            poly_point_t a = moved.r, b = cut[j - 1].r;
            if (a.x != b.x ? a.x > b.x : falls ? a.y <= b.y : a.y >= b.y) break;
            cut[j] = cut[j - 1];
        }
        cut[j] = moved;
    }
}

/* Cuts an edge; its first part stays where it is, the others are added at part[n]. Where a part is turned, because it
 * stands upright now, nothing may begin any more where it began: that is marked. */
static int32_t split(clip_seg_t *s, const cut_t *cut, int32_t cuts, clip_seg_t *part, int32_t n) {
    const clip_seg_t whole = *s;
    clip_seg_t *to = s;
    poly_point_t from = whole.l;
    for (int32_t k = 0; k <= cuts; k++) {
        clip_seg_t p = whole;
        p.l = from;
        p.r = k < cuts ? cut[k].r : whole.r;
        if (poly_same(p.l, p.r)) continue;
        if (!to) to = &part[n++];
        *to = p;
        if (!poly_before(p.l, p.r)) {
            *to = (clip_seg_t){.l = from, .r = from};
            part[n++] = clip_upright(p);
        }
        to = NULL;
        from = p.r;
    }
    return n;
}

/* Merges m sorted segments behind the n others into these. */
static void merge(clip_seg_t *in, int32_t n, int32_t m, clip_seg_t *spare) {
    memcpy(spare, in + n, (size_t)m * sizeof *in);
    for (int32_t to = n + m; m > 0;)
        in[--to] = n > 0 && poly_before(spare[m - 1].l, in[n - 1].l) ? in[--n] : spare[--m];
}

int32_t clip_cross(clip_t *c, int32_t n) {
    clip_seg_t *in = c->in, *part = in + n;
    /* Of what is free, a cut needs its own place twice, three parts and as much again to sort them; and all have to fit
     * into half the memory. What is not cut for want of room is left to the sweep. */
    int32_t most = (c->in_to - n) / 8, half = (c->in_to / 2 - n) / 3;
    if (half < most) most = half;
    cut_t *cut = in + c->in_to - most;
    int32_t crossings = 0, cuts = find_cuts(c, n, cut, most, (band_t *)(void *)part, &crossings);
    if (cuts == 0) return n;
    c->stats.crossings += crossings;
    order(in, cut, cuts, cut - cuts);
    int32_t parts = 0;
    for (int32_t k = 0, to = 0; k < cuts; k = to) {
        while (to < cuts && cut[to].l.x == cut[k].l.x) to++;
        parts = split(&in[cut[k].l.x], cut + k, to - k, part, parts);
    }
    clip_sort(part, parts, part + parts);
    merge(in, n, parts, part + parts);
    return n + parts;
}
