/* halo_cut.c - CUT: which edges cross, and which of the two is nearer. See halo.h.
 *
 * Candidates come from halo_grid.h. What is left of them after the comparison of boxes is collected before it is looked
 * at: a loop without branches that are hard to predict. */
#include "hidden/halo/halo_grid.h"

#include "error.h"
#include "hidden/halo/halo_meet.h"

#define FEW 12   /* crossings of an edge sorted by insertion */
#define BATCH 32 /* candidates looked at together: 128 bytes of stack */

/* Looks at the pairs of edge i with the edges from..to-1. */
static void look(halo_t *h, uint32_t i, uint64_t probe, uint32_t from, uint32_t to) {
    uint32_t found[BATCH];
    while (from < to) {
        const uint32_t end = to - from > BATCH ? from + BATCH : to;
        int n = 0;
        for (uint32_t j = from; j < end; j++) {
            found[n] = j;
            n += ((probe - h->box[j]) & HALO_GUARDS) == HALO_GUARDS;
        }
        h->tests += n;
        for (int k = 0; k < n; k++) {
            if (h->joining) {
                halo_join(h, i, found[k]);
            } else {
                halo_meet(h, i, found[k]);
            }
        }
        from = end;
    }
}

/* Looks at the edges of the finer grid `level` that are at home along edge i: row by row, the columns in which the edge
 * comes near. A home lies a row or column before what it is home of. Edge and box are rounded to fine units, so the
 * edge is taken 2 units thicker. */
static void look_along(const halo_grid_t *g, halo_t *h, uint32_t i, uint64_t probe, int level) {
    const halo_edge_t *e = &h->edge[i];
    const uint64_t box = h->box[i];
    const int shift = g->shift + level;
    const int32_t wide = g->wide[level], high = (g->base[level + 1] - g->base[level]) / wide, thick = g->pad + 2;
    const halo_point_t *low = e->p.y < e->q.y ? &e->p : &e->q, *top = e->p.y < e->q.y ? &e->q : &e->p;
    const int32_t x = halo_fine(g, low->x, g->x0), y = halo_fine(g, low->y, g->y0);
    const int32_t dx = halo_fine(g, top->x, g->x0) - x, dy = halo_fine(g, top->y, g->y0) - y;
    const int32_t slope_q16 = dy == 0 ? 0 : dx * 65536 / dy;
    const int32_t left = halo_left(box), right = halo_right(box);
    int32_t row = (halo_bottom(box) >> shift) - 1, last = halo_top(box) >> shift;
    if (row < 0) row = 0;
    if (last > high - 1) last = high - 1;
    for (; row <= last; row++) {
        int32_t from = left, to = right;
        if (dy != 0) {
            int32_t y0 = (row << shift) - thick - y, y1 = ((row + 2) << shift) + thick - y;
            if (y0 < 0) y0 = 0;
            if (y1 > dy) y1 = dy;
            if (y1 < 0) y1 = 0; /* beyond an end, but for what the box is larger */
            if (y0 > dy) y0 = dy;
            int32_t x0 = x + (int32_t)((int64_t)y0 * slope_q16 >> 16),
                    x1 = x + (int32_t)((int64_t)y1 * slope_q16 >> 16);
            int32_t l = (x0 < x1 ? x0 : x1) - thick, r = (x0 < x1 ? x1 : x0) + thick;
            if (l > from) from = l;
            if (r < to) to = r;
        }
        from = (from >> shift) - 1;
        to >>= shift;
        if (from < 0) from = 0;
        if (to > wide - 1) to = wide - 1;
        const int32_t cell = g->base[level] + row * wide;
        if (from <= to) look(h, i, probe, g->start[cell + from], g->start[cell + to + 1]);
    }
}

