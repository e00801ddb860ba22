/* plain_grid.h - the crossings of random edges by a uniform grid, as the paper has it and without further thought:
 * doubles, boxes of edges entered into cells by counting, every pair of a cell tested, a crossing counted in the cell
 * it lies in. What bench_halo.c compares with. */
#ifndef PLAIN_GRID_H
#define PLAIN_GRID_H

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

typedef struct plain_edge {
    double x0, y0, x1, y1;
} plain_edge_t;

static inline int plain_cell(double v, double cells) {
    const int c = (int)floor(v * cells); /* what reaches out of the unit square counts to the outer cells */
    return c < 0 ? 0 : c >= (int)cells ? (int)cells - 1 : c;
}

/* Edges of average length `length`; the number of crossings. */
static inline int64_t plain_grid(const plain_edge_t *e, int n, double length) {
    double cells = 1 / length;
    if (cells * cells > n) cells = sqrt(n);
    const int b = (int)cells + 1;
    uint32_t *start = calloc((size_t)b * (size_t)b + 1, sizeof *start);
    for (int i = 0; i < n; i++)
        for (int r = plain_cell(fmin(e[i].y0, e[i].y1), cells); r <= plain_cell(fmax(e[i].y0, e[i].y1), cells); r++)
            for (int c = plain_cell(fmin(e[i].x0, e[i].x1), cells); c <= plain_cell(fmax(e[i].x0, e[i].x1), cells); c++)
                start[r * b + c]++;
    uint32_t sum = 0;
    for (int c = 0; c <= b * b; c++) start[c] = sum += start[c];
    int32_t *entry = malloc((size_t)sum * sizeof *entry + 1);
    for (int i = 0; i < n; i++)
        for (int r = plain_cell(fmin(e[i].y0, e[i].y1), cells); r <= plain_cell(fmax(e[i].y0, e[i].y1), cells); r++)
            for (int c = plain_cell(fmin(e[i].x0, e[i].x1), cells); c <= plain_cell(fmax(e[i].x0, e[i].x1), cells); c++)
                entry[--start[r * b + c]] = i;
    int64_t crossings = 0;
    for (int cell = 0; cell < b * b; cell++) {
        for (uint32_t p = start[cell]; p < start[cell + 1]; p++) {
            const plain_edge_t a = e[entry[p]];
            const double ax = a.x1 - a.x0, ay = a.y1 - a.y0;
            for (uint32_t q = p + 1; q < start[cell + 1]; q++) {
                const plain_edge_t *f = &e[entry[q]];
                const double bx = f->x1 - f->x0, by = f->y1 - f->y0, x = f->x0 - a.x0, y = f->y0 - a.y0;
                const double of = ax * by - ay * bx, s = x * by - y * bx, t = x * ay - y * ax;
                if (of > 0 ? s < 0 || s > of || t < 0 || t > of : s > 0 || s < of || t > 0 || t < of) continue;
                const double at = s / of;
                if (plain_cell(a.y0 + at * ay, cells) * b + plain_cell(a.x0 + at * ax, cells) == cell) crossings++;
            }
        }
    }
    free(entry);
    free(start);
    return crossings;
}

#endif
