/* windows.h - what of a band between two horizons is not covered: for surfaces with holes, and for several surfaces.
 *
 * In a vertical plane through the eye the surface seen so far lies within one interval, between a lower and an upper
 * horizon (horizons.h); without holes it covers all of it. A facet behind a hole leaves a window between the horizon
 * and its near edge: what is farther away can be seen there, until something covers it.
 *
 *      w |    .----.         upper horizon, after the far edge f
 *        |    |////|f        a facet
 *        |    '----'n        its near edge; nothing nearer ends here
 *        |     |  |          a window
 *        |  ---'--'---       the upper horizon before
 *        +--------------- a
 *
 * A window is a trapezoid [a0, a1] between two lines of the chart, which are kept as they were: a window is cut as
 * often as one likes without moving, and what has been cut joins again when both its lines are the same. So windows are
 * as many as there are corners in what is not covered. They lie in bins of a; one reaches no farther than its bin. In a
 * bin they are listed by the band of w where they begin, high ones by themselves; as windows become many so do bands,
 * where most of them lie, so that lists are short however deep a surface is.
 *
 * Cost: a facet that has no window over it pays a look at the bins it spans; one that has, some ten divisions for each.
 * Error: half a unit where a line is evaluated; an abscissa where two lines cross is rounded to a unit. */
#ifndef WINDOWS_H
#define WINDOWS_H

#include "hidden/surface/envelope.h"
#include "hidden/surface/outline.h"

typedef struct window {
    int32_t a0, a1;
    int32_t low, high; /* no part of it is lower or higher */
    int32_t next;      /* of its list, or of the free ones; -1: none */
    outline_line_t lo, hi;
} window_t;

typedef struct windows {
    window_t *pool;
    int32_t used, free;     /* the pool's entries before `used` have been in use; free: a list of them */
    envelope_spare_t spare; /* behind them */
    envelope_t *above;      /* shares that, or NULL */
    int32_t *list;          /* of each bin: 1 + bands */
    int8_t shift;           /* an abscissa's bin is (a + 2^30) >> shift */
    int32_t bands;          /* 0, or WINDOWS_BANDS or more */
    int32_t most_bands;     /* there is room for */
    uint16_t *band_of;      /* each of WINDOWS_LEVELS levels of the ordinate; NULL: bands are equally high */
    int32_t present;        /* windows there are */
    int32_t few;            /* if there are more, bands become more */
} windows_t;

/* An interval of an edge, as fractions of its way from left to right, or of the height of a vertical one from below. */
typedef struct windows_part {
    int32_t from_q30, to_q30;
} windows_part_t;

#define WINDOWS_BANDS 32 /* to begin with */
#define WINDOWS_LEVEL_BITS 12
#define WINDOWS_LEVELS (1 << WINDOWS_LEVEL_BITS)

/* No windows; above NULL; room for as many as fit into `bytes` of mem (aligned to 8), beside the bins for a surface of
 * n rows or columns. Returns 0 or ERR_FULL. */
int windows_init(windows_t *w, int32_t n, void *mem, size_t bytes);

/* Bytes that have been in use. */
size_t windows_bytes(const windows_t *w);

/* Is there a window that touches [a0, a1] x [low, high]? (Rather yes than wrongly no.) */
bool windows_any(const windows_t *w, int32_t a0, int32_t a1, int32_t low, int32_t high);

/* Opens windows between a horizon and the edge p-q, p.a < q.a, where the edge is above it (lower: both have w negated)
 * and the horizon is not at the floor. Returns 0 or ERR_FULL. */
int windows_open(windows_t *w, envelope_t *h, pencil_t p, pencil_t q, bool lower);

/* What of the edge p-q, p.a < q.a, is in windows by more than the noise: at most WINDOWS_PARTS, sorted. Returns how
 * many. */
#define WINDOWS_PARTS 32
int32_t windows_clip(const windows_t *w, pencil_t p, pencil_t q, windows_part_t part[WINDOWS_PARTS]);

/* The same for a vertical edge from low to high, low < high, next to abscissa x; added to n parts. */
int32_t windows_clip_vertical(const windows_t *w, int32_t x, int32_t low, int32_t high,
                              windows_part_t part[WINDOWS_PARTS], int32_t n);

/* Adds a part to n sorted ones, in its place; parts that touch become one. Returns how many there are then. */
int32_t windows_add_part(windows_part_t part[WINDOWS_PARTS], int32_t n, windows_part_t v);

/* Adds the part of an edge, edge.p.a < edge.q.a, that is between two lines over [a0, a1]. open: what lies on one of
 * them is not. */
int32_t windows_add_between(const outline_line_t *lo, const outline_line_t *hi, int32_t a0, int32_t a1,
                            const outline_line_t *edge, bool open, windows_part_t part[WINDOWS_PARTS], int32_t n);

/* The lowest and the highest of a facet's lines between two abscissae where lines end; the same where there is one. */
typedef struct windows_span {
    int32_t a0, a1;
    const outline_line_t *lo, *hi;
    int32_t low, high; /* no part of either is lower or higher */
    bool cross;        /* they change places once: a twisted facet */
} windows_span_t;

/* The lines make a ring, so there are hardly more spans than lines. */
#define WINDOWS_SPANS (OUTLINE_LINES + 8)

/* The abscissae where lines end, sorted. Returns how many. */
#define WINDOWS_ENDS (2 * OUTLINE_LINES)
int32_t windows_ends(const outline_line_t *line, int32_t n, int32_t end[WINDOWS_ENDS]);

/* The span between two of them that are neighbours; false if there is no line. */
bool windows_span(const outline_line_t *line, int32_t n, int32_t a0, int32_t a1, windows_span_t *v);

/* A facet's spans from left to right; abscissae without a line are left out. Returns how many. */
int32_t windows_spans(const outline_line_t *line, int32_t n, windows_span_t span[WINDOWS_SPANS]);

/* What of an edge a facet hides, added to n parts; below as in windows_close, open as above. */
int32_t windows_behind(const windows_span_t *span, int32_t spans, int below, const outline_line_t *edge, bool open,
                       windows_part_t part[WINDOWS_PARTS], int32_t n);

/* Closes what a facet covers: over each abscissa from the lowest to the highest of its lines; where there is only one,
 * from it down to the floor (below > 0), up to the ceiling (below < 0), or nothing (0). Returns 0 or ERR_FULL. */
int windows_close(windows_t *w, const windows_span_t *span, int32_t spans, int below);

#endif