/* All pairs. */
static void look_all(const halo_grid_t *g, halo_t *h) {
    for (int level = 0; level < g->levels; level++) {
        const int shift = g->shift + level;
        const uint32_t end = g->start[g->base[level + 1]];
        for (uint32_t i = g->start[g->base[level]]; i < end; i++) {
            if (h->tick != NULL && i % HALO_TICK == 0) h->tick(h->tick_ctx, (int32_t)i / 2, h->edges);
            const uint64_t box = h->box[i], probe = halo_probe(box);
            const int32_t c = halo_left(box) >> shift, r = halo_bottom(box) >> shift;
            const int32_t over = (halo_right(box) >> shift) - c;
            const uint32_t *cell = &g->start[g->base[level] + r * g->wide[level] + c];
            look(h, i, probe, i + 1, cell[1 + over]);
            if (halo_top(box) >> shift > r) {
                const uint32_t *above = cell + g->wide[level];
                look(h, i, probe, above[c > 0 ? -1 : 0], above[1 + over]);
            }
            for (int finer = 0; finer < level; finer++) {
                if (g->start[g->base[finer]] != g->start[g->base[finer + 1]]) look_along(g, h, i, probe, finer);
            }
        }
    }
}

/* Groups the crossings by edge; first[] holds how many each has. In place if it must be: with room for all of them
 * twice they are copied, which does not wait for memory at each of them. */
static void group(halo_t *h) {
    const uint32_t placed = UINT32_C(1) << 31;
    uint32_t sum = 0;
    for (int32_t e = 0; e < h->edges; e++) h->first[e] = sum += h->first[e];
    h->first[h->edges] = sum;
    if (h->room / 2 >= sum) {
        for (uint32_t p = sum; p > 0; p--) h->crossing[sum + --h->first[h->crossing[p - 1].edge]] = h->crossing[p - 1];
        h->crossing += sum;
        return;
    }
    for (uint32_t p = 0; p < sum; p++) {
        halo_crossing_t x = h->crossing[p];
        if (x.edge & placed) continue;
        for (uint32_t to = UINT32_MAX; to != p;) {
            to = --h->first[x.edge];
            const halo_crossing_t there = h->crossing[to];
            x.edge |= placed;
            h->crossing[to] = x;
            x = there;
        }
    }
    for (uint32_t p = 0; p < sum; p++) h->crossing[p].edge &= ~placed;
}

/* Sorts the crossings of edges with few of them along the edge, so that DRAW has hardly anything left to sort. */
static void sort_few(halo_t *h) {
    for (int32_t e = 0; e < h->edges; e++) {
        halo_crossing_t *x = &h->crossing[h->first[e]];
        const uint32_t n = h->first[e + 1] - h->first[e];
        for (uint32_t k = 1; n <= FEW && k < n; k++) {
            const halo_crossing_t c = x[k];
            uint32_t at = k;
            for (; at > 0 && x[at - 1].at_q30 > c.at_q30; at--) x[at] = x[at - 1];
            x[at] = c;
        }
    }
}

static size_t round_up(size_t bytes) {
    return (bytes + 15) & ~(size_t)15;
}

int halo_cut(halo_t *h, int32_t reach) {
    halo_grid_t g;
    const size_t n = (size_t)h->edges, edges = round_up(n * sizeof *h->edge), boxes = n * sizeof *h->box;
    const size_t firsts = (n + 1) * sizeof *h->first, joins = reach == 0 ? 0 : n;
    const size_t lists = round_up(edges + boxes + firsts + joins);
    h->reach = reach;
    h->crossings = -1;
    h->tests = 0;
    if (lists > h->bytes) return ERR_FULL;
    h->box = (uint64_t *)(void *)(h->mem + edges);
    h->first = (uint32_t *)(void *)(h->mem + edges + boxes);
    for (size_t e = 0; e <= n; e++) h->first[e] = 0;
    h->joined = reach == 0 ? NULL : h->mem + edges + boxes + firsts;
    for (size_t e = 0; e < joins; e++) h->joined[e] = 0;
    h->crossings = 0;
    h->used = lists;
    if (n == 0) return 0;
    const uint8_t *end = halo_grid_build(&g, h, h->mem + lists, h->bytes - lists);
    if (end == NULL) {
        h->crossings = -1;
        return ERR_FULL;
    }
    const size_t before = round_up((size_t)(end - h->mem));
    h->crossing = (halo_crossing_t *)(void *)(h->mem + before);
    h->room = before > h->bytes ? 0 : (int64_t)((h->bytes - before) / sizeof *h->crossing);
    if (reach != 0) {
        h->joining = true;
        look_all(&g, h);
        h->joining = false;
        h->tests = 0;
    }
    look_all(&g, h);
    h->used = before + (size_t)h->crossings * sizeof *h->crossing;
    if (h->crossings > h->room) return ERR_FULL;
    group(h);
    sort_few(h);
    return 0;
}
