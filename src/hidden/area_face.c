/* area_face.c - see area_face.h. */
#include "hidden/area_face.h"
#include "hidden/area_wires.h"

#include "num/ints.h"
#include "scene/solid_math.h"

area_lattice_t area_lattice(const solid_map_t *m) {
    area_lattice_t l = {m, AREA_LATTICE_BITS, INT64_MAX};
    for (int32_t k = 0; k < m->solid->nv; k++) {
        const solid_place_t *p = &m->place[k];
        if (solid_map_is_behind(m, k)) {
            /* edges that are cut end anywhere */
            return (area_lattice_t){m, 0, m->lines.near_e};
        }
        if (m->lines.perspective) {
            int64_t e = solid_map_vertex(m, k).e;
            l.near_e = e < l.near_e ? e : l.near_e;
        }
        while (l.bits > 0 && (p->x > POLY_LIMIT >> l.bits || p->x < -(POLY_LIMIT >> l.bits) ||
                              p->y > POLY_LIMIT >> l.bits || p->y < -(POLY_LIMIT >> l.bits)))
            l.bits--;
    }
    return l;
}

static int64_t depth_of(const area_lattice_t *l, int64_t e) {
    return -ints_muldiv_round(l->near_e, (int64_t)1 << AREA_Z_BITS, e);
}

poly_point_t area_vertex(const area_lattice_t *l, int32_t v, int64_t *z) {
    const solid_map_t *m = l->m;
    page_h_t h = solid_map_vertex(m, v);
    *z = m->lines.perspective ? depth_of(l, h.e) : m->place[v].z;
    if (l->bits == 0) return (poly_point_t){m->place[v].x, m->place[v].y};
    if (!m->lines.perspective) h.e = (int64_t)1 << m->lines.frac_bits;
    return (poly_point_t){(int32_t)ints_muldiv_round(h.x, (int64_t)1 << l->bits, h.e),
                          (int32_t)ints_muldiv_round(h.y, (int64_t)1 << l->bits, h.e)};
}

bool area_edge(const area_lattice_t *l, int32_t edge, poly_point_t end[2], int64_t z[2], int64_t t_q30[2]) {
    solid_place_t place[2];
    if (!solid_map_edge(l->m, edge, place, t_q30)) return false;
    for (int k = 0; k < 2; k++) {
        int32_t v = l->m->solid->edge[edge].v[k];
        if (!solid_map_is_behind(l->m, v)) {
            end[k] = area_vertex(l, v, &z[k]);
        } else {
            end[k] = (poly_point_t){place[k].x, place[k].y};
            z[k] = depth_of(l, l->m->lines.near_e);
        }
    }
    return true;
}

int64_t area_space(const area_lattice_t *l, int32_t edge, int32_t page_q30) {
    solid_place_t place[2];
    int64_t t[2], e[2], s = page_q30;
    solid_map_edge(l->m, edge, place, t);
    if (l->m->lines.perspective && page_q30 > 0 && page_q30 < INK_ONE) {
        for (int k = 0; k < 2; k++) {
            int32_t v = l->m->solid->edge[edge].v[k];
            e[k] = solid_map_is_behind(l->m, v) ? l->m->lines.near_e : solid_map_vertex(l->m, v).e;
        }
        /* page u, space s: s = u e0 / (u e0 + (1 - u) e1), with e < 2^35 brought below 2^31 */
        int shift = 64 - ints_clz64((uint64_t)(e[0] | e[1])) - 31;
        for (int k = 0; k < 2 && shift > 0; k++) e[k] >>= shift;
        int64_t far = page_q30 * e[0], near = (INK_ONE - page_q30) * e[1];
        s = ints_muldiv_round(INK_ONE, far, far + near);
    }
    return t[0] + ((t[1] - t[0]) * s >> 30);
}

area_box_t area_box_of(const poly_vertex_t *v, int32_t n) {
    area_box_t b = {v[0].at.x, v[0].at.y, v[0].at.x, v[0].at.y};
    for (int32_t k = 1; k < n; k++) {
        poly_point_t p = v[k].at;
        b.x0 = p.x < b.x0 ? p.x : b.x0;
        b.x1 = p.x > b.x1 ? p.x : b.x1;
        b.y0 = p.y < b.y0 ? p.y : b.y0;
        b.y1 = p.y > b.y1 ? p.y : b.y1;
    }
    return b;
}

