/* area_weld.h - closes the cracks that rounding leaves between polygons.
 *
 * A border that is cut is bent, by half a unit each time. Where the same line then bounds another polygon, or where
 * bodies are flush, two borders run side by side a unit apart, and what lies behind would be seen through the crack.
 * So before a polygon is clipped, vertices within a few units of each other are made one, and edges that pass a vertex
 * of the other polygon so closely are drawn through it: then they coincide, and the clipper makes one of them. */
#ifndef AREA_WELD_H
#define AREA_WELD_H

#include "hidden/area/area_face.h"

/* A pair of polygons that have been welded. Where nothing was near they are as they came. */
typedef struct area_weld {
    poly_t subject, clip;
    bool changed;
} area_weld_t;

/* mem: for copies, if any are needed. Returns 0 or ERR_FULL. Cost: vertices of the one times the other's where their
 * boxes overlap. */
int area_weld(area_weld_t *w, const poly_t *subject, const area_box_t *subject_box, const poly_t *clip,
              const area_box_t *clip_box, void *mem, size_t bytes, size_t *used);

/* Is there a line along an edge of one that has the other on its far side, further away than a weld reaches but for
 * vertices that both have? Most neighbours are apart, and need no clip. Cost: as area_weld at worst, mostly less. */
bool area_apart(const poly_t *p, const poly_t *q);

#endif
