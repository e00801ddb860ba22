/* stepgen.h: pieces to edges, one by one. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include <stdbool.h>

#include "motion/stepgen.h"
#include "sim/sim.h"

#define LOG_MAX 4096
#define PULSE 32
#define WIDTH (PULSE + HAL_EDGE_GAP - 1)
#define SETUP 16
#define EARLY (SETUP + 16) /* DIR before its step */

typedef struct entry {
    uint64_t tick;
    uint32_t pins, changed;
} entry_t;

static entry_t entries[LOG_MAX];
static size_t logged;
static uint64_t origin; /* what expect() counts from */
static stepgen_piece_t queue[8];

static void record(void *ctx, uint64_t tick, uint32_t pins, uint32_t changed) {
    (void)ctx;
    assert_true(logged < LOG_MAX);
    entries[logged++] = (entry_t){tick, pins, changed};
}

static int begin(void **state) {
    (void)state;
    sim_reset();
    stepgen_halt(false); /* motors off */
    stepgen_init(queue, 8, PULSE, SETUP);
    sim_record(record, NULL);
    logged = 0;
    return 0;
}

static stepgen_axis_piece_t steps(uint32_t first, uint32_t interval, int32_t add, uint32_t count, bool forward) {
    return (stepgen_axis_piece_t){(uint64_t)first << 32, (uint64_t)interval << 32, (int64_t)add * ((int64_t)1 << 32),
                                  count, forward};
}

static void push(stepgen_axis_piece_t a, stepgen_axis_piece_t b, uint32_t length, bool rest) {
    stepgen_piece_t *p = stepgen_slot();
    assert_non_null(p);
    *p = (stepgen_piece_t){.axis = {a, b}, .length = length, .rest = rest};
    stepgen_push();
}

static void run(void) {
    stepgen_start();
    while (!stepgen_idle()) hal_idle();
}

/* Entry i is taken to be at this tick of the pieces' time. */
static void count_from(size_t i, uint64_t tick) {
    assert_true(i < logged);
    origin = entries[i].tick - tick;
}

static void expect(size_t i, uint64_t tick, uint32_t changed, uint32_t value) {
    assert_true(i < logged);
    assert_int_equal(entries[i].tick - origin, tick);
    assert_int_equal(entries[i].changed, changed);
    assert_int_equal(entries[i].pins & changed, value);
}

static const stepgen_axis_piece_t NONE = {0};

static void test_one_motor(void **state) {
    (void)state;
    push(steps(1000, 500, 100, 3, true), NONE, 3000, true);
    run();
    assert_int_equal(logged, 7);
    count_from(1, 1000);
    expect(0, 1000 - EARLY, HAL_X_DIR, HAL_X_DIR);
    expect(1, 1000, HAL_X_STEP, HAL_X_STEP);
    expect(2, 1000 + WIDTH, HAL_X_STEP, 0);
    expect(3, 1500, HAL_X_STEP, HAL_X_STEP);
    expect(5, 2100, HAL_X_STEP, HAL_X_STEP);
    expect(6, 2100 + WIDTH, HAL_X_STEP, 0);
    assert_int_equal(stepgen_position(0), 3);
    assert_int_equal(stepgen_position(1), 0);
    assert_int_equal(stepgen_starved(), 0);
}

/* Fractions of ticks add up. */
static void test_fractions(void **state) {
    (void)state;
    stepgen_axis_piece_t a = steps(100, 100, 0, 5, true);
    a.interval_q32 += (uint64_t)1 << 31;
    push(a, NONE, 1000, true);
    run();
    count_from(1, 100);
    expect(3, 200, HAL_X_STEP, HAL_X_STEP);
    expect(5, 301, HAL_X_STEP, HAL_X_STEP);
    expect(7, 401, HAL_X_STEP, HAL_X_STEP);
    expect(9, 502, HAL_X_STEP, HAL_X_STEP);
}

