/* triangulate.h - a polygon cut into triangles, by its ears. */
#ifndef TRIANGULATE_H
#define TRIANGULATE_H

#include "scene/solid_math.h"

/* Gives the n - 2 triangles of a face to `take`, in its direction. normal: solid_face_normal(). The polygon may be
 * concave; one that crosses itself is cut somehow. mem: 4 bytes a corner, during the call. Returns 0 or ERR_FULL.
 * Cost: O(n^2) for usual polygons. */
int triangulate(const solid_t *s, int32_t face, const solid_normal_t *normal, void *mem, size_t bytes,
                void (*take)(void *ctx, const int32_t v[3]), void *ctx);

#endif
