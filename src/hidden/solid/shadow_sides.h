/* shadow_sides.h - which faces look at the eye, and which objects it is inside of (shadow_build.c). */
#ifndef SHADOW_SIDES_H
#define SHADOW_SIDES_H

#include "hidden/solid/shadow.h"

/* Fills in s->face, still without the flags of its object, and s->object; s->map is set. Returns how many objects are
 * SHADOW_WHOLE. */
int32_t shadow_sides_find(shadows_t *s);

/* Of a face, without the flags. */
static inline int32_t shadow_side_of(const shadows_t *s, int32_t f) {
    return s->face[f] & SHADOW_SIDE;
}

static inline const solid_vertex_t *shadow_corner(const shadows_t *s, int32_t f, int32_t k) {
    const solid_t *solid = s->map->solid;
    return &solid->vertex[solid->corner[solid->face[f].corner + k]];
}

#endif
