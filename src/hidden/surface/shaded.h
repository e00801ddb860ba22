/* shaded.h - shaded drawings of surfaces (D. P. Anderson 1982): the visible part of each facet, hatched by the light.
 *
 * The visible part of a facet is its polygon less the perimeter (his section 5), and of its hatch lines those parts are
 * drawn that lie outside of what the facets before have covered: they are clipped like its edges, when its turn comes.
 * So two rows of the surface are in memory here too, and a facet's polygon need never be made. A hatch line is implicit
 * (hatch.h) and runs on through neighbours of one tone; where a line leaves a facet, both compute the same place.
 *
 * The light is given in the units of the data, or where a rotated view scales the axes (camera_t.unit), in units in
 * which the box is a cube: what is seen is lit. A facet's normal is square to its diagonals. No shadows are cast. */
#ifndef SHADED_H
#define SHADED_H

#include "hidden/area/area_light.h"
#include "hidden/hatch.h"
#include "view/camera.h"

#define SHADED_BITS 5 /* of the hatching's lattice below a lat: the page reaches 1 m */

/* A vertex of a row on its way through the page. */
typedef struct shaded_vertex {
    page_h_t h;
    int32_t z; /* as in grid_t */
    bool good; /* defined, and in front of the eye */
} shaded_vertex_t;

typedef struct shaded {
    const hatch_t *hatch;
    const line_space_t *lines; /* of each surface: INK_ROW gives its vertices */
    const camera_t *cam;
    const light_t *light;
    int32_t lights;
    const ink_sink_t *sink; /* takes INK_CURVE pieces of hatch lines */
    uint8_t space;          /* on this surface number */
    num_t middle[3];        /* of the scene, in the data's units: what a lamp is worth is reckoned there */
    intervals_t parts;
    num_t to[LIGHTS_MAX][3]; /* unit vectors to parallel lights, in the cube */
    int64_t full_q30;
    int32_t nx;
    shaded_vertex_t *row; /* two for each surface, row j in number j & 1 */
    int32_t *row_j;
    int64_t pieces;
    int err;
} shaded_t;

/* Memory for so many surfaces of nx columns, without room for parts of hatch lines: 12 bytes each, any number will do.
 */
size_t shaded_bytes(int32_t nx, int32_t surfaces);
/* Prepares the memory (aligned to 8) and the lights of s, whose members up to middle are set. Returns 0 or ERR_FULL. */
int shaded_init(shaded_t *s, int32_t nx, int32_t surfaces, void *mem, size_t bytes);
struct sweep; /* sweep.h */
struct layer;
/* For the sweep: hatches what is visible of the layer's facet in cell i; before its edges cover. Returns 0 or an error
 * of the sink. */
int shaded_facet(shaded_t *s, struct sweep *sweep, const struct layer *l, int32_t i);
/* Gives what is left to the sink. */
int shaded_finish(shaded_t *s);

#endif
