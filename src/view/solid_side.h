/* solid_side.h - which side of a plane of the scene's lattice the eye is on. */
#ifndef SOLID_SIDE_H
#define SOLID_SIDE_H

#include "scene/solid_math.h"
#include "view/solid_map.h"

/* eye - p, times the eye's w. */
static inline void solid_to_eye(const solid_map_t *m, const solid_vertex_t *p, int64_t v[3]) {
    for (int k = 0; k < 3; k++) v[k] = m->eye.e[k] - p->at[k] * m->eye.w;
}
/* The sign of n . (eye - p): exact. */
int solid_side_exact(const solid_map_t *m, const solid_normal_t *n, const solid_vertex_t *p);
/* The same, but 0 for an eye as near to the plane as its vertices may be off for being rounded (SOLID_FLAT): then it is
 * in it, and whatever that face is of does not hide half of the world. */
int solid_side(const solid_map_t *m, const solid_normal_t *n, const solid_vertex_t *p);

#endif
