/* The reference itself: cases worked out by hand, and a second, cruder way on random scenes.
 *
 * The crude way samples points, shoots the ground ray at every cell's four sides in floating point and compares slopes.
 * It knows nothing of determinants or intervals; where it is nearly tied it says so and is not asked. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "tests/oracle/surface_ref.h"

static void expect_hidden(const surface_ref_t *r, int family, int line, int k, size_t n, const double *ends) {
    spans_t h = {0}, e = {0};
    surface_ref_edge(r, family, line, k, &h, &e);
    assert_int_equal(h.n, n);
    for (size_t i = 0; i < n; i++) {
        assert_true(fabs((double)h.s[i].a - ends[2 * i]) < 1e-15);
        assert_true(fabs((double)h.s[i].b - ends[2 * i + 1]) < 1e-15);
    }
    spans_free(&h);
    spans_free(&e);
}

/* A ridge at y = 1, seen level from the south: what lies behind between heights 0 and 1 is hidden. */
static void test_ridge(void **state) {
    (void)state;
    double x[] = {0, 1, 2}, y[] = {0, 1, 2, 3};
    double z[] = {0, 0, 0, 1, 1, 1, .5, .5, .5, 2, -1, 2};
    surface_ref_t r = {.nx = 3, .ny = 4, .x = x, .y = y, .z = z, .eye = {.1, -1, 0, 0}};
    expect_hidden(&r, REF_ROW, 0, 0, 0, NULL);
    expect_hidden(&r, REF_ROW, 1, 0, 0, NULL);
    expect_hidden(&r, REF_ROW, 2, 0, 1, (double[]){0, 1});
    /* The view leans by .1, so rays from x > 1.8 leave by the east side y = 2 - (2 - x) / .1, whose height is y:
     * it falls below the row's 0.5 at x = 1.85. */
    expect_hidden(&r, REF_ROW, 2, 1, 1, (double[]){0, .85});
    /* Row 3 goes from 2 down to -1 and back: below 1 from t = 1/3, below 0 from 2/3. */
    expect_hidden(&r, REF_ROW, 3, 0, 1, (double[]){1. / 3, 2. / 3});
    expect_hidden(&r, REF_ROW, 3, 1, 1, (double[]){1. / 3, 2. / 3});
}

/* The same ridge with the eye in the grid plane x = 1: the column in that plane is hidden like its neighbourhood. */
static void test_grid_plane(void **state) {
    (void)state;
    double x[] = {0, 1, 2}, y[] = {0, 1, 2, 3};
    double z[] = {0, 0, 0, 1, 1, 1, .5, .5, .5, 2, -1, 2};
    surface_ref_t r = {.nx = 3, .ny = 4, .x = x, .y = y, .z = z, .eye = {0, -1, 0, 0}};
    expect_hidden(&r, REF_COL, 1, 0, 0, NULL);
    expect_hidden(&r, REF_COL, 1, 1, 1, (double[]){0, 1});      /* 1 down to 0.5 */
    expect_hidden(&r, REF_COL, 1, 2, 1, (double[]){0, 1. / 3}); /* 0.5 down to -1: out at 0 */
    /* The border column is on the border of every cover: nothing is certain of what one side hides. */
    spans_t h = {0}, e = {0};
    surface_ref_edge(&r, REF_COL, 0, 1, &h, &e);
    assert_int_equal(h.n, 0);
    assert_int_equal(e.n, 1);
    spans_free(&h);
    spans_free(&e);
}

/* Perspective: eye at (0.5, -1, 2) over a plain with a wall of height 1 at y = 1; it throws a shadow to y = 3. */
static void test_shadow(void **state) {
    (void)state;
    double x[] = {0, 1}, y[] = {0, 1, 1.5, 4};
    double z[] = {0, 0, 1, 1, 0, 0, 0, 0};
    surface_ref_t r = {.nx = 2, .ny = 4, .x = x, .y = y, .z = z, .eye = {.5, -1, 2, 1}};
    expect_hidden(&r, REF_ROW, 1, 0, 0, NULL);
    /* Row y = 1.5 is 2.5 away, the wall 2 away: the wall's ends cover |x - .5| < .5 * 2.5 / 2. */
    expect_hidden(&r, REF_ROW, 2, 0, 1, (double[]){0, 1});
    /* The column x = 0 at y, z = 0: behind the wall for all y up to 3; the ray leaves the wall's side never. */
    expect_hidden(&r, REF_COL, 0, 2, 1, (double[]){0, .6});
    expect_hidden(&r, REF_COL, 1, 2, 1, (double[]){0, .6});
}

