/* area_weld.c - see area_weld.h. */
#include "hidden/area/area_weld.h"

#include "error.h"
#include "num/ints.h"
#include <string.h>

/* Units within which a vertex of the clip polygon draws an edge of the subject to it, and the other way round. The
 * subject keeps its bends, the clip polygon is the original again next time: so it may give way more. */
#define NEAR_SUBJECT 4
#define NEAR_CLIP 8
/* With more pairs than this a weld costs more than it is worth. */
#define MOST_PAIRS 65536

/* On which side of the line from a to b all of `other` lies, 0 if on none: 1 left, -1 right. */
static int side_of(poly_point_t a, poly_point_t b, const poly_t *other) {
    uint64_t dx = ints_abs64((int64_t)b.x - a.x), dy = ints_abs64((int64_t)b.y - a.y);
    int64_t margin = NEAR_CLIP * (int64_t)(dx > dy ? dx : dy);
    int side = 0;
    for (int32_t k = 0; k < poly_vertices(other); k++) {
        poly_point_t v = other->v[k].at;
        if (poly_same(v, a) || poly_same(v, b)) continue;
        int64_t turn = poly_orient(a, b, v);
        int here = turn > margin ? 1 : turn < -margin ? -1 : 0;
        if (here == 0 || here == -side) return 0;
        side = here;
    }
    return side;
}

static bool has_none_on(int side, poly_point_t a, poly_point_t b, const poly_t *p) {
    for (int32_t k = 0; k < poly_vertices(p); k++) {
        int64_t turn = poly_orient(a, b, p->v[k].at);
        if (side > 0 ? turn > 0 : turn < 0) return false;
    }
    return true;
}

static bool parts(const poly_t *p, const poly_t *other) {
    for (int32_t c = 0, first = 0; c < p->contours; first = p->end[c++]) {
        poly_point_t a = p->v[p->end[c] - 1].at;
        for (int32_t i = first; i < p->end[c]; i++) {
            poly_point_t b = p->v[i].at;
            int side = side_of(a, b, other);
            if (side != 0 && has_none_on(side, a, b, p)) return true;
            a = b;
        }
    }
    return false;
}

bool area_apart(const poly_t *p, const poly_t *q) {
    if ((int64_t)poly_vertices(p) * poly_vertices(q) > MOST_PAIRS) return false;
    return parts(q, p) || parts(p, q);
}

typedef struct builder {
    poly_vertex_t *v;
    int32_t n, most;
} builder_t;

static bool in_box(const area_box_t *b, poly_point_t p, int32_t near) {
    return p.x >= b->x0 - near && p.x <= b->x1 + near && p.y >= b->y0 - near && p.y <= b->y1 + near;
}

static area_box_t box_of(poly_point_t a, poly_point_t b) {
    return (area_box_t){a.x < b.x ? a.x : b.x, a.y < b.y ? a.y : b.y, a.x < b.x ? b.x : a.x, a.y < b.y ? b.y : a.y};
}

/* Does the edge from a to b hit v, which is in its box, or pass it by less than `near` along the shorter of its
 * extents?
 */
enum { FAR, PASSES, HITS };
static int passes(poly_point_t a, poly_point_t b, poly_point_t v, int32_t near) {
    if (poly_same(a, v) || poly_same(b, v)) return FAR;
    uint64_t dx = ints_abs64((int64_t)b.x - a.x), dy = ints_abs64((int64_t)b.y - a.y);
    uint64_t off = ints_abs64(poly_orient(a, b, v));
    return off == 0 ? HITS : off <= (uint64_t)near * (dx > dy ? dx : dy) ? PASSES : FAR;
}

static int64_t along(poly_point_t a, poly_point_t b, poly_point_t v) {
    return ((int64_t)b.x - a.x) * ((int64_t)v.x - a.x) + ((int64_t)b.y - a.y) * ((int64_t)v.y - a.y);
}

/* Is there a vertex of `other`, which counts only within `common`, that an edge of p passes? */
static bool is_near(const poly_t *p, const poly_t *other, const area_box_t *common, int32_t near) {
    for (int32_t c = 0, first = 0; c < p->contours; first = p->end[c++]) {
        poly_point_t a = p->v[p->end[c] - 1].at;
        for (int32_t i = first; i < p->end[c]; i++) {
            poly_point_t b = p->v[i].at;
            const area_box_t box = box_of(a, b);
            if (box.x1 >= common->x0 - near && box.x0 <= common->x1 + near && box.y1 >= common->y0 - near &&
                box.y0 <= common->y1 + near)
                for (int32_t k = 0; k < poly_vertices(other); k++)
                    if (in_box(&box, other->v[k].at, near) && passes(a, b, other->v[k].at, near) == PASSES) return true;
            a = b;
        }
    }
    return false;
}

