/* Several surfaces over one grid against brute force: a point of an edge is hidden if on its way to the eye the line of
 * sight changes sides of any surface between entering a cell and leaving it. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "error.h"
#include "hidden/surface/perimeter.h"
#include "tests/oracle/num_of.h"
#define DICE_SEED 11
#include "tests/unit/dice.h"

#define N 9
#define SURFACES 3
#define SAMPLES 24

/* Points (i, j), heights z or NAN. */
typedef struct scene {
    int surfaces, perspective;
    double z[SURFACES][N][N], eye[3];
} scene_t;

typedef struct one {
    const scene_t *s;
    int m;
} one_t;

static num_t axis_of(void *ctx, int32_t k) {
    (void)ctx;
    return num_from_i64(k);
}

static num_t height_of(void *ctx, int32_t i, int32_t j) {
    const one_t *o = ctx;
    double z = o->s->z[o->m][j][i];
    return isnan(z) ? num_undef() : num_of(z);
}

static void make(scene_t *s, int round) {
    s->surfaces = 1 + round % SURFACES;
    s->perspective = round % 4 != 0;
    for (int m = 0; m < SURFACES; m++) {
        for (int j = 0; j < N; j++) {
            for (int i = 0; i < N; i++) {
                double wave = sin(i * 0.9 + round) * cos(j * 0.7 - round);
                s->z[m][j][i] = round % 5 == 0   ? 3 * uniform()           /* crossing everywhere */
                                : round % 5 == 1 ? wave + 1.5 * m          /* one above the other */
                                : round % 5 == 2 ? 2 * wave * (m ? m : -1) /* crossing in lines */
                                                 : wave + 0.4 * m + uniform() * 0.3;
                if (round % 7 == 3 && uniform() < 0.1) s->z[m][j][i] = NAN;
            }
        }
    }
    bool inside = round % 6 == 5 && s->perspective;
    s->eye[0] = inside ? 0.3 + 7.4 * uniform() : 30 * uniform() - 11;
    s->eye[1] = inside ? 0.3 + 7.4 * uniform() : -0.5 - 9 * uniform();
    s->eye[2] = inside ? (uniform() < 0.5 ? 6 + 3 * uniform() : -5 - 3 * uniform()) : 12 * uniform() - 4;
    if (!s->perspective) { /* a direction */
        s->eye[0] = 2 * uniform() - 1, s->eye[1] = -1, s->eye[2] = 1.4 * uniform() - 0.4;
    }
    if (round % 3 == 1 && round % 7 != 3) s->eye[0] = nearbyint(s->eye[0]); /* often in a plane of grid lines */
}

static bool has_facet(const scene_t *s, int m, int i, int j) {
    if (i < 0 || j < 0 || i > N - 2 || j > N - 2) return false;
    return !isnan(s->z[m][j][i] + s->z[m][j + 1][i] + s->z[m][j][i + 1] + s->z[m][j + 1][i + 1]);
}

/* Height of surface m at a point on a grid line. */
static double edge_height(const scene_t *s, int m, double x, double y) {
    if (fabs(x - round(x)) < fabs(y - round(y))) {
        int i = (int)round(x), j = (int)fmin(fmax(floor(y), 0), N - 2);
        return s->z[m][j][i] + (y - j) * (s->z[m][j + 1][i] - s->z[m][j][i]);
    }
    int j = (int)round(y), i = (int)fmin(fmax(floor(x), 0), N - 2);
    return s->z[m][j][i] + (x - i) * (s->z[m][j][i + 1] - s->z[m][j][i]);
}

/* +1 visible, -1 hidden, 0 too close to call: p on an edge of surface own. */
static int truth(const scene_t *s, int own, const double p[3]) {
    double dir[3], cut[4 * N + 2];
    int cuts = 0;
    for (int k = 0; k < 3; k++) dir[k] = s->perspective ? s->eye[k] - p[k] : s->eye[k];
    cut[cuts++] = 0;
    for (int axis = 0; axis < 2; axis++) {
        for (int k = 0; k < N && dir[axis] != 0; k++) {
            double t = (k - p[axis]) / dir[axis];
            if (t > 1e-7 && (!s->perspective || t < 1)) cut[cuts++] = t;
        }
    }
    for (int a = 1; a < cuts; a++) {
        for (int b = a; b > 0 && cut[b - 1] > cut[b]; b--) {
            double swap = cut[b];
            cut[b] = cut[b - 1], cut[b - 1] = swap;
        }
    }
    if (s->perspective) cut[cuts++] = 1; /* in the eye's own cell */
    for (int c = 0; c + 1 < cuts; c++) {
        double t0 = cut[c], t1 = cut[c + 1], tm = (t0 + t1) / 2;
        int i = (int)floor(p[0] + tm * dir[0]), j = (int)floor(p[1] + tm * dir[1]);
        if (t1 - t0 < 1e-6) return 0;
        if (dir[0] == 0 && i == N - 1) i--; /* along the last column: seen from its one side */
        for (int m = 0; m < s->surfaces; m++) {
            if (!has_facet(s, m, i, j)) continue;
            double at[2][2] = {{p[0] + t0 * dir[0], p[1] + t0 * dir[1]}, {p[0] + t1 * dir[0], p[1] + t1 * dir[1]}};
            double far = p[2] + t0 * dir[2] - edge_height(s, m, at[0][0], at[0][1]), near;
            if (s->perspective && t1 == 1) {
                near = s->eye[2] > 3.5 ? 1 : -1; /* inside scenes: above or below all surfaces */
                if (s->eye[2] <= 6 && s->eye[2] >= -5) return 0;
            } else {
                near = p[2] + t1 * dir[2] - edge_height(s, m, at[1][0], at[1][1]);
            }
            if (c == 0 && m == own) continue;
            if (fabs(far) < 2e-4 || fabs(near) < 2e-4) return 0;
            if ((far < 0) != (near < 0)) return -1;
        }
    }
    return 1;
}

