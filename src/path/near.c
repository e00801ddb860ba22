/* near.c - a uniform grid of cells, items sorted by cell. See near.h. */
#include "path/near.h"
#include <stddef.h>

static near_cell_t *cell_of(const near_t *g, spot_t s) {
    return &g->cell[(s.y >> g->shift_y) * g->nx + (s.x >> g->shift_x)];
}

static void set_size(near_t *g, int32_t items, int32_t crowd, int32_t x_max, int32_t y_max) {
    int32_t wanted = items / crowd + 1 < g->cells_max ? items / crowd + 1 : g->cells_max;
    near_size(wanted, x_max, y_max, &g->shift_x, &g->shift_y);
    g->nx = (x_max >> g->shift_x) + 1;
    g->ny = (y_max >> g->shift_y) + 1;
}

/* Sorts the items from[0..n) into g->item, which they may not overlap; from == NULL stands for 0..n-1. */
static void fill(near_t *g, const int32_t *from, int32_t n, int32_t crowd) {
    int32_t x_max = 0, y_max = 0;
    for (int32_t i = 0; i < n; i++) {
        spot_t s = g->spot[from ? from[i] : i];
        if (s.x > x_max) x_max = s.x;
        if (s.y > y_max) y_max = s.y;
    }
    set_size(g, n, crowd, x_max, y_max);
    for (int32_t k = 0; k < g->nx * g->ny; k++) g->cell[k] = (near_cell_t){0, 0};
    for (int32_t i = 0; i < n; i++) cell_of(g, g->spot[from ? from[i] : i])->start++;
    uint32_t sum = 0;
    for (int32_t k = 0; k < g->nx * g->ny; k++) {
        uint32_t count = g->cell[k].start;
        g->cell[k].start = sum;
        sum += count;
    }
    for (int32_t i = 0; i < n; i++) {
        int32_t item = from ? from[i] : i;
        near_cell_t *c = cell_of(g, g->spot[item]);
        g->item[c->start + c->count++] = item;
    }
}

void near_build(near_t *g, int32_t strokes, int32_t crowd) {
    g->items = 2 * strokes;
    fill(g, NULL, g->items, crowd);
}

/* What is left moves to the end of the items' memory, and is sorted from there into its beginning. */
void near_thin(near_t *g, int32_t crowd) {
    int32_t n = 0, *end = g->item + g->items;
    for (int32_t k = g->nx * g->ny - 1; k >= 0; k--) {
        const int32_t *item = &g->item[g->cell[k].start];
        for (uint32_t i = g->cell[k].count; i-- > 0;) {
            if (g->spot[item[i]].x >= 0) end[-++n] = item[i];
        }
    }
    fill(g, end - n, n, crowd);
}

const near_cell_t *near_cell_at(const near_t *g, int32_t cx, int32_t cy) {
    return cx < 0 || cy < 0 || cx >= g->nx || cy >= g->ny ? NULL : &g->cell[cy * g->nx + cx];
}

/* A search: the nearest item so far, where it is entered, and its distance. */
typedef struct search {
    near_t *g;
    spot_t at;
    int32_t cx, cy;
    near_cell_t *cell; /* or NULL */
    uint32_t place;
    uint32_t best;
} search_t;

static void forget(near_t *g, near_cell_t *c, uint32_t place) {
    g->item[c->start + place] = g->item[c->start + --c->count];
}

/* Forgets what is marked among the first of a heavy cell. */
static void forget_marked(near_t *g, near_cell_t *c) {
    for (uint32_t i = 0; i < c->count && i < NEAR_TAKE_SCAN;) {
        if (g->spot[g->item[c->start + i]].x < 0)
            forget(g, c, i);
        else
            i++;
    }
}

/* Forgets an item that is taken; a cell that has been heavy is heavy no more when none is left in it that is marked. */
static void forget_taken(near_t *g, near_cell_t *c, uint32_t place) {
    forget(g, c, place);
    if (c->count == NEAR_TAKE_SCAN) forget_marked(g, c);
}

/* Forgets the item where the search begins. In a heavy cell it may stay. */
static void forget_own(near_t *g, near_cell_t *c, int32_t item) {
    const int32_t *const of_cell = &g->item[c->start];
    for (uint32_t i = 0; i < c->count && i < NEAR_TAKE_SCAN; i++) {
        if (of_cell[i] != item) continue;
        forget_taken(g, c, i);
        return;
    }
}

