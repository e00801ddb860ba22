/* motion_ref.h - the ideal plan of a path: infinite look-ahead in floating point, speeds instead of heights.
 *
 * Limits per vertex: junction deviation v^2 = a d s/(1-s) with s = sin of half the angle between the lines, and
 * v^2 = a R with R the radius of the arc that turns as the vertex does over half of both its lines. */
#ifndef MOTION_REF_H
#define MOTION_REF_H

#include <stddef.h>

typedef struct motion_ref_limits {
    double speed, accel, junction; /* mm/s, mm/s^2, mm */
} motion_ref_limits_t;

typedef struct motion_ref_point {
    double x, y; /* mm */
} motion_ref_point_t;

typedef struct motion_ref_line {
    double length, start_s; /* start: from the start of the run */
    double v_in, v_top, v_out;
} motion_ref_line_t;

/* Plans a run from rest at p[0] to rest at p[n-1]; lines: n - 1 results, or NULL. Returns the time in s.
 * Points equal to their predecessor make lines of length 0. */
double motion_ref_run(const motion_ref_point_t *p, size_t n, const motion_ref_limits_t *limits,
                      motion_ref_line_t *lines);
/* When the pen is s mm into a line, from the start of the run. */
double motion_ref_when(const motion_ref_line_t *line, double accel, double s);
/* The inverse: how far into a line the pen is, t s after the start of the run, which must fall into the line. */
double motion_ref_where(const motion_ref_line_t *line, double accel, double t);
/* The time of a straight move between rests. */
double motion_ref_travel(double length, const motion_ref_limits_t *limits);

#endif
