/* page_grid.c - see page_grid.h: a counting sort by cells, and a walk row by row. */
#include "hidden/solid/page_grid.h"

#include "error.h"
#include "num/ints.h"
#include <string.h>

#define MARGIN 2 /* lat: places are rounded */
#define FINE 4   /* cells for each box at most: a scene fills half of its window, and lines are short */

typedef struct cells {
    int32_t c0, r0, c1, r1; /* inclusive; empty if c0 > c1 */
} cells_t;

page_box_t page_grid_window(const solid_map_t *m) {
    const page_window_t *w = m->lines.window;
    page_box_t box = {w->x0_lat, w->y0_lat, w->x1_lat, w->y1_lat};
    if (m->any_behind) return box;
    page_box_t all = {INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN};
    for (int32_t v = 0; v < m->solid->nv; v++) {
        const solid_place_t *p = &m->place[v];
        if (p->x < all.x0) all.x0 = p->x;
        if (p->x > all.x1) all.x1 = p->x;
        if (p->y < all.y0) all.y0 = p->y;
        if (p->y > all.y1) all.y1 = p->y;
    }
    if (all.x0 > box.x0) box.x0 = all.x0 < box.x1 ? all.x0 : box.x1;
    if (all.y0 > box.y0) box.y0 = all.y0 < box.y1 ? all.y0 : box.y1;
    if (all.x1 < box.x1) box.x1 = all.x1 > box.x0 ? all.x1 : box.x0;
    if (all.y1 < box.y1) box.y1 = all.y1 > box.y0 ? all.y1 : box.y0;
    return box;
}

static cells_t cells_of(const page_grid_t *g, const page_box_t *b) {
    const page_box_t *w = &g->window;
    if (b->x1 < w->x0 - MARGIN || b->x0 > w->x1 + MARGIN || b->y1 < w->y0 - MARGIN || b->y0 > w->y1 + MARGIN)
        return (cells_t){1, 1, 0, 0};
    cells_t c = {0, 0, g->columns - 1, g->rows - 1};
    if (b->x0 - MARGIN > w->x0) c.c0 = (b->x0 - MARGIN - w->x0) >> g->shift;
    if (b->y0 - MARGIN > w->y0) c.r0 = (b->y0 - MARGIN - w->y0) >> g->shift;
    if (b->x1 + MARGIN < w->x1) c.c1 = (b->x1 + MARGIN - w->x0) >> g->shift;
    if (b->y1 + MARGIN < w->y1) c.r1 = (b->y1 + MARGIN - w->y0) >> g->shift;
    return c;
}

static void set_shift(page_grid_t *g, int32_t shift) {
    g->shift = shift;
    g->columns = ((g->window.x1 - g->window.x0) >> shift) + 1;
    g->rows = ((g->window.y1 - g->window.y0) >> shift) + 1;
}

static int64_t count(const page_grid_t *g, int32_t n, page_box_t (*box)(void *ctx, int32_t k), void *ctx) {
    int64_t entries = 0;
    for (int32_t k = 0; k < n; k++) {
        page_box_t b = box(ctx, k);
        cells_t c = cells_of(g, &b);
        entries += (int64_t)(c.c1 - c.c0 + 1) * (c.r1 - c.r0 + 1);
    }
    return entries;
}

static void sort(page_grid_t *g, int32_t n, page_box_t (*box)(void *ctx, int32_t k), void *ctx) {
    int32_t cells = g->columns * g->rows;
    memset(g->start, 0, ((size_t)cells + 1) * sizeof *g->start);
    for (int pass = 0; pass < 2; pass++) {
        for (int32_t k = 0; k < n; k++) {
            page_box_t b = box(ctx, k);
            cells_t c = cells_of(g, &b);
            for (int32_t r = c.r0; r <= c.r1; r++)
                for (int32_t i = c.c0; i <= c.c1; i++) {
                    int32_t *at = &g->start[r * g->columns + i];
                    if (pass == 0)
                        ++*at;
                    else
                        g->entry[--*at] = k;
                }
        }
        if (pass == 1) break;
        for (int32_t i = 0; i < cells; i++) g->start[i + 1] += g->start[i]; /* ends, which fill downwards */
    }
}

