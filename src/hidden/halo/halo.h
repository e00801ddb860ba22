/* halo.h - wire frames with haloes: where a line passes behind another it is interrupted, so one sees which is in
 * front.
 *
 * Franklin & Akman, "A Simple and Efficient Haloed Line Algorithm for Hidden Line Elimination" (1987). Two parts as in
 * the paper: CUT finds where edges cross on the page and which of the two is nearer (halo_cut.c); DRAW leaves out of
 * each edge what is closer to a nearer one than the halo's width (halo_draw.c), and alone is run again for another
 * width.
 *
 * What is decided, all of it from integers and without rounding:
 * - Two edges cross if they have exactly one point of the page in common, their ends included.
 * - The order there is the sign of a determinant (the volume of the two edges' tetrahedron). Edges that pass each other
 *   so closely that moving their ends by `contact` units could reverse the order are in contact, and do not cut each
 *   other: edges that meet in a vertex, bars that lie in one plane, a beam that ends on another.
 * - Edges on one line of the page (parallel ones, dots) do not cross.
 * The farther edge loses W / sin(angle) to either side of a crossing, measured along it: the strip of halfwidth W along
 * the nearer edge. Where the angle is below 45 degrees that reaches far; it ends where the nearer edge does, W beyond
 * its end. Gaps that overlap are one. With a reach (halo_cut) edges need not cross: the halo of an edge also takes from
 * others what is less than W beside it or beyond its end (the paper's section 5). The order is then that at the points
 * where the two are closest. It does not reach beyond an end where another edge begins, or a finely cut curve would be
 * eaten by its own halo; and edges of one plane leave each other alone, unless nearly parallel.
 *
 * The result depends on neither the order of the edges nor their direction (but for the rounding of a gap's end, 2^-28
 * of an edge).
 *
 * Memory: HALO_BYTES_PER_EDGE for an edge with its share of the grid, HALO_BYTES_PER_CROSSING for a crossing, lent by
 * the caller until the last DRAW. Context: main loop. No division but one a crossing; no recursion.
 * Cost: edges + crossings for scenes that are more or less homogeneous (tests/bench/bench_halo.c). */
#ifndef HALO_H
#define HALO_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define HALO_XY_MAX (INT32_C(1) << 29) /* |x|, |y| */
#define HALO_Z_MAX (INT32_C(1) << 28)  /* |z| */
#define HALO_EDGES_MAX (1 << 24)
#define HALO_WIDTH_MIN 16 /* or 0 */
#define HALO_CONTACT_MAX (1 << 16)
#define HALO_WIDTH_MAX (INT32_C(1) << 24)
#define HALO_BYTES_PER_EDGE 56 /* at most, and 512 in all */
#define HALO_BYTES_PER_EDGE_LEAST 40
#define HALO_BYTES_PER_CROSSING 16
#define HALO_BYTES(edges, crossings) (512 + HALO_BYTES_PER_EDGE * (size_t)(edges) + 16 * (size_t)(crossings))

/* On the page (any unit, lat by custom), z growing towards the eye. z must be linear along the projected edge: depth in
 * a parallel view, the reciprocal of depth in perspective. */
typedef struct halo_point {
    int32_t x, y, z;
} halo_point_t;

typedef struct halo_edge {
    halo_point_t p, q;
    int32_t id; /* the caller's */
} halo_edge_t;

/* One interruption: of edge, by other. */
typedef struct halo_crossing {
    uint32_t edge;
    uint32_t at_q30;  /* where on edge, from p to q */
    uint32_t way_q36; /* half the gap for a halo of 1, as a part of edge */
    uint32_t other;   /* index of the nearer edge; above bit 24 see halo_draw.c */
} halo_crossing_t;

/* Takes the visible parts of edge `id` from p to q, 0 <= from < to <= 2^30, in ascending order for one edge. Returns 0
 * or a negative error, which ends DRAW and is returned by it. */
typedef struct halo_sink {
    void *ctx;
    int (*piece)(void *ctx, int32_t id, uint32_t from_q30, uint32_t to_q30);
} halo_sink_t;

typedef struct halo {
    uint8_t *mem;
    size_t bytes;
    halo_edge_t *edge; /* in the order of the grid after CUT */
    int32_t edges;
    halo_crossing_t *crossing; /* grouped by edge: first[e] .. first[e + 1] - 1 */
    uint32_t *first;
    int64_t crossings, room; /* found; that there is memory for */
    int32_t contact;         /* units, 1 .. HALO_CONTACT_MAX; 1 after halo_init, for ends that were rounded once */
    int32_t reach;
    uint8_t *joined;                                   /* with a reach: which ends of an edge other edges share */
    bool joining;                                      /* CUT is only looking for those */
    uint64_t *box;                                     /* while CUT works: halo_grid.h; DRAW sorts gaps in it */
    void (*tick)(void *ctx, int32_t done, int32_t of); /* now and then while CUT and DRAW work; NULL after halo_init */
    void *tick_ctx;
    int64_t tests; /* pairs of edges whose crossing was computed */
    size_t used;   /* bytes; after a halo_cut that found no room for its crossings, those that it needs */
} halo_t;

/* Prepares h in mem (any alignment). */
void halo_init(halo_t *h, void *mem, size_t bytes);
/* Adds an edge. Returns 0, ERR_FULL when there is no memory for another, or ERR_VALUE for coordinates out of range. */
int halo_add(halo_t *h, int32_t id, halo_point_t p, halo_point_t q);
/* CUT. reach: 0, or the largest width DRAW is going to be asked for, to have the ends' haloes too. May be called again,
 * with more edges or another reach. Returns 0, or ERR_FULL: h->crossings then says how many crossings there are, if the
 * edges at least fitted, otherwise -1; and halo_draw must not be called. */
int halo_cut(halo_t *h, int32_t reach);
/* DRAW: the visible parts of all edges, width 0 or HALO_WIDTH_MIN .. HALO_WIDTH_MAX (and <= reach, if there is one).
 * Width 0 is the plain wire frame. Returns 0 or the sink's error. */
int halo_draw(halo_t *h, int32_t width, const halo_sink_t *sink);

#endif
