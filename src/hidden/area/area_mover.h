/* area_mover.h - from the view that a light has of a face to the eye's.
 *
 * A place on the face is mapped over three of its corners: affine in space, so right in perspective. The rounding of
 * the light's view comes back magnified by 1 / slope there, thousands of units where the light grazes. So a place on an
 * edge of the face is mapped along that edge instead: what is lit up to the edge ends in it for the eye, too, whatever
 * the slope, and also where a face of a file is flat only nearly. */
#ifndef AREA_MOVER_H
#define AREA_MOVER_H

#include "hidden/area/area_place.h"

typedef struct area_mover {
    const area_lattice_t *from_view; /* the light's */
    const solid_map_t *to_view;      /* the eye's */
    poly_point_t at[3];              /* corners as the light sees them */
    page_h_t from[3];                /* the same, homogeneous */
    page_h_t to[3];                  /* and as the eye does */
    int64_t whole;
    int32_t face;
} area_mover_t;

/* Prepares it for a face whose vertices are all in front of the light. False if that sees it edge-on. The views outlive
 * it. */
bool area_mover(area_mover_t *mv, const area_lattice_t *from, const solid_map_t *to, int32_t face);
/* Where a place on the face is for the eye: what cannot be drawn is still to be clipped (area_place.h). edge: those of
 * the scene that the lit polygon's border follows to it and from it, or POLY_CUT. */
area_place_t area_move(const area_mover_t *mv, poly_point_t p, const int32_t edge[2]);

#endif
