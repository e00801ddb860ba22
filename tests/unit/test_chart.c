/* Charts: what lies on one line of sight has the same coordinates, directions go round counter-clockwise, higher is
 * higher, and what is far away fills the scale as well as what is near. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "tests/oracle/num_of.h"
#include "view/chart_around.h"

#define MOST 16

typedef struct field {
    int nx, ny;
    double x[MOST], y[MOST], z[MOST][MOST];
} field_t;

static num_t x_of(void *ctx, int32_t i) {
    return num_of(((field_t *)ctx)->x[i]);
}
static num_t y_of(void *ctx, int32_t j) {
    return num_of(((field_t *)ctx)->y[j]);
}
static num_t z_of(void *ctx, int32_t i, int32_t j) {
    return num_of(((field_t *)ctx)->z[j][i]);
}

typedef struct charted {
    surface_t src;
    grid_t grid;
    camera_t cam;
    chart_t chart;
    chart_column_t column[MOST];
    pencil_t at[MOST][MOST];
    int64_t dz[MOST][MOST];
} charted_t;

static void draw(charted_t *c, field_t *f, bool perspective, double ex, double ey, double ez) {
    c->src = (surface_t){f->nx, f->ny, f, x_of, y_of, z_of, NULL, NULL};
    assert_int_equal(grid_measure(&c->grid, &c->src, NULL, NULL, NULL, NULL, NULL), 0);
    c->cam = (camera_t){.perspective = perspective, .eye = {num_of(ex), num_of(ey), num_of(ez)}};
    grid_t *list = &c->grid;
    chart_init(&c->chart, &list, 1, &c->cam, c->column);
    for (int32_t j = 0; j < f->ny; j++) {
        chart_line_t line = {.at = c->at[j], .z = c->dz[j]};
        chart_row(&c->chart, list, j, &line);
    }
}

/* x and y are the eye's plus powers of two times 1, 3 and 5, one way or both, so many vertices lie on one ray from the
 * eye; heights put them on one line of sight. */
static void powers(double *v, int *n, double eye, bool both) {
    static const double step[] = {1, 2, 3, 4, 5, 6, 8, 10};
    *n = 0;
    for (int k = 7; both && k >= 0; k--) v[(*n)++] = eye - step[k];
    for (int k = 0; k < 8; k++) v[(*n)++] = eye + step[k];
}

static void check_rays(const charted_t *c, const field_t *f, double ex, double ey) {
    int pairs = 0;
    for (int a = 0; a < f->nx * f->ny; a++) {
        for (int b = 0; b < a; b++) {
            int i = a % f->nx, j = a / f->nx, k = b % f->nx, l = b / f->nx;
            double ax = f->x[i] - ex, ay = f->y[j] - ey, bx = f->x[k] - ex, by = f->y[l] - ey;
            double cross = ax * by - ay * bx;
            pencil_t p = c->at[j][i], q = c->at[l][k];
            if (p.a == CHART_NONE || q.a == CHART_NONE) continue;
            assert_true(abs(p.a) <= PENCIL_LIMIT && abs(p.w) <= PENCIL_LIMIT);
            if (cross == 0 && ax * bx + ay * by > 0) {
                pairs++;
                assert_true(abs(p.a - q.a) <= 1 && abs(p.w - q.w) <= 2);
            } else if (c->chart.kind != CHART_AROUND) {
                assert_true(cross > 0 ? p.a < q.a : p.a > q.a);
            }
        }
    }
    assert_true(pairs > 20);
}

static void test_rays(void **state) {
    (void)state;
    static const struct {
        double ex, ey;
        bool both_x, both_y;
        enum chart_kind kind;
    } view[] = {
        {0.25, -7.25, true, false, CHART_NORTH},
        {100, 0.125, false, true, CHART_EAST},
        {3, 5, true, true, CHART_AROUND},
        {0, 0, false, false, CHART_AROUND},
    };
    static charted_t c;
    static field_t f;
    for (size_t v = 0; v < sizeof view / sizeof *view; v++) {
        for (int up = -1; up <= 1; up++) {
            const double ez = 2;
            powers(f.x, &f.nx, view[v].ex, view[v].both_x);
            powers(f.y, &f.ny, view[v].ey, view[v].both_y);
            for (int j = 0; j < f.ny; j++) {
                for (int i = 0; i < f.nx; i++) {
                    f.z[j][i] = ez + up * (fabs(f.x[i] - view[v].ex) + 2 * fabs(f.y[j] - view[v].ey));
                }
            }
            draw(&c, &f, true, view[v].ex, view[v].ey, ez);
            assert_int_equal(c.chart.kind, view[v].kind);
            check_rays(&c, &f, view[v].ex, view[v].ey);
        }
    }
}

/* Single sectors, from near to a million times the scene's size: rows and columns seen from outside. The exact
 * coordinates up to an affine map are compared at all vertices: it is fixed by three of them. */
