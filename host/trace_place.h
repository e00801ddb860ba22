/* trace_place.h - steps of a trace that are not where their neighbours say. Part of trace_judge.
 *
 * A motor's position is smooth between two corners of the path: eight steps around one lie on a parabola of time, and
 * so must that one. Where they do not (at a corner, or when a generator rounds all of its steps to a clock) nothing can
 * be said; where they do, a step a tenth of its width off is displaced. A step that is displaced past its neighbours
 * makes all between its two places late by one; so up to TRACE_PLACE_GAP steps are left out of the parabola at a time,
 * and then what a corner in the gap could do is allowed for. */
#ifndef TRACE_PLACE_H
#define TRACE_PLACE_H

#include "host/trace_path.h"

#define TRACE_PLACE_GAP 6
#define TRACE_PLACE_STEPS 0.1 /* less is not told from a corner of the path */

typedef struct trace_place {
    unsigned long count; /* places where steps are out of place; the first: */
    double at_s, off_s;  /* when, and by how long */
} trace_place_t;

/* k: one motor's knots. mm: per step. accel_mm_s2, jump_mm_s: the greatest acceleration, and change of speed at a
 * corner. */
trace_place_t trace_place(const trace_knots_t *k, double mm, double accel_mm_s2, double jump_mm_s);

#endif
