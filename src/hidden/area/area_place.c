/* area_place.c - see area_place.h. */
#include "hidden/area/area_place.h"

#include "num/ints.h"

bool area_is_inside(const area_lattice_t *l, int32_t v) {
    const solid_place_t *p = &l->m->place[v];
    int32_t g = l->guard_lat;
    return !solid_map_is_behind(l->m, v) && p->x > -g && p->x < g && p->y > -g && p->y < g;
}

/* The most that a row of the camera gives for steps of 1 along all axes, times 2^20, rounded up. */
static int64_t row_most(const solid_map_t *m, int r) {
    uint64_t sum = 0;
    for (int k = 0; k < 3; k++) sum += ints_abs64(m->row[r][k]) / 4;
    int32_t drop = m->row_bits[r] - 22;
    if (drop >= 0) return (int64_t)(sum >> (drop > 62 ? 62 : drop)) + 1;
    return sum >> (62 + drop) ? INT64_MAX / 2 : (int64_t)(sum << -drop);
}

/* Sums of these must not overflow, whatever the lattice. */
static int64_t limited(int64_t a) {
    return a > INT64_MAX / 8 ? INT64_MAX / 8 : a;
}

static void find_flat(area_lattice_t *l) {
    const solid_map_t *m = l->m;
    int64_t x = limited(row_most(m, 0)), y = limited(row_most(m, 1)), page = x > y ? x : y;
    int64_t scale = (int64_t)SOLID_FLAT << (l->bits + 8), flat;
    if (!m->lines.perspective) {
        uint64_t eye = 0;
        for (int k = 0; k < 3; k++) eye += ints_abs64(m->eye.e[k]);
        int32_t drop = m->z_shift - (AREA_Z_BITS - SOLID_Z_BITS);
        flat = SOLID_FLAT * (int64_t)(drop > 0 ? eye >> drop : eye);
        page = ints_muldiv_round(page, scale, (int64_t)1 << 20 << (m->lines.frac_bits < 40 ? m->lines.frac_bits : 40));
    } else {
        /* d(x / E) = (dx - x/E dE) / E, and |x/E| is below the guard */
        int64_t e = row_most(m, 2), near = l->near >> (SOLID_FINE_E - 20);
        page += limited(ints_muldiv_round(e, l->guard_lat, 1));
        page = ints_muldiv_round(page, scale, near + 1);
        flat = ints_muldiv_round((int64_t)SOLID_FLAT << AREA_Z_BITS >> 2, e, near / 4 + 1);
    }
    l->flat_page_q8 = limited(page) + 1;
    l->flat_z = limited(flat) + 16;
}

area_lattice_t area_lattice(const solid_map_t *m) {
    area_lattice_t l = {.m = m, .bits = AREA_LATTICE_BITS, .near = INT64_MAX};
    const page_window_t *w = m->lines.window;
    while (l.bits > 0 && (w->x1_lat >= POLY_LIMIT >> l.bits || w->y1_lat >= POLY_LIMIT >> l.bits)) l.bits--;
    l.guard_lat = POLY_LIMIT >> l.bits;
    if (l.guard_lat > SOLID_PLACE_MOST) l.guard_lat = SOLID_PLACE_MOST;
    for (int32_t v = 0; v < m->solid->nv; v++) {
        l.clips |= !area_is_inside(&l, v);
        if (!m->lines.perspective || solid_map_is_behind(m, v)) continue;
        int64_t e = solid_map_fine(m, v);
        l.near = e < l.near ? e : l.near;
    }
    if (m->any_behind) l.near = m->lines.near_e * ((int64_t)1 << SOLID_FINE_E);
    find_flat(&l);
    return l;
}

area_place_t area_place(const area_lattice_t *l, int32_t v) {
    page_h_t h = solid_map_vertex(l->m, v);
    int64_t fine = solid_map_fine(l->m, v);
    if (l->m->lines.perspective) return (area_place_t){.x = h.x, .y = h.y, .e = fine};
    return (area_place_t){.x = h.x, .y = h.y, .e = (int64_t)1 << l->m->lines.frac_bits, .z = fine};
}

