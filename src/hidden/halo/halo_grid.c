/* halo_grid.c - see halo_grid.h. */
#include "hidden/halo/halo_grid.h"

#include "num/ints.h"
#include <stdbool.h>

#define FINE_BITS 15
#define CELLS_MAX 2048 /* a side */
#define PLACED (UINT64_C(1) << 63)
#define MANY 65536 /* edges beyond which sorting row by row first keeps to the caches, and pays */

static int32_t extent(int32_t a, int32_t b) {
    return a < b ? b - a : a - b;
}

/* 16 log2(v), to a sixteenth or so; 0 for 0. */
static uint32_t log2_q4(uint32_t v) {
    if (v == 0) return 0;
    const int top = 31 - ints_clz32(v);
    return (uint32_t)top << 4 | (uint32_t)((uint64_t)v << 4 >> top & 15);
}
static uint32_t exp2_q4(uint32_t l) {
    const uint32_t top = l >> 4;
    return (uint32_t)((UINT64_C(16) + (l & 15)) << top >> 4);
}

/* By how much boxes are larger than their edges, so that those overlap whose edges are within reach of each other: half
 * of what the corner of a halo that lies at 45 degrees reaches. */
static int32_t growth(const halo_t *h) {
    return h->reach == 0 ? 0 : h->reach / 4 * 3 + 3;
}

/* Chooses the number of cells and the scale of the fine units. */
static void size_up(halo_grid_t *g, const halo_t *h) {
    int32_t x0 = INT32_MAX, y0 = INT32_MAX, x1 = INT32_MIN, y1 = INT32_MIN;
    uint64_t logs = 0;
    for (int32_t i = 0; i < h->edges; i++) {
        const halo_edge_t *e = &h->edge[i];
        const int32_t l = e->p.x < e->q.x ? e->p.x : e->q.x, r = e->p.x < e->q.x ? e->q.x : e->p.x;
        const int32_t b = e->p.y < e->q.y ? e->p.y : e->q.y, t = e->p.y < e->q.y ? e->q.y : e->p.y;
        if (l < x0) x0 = l;
        if (r > x1) x1 = r;
        if (b < y0) y0 = b;
        if (t > y1) y1 = t;
        logs += log2_q4((uint32_t)(r - l > t - b ? r - l : t - b));
    }
    const int32_t grow = growth(h);
    const uint32_t wide = (uint32_t)extent(x0, x1) + 2 * (uint32_t)grow + 1;
    const uint32_t high = (uint32_t)extent(y0, y1) + 2 * (uint32_t)grow + 1;
    const uint32_t span = wide > high ? wide : high;
    /* Twice the geometric mean of the lengths, which a few enormous edges do not spoil; and no more cells than edges.
     */
    uint32_t mean = exp2_q4((uint32_t)(logs / (uint32_t)h->edges)) + 2 * (uint32_t)grow + 1;
    uint64_t cells = (uint64_t)span / (mean * 2) + 1;
    const uint64_t most = ints_sqrt_u64((uint64_t)h->edges * span / (wide < high ? wide : high)) + 1;
    if (cells > most) cells = most;
    if (cells > (uint32_t)h->edges) cells = (uint32_t)h->edges;
    if (cells > CELLS_MAX) cells = CELLS_MAX;
    g->shift = FINE_BITS;
    while (cells << g->shift > 1 << FINE_BITS) g->shift--;
    /* fine = (v - origin) * mul >> mul_shift < cells << shift */
    g->x0 = x0 - grow;
    g->y0 = y0 - grow;
    g->mul_shift = 32 + (31 - ints_clz32(span | 1)) - FINE_BITS;
    if (g->mul_shift < 0) g->mul_shift = 0;
    uint64_t mul = ((cells << g->shift) << g->mul_shift) / span;
    while (mul >> 32 != 0) {
        mul >>= 1;
        g->mul_shift--;
    }
    g->mul = (uint32_t)mul;
    g->levels = 0;
    g->base[0] = g->row[0] = 0;
    int32_t columns = halo_fine(g, x1 + grow, g->x0) >> g->shift, rows = halo_fine(g, y1 + grow, g->y0) >> g->shift;
    for (bool more = true; more; columns >>= 1, rows >>= 1) {
        g->wide[g->levels] = columns + 1;
        g->base[g->levels + 1] = g->base[g->levels] + (columns + 1) * (rows + 1);
        g->row[g->levels + 1] = g->row[g->levels] + rows + 1;
        g->levels++;
        more = columns > 1 || rows > 1;
    }
    g->cells = g->base[g->levels];
}

