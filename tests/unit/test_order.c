/* Pairing of ends, opening of closed strokes, and the order of strokes. */
#include "path/dist.h"
#include "path/loop.h"
#include "path/tour.h"
#include "path_scene.h"
#include <math.h>

#define CELL 409600 /* lat: 1000 steps */
#define CAP 20000
#define NEAR 102

static uint32_t memory[POOL_BYTES(CAP) / 4];
static pool_t pool;
static flat_t flat = {CELL, 0};
static const ink_map_t map = {&flat, flat_point};
static chain_t chain;
static tour_t tour;

static void start(int32_t cap) {
    pool = (pool_t){.cap = cap};
    pool.run = (run_t *)(void *)memory;
    pool.mate = (int32_t *)(void *)(pool.run + cap + 1);
    pool.work = (uint32_t *)(void *)(pool.mate + 2 * (cap + 1));
}

static void add(uint8_t family, int32_t line, double from, double to) {
    ink_piece_t p = {family, 0, line, (int64_t)(from * (double)ink_one(family)),
                     (int64_t)(to * (double)ink_one(family))};
    pool.run[pool.n++] = run_pack(&p);
}

/* The runs of the stroke with the free end e; as many are on the way back, too. */
static int32_t runs_of_stroke(int32_t e) {
    for (int32_t n = 1;; n++, e = pool.mate[e]) {
        assert_true(n <= pool.n);
        e ^= 1;
        if (pool.mate[e] < 0) return n;
    }
}

/* Pairs, opens, and returns the number of strokes. */
static int32_t strokes(void) {
    assert_int_equal(chain_place(&chain, &pool, &map, NEAR), 0);
    chain_pair(&chain);
    const int32_t open = chain_close(&chain);
    int32_t free_ends = 0, reached = 0;
    if (loop_find(&chain)) loop_open(&chain);
    for (int32_t e = 0; e < 2 * pool.n; e++) {
        int32_t m = pool.mate[e];
        assert_int_equal(m >= 0 ? pool.mate[m] : ~pool.mate[~m], e);
        free_ends += m < 0;
        if (m < 0) reached += runs_of_stroke(e);
    }
    assert_int_equal(reached, 2 * pool.n);
    assert_true(free_ends % 2 == 0 && free_ends >= 2 * open);
    return free_ends / 2;
}

static void add_square(int32_t left, int32_t bottom) {
    add(INK_ROW, bottom, left, left + 2);
    add(INK_ROW, bottom + 2, left, left + 2);
    add(INK_COL, left, bottom, bottom + 2);
    add(INK_COL, left + 2, bottom, bottom + 2);
}

static void packing_keeps_everything(void **state) {
    const ink_piece_t p = {INK_SEGMENT, RUN_SURFACES - 1, -RUN_LINE_LIMIT, RUN_T_LIMIT - 12345678901, RUN_T_LIMIT - 1};
    (void)state;
    run_t r = run_pack(&p);
    assert_int_equal(run_family(&r), p.family);
    assert_int_equal(run_surface(&r), p.surface);
    assert_int_equal(run_line(&r), p.line);
    assert_int_equal(run_t_of(&r, 0), p.from);
    assert_int_equal(run_t_of(&r, 1), p.to);
    r.to_hi |= RUN_SEEN | RUN_DRAWN;
    run_set_t(&r, 0, 77);
    run_set_t(&r, 1, RUN_T_LIMIT - 2);
    assert_int_equal(run_t_of(&r, 0), 77);
    assert_int_equal(run_t_of(&r, 1), RUN_T_LIMIT - 2);
    assert_int_equal(run_family(&r), p.family);
    assert_true(r.to_hi & RUN_SEEN);
}

static void distances_are_as_good_as_stated(void **state) {
    uint32_t seed = 1;
    double worst = 0, worst_small = 0;
    (void)state;
    for (int i = 0; i < 2000000; i++) {
        int32_t dx = (int32_t)(next_random(&seed) >> (next_random(&seed) % 31 + 1));
        int32_t dy = -(int32_t)(next_random(&seed) >> (next_random(&seed) % 31 + 1));
        double exact = hypot(dx, dy), e = fabs(dist_of(dx, dy) - exact) - 1;
        assert_true(e <= exact / 8000);
        if (exact > 1e5 && e / exact > worst) worst = e / exact;
        if (exact < 100 && e > worst_small) worst_small = e;
    }
    assert_int_equal(dist_of(0, 0), 0);
    assert_int_equal(dist_of(-7, 0), 7);
    print_message("# dist: worst error 1 part in %.0f\n", 1 / worst);
}

