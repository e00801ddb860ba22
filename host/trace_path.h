/* trace_path.h - where the steps of a trace put the pen, and when. Shared by judging and drawing. */
#ifndef TRACE_PATH_H
#define TRACE_PATH_H

#include "host/trace.h"
#include <stddef.h>

/* Motor positions (steps, may be halves) to page mm: the inverse of src/motion/kinematics.h. */
void trace_path_page(const machine_t *m, const double motor[2], double page_mm[2]);

/* The continuous position behind one motor's steps: a step from n to n+1 (or back) says that it passed n + 1/2. */
typedef struct trace_knots {
    double *time_s, *pos;
    size_t count, room;
} trace_knots_t;

/* Adds a knot; false: no memory. */
bool trace_knots_add(trace_knots_t *k, double time_s, double pos);
/* Position at a time, linear between knots and constant outside. *cursor starts at 0; times must not decrease from call
 * to call. */
double trace_knots_at(const trace_knots_t *k, size_t *cursor, double time_s);
void trace_knots_free(trace_knots_t *k);

#endif
