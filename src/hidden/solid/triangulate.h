/* triangulate.h - a polygon cut into triangles, by its ears. */
#ifndef TRIANGULATE_H
#define TRIANGULATE_H

#include "scene/solid_math.h"

/* Gives the n - 2 triangles of a face to `take`, in its direction. normal: solid_face_normal(). The polygon may be
 * concave, with holes that touch it and each other (bridges.h); one that crosses itself is cut somehow. slivers: also
 * those without an area that have one as somebody may see them, where corners are in a line but for rounding; without
 * them lines shine through between the others. mem: 4 bytes a corner, during the call. Returns 0 or ERR_FULL. Cost:
 * O(n^2) for usual polygons. */
int triangulate(const solid_t *s, int32_t face, const solid_normal_t *normal, bool slivers, void *mem, size_t bytes,
                void (*take)(void *ctx, const int32_t v[3]), void *ctx);

/* Does the way from a over b to c turn left, > 0, or right, < 0? */
typedef int triangle_turn_t(void *ctx, int32_t a, int32_t b, int32_t c);
/* The same, with left and right as somebody sees them who finds the polygon running counter-clockwise. Returns 1, and
 * has given nothing, if it crosses itself for him. turn and take have the same ctx. */
int triangulate_seen(const solid_t *s, int32_t face, const solid_normal_t *normal, triangle_turn_t *turn, void *mem,
                     size_t bytes, void (*take)(void *ctx, const int32_t v[3]), void *ctx);

#endif
