/* The wrapped functions: __real_ is the kernels' own. */
#include "tests/report/lattice.h"

#include "hidden/surface/horizons.h"
#include "hidden/surface/windows_pool.h"
#include "view/chart.h"

int lattice_shift;
int lattice_simplify;
int lattice_profiles;

void __real_chart_row(const chart_t *c, grid_t *g, int32_t j, chart_line_t *line);
void __wrap_chart_row(const chart_t *c, grid_t *g, int32_t j, chart_line_t *line);
int __real_horizons_clip(horizons_t *h, pencil_t p0, pencil_t p1);
int __wrap_horizons_clip(horizons_t *h, pencil_t p0, pencil_t p1);
int __real_windows_insert(windows_t *w, int32_t a0, int32_t a1, const outline_line_t *lo, const outline_line_t *hi);
int __wrap_windows_insert(windows_t *w, int32_t a0, int32_t a1, const outline_line_t *lo, const outline_line_t *hi);

static int32_t coarse(int32_t v) {
    return lattice_shift ? (v + (1 << (lattice_shift - 1))) >> lattice_shift : v;
}
static pencil_t coarse_point(pencil_t p) {
    return (pencil_t){coarse(p.a), coarse(p.w)};
}

void __wrap_chart_row(const chart_t *c, grid_t *g, int32_t j, chart_line_t *line) {
    __real_chart_row(c, g, j, line);
    if (lattice_shift && c->kind < CHART_AROUND)
        for (int32_t i = 0; i < g->nx; i++) line->at[i] = coarse_point(line->at[i]);
}

/* Takes what is nearly straight out of the part of a horizon that was just made: left of the gap. */
static void simplify(envelope_t *h) {
    enum { REACH = 6 };
    for (pencil_t *v = h->l - 2; v > h->base + 1 && v >= h->l - REACH; v--) {
        pencil_t p = v[-1], q = v[1];
        if (p.a >= v->a || v->a >= q.a) continue; /* a jump */
        if (p.w == ENVELOPE_FLOOR || v->w == ENVELOPE_FLOOR || q.w == ENVELOPE_FLOOR) continue;
        int64_t off = envelope_orient(p, q, *v), most = (int64_t)(q.a - p.a) * lattice_simplify;
        if (off > most || off < -most) continue;
        for (pencil_t *to = v; to + 1 < h->l; to++) *to = to[1];
        h->l--;
    }
}

int __wrap_horizons_clip(horizons_t *h, pencil_t p0, pencil_t p1) {
    int err = lattice_profiles ? __real_horizons_clip(h, coarse_point(p0), coarse_point(p1))
                               : __real_horizons_clip(h, p0, p1);
    if (lattice_simplify && !err && h->has_upper) simplify(&h->upper);
    if (lattice_simplify && !err && h->has_lower) simplify(&h->lower);
    return err;
}

/* What is left of a window that a facet cuts. */
int __wrap_windows_insert(windows_t *w, int32_t a0, int32_t a1, const outline_line_t *lo, const outline_line_t *hi) {
    if (lattice_simplify && a0 < a1 && windows_line_at(hi, a0) - windows_line_at(lo, a0) <= lattice_simplify &&
        windows_line_at(hi, a1) - windows_line_at(lo, a1) <= lattice_simplify)
        return 0;
    return __real_windows_insert(w, a0, a1, lo, hi);
}
