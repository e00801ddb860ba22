/* area_detail.c - see area_detail.h. */
#include "hidden/area/area_detail.h"

#include "config.h"
#include "num/ints.h"
#include "num/wide.h"

#if CONFIG_AREA

#define AT_ONCE 64 /* crossings of a line with a polygon; where there are more they are looked for again */
/* What rounding may move a crossing by, in lat: farther away the border has been bent by a cut or a weld, and is not
 * the edge any more. */
#define REFINED_LAT (LAT_PER_MM / 4)

_Static_assert(AT_ONCE % 2 == 0, "pairs");

typedef struct crossing {
    int64_t at_q30; /* on the detail */
    int32_t vertex; /* which of the polygon's edges */
} crossing_t;

static bool is_after(const crossing_t *a, const crossing_t *b) {
    return a->at_q30 != b->at_q30 ? a->at_q30 > b->at_q30 : a->vertex > b->vertex;
}

/* The side of a line that a place is on, times the line's length. */
static wide_t side_of(const area_fine_t line[2], const area_fine_t *p) {
    return wide_sub(wide_mul_s64(line[1].x - line[0].x, p->y - line[0].y),
                    wide_mul_s64(line[1].y - line[0].y, p->x - line[0].x));
}

/* Where along the detail, on the longer axis of its picture. */
static int64_t along(const area_edge_t *detail, poly_point_t p) {
    const int64_t dx = (int64_t)detail->end[1].x - detail->end[0].x, dy = (int64_t)detail->end[1].y - detail->end[0].y;
    const bool wide = ints_abs64(dx) >= ints_abs64(dy);
    const int64_t by = wide ? (int64_t)p.x - detail->end[0].x : (int64_t)p.y - detail->end[0].y, of = wide ? dx : dy;
    return of == 0 ? 0 : ints_muldiv_round(INK_ONE, by, of);
}

/* Where the detail crosses a part of an edge of the scene, from vertex v to the next, if that is near to where the
 * rounded ones do. */
static int64_t refine(const area_lattice_t *l, const area_edge_t *detail, const poly_vertex_t *v,
                      const poly_vertex_t *next, int64_t at_q30) {
    area_edge_t e;
    if (v->tag < 0 || !area_edge(l, v->tag, &e)) return at_q30;
    wide_t a = side_of(e.fine, &detail->fine[0]), b = side_of(e.fine, &detail->fine[1]);
    while (a.hi < -2 || a.hi > 1 || b.hi < -2 || b.hi > 1) /* below 2^65, and then 2^59 */
        a = wide_sar(a, 8), b = wide_sar(b, 8);
    const int64_t from = (int64_t)wide_sar(a, 6).lo, to = (int64_t)wide_sar(b, 6).lo;
    if ((from > 0) == (to > 0)) return at_q30;
    const int64_t fine_q30 = ints_muldiv_round(INK_ONE, from, from - to);
    const uint64_t dx = ints_abs64(detail->end[1].x - (int64_t)detail->end[0].x),
                   dy = ints_abs64(detail->end[1].y - (int64_t)detail->end[0].y);
    const int64_t moved = ints_muldiv_round(fine_q30 - at_q30, (int64_t)(dx > dy ? dx : dy), INK_ONE);
    if (ints_abs64(moved) > (uint64_t)REFINED_LAT << l->bits) return at_q30;
    const int64_t p = along(detail, v->at), q = along(detail, next->at), lo = p < q ? p : q, hi = p < q ? q : p;
    return fine_q30 < lo ? (lo < at_q30 ? lo : at_q30) : fine_q30 > hi ? (hi > at_q30 ? hi : at_q30) : fine_q30;
}

/* Does the detail cross the edge from vertex k to the next? */
static bool cross(const area_lattice_t *l, const area_edge_t *e, const poly_vertex_t *v, const poly_vertex_t *next,
                  int64_t *at_q30) {
    if ((poly_orient(e->end[0], e->end[1], v->at) > 0) == (poly_orient(e->end[0], e->end[1], next->at) > 0))
        return false;
    const int64_t from = poly_orient(v->at, next->at, e->end[0]) / 2, to = poly_orient(v->at, next->at, e->end[1]) / 2;
    int64_t at = from == to ? 0 : ints_muldiv_round(INK_ONE, from, from - to);
    at = at < 0 ? 0 : at > INK_ONE ? INK_ONE : at;
    *at_q30 = at > 0 && at < INK_ONE ? refine(l, e, v, next, at) : at;
    return true;
}

/* The first crossings behind `last`, in order. *more: there are others. */
static int32_t crossings(const area_lattice_t *l, const area_edge_t *e, const poly_t *p, const crossing_t *last,
                         crossing_t list[AT_ONCE], bool *more) {
    int32_t n = 0;
    *more = false;
    for (int32_t c = 0, first = 0; c < p->contours; first = p->end[c++])
        for (int32_t k = first; k < p->end[c]; k++) {
            crossing_t at = {.vertex = k};
            if (!cross(l, e, &p->v[k], &p->v[k + 1 < p->end[c] ? k + 1 : first], &at.at_q30)) continue;
            if (!is_after(&at, last)) continue;
            if (n == AT_ONCE) {
                *more = true;
                if (is_after(&at, &list[n - 1])) continue;
                n--;
            }
            int32_t j = n++;
            for (; j > 0 && is_after(&list[j - 1], &at); j--) list[j] = list[j - 1];
            list[j] = at;
        }
    return n;
}

static int add_detail(const area_lattice_t *l, int32_t line, const poly_t *p, intervals_t *to) {
    crossing_t list[AT_ONCE], last = {-1, -1};
    area_edge_t e;
    if (!area_edge(l, line, &e)) return 0;
    for (bool more = true; more;) {
        const int32_t n = crossings(l, &e, p, &last, list, &more);
        for (int32_t i = 0; i + 1 < n; i += 2) {
            int err = intervals_add(to, line, (int32_t)list[i].at_q30, (int32_t)list[i + 1].at_q30);
            if (err) return err;
        }
        if (more) last = list[n - 1];
    }
    return 0;
}

int32_t area_detail_first(const solid_t *s, int32_t face) {
    int32_t lo = s->ne, hi = s->ne + s->nd;
    while (lo < hi) {
        const int32_t middle = lo + (hi - lo) / 2;
        if (s->edge[middle].face[0] < face)
            lo = middle + 1;
        else
            hi = middle;
    }
    return lo;
}

int area_details(const area_lattice_t *l, int32_t face, const poly_t *p, intervals_t *to) {
    const solid_t *s = l->m->solid;
    int err = 0;
    for (int32_t k = area_detail_first(s, face); k < s->ne + s->nd && s->edge[k].face[0] == face && !err; k++)
        err = add_detail(l, k, p, to);
    return err;
}

#endif
