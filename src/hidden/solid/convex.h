/* convex.h - solids: every edge against every convex object near it.
 *
 * A. Ricci, "An algorithm for the removal of hidden lines in 3D scenes", The Computer Journal 14 (1971), 375-377: an
 * object that is convex hides one interval of a segment at most. Where he intersects the segment's picture with those
 * of all edges of the object and then compares depths, the segment is clipped here once, in space, against the object's
 * shadow: the points behind all planes of faces that look at the eye, and inside all planes through the eye and an edge
 * of its outline. That makes his special cases one rule each:
 *
 *     in the plane of a face that looks at the eye    not hidden: edges that touch the object without crossing it; one
 *                                                     that ends there is hidden up to its end
 *     in the plane through the eye and an outline     hidden if behind: what falls together with a nearer line, or
 *                                                     lies behind the seam of two faces, is not drawn
 *     edge of the object itself                       visible if one of its faces looks at the eye, else hidden;
 *                                                     dropped before anything is compared
 *     a plane through the eye                         looks away: a polygon seen edge-on hides nothing
 *     a segment seen end-on                           no ink
 *
 * Objects are the scene's convex ones (solid.h), and one by one the faces of the others: those that look at the eye of
 * closed ones, both sides of open ones. Faces that are not convex or not flat are cut into triangles, whose own
 * diagonals are no ink: polygons that are not flat are cut as the eye sees them, so that no diagonal is an outline. A
 * viewer inside of a closed object sees the inner sides of its faces; one in a face, or within SOLID_FLAT of its plane,
 * sees it edge-on. Objects that penetrate each other hide each other's parts; the line in which they do is none of the
 * edges, and as in the paper it is not drawn.
 *
 * Signs are exact: planes on the scene's lattice, the eye as solid_map.h has it. Touching is generous by SOLID_FLAT
 * lattice units, 2^-26 of the scene, since vertices of slanting planes are rounded. A crossing is rounded once, to
 * 2^-30 of the edge. That is right for bodies down to some 10^-5 of the scene thick (tests/oracle/solid_touching.h);
 * of thinner ones lines may be drawn twice, or shine through.
 *
 * Objects lie in the cells of a grid over the page by their pictures' boxes; an edge visits the cells along it. Most
 * pairs are decided by rounded page coordinates with a margin for their rounding; exact products are left to edges that
 * do cross an outline.
 * Memory: convex_bytes(). Cost: printed by make bench. */
#ifndef CONVEX_H
#define CONVEX_H

#include "hidden/hidden.h"
#include "view/solid_map.h"

/* Lent memory for a scene of so many faces with so many corners, and free segments; enough but for scenes with very
 * many visible parts to an edge, or very large objects on the page. */
size_t convex_bytes(int32_t faces, int32_t corners, int32_t segments);
/* Emits the visible parts of all edges as INK_SEGMENT. If hidden is not NULL, the other parts go there. Returns 0,
 * ERR_FULL when job->mem is too small, or the sinks' errors. */
int convex_draw(const solid_map_t *m, const ink_sink_t *hidden, const hidden_job_t *job, hidden_stats_t *stats);

#endif
