/* The judge works line by line with sets of parameters (spans.h): visible, hidden, drawn. */
#include "tests/oracle/judge_page.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define STEP JUDGE_STEP_MM
#define CLOSE_ENOUGH 0.25 /* steps: what an end may be off */

/* One grid line under judgement. */
typedef struct line {
    const judge_subject_t *r;
    const page_view_t *v;
    int family, index, edges;
    judge_page_t *ink;          /* NULL: the page is not looked at */
    const judge_piece_t *piece; /* the whole drawing */
    size_t pieces;
    spans_t page;    /* exists and is on the page */
    spans_t hidden;  /* of it, hidden or not existing */
    spans_t visible; /* of it, visible without a tie */
    spans_t tied;    /* of it, either */
    spans_t drawn;
} line_t;

static bool clipped(const line_t *l, int k, exact_point_t end[2], double *t0, double *t1) {
    l->r->ends(l->r->ref, l->family, l->index, k, end);
    return page_view_clip(l->v, end, t0, t1);
}

static exact_point_t between(const exact_point_t e[2], double t) {
    return (exact_point_t){e[0].x + t * (e[1].x - e[0].x), e[0].y + t * (e[1].y - e[0].y),
                           e[0].z + t * (e[1].z - e[0].z)};
}

/* Page length of the part [a, b] of the line. */
static double length(const line_t *l, long double a, long double b) {
    double sum = 0;
    for (int k = (int)fmaxl(0, floorl(a)); k < l->edges && k < b; k++) {
        exact_point_t e[2];
        double t0, t1, x0, y0, x1, y1;
        if (!clipped(l, k, e, &t0, &t1)) continue;
        t0 = fmax(t0, (double)(a - k));
        t1 = fmin(t1, (double)(b - k));
        if (t0 < t1 && page_view_point(l->v, between(e, t0), &x0, &y0) &&
            page_view_point(l->v, between(e, t1), &x1, &y1))
            sum += hypot(x1 - x0, y1 - y0);
    }
    return sum;
}

static double total(const line_t *l, const spans_t *s) {
    double sum = 0;
    for (size_t i = 0; i < s->n; i++) sum += length(l, s->s[i].a, s->s[i].b);
    return sum;
}

static void longest(const line_t *l, const spans_t *s, double *worst, judge_spot_t *spot) {
    for (size_t i = 0; i < s->n; i++) {
        double d = length(l, s->s[i].a, s->s[i].b);
        if (d <= *worst) continue;
        *worst = d;
        if (spot) *spot = (judge_spot_t){l->family, l->index, (double)s->s[i].a, (double)s->s[i].b};
    }
}

static void add_shifted(spans_t *to, const spans_t *s, int k) {
    for (size_t i = 0; i < s->n; i++) spans_add(to, s->s[i].a + k, s->s[i].b + k);
}

static void look_at_line(line_t *l) {
    spans_t hidden = {0}, either = {0}, unseen = {0};
    for (int k = 0; k < l->edges; k++) {
        exact_point_t e[2];
        double t0, t1;
        if (!clipped(l, k, e, &t0, &t1)) continue;
        spans_add(&l->page, k + (long double)t0, k + (long double)t1);
        if (!l->r->exists(l->r->ref, l->family, l->index, k)) {
            spans_add(&l->hidden, k, k + 1);
            spans_add(&unseen, k, k + 1);
            continue;
        }
        l->r->look(l->r->ref, l->family, l->index, k, &hidden, &either);
        add_shifted(&l->hidden, &hidden, k);
        add_shifted(&unseen, &hidden, k);
        add_shifted(&unseen, &either, k);
    }
    spans_tidy(&l->page);
    spans_tidy(&l->hidden);
    spans_tidy(&unseen);
    spans_subtract(&l->page, &unseen, &l->visible);
    spans_subtract(&unseen, &l->hidden, &l->tied);
    spans_free(&hidden);
    spans_free(&either);
    spans_free(&unseen);
}