bool area_is_thin(const poly_t *p, const area_box_t *box) {
    int64_t area2 = poly_area2(p);
    return (area2 < 0 ? -area2 : area2) <= 8 * ((int64_t)box->x1 - box->x0 + box->y1 - box->y0);
}

int64_t area_depth(const area_plane_t *p, poly_point_t at) {
    int64_t whole = poly_orient(p->a, p->b, p->c);
    return p->za + ints_muldiv_round(poly_orient(p->a, at, p->c), p->zb - p->za, whole) +
           ints_muldiv_round(poly_orient(p->a, p->b, at), p->zc - p->za, whole);
}

/* Which edge of the scene runs from each corner of a face to the next. */
static void find_edges(const solid_t *s, int32_t *corner_edge) {
    for (int32_t k = 0; k < s->nc; k++) corner_edge[k] = POLY_CUT;
    for (int32_t e = 0; e < s->ne; e++) {
        const solid_edge_t *edge = &s->edge[e];
        if (solid_is_cut(edge)) continue;
        for (int side = 0; side < 2; side++) {
            if (edge->face[side] < 0) continue;
            const solid_face_t *f = &s->face[edge->face[side]];
            for (int32_t k = 0; k < f->n; k++) {
                int32_t a = s->corner[f->corner + k], b = s->corner[f->corner + (k + 1 < f->n ? k + 1 : 0)];
                if ((a == edge->v[0] && b == edge->v[1]) || (a == edge->v[1] && b == edge->v[0]))
                    corner_edge[f->corner + k] = edge->first;
            }
        }
    }
}

typedef struct corner {
    poly_vertex_t v;
    int64_t z;
} corner_t;

/* The three corners that span the face widest: the first, the farthest from it, and the farthest from the line between
 * those. False if they lie in one line: the face is seen edge-on. */
static bool span(area_face_t *f, const poly_vertex_t *v, const int64_t *z) {
    int32_t b = 0, c = 0;
    int64_t far = 0, wide = 0;
    for (int32_t k = 1; k < f->n; k++) {
        int64_t dx = v[k].at.x - v[0].at.x, dy = v[k].at.y - v[0].at.y, d = dx * dx + dy * dy;
        if (d > far) far = d, b = k;
    }
    for (int32_t k = 1; k < f->n; k++) {
        int64_t w = poly_orient(v[0].at, v[b].at, v[k].at);
        if (w < 0) w = -w;
        if (w > wide) wide = w, c = k;
    }
    if (wide == 0) return false;
    f->plane = (area_plane_t){v[0].at, v[b].at, v[c].at, z[0], z[b], z[c], 0};
    /* How fast depth changes from one lat to the next, in x and y together. */
    int64_t zb = z[b] - z[0], zc = z[c] - z[0];
    int64_t gx =
        ints_muldiv_round(zb, v[c].at.y - v[0].at.y, wide) - ints_muldiv_round(zc, v[b].at.y - v[0].at.y, wide);
    int64_t gy =
        ints_muldiv_round(zc, v[b].at.x - v[0].at.x, wide) - ints_muldiv_round(zb, v[c].at.x - v[0].at.x, wide);
    int64_t slope = (int64_t)(ints_abs64(gx) / 8 + ints_abs64(gy) / 8) + 1;
    f->plane.slack = slope > INT64_MAX / 256 ? INT64_MAX / 16 : 16 * slope;
    return true;
}

bool area_looks_at_eye(const solid_map_t *m, int32_t face) {
    const solid_vertex_t *p = &m->solid->vertex[m->solid->corner[m->solid->face[face].corner]];
    solid_normal_t n = solid_face_normal(m->solid, face);
    wide_t sum = {0, 0};
    for (int k = 0; k < 3; k++) sum = wide_add(sum, wide_mul_s64(n.n[k], m->eye.e[k] - p->at[k] * m->eye.w));
    return wide_sign(sum) > 0;
}

