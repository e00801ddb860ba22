/* Do pieces become maximal runs, whatever the direction they come in? */
#include "path/join.h"
#include "path_scene.h"

#define CELL 40960 /* lat: 100 steps */
#define GAP 102

typedef struct runs {
    ink_piece_t p[4096];
    int n;
} runs_t;

static int keep(void *ctx, const ink_piece_t *p) {
    runs_t *r = ctx;
    assert_true(r->n < 4096);
    r->p[r->n++] = *p;
    return 0;
}

static flat_t flat = {CELL, 0};
static const ink_map_t map = {&flat, flat_point};
static runs_t got;
static uint64_t memory[JOIN_BYTES(64) / 8];
static join_t join;

static void start(uint32_t pairs) {
    got.n = 0;
    flat.asked = 0;
    join_init(&join, memory, pairs, GAP, &map, (ink_sink_t){&got, keep});
}

static void piece(uint8_t family, int32_t line, double from, double to) {
    ink_piece_t p = {family, 0, line, (int64_t)(from * (double)ink_one(family)),
                     (int64_t)(to * (double)ink_one(family))};
    assert_int_equal(join_piece(&join, &p), 0);
}

static void expect(int k, uint8_t family, int32_t line, double from, double to) {
    assert_true(k < got.n);
    assert_int_equal(got.p[k].family, family);
    assert_int_equal(got.p[k].line, line);
    assert_int_equal(got.p[k].from, (int64_t)(from * (double)ink_one(family)));
    assert_int_equal(got.p[k].to, (int64_t)(to * (double)ink_one(family)));
}

static void pieces_join_through_nodes(void **state) {
    (void)state;
    start(8);
    for (int i = 0; i < 20; i++) piece(INK_ROW, 3, i, i + 1);
    assert_int_equal(join_finish(&join), 0);
    assert_int_equal(got.n, 1);
    expect(0, INK_ROW, 3, 0, 20);
    assert_int_equal(flat.asked, 0); /* exact continuation needs no map */
}

static void both_directions_from_the_eye_join(void **state) {
    (void)state;
    start(8);
    for (int i = 0; i < 10; i++) {
        piece(INK_COL, 5, 10 + i, 11 + i);
        piece(INK_COL, 5, 9 - i, 10 - i);
    }
    assert_int_equal(join_finish(&join), 0);
    assert_int_equal(got.n, 1);
    expect(0, INK_COL, 5, 0, 20);
}

static void both_directions_grow_behind_a_gap(void **state) {
    (void)state;
    start(8);
    piece(INK_COL, 5, 10, 11);
    for (int i = 2; i < 10; i++) { /* hidden from 8 to 10 and from 11 to 12: two runs grow, taking turns */
        piece(INK_COL, 5, 10 + i, 11 + i);
        piece(INK_COL, 5, 9 - i, 10 - i);
    }
    assert_int_equal(join_finish(&join), 0);
    assert_int_equal(got.n, 3);
    expect(0, INK_COL, 5, 10, 11);
    expect(1, INK_COL, 5, 0, 8);
    expect(2, INK_COL, 5, 12, 20);
}

static void small_gaps_close_and_larger_ones_stay(void **state) {
    const double cell = CELL;
    (void)state;
    start(8);
    piece(INK_ROW, 0, 0, 1);
    piece(INK_ROW, 0, 1 + 100 / cell, 2);
    piece(INK_ROW, 0, 2 + 110 / cell, 3);
    assert_int_equal(join_finish(&join), 0);
    assert_int_equal(got.n, 2);
    expect(0, INK_ROW, 0, 0, 2);
    expect(1, INK_ROW, 0, 2 + 110 / cell, 3);
}

static void overlaps_are_drawn_once(void **state) {
    (void)state;
    start(8);
    piece(INK_ROW, 0, 4, 5.25);
    piece(INK_ROW, 0, 5, 6);
    piece(INK_ROW, 0, 3, 4.5);
    assert_int_equal(join_finish(&join), 0);
    assert_int_equal(got.n, 1);
    expect(0, INK_ROW, 0, 3, 6);
}

static void lines_and_families_are_kept_apart(void **state) {
    (void)state;
    start(4); /* fewer slots than lines: runs are cut, nothing is mixed up */
    for (int i = 0; i < 4; i++) {
        for (int line = 0; line < 16; line++) {
            piece(INK_COL, line, i, i + 1);
            piece(INK_PROFILE, line, i, i + 1);
        }
    }
    assert_int_equal(join_finish(&join), 0);
    assert_int_equal(got.n, 4 * 32);
    int64_t sum = 0;
    for (int k = 0; k < got.n; k++) sum += (got.p[k].to - got.p[k].from) >> ink_bits(got.p[k].family);
    assert_int_equal(sum, 4 * 32);
}

static void two_lines_share_a_pair(void **state) {
    (void)state;
    start(4);
    for (int i = 0; i < 5; i++) {
        for (int line = 0; line < 8; line++) piece(INK_COL, line, i, i + 1);
    }
    assert_int_equal(join_finish(&join), 0);
    assert_int_equal(got.n, 8);
}

/* Vertex 3 sticks out of the paper: as far as the map goes, the line leaves it and comes back at the same place. */
static bool spike_point(void *ctx, uint8_t family, uint8_t surface, int32_t line, int64_t t, page_point_t *p) {
    (void)ctx, (void)family, (void)surface, (void)line;
    int64_t off = t - 3 * INK_GRID_ONE;
    if (off < 0) off = -off;
    if (off < INK_GRID_ONE / 100) return false;
    *p = (page_point_t){0, -(int32_t)(off * CELL >> INK_GRID_BITS)};
    return true;
}

static void a_node_off_the_paper_keeps_its_gap(void **state) {
    (void)state;
    const ink_map_t spike = {NULL, spike_point};
    start(8);
    join.map = &spike;
    piece(INK_ROW, 1, 0, 2.98);
    piece(INK_ROW, 1, 3.02, 5);
    piece(INK_ROW, 1, 5.02, 6); /* no node in this gap, but too wide */
    assert_int_equal(join_finish(&join), 0);
    assert_int_equal(got.n, 3);
    expect(0, INK_ROW, 1, 0, 2.98);
    expect(1, INK_ROW, 1, 5.02, 6);
    expect(2, INK_ROW, 1, 3.02, 5);
}

static int refuse(void *ctx, const ink_piece_t *p) {
    (void)ctx;
    (void)p;
    return -4;
}

static void errors_of_the_sink_travel(void **state) {
    ink_piece_t p = {INK_ROW, 0, 0, 0, INK_GRID_ONE};
    (void)state;
    join_init(&join, memory, 1, GAP, &map, (ink_sink_t){NULL, refuse});
    assert_int_equal(join_piece(&join, &p), 0);
    assert_int_equal(join_finish(&join), -4);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pieces_join_through_nodes),
        cmocka_unit_test(both_directions_from_the_eye_join),
        cmocka_unit_test(both_directions_grow_behind_a_gap),
        cmocka_unit_test(small_gaps_close_and_larger_ones_stay),
        cmocka_unit_test(overlaps_are_drawn_once),
        cmocka_unit_test(lines_and_families_are_kept_apart),
        cmocka_unit_test(two_lines_share_a_pair),
        cmocka_unit_test(a_node_off_the_paper_keeps_its_gap),
        cmocka_unit_test(errors_of_the_sink_travel),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
