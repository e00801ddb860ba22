/* emit.h - draws a stroke: computes the vertices of its runs again and hands them to simplify.h. */
#ifndef EMIT_H
#define EMIT_H

#include "path/pool.h"
#include "path/simplify.h"

/* Draws the stroke that starts at the free end `start` and marks its runs RUN_DRAWN. *vertices grows by their
 * points. point: what the map says of every end of a run, or NULL. A vertex that the map does not find is passed over.
 * Returns 0 or the error of the sink. */
int emit_stroke(pool_t *pool, const ink_map_t *map, const page_point_t *point, int32_t start, simplify_t *out,
                int64_t *vertices);
/* The same for a run without a vertex between its ends, which is a stroke and need not be marked. Most strokes of a
 * rough surface are so. */
int emit_plain(const page_point_t *point, int32_t start, simplify_t *out, int64_t *vertices);
/* Marks the runs of a stroke RUN_DRAWN without drawing them. */
void emit_drop(pool_t *pool, int32_t start);
/* Is the whole stroke shorter than dot_lat? Looks no further than it must. */
bool emit_is_dot(const pool_t *pool, const ink_map_t *map, const page_point_t *point, int32_t start, int32_t dot_lat);

#endif
