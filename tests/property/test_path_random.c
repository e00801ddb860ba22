/* Laws of the whole ink stage on random ink: what went in comes out, once, in at least Euler's number of strokes,
 * for every size of the pool. */
#include "../unit/path_scene.h"
#include "error.h"
#include "tests/oracle/run_cases.h"
#include <math.h>

#define UNITS 16  /* of ink to a cell */
#define UNIT 1024 /* lat; 2.5 steps, so that nothing is a dot and no gap closes */
#define SIDE_MAX 14
#define POINTS ((SIDE_MAX - 1) * UNITS + 1)

/* Ink as a bitmap: unit u of row (column) k is drawn. */
typedef struct ink {
    int nx, ny;
    uint8_t row[SIDE_MAX][POINTS], col[SIDE_MAX][POINTS];
} ink_t;

static uint32_t seed;
static int below(int n) {
    return (int)(next_random(&seed) % (uint32_t)n);
}

static void scribble(uint8_t *unit, int density) {
    int from = 0, to = UNITS;
    if (below(100) >= density) return;
    if (below(4) == 0) from = below(UNITS);
    if (below(4) == 0) to = from + 1 + below(UNITS - from);
    memset(unit + from, 1, (size_t)(to - from));
}

static void random_ink(ink_t *k) {
    int density = 20 + below(81);
    memset(k, 0, sizeof *k);
    k->nx = 2 + below(SIDE_MAX - 1);
    k->ny = 2 + below(SIDE_MAX - 1);
    for (int j = 0; j < k->ny; j++) {
        for (int i = 0; i + 1 < k->nx; i++) scribble(&k->row[j][i * UNITS], density);
    }
    for (int i = 0; i < k->nx; i++) {
        for (int j = 0; j + 1 < k->ny; j++) scribble(&k->col[i][j * UNITS], density);
    }
}

/* Gives the pieces of one edge. */
static int give_edge(const ink_sink_t *s, uint8_t family, int line, int cell, const uint8_t *unit) {
    for (int u = 0; u < UNITS; u++) {
        int from = u;
        if (!unit[u]) continue;
        while (u < UNITS && unit[u]) u++;
        ink_piece_t p = {family, 0, line, cell * ink_one(family) + from * (ink_one(family) / UNITS),
                         cell * ink_one(family) + u * (ink_one(family) / UNITS)};
        int err = s->piece(s->ctx, &p);
        if (err) return err;
    }
    return 0;
}

/* In the order of the perimeter kernel: rows outward from j0, columns outward from i0. */
static int give_all(const ink_t *k, const ink_sink_t *s, int i0, int j0) {
    for (int b = 0; b < 2 * k->ny; b++) {
        int j = b < k->ny - j0 ? j0 + b : k->ny - 1 - b;
        if (j < 0) break;
        for (int a = 0; a < 2 * k->nx; a++) {
            int i = a < k->nx - i0 ? i0 + a : k->nx - 1 - a;
            if (i < 0) break;
            int err = i + 1 < k->nx ? give_edge(s, INK_ROW, j, i, &k->row[j][i * UNITS]) : 0;
            if (!err && j + 1 < k->ny) err = give_edge(s, INK_COL, i, j, &k->col[i][j * UNITS]);
            if (err) return err;
        }
    }
    return 0;
}

static path_stats_t draw(const ink_t *k, int runs, int lines, int effort, int i0, int j0, drawn_t *d) {
    flat_t flat = {UNITS * UNIT, 0};
    ink_map_t map = {&flat, flat_point};
    pen_sink_t pen = drawn_sink(d);
    path_config_t c;
    path_stats_t stats;
    path_t path;
    size_t bytes = PATH_BYTES(runs, lines);
    uint8_t *mem = malloc(bytes + 1);
    path_default(&c, 80 << 16);
    assert_int_equal(c.step_lat, 410);
    c.lines = lines;
    c.effort = effort;
    assert_int_equal(path_init(&path, mem + 1, bytes, &c, &map, &pen), 0); /* any alignment will do */
    ink_sink_t sink = path_sink(&path);
    assert_int_equal(give_all(k, &sink, i0, j0), 0);
    assert_int_equal(path_finish(&path, &stats), 0);
    assert_true(stats.bytes <= bytes);
    assert_int_equal(stats.strokes, d->strokes);
    assert_int_equal(stats.lost, 0);
    assert_int_equal(stats.dots, 0);
    free(mem);
    return stats;
}

