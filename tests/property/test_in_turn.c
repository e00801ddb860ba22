/* test_in_turn.c - one horizon after the other draws what both together draw: the same intervals of the same lines, in
 * about half the memory. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>
#include <math.h>

#include "error.h"
#include "tests/oracle/run_cases.h"

static int by_line(const void *a, const void *b) {
    const judge_piece_t *p = a, *q = b;
    if (p->family != q->family) return p->family < q->family ? -1 : 1;
    if (p->line != q->line) return p->line < q->line ? -1 : 1;
    return (p->from > q->from) - (p->from < q->from);
}

/* Sorted, and what touches joined; what overlaps as well, for of two horizons that all but coincide either may show a
 * part, and one sweep does not know what the other drew. */
static void normalise(run_drawing_t *d) {
    size_t n = 0;
    if (d->n) qsort(d->piece, d->n, sizeof *d->piece, by_line);
    for (size_t k = 0; k < d->n; k++) {
        judge_piece_t *p = &d->piece[k], *last = n ? &d->piece[n - 1] : NULL;
        if (last && last->family == p->family && last->line == p->line && last->to >= p->from)
            last->to = fmax(last->to, p->to);
        else
            d->piece[n++] = *p;
    }
    d->n = n;
}

static void test_same_ink(void **state) {
    (void)state;
    int64_t pieces = 0, both = 0, turns = 0;
    uint64_t first = cases_first(8000, 3000);
    for (uint64_t seed = first; seed < first + cases_scaled(3000); seed++) {
        scene_t s;
        run_drawing_t a = {0}, b = {0};
        hidden_stats_t together, apart;
        scene_random(&s, seed, 16, false);
        run_in_turn = false;
        int err = run_perimeter(&s, &a, &together);
        run_in_turn = true;
        assert_int_equal(run_perimeter(&s, &b, &apart), err);
        run_in_turn = false;
        normalise(&a);
        normalise(&b);
        if (a.n != b.n) fail_msg("seed %llu: %zu runs together, %zu apart", (unsigned long long)seed, a.n, b.n);
        for (size_t k = 0; k < a.n; k++) {
            if (by_line(&a.piece[k], &b.piece[k]) || a.piece[k].to != b.piece[k].to)
                fail_msg("seed %llu: family %d line %d differs", (unsigned long long)seed, a.piece[k].family,
                         a.piece[k].line);
        }
        pieces += (int64_t)a.n;
        if (together.peak_upper && together.peak_lower) {
            assert_int_equal(together.peak_upper, apart.peak_upper);
            assert_int_equal(together.peak_lower, apart.peak_lower);
            assert_int_equal(together.facets, apart.facets);
            both += (int64_t)together.bytes;
            turns += (int64_t)apart.bytes;
        }
        run_drawing_free(&a);
        run_drawing_free(&b);
        scene_free(&s);
    }
    print_message("# in turn: %lld visible runs, the same; memory %.2f of both together\n", (long long)pieces,
                  (double)turns / (double)both);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_same_ink)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
