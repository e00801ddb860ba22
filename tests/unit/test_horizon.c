/* The horizon kernel against brute force in floating point: a point of a profile is visible if in its vertical plane
 * through the eye it is above everything nearer or below everything nearer. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "error.h"
#include "hidden/surface/horizon.h"
#include "tests/oracle/num_of.h"
#define DICE_SEED 1
#include "tests/unit/dice.h"

#define PROFILES 30
#define POINTS 25

/* Profiles along y = k, points with their own x, height NAN in a gap. */
typedef struct terrain {
    int n[PROFILES];
    double x[PROFILES][POINTS], z[PROFILES][POINTS];
    double eye[3];
    int perspective;
} terrain_t;

static int32_t points(void *ctx, int32_t k) {
    return ((terrain_t *)ctx)->n[k];
}

static void point(void *ctx, int32_t k, int32_t v, num_t xyz[3]) {
    terrain_t *t = ctx;
    xyz[0] = num_of(t->x[k][v]);
    xyz[1] = num_from_i64(k);
    xyz[2] = isnan(t->z[k][v]) ? num_undef() : num_of(t->z[k][v]);
}

static void make(terrain_t *t, int kind, int perspective) {
    for (int k = 0; k < PROFILES; k++) {
        t->n[k] = 3 + (int)(uniform() * (POINTS - 3));
        double left = -5 - 3 * uniform(), right = 5 + 3 * uniform();
        for (int i = 0; i < t->n[k]; i++) {
            t->x[k][i] =
                left + (right - left) * (i + (i == 0 || i == t->n[k] - 1 ? 0 : 0.8 * uniform())) / (t->n[k] - 1);
            double x = t->x[k][i];
            t->z[k][i] = kind == 0   ? 4 * uniform()
                         : kind == 1 ? 3 * sin(x * 0.7 + k * 0.3) + 0.2 * k
                                     : floor(3 * uniform());
            if (kind == 2 && uniform() < 0.05) t->z[k][i] = NAN;
        }
    }
    t->perspective = perspective;
    t->eye[0] = 6 * uniform() - 3;
    t->eye[1] = -1 - 20 * uniform();
    t->eye[2] = 12 * uniform() - 4;
    if (!perspective) t->eye[0] = 0;
}

typedef struct drawn {
    unsigned char *seen; /* per profile, segment and sample */
    int twice;
} drawn_t;

#define SAMPLES 16

static int take(void *ctx, const ink_piece_t *p) {
    drawn_t *d = ctx;
    assert_int_equal(p->family, INK_PROFILE);
    double from = ldexp((double)p->from, -30), to = ldexp((double)p->to, -30);
    for (int i = 0; i < POINTS * SAMPLES; i++) {
        double at = (i + 0.5) / SAMPLES;
        unsigned char *s = &d->seen[p->line * POINTS * SAMPLES + i];
        if (at >= from && at <= to) d->twice += (*s)++;
    }
    return 0;
}

/* Pencil coordinates in floating point. */
static double a_of(const terrain_t *t, double x, double y) {
    return t->perspective ? (x - t->eye[0]) / (y - t->eye[1]) : x;
}
static double w_of(const terrain_t *t, double y, double z) {
    return t->perspective ? (z - t->eye[2]) / (y - t->eye[1]) : z - t->eye[2] / t->eye[1] * y;
}

/* +1 visible, -1 hidden, 0 too close to call. */
static int truth(const terrain_t *t, int k, double a, double w, int infinite) {
    double top = -INFINITY, bottom = INFINITY, near = 1e-6;
    for (int n = 0; n < k; n++) {
        for (int i = 0; i + 1 < t->n[n]; i++) {
            if (isnan(t->z[n][i]) || isnan(t->z[n][i + 1])) continue;
            double a0 = a_of(t, t->x[n][i], n), a1 = a_of(t, t->x[n][i + 1], n);
            if (fabs(a - a0) < near || fabs(a - a1) < near) return 0;
            if (a < a0 || a > a1) continue;
            double f = (a - a0) / (a1 - a0), w0 = w_of(t, n, t->z[n][i]), w1 = w_of(t, n, t->z[n][i + 1]);
            top = fmax(top, w0 + f * (w1 - w0));
            bottom = fmin(bottom, w0 + f * (w1 - w0));
        }
    }
    if (fabs(w - top) < near || (!infinite && fabs(w - bottom) < near)) return 0;
    return w > top || (!infinite && w < bottom) ? 1 : -1;
}