static void mark(uint8_t *unit, int from, int to) {
    if (from > to) {
        int keep = from;
        from = to;
        to = keep;
    }
    for (int u = from; u < to; u++) {
        assert_int_equal(unit[u], 0); /* nothing twice */
        unit[u] = 1;
    }
}

/* Rubs the drawing out of the scene: equal bitmaps, exactly. */
static void check_ink(const ink_t *k, const drawn_t *d) {
    static ink_t got;
    memset(&got, 0, sizeof got);
    got.nx = k->nx;
    got.ny = k->ny;
    for (int i = 0; i < d->n; i++) {
        page_point_t p = i ? d->p[i - 1] : (page_point_t){0, 0}, q = d->p[i];
        double length = hypot((double)p.x_lat - q.x_lat, (double)p.y_lat - q.y_lat);
        if (!d->down[i]) continue;
        assert_true(p.x_lat % UNIT == 0 && p.y_lat % UNIT == 0 && q.x_lat % UNIT == 0 && q.y_lat % UNIT == 0);
        assert_true(length > 0);
        if (p.y_lat == q.y_lat && p.y_lat % (UNITS * UNIT) == 0) {
            mark(got.row[p.y_lat / (UNITS * UNIT)], p.x_lat / UNIT, q.x_lat / UNIT);
        } else {
            assert_true(p.x_lat == q.x_lat && p.x_lat % (UNITS * UNIT) == 0);
            mark(got.col[p.x_lat / (UNITS * UNIT)], p.y_lat / UNIT, q.y_lat / UNIT);
        }
    }
    assert_memory_equal(&got, k, sizeof got);
}

static int find(int *parent, int v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
}

/* Half of the odd points of each connected piece of ink, at least one. */
static int euler_minimum(const ink_t *k) {
    enum { ALL = 2 * SIDE_MAX * POINTS };
    static int parent[ALL], degree[ALL], odd[ALL];
    int strokes = 0;
    for (int v = 0; v < ALL; v++) parent[v] = v, degree[v] = odd[v] = 0;
    for (int family = 0; family < 2; family++) {
        int lines = family ? k->nx : k->ny, cells = (family ? k->ny : k->nx) - 1;
        for (int line = 0; line < lines; line++) {
            for (int u = 0; u < cells * UNITS; u++) {
                int end[2];
                if (!(family ? k->col : k->row)[line][u]) continue;
                for (int side = 0; side < 2; side++) {
                    int at = u + side, node = at % UNITS == 0;
                    end[side] = !family ? line * POINTS + at
                                : node  ? at / UNITS * POINTS + line * UNITS
                                        : (SIDE_MAX + line) * POINTS + at;
                    degree[end[side]]++;
                }
                parent[find(parent, end[0])] = find(parent, end[1]);
            }
        }
    }
    for (int v = 0; v < ALL; v++) odd[find(parent, v)] += degree[v] & 1;
    for (int v = 0; v < ALL; v++) {
        if (parent[v] == v && (degree[v] || odd[v])) strokes += odd[v] > 2 ? odd[v] / 2 : 1;
    }
    return strokes;
}

