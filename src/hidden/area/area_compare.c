/* area_compare.c - see area_sort.h: which of two polygons is in front, by their depths over the page; and where an edge
 * of either cannot be had from polygons, since it runs along the line where their planes meet. */
#include "hidden/area/area_body.h"
#include "hidden/area/area_sort.h"
#include "hidden/area/area_wires.h"

#include "num/ints.h"
#include "view/solid_side.h"

/* Faces that reach through each other by less than this many units of the page do not: rounding moves a border so far
 * beyond the edge where two faces meet. */
#define LEAST_THROUGH 16

/* Does the line where two planes meet run so nearly along an edge of p that is cut there that being off by so many
 * units moves the end of that edge by a tenth of a step or more? */
static bool is_flat_cut(const poly_t *p, const area_plane_t *apart, int64_t units) {
    const uint64_t slope = (uint64_t)area_plane_slope(apart);
    for (int32_t c = 0, first = 0; c < p->contours; first = p->end[c++])
        for (int32_t k = first; k < p->end[c]; k++) {
            const poly_point_t a = p->v[k].at, b = p->v[k + 1 < p->end[c] ? k + 1 : first].at;
            if (p->v[k].tag < 0) continue;
            const int64_t at_a = area_plane_at(apart, a), at_b = area_plane_at(apart, b);
            if ((at_a > 0) == (at_b > 0)) continue;
            const uint64_t dx = ints_abs64((int64_t)b.x - a.x), dy = ints_abs64((int64_t)b.y - a.y);
            const uint64_t a_unit = (ints_abs64(at_a) + ints_abs64(at_b)) / (dx > dy ? dx : dy);
            if (units >= AREA_TENTH_OF_A_STEP || a_unit < slope / AREA_TENTH_OF_A_STEP * (uint64_t)units) return true;
        }
    return false;
}

void area_roughen(area_t *a, const area_face_t *f) {
    int32_t from, to;
    if (!f->body) {
        if (!f->holed) a->state[f->face] = AREA_ROUGH;
        return;
    }
    area_body_parts(&a->faces, (int32_t)(f - a->faces.face), &from, &to);
    for (int32_t k = from; k < to; k++)
        if (a->faces.face[k].sharp) a->state[a->faces.face[k].face] = AREA_ROUGH;
}

/* A polygon p of face s is cut by face c, or all but: so many units off, of what depth may be off. */
static void look_at_cut(area_t *a, const poly_t *p, const area_face_t *s, const area_face_t *c,
                        const area_plane_t *apart, int64_t slack) {
    const int64_t units = LEAST_THROUGH + slack / area_plane_slope(apart);
    const poly_t whole = {a->faces.vertex + c->first, &c->n, 1};
    if (is_flat_cut(p, apart, units)) area_roughen(a, s);
    if (is_flat_cut(&whole, apart, units)) area_roughen(a, c);
}

/* How much the depths of two faces may be off at a place, each. */
static void slacks_of(const area_t *a, const area_face_t *s, const area_face_t *c, poly_point_t at, int64_t slack[2]) {
    slack[0] = s->slack;
    slack[1] = c->slack;
    if (!s->deep && !c->deep) return;
    const int64_t z = area_plane_at(&s->plane, at), near = z < 0 ? z : 0;
    slack[0] = area_slack(&a->faces.lattice, s, near);
    slack[1] = area_slack(&a->faces.lattice, c, near);
}

/* And together. */
static int64_t slack_of(const area_t *a, const area_face_t *s, const area_face_t *c, poly_point_t at) {
    int64_t slack[2];
    slacks_of(a, s, c, at, slack);
    return slack[0] + slack[1];
}

/* Has an edge a face in the plane of that face, which hides nothing of it? */
static bool is_shown_in(const area_t *a, int32_t edge, int32_t face) {
    const solid_t *s = a->faces.lattice.m->solid;
    for (int32_t e = edge; e >= 0; e = s->edge[e].twin)
        for (int side = 0; side < 2; side++) {
            const int32_t f = s->edge[e].face[side];
            if (f < 0) continue;
            const uint8_t state = a->state[f];
            if ((state == AREA_TAKES_PART || state == AREA_ROUGH) && solid_face_lies_in(s, f, face)) return true;
        }
    return false;
}

