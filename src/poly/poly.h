/* poly.h - polygons with integer vertices: concave, with holes, of several contours.
 *
 * A polygon is a set of closed contours over one array of vertices; contour k is v[end[k-1]] .. v[end[k]-1], and the
 * edge from its last vertex to its first closes it. What is inside is said by a fill rule: even-odd (a point is inside
 * if a ray from it crosses an odd number of edges; the contours may run either way, holes need no mark), or nonzero.
 * Contours may touch and cross each other and themselves.
 *
 * Bit budget: |x|, |y| <= POLY_LIMIT = 2^30 - 1. Differences of coordinates then take 31 bits and a sign, a product of
 * two is below 2^62, and an orientation, the difference of two products, is an exact int64_t. On the page 2^30 lat are
 * 32 m. */
#ifndef POLY_H
#define POLY_H

#include <stdbool.h>
#include <stdint.h>

#define POLY_LIMIT ((INT32_C(1) << 30) - 1)
_Static_assert(2 * ((int64_t)(2 * POLY_LIMIT) * (2 * POLY_LIMIT)) > 0, "an orientation is an int64_t");

#define POLY_CUT (-1) /* tag of an edge that runs along the border of a clip polygon */

typedef struct poly_point {
    int32_t x, y;
} poly_point_t;

/* A vertex and the edge that starts there: tag is the caller's name for that edge, >= 0. Parts of an edge keep it. */
typedef struct poly_vertex {
    poly_point_t at;
    int32_t tag;
} poly_vertex_t;

typedef struct poly {
    const poly_vertex_t *v;
    const int32_t *end; /* of contour k: the index after its last vertex, ascending */
    int32_t contours;
} poly_t;

static inline int32_t poly_vertices(const poly_t *p) {
    return p->contours ? p->end[p->contours - 1] : 0;
}

/* Twice the signed area of the triangle a b c: positive if c lies to the left of the way from a to b. Exact. */
static inline int64_t poly_orient(poly_point_t a, poly_point_t b, poly_point_t c) {
    return (int64_t)(b.x - a.x) * (c.y - a.y) - (int64_t)(b.y - a.y) * (c.x - a.x);
}

/* The order in which a sweep from left to right meets points: by x, then by y. */
static inline bool poly_before(poly_point_t a, poly_point_t b) {
    return a.x != b.x ? a.x < b.x : a.y < b.y;
}
static inline bool poly_same(poly_point_t a, poly_point_t b) {
    return a.x == b.x && a.y == b.y;
}

/* Twice the area, counter-clockwise contours positive: exact for contours that do not cross (modulo 2^64 for any). */
int64_t poly_area2(const poly_t *p);

#endif
