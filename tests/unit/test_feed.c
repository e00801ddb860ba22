/* Drawing while ink is still coming (path_feed_t): when the pen takes what must make no difference to what is drawn. */
#include "error.h"
#include "path_scene.h"
#include "path_surface.h"

enum mood { EAGER, LAZY, MOODY };

typedef struct plotter {
    drawn_t drawn;
    enum mood mood;
    uint32_t seed;
    int rests, pieces, before; /* lifts asked for; pieces given so far, and when the first point was drawn */
    int points, stop_at;       /* an error at this point, if not 0 */
    bool stroke;               /* a move has begun a stroke */
} plotter_t;

static surface_ink_t ink;

static double hill(double r) {
    return exp(-r * r);
}

static bool ready(void *ctx) {
    plotter_t *m = ctx;
    m->seed = m->seed * 1664525u + 1013904223u;
    return m->mood == EAGER || (m->mood == MOODY && m->seed >> 30);
}

static int rest(void *ctx) {
    plotter_t *m = ctx;
    m->rests++;
    m->stroke = false; /* the next must be a move */
    return 0;
}

static int count(plotter_t *m) {
    if (!m->points) m->before = m->pieces;
    m->points++;
    return m->stop_at && m->points > m->stop_at ? ERR_STOPPED : 0;
}
static int pen_move(void *ctx, page_point_t p) {
    plotter_t *m = ctx;
    pen_sink_t pen = drawn_sink(&m->drawn);
    m->stroke = true;
    return count(m) ? ERR_STOPPED : pen.move(pen.ctx, p);
}
static int pen_draw(void *ctx, page_point_t p) {
    plotter_t *m = ctx;
    pen_sink_t pen = drawn_sink(&m->drawn);
    assert_true(m->stroke);
    return count(m) ? ERR_STOPPED : pen.draw(pen.ctx, p);
}

/* As many pieces at a time as come from a row of facets, of so many us each. */
static int draw(plotter_t *m, size_t bytes, int32_t waiting, int32_t us, path_stats_t *stats) {
    static uint64_t mem[1 << 15];
    const ink_map_t map = {&ink, surface_ink_point};
    const pen_sink_t pen = {m, pen_move, pen_draw};
    const path_feed_t feed = {m, ready, rest, waiting, 100 * LAT_PER_MM / 1000, 200000, 500};
    path_config_t c;
    path_t path;
    assert_true(bytes <= sizeof mem);
    path_default(&c, 80 << 16);
    c.lines = ink.n;
    c.feed = waiting ? &feed : NULL;
    assert_int_equal(path_init(&path, mem, bytes, &c, &map, &pen), 0);
    ink_sink_t s = path_sink(&path);
    int err = 0;
    for (m->pieces = 0; m->pieces < ink.pieces && !err; m->pieces++) {
        err = s.piece(s.ctx, &ink.piece[m->pieces]);
        if (!err && m->pieces % (ink.pieces / ink.n + 1) == 0) err = path_advance(&path, us);
    }
    return err ? err : path_finish(&path, stats);
}

static bool same(const drawn_t *a, const drawn_t *b) {
    return a->n == b->n && a->strokes == b->strokes && memcmp(a->p, b->p, sizeof *a->p * (size_t)a->n) == 0;
}

/* The same strokes whatever the pen does, and not many more than with everything at hand. */
static void compare(const char *name, size_t bytes, int32_t us) {
    plotter_t all = {0}, m[3] = {{.mood = EAGER}, {.mood = LAZY}, {.mood = MOODY}};
    path_stats_t whole, s[3];
    assert_int_equal(draw(&all, bytes, 0, us, &whole), 0);
    const double down_mm = drawn_mm(&all.drawn, true);
    for (int k = 0; k < 3; k++) {
        assert_int_equal(draw(&m[k], bytes, 64, us, &s[k]), 0);
        assert_true(same(&m[0].drawn, &m[k].drawn));
        assert_true(fabs(drawn_mm(&m[k].drawn, true) - down_mm) < down_mm / 1000);
        assert_true(s[k].strokes <= whole.strokes + whole.strokes / 20 + 4);
        assert_true(m[k].rests > 0);
    }
    assert_true(m[0].before < ink.pieces / 4);
    print_message(
        "# feed: %s, %d bytes: first drawn after %d %% of the ink (else %d %%); %d strokes (else %d), %.0f mm pen-up "
        "(%.0f)\n",
        name, (int)bytes, 100 * m[0].before / ink.pieces, 100 * all.before / ink.pieces, (int)s[0].strokes,
        (int)whole.strokes, drawn_mm(&m[0].drawn, false), drawn_mm(&all.drawn, false));
    for (int k = 0; k < 3; k++) drawn_free(&m[k].drawn);
    drawn_free(&all.drawn);
}

static void smooth_is_the_same_whenever_it_is_taken(void **state) {
    (void)state;
    assert_int_equal(surface_ink_make(&ink, 60, 2, hill, true), 0);
    compare("smooth 60x60", PATH_BYTES(1024, 64), 6000);
    compare("smooth 60x60, a slow board", PATH_BYTES(1024, 64), 200000);
    surface_ink_free(&ink);
}

static void random_is_the_same_with_a_full_pool(void **state) {
    (void)state;
    assert_int_equal(surface_ink_make(&ink, 60, 2, NULL, true), 0);
    compare("random 60x60", PATH_BYTES(3000, 64), 6000);
    compare("random 60x60, a small pool", PATH_BYTES(400, 64), 6000);
    compare("random 60x60, a slow board", PATH_BYTES(400, 64), 500000);
    surface_ink_free(&ink);
}

/* Wherever the pen fails, while pieces come, strokes are put in order or the rest is drawn, that is what is returned.
 */
static void a_stop_ends_it_anywhere(void **state) {
    (void)state;
    assert_int_equal(surface_ink_make(&ink, 24, 2, NULL, true), 0);
    for (int at = 1; at < 200; at += 3) {
        plotter_t m = {.mood = at % 2 ? EAGER : MOODY, .stop_at = at};
        path_stats_t stats;
        assert_int_equal(draw(&m, PATH_BYTES(64, 16), 16, 6000, &stats), ERR_STOPPED);
        assert_true(m.drawn.n <= at);
        drawn_free(&m.drawn);
    }
    surface_ink_free(&ink);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(smooth_is_the_same_whenever_it_is_taken),
        cmocka_unit_test(random_is_the_same_with_a_full_pool),
        cmocka_unit_test(a_stop_ends_it_anywhere),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