/* Equal deadlines are one write; unequal ones are served in order whatever the motors. */
static void test_two_motors(void **state) {
    (void)state;
    push(steps(200, 300, 0, 2, true), steps(200, 310, 0, 2, true), 1000, true);
    run();
    count_from(1, 200);
    expect(0, 200 - EARLY, HAL_X_DIR | HAL_Y_DIR, HAL_X_DIR | HAL_Y_DIR);
    expect(1, 200, HAL_X_STEP | HAL_Y_STEP, HAL_X_STEP | HAL_Y_STEP);
    expect(2, 200 + WIDTH, HAL_X_STEP | HAL_Y_STEP, 0);
    expect(3, 500, HAL_X_STEP, HAL_X_STEP);
    expect(4, 510, HAL_Y_STEP, HAL_Y_STEP);
    expect(5, 500 + WIDTH, HAL_X_STEP, 0);
    expect(6, 510 + WIDTH, HAL_Y_STEP, 0);
    assert_int_equal(logged, 7);
}

/* DIR changes as long before the first step of the other direction as it has to, whatever came before. */
static void test_turning(void **state) {
    (void)state;
    push(steps(200, 0, 0, 1, true), NONE, 210, false);
    push(steps(100, 0, 0, 1, false), NONE, 1000, true);
    run();
    count_from(1, 200);
    expect(2, 200 + WIDTH, HAL_X_STEP, 0);
    expect(3, 310 - EARLY, HAL_X_DIR, 0);
    expect(4, 310, HAL_X_STEP, HAL_X_STEP);
    assert_int_equal(stepgen_position(0), 0);
}

/* Pen and enable change at the start of their piece, and steps of later pieces count from its end. */
static void test_pins(void **state) {
    (void)state;
    stepgen_piece_t *p = stepgen_slot();
    *p = (stepgen_piece_t){.length = 5000, .set_pins = true, .pins = HAL_ENABLE, .rest = true};
    stepgen_push();
    push(steps(100, 0, 0, 1, true), NONE, 400, false);
    p = stepgen_slot();
    *p = (stepgen_piece_t){.length = 700, .set_pins = true, .pins = HAL_PEN | HAL_ENABLE, .rest = true};
    stepgen_push();
    p = stepgen_slot();
    *p = (stepgen_piece_t){.length = 1, .set_pins = true, .pins = 0, .rest = true};
    stepgen_push();
    run();
    count_from(0, 0);
    expect(0, 0, HAL_ENABLE, HAL_ENABLE);
    expect(1, 5100 - EARLY, HAL_X_DIR, HAL_X_DIR);
    expect(2, 5100, HAL_X_STEP, HAL_X_STEP);
    expect(4, 5400, HAL_PEN, HAL_PEN);
    expect(5, 6100, HAL_PEN | HAL_ENABLE, 0);
    assert_int_equal(logged, 6);
    assert_int_equal(stepgen_starved(), 0);
}

/* Running dry between two rests is nothing, in motion or with the pen down it is counted. */
static void test_starving(void **state) {
    (void)state;
    push(steps(100, 0, 0, 1, true), NONE, 200, true);
    run();
    assert_int_equal(stepgen_starved(), 0);
    push(steps(100, 0, 0, 1, true), NONE, 200, false);
    run();
    assert_int_equal(stepgen_starved(), 1);
    push(steps(100, 0, 0, 1, true), NONE, 200, true);
    run();
    assert_int_equal(stepgen_position(0), 3);
    assert_int_equal(stepgen_starved(), 1);
}

static void test_queue_full(void **state) {
    (void)state;
    for (int i = 0; i < 8; i++) push(steps(100, 100, 0, 2, true), NONE, 300, i == 7);
    assert_null(stepgen_slot());
    stepgen_start();
    hal_idle(); /* takes the first */
    assert_non_null(stepgen_slot());
    run();
    assert_int_equal(stepgen_position(0), 16);
    for (size_t i = 1; i < logged; i++) assert_true(entries[i].tick > entries[i - 1].tick);
}

