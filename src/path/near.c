/* near.c - a uniform grid of cells, items sorted by cell. See near.h. */
#include "path/near.h"
#include <stddef.h>

#define SPOTS_ACROSS 46340 /* the longest distance there is, 2^15 sqrt 2, and just below 2^15.5 */

static near_cell_t *cell_of(const near_t *g, spot_t s) {
    return &g->cell[(s.y >> g->shift) * g->nx + (s.x >> g->shift)];
}

static bool is_out(const int32_t *place, int32_t item) {
    return place && place[item >> 1] >= 0;
}

static void set_size(near_t *g, int32_t items, int32_t x_max, int32_t y_max) {
    int32_t wanted = items / 4 + 1 < g->cells_max ? items / 4 + 1 : g->cells_max;
    for (g->shift = 0; g->shift < 15; g->shift++) {
        if (((x_max >> g->shift) + 1) * ((y_max >> g->shift) + 1) <= wanted) break;
    }
    g->nx = (x_max >> g->shift) + 1;
    g->ny = (y_max >> g->shift) + 1;
}

void near_build(near_t *g, int32_t strokes, const int32_t *place) {
    int32_t items = 0, x_max = 0, y_max = 0;
    for (int32_t i = 0; i < 2 * strokes; i++) {
        if (is_out(place, i)) continue;
        items++;
        if (g->spot[i].x > x_max) x_max = g->spot[i].x;
        if (g->spot[i].y > y_max) y_max = g->spot[i].y;
    }
    set_size(g, items, x_max, y_max);
    for (int32_t k = 0; k < g->nx * g->ny; k++) g->cell[k] = (near_cell_t){0, 0};
    for (int32_t i = 0; i < 2 * strokes; i++) {
        if (!is_out(place, i)) cell_of(g, g->spot[i])->start++;
    }
    uint32_t sum = 0;
    for (int32_t k = 0; k < g->nx * g->ny; k++) {
        uint32_t n = g->cell[k].start;
        g->cell[k].start = sum;
        sum += n;
    }
    for (int32_t i = 0; i < 2 * strokes; i++) {
        if (is_out(place, i)) continue;
        near_cell_t *c = cell_of(g, g->spot[i]);
        g->item[c->start + c->count++] = i;
    }
}

const near_cell_t *near_cell_at(const near_t *g, int32_t cx, int32_t cy) {
    return cx < 0 || cy < 0 || cx >= g->nx || cy >= g->ny ? NULL : &g->cell[cy * g->nx + cx];
}

/* Looks for something nearer than *best in the cell (cx, cy). */
static void take_from_cell(near_t *g, int32_t cx, int32_t cy, spot_t at, const int32_t *place, uint32_t *best,
                           int32_t *found) {
    near_cell_t *c = &g->cell[cy * g->nx + cx];
    int32_t *item = &g->item[c->start];
    for (uint32_t i = 0, looked = 0; i < c->count && looked < NEAR_CELL_SCAN;) {
        if (place[item[i] >> 1] >= 0) {
            item[i] = item[--c->count];
            continue;
        }
        uint32_t d = near_square(g->spot[item[i]], at);
        if (d < *best) *best = d, *found = item[i];
        i++, looked++;
    }
}

static int32_t clamp(int32_t v, int32_t max) {
    return v < 0 ? 0 : v > max ? max : v;
}

/* Is everything outside ring r farther than `square`? */
static bool is_settled(const near_t *g, spot_t at, int32_t cx, int32_t cy, int32_t r, uint32_t square) {
    int32_t left = at.x - (cx - r) * (1 << g->shift), right = (cx + r + 1) * (1 << g->shift) - at.x;
    int32_t down = at.y - (cy - r) * (1 << g->shift), up = (cy + r + 1) * (1 << g->shift) - at.y;
    int32_t x = left < right ? left : right, y = down < up ? down : up, margin = x < y ? x : y;
    return margin > SPOTS_ACROSS || (margin > 0 && square <= (uint32_t)(margin * margin));
}

int32_t near_take(near_t *g, spot_t at, const int32_t *place) {
    int32_t cx = clamp(at.x >> g->shift, g->nx - 1), cy = clamp(at.y >> g->shift, g->ny - 1);
    int32_t found = -1, rings = g->nx > g->ny ? g->nx : g->ny;
    uint32_t best = UINT32_MAX;
    for (int32_t r = 0; r < rings; r++) {
        int32_t y0 = cy - r, y1 = cy + r;
        for (int32_t y = y0 < 0 ? 0 : y0; y <= y1 && y < g->ny; y++) {
            bool whole = y == y0 || y == y1;
            int32_t x = cx - r, step = whole || r == 0 ? 1 : 2 * r;
            for (; x <= cx + r; x += step) {
                if (x >= 0 && x < g->nx) take_from_cell(g, x, y, at, place, &best, &found);
            }
        }
        if (found >= 0 && is_settled(g, at, cx, cy, r, best)) break;
    }
    return found;
}