static void straight_on_before_turning(void **state) {
    /* four runs end at node (2, 2): they go straight on; and a corner at (5, 5) turns */
    (void)state;
    start(16);
    add(INK_ROW, 2, 0, 2);
    add(INK_COL, 2, 2, 4);
    add(INK_ROW, 2, 2, 4);
    add(INK_COL, 2, 0, 2);
    add(INK_ROW, 5, 3, 5);
    add(INK_COL, 5, 5, 7);
    assert_int_equal(strokes(), 3);
    assert_int_equal(pool.mate[1], 4);
    assert_int_equal(pool.mate[7], 2);
    assert_int_equal(pool.mate[9], 10);
}

static void three_ends_leave_the_odd_one_out(void **state) {
    (void)state;
    start(16);
    add(INK_COL, 2, 0, 2);
    add(INK_ROW, 2, 0, 2);
    add(INK_ROW, 2, 2, 4);
    assert_int_equal(strokes(), 2);
    assert_int_equal(pool.mate[3], 4);
}

static void ends_within_a_quarter_step_meet(void **state) {
    const double cell = CELL;
    (void)state;
    start(16);
    add(INK_ROW, 2, 0, 2);
    add(INK_ROW, 2, 2 + 100 / cell, 4);
    add(INK_ROW, 3, 0, 2);
    add(INK_ROW, 3, 2 + 104 / cell, 4);
    assert_int_equal(strokes(), 3);
}

/* The frame and all lines of an n x n grid: Euler's minimum is 2 (n - 2), and the frame is closed. */
static void a_grid_needs_no_stroke_for_its_frame(void **state) {
    (void)state;
    for (int n = 2; n < 40; n += n < 5 ? 1 : 7) {
        start(CAP);
        for (int i = 0; i < n; i++) {
            add(INK_ROW, i, 0, n - 1);
            add(INK_COL, i, 0, n - 1);
        }
        assert_int_equal(strokes(), n == 2 ? 1 : 2 * (n - 2));
    }
}

static void closed_strokes_share_a_corner(void **state) {
    /* a small square whose corner is in the middle of a line, between that line's ends: stays alone; another on a free
     * end */
    (void)state;
    start(16);
    add(INK_ROW, 0, 0, 4);
    add(INK_ROW, 0 + 2, 4, 6);
    add(INK_ROW, 4, 4, 6);
    add(INK_COL, 4, 2, 4);
    add(INK_COL, 6, 2, 4);
    assert_int_equal(strokes(), 2);
    start(16);
    add(INK_ROW, 3, 0, 4); /* ends in the middle of the square's left side */
    add(INK_ROW, 2, 4, 6);
    add(INK_ROW, 4, 4, 6);
    add(INK_COL, 4, 2, 4);
    add(INK_COL, 6, 2, 4);
    assert_int_equal(strokes(), 1);
    assert_int_equal(pool.n, 6); /* that side was cut */
    start(5);                    /* no room to cut it: still right, a stroke more */
    add(INK_ROW, 3, 0, 4);
    add(INK_ROW, 2, 4, 6);
    add(INK_ROW, 4, 4, 6);
    add(INK_COL, 4, 2, 4);
    add(INK_COL, 6, 2, 4);
    assert_int_equal(strokes(), 2);
}

/* Length of the tour over page points, home to home. */
static double travel(const page_point_t at) {
    double sum = 0;
    page_point_t p = at, q;
    for (int32_t k = 0; k < tour.n; k++) {
        int32_t e = tour_stroke(&tour, &pool, k);
        pool_end_point(&pool, &map, e, &q);
        sum += hypot((double)p.x_lat - q.x_lat, (double)p.y_lat - q.y_lat);
        pool_end_point(&pool, &map, ~pool.mate[e], &p);
    }
    return sum + hypot((double)p.x_lat - at.x_lat, (double)p.y_lat - at.y_lat);
}

static void check_permutation(void) {
    static bool seen[2 * CAP];
    memset(seen, 0, sizeof seen);
    for (int32_t k = 0; k < tour.n; k++) {
        int32_t e = tour_stroke(&tour, &pool, k), first = e < ~pool.mate[e] ? e : ~pool.mate[e];
        assert_true(pool.mate[e] < 0);
        assert_false(seen[first]);
        seen[first] = true;
    }
}

