/* Pairing of very many ends by their places (path/meet.h): as many strokes as by the buckets of path/chain.h, and what
 * the links say holds together. */
#include "path/loop.h"
#include "path/meet.h"
#include "path_scene.h"

#define CELL 409600 /* lat */
#define SIDE 220
#define MOST (2 * SIDE * SIDE)
#define CAP (3 * MOST)
#define NEAR 102

static pool_t pool;
static flat_t flat;
static const ink_map_t map = {&flat, flat_point};
static chain_t chain;
static places_t places;
static const page_point_t HOME = {0, 0};

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

static void start(int32_t cap) {
    pool = (pool_t){.cap = cap, .run = pool.run};
    pool.mate = pool_own_mate(&pool);
    pool.work = (uint32_t *)(void *)(pool.mate + 2 * (cap + 1));
}

static void add(uint8_t family, int32_t line, double from, double to) {
    const ink_piece_t p = {family, 0, line, (int64_t)(from * (double)ink_one(family)),
                           (int64_t)(to * (double)ink_one(family))};
    pool.run[pool.n++] = run_pack(&p);
}

/* Edges of a grid, so many in 256 of them, some cut short, and longer ones. */
static void edges(uint32_t most, uint32_t cut) {
    uint32_t seed = most + 1;
    for (int32_t j = 0; j < SIDE; j++) {
        for (int32_t i = 0; i < SIDE; i++) {
            for (uint8_t family = INK_ROW; family <= INK_COL; family++) {
                const uint32_t dice = next_random(&seed);
                const double from = i + (dice >> 8 & 255 ? 0 : 0.3), to = i + (dice >> 16 & 255) / 256.0;
                if ((dice & 255) < most) add(family, j, from, (dice >> 24) < cut && to > from ? to : i + 1);
            }
        }
    }
}

/* Squares, each closed, many of which touch the next: they are opened where others end. */
static void squares(void) {
    for (int32_t j = 0; j + 1 < SIDE; j += 2) {
        for (int32_t i = 0; i + 1 < SIDE; i += 2) {
            const double wide = i % 3 ? 1 : 2;
            add(INK_ROW, j, i, i + wide);
            add(INK_ROW, j + 1, i, i + wide);
            add(INK_COL, i, j, j + 1);
            add(INK_COL, i + (int32_t)wide, j, j + 1);
            if (j % 5 == 0) add(INK_ROW, j + 1, i + 0.5, i + 0.75);
            if (j % 7 == 0) add(INK_COL, i + 1, j, j + 0.5);
            add(INK_ROW, j, i + 0.3, i + 0.31);
        }
    }
}

/* Everything within a few steps. */
static void crowd(void) {
    uint32_t seed = 5;
    while (pool.n < MOST) {
        const double from = next_random(&seed) % 1000 / 1000.0;
        add(INK_ROW, (int32_t)(next_random(&seed) % 16), from, from + next_random(&seed) % 1000 / 500.0);
    }
}

/* Do the links hold together? Counts the free ends. */
static int32_t free_ends(void) {
    int32_t free_ends = 0, reached = 0;
    for (int32_t e = 0; e < 2 * pool.n; e++) {
        const int32_t m = pool.mate[e];
        assert_int_equal(m >= 0 ? pool.mate[m] : ~pool.mate[~m], e);
        if (m >= 0) continue;
        free_ends++;
        int32_t f = e;
        for (reached++; pool.mate[f ^ 1] >= 0; reached++) f = pool.mate[f ^ 1];
        assert_int_equal(f ^ 1, ~m);
    }
    assert_int_equal(reached, 2 * pool.n); /* no stroke is closed any more */
    return free_ends;
}

/* Are the places of free ends, and only they, not marked? */
static void check_places(void) {
    int32_t open = 0;
    for (int32_t k = 0; k < places.now.n; k++) {
        const place_t at = places.now.place[k];
        if (places_is_marked(places.now.spot[k])) continue;
        assert_int_equal(places.now.place[at.tip].tip, k);
        if (at.end < places.pen) assert_int_equal(~pool.mate[at.end], places.now.place[at.tip].end);
        open++;
    }
    assert_int_equal(open, 2 * places.strokes + 2);
}

static int compare_points(const void *a, const void *b) {
    return memcmp(a, b, sizeof(page_point_t));
}

/* How many strokes could be joined to another that ends in the very same point? */
static int32_t left_apart(void) {
    page_point_t *p = malloc(sizeof *p * 2 * (size_t)pool.n);
    int32_t n = 0, apart = 0;
    for (int32_t e = 0; e < 2 * pool.n; e++) {
        if (pool.mate[e] < 0 && ~pool.mate[e] != (e ^ 1)) p[n++] = chain.point[e];
    }
    qsort(p, (size_t)n, sizeof *p, compare_points);
    for (int32_t k = 0; k + 1 < n; k++) {
        if (compare_points(&p[k], &p[k + 1]) != 0) continue;
        apart++;
        k++;
    }
    free(p);
    return apart;
}

typedef struct layout {
    const char *name;
    uint32_t most, cut;
    int32_t cell_lat;
} layout_t;

static void fill(const layout_t *l, int32_t cap) {
    flat = (flat_t){l->cell_lat, 0};
    start(cap);
    if (l->most)
        edges(l->most, l->cut);
    else if (l->cut)
        squares();
    else
        crowd();
    while (pool.n < CHAIN_MANY) add(INK_ROW, 0, 0, 1);
    assert_int_equal(chain_place(&chain, &pool, &map, NEAR), 0);
}

static void there_are_as_many_strokes_as_by_buckets(void **state) {
    static const layout_t LAYOUT[] = {
        {"grid", 256, 0, CELL},        {"cut short", 240, 64, CELL},   {"cut shorter", 256, 200, CELL},
        {"very small", 256, 128, 512}, {"smaller yet", 250, 128, 128}, {"squares", 0, 1, CELL},
        {"crowd", 0, 0, CELL},
    };
    (void)state;
    for (size_t k = 0; k < sizeof LAYOUT / sizeof LAYOUT[0]; k++) {
        fill(&LAYOUT[k], CAP);
        const int32_t runs = pool.n;
        assert_true(places_sort(&places, &chain, HOME, HOME, 410));
        meet_pair(&places);
        const int32_t ends = free_ends(), apart = left_apart();
        check_places();
        assert_int_equal(ends, 2 * places.strokes);

        fill(&LAYOUT[k], runs + runs / 8);
        assert_null(chain.plain);
        chain_pair(&chain);
        chain_close(&chain);
        if (loop_find(&chain)) loop_open(&chain);
        const int32_t strokes = free_ends() / 2;
        print_message("# meet: %d runs, %s: %d strokes, %d by buckets; %d and %d end in one point\n", (int)runs,
                      LAYOUT[k].name, (int)(ends / 2), (int)strokes, (int)apart, (int)left_apart());
        assert_true(ends / 2 <= strokes + strokes / 200 + 1);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(there_are_as_many_strokes_as_by_buckets)};
    return cmocka_run_group_tests(tests, make, drop);
}
