/* A look-at camera with a fitted scale, and its inverse for small moves on the page. */
#include "tests/oracle/page_view.h"

#include <math.h>
#include <string.h>

#define PAGE_W 297.0
#define PAGE_H 210.0
#define MARGIN 10.0

static double apply(const double row[4], exact_point_t p) {
    return row[0] * p.x + row[1] * p.y + row[2] * p.z + row[3];
}

/* Solves the 3x3 system a v = b by Cramer's rule; zero for a singular one. */
static void solve3(double a[3][3], const double b[3], double v[3]) {
    double c[3][3], det = 0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            c[i][j] = a[i1][j1] * a[i2][j2] - a[i1][j2] * a[i2][j1];
        }
    for (int j = 0; j < 3; j++) det += a[0][j] * c[0][j];
    for (int j = 0; j < 3; j++) v[j] = det == 0 ? 0 : (b[0] * c[0][j] + b[1] * c[1][j] + b[2] * c[2][j]) / det;
}

static void cross(const double a[3], const double b[3], double out[3]) {
    for (int i = 0; i < 3; i++) out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static double normalise(double v[3]) {
    double n = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int i = 0; i < 3 && n > 0; i++) v[i] /= n;
    return n;
}

void page_view_aim(page_view_t *v, const surface_ref_t *r, const double to[3]) {
    *v = (page_view_t){.eye = r->eye, .x1 = PAGE_W, .y1 = PAGE_H};
    double eye[3] = {r->eye.x, r->eye.y, r->eye.z};
    double back[3], up[3] = {0, 0, 1}, right[3]; /* back: from the scene to the eye */
    for (int i = 0; i < 3; i++) back[i] = r->eye.h ? eye[i] - to[i] : eye[i];
    normalise(back);
    cross(up, back, right);
    if (normalise(right) < 1e-12) right[0] = 1, right[1] = right[2] = 0;
    cross(back, right, up);
    const double *origin = r->eye.h ? eye : to;
    const double *axis[3] = {right, up, back};
    for (int k = 0; k < 3; k++) {
        double s = k == 2 ? -1 : 1;
        for (int i = 0; i < 3; i++) v->m[k][i] = k == 2 && !r->eye.h ? 0 : s * axis[k][i];
        v->m[k][3] =
            k == 2 && !r->eye.h ? 1 : -s * (axis[k][0] * origin[0] + axis[k][1] * origin[1] + axis[k][2] * origin[2]);
    }
    double lo[2] = {INFINITY, INFINITY}, hi[2] = {-INFINITY, -INFINITY};
    double widest = r->eye.h ? tan(50 * 3.14159265358979 / 180) : INFINITY;
    for (int j = 0; j < r->ny; j++)
        for (int i = 0; i < r->nx; i++) {
            if (r->hole && r->hole[j * r->nx + i]) continue;
            exact_point_t p = surface_ref_node(r, i, j);
            double e = apply(v->m[2], p);
            for (int k = 0; k < 2; k++) {
                double x = apply(v->m[k], p), q = e > 0 ? x / e : x > 0 ? widest : -widest;
                lo[k] = fmin(lo[k], fmax(-widest, q));
                hi[k] = fmax(hi[k], fmin(widest, q));
            }
        }
    if (lo[0] > hi[0]) lo[0] = lo[1] = hi[0] = hi[1] = 0; /* no point is defined */
    double wide = fmax(hi[0] - lo[0], 1e-300), high = fmax(hi[1] - lo[1], 1e-300);
    double scale = fmin((PAGE_W - 2 * MARGIN) / wide, (PAGE_H - 2 * MARGIN) / high);
    for (int i = 0; i < 4; i++) {
        v->m[0][i] = scale * v->m[0][i] + (PAGE_W / 2 - scale * (lo[0] + hi[0]) / 2) * v->m[2][i];
        v->m[1][i] = scale * v->m[1][i] + (PAGE_H / 2 - scale * (lo[1] + hi[1]) / 2) * v->m[2][i];
    }
}

exact_eye_t page_view_eye_of(const double m[3][4]) {
    exact_eye_t e = {0};
    double a[3][3], b[3], v[3];
    if (m[2][0] == 0 && m[2][1] == 0 && m[2][2] == 0) { /* parallel: the direction in which the page stands still */
        cross(m[0], m[1], v);
        e = (exact_eye_t){v[0], v[1], v[2], 0};
        return e;
    }
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) a[i][j] = m[i][j];
        b[i] = -m[i][3];
    }
    solve3(a, b, v);
    e = (exact_eye_t){v[0], v[1], v[2], 1};
    return e;
}

bool page_view_point(const page_view_t *v, exact_point_t p, double *px, double *py) {
    double e = apply(v->m[2], p);
    if (!(e > 0)) return false;
    *px = apply(v->m[0], p) / e;
    *py = apply(v->m[1], p) / e;
    return true;
}

bool page_view_clip(const page_view_t *v, const exact_point_t end[2], double *t0, double *t1) {
    double f[5][2];
    double size = 0;
    for (int i = 0; i < 4; i++) size += fabs(v->m[2][i]);
    for (int s = 0; s < 2; s++) {
        double x = apply(v->m[0], end[s]), y = apply(v->m[1], end[s]), e = apply(v->m[2], end[s]);
        f[0][s] = x - v->x0 * e;
        f[1][s] = v->x1 * e - x;
        f[2][s] = y - v->y0 * e;
        f[3][s] = v->y1 * e - y;
        f[4][s] = e - 1e-9 * size;
    }
    *t0 = 0;
    *t1 = 1;
    for (int k = 0; k < 5; k++) {
        if (f[k][0] < 0 && f[k][1] < 0) return false;
        if (f[k][0] < 0) *t0 = fmax(*t0, f[k][0] / (f[k][0] - f[k][1]));
        if (f[k][1] < 0) *t1 = fmin(*t1, f[k][0] / (f[k][0] - f[k][1]));
    }
    return *t0 < *t1;
}

static exact_point_t between(const exact_point_t end[2], double t) {
    return (exact_point_t){end[0].x + t * (end[1].x - end[0].x), end[0].y + t * (end[1].y - end[0].y),
                           end[0].z + t * (end[1].z - end[0].z)};
}

bool page_view_part(const page_view_t *v, const exact_point_t end[2], double from, double to, page_part_t *part) {
    double t0, t1;
    if (!page_view_clip(v, end, &t0, &t1)) return false;
    part->from = fmax(from, t0), part->to = fmin(to, t1);
    if (part->from >= part->to) return false;
    const exact_point_t p = between(end, part->from), q = between(end, part->to);
    part->depth[0] = apply(v->m[2], p), part->depth[1] = apply(v->m[2], q);
    return page_view_point(v, p, &part->at.x0, &part->at.y0) && page_view_point(v, q, &part->at.x1, &part->at.y1);
}

void page_view_shift(const page_view_t *v, const exact_point_t end[2], double dx, double dy, exact_point_t out[2]) {
    for (int s = 0; s < 2; s++) {
        double e = apply(v->m[2], end[s]), a[3][3], d[3];
        double b[3] = {dx * e, dy * e, 0};
        for (int j = 0; j < 3; j++) a[0][j] = v->m[0][j], a[1][j] = v->m[1][j];
        a[2][0] = v->eye.h ? v->m[2][0] : v->eye.x;
        a[2][1] = v->eye.h ? v->m[2][1] : v->eye.y;
        a[2][2] = v->eye.h ? v->m[2][2] : v->eye.z;
        solve3(a, b, d);
        out[s] = (exact_point_t){end[s].x + d[0], end[s].y + d[1], end[s].z + d[2]};
    }
}