/* Each vertex of p that is next to one of other's is moved there. */
static void join(poly_vertex_t *v, int32_t n, const poly_t *other, const area_box_t *common) {
    for (int32_t i = 0; i < n; i++) {
        poly_point_t at = v[i].at;
        int32_t least = 2 * NEAR_SUBJECT + 1;
        if (!in_box(common, at, NEAR_SUBJECT)) continue;
        for (int32_t k = 0; k < poly_vertices(other); k++) {
            poly_point_t to = other->v[k].at;
            uint64_t dx = ints_abs64((int64_t)to.x - at.x), dy = ints_abs64((int64_t)to.y - at.y);
            if (dx > NEAR_SUBJECT || dy > NEAR_SUBJECT || (int32_t)(dx + dy) >= least) continue;
            least = (int32_t)(dx + dy);
            v[i].at = to;
        }
    }
}

/* Copies p with each of other's vertices that its edges pass; and hit, since an edge that is bent to one might miss the
 * next. */
static int thread(const poly_t *p, const poly_t *other, int32_t near, builder_t *to, int32_t *end) {
    for (int32_t c = 0, first = 0; c < p->contours; first = p->end[c++]) {
        for (int32_t i = first; i < p->end[c]; i++) {
            poly_point_t a = p->v[i].at, b = p->v[i + 1 < p->end[c] ? i + 1 : first].at;
            const area_box_t box = box_of(a, b);
            if (to->n == to->most) return ERR_FULL;
            int32_t start = to->n;
            to->v[to->n++] = p->v[i];
            int64_t length = along(a, b, b);
            for (int32_t k = 0; k < poly_vertices(other); k++) {
                poly_point_t v = other->v[k].at;
                if (!in_box(&box, v, near) || passes(a, b, v, near) == FAR) continue;
                int64_t at = along(a, b, v);
                if (at <= 0 || at >= length) continue;
                if (to->n == to->most) return ERR_FULL;
                int32_t j = to->n++;
                for (; j > start + 1 && along(a, b, to->v[j - 1].at) > at; j--) to->v[j] = to->v[j - 1];
                to->v[j] = (poly_vertex_t){v, p->v[i].tag};
            }
        }
        end[c] = to->n;
    }
    return 0;
}

int area_weld(area_weld_t *w, const poly_t *subject, const area_box_t *subject_box, const poly_t *clip,
              const area_box_t *clip_box, void *mem, size_t bytes, size_t *used) {
    const area_box_t common = {subject_box->x0 > clip_box->x0 ? subject_box->x0 : clip_box->x0,
                               subject_box->y0 > clip_box->y0 ? subject_box->y0 : clip_box->y0,
                               subject_box->x1 < clip_box->x1 ? subject_box->x1 : clip_box->x1,
                               subject_box->y1 < clip_box->y1 ? subject_box->y1 : clip_box->y1};
    *w = (area_weld_t){*subject, *clip, false};
    *used = 0;
    int32_t n = poly_vertices(subject), m = poly_vertices(clip);
    if ((int64_t)n * m > MOST_PAIRS) return 0;
    if (!is_near(subject, clip, &common, NEAR_SUBJECT) && !is_near(clip, subject, &common, NEAR_CLIP)) return 0;
    w->changed = true;
    /* the subject with its vertices joined, the subject threaded, the clip polygon threaded: and the ends of the last
     * two */
    size_t ends = ((size_t)subject->contours + (size_t)clip->contours) * sizeof(int32_t);
    if (bytes < ends + (size_t)n * sizeof(poly_vertex_t)) return ERR_FULL;
    int32_t *end = mem;
    builder_t to = {(poly_vertex_t *)(void *)(end + subject->contours + clip->contours), 0,
                    (int32_t)((bytes - ends) / sizeof(poly_vertex_t))};
    memcpy(to.v, subject->v, (size_t)n * sizeof *to.v);
    join(to.v, n, clip, &common);
    const poly_t joined = {to.v, subject->end, subject->contours};
    builder_t threaded = {to.v + n, 0, to.most - n};
    int err = thread(&joined, clip, NEAR_SUBJECT, &threaded, end);
    if (err) return err;
    w->subject = (poly_t){threaded.v, end, subject->contours};
    builder_t last = {threaded.v + threaded.n, 0, threaded.most - threaded.n};
    err = thread(clip, &w->subject, NEAR_CLIP, &last, end + subject->contours);
    w->clip = (poly_t){last.v, end + subject->contours, clip->contours};
    *used = (ends + (size_t)(n + threaded.n + last.n) * sizeof(poly_vertex_t) + 7) & ~(size_t)7;
    return err;
}
