/* clip_judge.c - see clip_judge.h. */
#include "tests/oracle/clip_judge.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "poly/clip_inner.h"
#include "tests/oracle/slab_area.h"

#define MOST CLIP_SHAPE_MOST

const enum clip_result clip_judge_table[6] = {CLIP_INSIDE, CLIP_OUTSIDE, CLIP_REST, CLIP_UNION, CLIP_XOR, CLIP_SUBJECT};

clip_shape_t clip_judge_result[6];
static clip_shape_t once_more;
static uint64_t memory[1 << 17];

void clip_shape_clear(clip_shape_t *s) {
    s->out = (clip_out_t){s->v, s->end, s->outer, 0, MOST, 0, MOST};
    s->poly = (poly_t){s->v, s->end, 0};
}

void clip_shape_add(clip_shape_t *s, int32_t x, int32_t y) {
    if (s->out.n == MOST) abort();
    s->v[s->out.n] = (poly_vertex_t){{x, y}, s->out.n};
    s->out.n++;
}

void clip_shape_close(clip_shape_t *s) {
    s->end[s->out.contours++] = s->out.n;
    s->poly.contours = s->out.contours;
}

/* |dx| + |dy| of all edges: splitting never makes it longer, cancelling makes it shorter. */
static int64_t way(const poly_t *p) {
    int64_t sum = 0;
    for (int c = 0, first = 0; c < p->contours; first = p->end[c++])
        for (int i = first; i < p->end[c]; i++) {
            poly_point_t a = p->v[i].at, b = p->v[i + 1 < p->end[c] ? i + 1 : first].at;
            sum += llabs((int64_t)b.x - a.x) + llabs((int64_t)b.y - a.y);
        }
    return sum;
}

static int run(const poly_t *s, const poly_t *c, enum clip_fill fill, enum clip_result a, enum clip_result b,
               clip_shape_t *to_a, clip_shape_t *to_b, clip_t *work) {
    const clip_job_t job = {*s, *c, fill, {a, b}};
    int err = clip_run(work, &job, memory, sizeof memory);
    clip_shape_t *to[2] = {to_a, to_b};
    for (int k = 0; k < 2 && !err; k++) {
        if (!to[k]) continue;
        clip_shape_clear(to[k]);
        err = clip_trace(work, k, &to[k]->out);
        to[k]->poly.contours = to[k]->out.contours;
    }
    return err;
}

/* Do collinear edges share more than a point? */
static bool overlap(poly_point_t a, poly_point_t b, poly_point_t c, poly_point_t d) {
    poly_point_t l1 = poly_before(a, b) ? a : b, r1 = poly_before(a, b) ? b : a;
    poly_point_t l2 = poly_before(c, d) ? c : d, r2 = poly_before(c, d) ? d : c;
    return poly_before(l1, r2) && poly_before(l2, r1);
}

/* Do no two edges cross or overlap, and has no edge length zero? */
static bool is_planar(const poly_t *p) {
    int n = poly_vertices(p);
    poly_point_t *a = malloc((size_t)(n + 1) * sizeof *a), *b = malloc((size_t)(n + 1) * sizeof *b);
    bool good = a && b;
    for (int c = 0, first = 0; c < p->contours; first = p->end[c++])
        for (int i = first; i < p->end[c]; i++) {
            a[i] = p->v[i].at;
            b[i] = p->v[i + 1 < p->end[c] ? i + 1 : first].at;
        }
    for (int i = 0; i < n && good; i++) {
        if (poly_same(a[i], b[i])) good = false;
        for (int j = 0; j < i && good; j++) {
            int64_t o1 = poly_orient(a[i], b[i], a[j]), o2 = poly_orient(a[i], b[i], b[j]);
            int64_t o3 = poly_orient(a[j], b[j], a[i]), o4 = poly_orient(a[j], b[j], b[i]);
            if (((o1 > 0 && o2 < 0) || (o1 < 0 && o2 > 0)) && ((o3 > 0 && o4 < 0) || (o3 < 0 && o4 > 0))) good = false;
            if (o1 == 0 && o2 == 0 && overlap(a[i], b[i], a[j], b[j])) good = false;
        }
    }
    free(a);
    free(b);
    return good;
}

