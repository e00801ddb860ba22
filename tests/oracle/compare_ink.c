/* Line by line: the intervals of one drawing without those of the other, measured on the page. */
#include "tests/oracle/compare_ink.h"

#include <math.h>

static void line_of(const run_drawing_t *d, int family, int line, spans_t *out) {
    spans_clear(out);
    for (size_t i = 0; i < d->n; i++)
        if (d->piece[i].family == family && d->piece[i].line == line) spans_add(out, d->piece[i].from, d->piece[i].to);
    spans_tidy(out);
}

/* Length on the page of [from, to] of a line, counted in vertices. */
static double length_mm(const scene_t *s, int family, int line, double from, double to) {
    double sum = 0;
    for (int k = (int)floor(from); k < to; k++) {
        exact_point_t e[2];
        page_part_t part;
        surface_ref_edge_ends(&s->ref, family, line, k, e);
        if (!page_view_part(&s->view, e, fmax(from - k, 0), fmin(to - k, 1), &part)) continue;
        sum += hypot(part.at.x1 - part.at.x0, part.at.y1 - part.at.y0);
    }
    return sum;
}

double compare_ink(const scene_t *s, const run_drawing_t *a, const run_drawing_t *b, enum compare_how how,
                   judge_spot_t *where) {
    spans_t ink[2] = {{0}}, only = {0};
    double worst = 0;
    for (int family = 0; family < 2; family++)
        for (int line = 0; line < (family == REF_ROW ? s->ref.ny : s->ref.nx); line++) {
            line_of(a, family, line, &ink[0]);
            line_of(b, family, line, &ink[1]);
            for (int side = how == COMPARE_WITHIN ? 1 : 0; side < 2; side++) {
                spans_subtract(&ink[side], &ink[1 - side], &only);
                for (size_t i = 0; i < only.n; i++) {
                    double from = (double)only.s[i].a, to = (double)only.s[i].b;
                    double mm = length_mm(s, family, line, from, to);
                    if (!(mm > worst)) continue;
                    worst = mm;
                    if (where) *where = (judge_spot_t){family, line, from, to};
                }
            }
        }
    for (int side = 0; side < 2; side++) spans_free(&ink[side]);
    spans_free(&only);
    return worst;
}