static void test_single(void **state) {
    (void)state;
    static charted_t c;
    static field_t f;
    double worst = 0;
    for (int view = 0; view < 200; view++) {
        f.nx = f.ny = MOST;
        for (int k = 0; k < MOST; k++) f.x[k] = k + 0.25 * (k * 7 % 3), f.y[k] = 2 * k + 0.5 * (k * 5 % 3);
        for (int j = 0; j < MOST; j++) {
            for (int i = 0; i < MOST; i++) f.z[j][i] = sin(i * 1.3 + j * j * 0.7) * 3;
        }
        double away = pow(10, 1.2 + view % 6), angle = view * 0.37;
        double e[3] = {8 + away * cos(angle), 15 + away * sin(angle), away * (view % 5 - 2) * 0.3};
        draw(&c, &f, true, e[0], e[1], e[2]);
        if (c.chart.kind == CHART_AROUND) continue;
        bool north = c.chart.kind == CHART_NORTH;
        /* a is affine in num / den with num, den linear in the plan: fit it at three vertices. */
        int64_t span_a = 0, span_w = 0;
        for (int n = 0; n < MOST * MOST; n++) {
            span_a = llabs(c.at[n / MOST][n % MOST].a) > span_a ? llabs(c.at[n / MOST][n % MOST].a) : span_a;
            span_w = llabs(c.at[n / MOST][n % MOST].w) > span_w ? llabs(c.at[n / MOST][n % MOST].w) : span_w;
        }
        assert_true(span_a > 1 << 28 && span_w > 1 << 26);
        long double slope[2][3];
        for (int k = 0; k < 3; k++) {
            int i = k == 1 ? MOST - 1 : 0, j = k == 2 ? MOST - 1 : 0;
            long double dx = (long double)f.x[i] - e[0], dy = (long double)f.y[j] - e[1],
                        dz = (long double)f.z[j][i] - e[2];
            slope[0][k] = north ? dx / dy : dy / dx;
            slope[1][k] = dz / (north ? dy : dx);
        }
        int other = north ? 1 : 2;
        long double scale = (c.at[other == 2 ? MOST - 1 : 0][other == 1 ? MOST - 1 : 0].a - c.at[0][0].a) /
                            (slope[0][other] - slope[0][0]);
        for (int n = 0; n < MOST * MOST; n++) {
            int i = n % MOST, j = n / MOST;
            long double dx = (long double)f.x[i] - e[0], dy = (long double)f.y[j] - e[1];
            long double a = c.at[0][0].a + scale * ((north ? dx / dy : dy / dx) - slope[0][0]);
            worst = fmax(worst, fabs((double)(a - c.at[j][i].a)));
        }
    }
    print_message("# chart: single sectors to 10^6 times the scene's size: worst abscissa %.1f units of 2^30\n", worst);
    assert_true(worst < 16); /* the fit itself divides errors of a unit */
}

/* Parallel views: moving along the direction to the eye changes nothing. */
static void test_parallel(void **state) {
    (void)state;
    static charted_t c;
    static field_t f;
    static const double dir[][3] = {{1, 2, 0.5}, {-2, 1, -1}, {1, 0, 0}, {0, -1, 2}, {-1, -1, 1}};
    for (size_t v = 0; v < sizeof dir / sizeof *dir; v++) {
        f.nx = f.ny = 9;
        for (int k = 0; k < 9; k++) f.x[k] = f.y[k] = k;
        for (int j = 0; j < 9; j++) {
            for (int i = 0; i < 9; i++) {
                /* height of the plane that holds the direction and the horizontal across it */
                double along = (i * dir[v][0] + j * dir[v][1]) / (dir[v][0] * dir[v][0] + dir[v][1] * dir[v][1]);
                f.z[j][i] = along * dir[v][2];
            }
        }
        draw(&c, &f, false, dir[v][0], dir[v][1], dir[v][2]);
        assert_int_equal(c.chart.kind, CHART_PARALLEL);
        for (int j = 0; j < 9; j++) {
            for (int i = 0; i < 9; i++) {
                assert_true(abs(c.at[j][i].w - c.at[0][0].w) <= 3);
                int k = i + (int)dir[v][0], l = j + (int)dir[v][1];
                if (k < 0 || l < 0 || k > 8 || l > 8) continue;
                assert_true(abs(c.at[j][i].a - c.at[l][k].a) <= 2);
            }
        }
    }
    draw(&c, &f, false, 0, 0, 1);
    assert_int_equal(c.chart.kind, CHART_VERTICAL);
}

