/* sweep.h - facets in occlusion-compatible order, two rows of the grid at a time (Anderson's section 4).
 *
 *      . . . . . . .      Rows outward from the eye's cell E, first up, then down; in a row columns outward,
 *      . 5 4 3 6 7 .      first right, then left. That single pair of loops is right for every position of the
 *      . . . 2 . . .      eye, above, beside, or in a grid plane.
 *      . . . E 1 . .
 *
 * What is done with a row of facets is the caller's: perimeter.c keeps two horizons, holes.c also the windows between
 * them, cells.c does so for several surfaces. */
#ifndef SWEEP_H
#define SWEEP_H

#include "config.h"
#include "hidden/hidden.h"
#include "hidden/surface/edges.h"

/* What became of a facet's far edges: both wholly above the upper horizon, below the lower one, both hidden, or
 * something else. */
enum facet_kind { FACET_CUT, FACET_ABOVE, FACET_BELOW, FACET_HIDDEN };

/* One surface in the sweep. */
typedef struct layer {
    grid_t *grid;
    uint8_t surface;
    int8_t seen;          /* chart_seen */
    chart_line_t line[2]; /* [0] has the smaller j */
    run_t *column_run;    /* one per column */
    run_t row_run[2];     /* of line[0] and line[1] */
    /* Only with windows: which edges have been clipped, of line[0] and line[1], of the columns between them, and of the
     * eye's row, for the way down. */
    uint8_t *row_done[2], *column_done, *kept_done;
    outline_line_t *outline; /* of the facet at hand: OUTLINE_LINES, or its edges where each is one line */
    int32_t lines;
    bool present;         /* it has a facet in the cell at hand */
    windows_span_t *span; /* several surfaces: of that facet */
    int32_t spans;
    int8_t below;              /* seen, if the facet may touch the point right below the eye */
    uint8_t near_new, far_new; /* of its sides: bit k for side k (sides.h) */
} layer_t;

typedef struct sweep {
    edges_t edges;
    layer_t *layer;
    int32_t layers;
    enum facet_kind last; /* of the corner facet before */
    shade_t *shade;       /* what other surfaces hide of a vertical edge: two for each */
    int32_t from, to, of; /* the strip at hand: of is 1, or HIDDEN_STRIPS */
#if CONFIG_AREA
    struct shaded *shaded; /* hatches visible facets, or NULL (shaded.h) */
#endif
    const hidden_pause_t *pause;
    int64_t facets;
    int32_t rows; /* of facets that are done */
    size_t fixed; /* bytes of lent memory before the horizons */
} sweep_t;

/* Sweeps a row of facets between each layer's line[0] and line[1]; `far` is the line away from the eye, fresh: the row
 * is the eye's own, none of its lines has been swept. */
typedef int (*sweep_row_t)(sweep_t *s, int far, bool fresh);

/* Memory for `layers` surfaces of nx columns, without horizons, at most; windows: for them or for several. */
size_t sweep_bytes(int32_t nx, int32_t layers, bool windows);

/* Prepares a sweep over n surfaces on the same points (x, y) in job's memory.
 * s->from, to and of tell which strip it is for in COVER_STRIP. Returns 0 or ERR_FULL. */
int sweep_init(sweep_t *s, grid_t *const grid[], int32_t n, const camera_t *cam, const hidden_job_t *job,
               enum edges_cover cover);

/* The whole sweep. Returns 0 or the first error of row or the sink. */
int sweep_all(sweep_t *s, const hidden_job_t *job, sweep_row_t row);

/* About what it would have taken of job's memory, after ERR_FULL. */
size_t sweep_needs(const sweep_t *s, const grid_t *g, const hidden_job_t *job, int32_t layers);

/* Adds what the sweep took to stats, zero before the first sweep; evaluated is the caller's. */
void sweep_account(const sweep_t *s, hidden_stats_t *stats);

#if CONFIG_AREA
struct shaded;
struct sweep;
int shaded_facet(struct shaded *s, struct sweep *sweep, const layer_t *l, int32_t i);
#endif

/* A facet's turn comes: before its edges cover. Returns 0 or an error. */
static inline int sweep_shade(sweep_t *s, const layer_t *l, int32_t i) {
#if CONFIG_AREA
    if (s->shaded != NULL) return shaded_facet(s->shaded, s, l, i);
#endif
    (void)l, (void)i;
    return hidden_pause(s->pause);
}

/* An edge of a layer. */
static inline int sweep_column_edge(sweep_t *s, layer_t *l, int32_t i) {
    return edges_column(&s->edges, &l->line[0], &l->line[1], i, &l->column_run[i]);
}
static inline int sweep_row_edge(sweep_t *s, layer_t *l, int which, int32_t i) {
    return edges_row(&s->edges, &l->line[which], i, &l->row_run[which]);
}

#endif
