/* naive_solids.c - see naive_solids.h. */
#include "tests/report/naive_solids.h"

#include <math.h>
#include <stdlib.h>

#include "tests/report/naive.h"

typedef struct buffer {
    const page_view_t *view;
    float *near; /* of each pixel: the nearest that was painted */
    int columns, rows;
    double pixel; /* mm */
    float slack;
} buffer_t;

/* On the page in pixels, and how near: larger is nearer, linear along a line's picture. */
typedef struct spot {
    float x, y, near;
} spot_t;

static bool look(const buffer_t *b, exact_point_t p, spot_t *s) {
    const page_view_t *v = b->view;
    double x, y;
    if (!page_view_point(v, p, &x, &y)) return false;
    const double e = v->m[2][0] * p.x + v->m[2][1] * p.y + v->m[2][2] * p.z + v->m[2][3];
    const double parallel = v->eye.x * p.x + v->eye.y * p.y + v->eye.z * p.z;
    *s = (spot_t){(float)((x - v->x0) / b->pixel), (float)((y - v->y0) / b->pixel),
                  (float)(v->eye.h ? 1 / e : parallel)};
    return true;
}

/* Even-odd over the centres of pixels; its plane by the corners that span most. */
static void paint(buffer_t *b, const spot_t *s, int n) {
    float lo[2] = {INFINITY, INFINITY}, hi[2] = {-INFINITY, -INFINITY}, best = 0, dx = 0, dy = 0;
    for (int i = 0; i < n; i++) {
        lo[0] = fminf(lo[0], s[i].x), hi[0] = fmaxf(hi[0], s[i].x);
        lo[1] = fminf(lo[1], s[i].y), hi[1] = fmaxf(hi[1], s[i].y);
        const spot_t *p = &s[0], *q = &s[i], *r = &s[(i + 1) % n];
        const float ax = q->x - p->x, ay = q->y - p->y, bx = r->x - p->x, by = r->y - p->y, area = ax * by - ay * bx;
        if (!(fabsf(area) > fabsf(best))) continue;
        best = area;
        dx = ((q->near - p->near) * by - (r->near - p->near) * ay) / area;
        dy = ((r->near - p->near) * ax - (q->near - p->near) * bx) / area;
    }
    if (best == 0) return;
    for (int y = (int)fmaxf(0, floorf(lo[1])); (float)y <= hi[1] && y < b->rows; y++)
        for (int x = (int)fmaxf(0, floorf(lo[0])); (float)x <= hi[0] && x < b->columns; x++) {
            const float cx = (float)x + .5f, cy = (float)y + .5f;
            bool in = false;
            for (int i = 0; i < n; i++) {
                const spot_t *p = &s[i], *q = &s[(i + 1) % n];
                if ((p->y > cy) != (q->y > cy) && cx < p->x + (cy - p->y) / (q->y - p->y) * (q->x - p->x)) in = !in;
            }
            float *at = &b->near[y * b->columns + x];
            if (in) *at = fmaxf(*at, s[0].near + dx * (cx - s[0].x) + dy * (cy - s[0].y));
        }
}

/* From a fraction on the page to one in space. */
static double in_space(const page_view_t *v, const spot_t s[2], double u) {
    if (!v->eye.h) return u;
    const double a = u * (double)s[1].near, b = (1 - u) * (double)s[0].near;
    return a + b > 0 ? a / (a + b) : u;
}

static void put(judge_piece_t **all, size_t *n, int edge, double from, double to) {
    if (!(from < to)) return;
    *all = realloc(*all, (*n + 1) * sizeof **all);
    if (!*all) abort();
    (*all)[(*n)++] = (judge_piece_t){REF_ROW, edge, from, to};
}

