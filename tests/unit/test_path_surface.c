/* The ink stage behind the real kernel: the reference figures of the 40x40 sinc and of Anderson's smooth 60x60 surface,
 * and what a small memory costs. */
#include "path_scene.h"
#include "path_surface.h"

static surface_ink_t ink;

static double sinc(double r) {
    return sin(r) / r;
}
static double hill(double r) {
    return exp(-r * r);
}

/* What is told while strokes are put in order and drawn rises to the end. */
static int32_t told;

static void hear(void *ctx, int32_t done, int32_t of) {
    (void)ctx;
    assert_true(done >= told && done <= of);
    told = done;
}

static path_stats_t draw(size_t bytes, int32_t lines, int32_t effort, drawn_t *d) {
    static uint64_t mem[1 << 14];
    const ink_map_t map = {&ink, surface_ink_point};
    const pen_sink_t pen = drawn_sink(d);
    path_config_t c;
    path_stats_t stats;
    path_t path;
    assert_true(bytes <= sizeof mem);
    path_default(&c, 80 << 16);
    c.lines = lines;
    c.effort = effort;
    c.tell = hear;
    told = 0;
    assert_int_equal(path_init(&path, mem, bytes, &c, &map, &pen), 0);
    ink_sink_t s = path_sink(&path);
    for (int i = 0; i < ink.pieces; i++) assert_int_equal(s.piece(s.ctx, &ink.piece[i]), 0);
    assert_int_equal(told, 0);
    assert_int_equal(path_finish(&path, &stats), 0);
    assert_true(told > 0);
    assert_int_equal(stats.lost, 0);
    assert_int_equal(stats.strokes, d->strokes);
    return stats;
}

/* Every pool draws the same length; its strokes and travel are the price of its size. */
static void print_table(const char *name, int32_t lines) {
    const int runs[] = {4, 16, 64, 256, 1024};
    double whole = 0;
    for (int k = 4; k >= 0; k--) {
        drawn_t d = {0};
        path_stats_t s = draw(PATH_BYTES(runs[k], lines), lines, 500, &d);
        if (k == 4) whole = drawn_mm(&d, true);
        assert_true(fabs(drawn_mm(&d, true) - whole) < 0.001 * whole);
        print_message("# path: %s, pool of %4d runs (%5d bytes): %4d strokes, %5.0f mm pen-up\n", name, runs[k],
                      (int)s.bytes, (int)s.strokes, drawn_mm(&d, false));
        drawn_free(&d);
    }
}

/* Scales the drawing to `width_mm` and puts its corner at home. */
static void fit(double width_mm) {
    drawn_t d = {0};
    page_point_t lo = {INT32_MAX, INT32_MAX}, hi = {INT32_MIN, INT32_MIN};
    draw(PATH_BYTES(1024, 1), 1, 0, &d);
    for (int i = 0; i < d.n; i++) {
        lo.x_lat = d.p[i].x_lat < lo.x_lat ? d.p[i].x_lat : lo.x_lat;
        lo.y_lat = d.p[i].y_lat < lo.y_lat ? d.p[i].y_lat : lo.y_lat;
        hi.x_lat = d.p[i].x_lat > hi.x_lat ? d.p[i].x_lat : hi.x_lat;
    }
    ink.corner = lo;
    ink.scale = width_mm * LAT_PER_MM / (hi.x_lat - lo.x_lat);
    drawn_free(&d);
}

static void sinc_reaches_the_reference(void **state) {
    drawn_t d = {0};
    (void)state;
    assert_int_equal(surface_ink_make(&ink, 40, 10, sinc, false), 0);
    fit(260);
    path_stats_t s = draw(PATH_BYTES(1024, 1), 1, 500, &d);
    double between = drawn_mm(&d, false) - hypot(d.p[0].x_lat, d.p[0].y_lat) / LAT_PER_MM -
                     hypot(d.p[d.n - 1].x_lat, d.p[d.n - 1].y_lat) / LAT_PER_MM;
    print_message(
        "# path: sinc 40x40, 260 mm wide: %d strokes, %.0f mm drawn, %.0f mm pen-up (%.0f mm between strokes); "
        "gnuplot 1866 strokes, 79202 mm; best known post-processing 182, 547 mm\n",
        (int)s.strokes, drawn_mm(&d, true), drawn_mm(&d, false), between);
    assert_true(s.strokes <= 182);
    assert_true(drawn_mm(&d, false) <= 547);
    drawn_free(&d);
    print_table("sinc 40x40", 1);
    surface_ink_free(&ink);
}

static void smooth_reaches_the_reference(void **state) {
    drawn_t d = {0};
    (void)state;
    assert_int_equal(surface_ink_make(&ink, 60, 2, hill, true), 0);
    path_stats_t s = draw(PATH_BYTES(1024, 1), 1, 500, &d);
    print_message("# path: smooth 60x60: %d strokes, %.0f mm drawn, %.0f mm pen-up; PLplot 11018 strokes, ln 150\n",
                  (int)s.strokes, drawn_mm(&d, true), drawn_mm(&d, false));
    assert_true(s.strokes <= 150);
    drawn_free(&d);
    print_table("smooth 60x60", 1);
    surface_ink_free(&ink);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sinc_reaches_the_reference),
        cmocka_unit_test(smooth_reaches_the_reference),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