void judge_edge(const judge_subject_t *r, const page_view_t *v, int family, int line, int k, double steps,
                spans_t *visible, spans_t *hidden) {
    exact_point_t e[2], moved[2][2];
    double t0, t1, x0, y0, x1, y1;
    spans_t part = {0}, either = {0}, keep = {0};
    r->look(r->ref, family, line, k, hidden, &either);
    spans_copy(hidden, &part);
    for (size_t i = 0; i < either.n; i++) spans_add(&part, either.s[i].a, either.s[i].b);
    spans_tidy(&part);
    spans_complement(&part, 0, 1, visible);
    r->ends(r->ref, family, line, k, e);
    if (steps > 0 && page_view_clip(v, e, &t0, &t1) && page_view_point(v, between(e, t0), &x0, &y0) &&
        page_view_point(v, between(e, t1), &x1, &y1) && hypot(x1 - x0, y1 - y0) > 0) {
        double d = steps * STEP / hypot(x1 - x0, y1 - y0);
        for (int s = 0; s < 10; s++) { /* by less as well: what is next to it may be thinner than a step */
            const double side = (s & 1 ? d : -d) * ldexp(1, 3 * (s / 2 - 4));
            page_view_shift(v, e, -side * (y1 - y0), side * (x1 - x0), moved[s & 1]);
            r->moved(r->ref, family, line, k, moved[s & 1], &part);
            spans_subtract(visible, &part, &keep);
            spans_copy(&keep, visible);
            spans_intersect(hidden, &part, &keep);
            spans_copy(&keep, hidden);
        }
        r->doubled(r->ref, family, line, k, moved[0], moved[1], &part);
        spans_subtract(visible, &part, &keep);
        spans_copy(&keep, visible);
    }
    spans_free(&part);
    spans_free(&either);
    spans_free(&keep);
}

/* The same for edge k of a line, in the line's parameter; an edge that does not exist is hidden. */
static void robust(const line_t *l, int k, double steps, spans_t *visible, spans_t *hidden) {
    spans_t v = {0}, h = {0};
    spans_clear(visible);
    spans_clear(hidden);
    if (l->r->exists(l->r->ref, l->family, l->index, k)) {
        judge_edge(l->r, l->v, l->family, l->index, k, steps, &v, &h);
        add_shifted(visible, &v, k);
        add_shifted(hidden, &h, k);
    } else {
        spans_add(hidden, k, k + 1);
    }
    spans_free(&v);
    spans_free(&h);
}

/* What of `bad` is alone on the page. The page is looked at only if there is more than a run of `most` mm. Returns the
 * longest run that was. */
static double keep_alone(const line_t *l, spans_t *bad, bool is_false, double most) {
    double worst = most;
    spans_t keep = {0}, covered = {0};
    longest(l, bad, &worst, NULL);
    if (!l->ink || worst <= most) return 0;
    judge_page_fill(l->ink, l->r, l->v, l->piece, l->pieces);
    judge_page_alone(l->r, l->v, l->family, l->index, bad, is_false ? &l->ink->seen : &l->ink->drawn, &keep);
    worst = 0;
    spans_subtract(bad, &keep, &covered);
    longest(l, &covered, &worst, NULL);
    spans_copy(&keep, bad);
    spans_free(&keep);
    spans_free(&covered);
    return worst;
}

/* Of the raw errors `bad`, what remains when each edge is asked again with a step's tolerance, and then the page.
 * Returns the longest run that the page explained. */
static double forgive(const line_t *l, const spans_t *bad, bool is_false, spans_t *out) {
    spans_t here = {0}, part = {0}, visible = {0}, hidden = {0}, keep = {0};
    spans_clear(out);
    for (int k = 0; k < l->edges; k++) {
        spans_clear(&here);
        spans_add(&here, k, k + 1);
        spans_intersect(bad, &here, &part);
        if (total(l, &part) < 1e-3 * STEP) continue;
        robust(l, k, 1, &visible, &hidden);
        spans_intersect(&part, is_false ? &hidden : &visible, &keep);
        add_shifted(out, &keep, 0);
    }
    spans_tidy(out);
    const double beside = keep_alone(l, out, is_false, STEP);
    spans_free(&here);
    spans_free(&part);
    spans_free(&visible);
    spans_free(&hidden);
    spans_free(&keep);
    return beside;
}

/* Does the line stay on the page from a to b? What leaves it may come back anywhere. */
static bool is_on_page(const line_t *l, long double a, long double b) {
    for (size_t i = 0; i < l->page.n; i++)
        if (l->page.s[i].a <= a && b <= l->page.s[i].b) return true;
    return false;
}

