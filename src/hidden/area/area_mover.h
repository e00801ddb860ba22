/* area_mover.h - from the view that a light has of a face to the eye's.
 *
 * A place on the face is mapped over three of its corners: affine in space, so right in perspective. One on the border
 * stays on it, also where a face of a file is flat only nearly. */
#ifndef AREA_MOVER_H
#define AREA_MOVER_H

#include "hidden/area/area_place.h"

#define AREA_MOVER_CORNERS 8

typedef struct area_mover {
    const area_lattice_t *from_view; /* the light's */
    const solid_map_t *to_view;      /* the eye's */
    poly_point_t at[3];              /* corners as the light sees them */
    page_h_t from[3];                /* the same, homogeneous */
    page_h_t to[3];                  /* and as the eye does */
    int64_t whole;
    struct {
        poly_point_t at;
        page_h_t from[1], to[1];
    } border[AREA_MOVER_CORNERS]; /* all corners, if they are not many: n, else 0 */
    int32_t n;
} area_mover_t;

/* Prepares it for a face whose vertices are all in front of the light. False if that sees it edge-on. The views outlive
 * it. */
bool area_mover(area_mover_t *mv, const area_lattice_t *from, const solid_map_t *to, int32_t face);
/* Where a place on the face is for the eye: what cannot be drawn is still to be clipped (area_place.h). */
area_place_t area_move(const area_mover_t *mv, poly_point_t p);

#endif
