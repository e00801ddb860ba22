/* clear_ref.c - see clear_ref.h. */
#include "tests/oracle/clear_ref.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "error.h"
#include "tests/oracle/num_of.h"
#include "tests/oracle/run_cases.h"
#include "tests/oracle/solid_ink.h"

/* ---- scenes ---- */

static uint64_t state64;

static double random_unit(void) {
    state64 = state64 * 6364136223846793005u + 1442695040888963407u;
    return (double)(state64 >> 11) * 0x1p-53;
}
static int pick(int n) {
    return (int)(random_unit() * n);
}

/* A place in the plane of a face. */
static int on_face(solid_ref_t *r, int f) {
    const int n = r->first[f + 1] - r->first[f], *c = r->corner + r->first[f];
    const exact_point_t a = r->vertex[c[0]], b = r->vertex[c[1 + pick(n - 1)]], d = r->vertex[c[1 + pick(n - 1)]];
    const double u = random_unit() * 1.8 - .4, w = random_unit() * 1.8 - .4;
    return solid_ref_vertex(r, a.x + u * (b.x - a.x) + w * (d.x - a.x), a.y + u * (b.y - a.y) + w * (d.y - a.y),
                            a.z + u * (b.z - a.z) + w * (d.z - a.z));
}

/* Faces of one object have vertices of their own. */
static bool begins_object(const solid_ref_t *r, int f) {
    int least = r->nv, most = -1;
    for (int k = r->first[f]; k < r->first[f + 1]; k++) least = r->corner[k] < least ? r->corner[k] : least;
    for (int k = 0; k < r->first[f]; k++) most = r->corner[k] > most ? r->corner[k] : most;
    return least > most;
}

/* Is the same polygon there again? Then rays do not tell which of both a line is seen on. */
static bool has_twin(const solid_ref_t *r, int f) {
    for (int g = 0; g < r->nf; g++) {
        int shared = 0;
        for (int j = r->first[f]; j < r->first[f + 1] && g != f; j++)
            for (int k = r->first[g]; k < r->first[g + 1]; k++)
                if (memcmp(&r->vertex[r->corner[j]], &r->vertex[r->corner[k]], sizeof r->vertex[0]) == 0) {
                    shared++;
                    break;
                }
        if (shared == r->first[f + 1] - r->first[f]) return true;
    }
    return false;
}

/* Thinner than a hundredth of its length: lines on it meet its borders at angles at which the lattice of the scene
 * moves the crossing by steps. */
static bool is_needle(const solid_ref_t *r, int f) {
    const int n = r->first[f + 1] - r->first[f], *c = r->corner + r->first[f];
    double area[3] = {0, 0, 0}, far = 0;
    const exact_point_t o = r->vertex[c[0]];
    for (int k = 0; k < n; k++) {
        const exact_point_t p = r->vertex[c[k]], q = r->vertex[c[(k + 1) % n]];
        const double px = p.x - o.x, py = p.y - o.y, pz = p.z - o.z, qx = q.x - o.x, qy = q.y - o.y, qz = q.z - o.z;
        area[0] += py * qz - pz * qy;
        area[1] += pz * qx - px * qz;
        area[2] += px * qy - py * qx;
        far = fmax(far, px * px + py * py + pz * pz);
    }
    return sqrt(area[0] * area[0] + area[1] * area[1] + area[2] * area[2]) < 2e-2 * far;
}

/* Makes some faces translucent and draws lines on some. */
static void dress(solid_scene_t *s, uint64_t seed) {
    solid_ref_t *r = &s->ref;
    state64 = seed * 2654435761u + 99;
    for (int k = 0; k < 4; k++) random_unit();
    if (r->nf == 0) return;
    r->clear = calloc((size_t)r->nf, sizeof *r->clear);
    r->detail = malloc((size_t)r->nf * 3 * sizeof *r->detail);
    if (!r->clear || !r->detail) abort();
    /* On a lattice whole bodies: from inside of a body the edges of what touches it lie in the faces that are seen. */
    const int kind = s->lattice ? 3 : pick(5), from = pick(r->nf), to = from + pick(r->nf);
    for (int f = 0; f < r->nf; f++)
        r->clear[f] = kind == 0   ? pick(3) == 0
                      : kind == 1 ? f >= from && f <= to
                      : kind == 2 ? pick(8) != 0
                      : kind == 3 ? (begins_object(r, f) ? pick(2) : r->clear[f - 1])
                                  : false;
    for (int f = 0; f < r->nf; f++)
        for (int k = has_twin(r, f) || is_needle(r, f) ? 0 : pick(4); k > 1; k--) {
            const int a = on_face(r, f), b = on_face(r, f);
            r->detail[r->nd][0] = f;
            r->detail[r->nd][1] = a;
            r->detail[r->nd++][2] = b;
        }
}

