/* area.h - the polygon area sort: visible polygons of a scene of solids, and from them its visible edges.
 *
 * K. Weiler and P. Atherton, "Hidden surface removal using polygon area sorting", SIGGRAPH 1977. The front-most polygon
 * of a list clips all others into what is inside and what is outside of it (poly/clip.h). Of what is inside, all that
 * is behind it goes; what is in front of it is an error of the rough sort and becomes the next clip polygon, for the
 * inside list alone, until the list has no polygon that has not clipped it: then it is visible as it is, and the work
 * goes on with the outside lists, last first. Clip polygons are the original ones, not remainders, and those that clip
 * the present area are on a stack; one that is found there again overlaps another one cyclically, and what is behind it
 * has gone already (their check, with the recursion turned into that stack).
 *
 * Polygons are the scene's faces on the page: integer vertices in lat, and a depth that is linear over the page. Of two
 * polygons the one in front is decided where their depths differ most, since faces that share an edge differ by nothing
 * there. A part of a face that cuts through another is cut in two where the planes meet, and counted; that line is not
 * drawn. Faces need not be convex; closed objects show their outer sides only.
 *
 * Edges are drawn where a visible polygon ends in them, each once. A crossing is rounded to the lattice (area_place.h,
 * 1/12,800 of a step) each time an area is cut, and welds move borders by a few units (area_weld.h): ends of edges are
 * off by less than a quarter step. Where that cannot be had from polygons, since they overlap by no more than rounding
 * makes of nothing (1/800 of a step), the edge is held against the faces as a line in space (area_wires.h); hatching
 * and shadows may be wrong in such strips.
 *
 * The screen subdivision of their section "Screen subdivision" bounds memory: a window with more polygons than the
 * memory takes is halved, and the halves are done one after the other; pieces of edges meet again afterwards. Where
 * that does not help, since polygons reach across both, depth is divided as well: boxes from front to back. Convex
 * bodies are sorted as one polygon each, their silhouettes (area_body.h, their "Consolidation"). Memory: area_bytes().
 * Cost: printed by make bench. */
#ifndef AREA_H
#define AREA_H

#include "hidden/hidden.h"
#include "poly/clip.h"
#include "view/solid_map.h"

/* What a scene's area sort found, beside hidden_stats_t. */
typedef struct area_stats {
    int64_t polygons;      /* that take part: not those seen edge-on or from behind */
    int64_t lateral;       /* boxes held against that of a clip polygon */
    int64_t clips;         /* pairs clipped; those that a glance tells apart are not counted */
    int64_t removed;       /* pieces behind a clip polygon */
    int64_t errors;        /* sort errors: polygons in front of the one that was taken to be the front-most */
    int64_t intersections; /* parts that cut through the face that clips */
    int64_t bodies;        /* sorted as silhouettes, in the beginning */
    int64_t visible;       /* visible polygons, pieces of one face counted each */
    bool behind;           /* something is behind the eye */
    int32_t windows;       /* of the screen subdivision */
    int32_t boxes;         /* of the Z subdivision */
    int32_t depth;         /* of the stack, at most */
    int32_t pieces;        /* polygons there were at once, at most */
    size_t bytes;          /* of the memory that were in use, at most: with less, windows are halved */
} area_stats_t;

/* Takes one visible polygon: `face` of the scene, its contours in lat; tags are edges of the scene (those that stand
 * for all of a place, solid_edge_t.first) or POLY_CUT. p is valid during the call. When memory ran out and a
 * window had to be halved, parts of the same polygon may come once more. */
typedef struct area_sink {
    void *ctx;
    int (*polygon)(void *ctx, int32_t face, const poly_t *p);
    /* A visible part of a line that no polygon ends in: free segments, edges of faces that are seen edge-on. From and
     * to are fractions of what of it is in front of the eye. */
    int (*wire)(void *ctx, int32_t edge, int32_t from_q30, int32_t to_q30);
    /* Wires of an edge follow that take the place of what polygons ended in it: those of one of its faces end roughly
     * (area_wires.h, AREA_ROUGH). May be NULL: then there are none. */
    void (*again)(void *ctx, int32_t edge);
    int32_t window_faces; /* most polygons in a window of the screen subdivision; 0: halved where that spares work;
                             INT32_MAX: one window, with as many pieces as the memory takes */
    bool overlap;         /* windows reach into the next by BORDERS_OVERLAP_LAT (area_border.h) */
    bool one_by_one;      /* without consolidation (area_body.h): to compare */
} area_sink_t;

/* Memory for a scene of so many faces with so many corners: in one window unless it is cut up very much. */
size_t area_bytes(int32_t faces, int32_t corners);
/* About the least that it gets through with, in windows, if so many faces with so many corners may be seen; with
 * shadows of so many lights, or 0. */
size_t area_least_bytes(int32_t faces, int32_t corners, int32_t lights);
/* Of that, what is there for every face from the start to the end. */
size_t area_fixed_bytes(const solid_map_t *m);
/* Gives all visible polygons to sink. mem is aligned to 8. Returns 0; ERR_FULL; or the sink's error. stats are filled
 * in also after an error. tick may be NULL. */
int area_sort(const solid_map_t *m, void *mem, size_t bytes, const area_sink_t *sink,
              void (*tick)(void *ctx, int32_t done, int32_t of), void *tick_ctx, area_stats_t *stats);
struct area_tone; /* area_tone.h */
/* Emits the visible parts of all edges as INK_SEGMENT, surface 0; with a tone (may be NULL) hatching too, as INK_CURVE
 * on surface LINE_HATCH, and borders of shadows on LINE_SHADOW. What is seen of edges only through translucent objects
 * goes to behind, unless that is NULL: then they are like others. Two sorts then: what is seen without them, and with
 * them. Details are lines from solid->ne on, on surface LINE_DETAIL. Returns as area_sort, and ERR_VALUE or ERR_LIGHT
 * for a light that cannot be used. */
int area_draw(const solid_map_t *m, const struct area_tone *tone, const ink_sink_t *behind, const hidden_job_t *job,
              hidden_stats_t *stats, area_stats_t *area);

#endif
