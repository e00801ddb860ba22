/* area_plane.h - depth over the page, as the plane of a face: z = c0 + cx x + cy y at lattice points.
 *
 * The plane goes through three corners as they are before they are rounded to the lattice, so depths are those of the
 * face itself at any lattice point, to a small part of a unit of the scene; two planes are compared by their
 * difference.
 *
 * Bits: z 2^60 at most, a gradient below 2^58 a unit where the face is a few units wide, 24 fractional bits, and the
 * product with a coordinate of 2^30: below 2^113 in wide_t. */
#ifndef AREA_PLANE_H
#define AREA_PLANE_H

#include "hidden/area/area_place.h"
#include "num/wide.h"

#define AREA_PLANE_BITS 24

typedef struct area_plane {
    wide_t cx, cy, c0; /* in 2^-AREA_PLANE_BITS */
} area_plane_t;

/* False if they lie in one line. */
bool area_plane_through(area_plane_t *p, const area_fine_t *a, const area_fine_t *b, const area_fine_t *c);

static inline area_plane_t area_plane_minus(const area_plane_t *a, const area_plane_t *b) {
    return (area_plane_t){wide_sub(a->cx, b->cx), wide_sub(a->cy, b->cy), wide_sub(a->c0, b->c0)};
}

/* Limited to +-2^62. */
static inline int64_t area_limited(wide_t z) {
    int64_t most = (int64_t)1 << 62, low = (int64_t)z.lo;
    if (z.hi != low >> 63) return z.hi < 0 ? -most : most;
    return low < -most ? -most : low > most ? most : low;
}

static inline int64_t area_plane_round(wide_t sum) {
    return area_limited(wide_sar(sum, AREA_PLANE_BITS));
}

static inline wide_t area_plane_sum(const area_plane_t *p, poly_point_t at) {
    return wide_add(p->c0, wide_add(wide_times_s32(p->cx, at.x), wide_times_s32(p->cy, at.y)));
}

static inline int64_t area_plane_at(const area_plane_t *p, poly_point_t at) {
    return area_plane_round(area_plane_sum(p, at));
}
/* How much the depth changes over a unit of the page at most, in any direction; at least 1. */
int64_t area_plane_slope(const area_plane_t *p);
/* The plane at four places, in a unit that makes all of them as large as fits, their differences too. */
void area_plane_at_four(const area_plane_t *p, const poly_point_t at[4], int64_t out[4]);
/* The plane at a place that was not rounded and may lie far outside of the face. */
wide_t area_plane_at_fine(const area_plane_t *p, const area_fine_t *at);

#endif
