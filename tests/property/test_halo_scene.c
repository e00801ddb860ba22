/* Haloed lines through the whole of the core: solids and grids, every kind of view, from the plot to the strokes of the
 * pen, judged on the page. RIDGELINE_CASES multiplies the count, RIDGELINE_SEED tries one. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "app/picture.h"
#include "error.h"
#include "num/num.h"
#include "tests/oracle/halo_page.h"
#include "tests/oracle/num_of.h"
#include "tests/oracle/run_cases.h"
#include "tests/oracle/solid_cases.h"

#define LINES 1000
#define GRIDS 2

typedef struct heights {
    int nx, ny;
    double x[8], y[8], z[64];
} heights_t;

typedef struct scene_now {
    plot_t plot;
    plot_item_t item[GRIDS];
    settings_t set;
    heights_t grid[GRIDS];
    solid_scene_t solids;
    mesh_t mesh;
    int n;
    halo_page_line_t line[LINES];
    page_view_t view;
    halo_page_ink_t *ink;
    int pieces;
    page_point_t at;
} now_t;

static void on_begin(void *ctx, const camera_t *cam) {
    now_t *s = ctx;
    page_view_t *v = &s->view;
    for (int r = 0; r < 3; r++)
        for (int k = 0; k < 4; k++) v->m[r][k] = num_value(cam->m[r][k]) / (r < 2 ? LAT_PER_MM : 1);
    v->eye = (exact_eye_t){num_value(cam->eye[0]), num_value(cam->eye[1]), num_value(cam->eye[2]), cam->perspective};
    v->x0 = (double)cam->window.x0_lat / LAT_PER_MM;
    v->y0 = (double)cam->window.y0_lat / LAT_PER_MM;
    v->x1 = (double)cam->window.x1_lat / LAT_PER_MM;
    v->y1 = (double)cam->window.y1_lat / LAT_PER_MM;
}

static int on_move(void *ctx, page_point_t to) {
    ((now_t *)ctx)->at = to;
    return 0;
}
static int on_draw(void *ctx, page_point_t to) {
    now_t *s = ctx;
    s->ink = realloc(s->ink, (size_t)(s->pieces + 1) * sizeof *s->ink);
    s->ink[s->pieces++] =
        (halo_page_ink_t){s->at.x_lat / 32768., s->at.y_lat / 32768., to.x_lat / 32768., to.y_lat / 32768.};
    s->at = to;
    return 0;
}

static num_t x_of(void *ctx, int32_t i) {
    return num_of(((heights_t *)ctx)->x[i]);
}
static num_t y_of(void *ctx, int32_t j) {
    return num_of(((heights_t *)ctx)->y[j]);
}
static num_t z_of(void *ctx, int32_t i, int32_t j) {
    const heights_t *g = ctx;
    return num_of(g->z[j * g->nx + i]);
}

static void add_line(now_t *s, exact_point_t p, exact_point_t q) {
    if (s->n < LINES) s->line[s->n++] = (halo_page_line_t){{p, q}};
}

static exact_point_t node(const heights_t *g, int i, int j) {
    return (exact_point_t){g->x[i], g->y[j], g->z[j * g->nx + i]};
}

static void make_grids(now_t *s, uint64_t *rng) {
    s->plot = (plot_t){PLOT_SURFACES, 1 + scene_below(rng, GRIDS), s->item, &s->set};
    for (int k = 0; k < s->plot.n; k++) {
        heights_t *g = &s->grid[k];
        g->nx = 2 + scene_below(rng, 6);
        g->ny = 2 + scene_below(rng, 6);
        const double rough = scene_below(rng, 2) ? 1 : .2;
        for (int i = 0; i < g->nx; i++) g->x[i] = -2 + i * 4. / (g->nx - 1);
        for (int j = 0; j < g->ny; j++) g->y[j] = -2 + j * 4. / (g->ny - 1);
        for (int j = 0; j < g->ny; j++)
            for (int i = 0; i < g->nx; i++)
                g->z[j * g->nx + i] = exp(-g->x[i] * g->x[i] - g->y[j] * g->y[j]) + rough * scene_uniform(rng) + .5 * k;
        s->item[k].surface = (surface_t){.nx = g->nx, .ny = g->ny, .ctx = g, .x_of = x_of, .y_of = y_of, .z_of = z_of};
        for (int j = 0; j < g->ny; j++)
            for (int i = 0; i < g->nx; i++) {
                if (i + 1 < g->nx) add_line(s, node(g, i, j), node(g, i + 1, j));
                if (j + 1 < g->ny) add_line(s, node(g, i, j), node(g, i, j + 1));
            }
    }
    if (scene_below(rng, 2)) {
        s->set.view.from = true;
        const double turn = 6.283 * scene_uniform(rng), away = 1.5 + 8 * scene_uniform(rng);
        s->set.view.eye[0] = num_of(away * cos(turn));
        s->set.view.eye[1] = num_of(away * sin(turn));
        s->set.view.eye[2] = num_of(6 * scene_uniform(rng) - 2);
    } else {
        s->set.view.rot_x = num_of(floor(180 * scene_uniform(rng)));
        s->set.view.rot_z = num_of(floor(360 * scene_uniform(rng)));
    }
}

static void make_solids(now_t *s, solid_make_t make, uint64_t seed) {
    make(&s->solids, seed, 4);
    s->set = s->solids.set;
    solid_scene_mesh(&s->solids.ref, &s->mesh);
    s->item[0].mesh = s->mesh;
    s->item[0].solid = true;
    s->plot = (plot_t){PLOT_SOLIDS, 1, s->item, &s->set};
    const solid_ref_t *r = &s->solids.ref;
    for (int e = 0; e < r->ne; e++) add_line(s, r->vertex[r->edge[e][0]], r->vertex[r->edge[e][1]]);
}

/* Draws and judges one scene; *seen: it was drawn. */
static bool run(now_t *s, uint64_t seed, solid_make_t make, halo_page_report_t *r, bool *seen) {
    static picture_t picture;
    const size_t bytes = (size_t)1 << 22;
    uint64_t rng = seed;
    *s = (now_t){0};
    settings_default(&s->set);
    if (make)
        make_solids(s, make, seed);
    else
        make_grids(s, &rng);
    s->set.hidden = HIDDEN_HALO;
    s->set.halo_um = scene_below(&rng, 4) ? 100 + scene_below(&rng, 2500) : 10 << scene_below(&rng, 13); /* to 41 mm */
    picture_hooks_t hooks = {.ctx = s, .begin = on_begin};
    const pen_sink_t pen = {s, on_move, on_draw};
    void *mem = malloc(bytes);
    int err = picture_draw(&picture, &s->plot, mem, bytes, &pen, &hooks);
    if (err == ERR_FULL) { /* as the desktop does, but for more memory */
        s->pieces = 0;
        hooks.generous = true;
        err = picture_draw(&picture, &s->plot, mem, bytes, &pen, &hooks);
    }
    free(mem);
    *seen = err == 0 && s->n < LINES;
    if (*seen) *r = halo_page_judge(&s->view, s->line, s->n, s->set.halo_um * 1e-3, s->ink, s->pieces);
    const bool good = err == ERR_VALUE || err == ERR_EMPTY || (err == 0 && r->missing_mm <= 0 && r->false_mm <= 0);
    if (!good)
        print_message("# FAILED RIDGELINE_SEED=%llu build/tests/property/test_halo_scene\n"
                      "#   %s, %d lines, halo %g mm, %s: error %d, missing %g mm, false %g mm at %g,%g\n",
                      (unsigned long long)seed, make ? s->solids.what : "grids", s->n, s->set.halo_um * 1e-3,
                      s->view.eye.h ? "perspective" : "parallel", err, r->missing_mm, r->false_mm, r->x, r->y);
    free(s->ink);
    if (make) {
        solid_scene_mesh_free(&s->mesh);
        solid_scene_free(&s->solids);
    }
    return good;
}

