/* surface_mesh.h - a surface as a mesh, for scenes in which it stands among solids.
 *
 * Each cell whose four corners are defined becomes a polygon of four corners, which need not be flat; its diagonal is
 * no edge. Or two triangles, which are (MESH_GRID). Memory: SURFACE_MESH_BYTES of the columns and rows. */
#ifndef SURFACE_MESH_H
#define SURFACE_MESH_H

#include "scene/mesh.h"
#include "scene/surface.h"

#define SURFACE_MESH_BYTES(nx, ny, triangles)                                                                          \
    ((size_t)(nx) * (size_t)(ny)*3 * sizeof(packed_t) +                                                                \
     ((size_t)(nx)-1) * ((size_t)(ny)-1) * ((triangles) ? 8 : 5) * sizeof(int32_t) + 8)

/* Makes m from s in mem (aligned to 8). Heights beyond lo and hi (NULL: no limit) are holes. */
void surface_mesh(const surface_t *s, const num_t *lo, const num_t *hi, bool triangles, void *mem, mesh_t *m);
/* The counts that it would have without holes. */
void surface_mesh_counts(const surface_t *s, bool triangles, mesh_t *m);

#endif
