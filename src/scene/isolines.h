/* isolines.h - isolines in space, in lent memory, become a mesh: a facet for each cell between neighbours.
 *
 * What gnuplot makes of data whose points lie on no grid of x and y (a sphere, a coil, the outlines of continents), and
 * of parametric surfaces. Sets of isolines are independent of each other. Where all lines of a set have as many points,
 * at least two, there are facets between each line and the next; else the lines are drawn for themselves, and hide
 * nothing. A point that is undefined, or outside of the limits, is a hole: no facet has it as a corner, and lines are
 * interrupted.
 *
 * Memory: 24 bytes a point from the pool's lower end; from its upper end 20 a facet, or 4 a point of a line, at most 4
 * more for each piece of it. Context: main loop. */
#ifndef ISOLINES_H
#define ISOLINES_H

#include "scene/data_grid.h"
#include "scene/mesh.h"

typedef struct isolines {
    data_pool_t *pool;
    packed_t *vertex;                /* x, y, z of each point */
    int32_t *top;                    /* as mesh_t's */
    mesh_t mesh;                     /* counts so far */
    num_t lo[3], hi[3];              /* limits; undefined: none */
    num_t extent[2][2];              /* of x and y within their limits, whatever else a point lacks */
    int32_t first, line_first;       /* first points of the set and of the line */
    int32_t lines, length;           /* complete lines of the set; points of its first one */
    bool even;                       /* so far all lines of the set have this length */
    int32_t set_words, set_segments; /* mesh's counts when the set began */
} isolines_t;

/* Without limits; lo and hi may be set behind this. */
void isolines_init(isolines_t *s);
/* Begins in what is free of the pool. */
void isolines_start(isolines_t *s, data_pool_t *pool);
/* Begins with the points of a grid that is being read, the last thing in its pool, in place of it. A coordinate may
 * move by data_grid.h's tolerance, 2^-12 of a step. */
int isolines_adopt(isolines_t *s, const data_grid_t *g);
/* The next point of the line. 0 or ERR_FULL, as the others. */
int isolines_point(isolines_t *s, num_t x, num_t y, num_t z);
/* The line ends; nothing between lines. */
int isolines_break(isolines_t *s);
/* The set ends. facets: false draws lines in any case. */
int isolines_end_set(isolines_t *s, bool facets);
/* All of it. Takes the memory from the pool. ERR_EMPTY: there is neither a facet nor a line. */
int isolines_finish(isolines_t *s, mesh_t *out);

#endif