/* Does an edge of p lie in the plane of c, and none of its faces does? */
static bool has_edge_in(const area_t *a, const poly_t *p, const area_face_t *s, const area_face_t *c,
                        const area_plane_t *apart) {
    for (int32_t k = 0, first = 0; k < p->contours; first = p->end[k++]) {
        poly_vertex_t from = p->v[p->end[k] - 1];
        bool in = (int64_t)ints_abs64(area_plane_at(apart, from.at)) <= slack_of(a, s, c, from.at);
        for (int32_t i = first; i < p->end[k]; i++) {
            const poly_vertex_t to = p->v[i];
            const bool next = (int64_t)ints_abs64(area_plane_at(apart, to.at)) <= slack_of(a, s, c, to.at);
            if (in && next && from.tag >= 0 && !is_shown_in(a, from.tag, c->face)) return true;
            from = to;
            in = next;
        }
    }
    return false;
}

/* A face seen nearly edge-on is so steep that what its corners may be off its plane is more than all depths around: it
 * would be together with whatever is near it. Faces of one plane are equally steep; so where one is much steeper, it is
 * taken at its word, since its plane goes through corners of it, but for so much as rounding on the page makes of it.
 */
#define STEEPER 16
static void look_at_steep(const area_t *a, const poly_t *p, const area_face_t *s, const area_face_t *c,
                          const area_plane_t *apart, int64_t rounding, int64_t *front, int64_t *behind) {
    for (int32_t k = 0; k < poly_vertices(p); k++) {
        int64_t slack[2];
        slacks_of(a, s, c, p->v[k].at, slack);
        const int steep = slack[1] > slack[0];
        if (slack[steep] / STEEPER < slack[!steep]) continue;
        const int64_t d = area_plane_at(apart, p->v[k].at), least = slack[!steep] + rounding;
        if (d > least && d > *front) *front = d;
        if (-d > least && -d > *behind) *behind = -d;
    }
}

/* Where only steepness makes two faces touch, an edge of the steep one may well be behind the other face or in front of
 * it: as a line it is known where it is. */
static void look_at_touching(area_t *a, const poly_t *p, const area_face_t *s, const area_face_t *c,
                             const area_plane_t *apart) {
    for (int32_t k = 0; k < poly_vertices(p); k++) {
        int64_t slack[2];
        slacks_of(a, s, c, p->v[k].at, slack);
        const int steep = slack[1] > slack[0];
        const int64_t d = (int64_t)ints_abs64(area_plane_at(apart, p->v[k].at)), least = 2 * slack[!steep];
        if (slack[steep] / STEEPER >= slack[!steep] && d > least && d - slack[!steep] <= slack[steep])
            area_roughen(a, steep ? c : s);
    }
}

/* Where they differ most decides, of the corners where they differ by more than what either may be off there. */
int area_compare(area_t *a, const poly_t *p, int32_t of, int32_t than) {
    const area_face_t *s = &a->faces.face[of], *c = &a->faces.face[than];
    if (s->body || c->body) {
        const int where = area_bodies_compare(&a->faces, of, than);
        return where == 1 ? AREA_IN_FRONT : where == -1 ? AREA_BEHIND : AREA_TOGETHER;
    }
    const area_plane_t apart = area_plane_minus(&c->plane, &s->plane);
    int64_t through = area_plane_slope(&apart), slack = s->slack + c->slack;
    int64_t front = 0, behind = 0;
    int32_t touching = 0;
    bool clearly_front = false, clearly_behind = false, maybe_front = false, maybe_behind = false;
    through = through > INT64_MAX / (4 * LEAST_THROUGH) ? INT64_MAX / 4 : through * LEAST_THROUGH;
    for (int32_t k = 0; k < poly_vertices(p); k++) {
        const int64_t d = area_plane_at(&apart, p->v[k].at);
        slack = slack_of(a, s, c, p->v[k].at);
        if (d > slack && d > front) front = d;
        if (-d > slack && -d > behind) behind = -d;
        touching += d <= slack && -d <= slack;
        maybe_front |= d > through;
        maybe_behind |= -d > through;
        clearly_front |= d > slack && d - slack > through;
        clearly_behind |= -d > slack && -d - slack > through;
    }
    if (maybe_front && maybe_behind) look_at_cut(a, p, s, c, &apart, slack);
    if (clearly_front && clearly_behind) return AREA_THROUGH;
    if (touching > 0) look_at_touching(a, p, s, c, &apart);
    if (front == behind) look_at_steep(a, p, s, c, &apart, through, &front, &behind);
    if (front < behind && touching >= 2 && has_edge_in(a, p, s, c, &apart)) area_roughen(a, s);
    return front == behind ? AREA_TOGETHER : front > behind ? AREA_IN_FRONT : AREA_BEHIND;
}
