/* halo_page.h - judges a finished drawing of haloed lines on the page, in floating point, from the scene's lines in
 * space.
 *
 * Projects, crosses and compares depths by itself: neither the program's page coordinates nor its 1/E. What hangs on
 * less than the program's contact (halo_ink.h) or on 0.02 mm is left open: either drawing is right. */
#ifndef HALO_PAGE_H
#define HALO_PAGE_H

#include "tests/oracle/page_view.h"

typedef struct halo_page_line {
    exact_point_t end[2];
} halo_page_line_t;

/* A straight piece of a stroke, mm. */
typedef struct halo_page_ink {
    double x0, y0, x1, y1;
} halo_page_ink_t;

typedef struct halo_page_report {
    double checked_mm, gaps_mm; /* lines that must be drawn, gaps that must be free */
    double missing_mm, false_mm;
    double x, y; /* a place that is wrong */
} halo_page_report_t;

/* The drawing of n lines seen through v, haloes `width` mm to either side. */
halo_page_report_t halo_page_judge(const page_view_t *v, const halo_page_line_t *line, int n, double width,
                                   const halo_page_ink_t *ink, int pieces);

#endif