static void random_strokes(int n) {
    uint32_t seed = 99;
    start(CAP);
    for (int i = 0; i < n; i++) {
        double across = next_random(&seed) % 1000 / 16.0, length = 0.1 + next_random(&seed) % 100 / 50.0;
        add(INK_ROW, (int32_t)(next_random(&seed) % 64), across, across + length);
    }
    strokes();
    tour_collect(&tour, &chain, (page_point_t){0, 0}, (page_point_t){0, 0});
}

static void order_is_a_permutation_and_improves(void **state) {
    const page_point_t home = {0, 0};
    (void)state;
    for (int n = 0; n <= 2000; n = n < 12 ? n + 1 : 4 * n) {
        random_strokes(n);
        tour_greedy(&tour);
        tour_settle(&tour);
        check_permutation();
        double greedy = travel(home), before = greedy;
        for (int64_t effort = 10; effort <= 1000; effort *= 10) {
            random_strokes(n);
            tour_greedy(&tour);
            tour_improve(&tour, effort * n);
            tour_settle(&tour);
            check_permutation();
            double now = travel(home);
            assert_true(now <= before + 1e-4 * greedy + n * 4096.0); /* spots are that coarse */
            before = now;
        }
        if (n > 700)
            print_message("# order: %d random strokes, greedy %.0f mm, improved %.0f\n", (int)tour.n,
                          greedy / LAT_PER_MM, before / LAT_PER_MM);
    }
}

/* Few strokes: against every order and direction. */
static double best_of_all(page_point_t at, unsigned left, double sum, double best) {
    if (sum >= best) return best;
    if (!left) return fmin(best, sum + hypot(at.x_lat, at.y_lat));
    for (int32_t k = 0; k < tour.n; k++) {
        if (!(left >> k & 1)) continue;
        for (int side = 0; side < 2; side++) {
            page_point_t a, b;
            int32_t e = tour.end[k] & ~TOUR_QUIET, f = ~pool.mate[e];
            pool_end_point(&pool, &map, side ? f : e, &a);
            pool_end_point(&pool, &map, side ? e : f, &b);
            double d = hypot((double)at.x_lat - a.x_lat, (double)at.y_lat - a.y_lat);
            best = best_of_all(b, left & ~(1u << k), sum + d, best);
        }
    }
    return best;
}

static void few_strokes_are_ordered_nearly_best(void **state) {
    uint32_t seed = 5;
    double excess = 0, most = 0;
    (void)state;
    for (int round = 0; round < 40; round++) {
        start(CAP);
        for (int i = 0; i < 7; i++) {
            double across = next_random(&seed) % 100 / 10.0, length = 0.1 + next_random(&seed) % 100 / 20.0;
            add(i & 1 ? INK_ROW : INK_COL, (int32_t)(next_random(&seed) % 16), across, across + length);
        }
        strokes();
        tour_collect(&tour, &chain, (page_point_t){0, 0}, (page_point_t){0, 0});
        tour_greedy(&tour);
        tour_improve(&tour, 100000);
        tour_settle(&tour);
        double is = travel((page_point_t){0, 0});
        double best = best_of_all((page_point_t){0, 0}, (1u << tour.n) - 1, 0, 1e300);
        excess += is / best - 1;
        if (is / best - 1 > most) most = is / best - 1;
    }
    assert_true(excess / 40 < 0.03);
    print_message("# order: 7 strokes, 40 cases: %.2f %% above the best order, at most %.1f %%\n", 100 * excess / 40,
                  100 * most);
}

static void a_line_between_two_closed_strokes_is_none(void **state) {
    (void)state;
    start(16);
    add_square(0, 2);
    add_square(6, 2);
    add(INK_ROW, 3, 2, 6); /* both its ends are taken, before it is come to */
    assert_int_equal(strokes(), 1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(packing_keeps_everything),
        cmocka_unit_test(distances_are_as_good_as_stated),
        cmocka_unit_test(straight_on_before_turning),
        cmocka_unit_test(three_ends_leave_the_odd_one_out),
        cmocka_unit_test(ends_within_a_quarter_step_meet),
        cmocka_unit_test(a_grid_needs_no_stroke_for_its_frame),
        cmocka_unit_test(closed_strokes_share_a_corner),
        cmocka_unit_test(a_line_between_two_closed_strokes_is_none),
        cmocka_unit_test(order_is_a_permutation_and_improves),
        cmocka_unit_test(few_strokes_are_ordered_nearly_best),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
