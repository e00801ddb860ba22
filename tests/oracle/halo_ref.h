/* halo_ref.h - haloed lines the slow way: every edge against every other, in rationals.
 *
 * What src/hidden/halo/halo.h promises is worked out without its method: crossings and depths are GMP rationals, no
 * grid, and a gap is the farther edge clipped by the four sides of the nearer one's halo, in long double. Where a
 * decision of the `ends` kind hangs on the rounding of a point that is not on the lattice, either answer is right: such
 * gaps are "open" and not judged. */
#ifndef HALO_REF_H
#define HALO_REF_H

#include "hidden/halo/halo.h"

/* A drawn piece, as the kernel's sink takes it; edge is an index into the given edges. */
typedef struct halo_ref_piece {
    int32_t edge;
    double from, to; /* 0 .. 1 */
} halo_ref_piece_t;

/* What is wrong with a drawing, in units of the page: the longest stretch of an edge that should be drawn and is not,
 * and the reverse; beyond what halo.h allows for rounding (1 unit and length * width / 2^36), so 0 is right. */
typedef struct halo_ref_report {
    double missing, falsely; /* longest, as measured */
    double beyond;           /* the most by which the allowance is exceeded */
    int32_t edge;            /* where */
    double drawn, whole;     /* lengths in all */
    int crossings, contacts, open;
} halo_ref_report_t;

/* Judges the pieces (any order) of the edges' drawing with haloes of `width`. */
halo_ref_report_t halo_ref_judge(const halo_edge_t *edge, int n, int32_t width, bool ends, int32_t contact,
                                 const halo_ref_piece_t *piece, int pieces);

#endif
