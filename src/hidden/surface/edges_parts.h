/* edges_parts.h - what edges.c, edges_around.c and edges_windows.c share, and nobody else. */
#ifndef EDGES_PARTS_H
#define EDGES_PARTS_H

#include "hidden/surface/edges.h"

#define ONE_Q30 (INT32_C(1) << 30)

static inline uint32_t size32(int32_t v) {
    return v < 0 ? 0u - (uint32_t)v : (uint32_t)v;
}

static inline int64_t fine_of_q30(int32_t part_q30) {
    return (int64_t)part_q30 << (INK_GRID_BITS - 30);
}

/* whole * part / 2^46, rounded down. */
int64_t edges_scale(int64_t whole, int64_t part_q46);
/* 2^46 num / den, rounded down; num <= den < 2^63. */
int64_t edges_fraction(uint64_t num, uint64_t den);

/* A point of an edge relative to the eye. */
typedef struct place {
    int32_t x, y;
    int64_t z; /* |z| < 2^60 */
} edges_place_t;

/* Takes a visible part of the line at hand, in fractions of the chart, and places it on the edge in space. */
int edges_take_part(void *ctx, envelope_part_t part, bool first);
/* Takes the part [s0, s1] of the edge without asking what is in front of it. */
int edges_take_unseen(edges_t *e, int64_t s0, int64_t s1);
/* Clips a line of the chart, or notes it as a side of the facet at hand. */
int edges_clip_line(edges_t *e, pencil_t p0, pencil_t p1);
/* Is the facet at hand to the right of a vertical line? Then one of its sides begins there. */
bool edges_facet_is_right(const edges_t *e, pencil_t p0, pencil_t p1);
/* An edge of CHART_AROUND that is not one line of the chart: cut at the diagonals, at zones, or right below the eye. */
int edges_clip_around(edges_t *e, edges_place_t p, edges_place_t q);
/* The part [s0, s1] of an edge or a segment of CHART_AROUND that lies in one sector. */
int edges_clip_in_sector(edges_t *e, edges_place_t a, edges_place_t b, int64_t s0, int64_t s1);
/* Clips a line against horizons and windows; a bare one leaves windows between it and the horizons. */
int edges_clip_windowed(edges_t *e, pencil_t p0, pencil_t p1);

#endif