int page_grid_build(page_grid_t *g, const page_box_t *window, int32_t n, page_box_t (*box)(void *ctx, int32_t k),
                    void *ctx, void *mem, size_t bytes) {
    *g = (page_grid_t){.window = *window, .start = mem};
    int64_t room = (int64_t)(bytes / sizeof(int32_t));
    int64_t width = (int64_t)window->x1 - window->x0, height = (int64_t)window->y1 - window->y0;
    int32_t shift = 0;
    while (((width >> shift) + 1) * ((height >> shift) + 1) > FINE * ((int64_t)n + 1)) shift++;
    for (;; shift++) {
        set_shift(g, shift);
        int64_t cells = (int64_t)g->columns * g->rows, entries = count(g, n, box, ctx);
        /* boxes that cover many cells are no better found by many */
        bool fits = cells + 1 + entries <= (cells > (int64_t)n + 1 ? room / 2 : room);
        if (fits && (entries <= 8 * (int64_t)n + 64 || cells == 1)) {
            g->entry = g->start + cells + 1;
            g->bytes = (size_t)(cells + 1 + entries) * sizeof(int32_t);
            sort(g, n, box, ctx);
            return 0;
        }
        if (cells == 1) return ERR_FULL;
    }
}

/* Columns first .. last of a row lie side by side. */
static bool visit_cells(const page_grid_t *g, int32_t row, int32_t first, int32_t last, page_grid_visit_t *visit,
                        void *ctx) {
    const int32_t *cell = &g->start[row * g->columns];
    return visit(ctx, g->entry + cell[first], g->entry + cell[last + 1]);
}

static bool visit_all(const page_grid_t *g, const cells_t *c, page_grid_visit_t *visit, void *ctx) {
    for (int32_t r = c->r0; r <= c->r1; r++)
        if (!visit_cells(g, r, c->c0, c->c1, visit, ctx)) return false;
    return true;
}

bool page_grid_visit(const page_grid_t *g, const page_box_t *box, page_grid_visit_t *visit, void *ctx) {
    const cells_t c = cells_of(g, box);
    return visit_all(g, &c, visit, ctx);
}

void page_grid_walk(const page_grid_t *g, const solid_place_t *a, const solid_place_t *b, int32_t off_lat,
                    page_grid_visit_t *visit, void *ctx) {
    if (a->y > b->y) {
        const solid_place_t *swap = a;
        a = b;
        b = swap;
    }
    const page_box_t box = {(a->x < b->x ? a->x : b->x) - off_lat, a->y - off_lat,
                            (a->x < b->x ? b->x : a->x) + off_lat, b->y + off_lat};
    const cells_t c = cells_of(g, &box);
    if (c.c0 > c.c1) return;
    if (c.r0 == c.r1 || c.c0 == c.c1 || a->y == b->y) { /* a level line between two rows is in both */
        visit_all(g, &c, visit, ctx);
        return;
    }
    /* |dx| <= 2^30, and what the slope is multiplied by is at most dy */
    const int64_t dy = (int64_t)b->y - a->y, slope_q30 = ((int64_t)b->x - a->x) * ((int64_t)1 << 30) / dy;
    const int32_t margin = MARGIN + off_lat;
    for (int32_t r = c.r0; r <= c.r1; r++) { /* the part of the line in each row */
        int64_t low = g->window.y0 + ((int64_t)r << g->shift) - margin - a->y,
                high = low + ((int64_t)1 << g->shift) + 2 * margin;
        if (low < 0) low = 0;
        if (low > dy) low = dy;
        if (high > dy) high = dy;
        if (high < 0) high = 0;
        const int32_t from = a->x + (int32_t)(slope_q30 * low >> 30), to = a->x + (int32_t)(slope_q30 * high >> 30);
        /* a lat more than places are off, for the slope */
        int32_t first = ((from < to ? from : to) - margin - 1 - g->window.x0) >> g->shift,
                last = ((from < to ? to : from) + margin + 1 - g->window.x0) >> g->shift;
        if (first < c.c0) first = c.c0;
        if (last > c.c1) last = c.c1;
        if (first <= last && !visit_cells(g, r, first, last, visit, ctx)) return;
    }
}