void clear_scene_random(solid_scene_t *s, uint64_t seed, int objects) {
    solid_scene_random(s, seed, objects);
    dress(s, seed);
}
void clear_scene_polygons(solid_scene_t *s, uint64_t seed, int objects) {
    solid_scene_polygons(s, seed, objects);
    dress(s, seed);
}

/* ---- references ---- */

/* The same without translucent faces; corners are shared. */
static solid_ref_t looked_through(const solid_ref_t *r) {
    solid_ref_t t = *r;
    t.nf = t.nc = 0;
    t.corner = t.first = NULL;
    for (int f = 0; f < r->nf; f++)
        if (!r->clear || !r->clear[f]) solid_ref_face(&t, r->corner + r->first[f], r->first[f + 1] - r->first[f]);
    return t;
}

/* Lines on faces of `of`, hidden by the faces of `by`. */
typedef struct details {
    const solid_ref_t *of, *by;
} details_t;

static int details_lines(const void *ref, int family) {
    return family ? 0 : ((const details_t *)ref)->of->nd;
}
static int details_edges(const void *ref, int family, int line) {
    (void)ref, (void)family, (void)line;
    return 1;
}
static bool details_exist(const void *ref, int family, int line, int k) {
    (void)ref, (void)family, (void)line, (void)k;
    return true;
}
static void details_ends(const void *ref, int family, int line, int k, exact_point_t end[2]) {
    const solid_ref_t *r = ((const details_t *)ref)->of;
    (void)family, (void)k;
    for (int i = 0; i < 2; i++) end[i] = r->vertex[r->detail[line][1 + i]];
}

static void look_at(const details_t *d, int line, const exact_point_t at[2], spans_t *hidden, spans_t *either) {
    spans_t beside = {0}, border = {0};
    exact_point_t end[2];
    details_ends(d, 0, line, 0, end);
    solid_ref_hidden(d->by, at, end, hidden, either);
    solid_ref_beside(d->of, d->of->detail[line][0], at, &beside, &border);
    for (size_t k = 0; k < beside.n; k++) spans_add(hidden, beside.s[k].a, beside.s[k].b);
    for (size_t k = 0; k < border.n && either; k++) spans_add(either, border.s[k].a, border.s[k].b);
    spans_tidy(hidden);
    if (either) spans_tidy(either);
    spans_free(&beside);
    spans_free(&border);
}

static void details_look(const void *ref, int family, int line, int k, spans_t *hidden, spans_t *either) {
    exact_point_t end[2];
    details_ends(ref, family, line, k, end);
    look_at(ref, line, end, hidden, either);
}
static void details_moved(const void *ref, int family, int line, int k, const exact_point_t at[2], spans_t *hidden) {
    (void)family, (void)k;
    look_at(ref, line, at, hidden, NULL);
}
static void details_doubled(const void *ref, int family, int line, int k, const exact_point_t at[2],
                            const exact_point_t other[2], spans_t *out) {
    (void)ref, (void)family, (void)line, (void)k, (void)at, (void)other;
    spans_clear(out);
}

static judge_subject_t judge_details(const details_t *d) {
    return (judge_subject_t){.ref = d,
                             .lines = details_lines,
                             .edges = details_edges,
                             .exists = details_exist,
                             .ends = details_ends,
                             .look = details_look,
                             .moved = details_moved,
                             .doubled = details_doubled};
}

/* ---- ink ---- */

/* Pieces of edges, and of lines on faces. */
typedef struct clear_ink {
    solid_ink_t edges, details;
} clear_ink_t;

