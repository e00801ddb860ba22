/* perimeter.h - a grid surface without its hidden lines (D. P. Anderson 1982).
 *
 * Facets are taken in occlusion-compatible order (his section 4): rows outward from the eye's cell, columns outward
 * within a row, so two rows of the surface are in memory and never more. What changed against the paper: visibility
 * is decided in pencil coordinates (view/chart.h), where his three forms of the perimeter are one band between two
 * horizons, views in grid planes need no perturbation, and viewpoints inside the rectangle need no polar lists. */
#ifndef PERIMETER_H
#define PERIMETER_H

#include "config.h"
#include "hidden/hidden.h"
#include "scene/grid.h"
#include "view/camera.h"

/* Draws every visible piece of the grid lines of g into job->sink: families INK_ROW and INK_COL, surface 0, no piece
 * twice. Pieces of one line that continue each other through a vertex are joined where that needs no memory.
 * g has been measured. Returns 0, ERR_FULL when the horizons do not fit into job->bytes (stats->bytes then says
 * what was reached), or the sink's error.
 * Cost: linear in the facets for all surfaces we know; memory: see perimeter_bytes. */
int perimeter_draw(grid_t *g, const camera_t *cam, const hidden_job_t *job, hidden_stats_t *stats);

/* The same for n surfaces over the same points (x, y), 1 <= n <= 255 (1 where CONFIG_PLOT_ITEMS is 1); pieces carry the
 * surface's number. A surface with holes takes holes.h, several surfaces cells.h: half of the memory is then for
 * windows, 52 bytes each, a few for each vertex of the holes' rims, or one for each column between two surfaces.
 * Several surfaces take some 5,000 instructions a facet. Returns as above, or ERR_UNSUPPORTED when the grids' points
 * differ. */
int perimeter_draw_several(grid_t *const grid[], int32_t n, const camera_t *cam, const hidden_job_t *job,
                           hidden_stats_t *stats);
/* Have they the same points? */
bool perimeter_same_points(const surface_t *s, const surface_t *t);

#if CONFIG_AREA
struct shaded;
/* The same, and hatches what is visible of the facets (shaded.h). */
int perimeter_draw_shaded(grid_t *const grid[], int32_t n, const camera_t *cam, const hidden_job_t *job,
                          struct shaded *shaded, hidden_stats_t *stats);
#endif

/* Memory for nx columns and `vertices` horizon vertices (both horizons together). 4 (nx + ny) vertices are enough
 * for smooth surfaces, 10 (nx + ny) for random ones as large as 200 x 200. */
size_t perimeter_bytes(int32_t nx, int32_t vertices);
/* The same for a surface without holes. */
size_t perimeter_bytes_least(int32_t nx, int32_t vertices);

#endif
