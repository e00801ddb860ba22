/* seams.h - the lines in which solids cut through each other, as free segments of the scene.
 *
 * A drawing of edges alone leaves out where two bodies meet that were pushed into each other: no edge is there. Here
 * every face of an object is held against every face of another that its box touches; the line both planes have in
 * common, as far as it lies in both faces, becomes a segment. It lies in the planes of its two faces to a lattice unit,
 * which is contact for the kernel (solid.h: SOLID_FLAT), so they do not hide it, and all else is hidden or seen as
 * usual.
 *
 * Faces that only touch (all corners of one on one side of the other's plane, to SOLID_FLAT) have no seam: an edge is
 * there. Faces of one object are not looked at. Faces that are concave or not flat are cut into triangles, as the
 * kernel does. Which of two faces crosses the other's plane are signs of determinants, exact; ends are rounded once,
 * and the same end of two neighbouring seams is the same place.
 *
 * Pairs: objects whose boxes overlap, by a sweep; of those, faces by another along the same axis. Cost: objects +
 * faces log faces + pairs of boxes, for objects spread over that axis. Memory while it works: 44 bytes an object, and
 * if boxes overlap 52 a convex face or triangle; afterwards 96 a seam, and the scene's vertices and edges once more. */
#ifndef SEAMS_H
#define SEAMS_H

#include "scene/solid.h"

/* Adds the seams to s, whose vertices and edges are moved into mem (aligned to 8) if there are any; *kept: the bytes of
 * it that live as long as s. Details must be free (solid_free_details). Returns 0 or ERR_FULL. */
int seams_add(solid_t *s, void *mem, size_t bytes, size_t *kept);

#endif
