/* area_wires.c - see area_wires.h. A line is cut where its picture crosses a polygon's border; between two crossings it
 * is inside or not, and where it is, depth decides. */
#include "hidden/area/area_wires.h"
#include "hidden/intervals.h"

#include "error.h"
#include "num/ints.h"
#include "scene/solid_math.h"

typedef struct wire {
    area_edge_t line;
    area_box_t box;
} wire_t;

/* How much farther away than a face a line is at its ends, and in between. */
typedef struct apart {
    wide_t at[2];
} apart_t;

static apart_t apart(const wire_t *w, const area_face_t *f) {
    apart_t a;
    for (int k = 0; k < 2; k++)
        a.at[k] = wide_sub(wide_from_s64(w->line.fine[k].z), area_plane_at_fine(&f->plane, &w->line.fine[k]));
    return a;
}

static int64_t behind(const apart_t *a, int32_t t_q30) {
    wide_t more = wide_times_s32(wide_sub(a->at[1], a->at[0]), t_q30);
    return area_limited(wide_add(a->at[0], wide_sar(more, 30)));
}

/* Where the line crosses the border, in order; those before and after it as its ends. Returns how many, or an error. */
static int32_t crossings(const wire_t *w, const poly_vertex_t *v, int32_t corners, int32_t *t, int32_t most) {
    int32_t n = 0;
    poly_point_t a = v[corners - 1].at;
    int64_t side_a = poly_orient(w->line.end[0], w->line.end[1], a);
    for (int32_t k = 0; k < corners; k++) {
        poly_point_t b = v[k].at;
        int64_t side_b = poly_orient(w->line.end[0], w->line.end[1], b);
        if ((side_a > 0) != (side_b > 0)) {
            int64_t p = poly_orient(a, b, w->line.end[0]) / 2, q = poly_orient(a, b, w->line.end[1]) / 2;
            int64_t at = p == q ? 0 : ints_muldiv_round(INK_ONE, p, p - q);
            if (n == most) return ERR_FULL;
            at = at < 0 ? 0 : at > INK_ONE ? INK_ONE : at;
            int32_t j = n++;
            for (; j > 0 && t[j - 1] > at; j--) t[j] = t[j - 1];
            t[j] = (int32_t)at;
        }
        a = b;
        side_a = side_b;
    }
    return n;
}

static int64_t depth(const wire_t *w, int32_t t_q30) {
    const area_fine_t *f = w->line.fine;
    return f[0].z + ints_muldiv_round(f[1].z - f[0].z, t_q30, INK_ONE);
}

/* Adds what the face hides between two crossings. */
static int hide(const area_lattice_t *l, const wire_t *w, const area_face_t *f, int32_t from, int32_t to,
                intervals_t *hidden) {
    const apart_t by = apart(w, f);
    const int64_t slack_from = area_slack(l, f, depth(w, from)), slack_to = area_slack(l, f, depth(w, to));
    const int64_t at_from = behind(&by, from), at_to = behind(&by, to);
    if (from >= to || (at_from <= slack_from && at_to <= slack_to)) return 0;
    if ((at_from > slack_from && at_to < -slack_to) || (at_from < -slack_from && at_to > slack_to)) {
        /* it goes through */
        int32_t middle = from + (int32_t)ints_muldiv_round(to - from, at_from, at_from - at_to);
        *(at_from > 0 ? &to : &from) = middle;
    }
    return intervals_add(hidden, 0, from, to);
}

typedef struct wire_use {
    const area_sink_t *sink;
    int32_t edge, shown; /* up to there the line is dealt with */
} wire_use_t;

static int32_t no_gap(void *ctx, int32_t line) {
    (void)ctx, (void)line;
    return 0;
}

static int show_up_to(void *ctx, const interval_t *hidden) {
    wire_use_t *u = ctx;
    int32_t from = u->shown;
    u->shown = hidden->to_q30;
    return from < hidden->from_q30 ? u->sink->wire(u->sink->ctx, u->edge, from, hidden->from_q30) : 0;
}

/* Memory for one line at a time. */
typedef struct wire_memory {
    intervals_t hidden;
    int32_t *t, most; /* crossings */
    uint8_t *scratch; /* a face */
    size_t scratch_bytes;
} wire_memory_t;

/* Of a line on a translucent face that is looked through: what is not on it is hidden. */
static int hide_beside(const area_lattice_t *l, const wire_t *w, int32_t face, wire_memory_t *m) {
    const solid_face_t *f = &l->m->solid->face[face];
    const int32_t most = AREA_CORNERS(l->clips, f->n);
    const size_t corners = ((size_t)most * sizeof(poly_vertex_t) + 7) & ~(size_t)7;
    if (m->scratch_bytes < corners + AREA_SCRATCH(l->clips, f->n)) return ERR_FULL;
    poly_vertex_t *v = (poly_vertex_t *)(void *)m->scratch;
    int32_t n = area_face_place(l, f, NULL, v, (area_corner_t *)(void *)(m->scratch + corners), most);
    if (n > 0) n = crossings(w, v, n, m->t, m->most);
    int32_t from = 0;
    for (int32_t k = 0; k + 1 < n; k += 2) {
        int err = from < m->t[k] ? intervals_add(&m->hidden, 0, from, m->t[k]) : 0;
        if (err) return err;
        from = m->t[k + 1];
    }
    if (n < 0) return n;
    return from < INK_ONE ? intervals_add(&m->hidden, 0, from, (int32_t)INK_ONE) : 0;
}

