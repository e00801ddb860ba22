/* page_view.h - the judge's own camera: from the world to page millimetres in floating point.
 *
 *     (X, Y, E) = m (x, y, z, 1),   page = (X / E, Y / E) mm
 *
 * Only what is in front (E > 0) and inside the window counts as page. */
#ifndef PAGE_VIEW_H
#define PAGE_VIEW_H

#include <stdbool.h>

#include "tests/oracle/page_lines.h"
#include "tests/oracle/surface_ref.h"

typedef struct page_view {
    double m[3][4];
    exact_eye_t eye;
    double x0, y0, x1, y1; /* window (mm) */
} page_view_t;

/* An A4 page looking from the eye (in the direction of a parallel eye) at `to`; the whole surface fits unless the eye
 * is so near that it would take more than a field of 100 degrees. */
void page_view_aim(page_view_t *v, const surface_ref_t *r, const double to[3]);
/* The eye from a matrix alone: its null vector. */
exact_eye_t page_view_eye_of(const double m[3][4]);
/* Page position of p; false when it is not in front. */
bool page_view_point(const page_view_t *v, exact_point_t p, double *px, double *py);
/* The part [*t0, *t1] of the segment that is in front and in the window; false if none. */
bool page_view_clip(const page_view_t *v, const exact_point_t end[2], double *t0, double *t1);
/* What of [from, to] of a segment is on the page, and the depths (E) of its ends: places along it are not in proportion
 * to those in space. */
typedef struct page_part {
    page_line_t at;
    double from, to; /* of the segment, in space */
    double depth[2];
} page_part_t;
/* False if nothing of it is. */
bool page_view_part(const page_view_t *v, const exact_point_t end[2], double from, double to, page_part_t *part);
/* Ends of the segment moved on the page by (dx, dy) mm at unchanged depth. */
void page_view_shift(const page_view_t *v, const exact_point_t end[2], double dx, double dy, exact_point_t out[2]);

#endif
