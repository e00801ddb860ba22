/* Pieces that wait come out as they went in, in their order; one more than fits is refused. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "error.h"
#include "path/waiting.h"

typedef struct taken {
    ink_piece_t piece[16];
    int n, most;
} taken_t;

static int take(void *ctx, const ink_piece_t *piece) {
    taken_t *t = ctx;
    if (t->n == t->most) return ERR_STOPPED;
    t->piece[t->n++] = *piece;
    return 0;
}

static void pieces_wait_for_a_pause(void **state) {
    (void)state;
    run_t run[3];
    taken_t t = {.most = 16};
    waiting_t w = {.run = run, .cap = 3, .next = {&t, take}};
    const ink_sink_t sink = waiting_sink(&w);
    const ink_piece_t in[3] = {{INK_ROW, 0, 7, 5, ((int64_t)1 << 61) + 3},
                               {INK_COL, 31, (1 << 25) - 1, 0, INK_GRID_ONE},
                               {INK_PROFILE, 2, 0, INK_ONE, 2 * INK_ONE}};
    for (int round = 0; round < 2; round++) {
        assert_false(w.some);
        for (int k = 0; k < 3; k++) assert_int_equal(sink.piece(sink.ctx, &in[k]), 0);
        assert_true(w.some);
        assert_int_equal(t.n, 3 * round);
        assert_int_equal(sink.piece(sink.ctx, &in[0]), ERR_FULL);
        assert_int_equal(waiting_pause(&w), 0);
        for (int k = 0; k < 3; k++) {
            const ink_piece_t *out = &t.piece[3 * round + k];
            assert_int_equal(out->family, in[k].family);
            assert_int_equal(out->surface, in[k].surface);
            assert_int_equal(out->line, in[k].line);
            assert_true(out->from == in[k].from && out->to == in[k].to);
        }
    }
}

static void errors_go_on(void **state) {
    (void)state;
    run_t run[2];
    taken_t t = {.most = 1};
    waiting_t w = {.run = run, .cap = 2, .next = {&t, take}};
    const ink_sink_t sink = waiting_sink(&w);
    const ink_piece_t piece = {INK_ROW, 0, 0, 0, 1}, wrong = {INK_ROW, 0, 0, 2, 1};
    assert_int_equal(sink.piece(sink.ctx, &wrong), ERR_VALUE);
    assert_int_equal(sink.piece(sink.ctx, &piece), 0);
    assert_int_equal(sink.piece(sink.ctx, &piece), 0);
    assert_int_equal(waiting_pause(&w), ERR_STOPPED);
    assert_int_equal(t.n, 1);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(pieces_wait_for_a_pause), cmocka_unit_test(errors_go_on)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
