/* area_mover.c - see area_mover.h. */
#include "hidden/area/area_mover.h"
#include "hidden/area/area_face.h"

#include "config.h"
#include "num/ints.h"

#if CONFIG_AREA

bool area_mover(area_mover_t *mv, const area_lattice_t *from, const solid_map_t *to, int32_t face) {
    const solid_face_t *f = &to->solid->face[face];
    const int32_t *corner = to->solid->corner + f->corner;
    mv->face = face;
    mv->from_view = from;
    mv->to_view = to;
    /* The three corners that span the face widest, seen from the light. */
    int32_t at[3] = {0, 0, 0};
    uint64_t far = 0, wide = 0;
    for (int k = 0; k < 3; k++) mv->at[k] = area_vertex(from, corner[0]);
    for (int32_t k = 1; k < f->n; k++) {
        poly_point_t p = area_vertex(from, corner[k]);
        int64_t dx = p.x - mv->at[0].x, dy = p.y - mv->at[0].y;
        uint64_t d = (uint64_t)(dx * dx + dy * dy);
        if (d > far) far = d, at[1] = k, mv->at[1] = p;
    }
    if (far == 0) return false;
    for (int32_t k = 1; k < f->n; k++) {
        poly_point_t p = area_vertex(from, corner[k]);
        uint64_t d = ints_abs64(poly_orient(mv->at[0], mv->at[1], p));
        if (d > wide) wide = d, at[2] = k, mv->at[2] = p;
    }
    mv->whole = poly_orient(mv->at[0], mv->at[1], mv->at[2]);
    for (int k = 0; k < 3; k++) {
        mv->from[k] = solid_map_vertex(from->m, corner[at[k]]);
        mv->to[k] = solid_map_vertex(to, corner[at[k]]);
    }
    return mv->whole != 0;
}

/* A share of a difference; far outside of a face it may be anything, but stays summable. */
static int64_t share_of(int64_t a, int64_t p, int64_t whole) {
    int64_t most = (int64_t)1 << 61, part = ints_muldiv_round(p, a, whole);
    return part < -most ? -most : part > most ? most : part;
}

/* a + (b - a) p / whole + (c - a) q / whole */
static int64_t mix(int64_t a, int64_t b, int64_t c, int64_t p, int64_t q, int64_t whole) {
    return a + share_of(b - a, p, whole) + share_of(c - a, q, whole);
}

static area_place_t place(const area_mover_t *mv, int64_t x, int64_t y, int64_t e) {
    const line_space_t *l = &mv->to_view->lines;
    if (!l->perspective) return (area_place_t){.x = x, .y = y, .e = (int64_t)1 << l->frac_bits};
    const int64_t most = INT64_MAX >> SOLID_FINE_E;
    return (area_place_t){.x = x, .y = y, .e = (e > most ? most : e < -most ? -most : e) * (1 << SOLID_FINE_E)};
}

/* Is it an edge of the face? */
static bool has_edge(const area_mover_t *mv, int32_t edge) {
    const solid_t *s = mv->to_view->solid;
    for (; edge >= 0; edge = s->edge[edge].twin)
        if (s->edge[edge].face[0] == mv->face || s->edge[edge].face[1] == mv->face) return true;
    return false;
}

static area_place_t vertex(const area_mover_t *mv, int32_t v) {
    const page_h_t h = solid_map_vertex(mv->to_view, v);
    return place(mv, h.x, h.y, h.e);
}

/* Where p is along an edge on whose picture it lies, q30. */
static int64_t along(const area_mover_t *mv, const int32_t v[2], poly_point_t p) {
    const poly_point_t a = area_vertex(mv->from_view, v[0]), b = area_vertex(mv->from_view, v[1]);
    const int64_t dx = (int64_t)b.x - a.x, dy = (int64_t)b.y - a.y, px = (int64_t)p.x - a.x, py = (int64_t)p.y - a.y;
    const bool wide = (dx < 0 ? -dx : dx) > (dy < 0 ? -dy : dy);
    const int64_t size = wide ? dx : dy, at = wide ? px : py;
    if (size == 0) return 0;
    const int64_t share = ints_muldiv_round(INK_ONE, at, size);
    if (share <= 0 || share >= INK_ONE) return share <= 0 ? 0 : INK_ONE;
    if (!mv->from_view->m->lines.perspective) return share;
    const int64_t e0 = solid_map_vertex(mv->from_view->m, v[0]).e, e1 = solid_map_vertex(mv->from_view->m, v[1]).e;
    return line_space_share(share, INK_ONE - share, e0, e1, INK_ONE);
}

