/* outline.h - the lines that bound a facet in the chart. */
#ifndef OUTLINE_H
#define OUTLINE_H

#include "view/pencil.h"

/* Of four edges, cut at diagonals and zones of CHART_AROUND: a twisted facet passes the eye's level four times, and
 * eight zones each time. A facet with more lines would hide nothing. */
#define OUTLINE_LINES 56

typedef struct outline_line {
    pencil_t p, q; /* p.a < q.a */
} outline_line_t;

#endif
