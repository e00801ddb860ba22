/* surface_strokes.c - see surface_strokes.h. */
#include "tests/report/surface_strokes.h"

#include <math.h>

strokes_t surface_strokes(const scene_t *s, const run_drawing_t *d, const sheet_box_t *box) {
    strokes_t all = {0};
    for (size_t i = 0; i < d->n; i++)
        for (int k = (int)d->piece[i].from; k < d->piece[i].to; k++) {
            const judge_piece_t *p = &d->piece[i];
            exact_point_t end[2];
            page_part_t part;
            surface_ref_edge_ends(&s->ref, p->family, p->line, k, end);
            if (!page_view_part(&s->view, end, fmax(p->from - k, 0), fmin(p->to - k, 1), &part)) continue;
            const page_line_t *l = &part.at;
            if (box && (fmax(l->x0, l->x1) < box->x0 || fmin(l->x0, l->x1) > box->x1)) continue;
            if (box && (fmax(l->y0, l->y1) < box->y0 || fmin(l->y0, l->y1) > box->y1)) continue;
            strokes_add(&all, l->x0, l->y0, l->x1, l->y1);
        }
    return all;
}
