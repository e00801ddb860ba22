/* Slab by slab, with margins that make rounding harmless. */
#include "tests/oracle/surface_visit.h"

#include <math.h>

/* Widens [*lo, *hi] by the abscissae of segment p-q within the slab ylo <= y <= yhi. */
static void slab_range(const long double p[2], const long double q[2], long double ylo, long double yhi,
                       long double *lo, long double *hi) {
    long double t0 = 0, t1 = 1, dy = q[1] - p[1];
    if (dy == 0) {
        if (p[1] < ylo || p[1] > yhi) return;
    } else {
        long double a = (ylo - p[1]) / dy, b = (yhi - p[1]) / dy;
        t0 = fmaxl(0, fminl(a, b));
        t1 = fminl(1, fmaxl(a, b));
        if (t0 > t1) return;
    }
    long double a = p[0] + t0 * (q[0] - p[0]), b = p[0] + t1 * (q[0] - p[0]);
    *lo = fminl(*lo, fminl(a, b));
    *hi = fmaxl(*hi, fmaxl(a, b));
}

/* Ground quadrilateral between the edge and the eye (or, for a parallel view, a point beyond the grid). */
static void footprint(const query_t *q, long double f[4][2]) {
    const surface_ref_t *r = q->r;
    long double reach = r->x[r->nx - 1] - r->x[0] + (r->y[r->ny - 1] - r->y[0]);
    long double size = fabsl(r->eye.x) + fabsl(r->eye.y);
    for (int s = 0; s < 2; s++) {
        f[s][0] = q->p[s].x;
        f[s][1] = q->p[s].y;
        f[3 - s][0] = r->eye.h ? (long double)r->eye.x : f[s][0] + (size > 0 ? 2 * reach * r->eye.x / size : 0);
        f[3 - s][1] = r->eye.h ? (long double)r->eye.y : f[s][1] + (size > 0 ? 2 * reach * r->eye.y / size : 0);
    }
}

/* The first column of cells that reaches beyond x. */
static int first_column(const surface_ref_t *r, long double x) {
    int lo = 0, hi = r->nx - 1;
    while (lo < hi) {
        int mid = (lo + hi) / 2;
        if (r->x[mid + 1] < x)
            lo = mid + 1;
        else
            hi = mid;
    }
    return lo;
}

/* Visits every existing cell of one sheet that may be between the edge and the eye; the margins only cost time. */
static void visit_sheet(const query_t *q, bool other, surface_visit_fn *visit, void *ctx) {
    const surface_ref_t *r = q->r;
    long double f[4][2];
    footprint(q, f);
    long double slack_x = 1e-9L * (r->x[r->nx - 1] - r->x[0]), slack_y = 1e-9L * (r->y[r->ny - 1] - r->y[0]);
    for (int cj = 0; cj + 1 < r->ny; cj++) {
        long double lo = INFINITY, hi = -INFINITY;
        for (int k = 0; k < 4; k++)
            slab_range(f[k], f[(k + 1) & 3], r->y[cj] - slack_y, r->y[cj + 1] + slack_y, &lo, &hi);
        if (lo > hi) continue;
        for (int ci = first_column(r, lo - slack_x); ci + 1 < r->nx && r->x[ci] <= hi + slack_x; ci++) {
            if (!surface_ref_cell_exists(r, ci, cj)) continue;
            bool beside = q->imin >= ci && q->imax <= ci + 1 && q->jmin >= cj && q->jmax <= cj + 1;
            visit(q, ci, cj, !beside ? APART : other ? OVER : OWN, ctx);
        }
    }
}

void surface_visit(const query_t *q, surface_visit_fn *visit, void *ctx) {
    visit_sheet(q, false, visit, ctx);
    for (int s = 0; s < q->r->sheets; s++) {
        surface_ref_t sheet = *q->r;
        query_t there = *q;
        sheet.z = q->r->sheet_z[s];
        sheet.hole = q->r->sheet_hole ? q->r->sheet_hole[s] : NULL;
        there.r = &sheet;
        visit_sheet(&there, true, visit, ctx);
    }
}
