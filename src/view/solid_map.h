/* solid_map.h - solids on the page: the line space of their edges, and each vertex as integers for kernels.
 *
 * Two kinds of coordinates, for two needs.
 *
 * Exact in space: the lattice of the scene (solid.h) and the eye on it: eye = (e, w), the point e / w, or for w == 0
 * the direction e towards the eye. Which side of a plane of the lattice the eye is on, or a vertex of a plane through
 * the eye and two vertices, is then a determinant without rounding.
 *
 * On the page: x, y in lat, rounded once for each vertex (good within half a lat and a twentieth, 1/800 of a step), and
 * a depth z that is linear along a line's picture: in parallel views the distance along the lines of sight, in
 * perspective -1/E, both scaled to SOLID_Z_BITS; smaller is nearer. A vertex behind the eye, or nearer than 2^-20 of
 * the farthest, has no place on the page: solid_map_is_behind(). Edges to one are cut: solid_map_edge(). Whatever ink
 * such a piece gets is cut again, exactly, by view/cut.
 *
 * Bits: e below 2^50, w at most 2^22, e - p w below 2^51, a plane through the eye and two vertices (difference times e
 * - p w) 2^80, times a difference 2^110: wide_t. Cost: nine products a vertex, and in perspective three divisions. */
#ifndef SOLID_MAP_H
#define SOLID_MAP_H

#include "scene/solid.h"
#include "view/camera.h"

#define SOLID_EYE_BITS 50
#define SOLID_Z_BITS 29
#define SOLID_PLACE_MOST (1 << 29)

_Static_assert(SOLID_BITS + SOLID_EYE_BITS + 2 + SOLID_BITS + 2 + 2 < 126,
               "a plane through the eye times a difference");

typedef struct solid_place {
    int32_t x, y; /* lat; limited to +-SOLID_PLACE_MOST, which is 16 m */
    int32_t z;    /* see above; INT32_MIN behind the eye */
} solid_place_t;

typedef struct solid_eye {
    int64_t e[3], w; /* |e| < 2^50, 0 <= w <= 2^22 */
} solid_eye_t;

typedef struct solid_map {
    const solid_t *solid;
    const camera_t *cam;
    line_space_t lines; /* of family INK_SEGMENT, line = edge */
    solid_eye_t eye;
    int64_t row[3][4]; /* homogeneous coordinates of a lattice point, in lines' units times 2^row_bits[r] */
    int32_t row_bits[3];
    int32_t z_shift; /* parallel */
    int64_t z_row[3];
    solid_place_t *place; /* of each vertex */
    bool any_behind;
    bool all_good; /* every vertex: solid_map_is_good */
    bool
        through; /* translucent faces are looked through: for the area sort they are not there, their edges are lines */
} solid_map_t;

#define SOLID_MAP_BYTES(vertices) ((size_t)(vertices) * sizeof(solid_place_t) + 8)

/* Prepares m; place: SOLID_MAP_BYTES(solid->nv), aligned to 8. solid, cam and place outlive m. Returns 0 or ERR_VALUE.
 */
int solid_map_setup(solid_map_t *m, const solid_t *solid, const camera_t *cam, void *place);
/* A vertex in homogeneous page coordinates. */
page_h_t solid_map_vertex(const solid_map_t *m, int32_t v);
/* Depth as fine as the lattice has it. Perspective: E times 2^SOLID_FINE_E. Parallel: the distance along the lines of
 * sight, below 2^SOLID_FINE_Z in amount; smaller is nearer. */
#define SOLID_FINE_E 24
#define SOLID_FINE_Z 60
int64_t solid_map_fine(const solid_map_t *m, int32_t v);
static inline bool solid_map_is_behind(const solid_map_t *m, int32_t v) {
    return m->place[v].z == INT32_MIN;
}
/* Is it where x and y say, give or take half a lat and a hair: neither behind the eye nor beyond the limit? */
bool solid_place_is_good(const solid_place_t *p);
static inline bool solid_map_is_good(const solid_map_t *m, int32_t v) {
    return m->all_good || solid_place_is_good(&m->place[v]);
}
/* An edge's ends on the page and the parameters in space of what is in front of the eye, 0 and INK_ONE for an edge that
 * is not cut there. If a vertex is not good, the places are where the edge, along itself, comes 32 mm close to the
 * window: off by *off_lat at most from its picture, for the rounding of homogeneous coordinates (0 for other edges; a
 * few lat, 2^10 next to the eye), and of no less depth than what is seen. False if nothing of it is near the window. */
bool solid_map_edge(const solid_map_t *m, int32_t edge, solid_place_t end[2], int64_t t_q30[2], int32_t *off_lat);

#endif