/* What is nearest so far is kept without a branch, which would be guessed wrong as often as not. */
static __attribute__((noinline)) void search_cell(search_t *s, near_cell_t *c) {
    near_t *const g = s->g;
    const spot_t *const spot = g->spot, at = s->at;
    const int32_t *const item = &g->item[c->start];
    if (c->count > NEAR_TAKE_SCAN) forget_marked(g, c);
    const uint32_t count = c->count < NEAR_TAKE_SCAN ? c->count : NEAR_TAKE_SCAN;
    uint32_t best = s->best, place = count;
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t d = near_square(spot[item[i]], at);
        place = d < best ? i : place;
        best = d < best ? d : best;
    }
    if (place == count) return;
    s->best = best;
    s->cell = c;
    s->place = place;
}

/* How far it is from v to the cells that are `by` (of either sign) columns or rows away from its own, c. */
static uint32_t away(int32_t v, int32_t c, int shift, int32_t by) {
    int32_t d = by > 0 ? (c + by) * (1 << shift) - v : by < 0 ? v - (c + by + 1) * (1 << shift) + 1 : 0;
    return d < 0 ? 0 : (uint32_t)d;
}

/* Row cy + r of cells: from column cx - out to cx + out, those `step` apart. */
static void search_row(search_t *s, int32_t r, int32_t out, int32_t step) {
    near_t *g = s->g;
    int32_t y = s->cy + r;
    if (y < 0 || y >= g->ny) return;
    uint32_t dy = away(s->at.y, s->cy, g->shift_y, r);
    if (dy * dy >= s->best) return;
    for (int32_t i = -out; i <= out; i += step) {
        int32_t x = s->cx + i;
        if (x < 0 || x >= g->nx) continue;
        near_cell_t *c = &g->cell[y * g->nx + x];
        if (c->count == 0) continue;
        uint32_t dx = away(s->at.x, s->cx, g->shift_x, i);
        if (dx * dx + dy * dy < s->best) search_cell(s, c);
    }
}

/* The square of how far the cells on one side are, or NEAR_FAR if there are none. */
static uint32_t border(int32_t v, int32_t c, int shift, int32_t by, int32_t cells) {
    if (c + by < 0 || c + by >= cells) return NEAR_FAR;
    const uint32_t d = away(v, c, shift, by);
    return d * d;
}

/* The eight cells around that of the place, where most searches end, those beside it first; each only if it is nearer
 * than what has been found. */
static void search_around(search_t *s) {
    const near_t *g = s->g;
    near_cell_t *own = &g->cell[s->cy * g->nx + s->cx];
    const uint32_t left = border(s->at.x, s->cx, g->shift_x, -1, g->nx),
                   right = border(s->at.x, s->cx, g->shift_x, 1, g->nx);
    const uint32_t below = border(s->at.y, s->cy, g->shift_y, -1, g->ny),
                   above = border(s->at.y, s->cy, g->shift_y, 1, g->ny);
    if (left < s->best) search_cell(s, own - 1);
    if (right < s->best) search_cell(s, own + 1);
    if (below < s->best) search_cell(s, own - g->nx);
    if (above < s->best) search_cell(s, own + g->nx);
    if (left + below < s->best) search_cell(s, own - g->nx - 1);
    if (right + below < s->best) search_cell(s, own - g->nx + 1);
    if (left + above < s->best) search_cell(s, own + g->nx - 1);
    if (right + above < s->best) search_cell(s, own + g->nx + 1);
}

/* The square of how far the nearest cells r columns or rows away are. */
static uint32_t ring_square(const search_t *s, int32_t r) {
    const near_t *g = s->g;
    uint32_t nearest = UINT32_MAX;
    for (int32_t by = -r; by <= r; by += 2 * r) {
        const uint32_t x = away(s->at.x, s->cx, g->shift_x, by), y = away(s->at.y, s->cy, g->shift_y, by);
        if (x < nearest) nearest = x;
        if (y < nearest) nearest = y;
    }
    return nearest * nearest;
}

int32_t near_take(near_t *g, spot_t at, int32_t from) {
    search_t s = {.g = g, .at = at, .best = NEAR_FAR};
    s.cx = near_clamp(at.x >> g->shift_x, g->nx - 1);
    s.cy = near_clamp(at.y >> g->shift_y, g->ny - 1);
    near_cell_t *own = &g->cell[s.cy * g->nx + s.cx];
    forget_own(g, own, from);
    search_cell(&s, own);
    const int32_t rings = g->nx > g->ny ? g->nx : g->ny;
    for (int32_t r = 1; r < rings && ring_square(&s, r) < s.best; r++) {
        if (r == 1) {
            search_around(&s);
            continue;
        }
        search_row(&s, -r, r, 1);
        for (int32_t k = 1 - r; k < r; k++) search_row(&s, k, r, 2 * r);
        search_row(&s, r, r, 1);
    }
    if (!s.cell) return -1;
    const int32_t found = g->item[s.cell->start + s.place];
    forget_taken(g, s.cell, s.place);
    return found;
}
