/* The kernels in less memory than they need: every size from nothing to enough must end in ERR_FULL or in the right
 * drawing, and never touch a byte that was not lent. Run with `make asan` this is also the test of their bounds. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "error.h"
#include "tests/oracle/run_cases.h"

/* Windows lie in other lists where there is little memory, are joined in another order, and so are rounded otherwise.
 */
static bool same(const run_drawing_t *a, const run_drawing_t *b) {
    bool equal = a->n == b->n;
    for (size_t k = 0; k < a->n && equal; k++) {
        const judge_piece_t *p = &a->piece[k], *q = &b->piece[k];
        equal = p->family == q->family && p->line == q->line && fabs(p->from - q->from) < 0x1p-24 &&
                fabs(p->to - q->to) < 0x1p-24;
    }
    return equal;
}

static void test_perimeter(void **state) {
    (void)state;
    int64_t full = 0, drawn = 0, least = 0, needed = 0;
    const uint64_t count = cases_scaled(40), first = cases_first(6000, count);
    for (uint64_t seed = first; seed < first + count; seed++) {
        scene_t s;
        run_drawing_t reference = {0};
        hidden_stats_t stats;
        scene_random(&s, seed, 14, seed & 1);
        int err = run_perimeter(&s, &reference, &stats);
        size_t enough = stats.bytes;
        size_t step = enough / 40 / 8 * 8 + 8;
        if (err == ERR_EMPTY)
            enough = 0;
        else
            assert_int_equal(err, 0);
        bool worked = false;
        for (size_t bytes = 0; bytes < 4 * enough && !worked; bytes += step) {
            run_drawing_t d = {0};
            err = run_perimeter_in(&s, &d, bytes, &stats);
            if (err) assert_int_equal(err, ERR_FULL);
            full += err == ERR_FULL;
            if (err == 0) {
                worked = true;
                drawn++;
                least += (int64_t)bytes;
                needed += (int64_t)enough;
                assert_true(same(&d, &reference));
            }
            run_drawing_free(&d);
        }
        assert_true(worked || enough == 0);
        run_drawing_free(&reference);
        scene_free(&s);
    }
    print_message("# memory: %lld drawings in the least memory that does, %lld sizes refused; %.2f of what was used "
                  "with plenty\n",
                  (long long)drawn, (long long)full, (double)least / (double)needed);
}

/* Larger surfaces, with memory for what is known of the horizons (lowest.h) and without: the same pieces. */
static void test_lowest(void **state) {
    (void)state;
    int64_t facets = 0, pieces = 0;
    int without = 0;
    const uint64_t count = cases_scaled(150), first = cases_first(7000, count);
    for (uint64_t seed = first; seed < first + count; seed++) {
        scene_t s;
        run_drawing_t plenty = {0}, little = {0};
        hidden_stats_t stats, small;
        scene_random(&s, seed, 60, false);
        int err = run_perimeter(&s, &plenty, &stats);
        if (err == 0) {
            size_t bytes = stats.bytes - stats.bytes / 8; /* some of it was for that */
            while ((err = run_perimeter_in(&s, &little, bytes, &small)) == ERR_FULL) {
                run_drawing_free(&little);
                little = (run_drawing_t){0};
                bytes += bytes / 16;
            }
            assert_int_equal(err, 0);
            without += small.bytes < stats.bytes;
            assert_int_equal(little.n, plenty.n);
            for (size_t k = 0; k < plenty.n; k++)
                assert_memory_equal(&little.piece[k], &plenty.piece[k], sizeof *plenty.piece);
            facets += stats.facets;
            pieces += (int64_t)plenty.n;
        }
        run_drawing_free(&little);
        run_drawing_free(&plenty);
        scene_free(&s);
    }
    assert_true(without > 0);
    print_message("# memory: %d surfaces of %lld facets with less to remember horizons in, the same %lld pieces\n",
                  without, (long long)facets, (long long)pieces);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_perimeter), cmocka_unit_test(test_lowest)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
