/* Does simplify keep its word: original vertices, within the tolerance, turning points kept? */
#include "path/simplify.h"
#include "path_scene.h"
#include <math.h>

#define TOL 51
#define MANY 2000

/* Distance from p to the segment a-b. */
static double away(page_point_t p, page_point_t a, page_point_t b) {
    double vx = (double)b.x_lat - a.x_lat, vy = (double)b.y_lat - a.y_lat;
    double wx = (double)p.x_lat - a.x_lat, wy = (double)p.y_lat - a.y_lat;
    double length = vx * vx + vy * vy, t = length > 0 ? (vx * wx + vy * wy) / length : 0;
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    return hypot(wx - t * vx, wy - t * vy);
}

static bool same(page_point_t a, page_point_t b) {
    return a.x_lat == b.x_lat && a.y_lat == b.y_lat;
}

/* Feeds one stroke, and returns what came out. */
static drawn_t run(const page_point_t *in, int n, int32_t tol) {
    drawn_t d = {0};
    simplify_t s;
    simplify_init(&s, tol, drawn_sink(&d));
    assert_int_equal(simplify_move(&s, in[0]), 0);
    for (int i = 1; i < n; i++) assert_int_equal(simplify_draw(&s, in[i]), 0);
    assert_int_equal(simplify_finish(&s), 0);
    return d;
}

/* Every vertex left out lies within tol of the segment that replaced it. Vertices may repeat, so a match is searched
 * for segment by segment: the farthest reach of each segment's end that still satisfies the bound. Returns the worst
 * distance. */
static double check(const page_point_t *in, int n, const drawn_t *d, int32_t tol) {
    double worst = 0;
    int i = 0;
    if (d->n == 0) {
        for (int k = 1; k < n; k++) assert_true(same(in[0], in[k]));
        return 0;
    }
    assert_false(d->down[0]);
    assert_true(same(d->p[0], in[0]));
    assert_true(same(d->p[d->n - 1], in[n - 1]));
    for (int k = 1; k < d->n; k++) {
        double largest = 0;
        int j = i;
        assert_true(d->down[k]);
        assert_false(same(d->p[k], d->p[k - 1]));
        for (;; j++) {
            assert_true(j < n);
            double a = away(in[j], d->p[k - 1], d->p[k]);
            assert_true(a <= tol + 1e-6);
            if (a > largest) largest = a;
            if (same(in[j], d->p[k]) && j > i) break;
        }
        if (largest > worst) worst = largest;
        i = j;
    }
    for (; i < n; i++) assert_true(same(in[i], in[n - 1]));
    return worst;
}

static void a_straight_line_is_one_segment(void **state) {
    page_point_t p[100];
    (void)state;
    for (int dir = 0; dir < 8; dir++) {
        int dx[] = {1, 1, 0, -1, -1, -1, 0, 1}, dy[] = {0, 1, 1, 1, 0, -1, -1, -1};
        for (int i = 0; i < 100; i++) p[i] = (page_point_t){500 + 13 * i * dx[dir], 700 + 13 * i * dy[dir]};
        for (int32_t tol = 0; tol <= TOL; tol += TOL) {
            drawn_t d = run(p, 100, tol);
            assert_int_equal(d.n, 2);
            check(p, 100, &d, tol);
            drawn_free(&d);
        }
    }
}

static void a_stroke_that_doubles_back_keeps_its_turning_points(void **state) {
    const page_point_t p[] = {{0, 0}, {100, 0}, {1000, 0}, {400, 0}, {200, 0}, {2000, 0}, {2000, 0}, {0, 0}};
    const int32_t expected[] = {0, 1000, 200, 2000, 0};
    (void)state;
    drawn_t d = run(p, 8, TOL);
    assert_int_equal(d.n, 5);
    for (int i = 0; i < 5; i++) assert_int_equal(d.p[i].x_lat, expected[i]);
    drawn_free(&d);
}

static void turning_points_below_the_tolerance_do_not_count(void **state) {
    const page_point_t p[] = {{0, 0}, {20, 10}, {-15, 5}, {10000, 20}};
    (void)state;
    drawn_t d = run(p, 4, TOL);
    check(p, 4, &d, TOL);
    drawn_free(&d);
}

static void nothing_comes_of_a_stroke_without_length(void **state) {
    const page_point_t p[] = {{7, 7}, {7, 7}, {7, 7}};
    (void)state;
    drawn_t d = run(p, 3, TOL);
    assert_int_equal(d.n, 0);
    drawn_free(&d);
}

