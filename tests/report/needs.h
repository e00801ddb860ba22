/* needs.h - what a scene needs, and what a method that models everything would: the parts of report_needs.
 *
 * The general method: each facet is a convex object with the planes of its shadow (A. Ricci 1971: one front plane, four
 * through the eye), each edge is clipped against every object whose box on the page meets its own. Finding those pairs
 * is not counted, so the ratio flatters it. */
#ifndef REPORT_NEEDS_H
#define REPORT_NEEDS_H

#include "tests/oracle/page_view.h"

#define NEEDS_OBJECT_BYTES (4 * 12 + 5 * 16) /* four corners, five planes, in 32-bit numbers */

typedef struct needs_box {
    float x0, y0, x1, y1;
} needs_box_t;

/* Of the pictures of n points. */
needs_box_t needs_box(const page_view_t *view, const exact_point_t *p, int n);
bool needs_boxes_meet(const needs_box_t *a, const needs_box_t *b);

/* Each writes its table into dir and its part of the section on stdout. */
void needs_solids(const char *dir);
void needs_haloes(const char *dir);

#endif
