/* area_place.h - where the vertices and edges of a scene are for the area sort: on the page, with their depths.
 *
 * The page is a lattice finer than a lat, since cuts at small angles need it; each vertex is rounded to it once. Faces
 * and edges that reach behind the eye or too far off the page are clipped in space before, in homogeneous coordinates
 * of 60 bits: by the plane through which everything nearer is left out, then by four through the eye and the borders of
 * the lattice. A crossing is always computed from what is inside of a plane towards what is outside, so two faces get
 * the same of the edge they share. */
#ifndef AREA_PLACE_H
#define AREA_PLACE_H

#include "poly/poly.h"
#include "view/solid_map.h"

#define AREA_LATTICE_BITS 5
#define AREA_Z_BITS 60
#define AREA_FINE_BITS 24 /* of places that were not rounded to the lattice */

typedef struct area_lattice {
    const solid_map_t *m;
    int bits;          /* 1 lat is 2^bits units */
    int32_t guard_lat; /* pictures end at so much in x and y */
    bool clips;        /* some vertex is not where its picture may be */
    int64_t near;      /* perspective: the least E, times 2^SOLID_FINE_E, of what is drawn; z is -2^AREA_Z_BITS there */
    /* What SOLID_FLAT units of the scene are on the page at most, in 1/256 of its units, and in depth; nearest to the
     * eye. */
    int64_t flat_page_q8, flat_z;
} area_lattice_t;

area_lattice_t area_lattice(const solid_map_t *m);

/* A place in space: page = (x, y) / e. Parallel: e is 2^frac_bits, and z says the depth; perspective: e is finer by
 * SOLID_FINE_E bits and says it. t: of an edge, from its first vertex to its second. */
typedef struct area_place {
    int64_t x, y, e, z, t_q60;
} area_place_t;

area_place_t area_place(const area_lattice_t *l, int32_t v);
/* Is the vertex where it can be drawn? */
bool area_is_inside(const area_lattice_t *l, int32_t v);
enum { AREA_BORDERS = 5 };
/* How far inside of border b a place is; not inside: negative. */
int64_t area_inside(const area_lattice_t *l, int b, const area_place_t *p);
/* Where the way from a place inside of a border to one outside meets it; how far they are inside. */
area_place_t area_cut(const area_place_t *in, const area_place_t *out, int64_t in_by, int64_t out_by);

/* A picture that was not rounded: in units of 2^-AREA_FINE_BITS; and its depth: perspective, -near / E scaled to
 * AREA_Z_BITS, parallel the distance along the lines of sight. Both are linear along lines and smaller is nearer. */
typedef struct area_fine {
    int64_t x, y, z;
} area_fine_t;
area_fine_t area_fine(const area_lattice_t *l, const area_place_t *p);
poly_point_t area_round(const area_lattice_t *l, const area_fine_t *f);
/* The vertex, which area_is_inside. */
poly_point_t area_vertex(const area_lattice_t *l, int32_t v);

/* What of an edge can be drawn. */
typedef struct area_edge {
    area_place_t at[2];
    area_fine_t fine[2];
    poly_point_t end[2];
} area_edge_t;
/* False if there is nothing. */
bool area_edge(const area_lattice_t *l, int32_t edge, area_edge_t *out);
/* From a fraction of the way between the ends' pictures to the parameter in space (q30). */
int64_t area_space(const area_lattice_t *l, const area_edge_t *e, int32_t page_q30);

#endif
