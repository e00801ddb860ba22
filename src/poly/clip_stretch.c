/* clip_stretch.c - long stretches of border that nothing comes near, swept as one edge each.
 *
 * Most of a large polygon's border meets nothing, and the sweep would visit its vertices only to pass on. Borders are
 * cut into stretches that run into one quadrant, so each lies in the box of its two ends, and so does the chord between
 * them. Where the closed box of a stretch meets no other, but for the vertex it shares with the stretch before or
 * after, the chord may take its place: everything else stays outside of that box, and the planar graph keeps its shape.
 * Stretches whose boxes do meet are cut in four, and only those are looked at again; a box that is clear of the large
 * ones is clear of what they are cut into. Roundings never take an edge out of the box of its ends, so a chord stays
 * clear. The contours of results run along the stretches again (clip_trace.c).
 *
 * Where this saves little, because borders turn all the time or meet everywhere, it gives up early. */
#include "poly/clip_inner.h"

#define CUT_IN 2
#define LONGEST 8 /* edges, a power of CUT_IN; where there are many: */
#define LONGEST_OF_MANY 64
#define MANY 16384
/* Worth it only where a stretch has so many edges on average, and decided by so many comparisons of boxes for each, and
 * so many more. */
#define WORTHWHILE 3
#define COMPARISONS 64
#define AT_FIRST 4096

/* A stretch while it is looked for is its box, l to r; tag is its first vertex, w its edges and what is known. */
enum { EDGES, KNOWN };
enum { JOINED = 1, MEETS = 2 }; /* it goes on from the one before in the same quadrant; its box meets another */

typedef struct stretches {
    clip_t *c;
    int32_t clip;             /* where the vertices of the clip polygon begin */
    clip_seg_t *list, *spare; /* of stretches, in order of x once sorted; each has room for most */
    int32_t n, most;
    int32_t segments; /* in c->in */
    bool tall;        /* x and y of boxes are exchanged */
    bool full;
} stretches_t;

/* ---- reading ---- */

/* Copies a polygon without the vertices that repeat the next one, and each contour's first again after its last.
 * Returns the new n, or -1. */
static int32_t copy(poly_vertex_t *v, int32_t n, const poly_t *p, bool tagged) {
    int32_t from = 0;
    for (int32_t k = 0; k < p->contours; from = p->end[k++]) {
        int32_t first = n;
        for (int32_t i = from; i < p->end[k]; i++) {
            if (!clip_in_range(p->v[i].at)) return -1;
            if (poly_same(p->v[i].at, p->v[i + 1 < p->end[k] ? i + 1 : from].at)) continue;
            v[n] = p->v[i];
            if (!tagged) v[n].tag = POLY_CUT;
            n++;
        }
        if (n == first) continue;
        v[n] = v[first];
        v[n++].tag = CLIP_LAST;
    }
    return n;
}

static void add(stretches_t *s, int32_t from, int32_t to, bool joined) {
    poly_point_t a = s->c->v[from].at, b = s->c->v[to].at;
    if (s->n == s->most) {
        s->full = true;
        return;
    }
    if (s->tall) {
        a = (poly_point_t){a.y, a.x};
        b = (poly_point_t){b.y, b.x};
    }
    s->list[s->n++] = (clip_seg_t){.l = {a.x < b.x ? a.x : b.x, a.y < b.y ? a.y : b.y},
                                   .r = {a.x > b.x ? a.x : b.x, a.y > b.y ? a.y : b.y},
                                   .w = {(int16_t)(to - from), joined ? JOINED : 0},
                                   .tag = from};
}

/* A vertex that is the right end of both its edges needs a segment of no length to be met at all. */
static void mark(stretches_t *s, poly_point_t at) {
    s->c->in[s->segments++] = (clip_seg_t){.l = at, .r = at};
}

/* Cuts the contour that begins at v[from] into stretches; the edge that closes it is one for itself. Returns where the
 * next contour begins. */
static int32_t cut_contour(stretches_t *s, int32_t from, int32_t longest) {
    const poly_vertex_t *v = s->c->v;
    bool forward = false, rising = false, joined = false;
    int32_t start = from, k = from;
    for (; v[k].tag != CLIP_LAST; k++) {
        poly_point_t a = v[k].at, b = v[k + 1].at;
        bool on = poly_before(a, b), goes_on = k > from && on == forward && (rising ? b.y >= a.y : b.y <= a.y);
        bool closing = v[k + 1].tag == CLIP_LAST;
        if (goes_on && !closing && k - start < longest) continue;
        if (k > from) add(s, start, k, joined);
        if (forward && !on) mark(s, a);
        if (!goes_on) rising = b.y >= a.y;
        forward = on;
        joined = goes_on;
        start = k;
    }
    add(s, start, k, joined);
    if (forward && !poly_before(v[from].at, v[from + 1].at)) mark(s, v[from].at);
    return k + 1;
}

/* ---- deciding ---- */

static bool follows(const clip_seg_t *a, const clip_seg_t *b) {
    return b->w[KNOWN] & JOINED && b->tag == a->tag + a->w[EDGES];
}

