/* clip.h - Boolean operations on two polygons: one arrangement, then as many results as are asked for.
 *
 * The task is the clipper of Weiler and Atherton (1977, "Polygon clipping algorithm"): a subject and a clip polygon,
 * each concave with holes and of any number of contours, and out of one pass two lists, what of the subject is inside
 * the clip polygon and what is outside. Their method, chains of vertices linked at intersections that are classified as
 * entering or leaving, has no answer where borders touch, coincide or run into vertices, and that is what faces of one
 * solid do all the time. So ours is another, right by construction:
 *
 *   1. All edges of both polygons become one planar graph. Crossings are rounded to the nearest lattice point and both
 *      edges are split there: most of them beforehand, by comparing boxes (clip_cross.c), the others in a plane sweep
 *      between neighbours. Rounding may make new crossings, so the sweep is repeated until one finds nothing to round.
 *      That last sweep proves that edges meet in end points only: were there a crossing, the leftmost one would be
 *      between neighbours (Shamos and Hoey 1976). A vertex on an edge splits it exactly; edges that coincide become
 *      one, their windings added.
 *   2. The same sweep counts both winding numbers on either side of each edge, exactly, so every face of the graph
 *      is known to be in the subject, in the clip polygon, in both or in neither. The borders of a result are the edges
 *      with different answers on their sides, and at each vertex they alternate in and out around it.
 *   3. Results are traced along those. The borders of one connected piece form one outer contour, counter-clockwise,
 *      and its holes, clockwise; contours touch in points at most.
 *
 * It ends: a split leaves two edges whose widths and heights add up to the old ones, and none is of length zero. It
 * ends soon: edges within half a unit of a rounded crossing are drawn to it (Hobby's snap rounding), and from the third
 * sweep on to any vertex; without that, bundles of nearly parallel edges creep towards each other unit by unit. Error:
 * every rounding moves an edge by at most half a unit in x and in y, and nothing is moved where nothing crosses between
 * lattice points. tests/property/test_clip_random prints how many sweeps it took, counting crossings found beforehand
 * as one, and the largest mean displacement it saw on small lattices, where the worst happens.
 *
 * Of large polygons most of the border meets nothing. Such stretches are found by their boxes and go through all this
 * as one edge each (clip_stretch.c), for the time. The vertices are the same as without, unless edges that all but
 * coincide are rounded in another order or in another sweep: in 3 pairs among 100,000 large ones vertices were half a
 * unit from where they are without. Both are within the bound; the test holds them against exact areas and each other.
 *
 * Memory is the caller's, CLIP_BYTES(edges of both); ERR_FULL if crossings take more. No recursion. Cost: edges +
 * crossings times the logarithm of the edges that a vertical line meets. Context: main loop. */
#ifndef CLIP_H
#define CLIP_H

#include "poly/poly.h"
#include <stddef.h>

/* Results, as truth tables: bit s + 2 c says whether a point in (s) or not in the subject and in (c) or not in the
 * clip polygon belongs to it. */
enum clip_result {
    CLIP_INSIDE = 0x8,  /* subject and clip */
    CLIP_OUTSIDE = 0x2, /* subject without clip */
    CLIP_REST = 0x4,    /* clip without subject */
    CLIP_UNION = 0xE,
    CLIP_XOR = 0x6,
    CLIP_SUBJECT = 0xA, /* the subject itself: contours that cross are taken apart */
    CLIP_NOTHING = 0x0,
};

enum clip_fill { CLIP_EVEN_ODD, CLIP_NONZERO };

typedef struct clip_job {
    poly_t subject, clip;
    enum clip_fill fill;        /* of both; CLIP_NONZERO wants less than 32768 contours */
    enum clip_result result[2]; /* the two that clip_trace will be asked for */
} clip_job_t;

/* Enough for so many edges and as many crossings again. */
#define CLIP_BYTES(edges) ((size_t)(edges)*192 + 2048)

/* The work area; its members are clip.c's, stats for anybody. */
typedef struct clip {
    struct clip_edge *edge;       /* of the graph, from the start of the memory upwards */
    struct clip_seg *in;          /* waiting edges [in_from, in_to), at the end of it */
    struct clip_seg *heap;        /* second parts of edges that were split ahead of the sweep */
    int32_t *status;              /* edges that the sweep line meets, from below */
    struct poly_vertex *v;        /* at the very end, copies: */
    struct clip_stretch *stretch; /* stretches of border that are one edge of the graph; before this address */
    int32_t stretches;
    int32_t edges, in_from, in_to, waiting, active;
    int32_t most_waiting, most_active;
    enum clip_fill fill;
    enum clip_result result[2];
    bool rounded, unsorted; /* in this sweep: a crossing was rounded; one came out before the sweep line */
    bool snap;              /* edges that pass within half a unit of a vertex are drawn to it */
    bool full;
    bool tagged; /* clip_run_tagged */
    struct {
        int32_t sweeps, crossings, most_edges; /* of the last clip_run */
    } stats;
} clip_t;

/* Builds the graph in mem (aligned to 8 bytes). Returns 0; ERR_FULL; ERR_VALUE for a coordinate beyond POLY_LIMIT. */
int clip_run(clip_t *c, const clip_job_t *job, void *mem, size_t bytes);

/* The same, but edges of the clip polygon keep their tags, too. Where both have one, either. */
int clip_run_tagged(clip_t *c, const clip_job_t *job, void *mem, size_t bytes);

/* Where a result goes: arrays of the caller, filled from n and contours on (so results can be appended). */
typedef struct clip_out {
    poly_vertex_t *v;
    int32_t *end;   /* of each contour, as in poly_t */
    int32_t *outer; /* of each contour: -1 for an outer one, the index of its outer contour for a hole; may be NULL */
    int32_t n, n_max;
    int32_t contours, contours_max;
} clip_out_t;

/* Edges on the border of a result, before it is traced: so many vertices, and a third of it contours, are enough. */
int32_t clip_count(const clip_t *c, int which);
/* Appends result number which (0 or 1), once for each clip_run. Edges of the subject keep their tags, others get
 * POLY_CUT (but for clip_run_tagged); vertices in the middle of a straight edge are left out. Returns 0 or ERR_FULL. */
int clip_trace(clip_t *c, int which, clip_out_t *out);

#endif