int64_t area_inside(const area_lattice_t *l, int b, const area_place_t *p) {
    bool perspective = l->m->lines.perspective;
    if (b == 0) return perspective ? p->e - l->near : 0;
    int64_t most = ints_muldiv_round(p->e, l->guard_lat, (int64_t)1 << (perspective ? SOLID_FINE_E : 0));
    int64_t at = b <= 2 ? p->x : p->y;
    if (most > INT64_MAX / 4) most = INT64_MAX / 4;
    return b & 1 ? most - at : most + at;
}

static int64_t part(int64_t a, int64_t b, int64_t in, int64_t whole) {
    return a + ints_muldiv_round(b - a, in, whole);
}

area_place_t area_cut(const area_place_t *in, const area_place_t *out, int64_t in_by, int64_t out_by) {
    /* halved, the difference of opposite signs fits */
    int64_t by = in_by / 2, whole = by - out_by / 2;
    if (whole <= 0) return *in;
    return (area_place_t){part(in->x, out->x, by, whole), part(in->y, out->y, by, whole),
                          part(in->e, out->e, by, whole), part(in->z, out->z, by, whole),
                          part(in->t_q60, out->t_q60, by, whole)};
}

static int64_t divide(const area_lattice_t *l, int64_t at, int64_t e) {
    int more = l->bits + AREA_FINE_BITS + (l->m->lines.perspective ? SOLID_FINE_E : 0);
    int64_t most = (int64_t)l->guard_lat << (l->bits + AREA_FINE_BITS);
    int64_t q = ints_muldiv_round(at, (int64_t)1 << more, e);
    return q < -most ? -most : q > most ? most : q;
}

area_fine_t area_fine(const area_lattice_t *l, const area_place_t *p) {
    int64_t e = p->e < 1 ? 1 : p->e;
    if (!l->m->lines.perspective) return (area_fine_t){divide(l, p->x, e), divide(l, p->y, e), p->z};
    if (e < l->near) e = l->near; /* cut, and rounded to the wrong side */
    return (area_fine_t){divide(l, p->x, e), divide(l, p->y, e),
                         -ints_muldiv_round(l->near, (int64_t)1 << AREA_Z_BITS, e)};
}

static int32_t to_lattice(int64_t fine) {
    const int64_t half = (int64_t)1 << (AREA_FINE_BITS - 1);
    return (int32_t)(fine < 0 ? -((half - fine) >> AREA_FINE_BITS) : (half + fine) >> AREA_FINE_BITS);
}

poly_point_t area_round(const area_lattice_t *l, const area_fine_t *f) {
    (void)l;
    return (poly_point_t){to_lattice(f->x), to_lattice(f->y)};
}

poly_point_t area_vertex(const area_lattice_t *l, int32_t v) {
    const area_place_t p = area_place(l, v);
    const area_fine_t f = area_fine(l, &p);
    return area_round(l, &f);
}

bool area_edge(const area_lattice_t *l, int32_t edge, area_edge_t *out) {
    const int32_t *v = l->m->solid->edge[edge].v;
    area_place_t *at = out->at;
    for (int k = 0; k < 2; k++) at[k] = area_place(l, v[k]);
    at[1].t_q60 = (int64_t)1 << 60;
    bool clips = l->clips && (!area_is_inside(l, v[0]) || !area_is_inside(l, v[1]));
    for (int b = 0; b < AREA_BORDERS && clips; b++) {
        int64_t by[2] = {area_inside(l, b, &at[0]), area_inside(l, b, &at[1])};
        if (by[0] < 0 && by[1] < 0) return false;
        for (int k = 0; k < 2; k++)
            if (by[k] < 0) at[k] = area_cut(&at[1 - k], &at[k], by[1 - k], by[k]);
    }
    for (int k = 0; k < 2; k++) {
        out->fine[k] = area_fine(l, &at[k]);
        out->end[k] = area_round(l, &out->fine[k]);
    }
    return true;
}

int64_t area_space(const area_lattice_t *l, const area_edge_t *e, int32_t page_q30) {
    int64_t t[2], s = page_q30;
    for (int k = 0; k < 2; k++) t[k] = (e->at[k].t_q60 + (1 << 29)) >> 30;
    if (page_q30 <= 0 || page_q30 >= INK_ONE) return t[page_q30 > 0];
    if (l->m->lines.perspective) s = line_space_share(s, INK_ONE - s, e->at[0].e, e->at[1].e, INK_ONE);
    return t[0] + ((t[1] - t[0]) * s >> 30);
}
