/* area_limit.h - what of a polygon lies in a window of the screen, a vertex at a time.
 *
 * It takes no memory but what it leaves (reentrant.h), which is why it comes before the clipper where that has too
 * little. A contour that leaves the window and comes back runs along its border meanwhile, there and back; neither fill
 * rule minds. Crossings are rounded to the nearest lattice point, the same for an edge and for one that runs back along
 * it: edges move by half a unit at most.
 */
#ifndef AREA_LIMIT_H
#define AREA_LIMIT_H

#include "hidden/area/area_face.h"
#include "hidden/reentrant.h"
#include "poly/clip.h"

#define AREA_LIMIT_BORDERS 4 /* low and high x, low and high y */

typedef struct area_limit {
    area_box_t box;
    int32_t tag; /* of all edges */
    clip_out_t *out;
    int32_t begun; /* where this contour begins in out */
    REENTRANT_BORDER(poly_point_t) at[AREA_LIMIT_BORDERS];
} area_limit_t;

void area_limit_init(area_limit_t *l, const area_box_t *box, int32_t tag, clip_out_t *out);
/* The next vertex of a contour. Returns 0 or ERR_FULL. */
int area_limit_put(area_limit_t *l, poly_point_t at);
/* After the last one: the way back to the first, and the contour's end, if there is anything of it. The same. */
int area_limit_close(area_limit_t *l);

#endif
