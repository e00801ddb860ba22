/* run_solids.c - a scene of solids through the program's stages, and before the judge. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "error.h"
#include "hidden/area/area.h"
#include "hidden/solid/convex.h"
#include "tests/oracle/num_of.h"
#include "tests/oracle/run_cases.h"
#include "tests/oracle/solid_ink.h"

static void world(const solid_t *s, int32_t v, double out[3]) {
    for (int k = 0; k < 3; k++) out[k] = num_value(s->origin[k]) + ldexp(s->vertex[v].at[k], -s->shift);
}

/* How far the rounding of vertices moves the end of a piece: much where an edge comes within lattice units of the eye,
 * through which one may even pass. It moves the scene, so that the kernel is not judged by it. */
static void measure_moved(solid_ink_t *i, const double a[3], const double b[3], int edge, bool turned, double t) {
    const exact_point_t *p = &i->ref->vertex[i->ref->edge[edge][turned]],
                        *q = &i->ref->vertex[i->ref->edge[edge][!turned]];
    const exact_point_t ours = {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])},
                        its = {p->x + t * (q->x - p->x), p->y + t * (q->y - p->y), p->z + t * (q->z - p->z)};
    const page_view_t *v = i->view;
    double x[2], y[2];
    if (!page_view_point(v, ours, &x[0], &y[0]) || !page_view_point(v, its, &x[1], &y[1])) return;
    if (x[1] < v->x0 || x[1] > v->x1 || y[1] < v->y0 || y[1] > v->y1) return;
    i->moved = fmax(i->moved, hypot(x[1] - x[0], y[1] - y[0]) / JUDGE_STEP_MM);
}

int solid_ink_take(void *ctx, const ink_piece_t *p) {
    solid_ink_t *i = ctx;
    double a[3], b[3], from = (double)p->from / (double)INK_ONE, to = (double)p->to / (double)INK_ONE;
    bool turned;
    world(i->solid, i->solid->edge[p->line].v[0], a);
    world(i->solid, i->solid->edge[p->line].v[1], b);
    int edge = solid_ref_find(i->ref, a, b, fmax(1e-6 * i->ref->size, 4 * i->unit), &turned);
    if (edge < 0) {
        i->lost++;
        return 0;
    }
    measure_moved(i, a, b, edge, turned, from);
    measure_moved(i, a, b, edge, turned, to);
    i->piece = realloc(i->piece, (i->n + 1) * sizeof *i->piece);
    i->piece[i->n++] = (judge_piece_t){REF_ROW, edge, turned ? 1 - to : from, turned ? 1 - from : to};
    return 0;
}

/* Where the edge `of` runs along the edge `on`: the parameters on `on` of its ends. */
static bool runs_along(const solid_ref_t *r, int of, int on, double within, double t[2]) {
    const exact_point_t *o = &r->vertex[r->edge[on][0]], *e = &r->vertex[r->edge[on][1]];
    const double d[3] = {e->x - o->x, e->y - o->y, e->z - o->z}, dd = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    for (int k = 0; k < 2; k++) {
        const exact_point_t *q = &r->vertex[r->edge[of][k]];
        const double p[3] = {q->x - o->x, q->y - o->y, q->z - o->z};
        double off = 0;
        t[k] = (p[0] * d[0] + p[1] * d[1] + p[2] * d[2]) / dd;
        for (int i = 0; i < 3; i++) off += fabs(p[i] - t[k] * d[i]);
        if (off > within) return false;
    }
    return fmin(t[0], t[1]) < 1 && fmax(t[0], t[1]) > 0;
}

void solid_ink_share(solid_ink_t *ink) {
    const solid_ref_t *r = ink->ref;
    const double within = fmax(1e-7 * r->size, ink->unit);
    size_t drawn = ink->n;
    spans_t have = {0}, here = {0}, more = {0};
    for (int on = 0; on < r->ne; on++) {
        spans_clear(&have);
        spans_clear(&here);
        for (size_t i = 0; i < drawn; i++) {
            const judge_piece_t p = ink->piece[i];
            double t[2];
            if (p.line == on) spans_add(&have, p.from, p.to);
            if (p.line == on || !runs_along(r, p.line, on, within, t)) continue;
            double a = t[0] + p.from * (t[1] - t[0]), b = t[0] + p.to * (t[1] - t[0]);
            spans_add(&here, fmax(fmin(a, b), 0), fmin(fmax(a, b), 1));
        }
        spans_tidy(&have);
        spans_tidy(&here);
        spans_subtract(&here, &have, &more);
        for (size_t i = 0; i < more.n; i++) {
            ink->piece = realloc(ink->piece, (ink->n + 1) * sizeof *ink->piece);
            ink->piece[ink->n++] = (judge_piece_t){REF_ROW, on, (double)more.s[i].a, (double)more.s[i].b};
        }
    }
    spans_free(&have);
    spans_free(&here);
    spans_free(&more);
}