static void ink_is_conserved_and_strokes_are_few(void **state) {
    static ink_t k;
    int excess = 0, minimum = 0, scenes = 3000;
    (void)state;
    seed = 20240607 + (uint32_t)cases_first(0, 1);
    for (int round = 0; round < scenes; round++) {
        drawn_t d = {0};
        random_ink(&k);
        int least = euler_minimum(&k), i0 = below(k.nx), j0 = below(k.ny);
        path_stats_t stats = draw(&k, 1000, SIDE_MAX, 20, i0, j0, &d);
        check_ink(&k, &d);
        assert_int_equal(stats.flushes, 0);
        assert_true(d.strokes >= least);
        excess += d.strokes - least;
        minimum += least;
        drawn_free(&d);
    }
    assert_true(excess * 1000 <
                minimum); /* closed strokes that only cross others: turning there would sacrifice straightness */
    print_message("# path: %d random scenes, %d strokes above Euler's minimum of %d\n", scenes, excess, minimum);
}

static void every_pool_draws_everything(void **state) {
    static ink_t k;
    (void)state;
    seed = 77 + (uint32_t)cases_first(0, 1);
    for (int round = 0; round < 1500; round++) {
        drawn_t d = {0}, again = {0};
        random_ink(&k);
        int runs = POOL_RUNS_MIN + round % 60, lines = 1 + below(SIDE_MAX), i0 = below(k.nx), j0 = below(k.ny);
        int effort = below(50);
        draw(&k, runs, lines, effort, i0, j0, &d);
        check_ink(&k, &d);
        assert_true(d.strokes >= euler_minimum(&k));
        draw(&k, runs, lines, effort, i0, j0, &again);
        assert_int_equal(d.n, again.n);
        if (d.n) assert_memory_equal(d.p, again.p, sizeof *d.p * (size_t)d.n);
        drawn_free(&d);
        drawn_free(&again);
    }
}

static int fail_after(void *ctx, page_point_t p) {
    int *left = ctx;
    (void)p;
    return (*left)-- > 0 ? 0 : ERR_STOPPED;
}

static void errors_of_the_pen_stop_everything(void **state) {
    static ink_t k;
    static uint8_t mem[PATH_BYTES(8, 4)];
    (void)state;
    seed = 3;
    random_ink(&k);
    for (int after = 0; after < 40; after++) {
        flat_t flat = {UNITS * UNIT, 0};
        ink_map_t map = {&flat, flat_point};
        int left = after;
        pen_sink_t pen = {&left, fail_after, fail_after};
        path_config_t c;
        path_t path;
        path_default(&c, 80 << 16);
        assert_int_equal(path_init(&path, mem, sizeof mem, &c, &map, &pen), 0);
        ink_sink_t sink = path_sink(&path);
        int err = give_all(&k, &sink, 0, 0);
        if (!err) err = path_finish(&path, NULL);
        assert_int_equal(err, ERR_STOPPED);
    }
}

static void every_machine_has_a_step(void **state) {
    path_config_t c;
    (void)state;
    path_default(&c, 0);
    assert_int_equal(c.step_lat, LAT_PER_MM);
    path_default(&c, 1);
    assert_int_equal(c.step_lat, PATH_STEP_MAX);
    path_default(&c, UINT32_MAX);
    assert_int_equal(c.step_lat, PATH_STEP_MIN);
    path_default(&c, 100 << 16);
    assert_int_equal(c.step_lat, 328);
}

static void the_door_is_guarded(void **state) {
    static uint8_t mem[PATH_BYTES_MIN];
    flat_t flat = {UNITS * UNIT, 0};
    ink_map_t map = {&flat, flat_point};
    drawn_t d = {0};
    pen_sink_t pen = drawn_sink(&d);
    path_config_t c;
    path_t path;
    (void)state;
    path_default(&c, 80 << 16);
    assert_int_equal(path_init(&path, mem, sizeof mem - 1, &c, &map, &pen), ERR_FULL);
    c.step_lat = PATH_STEP_MIN - 1;
    assert_int_equal(path_init(&path, mem, sizeof mem, &c, &map, &pen), ERR_VALUE);
    c.step_lat = PATH_STEP_MIN;
    assert_int_equal(path_init(&path, mem, sizeof mem, &c, &map, &pen), 0);
    ink_sink_t s = path_sink(&path);
    const ink_piece_t bad[] = {{INK_ROW, 0, 0, -1, INK_ONE},     {INK_ROW, 0, 0, 2, 1},
                               {INK_ROW, 0, 0, 0, RUN_T_LIMIT},  {9, 0, 0, 0, 1},
                               {INK_ROW, RUN_SURFACES, 0, 0, 1}, {INK_ROW, 0, RUN_LINE_LIMIT, 0, 1}};
    for (int i = 0; i < 6; i++) assert_int_equal(s.piece(s.ctx, &bad[i]), ERR_VALUE);
    assert_int_equal(path_polyline(&path, 0, 3, 5), 0);
    path_stats_t stats;
    assert_int_equal(path_finish(&path, &stats), 0);
    assert_int_equal(stats.strokes, 1);
    assert_int_equal(stats.draws, 1);
    drawn_free(&d);
}

