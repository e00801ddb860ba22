/* area_body.h - consolidation: a convex body of several visible faces as one polygon of the area sort, its silhouette.
 *
 * Weiler and Atherton's section "Consolidation": a polygon that exactly encompasses those of a body takes their place,
 * and they are detail of it. The silhouette is their union (poly/clip.h). Here bodies are convex closed objects: their
 * faces do not hide each other, and of two such bodies that are apart one is in front wherever both are seen, so no
 * depth at a place is asked. A plane of a face of either one that has the other body outside says which: the one on the
 * eye's side. A polygon is compared with a body alike, by its own plane or one of the body's. Where no such plane is
 * found, bodies may cut through each other; then their faces are sorted one by one, as they are where memory is short,
 * where something is clipped in space, where depth is divided, and where they are translucent.
 *
 * What is seen of a silhouette is divided among the faces again when it is given away (area_sort.c), so that what comes
 * out is as without; but where sides of faces meet in the middle of a silhouette nothing is cut and nothing rounded.
 *
 * Memory: for each body an area_face_t and as many vertices as its faces have. Cost: a union for each body; a few dot
 * products for each pair whose boxes meet, for each clip. */
#ifndef AREA_BODY_H
#define AREA_BODY_H

#include "hidden/area/area_face.h"
#include "poly/clip.h"

/* So many bodies at most. */
int32_t area_bodies_most(const solid_map_t *m);
/* Marks the faces that belong to what may become bodies. Returns how many vertices they have. */
int32_t area_bodies_vertices(area_faces_t *faces);
/* Memory that stays in use: which faces the scene's objects have. */
size_t area_bodies_bytes(const solid_t *s);
/* Makes bodies of the faces that were marked. There is room for area_bodies_most() more faces, and for so many vertices
 * after faces->vertices; mem (aligned to 8): area_bodies_bytes(), in use as long as the faces are. clip_mem is lent;
 * bodies that it does not suffice for are left as they are. */
void area_bodies_make(area_faces_t *faces, void *mem, void *clip_mem, size_t clip_bytes);
/* Divides the bodies that are `broken` into their faces again, which come among the others by depth; all of them, if
 * `all`. Returns whether there were any. */
bool area_bodies_break(area_faces_t *faces, bool all);

/* Where body or polygon `of` is to body or polygon `than`, of which one is a body, on the page where both are: 1 in
 * front, -1 behind, 0 they have no more than a border in common. AREA_APART_UNKNOWN if there is no plane between them.
 */
#define AREA_APART_UNKNOWN 2
int area_bodies_compare(const area_faces_t *faces, int32_t of, int32_t than);

/* The faces of a body: [*from, *to) of faces->face. */
void area_body_parts(const area_faces_t *faces, int32_t body, int32_t *from, int32_t *to);

#endif
