/* area_show.c - see area_sort.h: what was found to be visible, on its way to the sink. */
#include "hidden/area/area_body.h"
#include "hidden/area/area_sort.h"
#include "hidden/area/area_weld.h"

#include "num/ints.h"

/* Takes a visible polygon out of what is open. */
static int cover(area_t *a, const poly_t *p) {
    const clip_job_t job = {*a->open, *p, CLIP_EVEN_ODD, {CLIP_OUTSIDE, CLIP_NOTHING}};
    int err = clip_run(&a->clip, &job, a->clip_mem, a->clip_bytes);
    if (err) return err;
    a->which = !a->which;
    clip_out_t *to = &a->store[a->which];
    to->n = to->contours = 0;
    err = clip_trace(&a->clip, 0, to);
    *a->open = (poly_t){to->v, to->end, to->contours};
    return err;
}

static bool is_within(poly_point_t a, poly_point_t b, int32_t units) {
    return ints_abs64((int64_t)a.x - b.x) <= (uint64_t)units && ints_abs64((int64_t)a.y - b.y) <= (uint64_t)units;
}

/* The vertex before or after k (step -1 or 1) of a contour of n that is not next to it; k if there is none. */
static int32_t beside(const poly_vertex_t *v, int32_t n, int32_t k, int32_t step) {
    int32_t at = k;
    do at = at + step < 0 ? n - 1 : at + step == n ? 0 : at + step;
    while (at != k && is_within(v[at].at, v[k].at, AREA_THIN));
    return at;
}

static bool is_along_side(const area_box_t *w, poly_point_t a, poly_point_t b) {
    return (a.x == b.x && (a.x == w->x0 || a.x == w->x1)) || (a.y == b.y && (a.y == w->y0 || a.y == w->y1));
}

/* Does a polygon end somewhere in a strip that is no wider than what rounding and welds make of nothing, for a tenth of
 * a step? What hides the strip is as narrow there, and may have been lost: if it was cut by more than the window. */
static bool ends_narrowly(const poly_t *p, const area_box_t *window) {
    bool cut = false, narrow = false;
    for (int32_t c = 0, first = 0; c < p->contours; first = p->end[c++]) {
        const poly_vertex_t *v = p->v + first;
        const int32_t n = p->end[c] - first;
        for (int32_t k = 0; k < n; k++) {
            const poly_point_t at = v[k].at, next = v[k + 1 < n ? k + 1 : 0].at;
            cut |= v[k].tag < 0 && !is_along_side(window, at, next);
            if (narrow) continue;
            const poly_point_t a = v[beside(v, n, k, -1)].at, b = v[beside(v, n, k, 1)].at;
            narrow = area_is_sharp(a, at, b) && !is_within(a, at, AREA_TENTH_OF_A_STEP) &&
                     !is_within(b, at, AREA_TENTH_OF_A_STEP) && !is_along_side(window, a, at) &&
                     !is_along_side(window, at, b);
        }
    }
    return cut && narrow;
}

/* Of a face that was cut a part, or the whole of one. */
static int give(area_t *a, int32_t face, const poly_t *p) {
    if (p->v != a->faces.vertex + a->faces.face[face].first && ends_narrowly(p, &a->window))
        area_roughen(a, &a->faces.face[face]);
    a->stats->visible++;
    const int err = a->sink->polygon(a->sink->ctx, a->faces.face[face].face, p);
    a->sink_failed |= err != 0;
    return err;
}

/* Does a border of p that is not one of the silhouette's come so near to a box that a weld might move it there? */
#define NEAR_CUT 16
static bool is_cut_near(const poly_t *p, const area_box_t *box) {
    for (int32_t c = 0, first = 0; c < p->contours; first = p->end[c++])
        for (int32_t k = first; k < p->end[c]; k++) {
            const poly_point_t a = p->v[k].at, b = p->v[k + 1 < p->end[c] ? k + 1 : first].at;
            if (p->v[k].tag < 0 && (a.x < b.x ? b.x : a.x) + NEAR_CUT >= box->x0 &&
                (a.x < b.x ? a.x : b.x) - NEAR_CUT <= box->x1 && (a.y < b.y ? b.y : a.y) + NEAR_CUT >= box->y0 &&
                (a.y < b.y ? a.y : b.y) - NEAR_CUT <= box->y1)
                return true;
        }
    return false;
}

