/* area_face.c - see area_face.h. */
#include "hidden/area/area_face.h"
#include "hidden/area/area_wires.h"

#include "error.h"
#include "num/heap_sort.h"
#include "num/ints.h"
#include "view/solid_side.h"

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

int32_t area_box_halve(const area_box_t *box, area_box_t half[2]) {
    const bool wide = box->x1 - box->x0 >= box->y1 - box->y0;
    const int32_t from = wide ? box->x0 : box->y0, size = (wide ? box->x1 : box->y1) - from;
    half[0] = half[1] = *box;
    *(wide ? &half[0].x1 : &half[0].y1) = from + size / 2;
    *(wide ? &half[1].x0 : &half[1].y0) = from + size / 2;
    return size;
}

bool area_is_thin(const poly_t *p, const area_box_t *box) {
    int64_t area2 = poly_area2(p);
    return (area2 < 0 ? -area2 : area2) <= 2 * AREA_THIN * ((int64_t)box->x1 - box->x0 + box->y1 - box->y0);
}

/* Which edge of the scene runs from each corner of a face to the next. */
static void find_edges(const solid_t *s, int32_t *corner_edge) {
    for (int32_t k = 0; k < s->nc; k++) corner_edge[k] = POLY_CUT;
    for (int32_t e = 0; e < s->ne; e++) {
        const solid_edge_t *edge = &s->edge[e];
        if (solid_is_cut(s, edge)) continue;
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

/* Is a corner's angle below 1 / SHARP? Where that is, its sides are closer to each other than area_weld.h makes one for
 * a thousand units, a tenth of a step, or more. */
#define SHARP 128
bool area_is_sharp(poly_point_t a, poly_point_t b, poly_point_t c) {
    const int64_t ax = (int64_t)a.x - b.x, ay = (int64_t)a.y - b.y, cx = (int64_t)c.x - b.x, cy = (int64_t)c.y - b.y,
                  dot = ax * cx / 2 + ay * cy / 2, cross = ax * cy / 2 - ay * cx / 2;
    return dot > 0 && ints_abs64(cross) < (uint64_t)dot / SHARP;
}

static bool is_sharp(const poly_vertex_t *v, int32_t n) {
    poly_point_t a = v[n - 1].at;
    for (int32_t k = 0; k < n; k++) {
        if (area_is_sharp(a, v[k].at, v[k + 1 < n ? k + 1 : 0].at)) return true;
        a = v[k].at;
    }
    return false;
}

/* How much the depth of a face of this slope may be off at depth z: SOLID_FLAT units of the scene across its plane. */
static int64_t slack_at(const area_lattice_t *l, int64_t slope, int64_t z) {
    int64_t page = l->flat_page_q8, flat = l->flat_z;
    const int64_t one = (int64_t)1 << AREA_Z_BITS, most = INT64_MAX / 16;
    if (l->m->lines.perspective) { /* smaller by near / E, and its square */
        page = ints_muldiv_round(page, -z, one) + 1;
        flat = ints_muldiv_round(ints_muldiv_round(flat, -z, one), -z, one) + 16;
    }
    int64_t across = ints_muldiv_round(slope, page, 256);
    return across > most - flat ? most : flat + across;
}

/* The plane through the three corners that span the face widest: the first, the farthest from it, and the farthest from
 * the line between those. False if they lie in one line: the face is seen edge-on. */
static bool span(const area_lattice_t *l, area_face_t *f, const poly_vertex_t *v, const area_corner_t *corner) {
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
    if (wide == 0 || !area_plane_through(&f->plane, &corner[0].fine, &corner[b].fine, &corner[c].fine)) return false;
    f->z_far = f->z_near = corner[0].fine.z;
    for (int32_t k = 1; k < f->n; k++) {
        int64_t z = corner[k].fine.z;
        f->z_near = z < f->z_near ? z : f->z_near;
        f->z_far = z > f->z_far ? z : f->z_far;
    }
    f->slope = area_plane_slope(&f->plane);
    f->slack = slack_at(l, f->slope, f->z_near);
    f->deep = l->m->lines.perspective && f->z_far / 2 > f->z_near / 3;
    return true;
}

int64_t area_slack(const area_lattice_t *l, const area_face_t *f, int64_t z) {
    return f->deep ? slack_at(l, f->slope, z) : f->slack;
}

bool area_looks_at_eye(const solid_map_t *m, int32_t face) {
    const solid_vertex_t *p = &m->solid->vertex[m->solid->corner[m->solid->face[face].corner]];
    solid_normal_t n = solid_face_normal(m->solid, face);
    return solid_side_exact(m, &n, p) > 0;
}

/* Clips a face in space by a border of what can be drawn: from `from` to `to`, which has room for `most`. Returns how
 * many corners are left, or ERR_FULL. */
static int32_t clip(const area_lattice_t *l, int border, const area_corner_t *from, int32_t n, area_corner_t *to,
                    int32_t most) {
    int32_t left = 0;
    for (int32_t k = 0; k < n; k++) {
        const area_corner_t *a = &from[k], *b = &from[k + 1 < n ? k + 1 : 0];
        int64_t a_by = area_inside(l, border, &a->at), b_by = area_inside(l, border, &b->at);
        if (left + 2 > most) return ERR_FULL;
        if (a_by >= 0) to[left++] = *a;
        if ((a_by >= 0) == (b_by >= 0)) continue;
        to[left].at = a_by >= 0 ? area_cut(&a->at, &b->at, a_by, b_by) : area_cut(&b->at, &a->at, b_by, a_by);
        to[left++].tag = a_by >= 0 ? POLY_CUT : a->tag;
    }
    return left;
}

/* The first n corners of scratch, clipped, are put on the page. */
static int32_t place(const area_lattice_t *l, bool clips, int32_t n, poly_vertex_t *v, area_corner_t *scratch,
                     int32_t most) {
    area_corner_t *from = scratch, *to = scratch + most;
    for (int b = 0; b < AREA_BORDERS && clips; b++) {
        n = clip(l, b, from, n, to, most);
        if (n <= 0) return n;
        area_corner_t *swap = from;
        from = to;
        to = swap;
    }
    for (int32_t k = 0; k < n; k++) {
        scratch[k] = from[k];
        scratch[k].fine = area_fine(l, &scratch[k].at);
        v[k] = (poly_vertex_t){area_round(l, &scratch[k].fine), scratch[k].tag};
    }
    return n;
}

int32_t area_face_place(const area_lattice_t *l, const solid_face_t *f, const int32_t *corner_edge, poly_vertex_t *v,
                        area_corner_t *scratch, int32_t most) {
    const solid_t *s = l->m->solid;
    bool clips = false;
    for (int32_t k = 0; k < f->n; k++) {
        int32_t vertex = s->corner[f->corner + k];
        clips |= l->clips && !area_is_inside(l, vertex);
        scratch[k] =
            (area_corner_t){.at = area_place(l, vertex), .tag = corner_edge ? corner_edge[f->corner + k] : POLY_CUT};
    }
    return place(l, clips, f->n, v, scratch, most);
}

int32_t area_contour_place(const area_lattice_t *l, int32_t edge, int32_t n, poly_vertex_t *v, area_corner_t *scratch,
                           int32_t most) {
    const solid_t *s = l->m->solid;
    bool clips = false;
    for (int32_t k = 0; k < n; k++) {
        const solid_edge_t *e = &s->edge[edge + k];
        const int32_t vertex = e->v[solid_tone(e).turned];
        clips |= l->clips && !area_is_inside(l, vertex);
        scratch[k] = (area_corner_t){.at = area_place(l, vertex), .tag = POLY_CUT};
    }
    return place(l, clips, n, v, scratch, most);
}

/* Each hole is joined to the first corner, which comes again (obj_reader.c); it is the last one of a face that was
 * turned round. */
static bool has_holes(const solid_t *s, const solid_face_t *f) {
    const int32_t *v = s->corner + f->corner, last = f->n - 1;
    for (int32_t k = 1; k < last; k++)
        if (v[k] == v[0] || v[k] == v[last]) return true;
    return false;
}

/* Is a face no wider than its corners' rounding, or the eye in its plane? Close by that may look like something, which
 * hides nothing. */
static bool is_line(const solid_map_t *m, int32_t face) {
    const solid_t *s = m->solid;
    const solid_face_t *f = &s->face[face];
    const solid_normal_t n = solid_face_normal(s, face);
    const solid_vertex_t *first = &s->vertex[s->corner[f->corner]];
    if (solid_side(m, &n, first) == 0 && solid_face_is_flat(s, face, &n)) return true;
    uint64_t area2 = 0, far = 0;
    for (int k = 0; k < 3; k++) area2 += solid_abs(n.n[k]);
    for (int32_t c = 1; c < f->n; c++) {
        const solid_delta_t d = solid_sub(&s->vertex[s->corner[f->corner + c]], first);
        for (int k = 0; k < 3; k++) far = solid_abs(d.d[k]) > far ? solid_abs(d.d[k]) : far;
    }
    return area2 > 0 && area2 <= 4 * SOLID_FLAT * far;
}

static bool is_before(const area_face_t *a, const area_face_t *b) {
    return a->z_near != b->z_near ? a->z_near < b->z_near : a->face < b->face;
}

HEAP_SORT(area_face_t, is_before)

bool area_is_turned_away(const solid_map_t *m, int32_t face, bool into) {
    const solid_object_t *o = &m->solid->object[m->solid->face[face].object];
    return o->kind != SOLID_OPEN && !(into && o->clear) && !m->any_behind && !area_looks_at_eye(m, face);
}

int32_t area_faces_most(const solid_map_t *m) {
    int32_t n = 0;
    for (int32_t k = 0; k < m->solid->nf; k++) n += !area_is_turned_away(m, k, m->through);
    return n;
}

int area_faces_make(area_faces_t *faces, int32_t *corner_edge, uint8_t *state, area_corner_t *scratch, int32_t most) {
    const area_lattice_t *l = &faces->lattice;
    const solid_map_t *m = l->m;
    const solid_t *s = m->solid;
    find_edges(s, corner_edge);
    faces->n = faces->parts = faces->vertices = 0;
    for (int32_t k = 0; k < s->nf; k++) {
        area_face_t *f = &faces->face[faces->n];
        poly_vertex_t *v = faces->vertex + faces->vertices;
        state[k] = AREA_TURNED_AWAY;
        const bool through = m->through && solid_is_clear(m->solid, k);
        if (!through && area_is_turned_away(m, k, m->through)) continue;
        state[k] = AREA_LEFT_OUT;
        if (through) continue;
        int32_t n = area_face_place(l, &s->face[k], corner_edge, v, scratch, AREA_CORNERS(l->clips, most));
        if (n < 0) return n;
        *f = (area_face_t){.face = k,
                           .first = faces->vertices,
                           .n = n,
                           .holed = has_holes(s, &s->face[k]),
                           .object = s->face[k].object};
        if (n < 3 || !span(l, f, v, scratch)) continue;
        f->box = area_box_of(v, n);
        const poly_t whole = {v, &f->n, 1};
        if (area_is_thin(&whole, &f->box) || (f->deep && is_line(m, k))) continue;
        f->sharp = !f->holed && is_sharp(v, n);
        state[k] = AREA_TAKES_PART; /* maybe AREA_ROUGH later */
        faces->vertices += n;
        faces->n++;
    }
    heap_sort(faces->face, faces->n);
    return 0;
}
