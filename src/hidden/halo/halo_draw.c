/* halo_draw.c - DRAW: the visible parts of edges for a width of the halo. See halo.h.
 *
 * A crossing knows where it is and how far its gap reaches per unit of width, so a gap is one product. In the bits of
 * `other` above 24 it knows up to which power of two of a width that is all there is to it; a wider halo looks at the
 * nearer edge again, to end where that ends (halo_strip). */
#include "hidden/halo/halo_meet.h"

#include "num/heap_sort.h"
#include "num/ints.h"

#define ONE_Q30 (UINT32_C(1) << 30)
#define FEW 12 /* gaps sorted by insertion */

typedef struct gap {
    uint32_t from_q30, to_q30;
} gap_t;
_Static_assert(sizeof(gap_t) == sizeof(uint64_t), "gaps are sorted where the boxes were; an edge has fewer than edges");

/* Narrows [t0, t1] q30 to where |a + b t| <= most, b per 2^30. */
static void narrow(int64_t a, int64_t b, int64_t low, int64_t high, int64_t *t0, int64_t *t1) {
    if (b == 0) {
        if (a < low || a > high) *t1 = -1;
        return;
    }
    int64_t s = ints_muldiv_round(low - a, 1 << 30, b), t = ints_muldiv_round(high - a, 1 << 30, b);
    if (b < 0) {
        const int64_t swap = s;
        s = t;
        t = swap;
    }
    if (s > *t0) *t0 = s;
    if (t < *t1) *t1 = t;
}

bool halo_strip(const halo_edge_t *far, const halo_edge_t *near, int32_t width, uint32_t *from_q30, uint32_t *to_q30) {
    const int32_t fx = far->q.x - far->p.x, fy = far->q.y - far->p.y;
    int32_t nx = near->q.x - near->p.x, ny = near->q.y - near->p.y;
    const int32_t x = far->p.x - near->p.x, y = far->p.y - near->p.y;
    if (nx == 0 && ny == 0) nx = -fy, ny = fx; /* a dot: as if it were a short line square to the other */
    if (nx == 0 && ny == 0) nx = 1;            /* both are dots */
    const bool dot = near->q.x == near->p.x && near->q.y == near->p.y;
    /* A short edge as a longer one, or the fractions of its halo's products would count. */
    const int32_t scale = nx < 1 << 14 && nx > -(1 << 14) && ny < 1 << 14 && ny > -(1 << 14) ? 1 << 15 : 1;
    nx *= scale, ny *= scale;
    const int64_t square = wide_mul_s32(nx, nx) + wide_mul_s32(ny, ny);
    /* width * length, the length with all the 32 bits that the root gives: 2^24 2^32 */
    const int shift = square == 0 ? 0 : ints_clz64((uint64_t)square) & ~1;
    const int64_t reach = (int64_t)width * ints_sqrt_u64((uint64_t)square << shift) >> (shift / 2);
    int64_t t0 = 0, t1 = ONE_Q30;
    narrow(wide_mul_s32(nx, y) - wide_mul_s32(ny, x), wide_mul_s32(nx, fy) - wide_mul_s32(ny, fx), -reach, reach, &t0,
           &t1);
    narrow(wide_mul_s32(nx, x) + wide_mul_s32(ny, y), wide_mul_s32(nx, fx) + wide_mul_s32(ny, fy), -reach,
           (dot ? 0 : square / scale) + reach, &t0, &t1);
    if (t0 > t1) return false;
    *from_q30 = (uint32_t)t0;
    *to_q30 = (uint32_t)t1;
    return true;
}

/* The gap of a crossing; empty (from > to) if there is none. */
static gap_t gap_of(const halo_t *h, const halo_crossing_t *x, int32_t width) {
    gap_t g = {1, 0};
    if ((uint32_t)width >> (x->other >> 24) != 0) {
        halo_strip(&h->edge[x->edge], &h->edge[x->other & HALO_OTHER], width, &g.from_q30, &g.to_q30);
        return g;
    }
    const uint64_t way = wide_mul_u32((uint32_t)width, x->way_q36) >> 6, to = x->at_q30 + way;
    g.from_q30 = way < x->at_q30 ? x->at_q30 - (uint32_t)way : 0;
    g.to_q30 = to < ONE_Q30 ? (uint32_t)to : ONE_Q30;
    return g;
}

static bool is_before(const gap_t *a, const gap_t *b) {
    return a->from_q30 < b->from_q30;
}

HEAP_SORT(gap_t, is_before)

/* Edges behind thousands of others exist, and no input may make it slow. */
static void sort(gap_t *gap, uint32_t n) {
    if (n > FEW) {
        heap_sort(gap, (int32_t)n);
        return;
    }
    for (uint32_t k = 1; k < n; k++) {
        const gap_t g = gap[k];
        uint32_t at = k;
        for (; at > 0 && is_before(&g, &gap[at - 1]); at--) gap[at] = gap[at - 1];
        gap[at] = g;
    }
}

/* The gaps of an edge, sorted by where they begin; how many. They nearly are: CUT has sorted the crossings. */
static uint32_t gaps_of(const halo_t *h, const halo_crossing_t *x, uint32_t count, int32_t width, gap_t *gap) {
    uint32_t n = 0, last = 0;
    bool sorted = true;
    for (uint32_t k = 0; k < count; k++) {
        const gap_t g = gap_of(h, &x[k], width);
        gap[n] = g;
        if (g.from_q30 > g.to_q30) continue;
        sorted &= g.from_q30 >= last;
        last = g.from_q30;
        n++;
    }
    if (!sorted) sort(gap, n);
    return n;
}

int halo_draw(halo_t *h, int32_t width, const halo_sink_t *sink) {
    gap_t *gap = (gap_t *)(void *)h->box;
    for (int32_t e = 0; e < h->edges; e++) {
        if (h->tick != NULL && e % HALO_TICK == 0) h->tick(h->tick_ctx, h->edges / 2 + e / 2, h->edges);
        const uint32_t from = h->first[e];
        const int32_t id = h->edge[e].id;
        uint32_t seen = 0; /* up to here all is decided */
        const uint32_t n = width == 0 ? 0 : gaps_of(h, &h->crossing[from], h->first[e + 1] - from, width, gap);
        for (uint32_t k = 0; k < n; k++) {
            if (gap[k].from_q30 > seen) {
                const int err = sink->piece(sink->ctx, id, seen, gap[k].from_q30);
                if (err != 0) return err;
            }
            if (gap[k].to_q30 > seen) seen = gap[k].to_q30;
        }
        if (seen < ONE_Q30) {
            const int err = sink->piece(sink->ctx, id, seen, ONE_Q30);
            if (err != 0) return err;
        }
    }
    return 0;
}