static void strokes_are_kept_apart(void **state) {
    drawn_t d = {0};
    simplify_t s;
    (void)state;
    simplify_init(&s, TOL, drawn_sink(&d));
    for (int i = 0; i < 3; i++) {
        assert_int_equal(simplify_move(&s, (page_point_t){1000 * i, 0}), 0);
        assert_int_equal(simplify_draw(&s, (page_point_t){1000 * i + 500, 0}), 0);
        assert_int_equal(simplify_draw(&s, (page_point_t){1000 * i + 900, 0}), 0);
    }
    assert_int_equal(simplify_finish(&s), 0);
    assert_int_equal(d.strokes, 3);
    assert_int_equal(d.n, 6);
    drawn_free(&d);
}

static void a_circle_keeps_the_sagitta_below_the_tolerance(void **state) {
    static page_point_t p[MANY + 1];
    (void)state;
    for (int i = 0; i <= MANY; i++) {
        double a = 2 * 3.14159265358979 * i / MANY;
        p[i] = (page_point_t){(int32_t)lround(1e6 * cos(a)), (int32_t)lround(1e6 * sin(a))};
    }
    drawn_t d = run(p, MANY + 1, TOL);
    double worst = check(p, MANY + 1, &d, TOL);
    /* the longest chord allowed has the sagitta 2 tol (in and out), the shortest worth having tol / 2 */
    assert_in_range(d.n, 200, 700);
    print_message("# simplify: circle of 30 mm radius, %d vertices to %d, worst %.1f of %d lat\n", MANY, d.n, worst,
                  TOL);
    drawn_free(&d);
}

static void the_bound_holds_for_random_strokes(void **state) {
    static page_point_t p[300];
    uint32_t seed = 2463534242u;
    double worst = 0;
    (void)state;
    for (int round = 0; round < 30000; round++) {
        int n = 2 + (int)(next_random(&seed) % 298);
        int32_t reach = 1 << (2 + next_random(&seed) % 18), jitter = 1 << (next_random(&seed) % 8);
        int32_t limit = (1 << 29) - 1, tol = (int32_t)(next_random(&seed) % 120);
        int64_t x = (int64_t)(next_random(&seed) % 1000) * 1000, y = x, vx = 0, vy = 0;
        for (int i = 0; i < n; i++) {
            if (next_random(&seed) % 16 == 0) vx = (int64_t)(next_random(&seed) % (2u * (uint32_t)reach)) - reach;
            if (next_random(&seed) % 16 == 0) vy = (int64_t)(next_random(&seed) % (2u * (uint32_t)reach)) - reach;
            if (next_random(&seed) % 64 == 0) vx = -vx, vy = -vy;
            x += vx + (int64_t)(next_random(&seed) % (uint32_t)jitter);
            y += vy + (int64_t)(next_random(&seed) % (uint32_t)jitter);
            x = x > limit ? limit : x < -limit ? -limit : x;
            y = y > limit ? limit : y < -limit ? -limit : y;
            p[i] = (page_point_t){(int32_t)x, (int32_t)y};
        }
        drawn_t d = run(p, n, tol);
        double w = check(p, n, &d, tol);
        if (tol && w / tol > worst) worst = w / tol;
        drawn_free(&d);
    }
    print_message("# simplify: worst of 30000 random strokes %.3f of the tolerance\n", worst);
}

static void corners_of_the_range(void **state) {
    const int32_t m = (1 << 29) - 1;
    const page_point_t p[] = {{-m, -m}, {m, m}, {-m, m}, {m, -m}, {-m, -m}, {0, 0}, {m, m}, {m, m - 1}, {-m, -m}};
    (void)state;
    drawn_t d = run(p, 9, TOL);
    check(p, 9, &d, TOL);
    assert_int_equal(d.n, 7); /* the middle goes, and one of the two near the corner */
    drawn_free(&d);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_straight_line_is_one_segment),
        cmocka_unit_test(a_stroke_that_doubles_back_keeps_its_turning_points),
        cmocka_unit_test(turning_points_below_the_tolerance_do_not_count),
        cmocka_unit_test(nothing_comes_of_a_stroke_without_length),
        cmocka_unit_test(strokes_are_kept_apart),
        cmocka_unit_test(a_circle_keeps_the_sagitta_below_the_tolerance),
        cmocka_unit_test(the_bound_holds_for_random_strokes),
        cmocka_unit_test(corners_of_the_range),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