/* Delivered late at every deadline in turn: widths, set-up and the count of steps stay right. */
static void test_late_at_every_deadline(void **state) {
    for (uint32_t at = 1; at < 40; at++)
        for (uint32_t by = 1; by < 2000; by = by * 3 + 1) {
            begin(state);
            push(steps(200, 120, 0, 4, true), steps(230, 90, 5, 5, true), 700, false);
            push(steps(100, 150, 0, 3, false), steps(60, 90, 0, 4, true), 500, true);
            stepgen_start();
            for (uint32_t k = 1; !stepgen_idle(); k++) {
                sim_inject_late(k == at, by);
                hal_idle();
            }
            assert_int_equal(stepgen_position(0), 1);
            assert_int_equal(stepgen_position(1), 9);
            uint64_t rise[2] = {0, 0}, turned[2] = {0, 0};
            for (size_t i = 0; i < logged; i++)
                for (int m = 0; m < 2; m++) {
                    uint32_t step = m ? HAL_Y_STEP : HAL_X_STEP, dir = m ? HAL_Y_DIR : HAL_X_DIR;
                    if (entries[i].changed & dir) turned[m] = entries[i].tick;
                    if (!(entries[i].changed & step)) continue;
                    if (entries[i].pins & step) {
                        assert_true(entries[i].tick - turned[m] >= 16);
                        assert_true(!rise[m] || entries[i].tick - rise[m] >= 64);
                        rise[m] = entries[i].tick;
                    } else {
                        assert_true(entries[i].tick - rise[m] >= PULSE);
                    }
                }
        }
}

static uint32_t seed;
static uint32_t below(uint32_t n) {
    seed = seed * 1664525u + 1013904223u;
    return (uint32_t)(((uint64_t)seed * n) >> 32);
}

static stepgen_axis_piece_t any_steps(uint32_t length) {
    if (below(6) == 0) return NONE;
    const uint32_t interval = 70 + below(below(4) ? 300 : 3000), n = 1 + below(length / (interval + 8));
    stepgen_axis_piece_t a = steps(64 + below(100), interval, 0, n, below(4));
    a.first_q32 += below(1u << 31);
    a.interval_q32 += below(1u << 31);
    a.add_q32 = (int64_t)((uint64_t)below(1u << 31) << 3) / (n + 1);
    return a;
}

static void flip_hold(void *ctx) {
    (void)ctx;
    if (stepgen_holding())
        stepgen_resume();
    else
        stepgen_hold();
}

/* The same random pieces, held and resumed now and then. */
static void run_random(void **state, uint32_t with, bool ahead) {
    static stepgen_piece_t long_queue[64];
    begin(state);
    stepgen_init(long_queue, 64, PULSE, SETUP);
    sim_play_ahead(ahead);
    seed = with;
    for (int i = 0; i < 3; i++) sim_at(20000 + below(100000), flip_hold, NULL);
    sim_at(200000, flip_hold, NULL);
    for (int i = 0; i < 40; i++) {
        const bool fast = i % 20 > 2 && i % 20 < 18;
        const uint32_t length = 500 + below(8000);
        stepgen_piece_t *p = stepgen_slot();
        *p = (stepgen_piece_t){.axis = {any_steps(length), any_steps(length)}, .length = length, .rest = i == 39};
        p->speed = fast ? 3000 : 100;
        if (below(8) == 0) {
            p->set_pins = true;
            p->pins = HAL_ENABLE | (below(2) ? HAL_PEN : 0);
        }
        stepgen_push();
    }
    run();
}

/* Whether edges are made one by one or many in one go, they are the same, to the tick. */
static void test_ahead(void **state) {
    static entry_t one_by_one[LOG_MAX];
    size_t all = 0;
    for (uint32_t k = 1; k < 300; k++) {
        run_random(state, k, false);
        const size_t n = logged;
        memcpy(one_by_one, entries, n * sizeof *entries);
        for (size_t i = 1; i < n; i++)
            if (entries[i].tick - entries[i - 1].tick < HAL_EDGE_GAP) fail_msg("seed %u, edge %zu: too close", k, i);
        run_random(state, k, true);
        for (size_t i = 0; i < n && i < logged; i++)
            if (memcmp(&one_by_one[i], &entries[i], sizeof *entries) != 0) fail_msg("seed %u, edge %zu", k, i);
        assert_int_equal(n, logged);
        all += n;
    }
    printf("# %zu edges of random pieces with holds, made ahead and one by one: the same\n", all);
    sim_play_ahead(true);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_one_motor, begin),  cmocka_unit_test_setup(test_fractions, begin),
        cmocka_unit_test_setup(test_two_motors, begin), cmocka_unit_test_setup(test_turning, begin),
        cmocka_unit_test_setup(test_pins, begin),       cmocka_unit_test_setup(test_starving, begin),
        cmocka_unit_test_setup(test_queue_full, begin), cmocka_unit_test_setup(test_late_at_every_deadline, begin),
        cmocka_unit_test_setup(test_ahead, begin),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
