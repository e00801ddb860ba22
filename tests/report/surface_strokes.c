/* surface_strokes.c - see surface_strokes.h. */
#include "tests/report/surface_strokes.h"

#include <math.h>

/* Ends of a piece's part in cell k, on the page; false if not on it. */
static bool part_on_page(const scene_t *s, const judge_piece_t *p, int k, double at[4]) {
    exact_point_t e[2], q[2];
    double t[2] = {fmax(p->from - k, 0), fmin(p->to - k, 1)}, t0, t1;
    surface_ref_edge_ends(&s->ref, p->family, p->line, k, e);
    if (!page_view_clip(&s->view, e, &t0, &t1)) return false;
    t[0] = fmax(t[0], t0), t[1] = fmin(t[1], t1);
    if (t[0] >= t[1]) return false;
    for (int i = 0; i < 2; i++) {
        q[i] = (exact_point_t){e[0].x + t[i] * (e[1].x - e[0].x), e[0].y + t[i] * (e[1].y - e[0].y),
                               e[0].z + t[i] * (e[1].z - e[0].z)};
        if (!page_view_point(&s->view, q[i], &at[2 * i], &at[2 * i + 1])) return false;
    }
    return true;
}

strokes_t surface_strokes(const scene_t *s, const run_drawing_t *d, const sheet_box_t *box) {
    strokes_t all = {0};
    for (size_t i = 0; i < d->n; i++)
        for (int k = (int)d->piece[i].from; k < d->piece[i].to; k++) {
            double at[4];
            if (!part_on_page(s, &d->piece[i], k, at)) continue;
            if (box && (fmax(at[0], at[2]) < box->x0 || fmin(at[0], at[2]) > box->x1)) continue;
            if (box && (fmax(at[1], at[3]) < box->y0 || fmin(at[1], at[3]) > box->y1)) continue;
            strokes_add(&all, at[0], at[1], at[2], at[3]);
        }
    return all;
}
