/* loop.h - opens closed strokes, where it saves a lift: at a node where another stroke ends.
 *
 * Pairing ends may close a stroke on itself (the border of a grid, a round silhouette). A closed stroke has to start
 * somewhere anyway, so starting it where some open stroke ends costs nothing and makes one stroke of two: only
 * then is Euler's minimum reached. The others are opened where two of their runs meet.
 * Cost: two points of the map for every vertex of a closed stroke; open strokes cost nothing. */
#ifndef LOOP_H
#define LOOP_H

#include "path/chain.h"

/* Enters the free ends that may be near a closed stroke; false if there is no such stroke. After chain_close. */
bool loop_find(chain_t *c);
/* Opens all closed strokes, after loop_find. May cut a run in two at a node, while the pool has room for it. */
void loop_open(chain_t *c);
/* Where a closed stroke was opened: at the free end `other`, found from the place `at`. It goes on there, and `end` is
 * free instead. */
typedef struct loop_joint {
    int32_t other, end;
    page_point_t at;
} loop_joint_t;
/* Opens the closed stroke through the end e. False if that end, and what it went on into, are free now. */
bool loop_open_at(chain_t *c, int32_t e, loop_joint_t *joint);

#endif