/* Over a vertex, inside: all four columns and rows through it are seen, a pit's far walls too. */
static void test_over_vertex(void **state) {
    (void)state;
    double x[] = {-2, -1, 0, 1, 2}, z[25];
    for (int i = 0; i < 25; i++) z[i] = 0;
    z[2 * 5 + 3] = 1; /* a spike at (1, 0) hides what is behind it up to x = 2 for eyes below 2 */
    surface_ref_t r = {.nx = 5, .ny = 5, .x = x, .y = x, .z = z, .eye = {0, 0, 2, 1}};
    expect_hidden(&r, REF_ROW, 2, 2, 0, NULL);
    expect_hidden(&r, REF_ROW, 2, 3, 0, NULL); /* the spike's back slope is seen edge-on: it reaches (2, 0) exactly */
    r.eye.z = 1.5;
    expect_hidden(&r, REF_ROW, 2, 3, 1, (double[]){0, 1});
    expect_hidden(&r, REF_ROW, 2, 1, 0, NULL);
    expect_hidden(&r, REF_COL, 2, 2, 0, NULL);
}

static void test_hole(void **state) {
    (void)state;
    double x[] = {0, 1, 2}, y[] = {0, 1, 2};
    double z[] = {0, 0, 0, 1, 1, 1, .5, .5, .5};
    unsigned char hole[9] = {1, 0, 0, 0, 0, 0, 0, 0, 0};
    surface_ref_t r = {.nx = 3, .ny = 3, .x = x, .y = y, .z = z, .hole = hole, .eye = {0, -1, .001, 0}};
    assert_false(surface_ref_edge_exists(&r, REF_ROW, 0, 0));
    assert_true(surface_ref_edge_exists(&r, REF_ROW, 1, 0));
    assert_true(surface_ref_edge_exists(&r, REF_COL, 1, 0));
    assert_false(surface_ref_edge_exists(&r, REF_COL, 0, 0));
    /* The cell in front of (0..1, y = 2) is not there, but the one behind y = 1 covers 0.5 .. 1 only to its far side.
     */
    expect_hidden(&r, REF_ROW, 2, 0, 0, NULL);
    expect_hidden(&r, REF_ROW, 2, 1, 1, (double[]){0, 1});
}

/* A roof at z = 1 over a floor at z = 0: from (.5, -1, 3) the roof's front edge throws its shadow on y = 0.5, on the
 * floor's middle column, which is in a plane with the eye, too. */
static void test_sheets(void **state) {
    (void)state;
    double x[] = {0, .5, 1}, y[] = {0, 1, 2}, floor_z[9] = {0}, roof_z[9];
    double *other[1] = {roof_z};
    for (int i = 0; i < 9; i++) roof_z[i] = 1;
    surface_ref_t r = {.nx = 3, .ny = 3, .x = x, .y = y, .z = floor_z, .eye = {.5, -1, 3, 1}};
    expect_hidden(&r, REF_COL, 1, 0, 0, NULL);
    r.sheets = 1;
    r.sheet_z = other;
    expect_hidden(&r, REF_ROW, 0, 0, 0, NULL);
    expect_hidden(&r, REF_ROW, 1, 0, 1, (double[]){0, 1});
    expect_hidden(&r, REF_COL, 0, 0, 1, (double[]){.5, 1});
    expect_hidden(&r, REF_COL, 1, 0, 1, (double[]){.5, 1});
    expect_hidden(&r, REF_COL, 1, 1, 1, (double[]){0, 1});
    r.z = roof_z;
    other[0] = floor_z;
    expect_hidden(&r, REF_COL, 1, 0, 0, NULL);
    expect_hidden(&r, REF_ROW, 2, 1, 0, NULL);
}

static uint64_t seed;
static double rnd(void) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(seed >> 11) * 0x1p-53;
}

