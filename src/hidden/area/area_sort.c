/* area_sort.c - see area.h: the sort itself, in one window. */
#include "hidden/area/area_sort.h"
#include "hidden/area/area_weld.h"

#include "error.h"
#include "num/ints.h"

int32_t area_half_of(const area_box_t *box, const area_plane_t *plane, poly_vertex_t v[8]) {
    const poly_point_t corner[4] = {{box->x0, box->y0}, {box->x1, box->y0}, {box->x1, box->y1}, {box->x0, box->y1}};
    int64_t at[4];
    int32_t n = 0;
    area_plane_at_four(plane, corner, at);
    for (int k = 0; k < 4; k++) {
        poly_point_t p = corner[k], q = corner[(k + 1) % 4];
        int64_t at_p = at[k], at_q = at[(k + 1) % 4];
        if (at_p > 0) v[n++] = (poly_vertex_t){p, POLY_CUT};
        if ((at_p > 0) == (at_q > 0)) continue;
        p.x += (int32_t)ints_muldiv_round((int64_t)q.x - p.x, at_p, at_p - at_q);
        p.y += (int32_t)ints_muldiv_round((int64_t)q.y - p.y, at_p, at_p - at_q);
        v[n++] = (poly_vertex_t){p, POLY_CUT};
    }
    return n;
}

/* Of a piece that cuts through face `by` what is in front of it is put on the list. */
static int cut_through(area_t *a, int32_t piece, int32_t by, area_list_t *in) {
    int32_t face = a->pool.piece[piece].face;
    const area_plane_t apart = area_plane_minus(&a->faces.face[by].plane, &a->faces.face[face].plane);
    poly_vertex_t v[8];
    const int32_t end = area_half_of(&a->pool.piece[piece].box, &apart, v);
    const clip_job_t job = {area_pool_poly(&a->pool, piece), {v, &end, 1}, CLIP_EVEN_ODD, {CLIP_INSIDE, CLIP_NOTHING}};
    area_list_t parts;
    a->stats->intersections++;
    int err = clip_run(&a->clip, &job, a->clip_mem, a->clip_bytes);
    if (!err) err = area_pool_parts(&a->pool, face, &a->clip, 0, &parts);
    for (int32_t k = err ? AREA_NONE : parts.first, next; k != AREA_NONE; k = next) {
        next = a->pool.piece[k].next;
        area_list_add(&a->pool, in, k);
    }
    area_pool_drop(&a->pool, piece);
    return err;
}

/* Clips a piece by face `by`: what is inside and not behind goes to *in, what is outside to *out. */
static int clip_piece(area_t *a, int32_t piece, int32_t by, area_list_t *in, area_list_t *out) {
    area_pool_t *pool = &a->pool;
    int32_t face = pool->piece[piece].face;
    const area_face_t *f = &a->faces.face[by];
    const poly_t whole = {a->faces.vertex + f->first, &f->n, 1}, subject = area_pool_poly(pool, piece);
    area_weld_t w;
    size_t used;
    if (area_apart(&subject, &whole)) {
        area_list_add(pool, out, piece);
        return 0;
    }
    int err = area_weld(&w, &subject, &pool->piece[piece].box, &whole, &f->box, a->clip_mem, a->clip_bytes, &used);
    if (err) return err;
    if (w.changed && f->sharp) area_roughen(a, f);
    if (w.changed && a->faces.face[face].sharp) area_roughen(a, &a->faces.face[face]);
    const clip_job_t job = {w.subject, w.clip, CLIP_EVEN_ODD, {CLIP_INSIDE, CLIP_OUTSIDE}};
    err = clip_run(&a->clip, &job, (uint8_t *)a->clip_mem + used, a->clip_bytes - used);
    if (err) return err;
    a->stats->clips++;
    /* Where rounding made something collapse, what is left is the result; otherwise the piece stays as it was. */
    bool exact = a->clip.stats.crossings == 0 && a->clip.stats.sweeps == 1 && !w.changed;
    if (exact && clip_count(&a->clip, 0) == 0) { /* wholly outside */
        area_list_add(pool, out, piece);
        return 0;
    }
    /* Outside, parts are apart because each meets fewer clip polygons than all of them do. */
    area_list_t parts, outside;
    err = area_pool_parts(pool, face, &a->clip, 1, &outside);
    if (!err) err = area_pool_parts(pool, face, &a->clip, 0, &parts);
    if (err) return err;
    bool same =
        exact && outside.first == AREA_NONE && parts.first == parts.last; /* wholly inside, with its own vertices */
    for (int32_t k = outside.first, next; k != AREA_NONE; k = next) {
        next = pool->piece[k].next;
        area_list_add(pool, out, k);
    }
    for (int32_t k = parts.first, next; k != AREA_NONE; k = next) {
        next = pool->piece[k].next;
        const poly_t p = area_pool_poly(pool, k);
        int where = area_compare(a, &p, face, by);
        if (where == AREA_BEHIND) {
            a->stats->removed++;
            same = false;
            area_pool_drop(pool, k);
            continue;
        }
        a->stats->errors += !a->faces.face[face].on_stack;
        same = same && where != AREA_THROUGH;
        if (where == AREA_THROUGH) {
            err = cut_through(a, k, by, in);
            if (err) return err;
        } else if (same)
            area_pool_drop(pool, k);
        else
            area_list_add(pool, in, k);
    }
    if (same)
        area_list_add(pool, in, piece);
    else
        area_pool_drop(pool, piece);
    return 0;
}

static int clip_list(area_t *a, area_list_t list, int32_t by, area_list_t *in, area_list_t *out) {
    *in = *out = (area_list_t){AREA_NONE, AREA_NONE};
    for (int32_t k = list.first, next; k != AREA_NONE; k = next) {
        const area_piece_t *p = &a->pool.piece[k];
        next = p->next;
        a->stats->lateral++;
        if (p->face == by) {
            area_list_add(&a->pool, in, k);
        } else if (!area_boxes_meet(&p->box, &a->faces.face[by].box)) {
            area_list_add(&a->pool, out, k);
        } else {
            int err = clip_piece(a, k, by, in, out);
            if (err) return err;
        }
    }
    return 0;
}

/* The first polygon of a list that does not clip this area already, or AREA_NONE. */
static int32_t next_clip(const area_t *a, area_list_t list) {
    for (int32_t k = list.first; k != AREA_NONE; k = a->pool.piece[k].next)
        if (!a->faces.face[a->pool.piece[k].face].on_stack) return a->pool.piece[k].face;
    return AREA_NONE;
}

int area_sort_list(area_t *a, area_list_t list) {
    a->depth = 0;
    for (;;) {
        int32_t by = next_clip(a, list);
        int err = 0;
        if (by != AREA_NONE) {
            area_list_t in, out;
            err = clip_list(a, list, by, &in, &out);
            if (err) return err;
            a->stack[a->depth].outside = out;
            a->stack[a->depth++].face = by;
            if (a->depth > a->stats->depth) a->stats->depth = a->depth;
            a->faces.face[by].on_stack = true;
            list = in;
            continue;
        }
        err = area_show(a, list);
        if (err) return err;
        if (a->depth == 0) return 0;
        list = a->stack[--a->depth].outside;
        a->faces.face[a->stack[a->depth].face].on_stack = false;
    }
}
