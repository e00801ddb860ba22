/* halo_ink.h - haloed lines of a scene: its edges onto the page for halo.h, and what is visible of them back as ink.
 *
 * Edges are cut to the paper and a halo's width beyond, and off what is behind the eye. Depth is, in a parallel view,
 * what the source says; in perspective 1 / E, scaled so that the nearest point left has HALO_INK_DEPTH: it is the
 * reciprocal that is linear along the picture of a line. */
#ifndef HALO_INK_H
#define HALO_INK_H

#include "hidden/hidden.h"
#include "view/line_space.h"

#define HALO_INK_DEPTH (1 << 24) /* as many units of depth as a page has lat, more or less */

/* Where edges come from. */
typedef struct halo_source {
    void *ctx;
    int32_t edges;             /* numbers 0 .. edges - 1 are asked for, several times each */
    const line_space_t *lines; /* of each surface; all of one window and one kind of view */
    int32_t surfaces;
    /* Edge e: all of it as ink (one cell of a line), its ends on the page, and in a parallel view their depth: greater
     * is nearer, |depth| <= HALO_INK_DEPTH. False if there is no such edge. */
    bool (*edge)(void *ctx, int32_t e, ink_piece_t *ink, page_h_t end[2], int32_t depth[2]);
} halo_source_t;

/* Draws all edges into job->sink, with haloes of `width` lat to either side; ends: see halo_cut. Returns 0, the sink's
 * error, or ERR_FULL when job's memory does not suffice: before the first piece, and stats->edges and stats->crossings
 * then say what there is, and stats->bytes what it takes at least; exactly, unless not even the edges fitted and
 * stats->crossings is 0. */
int halo_ink_draw(const halo_source_t *source, int32_t width, bool ends, const hidden_job_t *job,
                  hidden_stats_t *stats);
/* About the memory it would take with as many crossings as there are usually: one for two edges that are
 * loose or of several bodies, and within a body, whose back shows through, as many as its edges times a fifth of the
 * root of that. */
size_t halo_ink_needs(int32_t edges, int32_t loose, int32_t bodies);

#endif