/* s with gaps and then intervals shorter than a quarter step taken out: where ink ends for the eye. */
static void smooth(const line_t *l, const spans_t *s, spans_t *out) {
    spans_clear(out);
    for (size_t i = 0; i < s->n; i++) {
        if (out->n && is_on_page(l, out->s[out->n - 1].b, s->s[i].a) &&
            length(l, out->s[out->n - 1].b, s->s[i].a) < CLOSE_ENOUGH * STEP)
            out->s[out->n - 1].b = s->s[i].b;
        else
            spans_add(out, s->s[i].a, s->s[i].b);
    }
    size_t k = 0;
    for (size_t i = 0; i < out->n; i++)
        if (length(l, out->s[i].a, out->s[i].b) >= CLOSE_ENOUGH * STEP) out->s[k++] = out->s[i];
    out->n = k;
}

/* Is t, within d steps along the line, neither surely visible nor surely hidden under moves of d steps? */
static bool explained(const line_t *l, long double t, double d) {
    spans_t visible = {0}, hidden = {0};
    bool found = false;
    for (int k = (int)t - 1; k <= (int)t + 1 && !found; k++) {
        if (k < 0 || k >= l->edges) continue;
        robust(l, k, d, &visible, &hidden);
        add_shifted(&visible, &hidden, 0);
        spans_tidy(&visible);
        spans_complement(&visible, k, k + 1, &hidden);
        for (size_t i = 0; i < hidden.n && !found; i++) {
            long double a = hidden.s[i].a, b = hidden.s[i].b;
            found = t < a ? length(l, t, a) <= d * STEP : t > b ? length(l, b, t) <= d * STEP : true;
        }
    }
    spans_free(&visible);
    spans_free(&hidden);
    return found;
}

/* The next ends of intervals of s, before and after t, if they are nearer than those that are there. */
static void next_ends(const spans_t *s, long double t, long double *before, long double *after) {
    for (size_t i = 0; i < s->n; i++)
        for (int k = 0; k < 2; k++) {
            long double e = k ? s->s[i].b : s->s[i].a;
            if (e <= t)
                *before = fmaxl(*before, e);
            else
                *after = fminl(*after, e);
        }
}

/* Steps along the line from t to the nearest end of an interval of s. */
static double along(const line_t *l, const spans_t *s, long double t) {
    long double before = -INFINITY, after = INFINITY;
    next_ends(s, t, &before, &after);
    double d = isfinite(before) ? length(l, before, t) : INFINITY;
    return fmin(d, isfinite(after) ? length(l, t, after) : INFINITY) / STEP;
}

/* Between t and the next ends of what is seen, before and after: the longest run in which the drawing is wrong and the
 * page shows it, in steps. */
static double displaced(const line_t *l, const spans_t *seen, long double t) {
    long double before = 0, after = l->edges;
    spans_t around = {0}, bad = {0}, part = {0};
    double worst = 0;
    next_ends(seen, t, &before, &after);
    spans_add(&around, before, after);
    for (int is_false = 0; is_false < 2; is_false++) {
        if (is_false) {
            spans_intersect(&l->hidden, &l->drawn, &bad);
        } else {
            spans_subtract(&l->visible, &l->drawn, &bad);
        }
        spans_intersect(&bad, &around, &part);
        keep_alone(l, &part, is_false, 0);
        longest(l, &part, &worst, NULL);
    }
    spans_free(&around);
    spans_free(&bad);
    spans_free(&part);
    return worst / STEP;
}

static double end_error(const line_t *l, const spans_t *seen, long double t) {
    for (size_t i = 0; i < l->tied.n; i++)
        if (t >= l->tied.s[i].a && t <= l->tied.s[i].b) return 0;
    double best = fmin(along(l, seen, t), along(l, &l->tied, t));
    for (double d = CLOSE_ENOUGH; d < 3 && best > d; d *= 2)
        if (explained(l, t, d)) best = d;
    if (l->ink && best > CLOSE_ENOUGH) best = fmin(best, displaced(l, seen, t));
    return best;
}

static void check_ends(const line_t *l, judge_report_t *out) {
    spans_t seen = {0}, ink = {0}, drawn = {0};
    spans_intersect(&l->drawn, &l->page, &ink);
    smooth(l, &ink, &drawn);
    smooth(l, &l->visible, &seen);
    for (size_t i = 0; i < drawn.n; i++)
        for (int s = 0; s < 2; s++) {
            long double t = s ? drawn.s[i].b : drawn.s[i].a;
            double d = seen.n ? end_error(l, &seen, t) : 0; /* nothing to see at all is false ink, not a wrong end */
            if (d <= out->end_steps) continue;
            out->end_steps = d;
            out->end = (judge_spot_t){l->family, l->index, (double)t, (double)t};
        }
    spans_free(&seen);
    spans_free(&ink);
    spans_free(&drawn);
}