/* The vertex where two edges of the face meet; if they have none in common, as where the corner of a hole touches the
 * outline and the two were made to meet, the one of theirs that the light sees there. -1: none. */
static int32_t meeting(const area_mover_t *mv, const int32_t v[2], const int32_t w[2], poly_point_t p) {
    int64_t nearest = AREA_THIN + 1;
    int32_t found = -1;
    for (int k = 0; k < 2; k++)
        if (v[k] == w[0] || v[k] == w[1]) return v[k];
    for (int k = 0; k < 4; k++) {
        const int32_t end = k < 2 ? v[k] : w[k - 2];
        const poly_point_t at = area_vertex(mv->from_view, end);
        const int64_t dx = (int64_t)at.x - p.x, dy = (int64_t)at.y - p.y,
                      off = (int64_t)ints_abs64(dx) + (int64_t)ints_abs64(dy);
        if (off < nearest) nearest = off, found = end;
    }
    return found;
}

/* What ends in an edge of the face lies on it, also where a face of a file is flat only nearly: the light sees that it
 * is not. So does where two edges meet. */
static bool move_on_border(const area_mover_t *mv, poly_point_t p, const int32_t edge[2], area_place_t *to) {
    const solid_t *s = mv->to_view->solid;
    const bool on[2] = {has_edge(mv, edge[0]), has_edge(mv, edge[1])};
    if (!on[0] && !on[1]) return false;
    const int32_t *v = s->edge[edge[on[0] ? 0 : 1]].v, *w = s->edge[edge[on[1] ? 1 : 0]].v;
    if (v != w) {
        const int32_t corner = meeting(mv, v, w, p);
        if (corner >= 0) *to = vertex(mv, corner);
        return corner >= 0;
    }
    const int64_t share = along(mv, v, p);
    const page_h_t a = solid_map_vertex(mv->to_view, v[0]), b = solid_map_vertex(mv->to_view, v[1]);
    const page_h_t at = share == INK_ONE ? b : line_space_mix(&a, &b, (int32_t)share);
    *to = place(mv, at.x, at.y, at.e);
    return true;
}

area_place_t area_move(const area_mover_t *mv, poly_point_t p, const int32_t edge[2]) {
    const page_h_t *h = mv->to;
    area_place_t on_border;
    if (move_on_border(mv, p, edge, &on_border)) return on_border;
    int64_t to_b = poly_orient(mv->at[0], p, mv->at[2]), to_c = poly_orient(mv->at[0], mv->at[1], p);
    int64_t whole = mv->whole;
    if (mv->from_view->m->lines.perspective) {
        /* A share l of a corner in the picture is a share l / E of it in space, in the sum of these. */
        const int64_t fine = INK_ONE * 256;
        int64_t share[3] = {0, ints_muldiv_round(to_b, fine, whole), ints_muldiv_round(to_c, fine, whole)};
        share[0] = fine - share[1] - share[2];
        for (int k = 0; k < 3; k++)
            share[k] = ints_muldiv_round(share[k], mv->from_view->near >> SOLID_FINE_E, mv->from[k].e);
        whole = share[0] + share[1] + share[2];
        to_b = share[1];
        to_c = share[2];
        if (whole == 0) whole = 1;
    }
    int64_t x = mix(h[0].x, h[1].x, h[2].x, to_b, to_c, whole);
    int64_t y = mix(h[0].y, h[1].y, h[2].y, to_b, to_c, whole);
    int64_t e = mv->to_view->lines.perspective ? mix(h[0].e, h[1].e, h[2].e, to_b, to_c, whole) : 0;
    return place(mv, x, y, e);
}

#endif
