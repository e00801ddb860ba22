/* grid_outline.h - of the lines of surfaces only what outlines them: their borders, rims of holes, and silhouettes,
 * where of the two facets at an edge one shows its upper side and the other its lower one. */
#ifndef GRID_OUTLINE_H
#define GRID_OUTLINE_H

#include "scene/grid.h"
#include "view/line_space.h"

typedef struct grid_outline {
    const line_space_t *lines; /* of each surface */
    const grid_t *grid;        /* the same */
    ink_sink_t next;
} grid_outline_t;

/* Lets those parts of INK_ROW and INK_COL pieces through, and pieces of other families. o and what it points to outlive
 * the sink. Cost: six vertices for each edge. */
ink_sink_t grid_outline_sink(grid_outline_t *o);

#endif
