/* test_strips.c - a surface hidden strip by strip has the ink that it has as a whole: the same intervals of the same
 * lines, in a part of the memory. What passes from one strip into the next goes on there. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>
#include <math.h>

#include "error.h"
#include "tests/oracle/run_cases.h"

/* Of a cell. An edge that is cut has its ends at 2^-30 of its way in the chart; in space that is more where one end is
 * much farther away than the other. */
#define JOINED 1e-6
#define ENDS 1e-4

static int by_line(const void *a, const void *b) {
    const judge_piece_t *p = a, *q = b;
    if (p->family != q->family) return p->family < q->family ? -1 : 1;
    if (p->line != q->line) return p->line < q->line ? -1 : 1;
    return (p->from > q->from) - (p->from < q->from);
}

/* Sorted, what touches joined, what is nothing left out. */
static void normalise(run_drawing_t *d) {
    size_t n = 0;
    if (d->n) qsort(d->piece, d->n, sizeof *d->piece, by_line);
    for (size_t k = 0; k < d->n; k++) {
        judge_piece_t *p = &d->piece[k], *last = n ? &d->piece[n - 1] : NULL;
        if (last && last->family == p->family && last->line == p->line && last->to >= p->from - JOINED)
            last->to = fmax(last->to, p->to);
        else if (p->to - p->from > ENDS)
            d->piece[n++] = *p;
    }
    d->n = n;
}

/* How far the ends of two drawings are apart at most, if they have the same intervals; otherwise more than ENDS. */
static double compare(const run_drawing_t *a, const run_drawing_t *b) {
    double most = 0;
    if (a->n != b->n) return 1;
    for (size_t k = 0; k < a->n; k++) {
        const judge_piece_t *p = &a->piece[k], *q = &b->piece[k];
        if (p->family != q->family || p->line != q->line) return 1;
        most = fmax(most, fmax(fabs(p->from - q->from), fabs(p->to - q->to)));
    }
    return most;
}

static void test_same_ink(void **state) {
    (void)state;
    int64_t pieces = 0, whole = 0, part = 0;
    double most = 0;
    cases_t judged = {.name = "strips", .program = "test_strips"};
    uint64_t first = cases_first(8000, 3000);
    for (uint64_t seed = first; seed < first + cases_scaled(3000); seed++) {
        scene_t s;
        run_drawing_t a = {0}, b = {0};
        hidden_stats_t together, strips;
        scene_random(&s, seed, 16, false);
        run_strips.ends = 0;
        int err = run_perimeter(&s, &a, &together);
        run_strips.ends = (uint16_t)(seed * 0x9e3779b97f4a7c15u >> 48 | HIDDEN_TWO_STRIPS);
        assert_int_equal(run_perimeter(&s, &b, &strips), err);
        normalise(&a);
        normalise(&b);
        const double off = compare(&a, &b);
        if (off <= ENDS)
            most = fmax(most, off);
        else /* lines that fall together may be drawn or not */
            assert_true(cases_surface(&judged, &s, seed, true));
        run_strips.ends = 0;
        assert_int_equal(together.facets, strips.facets);
        assert_int_equal(together.edges, strips.edges);
        pieces += (int64_t)a.n;
        whole += together.peak_upper + together.peak_lower;
        part += strips.peak_upper + strips.peak_lower;
        run_drawing_free(&a);
        run_drawing_free(&b);
        scene_free(&s);
    }
    print_message(
        "# strips: %lld visible runs, the same, ends within %.2g of a cell, but in %lld scenes, which were judged;"
        " horizons %.2f of the whole ones\n",
        (long long)pieces, most, (long long)judged.run, (double)part / (double)whole);
}

/* As a board does it: a trial divides the strips until they fit into less memory than the whole needs; drawn with those
 * in the same memory, it is the same ink. */
static void test_divided(void **state) {
    (void)state;
    int64_t drawn = 0, divided = 0, refused = 0, judged = 0;
    uint64_t first = cases_first(16000, 1000);
    for (uint64_t seed = first; seed < first + cases_scaled(1000); seed++) {
        scene_t s;
        run_drawing_t a = {0}, trial = {0}, b = {0};
        hidden_stats_t whole, stats;
        cases_t cases = {.name = "divided", .program = "test_strips"};
        scene_random(&s, seed, 24, false);
        run_strips = (hidden_strips_t){0, false};
        if (run_perimeter(&s, &a, &whole) == 0) {
            const size_t bytes = whole.bytes - whole.bytes / (3 + seed % 8);
            run_strips = (hidden_strips_t){HIDDEN_TWO_STRIPS, true};
            int err = run_perimeter_in(&s, &trial, bytes, &stats);
            if (err) assert_int_equal(err, ERR_FULL);
            refused += err != 0;
            if (!err) {
                run_strips.divide = false;
                assert_int_equal(run_perimeter_in(&s, &b, bytes, &stats), 0);
                assert_int_equal(stats.edges, whole.edges);
                divided += stats.strips > 2;
                drawn++;
                normalise(&a);
                normalise(&b);
                if (compare(&a, &b) > ENDS) {
                    assert_true(cases_surface(&cases, &s, seed, true));
                    judged++;
                }
            }
        }
        run_strips.ends = 0;
        run_drawing_free(&a);
        run_drawing_free(&trial);
        run_drawing_free(&b);
        scene_free(&s);
    }
    assert_true(divided > 0);
    print_message(
        "# strips: %lld scenes in 2/3 to 9/10 of the memory, %lld in more than two strips, %lld refused; %lld judged\n",
        (long long)drawn, (long long)divided, (long long)refused, (long long)judged);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_same_ink), cmocka_unit_test(test_divided)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