/* A point only where x is not negative: a map that loses runs does not lose the rest. */
static bool half_point(void *ctx, uint8_t family, uint8_t surface, int32_t line, int64_t t, page_point_t *out) {
    return flat_point(ctx, family, surface, line, t, out) && out->x_lat >= 4 * UNITS * UNIT;
}

static void runs_off_the_paper_are_counted(void **state) {
    static uint8_t mem[PATH_BYTES(32, 16)];
    flat_t flat = {UNITS * UNIT, 0};
    ink_map_t map = {&flat, half_point};
    drawn_t d = {0};
    pen_sink_t pen = drawn_sink(&d);
    path_config_t c;
    path_stats_t stats;
    path_t path;
    (void)state;
    path_default(&c, 80 << 16);
    assert_int_equal(path_init(&path, mem, sizeof mem, &c, &map, &pen), 0);
    ink_sink_t s = path_sink(&path);
    for (int i = 0; i < 10; i++) {
        ink_piece_t p = {INK_COL, 0, i, 0, 3 * INK_GRID_ONE};
        assert_int_equal(s.piece(s.ctx, &p), 0);
    }
    assert_int_equal(path_finish(&path, &stats), 0);
    assert_int_equal(stats.lost, 4);
    assert_int_equal(stats.strokes, 6);
    drawn_free(&d);
}

/* All lines between the same two places, as a fan seen edge-on would have them. */
static bool crowd_point(void *ctx, uint8_t family, uint8_t surface, int32_t line, int64_t t, page_point_t *out) {
    (void)ctx, (void)family, (void)surface, (void)line;
    *out = (page_point_t){1000 + (int32_t)(t >> 10), 1000};
    return true;
}

static void a_crowd_of_ends_is_paired_all_the_same(void **state) {
    enum { RUNS = 20000 };
    size_t bytes = PATH_BYTES(RUNS, 1);
    void *mem = malloc(bytes);
    const ink_map_t map = {NULL, crowd_point};
    drawn_t d = {0};
    const pen_sink_t pen = drawn_sink(&d);
    path_config_t c;
    path_stats_t stats;
    path_t path;
    (void)state;
    path_default(&c, 80 << 16);
    assert_int_equal(path_init(&path, mem, bytes, &c, &map, &pen), 0);
    ink_sink_t s = path_sink(&path);
    for (int i = 0; i < RUNS; i++) {
        ink_piece_t p = {INK_PROFILE, 0, i, 0, INK_ONE};
        assert_int_equal(s.piece(s.ctx, &p), 0);
    }
    assert_int_equal(path_finish(&path, &stats), 0);
    assert_int_equal(stats.draws, RUNS); /* each of them turns back */
    assert_true(stats.strokes < RUNS / 20);
    drawn_free(&d);
    free(mem);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ink_is_conserved_and_strokes_are_few),
        cmocka_unit_test(every_pool_draws_everything),
        cmocka_unit_test(errors_of_the_pen_stop_everything),
        cmocka_unit_test(the_door_is_guarded),
        cmocka_unit_test(every_machine_has_a_step),
        cmocka_unit_test(a_crowd_of_ends_is_paired_all_the_same),
        cmocka_unit_test(runs_off_the_paper_are_counted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