/* Outer contours turn left, holes right; a hole's area plus that of the others of its outer contour leaves some. */
static bool are_holes_right(const clip_shape_t *s, clip_account_t *account) {
    for (int k = 0; k < s->out.contours; k++) {
        int first = k ? s->end[k - 1] : 0;
        const int32_t end = s->end[k] - first;
        poly_t one = {s->v + first, &end, 1};
        int64_t area = poly_area2(&one);
        account->contours++;
        if (s->outer[k] < 0) {
            if (area <= 0) return false;
            continue;
        }
        account->holes++;
        if (area >= 0 || s->outer[k] >= k || s->outer[s->outer[k]] >= 0) return false;
        /* Every vertex of it is in or on the outer contour: no area of the hole is outside. */
        int o = s->outer[k], from = o ? s->end[o - 1] : 0;
        const int32_t length = s->end[o] - from;
        poly_t outer = {s->v + from, &length, 1};
        clip_t work;
        clip_shape_t *left = &once_more;
        if (run(&one, &outer, CLIP_EVEN_ODD, CLIP_OUTSIDE, CLIP_NOTHING, left, NULL, &work)) return false;
        if (left->out.contours) return false;
    }
    return true;
}

static bool differs(unsigned in, const void *ctx) {
    unsigned table = *(const unsigned *)ctx;
    return (table >> (in & 3) & 1) != (in >> 2 & 1);
}

double clip_judge_off(const clip_shape_t *subject, const clip_shape_t *clip, enum clip_fill fill, int k, bool exact) {
    const slab_scene_t s = {{&subject->poly, &clip->poly, &clip_judge_result[k].poly},
                            {fill == CLIP_NONZERO, fill == CLIP_NONZERO, false},
                            3};
    const unsigned table = clip_judge_table[k];
    return exact ? slab_area_exact(&s, differs, &table) : slab_area(&s, differs, &table);
}

const char *clip_judge(const clip_shape_t *subject, const clip_shape_t *clip, enum clip_fill fill, bool exact,
                       clip_account_t *account) {
    clip_shape_t *const result = clip_judge_result;
    clip_t work;
    int64_t area[6];
    double borders = slab_border(&subject->poly) + slab_border(&clip->poly);
    int sweeps = 0;
    for (int k = 0; k < 6; k += 2)
        if (run(&subject->poly, &clip->poly, fill, clip_judge_table[k], clip_judge_table[k + 1], &result[k],
                &result[k + 1], &work))
            return "error";
    sweeps = work.stats.sweeps;
    for (int k = 0; k < 6; k++) {
        if (!is_planar(&result[k].poly)) return "edges of a result cross";
        if (!are_holes_right(&result[k], account)) return "a hole is in the wrong contour";
        if (way(&result[k].poly) > way(&subject->poly) + way(&clip->poly)) return "borders have become longer";
        area[k] = poly_area2(&result[k].poly);
    }
    account->pairs++;
    account->rounded += work.stats.crossings;
    account->sweeps += sweeps;
    if (sweeps > account->most_sweeps) account->most_sweeps = sweeps;
    if (area[0] + area[1] != area[5]) return "inside and outside are not the subject";
    if (area[1] + area[2] != area[4]) return "outside and rest are not the exclusive or";
    if (area[0] + area[4] != area[3]) return "inside and exclusive or are not the union";
    for (int k = 0; k < 6; k++) {
        const double off = clip_judge_off(subject, clip, fill, k, exact);
        if (exact) account->exact++;
        if (off > 1e-9 * borders * borders && work.stats.crossings == 0) return "not the exact result without rounding";
        if (off > .5 * sqrt(2) * borders * (sweeps - 1) + 1e-9 * borders * borders)
            return "further off than rounding is";
        if (borders > 0 && off / borders > account->worst) account->worst = off / borders;
    }
    /* A result is a planar graph already: clipped with itself or alone nothing is rounded and nothing changes. */
    for (int k = 0; k < 6; k++) {
        if (run(&result[k].poly, &result[k].poly, CLIP_EVEN_ODD, CLIP_INSIDE, CLIP_OUTSIDE, &once_more, NULL, &work))
            return "error";
        if (work.stats.sweeps != 1 || poly_area2(&once_more.poly) != area[k])
            return "a result changes when clipped again";
        if (once_more.out.n != result[k].out.n ||
            memcmp(once_more.v, result[k].v, (size_t)once_more.out.n * sizeof once_more.v[0]))
            return "a result's vertices change when clipped again";
    }
    return NULL;
}

void clip_shape_print(const char *name, const clip_shape_t *s) {
    printf("#   %s:", name);
    for (int c = 0, first = 0; c < s->poly.contours; first = s->end[c++]) {
        printf(" (");
        for (int i = first; i < s->end[c]; i++) printf("%d,%d ", s->v[i].at.x, s->v[i].at.y);
        printf(")");
    }
    printf("\n");
}
