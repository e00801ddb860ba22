/* plain.h - no hidden-line removal: every line of a grid, whole (`unset hidden3d`, and views from straight above or
 * below, where a graph of a function hides nothing).
 *
 * Lines are interrupted at undefined points, and end where they cross a limit of heights (grid.h). Cost: one look at
 * each point for each family drawn. */
#ifndef PLAIN_H
#define PLAIN_H

#include "hidden/ink.h"
#include "scene/grid.h"

/* Emits the lines of one family (INK_ROW or INK_COL) of g as pieces of surface number `surface`. With `facets`, only
 * edges of a facet are drawn, that is of a cell whose four corners are defined; otherwise all between two defined
 * points. Returns 0 or the sink's error. */
int plain_draw(grid_t *g, uint8_t family, bool facets, uint8_t surface, const ink_sink_t *sink);

#endif