/* The face's corners on the page, cut off where they are behind the eye. z: their depths. Returns how many. */
static int32_t place(const area_lattice_t *l, const solid_face_t *f, const int32_t *corner_edge, poly_vertex_t *v,
                     int64_t *z) {
    const solid_map_t *m = l->m;
    const solid_t *s = m->solid;
    int32_t n = 0;
    for (int32_t k = 0; k < f->n; k++) {
        int32_t a = s->corner[f->corner + k], b = s->corner[f->corner + (k + 1 < f->n ? k + 1 : 0)];
        int32_t tag = corner_edge[f->corner + k];
        bool hidden_a = solid_map_is_behind(m, a), hidden_b = solid_map_is_behind(m, b);
        if (!hidden_a) {
            v[n] = (poly_vertex_t){area_vertex(l, a, &z[n]), tag};
            n++;
        }
        if (hidden_a == hidden_b || tag < 0) continue;
        poly_point_t end[2];
        int64_t depth[2];
        int64_t t[2];
        if (!area_edge(l, tag, end, depth, t)) continue;
        /* the end that was cut belongs to the vertex behind */
        int cut = s->edge[tag].v[1] == (hidden_a ? a : b);
        v[n] = (poly_vertex_t){end[cut], hidden_a ? tag : POLY_CUT};
        z[n++] = depth[cut];
    }
    return n;
}

static bool is_before(const area_face_t *a, const area_face_t *b) {
    return a->z_near != b->z_near ? a->z_near < b->z_near : a->face < b->face;
}

/* Heap sort: in place, without recursion, the same everywhere. */
static void sift(area_face_t *f, int32_t k, int32_t n) {
    area_face_t moved = f[k];
    for (int32_t child = 2 * k + 1; child < n; child = 2 * k + 1) {
        if (child + 1 < n && is_before(&f[child], &f[child + 1])) child++;
        if (!is_before(&moved, &f[child])) break;
        f[k] = f[child];
        k = child;
    }
    f[k] = moved;
}

static void sort(area_face_t *f, int32_t n) {
    for (int32_t k = n / 2; k-- > 0;) sift(f, k, n);
    for (int32_t k = n; k-- > 1;) {
        area_face_t last = f[k];
        f[k] = f[0];
        f[0] = last;
        sift(f, 0, k);
    }
}

/* An eye with everything in front of it is outside of all closed objects, and sees their outer sides only. */
static bool is_turned_away(const solid_map_t *m, int32_t face) {
    const solid_t *s = m->solid;
    return s->object[s->face[face].object].kind != SOLID_OPEN && !m->any_behind && !area_looks_at_eye(m, face);
}

int32_t area_faces_most(const solid_map_t *m) {
    int32_t n = 0;
    for (int32_t k = 0; k < m->solid->nf; k++) n += !is_turned_away(m, k);
    return n;
}

void area_faces_make(area_faces_t *faces, const solid_map_t *m, int32_t *corner_edge, uint8_t *state, int64_t *depths) {
    const solid_t *s = m->solid;
    find_edges(s, corner_edge);
    faces->lattice = area_lattice(m);
    faces->n = faces->vertices = 0;
    for (int32_t k = 0; k < s->nf; k++) {
        const solid_face_t *from = &s->face[k];
        area_face_t *f = &faces->face[faces->n];
        poly_vertex_t *v = faces->vertex + faces->vertices;
        int64_t *z = depths;
        state[k] = AREA_TURNED_AWAY;
        if (is_turned_away(m, k)) continue;
        state[k] = AREA_LEFT_OUT;
        *f = (area_face_t){.face = k, .first = faces->vertices, .n = place(&faces->lattice, from, corner_edge, v, z)};
        if (f->n < 3 || !span(f, v, z)) continue;
        f->box = area_box_of(v, f->n);
        const poly_t whole = {v, &f->n, 1};
        if (area_is_thin(&whole, &f->box)) continue;
        state[k] = AREA_TAKES_PART;
        f->z_near = z[0];
        for (int32_t i = 1; i < f->n; i++) f->z_near = z[i] < f->z_near ? z[i] : f->z_near;
        faces->vertices += f->n;
        faces->n++;
    }
    sort(faces->face, faces->n);
}
