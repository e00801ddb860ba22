/* page_lines.h - drawings as bare lists of segments on the page, in mm: does one cover another, is anything there
 * twice? Every segment against every other, in double. */
#ifndef PAGE_LINES_H
#define PAGE_LINES_H

#include <stddef.h>

#include "tests/oracle/spans.h"

typedef struct page_line {
    double x0, y0, x1, y1;
} page_line_t;

typedef struct page_lines {
    page_line_t *line;
    size_t n, cap;
} page_lines_t;

void page_lines_add(page_lines_t *l, page_line_t line);
void page_lines_free(page_lines_t *l);
double page_lines_length(const page_lines_t *l);
/* The longest run of a segment of `what` that has nothing of `by` within `near` mm. */
double page_lines_uncovered(const page_lines_t *what, const page_lines_t *by, double near);
/* Where along a, in [0, 1], a segment of `by` is within `near` mm. */
void page_lines_along(const page_line_t *a, const page_lines_t *by, double near, spans_t *out);
/* The longest stretch over which a segment of p lies within `near` mm all along one of q; p may be q: then along
 * another. Both at least `least` long. */
double page_lines_twice(const page_lines_t *p, const page_lines_t *q, double near, double least);

#endif
