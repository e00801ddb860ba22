/* dash.h - ink with gaps: an ink sink that hands straight pieces on as dashes of even length on the page.
 *
 * A piece begins and ends with a dash, so that corners of hidden edges stay corners; its dashes are about DASH_LAT
 * long, with gaps of three quarters of that. What is too short for two dashes stays whole. */
#ifndef DASH_H
#define DASH_H

#include "hidden/ink.h"
#include "view/line_space.h"

#define DASH_LAT (2 * LAT_PER_MM)

typedef struct dash {
    const line_space_t *lines; /* one per surface of the scene */
    ink_sink_t next;
} dash_t;

/* d must outlive the sink. Pieces must lie between two neighbouring vertices, in front of the eye; cut them first, what
 * is off the page would be dashed too. */
ink_sink_t dash_sink(dash_t *d);

#endif
