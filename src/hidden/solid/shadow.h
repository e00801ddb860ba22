/* shadow.h - what the convex parts of a scene hide: one shadow for each.
 *
 * The shadow of a convex part is where a line of sight has passed through it: behind all planes of its faces that look
 * at the eye, and inside of all planes through the eye and an edge of its outline. A segment has at most one interval
 * in it. The shadows of a scene are those of convex objects with up to SHADOW_FACES_MOST faces, of the faces of others
 * one by one, and of triangles where a face is not convex or not flat.
 *
 * Which side of a plane an end is on is mostly clear from 30 bits of the plane's normal, which are kept; the exact
 * plane is made again from its face where a segment crosses it or comes near. In the same way the outline is first held
 * against the line's picture, and only what crosses it there is decided in space.
 *
 * Memory: SHADOW_BYTES() at most; in use afterwards 48 bytes a shadow, 24 a plane, 8 an edge of an outline, 1 a face, 5
 * an object.
 */
#ifndef SHADOW_H
#define SHADOW_H

#include "num/wide.h"
#include "scene/solid_math.h"
#include "view/solid_map.h"

#define SHADOW_FACES_MOST 48 /* beyond, faces one by one are faster: the page grid leaves most of them alone */

/* n . p - c < 0 behind the plane, as far as 30 bits of its normal tell: off by less than SHADOW_NEAR. Touching is taken
 * off c already. */
typedef struct shadow_plane {
    int64_t c;
    int32_t n[3];
    int32_t face; /* whose it is; -1: of the triangle that the outline is */
} shadow_plane_t;
#define SHADOW_NEAR ((int64_t)1 << (SOLID_BITS + 2))
/* n . p, and the sum of a normal's sizes: times so many units it is what n . p is off by if p is. */
static inline int64_t shadow_plane_dot(const int32_t n[3], const int32_t p[3]) {
    return wide_mul_s32(n[0], p[0]) + wide_mul_s32(n[1], p[1]) + wide_mul_s32(n[2], p[2]);
}
static inline int64_t shadow_plane_size(const int32_t n[3]) {
    return (int64_t)(solid_abs(n[0]) + solid_abs(n[1]) + solid_abs(n[2]));
}

typedef struct shadow {
    int32_t plane, outline;
    int32_t outlines;
    int16_t planes;
    bool exact;             /* places on the page are of no use */
    int32_t x0, y0, x1, y1; /* lat: box of the picture; everything for a part that reaches behind the eye */
    int32_t z, far;         /* nearest depth (solid_place_t), INT32_MIN then, and farthest of what is seen */
    int32_t seen;           /* the user's: last line it was compared with */
    int32_t owner;          /* shadows_owner() of edges that it does not hide; INT32_MIN: none in particular */
} shadow_t;

/* p to q with the inside to the left as the eye sees it. */
typedef struct shadow_edge {
    int32_t p, q;
} shadow_edge_t;

/* What is known of a face: its side, and flags. */
enum shadow_side {
    SHADOW_AWAY = 0,
    SHADOW_FRONT = 1, /* looks at the eye */
    SHADOW_EDGE_ON = 2,
    SHADOW_SIDE = 3,
    SHADOW_BENT = 4,   /* not convex or not flat */
    SHADOW_OPEN = 8,   /* of an open object, or the eye is inside: both sides of its faces may be seen */
    SHADOW_WHOLE = 16, /* its object has one shadow */
    SHADOW_SMOOTH = 32 /* its object has a `crease` or is a grid: not all of its edges are lines */
};

typedef struct shadows {
    const solid_map_t *map;
    uint8_t *face;   /* enum shadow_side */
    uint8_t *object; /* SHADOW_OPEN, SHADOW_WHOLE, SHADOW_SMOOTH */
    int32_t *part;   /* of each object with SHADOW_WHOLE: its place in list */
    shadow_t *list;
    int32_t n, whole; /* of them are objects', the first */
    shadow_plane_t *plane;
    shadow_edge_t *outline;
    size_t bytes; /* of the lent memory in use */
} shadows_t;

/* A segment to be compared with shadows. */
typedef struct shadow_line {
    int32_t v[2];
    solid_place_t end[2]; /* of what is in front of the eye */
    bool exact;           /* an end is not good (solid_map_is_good) */
} shadow_line_t;

/* Enough for a scene of so many faces, corners and objects. */
#define SHADOW_BYTES(faces, corners)                                                                                   \
    ((size_t)(corners) * (sizeof(shadow_t) + sizeof(shadow_plane_t) + 3 * sizeof(shadow_edge_t)) + (size_t)(faces)*8 + \
     64)

/* Finds the shadows of a scene in mem (aligned to 8), which lives as long as s. Returns 0 or ERR_FULL. */
int shadows_build(shadows_t *s, const solid_map_t *map, void *mem, size_t bytes);
/* Does any face at the edge (one record of twins) look at the eye, or may both its sides be seen? Otherwise its own
 * object hides it. */
static inline bool shadows_is_candidate(const shadows_t *s, const solid_edge_t *e) {
    const int32_t f = e->face[0], g = e->face[1];
    if (f < 0 && g < 0) return true;
    return (s->face[f < 0 ? g : f] | s->face[g < 0 ? f : g]) & (SHADOW_FRONT | SHADOW_OPEN);
}
/* What face it belongs to as shadow_t.owner has it: the whole object, or the one face. */
static inline int32_t shadows_owner(const shadows_t *s, int32_t face) {
    return s->face[face] & SHADOW_WHOLE ? ~s->map->solid->face[face].object : face;
}
/* Does one of the edge's two faces look at the eye and the other not? */
static inline bool shadows_is_outline(const shadows_t *s, const solid_edge_t *e) {
    return (e->face[0] | e->face[1]) >= 0 && (s->face[e->face[0]] ^ s->face[e->face[1]]) & SHADOW_FRONT;
}
/* Is a part of the line, whose picture's box meets that of the shadow, in it: parameters in space from *from to *to,
 * 0 .. INK_ONE, *from < *to. */
bool shadow_hides(const shadows_t *s, const shadow_t *shadow, const shadow_line_t *line, int32_t *from, int32_t *to);

#endif
