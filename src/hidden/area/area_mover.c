/* area_mover.c - see area_mover.h. */
#include "hidden/area/area_mover.h"

#include "config.h"
#include "num/ints.h"

#if CONFIG_AREA

bool area_mover(area_mover_t *mv, const area_lattice_t *from, const solid_map_t *to, int32_t face) {
    const solid_face_t *f = &to->solid->face[face];
    const int32_t *corner = to->solid->corner + f->corner;
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
    mv->n = f->n <= AREA_MOVER_CORNERS ? f->n : 0;
    for (int32_t k = 0; k < mv->n; k++) {
        mv->border[k].at = area_vertex(from, corner[k]);
        *mv->border[k].from = solid_map_vertex(from->m, corner[k]);
        *mv->border[k].to = solid_map_vertex(to, corner[k]);
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

/* A point on the border stays on it, also where a face of a file is flat only nearly: the light sees that it is not. */
static bool move_on_border(const area_mover_t *mv, poly_point_t p, area_place_t *to) {
    for (int32_t k = 0; k < mv->n; k++) {
        const int32_t m = k + 1 < mv->n ? k + 1 : 0;
        const poly_point_t a = mv->border[k].at, b = mv->border[m].at;
        const int64_t dx = (int64_t)b.x - a.x, dy = (int64_t)b.y - a.y, px = (int64_t)p.x - a.x,
                      py = (int64_t)p.y - a.y;
        const int64_t wide = dx < 0 ? -dx : dx, high = dy < 0 ? -dy : dy, size = wide > high ? wide : high;
        const int64_t along = wide > high ? (dx < 0 ? -px : px) : (dy < 0 ? -py : py), off = dx * py - dy * px;
        if (size == 0 || along < 0 || along > size || off > 2 * size || off < -2 * size) continue;
        const page_h_t *f = mv->border[k].from, *h = mv->border[k].to, *g = mv->border[m].to;
        int64_t share = ints_muldiv_round(INK_ONE, along, size);
        if (mv->from_view->m->lines.perspective && share > 0 && share < INK_ONE) {
            /* as in the picture, to in space */
            const int64_t far = mv->border[m].from->e;
            share = ints_muldiv_round(INK_ONE, ints_muldiv_round(share, f->e, far),
                                      ints_muldiv_round(share, f->e, far) + INK_ONE - share);
        }
        const page_h_t at = line_space_mix(h, g, (int32_t)(share > INK_ONE - 1 ? INK_ONE - 1 : share));
        *to = share == INK_ONE ? place(mv, g->x, g->y, g->e) : place(mv, at.x, at.y, at.e);
        return true;
    }
    return false;
}

area_place_t area_move(const area_mover_t *mv, poly_point_t p) {
    const page_h_t *h = mv->to;
    area_place_t on_border;
    if (move_on_border(mv, p, &on_border)) return on_border;
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
