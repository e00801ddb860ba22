/* test_crop.c - lines of data end where they cross the ranges of x and y. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "session_fixture.h"

enum { NX = 7, NY = 5 };

/* What a cut line is at (x, y): between its grid's points, for a surface that is bilinear in them. */
static double height(double x, double y) {
    return 3 * x - 2 * y + x * y;
}

static num_t num(double v) {
    const num_t a = num_from_decimal((uint64_t)lrint(fabs(v) * 1e6), -6);
    return v < 0 ? num_neg(a) : a;
}

/* A grid of any orientation: x from 0 and y from 10 in steps of 1, its rows and columns the one or the other way. */
static void make(data_grid_t *g, data_pool_t *pool, bool inner_x, bool down) {
    enum data_grid_trouble trouble;
    const int inner = inner_x ? NX : NY, outer = inner_x ? NY : NX;
    data_grid_start(g, pool);
    for (int o = 0; o < outer; o++) {
        for (int i = 0; i < inner; i++) {
            const int a = down ? inner - 1 - i : i, b = down ? outer - 1 - o : o;
            const double x = inner_x ? a : b, y = 10 + (inner_x ? b : a);
            assert_int_equal(data_grid_point(g, num(x), num(y), num(height(x, y)), &trouble), 0);
        }
        assert_int_equal(data_grid_break(g, &trouble), 0);
    }
    assert_int_equal(data_grid_finish(g, &trouble), 0);
}

/* The lines along one axis, limits given or not, against the surface itself. */
static void check(const data_grid_t *g, bool along_y, const double lim[2], bool limited) {
    data_crop_t c;
    surface_t s;
    const double first = along_y ? 10 : 0, last = along_y ? 10 + NY - 1 : NX - 1, slack = 1e-6;
    const num_t at[2] = {num(lim[0]), num(lim[1])}, wide[2] = {num(lim[0] - slack), num(lim[1] + slack)};
    const num_t *x_lim = limited && !along_y ? wide : NULL, *y_lim = limited && along_y ? wide : NULL;
    assert_int_equal(data_crop_lines(g, x_lim, y_lim, at, along_y, &c, &s), 0);
    const int n = along_y ? s.ny : s.nx;
    double from = limited && lim[0] > first ? lim[0] : first, to = limited && lim[1] < last ? lim[1] : last;
    for (int j = 0; j < s.ny; j++)
        for (int i = 0; i < s.nx; i++) {
            const double x = fixture_double(s.x_of(s.ctx, i)), y = fixture_double(s.y_of(s.ctx, j));
            assert_true(fabs(fixture_double(s.z_of(s.ctx, i, j)) - height(x, y)) < 1e-9);
        }
    const double ends[2] = {fixture_double(along_y ? s.y_of(s.ctx, 0) : s.x_of(s.ctx, 0)),
                            fixture_double(along_y ? s.y_of(s.ctx, n - 1) : s.x_of(s.ctx, n - 1))};
    assert_true(fabs(ends[0] - from) < 2e-6 && fabs(ends[1] - to) < 2e-6);
    assert_int_equal(n, (int)(floor(to) - ceil(from)) + 1 + (ceil(from) > from + slack) + (floor(to) < to - slack));
}

static void lines_end_at_the_limits(void **state) {
    (void)state;
    static packed_t memory[200];
    static const double xs[][2] = {{1.25, 4.5}, {1, 5}, {0.9999999, 5.0000001}, {-3, 3.75}, {2.5, 99}, {-1, 7}};
    for (int k = 0; k < 4; k++) {
        data_pool_t pool = {memory, 0, 200};
        data_grid_t g;
        make(&g, &pool, k & 1, k & 2);
        for (size_t i = 0; i < sizeof xs / sizeof xs[0]; i++) {
            const double ys[2] = {10 + xs[i][0] / 2, 10 + xs[i][1] / 2};
            check(&g, false, xs[i], true);
            check(&g, true, ys, true);
            check(&g, true, ys, false);
        }
    }
}

/* Of the session: only where nothing is hidden; the grid itself stays as it is. */
static void only_without_hidden3d(void **state) {
    (void)state;
    fixture_t *f = fixture_new();
    fixture_file(f, 0, "g", "0 0 1\n1 0 2\n2 0 4\n3 0 1\n\n0 1 5\n1 1 6\n2 1 7\n3 1 8\n\n0 2 1\n1 2 1\n2 2 1\n3 2 1\n");
    assert_int_equal(fixture_feed(f, "set xrange [0.5:2.25]; splot 'g'"), 0);
    assert_int_equal(f->rows_nx, 2);
    assert_int_equal(fixture_feed(f, "unset hidden3d; replot"), 0);
    assert_int_equal(f->item[0].nx, 2);
    assert_int_equal(f->rows_nx, 4);
    assert_int_equal(f->rows_ny, 3);
    assert_int_equal(f->cols_nx, 2);
    assert_int_equal(f->cols_ny, 3);
    assert_int_equal(fixture_feed(f, "set xrange [1:3]; set yrange [0:0.5]; replot"), ERR_EMPTY);
    free(f);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lines_end_at_the_limits),
        cmocka_unit_test(only_without_hidden3d),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