/* A grid plane through the eye and a plateau level with it get equal integers, not nearly equal ones. */
static void test_exact_ties(void **state) {
    (void)state;
    static charted_t c;
    static field_t f;
    f.nx = f.ny = 10;
    for (int k = 0; k < 10; k++) f.x[k] = k / 3.0, f.y[k] = k / 7.0;
    for (int j = 0; j < 10; j++) {
        for (int i = 0; i < 10; i++) f.z[j][i] = i % 3 ? 0.1 : j * 0.3 - 1;
    }
    draw(&c, &f, true, 4 / 3.0, -2, 0.1);
    assert_int_equal(c.chart.kind, CHART_NORTH);
    for (int j = 0; j < 10; j++) {
        assert_int_equal(c.at[j][4].a, 0);
        for (int i = 0; i < 10; i++) assert_true(i % 3 == 0 || abs(c.at[j][i].w) <= 4);
    }
}

static void test_unproject(void **state) {
    (void)state;
    const int64_t one = (int64_t)1 << 46;
    assert_int_equal(chart_unproject(1 << 29, 7, 7), one / 2);
    assert_int_equal(chart_unproject(0, 1, 9), 0);
    assert_int_equal(chart_unproject(1 << 30, 1, 9), one);
    /* Half-way in the picture, of an edge from distance 1 to distance 3 (reciprocals 3 : 1), is a quarter in space. */
    assert_true(llabs(chart_unproject(1 << 29, 3u << 30, 1u << 30) - one / 4) < 200 << 16);
    /* And of one that reaches a million times as far, a millionth and one of it, to a unit. */
    assert_true(llabs(chart_unproject(1 << 29, 1000000000, 1000) - one / 1000001) <= 1);
}

/* Zones: w grows with the slope, without jumps, as fine as promised. */
static void test_zones(void **state) {
    (void)state;
    static charted_t c;
    static field_t f;
    f = (field_t){.nx = 3, .ny = 3, .x = {-1, 0, 1}, .y = {-1, 0, 1}};
    f.z[0][0] = 1e6;
    draw(&c, &f, true, .25, .25, 0);
    assert_int_equal(c.chart.kind, CHART_AROUND);
    pencil_t last = {0, -1}, at;
    const double d = .5;
    for (double slope = 1e-6; slope < 200000; slope *= 1.0003) {
        const int64_t z = (int64_t)ldexp(slope * d, c.chart.z_bits);
        assert_true(chart_around(&c.chart, 1, (int32_t)ldexp(d, c.chart.x_bits), 0, z, &at));
        assert_true(at.w >= last.w && at.w <= PENCIL_LIMIT);
        pencil_t step, below;
        assert_true(chart_around(&c.chart, 1, (int32_t)ldexp(d, c.chart.x_bits), 0, z + z / 1000000, &step));
        assert_true(slope < 1e-2 || step.w > at.w); /* a millionth of a slope shows */
        assert_true(chart_around(&c.chart, 1, (int32_t)ldexp(d, c.chart.x_bits), 0, -z, &below));
        assert_int_equal(below.w, -at.w);
        last = at;
    }
    for (int k = 0; k < CHART_ZONES - 1; k++) {
        const int32_t border = chart_zone_border[k], x = 1 << 28;
        assert_true(chart_in_one_zone(k ? chart_zone_border[k - 1] : -border, border));
        assert_true(chart_in_one_zone(-border, k ? -chart_zone_border[k - 1] : 0));
        assert_false(chart_in_one_zone(border - 1, border + 1));
        assert_false(chart_in_one_zone(-border - 1, -border + 1));
        assert_false(chart_in_one_zone(-border - 1, border));
        assert_true(chart_around(&c.chart, 1, x, 0, chart_zone_height(&c.chart, k, x), &at));
        assert_true(abs(at.w - border) <= 1);
    }
}

/* An eye so little over or under a part of high cliffs that heights of 31 bits would put it on the other side; and the
 * middle of a surface that is no higher than wide, seen from so close that they would turn lines of sight. */
static void test_seen_from_close(void **state) {
    (void)state;
    field_t f = {2, 2, {-2, 2}, {-2, 2}, {{.5, .5}, {.5, .5}}};
    charted_t c;
    for (int side = -1; side <= 1; side += 2) {
        f.ny = 3, f.y[2] = 6;
        f.z[2][0] = f.z[2][1] = -1.6e6 + 1. / 3;
        draw(&c, &f, true, .3, .2, .5 + side * 1e-5);
        assert_true(c.chart.tall);
        assert_int_equal(chart_seen(&c.chart, &c.grid), side);
        f.z[2][0] = f.z[2][1] = 2;
        draw(&c, &f, true, .3, .2, .5 + side * 1e-5);
        assert_true(c.chart.tall);
        assert_int_equal(chart_seen(&c.chart, &c.grid), side);
        draw(&c, &f, true, .3, .2, 3);
        assert_true(!c.chart.tall);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_seen_from_close), cmocka_unit_test(test_zones),    cmocka_unit_test(test_rays),
        cmocka_unit_test(test_single),          cmocka_unit_test(test_parallel), cmocka_unit_test(test_exact_ties),
        cmocka_unit_test(test_unproject),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