typedef struct drawn {
    unsigned char seen[SURFACES][2][N][(N - 1) * SAMPLES];
    int twice;
} drawn_t;

static int take(void *ctx, const ink_piece_t *p) {
    drawn_t *d = ctx;
    double from = ldexp((double)p->from, -INK_GRID_BITS), to = ldexp((double)p->to, -INK_GRID_BITS);
    for (int i = 0; i < (N - 1) * SAMPLES; i++) {
        double at = (i + 0.5) / SAMPLES;
        if (at >= from && at <= to) d->twice += d->seen[p->surface][p->family][p->line][i]++;
    }
    return 0;
}

static void test_several(void **state) {
    (void)state;
    static drawn_t d;
    static scene_t s;
    static uint64_t memory[20000];
    int judged = 0, wrong = 0, hidden = 0;
    for (int round = 0; round < 240; round++) {
        make(&s, round);
        memset(&d, 0, sizeof d);
        one_t one[SURFACES];
        surface_t src[SURFACES];
        grid_t grid[SURFACES], *list[SURFACES];
        for (int m = 0; m < s.surfaces; m++) {
            one[m] = (one_t){&s, m};
            src[m] = (surface_t){N, N, &one[m], axis_of, axis_of, height_of, NULL, NULL};
            assert_int_equal(grid_measure(&grid[m], &src[m], NULL, NULL, NULL, NULL, NULL), 0);
            list[m] = &grid[m];
        }
        camera_t cam = {.perspective = s.perspective};
        for (int k = 0; k < 3; k++) cam.eye[k] = num_of(s.eye[k]);
        ink_sink_t sink = {&d, take};
        hidden_job_t job = {memory, sizeof memory, &sink, NULL, NULL, 0, NULL};
        hidden_stats_t st;
        assert_int_equal(perimeter_draw_several(list, s.surfaces, &cam, &job, &st), 0);
        assert_int_equal(d.twice, 0);
        for (int m = 0; m < s.surfaces; m++) {
            for (int family = 0; family < 2; family++) {
                for (int line = 0; line < N; line++) {
                    for (int q = 0; q < (N - 1) * SAMPLES; q++) {
                        int k = q / SAMPLES, i = family ? line : k, j = family ? k : line;
                        double f = (q % SAMPLES + 0.5) / SAMPLES, z0 = s.z[m][j][i],
                               z1 = s.z[m][j + !!family][i + !family];
                        double p[3] = {i + (family ? 0 : f), j + (family ? f : 0), z0 + f * (z1 - z0)};
                        bool exists = has_facet(&s, m, i, j) || has_facet(&s, m, i - family, j - !family);
                        bool ink = d.seen[m][family][line][q] != 0;
                        if (!exists) {
                            assert_false(ink);
                            continue;
                        }
                        int want = truth(&s, m, p);
                        judged += want != 0;
                        hidden += want < 0;
                        wrong += want != 0 && (want > 0) != ink;
                    }
                }
            }
        }
    }
    print_message("# several surfaces: 240 scenes, %d points judged, %d of them hidden, %d wrong\n", judged, hidden,
                  wrong);
    assert_true(judged > 500000 && hidden > 100000);
    assert_int_equal(wrong, 0);
}

static num_t half_axis(void *ctx, int32_t k) {
    (void)ctx;
    return num_from_fixed(k, 1);
}

static void test_refusals(void **state) {
    (void)state;
    static scene_t s;
    static uint64_t memory[2000];
    static drawn_t d;
    make(&s, 1);
    one_t one = {&s, 0};
    surface_t a = {N, N, &one, axis_of, axis_of, height_of, NULL, NULL},
              b = {N, N, &one, half_axis, axis_of, height_of, NULL, NULL};
    grid_t ga, gb, *list[2] = {&ga, &gb};
    grid_measure(&ga, &a, NULL, NULL, NULL, NULL, NULL);
    grid_measure(&gb, &b, NULL, NULL, NULL, NULL, NULL);
    camera_t cam = {.perspective = true, .eye = {num_from_i64(4), num_from_i64(-9), num_from_i64(5)}};
    ink_sink_t sink = {&d, take};
    hidden_job_t job = {memory, sizeof memory, &sink, NULL, NULL, 0, NULL};
    hidden_stats_t st;
    assert_int_equal(perimeter_draw_several(list, 2, &cam, &job, &st), ERR_UNSUPPORTED);
    list[1] = &ga;
    for (size_t bytes = 0; bytes < 6000; bytes += 40) {
        job.bytes = bytes / 8 * 8;
        int err = perimeter_draw_several(list, 2, &cam, &job, &st);
        assert_true(err == ERR_FULL || err == 0);
        assert_true(st.bytes <= job.bytes || err == ERR_FULL);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_several),
        cmocka_unit_test(test_refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