/* Which boxes meet? In order of x, each with those that reach so far. False if that takes too long. */
static bool find_meetings(stretches_t *s) {
    clip_sort(s->list, s->n, s->spare);
    int32_t *active = (int32_t *)(void *)s->spare, actives = 0;
    int64_t left = AT_FIRST;
    for (int32_t i = 0; i < s->n; i++) {
        clip_seg_t *a = &s->list[i];
        int32_t kept = 0;
        left += COMPARISONS - actives;
        if (left < 0) return false;
        for (int32_t j = 0; j < actives; j++) {
            clip_seg_t *b = &s->list[active[j]];
            if (b->r.x < a->l.x) continue;
            active[kept++] = active[j];
            if (b->r.y < a->l.y || a->r.y < b->l.y || follows(a, b) || follows(b, a)) continue;
            a->w[KNOWN] |= MEETS;
            b->w[KNOWN] |= MEETS;
        }
        active[kept] = i;
        actives = kept + 1;
    }
    return true;
}

/* An edge, or the chord of a stretch, for the sweep. */
static void emit(stretches_t *s, int32_t from, int32_t edges) {
    clip_t *c = s->c;
    poly_point_t a = c->v[from].at, b = c->v[from + edges].at;
    bool forward = poly_before(a, b);
    clip_seg_t *to = &c->in[s->segments++];
    *to = (clip_seg_t){.l = forward ? a : b, .r = forward ? b : a, .tag = c->v[from].tag};
    to->w[from >= s->clip] = forward ? 1 : -1;
    if (edges == 1) return;
    to->tag = CLIP_STRETCH - c->stretches++;
    c->stretch[-c->stretches] = (clip_stretch_t){from, from + edges};
}

/* What is clear goes to the sweep. The rest is listed again, long stretches in parts; where there are none, the edges
 * go to the sweep one by one. */
static void cut(stretches_t *s) {
    clip_seg_t *list = s->list;
    int32_t n = s->n;
    bool last = true;
    for (int32_t k = 0; k < n; k++) last &= !(list[k].w[KNOWN] & MEETS && list[k].w[EDGES] > CUT_IN);
    s->list = s->spare;
    s->spare = list;
    s->n = 0;
    for (int32_t k = 0; k < n; k++) {
        int32_t from = list[k].tag, edges = list[k].w[EDGES], to = from + edges;
        int32_t each = last ? 1 : edges > CUT_IN ? (edges + CUT_IN - 1) / CUT_IN : edges;
        if (!(list[k].w[KNOWN] & MEETS)) {
            emit(s, from, edges);
            continue;
        }
        for (int32_t at = from; at < to; at += each) {
            if (last)
                emit(s, at, 1);
            else
                add(s, at, at + each < to ? at + each : to, at > from || list[k].w[KNOWN] & JOINED);
        }
    }
}

/* Is a polygon higher than it is wide? */
static bool is_tall(const poly_vertex_t *v, int32_t n) {
    int32_t x0 = v[0].at.x, x1 = x0, y0 = v[0].at.y, y1 = y0;
    for (int32_t k = 1; k < n; k++) {
        x0 = v[k].at.x < x0 ? v[k].at.x : x0;
        x1 = v[k].at.x > x1 ? v[k].at.x : x1;
        y0 = v[k].at.y < y0 ? v[k].at.y : y0;
        y1 = v[k].at.y > y1 ? v[k].at.y : y1;
    }
    return y1 - y0 > x1 - x0;
}

int32_t clip_find_stretches(clip_t *c, const clip_job_t *job, void *mem, size_t *bytes) {
    int32_t edges = poly_vertices(&job->subject) + poly_vertices(&job->clip);
    int32_t contours = job->subject.contours + job->clip.contours, room = edges + contours;
    if (contours > edges / 8 || *bytes < CLIP_BYTES(edges)) return 0;
    /* Segments from the start of the memory on, copies of the vertices at its end and stretches before them: */
    c->v = (poly_vertex_t *)mem + *bytes / sizeof(poly_vertex_t) - room;
    c->stretch = (clip_stretch_t *)mem + ((size_t)((uint8_t *)c->v - (uint8_t *)mem) / sizeof(clip_stretch_t));
    c->in = mem;
    stretches_t s = {.c = c, .most = edges - edges / 4};
    s.list = c->in + edges + edges / 2;
    s.spare = s.list + s.most;
    s.clip = copy(c->v, 0, &job->subject, true);
    int32_t n = s.clip < 0 ? -1 : copy(c->v, s.clip, &job->clip, c->tagged);
    if (n <= 0) return 0;
    s.tall = is_tall(c->v, n);
    for (int32_t at = 0; at < n;) at = cut_contour(&s, at, n < MANY ? LONGEST : LONGEST_OF_MANY);
    if (s.n > edges / WORTHWHILE) return 0;
    while (s.n > 0) {
        if (s.full || !find_meetings(&s)) return 0;
        cut(&s);
    }
    *bytes = (size_t)((uint8_t *)(c->stretch - c->stretches) - (uint8_t *)mem);
    return s.segments <= edges - edges / 4 ? s.segments : 0;
}