/* on: the face that it is drawn on, or -1. */
static int draw(const area_faces_t *faces, int32_t edge, int32_t on, wire_memory_t *m, const area_sink_t *sink) {
    wire_t w;
    if (!area_edge(&faces->lattice, edge, &w.line)) return 0;
    const poly_vertex_t ends[2] = {{w.line.end[0], 0}, {w.line.end[1], 0}};
    w.box = area_box_of(ends, 2);
    /* A box without a width meets others all the same, and one whose border it lies on: it may be inside. */
    w.box.x0--, w.box.y0--, w.box.x1++, w.box.y1++;
    m->hidden.n = 0;
    if (on >= 0) {
        int err = hide_beside(&faces->lattice, &w, on, m);
        if (err) return err;
    }
    for (int32_t k = 0; k < faces->n + faces->parts; k++) {
        const area_face_t *f = &faces->face[k];
        if (f->body || !area_boxes_meet(&f->box, &w.box)) continue;
        int32_t n = crossings(&w, faces->vertex + f->first, f->n, m->t, m->most);
        if (n < 0) return n;
        for (int32_t i = 0; i + 1 < n; i += 2) {
            int err = hide(&faces->lattice, &w, f, m->t[i], m->t[i + 1], &m->hidden);
            if (err) return err;
        }
    }
    wire_use_t use = {sink, edge, 0};
    const interval_use_t each = {&use, no_gap, show_up_to};
    int err = intervals_finish(&m->hidden, &each);
    const interval_t end = {0, (int32_t)INK_ONE, (int32_t)INK_ONE};
    return err ? err : show_up_to(&use, &end);
}

/* Is a face that is turned away the other side of one that is seen edge-on, and so seen edge-on itself? */
static bool is_edge_on(const solid_t *s, int32_t face, int32_t edge, const uint8_t *state) {
    for (int32_t e = edge; e >= 0; e = s->edge[e].twin)
        for (int side = 0; side < 2; side++) {
            const int32_t other = s->edge[e].face[side];
            if (other >= 0 && state[other] == AREA_LEFT_OUT && solid_face_lies_in(s, face, other)) return true;
        }
    return false;
}

/* Who answers for an edge: a polygon, or one on the far side of a body; nobody; polygons that end in it roughly. */
enum { POLYGONS, NOBODY, ROUGHLY };
static int who_answers_for(const solid_t *s, int32_t edge, const uint8_t *state) {
    int who = NOBODY;
    for (int32_t e = edge; e >= 0; e = s->edge[e].twin)
        for (int side = 0; side < 2; side++) {
            const int32_t face = s->edge[e].face[side];
            if (face < 0) continue;
            if (state[face] == AREA_ROUGH) return ROUGHLY;
            if (state[face] == AREA_LEFT_OUT || who == POLYGONS) continue;
            if (state[face] != AREA_TURNED_AWAY || !is_edge_on(s, face, edge, state)) who = POLYGONS;
        }
    return who;
}

int area_wires(const area_faces_t *faces, const uint8_t *state, void *mem, size_t bytes, const area_sink_t *sink) {
    const solid_t *s = faces->lattice.m->solid;
    wire_memory_t m;
    const size_t third = bytes / 3 & ~(size_t)7;
    intervals_init(&m.hidden, mem, third);
    m.t = (int32_t *)(void *)((uint8_t *)mem + third);
    m.most = (int32_t)(third / sizeof *m.t);
    m.scratch = (uint8_t *)mem + 2 * third;
    m.scratch_bytes = third;
    for (int32_t e = 0; e < s->ne; e++) {
        if (s->edge[e].first != e || solid_is_cut(s, &s->edge[e])) continue;
        const int who = who_answers_for(s, e, state);
        if (who == POLYGONS || (who == ROUGHLY && !sink->again)) continue;
        if (who == ROUGHLY) sink->again(sink->ctx, e);
        int err = draw(faces, e, -1, &m, sink);
        if (err) return err;
    }
    for (int32_t e = s->ne; e < s->ne + s->nd && faces->lattice.m->through; e++) {
        int err = solid_is_clear(s, s->edge[e].face[0]) ? draw(faces, e, s->edge[e].face[0], &m, sink) : 0;
        if (err) return err;
    }
    return 0;
}
