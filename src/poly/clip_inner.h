/* clip_inner.h - what the parts of the clipper share (clip.h is the interface). */
#ifndef CLIP_INNER_H
#define CLIP_INNER_H

#include "poly/clip.h"

/* A waiting edge, from left to right; l == r only says that something ends at l. w is what it adds to the winding
 * numbers of subject and clip polygon on the way from below to above. */
typedef struct clip_seg {
    poly_point_t l, r;
    int16_t w[2];
    int32_t tag;
} clip_seg_t;

/* An edge of the graph. next is, for each result, the following edge of its contour: CLIP_NO_EDGE if this is no border
 * of it, and once traced CLIP_TRACED - the contour's number. */
typedef struct clip_edge {
    clip_seg_t s;
    int16_t above[2]; /* winding numbers above it */
    int32_t under;    /* an edge that bounds the same face from below, at its left end; -1: none */
    int32_t next[2];
} clip_edge_t;

/* Edges v[from] .. v[to] of the input that go through the sweep as one, their chord. */
typedef struct clip_stretch {
    int32_t from, to;
} clip_stretch_t;

/* Tags from here downwards: stretch[-1], stretch[-2], ... */
#define CLIP_STRETCH (-2)
#define CLIP_LAST INT32_MIN /* tag of a contour's first vertex when it comes again after its last */

#define CLIP_NO_EDGE (-1)
#define CLIP_TRACED (-2)

/* Which bit of a result's truth table is that of a place with these winding numbers? */
static inline unsigned clip_bit(const clip_t *c, const int16_t w[2]) {
    if (c->fill == CLIP_EVEN_ODD) return (unsigned)(w[0] & 1) | (unsigned)(w[1] & 1) << 1;
    return (w[0] ? 1u : 0) | (w[1] ? 2u : 0);
}
/* Is a place with these winding numbers in result k? */
static inline bool clip_is_in(const clip_t *c, int k, const int16_t w[2]) {
    return (unsigned)c->result[k] >> clip_bit(c, w) & 1;
}

static inline bool clip_is_in_above(const clip_t *c, int k, const clip_edge_t *e) {
    return clip_is_in(c, k, e->above);
}
static inline unsigned clip_bit_below(const clip_t *c, const clip_edge_t *e) {
    const int16_t w[2] = {(int16_t)(e->above[0] - e->s.w[0]), (int16_t)(e->above[1] - e->s.w[1])};
    return clip_bit(c, w);
}

/* One sweep over in, which is sorted by left ends: makes edge. Sets rounded, unsorted, full. */
void clip_sweep(clip_t *c);
/* Does the edge pass through the unit square around v, which lies in its box? */
bool clip_is_near(const clip_seg_t *s, poly_point_t v);
/* From left to right, whichever way it came out. */
clip_seg_t clip_upright(clip_seg_t s);
/* Draws steep falling edges of `in` to vertices near them in the columns of their ends. Sets full. */
void clip_snap_columns(clip_t *c);
/* Where two edges cross, rounded to the nearest lattice point: it lies in the boxes of both edges, whose corners are
 * lattice points, so a split never leaves a longer way than before. */
poly_point_t clip_crossing(const clip_seg_t *a, const clip_seg_t *b);
/* Splits the n sorted segments at the start of `in` where they cross. Returns how many there are then, at most half of
 * what fits, again sorted. */
int32_t clip_cross(clip_t *c, int32_t n);
static inline bool clip_in_range(poly_point_t a) {
    return a.x >= -POLY_LIMIT && a.x <= POLY_LIMIT && a.y >= -POLY_LIMIT && a.y <= POLY_LIMIT;
}

/* Writes the edges of both polygons to the start of mem, with chords for stretches of border that meet nothing; sets v,
 * stretch and stretches, and takes these off the bytes. Returns how many segments there are, or 0: not worth it, or
 * something is wrong. */
int32_t clip_find_stretches(clip_t *c, const clip_job_t *job, void *mem, size_t *bytes);
/* clip_run with that, if it is worth it, or without; so the two can be compared. */
int clip_run_by(clip_t *c, const clip_job_t *job, void *mem, size_t bytes, bool stretches);
static inline clip_stretch_t clip_stretch_of(const clip_t *c, const clip_seg_t *s) {
    return c->stretch[s->tag - CLIP_STRETCH - 1];
}
/* Sorts segments by their left ends. */
void clip_sort(clip_seg_t *s, int32_t n, clip_seg_t *spare);

#endif
