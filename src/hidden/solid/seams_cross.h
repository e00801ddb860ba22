/* seams_cross.h - the line in which two flat pieces of faces go through each other (seams.c). */
#ifndef SEAMS_CROSS_H
#define SEAMS_CROSS_H

#include "scene/solid_math.h"

typedef struct seam_box {
    int32_t lo[3], hi[3];
} seam_box_t;

/* A convex face, or a triangle of one that is not. */
typedef struct seam_piece {
    int32_t face;
    int32_t v[3]; /* v[0] < 0: the whole face */
    seam_box_t box;
} seam_piece_t;

typedef struct seam_plane {
    solid_normal_t n;
    wide_t slack;
    const solid_vertex_t *on;
} seam_plane_t;

typedef struct seam {
    solid_vertex_t end[2];
} seam_t;

static inline int32_t seam_corners(const solid_t *s, const seam_piece_t *p) {
    return p->v[0] < 0 ? s->face[p->face].n : 3;
}
static inline int32_t seam_corner(const solid_t *s, const seam_piece_t *p, int32_t k) {
    return p->v[0] < 0 ? s->corner[s->face[p->face].corner + k] : p->v[k];
}

seam_plane_t seam_plane(const solid_t *s, const seam_piece_t *p);
/* What two pieces have of the line in common in which their planes meet; pa: of a. False if that is nothing. */
bool seam_cross(const solid_t *s, const seam_piece_t *a, const seam_plane_t *pa, const seam_piece_t *b, seam_t *out);

#endif