static void walk(const buffer_t *b, const solid_ref_t *r, int edge, judge_piece_t **all, size_t *n) {
    const exact_point_t end[2] = {r->vertex[r->edge[edge][0]], r->vertex[r->edge[edge][1]]};
    double t0, t1;
    spot_t s[2];
    if (!page_view_clip(b->view, end, &t0, &t1) || !look(b, end[0], &s[0]) || !look(b, end[1], &s[1])) return;
    const int steps = 1 + (int)fmaxf(fabsf(s[1].x - s[0].x), fabsf(s[1].y - s[0].y));
    double from = -1;
    if (steps > 1000000) return;
    for (int k = 0; k <= steps; k++) {
        const float u = ((float)k + .5f) / (float)steps;
        const int x = (int)(s[0].x + u * (s[1].x - s[0].x)), y = (int)(s[0].y + u * (s[1].y - s[0].y));
        bool seen = k < steps && x >= 0 && y >= 0 && x < b->columns && y < b->rows;
        seen = seen && s[0].near + u * (s[1].near - s[0].near) >= b->near[y * b->columns + x] - b->slack;
        const double at = in_space(b->view, s, (double)k / steps);
        if (seen && from < 0) from = fmax(at, t0);
        if (!seen && from >= 0) put(all, n, edge, from, fmin(at, t1)), from = -1;
    }
}

judge_piece_t *naive_solids(const solid_ref_t *r, const page_view_t *v, size_t *n) {
    buffer_t b = {.view = v, .columns = NAIVE_COLUMNS, .pixel = (v->x1 - v->x0) / NAIVE_COLUMNS};
    judge_piece_t *all = malloc(sizeof *all);
    float lo = INFINITY, hi = -INFINITY;
    b.rows = 1 + (int)((v->y1 - v->y0) / b.pixel);
    b.near = malloc((size_t)(b.columns * b.rows) * sizeof *b.near);
    if (!b.near || !all) abort();
    for (int k = 0; k < b.columns * b.rows; k++) b.near[k] = -INFINITY;
    for (int f = 0; f < r->nf; f++) {
        spot_t s[64];
        int m = 0;
        for (int k = r->first[f]; k < r->first[f + 1] && m < 64; k++) m += look(&b, r->vertex[r->corner[k]], &s[m]);
        if (m < r->first[f + 1] - r->first[f]) continue; /* partly behind the eye */
        for (int k = 0; k < m; k++) lo = fminf(lo, s[k].near), hi = fmaxf(hi, s[k].near);
        paint(&b, s, m);
    }
    b.slack = hi > lo ? 1e-3f * (hi - lo) : 0;
    *n = 0;
    for (int e = 0; e < r->ne; e++) walk(&b, r, e, &all, n);
    free(b.near);
    return all;
}

static void cut(spans_t *gone, const halo_edge_t *e, const halo_edge_t *f, double width) {
    const double ax = e->q.x - e->p.x, ay = e->q.y - e->p.y, bx = f->q.x - f->p.x, by = f->q.y - f->p.y;
    const double cross = ax * by - ay * bx, ox = f->p.x - e->p.x, oy = f->p.y - e->p.y;
    if (cross == 0) return;
    const double t = (ox * by - oy * bx) / cross, u = (ox * ay - oy * ax) / cross;
    if (t < 0 || t > 1 || u < 0 || u > 1) return;
    if (e->p.z / 2 + e->q.z / 2 >= f->p.z / 2 + f->q.z / 2) return;
    const double half = width * hypot(bx, by) / fabs(cross);
    spans_add(gone, fmax(0, t - half), fmin(1, t + half));
}

void naive_halo(halo_run_t *out, const halo_edge_t *edge, int n, int32_t width) {
    spans_t whole = {0}, gone = {0}, left = {0};
    spans_add(&whole, 0, 1);
    for (int e = 0; e < n; e++) {
        spans_clear(&gone);
        for (int f = 0; f < n; f++)
            if (f != e) cut(&gone, &edge[e], &edge[f], width);
        spans_tidy(&gone);
        spans_subtract(&whole, &gone, &left);
        for (size_t k = 0; k < left.n; k++) halo_run_add(out, e, (double)left.s[k].a, (double)left.s[k].b);
    }
    spans_free(&whole);
    spans_free(&gone);
    spans_free(&left);
}