static void test_against_brute_force(void **state) {
    (void)state;
    static terrain_t t;
    static unsigned char seen[PROFILES * POINTS * SAMPLES];
    static uint64_t memory[4000];
    int judged = 0, wrong = 0;
    for (int scene = 0; scene < 120; scene++) {
        make(&t, scene % 3, scene / 3 % 2);
        int infinite = scene / 6 % 2;
        memset(seen, 0, sizeof seen);
        drawn_t d = {seen, 0};
        profiles_t p = {.count = PROFILES, .max_points = POINTS, .ctx = &t, .points = points, .point = point};
        p.side[0] = p.away[1] = num_from_i64(1);
        p.side[1] = p.away[0] = num_from_i64(0);
        camera_t cam = {.perspective = t.perspective, .eye = {num_of(t.eye[0]), num_of(t.eye[1]), num_of(t.eye[2])}};
        ink_sink_t sink = {&d, take};
        hidden_job_t job = {memory, sizeof memory, &sink, NULL, NULL, 0, NULL};
        hidden_stats_t st;
        assert_int_equal(horizon_draw(&p, &cam, infinite, &job, &st), 0);
        assert_int_equal(d.twice, 0);
        for (int k = 0; k < PROFILES; k++) {
            for (int i = 0; i < (t.n[k] - 1) * SAMPLES; i++) {
                int v = i / SAMPLES;
                double f = (i % SAMPLES + 0.5) / SAMPLES;
                double x = t.x[k][v] + f * (t.x[k][v + 1] - t.x[k][v]), z = t.z[k][v] + f * (t.z[k][v + 1] - t.z[k][v]);
                int drawn = seen[k * POINTS * SAMPLES + i];
                if (isnan(z)) {
                    assert_int_equal(drawn, 0);
                    continue;
                }
                int want = truth(&t, k, a_of(&t, x, k), w_of(&t, k, z), infinite);
                judged += want != 0;
                wrong += want != 0 && (want > 0) != (drawn != 0);
            }
        }
    }
    print_message("# horizon: 120 random terrains, %d points judged, %d wrong\n", judged, wrong);
    assert_true(judged > 100000);
    assert_int_equal(wrong, 0);
}

static void test_too_small(void **state) {
    (void)state;
    static terrain_t t;
    static unsigned char seen[PROFILES * POINTS * SAMPLES];
    make(&t, 0, 1);
    drawn_t d = {seen, 0};
    profiles_t p = {.count = PROFILES, .max_points = POINTS, .ctx = &t, .points = points, .point = point};
    p.side[0] = p.away[1] = num_from_i64(1);
    p.side[1] = p.away[0] = num_from_i64(0);
    camera_t cam = {.perspective = true, .eye = {num_of(t.eye[0]), num_of(t.eye[1]), num_of(t.eye[2])}};
    uint64_t memory[20];
    ink_sink_t sink = {&d, take};
    hidden_job_t job = {memory, sizeof memory, &sink, NULL, NULL, 0, NULL};
    hidden_stats_t st;
    assert_int_equal(horizon_draw(&p, &cam, false, &job, &st), ERR_FULL);
    job.bytes = 16;
    assert_int_equal(horizon_draw(&p, &cam, false, &job, &st), ERR_FULL);
}

static num_t paraboloid(void *ctx, num_t x, num_t y) {
    (void)ctx;
    return num_add(num_mul(x, x), num_mul(y, y));
}

/* Sampled profiles lie on the rectangle's border at both ends, in planes square to the view, nearest first. */
static void test_sampled(void **state) {
    (void)state;
    for (int view = 0; view < 40; view++) {
        camera_t cam = {.perspective = view & 1};
        double angle = view < 8 ? view / 2 * 1.5707963267948966 : 7 * uniform();
        double ex = 9 * cos(angle), ey = 9 * sin(angle);
        if (view < 8) ex = round(ex), ey = round(ey);
        cam.eye[0] = num_of(ex), cam.eye[1] = num_of(ey), cam.eye[2] = num_from_i64(3);
        profiles_sampled_t s = {.z_of = paraboloid, .samples = 9};
        s.x0 = s.y0 = num_from_i64(-2);
        s.x1 = num_from_i64(2), s.y1 = num_from_i64(3);
        profiles_t p;
        assert_int_equal(profiles_from_function(&p, &s, &cam, 11), 0);
        double before = -INFINITY;
        int crossing = 0;
        for (int32_t k = 0; k < p.count; k++) {
            int32_t n = p.points(p.ctx, k);
            if (n == 0) continue;
            crossing++;
            assert_int_equal(n, 9);
            double left = -INFINITY, depth = 0;
            for (int32_t v = 0; v < n; v++) {
                num_t q[3];
                p.point(p.ctx, k, v, q);
                double x = ldexp((double)q[0].m, q[0].e), y = ldexp((double)q[1].m, q[1].e),
                       z = ldexp((double)q[2].m, q[2].e);
                double fx = cam.perspective ? 0 - ex : -ex, fy = cam.perspective ? 0.5 - ey : -ey;
                double u = x * fy - y * fx, d = x * fx + y * fy;
                assert_true(fabs(z - x * x - y * y) < 1e-12);
                assert_true(x >= -2 && x <= 2 && y >= -2 && y <= 3);
                if (v == 0 || v == n - 1) assert_true(x == -2 || x == 2 || y == -2 || y == 3);
                assert_true(u > left);
                assert_true(v == 0 || fabs(d - depth) < 1e-9);
                left = u, depth = d;
            }
            assert_true(depth > before);
            before = depth;
        }
        assert_true(crossing >= 9);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_against_brute_force),
        cmocka_unit_test(test_too_small),
        cmocka_unit_test(test_sampled),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
