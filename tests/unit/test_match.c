/* The order of very many strokes (path/match.h): all of them once, and as near as on the walk to the nearest end. */
#include "path/loop.h"
#include "path/match.h"
#include "path/meet.h"
#include "path/tour.h"
#include "path_scene.h"
#include <math.h>
#include <stdlib.h>

#define CELL 409600 /* lat */
#define RUNS 80000
#define CAP (3 * RUNS)
#define NEAR 102

static pool_t pool;
static flat_t flat = {CELL, 0};
static const ink_map_t map = {&flat, flat_point};
static chain_t chain;
static places_t places;
static const page_point_t HOME = {0, 0}, AT = {CELL, 7 * CELL};

typedef enum layout { SCATTERED, IN_A_ROW, CROWDED } layout_t;

static int make(void **state) {
    void *mem = malloc(POOL_BYTES(CAP));
    pool.run = mem;
    *state = mem;
    return mem ? 0 : -1;
}
static int drop(void **state) {
    free(*state);
    return 0;
}

static void fill(layout_t layout, int32_t cap) {
    uint32_t seed = 7;
    pool = (pool_t){.cap = cap, .run = pool.run};
    pool.mate = (int32_t *)(void *)(pool.run + cap + 1);
    pool.work = (uint32_t *)(void *)(pool.mate + 2 * (cap + 1));
    for (int i = 0; i < RUNS; i++) {
        const bool crowd = layout == CROWDED && i % 8; /* so many in few of the grid's cells */
        const uint32_t line = layout == IN_A_ROW ? 500
                              : crowd            ? 500 + next_random(&seed) % 60
                                                 : next_random(&seed) % 1000;
        const double across = (double)next_random(&seed) / 4294967296.0,
                     from = crowd ? 500 + 8 * across : 1000 * across;
        const double length = 0.01 + next_random(&seed) % 1000 / (crowd ? 5000.0 : 500.0);
        const ink_piece_t p = {INK_ROW, 0, (int32_t)line, (int64_t)(from * (double)ink_one(INK_ROW)),
                               (int64_t)((from + length) * (double)ink_one(INK_ROW))};
        pool.run[pool.n++] = run_pack(&p);
    }
    assert_int_equal(chain_place(&chain, &pool, &map, NEAR), 0);
    if (!places_sort(&places, &chain, AT, HOME, 0)) return;
    meet_pair(&places);
}

static double distance(page_point_t a, page_point_t b) {
    return hypot((double)a.x_lat - b.x_lat, (double)a.y_lat - b.y_lat) / LAT_PER_MM;
}

/* Goes along the order; every run is passed once. Returns the travel between strokes. */
static double go(const int32_t *order, int32_t strokes) {
    static bool passed[RUNS * 2];
    page_point_t at = AT;
    double sum = 0;
    int32_t runs = 0;
    memset(passed, 0, sizeof passed);
    for (int32_t k = 0; k < strokes; k++) {
        int32_t e = order[k];
        assert_true(pool.mate[e] < 0);
        sum += distance(at, chain.point[e]);
        for (;;) {
            assert_false(passed[e >> 1]);
            passed[e >> 1] = true;
            runs++;
            e = pool_other_end(e);
            if (pool.mate[e] < 0) break;
            e = pool.mate[e];
        }
        at = chain.point[e];
    }
    assert_int_equal(runs, pool.n);
    return sum + distance(at, HOME);
}

static double walk(void) {
    tour_t tour;
    tour_collect(&tour, &chain, AT, HOME);
    tour_greedy(&tour);
    int32_t *order = malloc(sizeof *order * (size_t)tour.n);
    for (int32_t k = 0; k < tour.n; k++) order[k] = tour_stroke(&tour, &pool, k);
    const double sum = go(order, tour.n);
    free(order);
    return sum;
}

static void all_strokes_are_passed_once(void **state) {
    static const char *const NAME[] = {"scattered", "in a row", "crowded"};
    (void)state;
    for (layout_t layout = SCATTERED; layout <= CROWDED; layout++) {
        fill(layout, CAP);
        const double walked = walk();
        fill(layout, CAP);
        tour_t tour;
        assert_true(match_order(&places, &tour));
        int32_t *order = tour.order, winding = 0;
        const int32_t strokes = tour.n;
        for (int32_t k = 0; k < strokes; k++) {
            const bool plain = order[k] & TOUR_PLAIN;
            order[k] &= ~TOUR_PLAIN;
            if (!plain) assert_int_equal(tour.winding[winding++], k);
            const run_t *r = &pool.run[order[k] >> 1];
            assert_true(plain == (pool.mate[pool_other_end(order[k])] < 0 &&
                                  ink_next(INK_ROW, run_t_of(r, 0), run_t_of(r, 1)) == run_t_of(r, 1)));
        }
        assert_int_equal(tour.windings, winding);
        const double matched = go(order, strokes);
        print_message("# match: %d strokes %s: %.0f mm, %.0f by the walk to the nearest\n", (int)strokes, NAME[layout],
                      matched, walked);
        assert_true(matched < 1.05 * walked);
    }
}

static void without_memory_it_is_left_to_others(void **state) {
    (void)state;
    fill(SCATTERED, RUNS + RUNS / 4);
    assert_false(places_sort(&places, &chain, AT, HOME, 0));
    chain_pair(&chain);
    chain_close(&chain);
    if (loop_find(&chain)) loop_open(&chain);
    assert_true(walk() > 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_strokes_are_passed_once),
        cmocka_unit_test(without_memory_it_is_left_to_others),
    };
    return cmocka_run_group_tests(tests, make, drop);
}