static void judge_line(line_t *l, judge_report_t *out) {
    spans_t bad = {0}, worse = {0};
    look_at_line(l);
    out->visible_mm += total(l, &l->visible);
    out->ink_mm += total(l, &l->drawn);
    spans_subtract(&l->visible, &l->drawn, &bad);
    longest(l, &bad, &out->raw_missing_mm, NULL);
    out->beside_mm = fmax(out->beside_mm, forgive(l, &bad, false, &worse));
    longest(l, &worse, &out->missing_mm, &out->missing);
    spans_intersect(&l->hidden, &l->drawn, &bad);
    longest(l, &bad, &out->raw_false_mm, NULL);
    out->beside_mm = fmax(out->beside_mm, forgive(l, &bad, true, &worse));
    longest(l, &worse, &out->false_mm, &out->falsely);
    check_ends(l, out);
    spans_free(&bad);
    spans_free(&worse);
}

/* Fills l->drawn from the pieces of this line and measures what they draw twice. */
static void take_pieces(line_t *l, const judge_piece_t *piece, size_t n, judge_report_t *out) {
    for (size_t i = 0; i < n; i++) {
        for (size_t j = 0; j < i; j++) {
            double a = fmax(piece[i].from, piece[j].from), b = fmin(piece[i].to, piece[j].to);
            if (a < b) out->twice_mm = fmax(out->twice_mm, length(l, a, b));
        }
        spans_add(&l->drawn, piece[i].from, piece[i].to);
    }
    spans_tidy(&l->drawn);
}

static int by_line(const void *p, const void *q) {
    const judge_piece_t *a = p, *b = q;
    if (a->family != b->family) return a->family - b->family;
    if (a->line != b->line) return a->line - b->line;
    return (a->from > b->from) - (a->from < b->from);
}

static bool is_on_a_line(const judge_subject_t *r, const judge_piece_t *p) {
    return p->family >= 0 && p->family < 2 && p->line >= 0 && p->line < r->lines(r->ref, p->family) && p->from >= 0 &&
           p->from <= p->to && p->to <= r->edges(r->ref, p->family, p->line);
}

int judge_pieces(const judge_subject_t *r, const page_view_t *v, const judge_piece_t *piece, size_t n,
                 judge_report_t *out) {
    *out = (judge_report_t){0};
    for (size_t i = 0; i < n; i++)
        if (!is_on_a_line(r, &piece[i])) return -1;
    judge_piece_t *sorted = malloc((n + 1) * sizeof *sorted);
    if (!sorted) abort();
    if (n) memcpy(sorted, piece, n * sizeof *sorted);
    qsort(sorted, n, sizeof *sorted, by_line);
    size_t at = 0;
    judge_page_t ink = {0};
    for (int family = 0; family < 2; family++) {
        int lines = r->lines(r->ref, family);
        for (int index = 0; index < lines; index++) {
            int edges = r->edges(r->ref, family, index);
            line_t l = {.r = r, .v = v, .family = family, .index = index, .edges = edges, .piece = sorted, .pieces = n};
            if (r->every == 0) l.ink = &ink;
            size_t first = at;
            while (at < n && sorted[at].family == family && sorted[at].line == index) at++;
            if (r->every > 0 && (index + family) % r->every != r->every / 2) continue;
            take_pieces(&l, sorted + first, at - first, out);
            judge_line(&l, out);
            spans_free(&l.page);
            spans_free(&l.hidden);
            spans_free(&l.visible);
            spans_free(&l.tied);
            spans_free(&l.drawn);
        }
    }
    judge_page_free(&ink);
    free(sorted);
    return 0;
}

void judge_worst(judge_report_t *all, const judge_report_t *one) {
    if (one->missing_mm > all->missing_mm) all->missing_mm = one->missing_mm, all->missing = one->missing;
    if (one->false_mm > all->false_mm) all->false_mm = one->false_mm, all->falsely = one->falsely;
    if (one->end_steps > all->end_steps) all->end_steps = one->end_steps, all->end = one->end;
    all->raw_missing_mm = fmax(all->raw_missing_mm, one->raw_missing_mm);
    all->raw_false_mm = fmax(all->raw_false_mm, one->raw_false_mm);
    all->beside_mm = fmax(all->beside_mm, one->beside_mm);
    all->twice_mm = fmax(all->twice_mm, one->twice_mm);
    all->moved_steps = fmax(all->moved_steps, one->moved_steps);
    all->ink_mm += one->ink_mm;
    all->visible_mm += one->visible_mm;
}
