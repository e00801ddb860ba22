/* wires.h - solids as wire frames: every edge, nothing hidden. */
#ifndef WIRES_H
#define WIRES_H

#include "hidden/hidden.h"
#include "view/solid_map.h"

/* Emits all edges and segments, each once. Needs no memory. Returns 0 or the sink's error. */
int wires_draw(const solid_map_t *m, const hidden_job_t *job, hidden_stats_t *stats);

#endif
