/* The ink stage behind the real kernel: the reference figures of the 40x40 sinc and of Anderson's smooth 60x60 surface,
 * and what a small memory costs. */
#include "hidden/perimeter.h"
#include "lang/settings.h"
#include "path_scene.h"
#include "view/camera.h"
#include "view/page_map.h"
#include <math.h>

#define SIDE_MAX 60
#define PIECES_MAX 4000

typedef struct heights {
    int32_t n;
    double half; /* the surface is on [-half, half]^2 */
    double (*f)(double r);
} heights_t;

/* A surface's ink, and its map to the page, moved and scaled if asked for. */
typedef struct ink {
    heights_t heights;
    settings_t settings;
    surface_t surface;
    grid_t grid;
    camera_t camera;
    page_map_t map;
    int32_t cache[SIDE_MAX * SIDE_MAX];
    uint64_t table[PAGE_MAP_BYTES(SIDE_MAX, SIDE_MAX) / 8], work[1 << 15];
    ink_piece_t piece[PIECES_MAX];
    int pieces;
    double scale;
    page_point_t corner;
} ink_t;

static ink_t ink;

static num_t num_of(double v) {
    int e;
    double m = frexp(v, &e);
    return num_ldexp(num_from_i64((int64_t)ldexp(m, 53)), e - 53);
}

static double at(const heights_t *h, int32_t i) {
    return h->half * (2.0 * i / (h->n - 1) - 1);
}
static num_t coordinate(void *ctx, int32_t i) {
    return num_of(at(ctx, i));
}
static num_t height(void *ctx, int32_t i, int32_t j) {
    heights_t *h = ctx;
    return num_of(h->f(hypot(at(h, i), at(h, j))));
}

static double sinc(double r) {
    return sin(r) / r;
}
static double hill(double r) {
    return exp(-r * r);
}

static int keep(void *ctx, const ink_piece_t *p) {
    (void)ctx;
    assert_true(ink.pieces < PIECES_MAX);
    ink.piece[ink.pieces++] = *p;
    return 0;
}

static bool point(void *ctx, uint8_t family, uint8_t surface, int32_t line, int64_t t_q30, page_point_t *out) {
    page_point_t p;
    (void)ctx;
    (void)surface;
    if (!line_space_point(&ink.map.lines, family, line, t_q30, &p)) return false;
    out->x_lat = (int32_t)lround((p.x_lat - ink.corner.x_lat) * ink.scale);
    out->y_lat = (int32_t)lround((p.y_lat - ink.corner.y_lat) * ink.scale);
    return true;
}

/* Runs the kernel once. */
static void prepare(int32_t n, double half, double (*f)(double), bool perspective) {
    const ink_sink_t sink = {NULL, keep};
    const hidden_job_t job = {.mem = ink.work, .bytes = sizeof ink.work, .sink = &sink};
    hidden_stats_t stats;
    view_box_t box = {.lo = {num_of(-half), num_of(-half)}, .hi = {num_of(half), num_of(half)}};
    ink.heights = (heights_t){n, half, f};
    ink.surface = (surface_t){n, n, &ink.heights, coordinate, coordinate, height};
    settings_default(&ink.settings);
    ink.settings.view.from = perspective;
    ink.settings.view.eye[0] = num_from_i64(6);
    ink.settings.view.eye[1] = num_from_i64(8);
    ink.settings.view.eye[2] = num_from_i64(3);
    assert_int_equal(grid_measure(&ink.grid, &ink.surface, NULL, NULL, ink.cache, NULL, NULL), 0);
    box.lo[2] = ink.grid.z_min;
    box.hi[2] = ink.grid.z_max;
    assert_int_equal(camera_setup(&ink.camera, &ink.settings, &box), 0);
    assert_int_equal(page_map_setup(&ink.map, &ink.grid, &ink.camera, ink.table), 0);
    ink.pieces = 0;
    ink.scale = 1;
    ink.corner = (page_point_t){0, 0};
    assert_int_equal(perimeter_draw(&ink.grid, &ink.camera, &job, &stats), 0);
}

static path_stats_t draw(size_t bytes, int32_t lines, int32_t effort, drawn_t *d) {
    static uint64_t mem[1 << 14];
    const ink_map_t map = {NULL, point};
    const pen_sink_t pen = drawn_sink(d);
    path_config_t c;
    path_stats_t stats;
    path_t path;
    assert_true(bytes <= sizeof mem);
    path_default(&c, 80 << 16);
    c.lines = lines;
    c.effort = effort;
    assert_int_equal(path_init(&path, mem, bytes, &c, &map, &pen), 0);
    ink_sink_t s = path_sink(&path);
    for (int i = 0; i < ink.pieces; i++) assert_int_equal(s.piece(s.ctx, &ink.piece[i]), 0);
    assert_int_equal(path_finish(&path, &stats), 0);
    assert_int_equal(stats.lost, 0);
    assert_int_equal(stats.strokes, d->strokes);
    return stats;
}

static double mm(int64_t lat) {
    return (double)lat / LAT_PER_MM;
}

/* Every pool draws the same length; its strokes and travel are the price of its size. */
static void print_table(const char *name, int32_t lines) {
    const int runs[] = {4, 16, 64, 256, 1024};
    double whole = 0;
    for (int k = 4; k >= 0; k--) {
        drawn_t d = {0};
        path_stats_t s = draw(PATH_BYTES(runs[k], lines), lines, 1000, &d);
        if (k == 4) whole = mm(s.down_lat);
        assert_true(fabs(mm(s.down_lat) - whole) < 0.001 * whole);
        print_message("# path: %s, pool of %4d runs (%5d bytes): %4d strokes, %5.0f mm pen-up\n", name, runs[k],
                      (int)s.bytes, (int)s.strokes, mm(s.up_lat));
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
    prepare(40, 10, sinc, false);
    fit(260);
    path_stats_t s = draw(PATH_BYTES(1024, 1), 1, 1000, &d);
    double between = mm(s.up_lat) - hypot(d.p[0].x_lat, d.p[0].y_lat) / LAT_PER_MM -
                     hypot(d.p[d.n - 1].x_lat, d.p[d.n - 1].y_lat) / LAT_PER_MM;
    print_message(
        "# path: sinc 40x40, 260 mm wide: %d strokes, %.0f mm drawn, %.0f mm pen-up (%.0f mm between strokes); "
        "gnuplot 1866 strokes, 79202 mm; best known post-processing 182, 547 mm\n",
        (int)s.strokes, mm(s.down_lat), mm(s.up_lat), between);
    assert_true(s.strokes <= 182);
    assert_true(mm(s.up_lat) <= 547);
    drawn_free(&d);
    print_table("sinc 40x40", 1);
}

static void smooth_reaches_the_reference(void **state) {
    drawn_t d = {0};
    (void)state;
    prepare(60, 2, hill, true);
    path_stats_t s = draw(PATH_BYTES(1024, 1), 1, 1000, &d);
    print_message("# path: smooth 60x60: %d strokes, %.0f mm drawn, %.0f mm pen-up; PLplot 11018 strokes, ln 150\n",
                  (int)s.strokes, mm(s.down_lat), mm(s.up_lat));
    assert_true(s.strokes <= 150);
    drawn_free(&d);
    print_table("smooth 60x60", 1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sinc_reaches_the_reference),
        cmocka_unit_test(smooth_reaches_the_reference),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
