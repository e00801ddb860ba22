/* judge_page.c - see judge_page.h. */
#include "tests/oracle/judge_page.h"

#include <math.h>

/* What runs along for less is taken for a crossing. */
#define LEAST_MM (JUDGE_STEP_MM / 4)

static double mix(double a, double b, double t) {
    return a + t * (b - a);
}

/* From a fraction on the page to a place in space. */
static double in_space(const page_part_t *p, double u) {
    const double a = u * p->depth[0], b = (1 - u) * p->depth[1];
    return mix(p->from, p->to, a + b > 0 ? a / (a + b) : u);
}

void judge_page_fill(judge_page_t *page, const judge_subject_t *what, const page_view_t *v, const judge_piece_t *piece,
                     size_t n) {
    spans_t hidden = {0}, either = {0}, seen = {0};
    exact_point_t end[2];
    page_part_t p;
    if (page->known) return;
    page->known = true;
    for (size_t i = 0; i < n; i++)
        for (int k = (int)piece[i].from; k < piece[i].to; k++) {
            what->ends(what->ref, piece[i].family, piece[i].line, k, end);
            if (page_view_part(v, end, fmax(0, piece[i].from - k), fmin(1, piece[i].to - k), &p))
                page_lines_add(&page->drawn, p.at);
        }
    for (int family = 0; family < 2; family++)
        for (int line = 0; line < what->lines(what->ref, family); line++)
            for (int k = 0; k < what->edges(what->ref, family, line); k++) {
                if (!what->exists(what->ref, family, line, k)) continue;
                what->ends(what->ref, family, line, k, end);
                what->look(what->ref, family, line, k, &hidden, &either);
                spans_complement(&hidden, 0, 1, &seen);
                for (size_t i = 0; i < seen.n; i++)
                    if (page_view_part(v, end, (double)seen.s[i].a, (double)seen.s[i].b, &p))
                        page_lines_add(&page->seen, p.at);
            }
    spans_free(&hidden);
    spans_free(&either);
    spans_free(&seen);
}

void judge_page_free(judge_page_t *page) {
    page_lines_free(&page->drawn);
    page_lines_free(&page->seen);
    *page = (judge_page_t){0};
}

/* Takes out what is no longer than a crossing of two lines. */
static void keep_long(const page_part_t *p, spans_t *along) {
    const double all = hypot(p->at.x1 - p->at.x0, p->at.y1 - p->at.y0);
    size_t k = 0;
    for (size_t i = 0; i < along->n; i++) {
        const bool whole = along->s[i].a <= 0 && along->s[i].b >= 1; /* it may go on along the next edge */
        if (whole || all * (double)(along->s[i].b - along->s[i].a) >= LEAST_MM) along->s[k++] = along->s[i];
    }
    along->n = k;
}

void judge_page_alone(const judge_subject_t *what, const page_view_t *v, int family, int line, const spans_t *part,
                      const page_lines_t *by, spans_t *out) {
    spans_t along = {0}, covered = {0};
    for (size_t i = 0; i < part->n; i++)
        for (int k = (int)floorl(part->s[i].a); k < part->s[i].b; k++) {
            exact_point_t end[2];
            page_part_t p;
            what->ends(what->ref, family, line, k, end);
            if (!page_view_part(v, end, (double)(part->s[i].a - k), (double)(part->s[i].b - k), &p)) continue;
            page_lines_along(&p.at, by, JUDGE_ONE_LINE_MM, &along);
            keep_long(&p, &along);
            for (size_t m = 0; m < along.n; m++)
                spans_add(&covered, k + (long double)in_space(&p, (double)along.s[m].a),
                          k + (long double)in_space(&p, (double)along.s[m].b));
        }
    spans_tidy(&covered);
    spans_subtract(part, &covered, out);
    spans_free(&along);
    spans_free(&covered);
}