void solid_scene_mesh(const solid_ref_t *r, mesh_t *m) {
    packed_t(*vertex)[3] = malloc((size_t)r->nv * sizeof *vertex);
    int32_t words = r->nc + r->nf + 3 * r->nl + (r->clear ? 2 * r->nf : 0) + 3 * r->nd,
            *top = (int32_t *)malloc((size_t)words * sizeof *top) + words, *w = top;
    for (int v = 0; v < r->nv; v++) {
        vertex[v][0] = packed_from_num(num_of(r->vertex[v].x));
        vertex[v][1] = packed_from_num(num_of(r->vertex[v].y));
        vertex[v][2] = packed_from_num(num_of(r->vertex[v].z));
    }
    for (int f = 0, d = 0; f < r->nf; f++) {
        if (r->clear) *--w = 1 << 2 | MESH_OBJECT, *--w = r->clear[f];
        *--w = (r->first[f + 1] - r->first[f]) << 2 | MESH_FACE;
        for (int k = r->first[f]; k < r->first[f + 1]; k++) *--w = r->corner[k];
        for (; d < r->nd && r->detail[d][0] == f; d++) {
            *--w = 2 << 2 | MESH_DETAIL;
            *--w = r->detail[d][1];
            *--w = r->detail[d][2];
        }
    }
    for (int k = 0; k < r->nl; k++) {
        *--w = 2 << 2 | MESH_LINE;
        *--w = r->line[k][0];
        *--w = r->line[k][1];
    }
    *m = (mesh_t){.nv = r->nv, .words = words, .faces = r->nf, .corners = r->nc, .segments = r->nl, .details = r->nd};
    m->vertex = (const packed_t(*)[3])vertex;
    m->top = top;
}

void solid_scene_mesh_free(mesh_t *m) {
    free((void *)(uintptr_t)m->vertex);
    free((void *)(uintptr_t)(m->top - m->words));
}

void solid_view_of(const camera_t *cam, page_view_t *v, exact_eye_t *eye) {
    for (int r = 0; r < 3; r++)
        for (int k = 0; k < 4; k++) v->m[r][k] = num_value(cam->m[r][k]) / (r < 2 ? LAT_PER_MM : 1);
    *eye = (exact_eye_t){num_value(cam->eye[0]), num_value(cam->eye[1]), num_value(cam->eye[2]), cam->perspective};
    v->eye = *eye;
    v->x0 = (double)cam->window.x0_lat / LAT_PER_MM;
    v->y0 = (double)cam->window.y0_lat / LAT_PER_MM;
    v->x1 = (double)cam->window.x1_lat / LAT_PER_MM;
    v->y1 = (double)cam->window.y1_lat / LAT_PER_MM;
}

int solid_stage_make(solid_stage_t *t, const solid_scene_t *s, bool area) {
    *t = (solid_stage_t){.area = area};
    solid_scene_mesh(&s->ref, &t->mesh);
    const mesh_t *m = &t->mesh;
    size_t bytes = solid_bytes(&m, 1);
    t->bytes = (area ? area_bytes(m->faces, m->corners) : convex_bytes(m->faces, m->corners, m->segments)) + 65536;
    t->mem[0] = malloc(bytes);
    t->mem[1] = malloc(SOLID_MAP_BYTES(m->nv));
    t->mem[2] = malloc(t->bytes);
    if (!t->mem[0] || !t->mem[1] || !t->mem[2]) abort();
    int err = solid_build(&t->solid, &m, 1, t->mem[0], bytes);
    view_box_t box = {.solid = true};
    for (int k = 0; k < 3; k++) {
        box.lo[k] = t->solid.lo[k];
        box.hi[k] = t->solid.hi[k];
    }
    if (!err) err = camera_setup(&t->cam, &s->set, &box);
    return err ? err : solid_map_setup(&t->map, &t->solid, &t->cam, t->mem[1]);
}

int solid_stage_draw(solid_stage_t *t, const ink_sink_t *sink) {
    const hidden_job_t job = {.mem = t->mem[2], .bytes = t->bytes, .sink = sink};
    return t->area ? area_draw(&t->map, NULL, NULL, &job, &t->stats, &t->sorted)
                   : convex_draw(&t->map, NULL, &job, &t->stats);
}

void solid_stage_free(solid_stage_t *t) {
    for (int k = 0; k < 3; k++) free(t->mem[k]);
    solid_scene_mesh_free(&t->mesh);
}

int solid_stage_judge(solid_stage_t *t, const solid_scene_t *s, int every, judge_report_t *out, bool *good) {
    solid_ref_t ref = s->ref; /* shares the memory; the eye is its own */
    page_view_t view;
    solid_ink_t ink = {.ref = &ref, .solid = &t->solid, .view = &view, .unit = ldexp(1, -t->solid.shift)};
    *out = (judge_report_t){0};
    solid_view_of(&t->cam, &view, &ref.eye);
    int err = solid_stage_draw(t, &(ink_sink_t){&ink, solid_ink_take});
    *good = true;
    /* for the area sort an eye in a face is a matter of taste */
    if (!err && !(t->area && solid_ref_eye_touches(&ref))) {
        judge_subject_t what = judge_solid(&ref);
        if (!every) solid_ink_share(&ink);
        what.every = every;
        *good = judge_pieces(&what, &view, ink.piece, ink.n, out) == 0 && ink.lost == 0 && cases_good(out);
        out->moved_steps = ink.moved;
    }
    free(ink.piece);
    return err;
}

static bool judge(const solid_scene_t *s, judge_report_t *out, area_stats_t *area) {
    solid_stage_t t;
    bool good = true;
    *out = (judge_report_t){0};
    int err = solid_stage_make(&t, s, area != NULL);
    if (!err) err = solid_stage_judge(&t, s, 0, out, &good);
    if (area) *area = t.sorted;
    solid_stage_free(&t);
    /* all behind the eye; nothing with a length */
    return err ? err == ERR_VALUE || err == ERR_EMPTY : good;
}

bool solid_scene_judge(const solid_scene_t *s, judge_report_t *out) {
    return judge(s, out, NULL);
}

bool solid_scene_judge_area(const solid_scene_t *s, judge_report_t *out, area_stats_t *area) {
    return judge(s, out, area);
}
