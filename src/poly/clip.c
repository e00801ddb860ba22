/* clip.c - see clip.h: memory, reading the polygons, and sweeps until nothing is rounded any more. */
#include "poly/clip_inner.h"

#include "error.h"
#include <string.h>

/* Of the memory, so much is for the status and for the heap: per 192 bytes (one edge, CLIP_BYTES) one entry each. */
#define STATUS_SHARE 48
#define HEAP_SHARE 8

/* Nearly parallel edges a unit apart, rounded only where they cross, may creep towards each other a few units a sweep.
 * If so many sweeps were not enough, edges are also drawn to vertices within half a unit, which lets them coincide. */
#define SWEEPS_WITHOUT_SNAP 2

/* Polygons with so many edges together may well have stretches of border that meet nothing. */
#define LARGE 1000

static int lay_out(clip_t *c, void *mem, size_t bytes) {
    if (bytes > INT32_MAX) bytes = INT32_MAX;
    size_t status = bytes / STATUS_SHARE / sizeof(int32_t), heap = bytes / HEAP_SHARE / sizeof(clip_seg_t);
    c->edge = mem;
    c->most_active = (int32_t)status;
    c->most_waiting = (int32_t)heap;
    size_t taken = status * sizeof(int32_t) + heap * sizeof(clip_seg_t);
    size_t left = (bytes - taken) / sizeof(clip_seg_t);
    if (left < 16) return ERR_FULL;
    c->in = mem;
    c->in_to = (int32_t)left;
    c->heap = c->in + left;
    c->status = (int32_t *)(void *)(c->heap + heap);
    return 0;
}

/* Writes the edges of one contour from seg[n] on. A vertex that is the right end of both its edges needs a segment of
 * no length to be met at all. Returns the new n or an error. */
static int32_t read_contour(const poly_vertex_t *v, int32_t vertices, int side, bool tagged, clip_seg_t *seg, int32_t n,
                            int32_t most) {
    int32_t first = n;
    bool was_forward = false, first_forward = false;
    poly_point_t first_at = {0, 0};
    for (int32_t i = 0; i < vertices; i++) {
        poly_point_t a = v[i].at, b = v[i + 1 < vertices ? i + 1 : 0].at;
        if (!clip_in_range(a)) return ERR_VALUE;
        if (poly_same(a, b)) continue;
        if (n + 2 >= most) return ERR_FULL;
        bool forward = poly_before(a, b);
        if (n == first) {
            first_forward = forward;
            first_at = a;
        } else if (was_forward && !forward) {
            seg[n++] = (clip_seg_t){.l = a, .r = a};
        }
        clip_seg_t *s = &seg[n++];
        *s = (clip_seg_t){.l = forward ? a : b, .r = forward ? b : a, .tag = tagged ? v[i].tag : POLY_CUT};
        s->w[side] = forward ? 1 : -1;
        was_forward = forward;
    }
    if (n > first && was_forward && !first_forward) seg[n++] = (clip_seg_t){.l = first_at, .r = first_at};
    return n;
}

/* All edges. Returns how many, or an error. */
static int32_t read_edges(clip_t *c, const clip_job_t *job) {
    int32_t n = 0, most = c->in_to / 2;
    for (int side = 0; side < 2; side++) {
        const poly_t *p = side ? &job->clip : &job->subject;
        int32_t from = 0;
        for (int32_t k = 0; k < p->contours; from = p->end[k++]) {
            n = read_contour(p->v + from, p->end[k] - from, side, !side || c->tagged, c->in, n, most);
            if (n < 0) return n;
        }
    }
    return n;
}

/* The last sweep's edges become the next one's input. From the last to the first: 24 bytes written at the end of the
 * memory are never before the 40 that are still to be read. */
static void again(clip_t *c) {
    int32_t to = c->in_to;
    for (int32_t k = c->edges; k-- > 0;) {
        clip_seg_t s = c->edge[k].s;
        c->in[--to] = s;
    }
    c->in_from = to;
    /* Nearly in order: only crossings that were rounded to before the sweep line are not. */
    for (int32_t k = to + 1; c->unsorted && k < c->in_to; k++) {
        clip_seg_t s = c->in[k];
        int32_t j = k;
        for (; j > to && poly_before(s.l, c->in[j - 1].l); j--) c->in[j] = c->in[j - 1];
        c->in[j] = s;
    }
    if (c->snap) clip_snap_columns(c);
}

/* The n segments at the start of `in`, split where they cross and sorted, go to the end of the memory; then sweeps. */
static int run(clip_t *c, int32_t n) {
    clip_sort(c->in, n, c->in + n);
    n = clip_cross(c, n);
    c->stats.sweeps = c->stats.crossings > 0; /* as good as one */
    c->in_from = c->in_to - n;
    memmove(c->in + c->in_from, c->in, (size_t)n * sizeof(clip_seg_t));
    for (;;) {
        c->snap = c->stats.sweeps >= SWEEPS_WITHOUT_SNAP;
        clip_sweep(c);
        c->stats.sweeps++;
        if (c->full) return ERR_FULL;
        if (!c->rounded) return 0;
        again(c);
        if (c->full) return ERR_FULL;
    }
}

static int run_by(clip_t *c, const clip_job_t *job, bool tagged, void *mem, size_t bytes, bool stretches) {
    *c = (clip_t){.fill = job->fill, .result = {job->result[0], job->result[1]}, .tagged = tagged};
    size_t left = bytes;
    int32_t n = stretches ? clip_find_stretches(c, job, mem, &left) : 0;
    if (n == 0) c->stretches = 0;
    int err = lay_out(c, mem, n > 0 ? left : bytes);
    if (err) return err;
    if (n == 0) n = read_edges(c, job);
    return n < 0 ? n : run(c, n);
}

int clip_run_by(clip_t *c, const clip_job_t *job, void *mem, size_t bytes, bool stretches) {
    return run_by(c, job, false, mem, bytes, stretches);
}

static bool is_large(const clip_job_t *job) {
    return poly_vertices(&job->subject) + poly_vertices(&job->clip) >= LARGE;
}

int clip_run(clip_t *c, const clip_job_t *job, void *mem, size_t bytes) {
    return run_by(c, job, false, mem, bytes, is_large(job));
}

int clip_run_tagged(clip_t *c, const clip_job_t *job, void *mem, size_t bytes) {
    return run_by(c, job, true, mem, bytes, is_large(job));
}