static void run_all(const char *name, uint64_t first, uint64_t count, solid_make_t make) {
    static now_t s;
    uint64_t from, to;
    int failed = 0, drawn = 0;
    halo_page_report_t all = {0};
    if (!cases_seeds(first, count, &from, &to)) return;
    for (uint64_t seed = from; seed < to && failed < 10; seed++) {
        halo_page_report_t r = {0};
        bool seen;
        if (!run(&s, seed, make, &r, &seen)) failed++;
        drawn += seen;
        all.checked_mm += r.checked_mm;
        all.gaps_mm += r.gaps_mm;
        all.missing_mm = fmax(all.missing_mm, r.missing_mm);
        all.false_mm = fmax(all.false_mm, r.false_mm);
    }
    print_message(
        "# %s: %d drawings, %.0f m of lines that must be drawn, %.1f m of gaps that must be free; missing %.2f "
        "steps, false %.2f\n",
        name, drawn, all.checked_mm * 1e-3, all.gaps_mm * 1e-3, all.missing_mm / JUDGE_STEP_MM,
        all.false_mm / JUDGE_STEP_MM);
    assert_int_equal(failed, 0);
}

static void test_solids(void **state) {
    (void)state;
    run_all("solids", 0, cases_scaled(400), solid_scene_random);
}
static void test_grids(void **state) {
    (void)state;
    run_all("grids", 1000000000, cases_scaled(400), NULL);
}

static void test_composed(void **state) {
    (void)state;
    run_all("composed", 2000000000, cases_scaled(200), solid_scene_composed);
}
static void test_touching(void **state) {
    (void)state;
    run_all("touching", 3000000000, cases_scaled(200), solid_scene_touching);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_solids), cmocka_unit_test(test_grids),
                                       cmocka_unit_test(test_composed), cmocka_unit_test(test_touching)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
