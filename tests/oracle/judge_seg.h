/* judge_seg.h - judges a finished drawing: page segments, of which nobody says to which line they belong.
 *
 * A segment draws the part of an edge beside which it runs within half a step. Visible ink that no segment draws is
 * missing. Of a segment, whatever draws no part of an edge that may be visible (within a step) is false: hidden ink
 * as well as ink that belongs to no line at all. Lines that fall together on the page excuse each other. */
#ifndef JUDGE_SEG_H
#define JUDGE_SEG_H

#include "tests/oracle/judge.h"

typedef struct page_seg {
    double x0, y0, x1, y1; /* mm */
} page_seg_t;

typedef struct judge_seg_report {
    judge_report_t pieces; /* missing ink and ends; its false ink counts only what belongs to no visible line */
    double false_mm;       /* longest run of a segment that draws nothing visible */
    page_seg_t false_seg;  /* the segment it is part of */
    double false_total_mm;
    double drawn_mm; /* sum of all segments */
} judge_seg_report_t;

void judge_segments(const judge_subject_t *what, const page_view_t *v, const page_seg_t *seg, size_t n,
                    judge_seg_report_t *out);

/* Reads a .seg file: `# camera` and 12 numbers, then `x0 y0 x1 y1` a line. Returns the segments (to be freed) or NULL;
 * the camera's eye is found from the matrix. */
page_seg_t *judge_seg_read(const char *name, page_view_t *v, size_t *n);

#endif
