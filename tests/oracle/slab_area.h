/* slab_area.h - the area where polygons overlap in a given way, by vertical slabs.
 *
 * Between two neighbouring abscissas of end points and crossings no edges cross, so each slab is a pile of trapezoids
 * and its area is its width times heights at its middle. No rounding of crossings, no graph, no tracing: nothing in
 * common with src/poly. Numbers are long double; slab_area_exact does the same in GMP rationals, some hundred times
 * slower. */
#ifndef SLAB_AREA_H
#define SLAB_AREA_H

#include "poly/poly.h"

/* Bit k of `in` says whether a place is in polygon k. */
typedef bool (*slab_test_t)(unsigned in, const void *ctx);

typedef struct slab_scene {
    const poly_t *poly[4];
    bool nonzero[4]; /* fill rule of each */
    int polys;
} slab_scene_t;

double slab_area(const slab_scene_t *s, slab_test_t test, const void *ctx);
double slab_area_exact(const slab_scene_t *s, slab_test_t test, const void *ctx);

/* Length of all borders of a polygon. */
double slab_border(const poly_t *p);

#endif