static uint64_t box_of(const halo_grid_t *g, const halo_edge_t *e, int32_t grow) {
    const int32_t l = e->p.x < e->q.x ? e->p.x : e->q.x, r = e->p.x < e->q.x ? e->q.x : e->p.x;
    const int32_t b = e->p.y < e->q.y ? e->p.y : e->q.y, t = e->p.y < e->q.y ? e->q.y : e->p.y;
    const uint32_t left = (uint32_t)halo_fine(g, l - grow, g->x0), right = (uint32_t)halo_fine(g, r + grow, g->x0);
    const uint32_t bottom = (uint32_t)halo_fine(g, b - grow, g->y0), top = (uint32_t)halo_fine(g, t + grow, g->y0);
    return left | bottom << 16 | (uint64_t)((0x7fff - right) | (0x7fff - top) << 16) << 32;
}

/* The cell of an edge's home, or the number of its row. */
static inline int32_t home(const halo_grid_t *g, uint64_t box, bool row) {
    int level = 0;
    int32_t c = halo_left(box) >> g->shift, r = halo_bottom(box) >> g->shift;
    int32_t c1 = halo_right(box) >> g->shift, r1 = halo_top(box) >> g->shift;
    while (c1 - c > 1 || r1 - r > 1) level++, c >>= 1, r >>= 1, c1 >>= 1, r1 >>= 1;
    return row ? g->row[level] + r : g->base[level] + r * g->wide[level] + c;
}

/* Sorts in place by home, or only by row, and leaves in start[] where each begins. PLACED says which edges are where
 * they belong: those that have it when sorting by row, those that have it not when sorting by home, which so ends
 * without. */
static void sort(const halo_grid_t *g, halo_t *h, bool row) {
    const int32_t n = h->edges, cells = row ? g->row[g->levels] : g->cells;
    const uint64_t placed = row ? PLACED : 0;
    uint32_t *start = g->start, sum = 0;
    for (int32_t c = 0; c <= cells; c++) start[c] = 0;
    for (int32_t i = 0; i < n; i++) start[home(g, h->box[i], row)]++;
    for (int32_t c = 0; c <= cells; c++) start[c] = sum += start[c];
    /* Whatever is at p goes to the last free place of its cell, and what was there is next. */
    for (int32_t p = 0; p < n; p++) {
        uint64_t box = h->box[p];
        if ((box & PLACED) == placed) continue;
        halo_edge_t e = h->edge[p];
        for (int32_t to = -1; to != p;) {
            to = (int32_t)--start[home(g, box, row)];
            const uint64_t box_there = h->box[to];
            const halo_edge_t e_there = h->edge[to];
            h->box[to] = box ^ PLACED;
            h->edge[to] = e;
            box = box_there;
            e = e_there;
        }
    }
}

uint8_t *halo_grid_build(halo_grid_t *g, halo_t *h, uint8_t *mem, size_t bytes) {
    size_up(g, h);
    const int32_t grow = growth(h);
    const size_t size = ((size_t)g->cells + 1) * sizeof *g->start;
    if (size > bytes) return NULL;
    g->start = (uint32_t *)(void *)mem;
    g->pad = h->reach == 0 ? 0 : (int32_t)((uint64_t)(uint32_t)grow * g->mul >> g->mul_shift) + 1;
    const bool many = h->edges > MANY;
    for (int32_t i = 0; i < h->edges; i++) h->box[i] = box_of(g, &h->edge[i], grow) | (many ? 0 : PLACED);
    if (many) sort(g, h, true);
    sort(g, h, false);
    return mem + size;
}
