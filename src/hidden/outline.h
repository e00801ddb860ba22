/* outline.h - the lines that bound a facet in the chart. */
#ifndef OUTLINE_H
#define OUTLINE_H

#include "view/pencil.h"

/* Of four edges, each cut at diagonals and zones of CHART_AROUND at most. */
#define OUTLINE_LINES 32

typedef struct outline_line {
    pencil_t p, q; /* p.a < q.a */
} outline_line_t;

#endif
