/* The census and the sort: "alone" is never said of an end with a neighbour; sorting only changes the order. */
#include "path/census.h"
#include "path/sort.h"
#include "path_scene.h"
#include <stdlib.h>

static page_point_t somewhere(uint32_t *seed, int32_t across) {
    int32_t x = (int32_t)(next_random(seed) % (uint32_t)across) - across / 2;
    return (page_point_t){x, (int32_t)(next_random(seed) % (uint32_t)across) - across / 2};
}

static bool is_near(page_point_t a, page_point_t b, int32_t near_lat) {
    int64_t dx = (int64_t)a.x_lat - b.x_lat, dy = (int64_t)a.y_lat - b.y_lat;
    return dx * dx + dy * dy <= (int64_t)near_lat * near_lat;
}

static void nobody_with_a_neighbour_is_alone(void **state) {
    enum { ENDS = 600 };
    (void)state;
    uint32_t seed = 7;
    static const int32_t across[] = {1, 2000, 40000, 1 << 20};
    int64_t alone = 0, lonely = 0;
    for (int round = 0; round < 40; round++) {
        static page_point_t p[ENDS];
        static uint32_t mem[ENDS * 8];
        census_t c;
        size_t bytes = round % 3 == 0 ? CENSUS_BYTES_MIN : sizeof mem;
        census_init(&c, mem, bytes, ENDS, 10);
        for (int i = 0; i < ENDS; i++) {
            p[i] = somewhere(&seed, across[round % 4]);
            /* every other one close to the one before, at about the distance that counts */
            if (i & 1 && round < 20)
                p[i] = (page_point_t){p[i - 1].x_lat + (int32_t)(next_random(&seed) % 200), p[i - 1].y_lat};
            census_enter(&c, p[i]);
        }
        for (int i = 0; i < ENDS; i++) {
            bool has = false;
            for (int k = 0; k < ENDS; k++) has = has || (k != i && is_near(p[i], p[k], 102));
            bool said = census_is_alone(&c, p[i], 102);
            assert_false(has && said);
            if (round >= 20 && round % 4 == 3 && round % 3 != 0) alone += said, lonely += !has;
        }
    }
    printf("# census: %d of %d ends without a neighbour are known to be alone\n", (int)alone, (int)lonely);
    assert_true(alone * 10 > lonely * 6); /* the rest have somebody in their cell, or theirs is shared */
}

static int by_line(const void *a, const void *b) {
    return run_line(a) - run_line(b);
}

static void sorting_keeps_every_run_with_its_points(void **state) {
    enum { RUNS = 20000 };
    (void)state;
    for (int32_t n = SORT_RUNS_MIN - 1; n <= RUNS; n += RUNS - SORT_RUNS_MIN + 1) {
        uint32_t seed = 3;
        pool_t pool = {.n = n, .cap = n};
        pool.run = malloc((size_t)n * sizeof(run_t));
        page_point_t *point = malloc((size_t)n * 2 * sizeof *point);
        uint32_t *work = malloc((size_t)n * 8);
        for (int32_t r = 0; r < n; r++) {
            pool.run[r] = run_pack(&(ink_piece_t){.line = r, .from = (int64_t)r * 3});
            point[2 * r] = somewhere(&seed, 1 << 24);
            point[2 * r + 1] = (page_point_t){point[2 * r].x_lat + r, r};
        }
        sort_runs(&pool, point, work);
        int64_t steps = 0;
        for (int32_t r = 0; r < n; r++) {
            assert_int_equal(pool.run[r].from_lo, (uint32_t)run_line(&pool.run[r]) * 3);
            assert_int_equal(point[2 * r + 1].y_lat, run_line(&pool.run[r]));
            assert_int_equal(point[2 * r + 1].x_lat, point[2 * r].x_lat + run_line(&pool.run[r]));
            if (r && is_near(point[2 * r], point[2 * r - 2], 1 << 19)) steps++;
        }
        if (n < SORT_RUNS_MIN) {
            for (int32_t r = 0; r < n; r++) assert_int_equal(run_line(&pool.run[r]), r);
        } else {
            assert_true(steps > n / 2); /* most are within a thirtieth of the page of the one before */
        }
        qsort(pool.run, (size_t)n, sizeof(run_t), by_line);
        for (int32_t r = 0; r < n; r++) assert_int_equal(run_line(&pool.run[r]), r);
        free(pool.run);
        free(point);
        free(work);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nobody_with_a_neighbour_is_alone),
        cmocka_unit_test(sorting_keeps_every_run_with_its_points),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
