/* edges.h - one grid edge at a time: from chart points through the horizons to visible intervals.
 *
 * Between the sweep (perimeter.c), which knows the order, and the horizons, which know nothing of grids. */
#ifndef EDGES_H
#define EDGES_H

#include "hidden/surface/horizons.h"
#include "hidden/surface/runs.h"
#include "hidden/surface/shade.h"
#include "hidden/surface/strip.h"
#include "hidden/surface/windows.h"
#include "view/chart_around.h"

/* The edge being clipped: where its intervals go. End 0 has the smaller index. */
typedef struct edges_edge {
    uint8_t family;
    int32_t line, cell;
    run_t *run;
    uint32_t g0, g1;            /* reciprocal distances of the ends (of the part being clipped) */
    bool in_plane;              /* a row in the vertical plane of the eye, but for rounding */
    bool quiet;                 /* it only shapes the horizons: what is visible of it is known */
    int64_t start_q46, way_q46; /* the part that is being clipped, in space */
    int32_t taken;              /* how many parts of the edge have been, see edges_t.taken */
} edges_edge_t;

/* A part of the edge at hand that has been taken. Where the horizons meet, or a window and a horizon, lines that all
 * but coincide may show in both. */
typedef struct edges_taken {
    int64_t from_q46, to_q46;
} edges_taken_t;
#define EDGES_TAKEN 4

/* What remembers what is covered: two horizons; those of one strip of the abscissa; or horizons and the windows between
 * them, for a surface with holes and for several surfaces. */
enum edges_cover { COVER_HORIZONS, COVER_STRIP, COVER_WINDOWS };

/* What clipping an edge does: take what is visible and cover; or only one of them. */
enum edges_work { EDGES_CLIP, EDGES_LOOK, EDGES_COVER };

/* Another surface's facet in the same cell, which hides what is behind it. */
typedef struct edges_sheet {
    const windows_span_t *span;
    int32_t spans;
    int8_t below;
    bool open; /* what lies on its border is not hidden */
} edges_sheet_t;

typedef struct edges {
    chart_t chart;
    horizons_t horizons;
    enum edges_cover cover;
    strip_t strip; /* COVER_STRIP */
    windows_t windows;
    bool bare; /* the edge is near, and no facet in front of it ends there */
    enum edges_work work;
    /* Windows want whole facets: the lines of the one at hand. */
    outline_line_t *outline;
    int32_t lines;
    bool outline_only; /* the edge is only to be noted */
    /* Several surfaces: the others' facets in the cell, and what they hide of the line at hand, in lent memory. */
    bool several;
    edges_sheet_t *sheet;
    int32_t sheets;
    windows_part_t *behind;
    int32_t behinds;
    /* Of an edge in a vertical plane through the eye: what the other surfaces' edges beside it hide, in no order. */
    shade_t *shade;
    int32_t shades;
    int64_t clipped;
    runs_t runs;
    edges_edge_t edge;
    edges_taken_t taken[EDGES_TAKEN];
} edges_t;

/* Prepares the cover (seen: see chart_seen) in pool[0..count), after the chart and the strip. Returns 0 or ERR_FULL. */
int edges_init(edges_t *e, const ink_sink_t *sink, enum edges_cover cover, int8_t seen, pencil_t *pool, size_t count);

/* COVER_WINDOWS: the facet at hand touches the point right below (below > 0) or above (below < 0) the eye: where only
 * one line of its outline is, it covers all from there down (up). Call it when its edges have been clipped. */
int edges_cover_below(edges_t *e, const windows_span_t *span, int32_t spans, int8_t below);

/* Clips the edge from (i, line) one column (INK_ROW) or one row (INK_COL, next is row line + 1) further, and adds
 * what is visible to run. Returns 0, ERR_FULL or the sink's error. */
int edges_row(edges_t *e, const chart_line_t *line, int32_t i, run_t *run);
int edges_column(edges_t *e, const chart_line_t *line, const chart_line_t *next, int32_t i, run_t *run);

/* A straight line that is no grid edge, such as one of the hatching of a facet. In CHART_AROUND by its ends relative to
 * the eye in the chart's scales; otherwise by their pencil coordinates and reciprocal distances (any common scale). */
typedef struct edges_segment {
    pencil_t at[2];
    uint32_t g[2];
    int32_t x[2], y[2];
    int64_t z[2]; /* |z| < 2^60 */
} edges_segment_t;

/* Gives what is visible of it to sink, as pieces of family INK_CURVE with parameters in space, 0 to INK_GRID_ONE;
 * nothing is covered by it. Returns 0 or the sink's error. */
int edges_look_at(edges_t *e, const edges_segment_t *s, const ink_sink_t *sink);

/* Is the edge vertical in the chart? Such edges must be clipped before others that end in their vertices. */
bool edges_row_is_vertical(const edges_t *e, const chart_line_t *line, int32_t i);
bool edges_column_is_vertical(const edges_t *e, const chart_line_t *line, const chart_line_t *next, int32_t i);

/* CHART_AROUND: have both points coordinates, in one sector and one zone? Then a line between them is a line of the
 * chart. */
static inline bool edges_is_straight(pencil_t p, pencil_t q) {
    if (p.a == CHART_NONE || q.a == CHART_NONE) return false;
    const int32_t lo = pencil_min(p.a, q.a), hi = pencil_max(p.a, q.a);
    return (lo == hi || lo >> CHART_SECTOR_BITS == (hi - 1) >> CHART_SECTOR_BITS) &&
           chart_in_one_zone(pencil_min(p.w, q.w), pencil_max(p.w, q.w));
}

/* x + (y - x) * part / 2^30, |x|, |y| < 2^60: in two halves, so that each product fits. */
static inline int64_t edges_mix(int64_t x, int64_t y, int32_t part_q30) {
    const int64_t d = y - x;
    return x + (d >> 30) * part_q30 + (((d & (INK_ONE - 1)) * part_q30) >> 30);
}

/* Adds a whole visible edge that the horizons know already. */
static inline int edges_whole(edges_t *e, uint8_t family, int32_t line, int32_t cell, run_t *run) {
    e->clipped++;
    return runs_add(&e->runs, run, family, line, cell * INK_GRID_ONE, (cell + 1) * INK_GRID_ONE);
}

#endif