/* 1 hidden, 0 visible, -1 too close to call. */
static int crude(const surface_ref_t *r, double px, double py, double pz, int imin, int imax, int jmin, int jmax) {
    double ex = r->eye.x, ey = r->eye.y, ez = r->eye.z;
    double gx = r->eye.h ? px - ex : -ex, gy = r->eye.h ? py - ey : -ey;
    bool close = false;
    for (int cj = 0; cj + 1 < r->ny; cj++)
        for (int ci = 0; ci + 1 < r->nx; ci++) {
            if (!surface_ref_cell_exists(r, ci, cj)) continue;
            if (imin >= ci && imax <= ci + 1 && jmin >= cj && jmax <= cj + 1) continue;
            int ni[5] = {ci, ci + 1, ci + 1, ci, ci}, nj[5] = {cj, cj, cj + 1, cj + 1, cj};
            double lo = INFINITY, hi = -INFINITY;
            int met = 0;
            for (int k = 0; k < 4; k++) {
                exact_point_t a = surface_ref_node(r, ni[k], nj[k]), b = surface_ref_node(r, ni[k + 1], nj[k + 1]);
                /* P - s g = a + u (b - a) */
                double ux = b.x - a.x, uy = b.y - a.y, det = gx * uy - gy * ux;
                if (det == 0) continue;
                double s = ((px - a.x) * uy - (py - a.y) * ux) / det;
                double u = fabs(ux) > fabs(uy) ? (px - s * gx - a.x) / ux : (py - s * gy - a.y) / uy;
                if (u < -1e-9 || u > 1 + 1e-9 || s < -1e-9 || (r->eye.h && s > 1 - 1e-9)) continue;
                if (u < 1e-7 || u > 1 - 1e-7) close = true;
                double q = a.z + u * (b.z - a.z);
                double at = r->eye.h ? ez + (q - ez) / (1 - s) : q - s * r->eye.z;
                lo = fmin(lo, at);
                hi = fmax(hi, at);
                met++;
            }
            if (met == 1 && r->eye.h) hi = pz + 1, lo = fmin(lo, pz - 1), close = true; /* the eye's own cell */
            if (met < 2) continue;
            if (fabs(pz - lo) < 1e-9 || fabs(pz - hi) < 1e-9)
                close = true;
            else if (pz > lo && pz < hi && !close)
                return 1;
        }
    return close ? -1 : 0;
}

static void test_random_against_crude(void **state) {
    (void)state;
    long asked = 0, hidden_points = 0;
    spans_t h = {0}, e = {0};
    for (int scene = 0; scene < 120; scene++) {
        seed = (uint64_t)scene * 977 + 5;
        double x[9], y[9], z[81];
        unsigned char hole[81];
        surface_ref_t r = {.nx = 2 + (int)(rnd() * 8), .ny = 2 + (int)(rnd() * 8), .x = x, .y = y, .z = z};
        for (int i = 0; i < 9; i++) x[i] = i + .7 * rnd(), y[i] = i + .7 * rnd();
        for (int i = 0; i < 81; i++) z[i] = 3 * rnd(), hole[i] = rnd() < .08;
        if (scene & 1) r.hole = hole;
        r.eye = (exact_eye_t){20 * rnd() - 6, 20 * rnd() - 6, 8 * rnd() - 2, scene % 3 != 0};
        for (int family = 0; family < 2; family++)
            for (int line = 0; line < (family ? r.nx : r.ny); line++)
                for (int k = 0; k + 1 < (family ? r.ny : r.nx); k++) {
                    exact_point_t p[2];
                    surface_ref_edge(&r, family, line, k, &h, &e);
                    surface_ref_edge_ends(&r, family, line, k, p);
                    for (int s = 0; s < 7; s++) {
                        double t = rnd();
                        int i = family ? line : k, j = family ? k : line;
                        int c = crude(&r, p[0].x + t * (p[1].x - p[0].x), p[0].y + t * (p[1].y - p[0].y),
                                      p[0].z + t * (p[1].z - p[0].z), i, i + !family, j, j + family);
                        if (c < 0) continue;
                        int exact = 0;
                        for (size_t n = 0; n < h.n; n++) exact |= t > h.s[n].a && t < h.s[n].b;
                        for (size_t n = 0; n < e.n; n++)
                            if (t > e.s[n].a && t < e.s[n].b) exact = c;
                        if (exact != c) fail_msg("scene %d family %d line %d at %.9f", scene, family, line, k + t);
                        asked++;
                        hidden_points += c;
                    }
                }
    }
    spans_free(&h);
    spans_free(&e);
    print_message("# reference: %ld sampled points agree, %ld of them hidden\n", asked, hidden_points);
    assert_true(hidden_points > asked / 10);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_ridge),
        cmocka_unit_test(test_grid_plane),
        cmocka_unit_test(test_shadow),
        cmocka_unit_test(test_over_vertex),
        cmocka_unit_test(test_hole),
        cmocka_unit_test(test_sheets),
        cmocka_unit_test(test_random_against_crude),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