/* Even-odd. */
static bool is_in(const poly_t *p, poly_point_t at) {
    bool in = false;
    for (int32_t c = 0, first = 0; c < p->contours; first = p->end[c++]) {
        poly_point_t a = p->v[p->end[c] - 1].at;
        for (int32_t k = first; k < p->end[c]; k++) {
            const poly_point_t b = p->v[k].at;
            if ((a.y > at.y) != (b.y > at.y) && (poly_orient(a, b, at) > 0) == (b.y > a.y)) in = !in;
            a = b;
        }
    }
    return in;
}

/* The mean of a convex polygon's corners. */
static poly_point_t middle_of(const poly_vertex_t *v, int32_t n) {
    int64_t x = 0, y = 0;
    for (int32_t k = 0; k < n; k++) x += v[k].at.x, y += v[k].at.y;
    return (poly_point_t){(int32_t)(x / n), (int32_t)(y / n)};
}

/* Of part k of a body what is in a piece of its silhouette. */
static int show_part(area_t *a, int32_t piece, int32_t k) {
    const area_face_t *f = &a->faces.face[k];
    const poly_t whole = {a->faces.vertex + f->first, &f->n, 1}, by = area_pool_poly(&a->pool, piece);
    const area_box_t *box = &a->pool.piece[piece].box;
    area_weld_t w;
    size_t used;
    if (a->pool.piece[piece].block == AREA_NONE) return give(a, k, &whole);
    if (!area_boxes_meet(&f->box, box)) return 0;
    if (!is_cut_near(&by, &f->box)) return is_in(&by, middle_of(whole.v, f->n)) ? give(a, k, &whole) : 0;
    if (area_apart(&whole, &by)) return 0;
    int err = area_weld(&w, &whole, &f->box, &by, box, a->clip_mem, a->clip_bytes, &used);
    if (err) return err;
    if (w.changed && f->sharp) area_roughen(a, f);
    const clip_job_t job = {w.subject, w.clip, CLIP_EVEN_ODD, {CLIP_INSIDE, CLIP_NOTHING}};
    /* where both have an edge of the body, rounding may have put the silhouette's a hair inside of the face's */
    err = clip_run_tagged(&a->clip, &job, (uint8_t *)a->clip_mem + used, a->clip_bytes - used);
    const int32_t seen = err ? AREA_NONE : area_pool_clipped(&a->pool, k, &a->clip, 0, &err);
    if (seen == AREA_NONE) return err;
    const poly_t p = area_pool_poly(&a->pool, seen);
    err = give(a, k, &p);
    area_pool_drop(&a->pool, seen);
    return err;
}

static int show_body(area_t *a, int32_t piece) {
    int32_t from, to;
    area_body_parts(&a->faces, a->pool.piece[piece].face, &from, &to);
    for (int32_t k = from; k < to; k++) {
        const int err = show_part(a, piece, k);
        if (err) return err;
    }
    return 0;
}

int area_show(area_t *a, area_list_t list) {
    for (int32_t k = list.first, next; k != AREA_NONE; k = next) {
        next = a->pool.piece[k].next;
        const int32_t face = a->pool.piece[k].face;
        poly_t p = area_pool_poly(&a->pool, k);
        int err = a->faces.face[face].body ? show_body(a, k) : give(a, face, &p);
        if (err) return err;
        if (a->open) {
            p = area_pool_poly(&a->pool, k); /* parts of a body may have moved it */
            err = cover(a, &p);
            if (err) return err;
        }
        area_pool_drop(&a->pool, k);
    }
    return 0;
}
