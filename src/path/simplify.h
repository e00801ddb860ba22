/* simplify.h - merges collinear vertices of a stroke while it passes, in constant memory.
 *
 * Vertices that come out are vertices that came in. Every vertex left out lies within tol_lat of the segment that
 * replaces it: from the last vertex given out (the apex) we keep the cone of directions that pass every vertex since
 * within the tolerance, and a vertex outside the cone, or one that moves back towards the apex, makes its predecessor
 * the next apex (cone intersection after Sklansky and Gonzalez 1980, with axis-parallel instead of perpendicular
 * offsets: they need no square root, and an offset parallel to an axis is never shorter than the perpendicular).
 * So a stroke that doubles back keeps its turning points. Equal successive vertices are merged.
 * Worst error: tol_lat, exactly (proved by tests/unit/test_simplify.c). Cost: at most six 32x32->64 products a vertex.
 * Bit budget: |coordinate| < 2^29 lat (16 m), so differences and their offsets stay below 2^31 and cross products below
 * 2^63. */
#ifndef SIMPLIFY_H
#define SIMPLIFY_H

#include "view/page.h"

typedef struct simplify {
    int32_t tol_lat;
    pen_sink_t out;
    page_point_t apex, last;   /* last vertex given out; last vertex taken */
    int32_t left[2], right[2]; /* the cone's sides, relative to the apex */
    bool open;                 /* a stroke has begun */
    bool pending;              /* `last` has not been given out */
    bool cone;                 /* left and right are set */
    bool moved;                /* the stroke's move has been given out */
} simplify_t;

/* tol_lat: 0 merges exactly collinear vertices only. */
void simplify_init(simplify_t *s, int32_t tol_lat, pen_sink_t out);
/* Begins a stroke, ending the one before. Both return 0 or the error of the sink. */
int simplify_move(simplify_t *s, page_point_t p);
int simplify_draw(simplify_t *s, page_point_t p);
/* A whole stroke from a to b, as simplify_move, simplify_draw and simplify_finish make it, sooner. */
int simplify_line(simplify_t *s, page_point_t a, page_point_t b);
/* Gives out what is held back. A stroke without length gives nothing, not even its move. */
int simplify_finish(simplify_t *s);

#endif