static double apart(const exact_point_t *p, const solid_t *s, int32_t v) {
    const double q[3] = {p->x, p->y, p->z};
    double sum = 0;
    for (int k = 0; k < 3; k++) sum += fabs(q[k] - num_value(s->origin[k]) - ldexp(s->vertex[v].at[k], -s->shift));
    return sum;
}

static void take_detail(solid_ink_t *ink, const ink_piece_t *p) {
    const solid_ref_t *r = ink->ref;
    const solid_edge_t *e = &ink->solid->edge[p->line];
    const double from = (double)p->from / (double)INK_ONE, to = (double)p->to / (double)INK_ONE;
    double nearest = fmax(1e-6 * r->size, 4 * ink->unit);
    int line = -1;
    bool turned = false;
    for (int d = 0; d < r->nd; d++)
        for (int t = 0; t < 2; t++) {
            const double off = apart(&r->vertex[r->detail[d][1 + t]], ink->solid, e->v[0]) +
                               apart(&r->vertex[r->detail[d][2 - t]], ink->solid, e->v[1]);
            if (off < nearest) nearest = off, line = d, turned = t;
        }
    if (line < 0) {
        ink->lost++;
        return;
    }
    ink->piece = realloc(ink->piece, (ink->n + 1) * sizeof *ink->piece);
    ink->piece[ink->n++] = (judge_piece_t){REF_ROW, line, turned ? 1 - to : from, turned ? 1 - from : to};
}

static int take(void *ctx, const ink_piece_t *p) {
    clear_ink_t *ink = ctx;
    if (p->line < ink->edges.solid->ne) return solid_ink_take(&ink->edges, p);
    take_detail(&ink->details, p);
    return 0;
}

static void add(solid_ink_t *to, const solid_ink_t *from) {
    to->piece = realloc(to->piece, (to->n + from->n + 1) * sizeof *to->piece);
    for (size_t k = 0; k < from->n; k++) to->piece[to->n++] = from->piece[k];
}

/* ---- */

static bool judge_both(const solid_stage_t *t, const solid_ref_t *ref, clear_ink_t ink[2], const page_view_t *view,
                       clear_report_t *out) {
    solid_ref_t through = looked_through(ref);
    bool good = true;
    add(&ink[1].edges, &ink[0].edges);
    add(&ink[1].details, &ink[0].details);
    for (int k = 0; k < 2; k++) {
        const solid_ref_t *by = k ? &through : ref;
        const details_t lines = {ref, by};
        const judge_subject_t edges = judge_solid(by), details = judge_details(&lines);
        solid_ink_share(&ink[k].edges);
        good &= judge_pieces(&edges, view, ink[k].edges.piece, ink[k].edges.n, &out->edges[k]) == 0;
        good &= judge_pieces(&details, view, ink[k].details.piece, ink[k].details.n, &out->details[k]) == 0;
        good &= cases_good(&out->edges[k]) && cases_good(&out->details[k]);
        out->lost += ink[k].edges.lost + ink[k].details.lost;
    }
    (void)t;
    free(through.corner);
    free(through.first);
    return good && out->lost == 0;
}

bool clear_scene_judge(const solid_scene_t *s, clear_report_t *out) {
    solid_stage_t t;
    bool good = true;
    *out = (clear_report_t){0};
    int err = solid_stage_make(&t, s, true);
    if (!err) {
        solid_ref_t ref = s->ref;
        page_view_t view;
        solid_view_of(&t.cam, &view, &ref.eye);
        const solid_ink_t none = {.ref = &ref, .solid = &t.solid, .view = &view, .unit = ldexp(1, -t.solid.shift)};
        clear_ink_t ink[2] = {{none, none}, {none, none}};
        const ink_sink_t seen = {&ink[0], take}, behind = {&ink[1], take};
        const hidden_job_t job = {.mem = t.mem[2], .bytes = t.bytes, .sink = &seen};
        err = area_draw(&t.map, NULL, &behind, &job, &t.stats, &t.sorted);
        out->area = t.sorted;
        /* an eye in a face is a matter of taste */
        if (!err && !solid_ref_eye_touches(&ref)) good = judge_both(&t, &ref, ink, &view, out);
        for (int k = 0; k < 2; k++) {
            free(ink[k].edges.piece);
            free(ink[k].details.piece);
        }
    }
    solid_stage_free(&t);
    return err ? err == ERR_VALUE || err == ERR_EMPTY : good;
}
