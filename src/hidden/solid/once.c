/* once.c - see once.h: what is kept of groups, united along their lines. Groups are found in once_build.c. */
#include "hidden/solid/once.h"

#include "error.h"
#include "hidden/line_class.h"
#include "num/heap_sort.h"

#define SLIVER_LAT (2 * ONCE_FLAT_LAT) /* what is left over and no longer than this is no ink */

static bool page_at(const once_t *o, const ink_piece_t *p, int64_t t_q30, page_h_t *h, page_point_t *at) {
    const line_space_t *s = &o->map->lines;
    if (!s->at(s->ctx, p->family, p->line, t_q30, h) || h->e <= 0) return false;
    *at = line_space_divide(s, h);
    return true;
}

static int32_t along(const page_point_t *p, int32_t group) {
    return group & 1 ? p->y_lat : p->x_lat;
}

/* Keeps a piece of an edge in a group, or hands it on. */
static int take(once_t *o, const ink_piece_t *p, bool hidden) {
    const ink_sink_t *next = hidden ? &o->dashed : &o->seen;
    page_h_t h;
    page_point_t a, b;
    if (p->family != INK_SEGMENT || p->surface > LINE_HIDDEN || o->group[p->line] < 0 ||
        !page_at(o, p, p->from, &h, &a) || !page_at(o, p, p->to, &h, &b))
        return next->piece(next->ctx, p);
    if (o->n == o->n_max) return ERR_FULL;
    const enum once_rank rank = hidden ? ONCE_HIDDEN : p->surface == LINE_SILHOUETTE ? ONCE_SILHOUETTE : ONCE_CREASE;
    o->surface[rank] = p->surface;
    const int32_t group = o->group[p->line], u = along(&a, group), v = along(&b, group);
    once_piece_t *piece = &o->piece[o->n++];
    *piece = (once_piece_t){.rank = 4 * group + (int32_t)rank, .u0 = u < v ? u : v, .u1 = u < v ? v : u};
    piece->edge = p->line;
    piece->from_q30 = (int32_t)p->from;
    piece->to_q30 = (int32_t)p->to;
    return 0;
}

static int take_seen(void *ctx, const ink_piece_t *p) {
    return take(ctx, p, false);
}
static int take_hidden(void *ctx, const ink_piece_t *p) {
    return take(ctx, p, true);
}

ink_sink_t once_seen(once_t *o, ink_sink_t next) {
    o->seen = next;
    return o->group ? (ink_sink_t){o, take_seen} : next;
}
ink_sink_t once_dashed(once_t *o, ink_sink_t dashes) {
    o->dashed = dashes;
    return o->group ? (ink_sink_t){o, take_hidden} : dashes;
}

/* By line and rank, from one end to the other, long before short; the rest for a definite order. */
static bool is_before(const once_piece_t *a, const once_piece_t *b) {
    if (a->rank != b->rank) return a->rank < b->rank;
    if (a->u0 != b->u0) return a->u0 < b->u0;
    if (a->u1 != b->u1) return a->u1 > b->u1;
    return a->edge < b->edge;
}

HEAP_SORT(once_piece_t, is_before)

/* Emits what of a piece lies in u0..u1 of its line. */
static int emit(const once_t *o, const once_piece_t *p, int32_t u0, int32_t u1) {
    if (u1 - u0 <= SLIVER_LAT && (u0 > p->u0 || u1 < p->u1)) return 0;
    const enum once_rank rank = p->rank & 3;
    const ink_sink_t *sink = rank == ONCE_HIDDEN ? &o->dashed : &o->seen;
    ink_piece_t ink = {INK_SEGMENT, o->surface[rank], p->edge, p->from_q30, p->to_q30};
    page_h_t h[2];
    page_point_t a, b;
    if (!page_at(o, &ink, p->from_q30, &h[0], &a) || !page_at(o, &ink, p->to_q30, &h[1], &b)) return 0;
    if (!o->map->lines.perspective) h[0].e = h[1].e = 256;
    const bool up = along(&a, p->rank >> 2) <= along(&b, p->rank >> 2);
    const int64_t way = (int64_t)p->u1 - p->u0;
    for (int k = 0; k < 2; k++) {
        const int32_t u = k ? u1 : u0;
        if (u == (k ? p->u1 : p->u0)) continue;
        const int64_t done = up ? (int64_t)u - p->u0 : (int64_t)p->u1 - u;
        const int64_t all = (int64_t)p->to_q30 - p->from_q30;
        const int64_t t = p->from_q30 + line_space_share(done, way - done, h[0].e, h[1].e, all);
        *((k == 0) == up ? &ink.from : &ink.to) = t;
    }
    if (ink.from >= ink.to) return 0;
    return sink->piece(sink->ctx, &ink);
}

/* What of a rank's pieces lies beyond those before them and beside what is drawn: n intervals, in order and apart. */
static int draw_rank(const once_t *o, const once_piece_t *p, int32_t count, const once_piece_t *drawn, int32_t n) {
    int32_t done = INT32_MIN / 2, at = 0;
    for (int32_t k = 0; k < count; k++) {
        if (p[k].u1 <= done) continue;
        int32_t from = p[k].u0 > done - ONCE_FLAT_LAT ? p[k].u0 : done;
        while (at < n && drawn[at].u1 <= from) at++;
        for (int32_t i = at; i < n && drawn[i].u0 < p[k].u1; i++) {
            int err = drawn[i].u0 > from ? emit(o, &p[k], from, drawn[i].u0) : 0;
            if (err) return err;
            if (drawn[i].u1 > from) from = drawn[i].u1;
        }
        int err = from < p[k].u1 ? emit(o, &p[k], from, p[k].u1) : 0;
        if (err) return err;
        done = p[k].u1;
    }
    return 0;
}

/* Intervals become one rank, in order and apart; how many there are then. */
static int32_t unite(once_piece_t *p, int32_t count) {
    int32_t n = 0;
    for (int32_t k = 0; k < count; k++) p[k].rank = 0;
    heap_sort(p, count);
    for (int32_t k = 0; k < count; k++) {
        if (n > 0 && p[k].u0 <= p[n - 1].u1) {
            if (p[k].u1 > p[n - 1].u1) p[n - 1].u1 = p[k].u1;
        } else {
            p[n++] = p[k];
        }
    }
    return n;
}

int once_finish(once_t *o) {
    int err = 0;
    heap_sort(o->piece, o->n);
    for (int32_t k = 0; k < o->n && !err;) {
        const int32_t group = o->piece[k].rank >> 2;
        once_piece_t *drawn = &o->piece[k]; /* what is drawn already, in the place of its pieces */
        int32_t n = 0;
        while (k < o->n && o->piece[k].rank >> 2 == group && !err) {
            once_piece_t *p = &o->piece[k];
            int32_t count = 1;
            while (k + count < o->n && p[count].rank == p->rank) count++;
            err = draw_rank(o, p, count, drawn, n);
            for (int32_t i = 0; i < count; i++) drawn[n++] = p[i];
            n = unite(drawn, n);
            k += count;
        }
    }
    o->n = 0;
    return err;
}
