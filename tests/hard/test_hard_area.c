/* The area sort's hard cases, each from several sides and judged by rays: cyclic overlap of two and of many, faces in
 * one plane, slivers, walls that meet flush, needles near the eye. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "error.h"
#include "tests/oracle/num_of.h"
#include "tests/oracle/run_cases.h"
#include "tests/oracle/solid_scenes.h"

static void polygon(solid_ref_t *r, const double (*p)[3], int n) {
    int v[32];
    for (int k = 0; k < n; k++) v[k] = solid_ref_vertex(r, p[k][0], p[k][1], p[k][2]);
    solid_ref_face(r, v, n);
}

static void box(solid_ref_t *r, double x, double y, double z, double a, double b, double c) {
    int v[8];
    for (int k = 0; k < 8; k++) v[k] = solid_ref_vertex(r, k & 1 ? x + a : x, k & 2 ? y + b : y, k & 4 ? z + c : z);
    static const int side[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (int k = 0; k < 6; k++) {
        const int f[4] = {v[side[k][0]], v[side[k][1]], v[side[k][2]], v[side[k][3]]};
        solid_ref_face(r, f, 4);
    }
}

/* Draws it from all around; returns how many views say that faces cut through each other. */
static int judge_around(const char *name, solid_scene_t *s, bool inside) {
    judge_report_t worst = {0};
    int views = 0, cuts = 0;
    int64_t errors = 0;
    solid_ref_finish(&s->ref);
    for (int x = 0; x <= 180; x += 15)
        for (int z = 0; z < 360; z += 24) {
            judge_report_t r;
            area_stats_t area = {0};
            settings_default(&s->set);
            s->set.view.rot_x = num_from_i64(x);
            s->set.view.rot_z = num_from_i64(z);
            s->set.view.from = inside;
            for (int k = 0; k < 3 && inside; k++)
                s->set.view.eye[k] = num_of((k == 0   ? sin(x * 0.0174) * cos(z * 0.0174)
                                             : k == 1 ? sin(x * 0.0174) * sin(z * 0.0174)
                                                      : cos(x * 0.0174)) *
                                            1.3);
            bool good = solid_scene_judge_area(s, &r, &area);
            cuts += area.intersections > 0;
            errors += area.errors;
            if (!good)
                fail_msg("%s from %d,%d: missing %g mm (edge %d), false %g mm (edge %d)", name, x, z, r.missing_mm,
                         r.missing.line, r.false_mm, r.falsely.line);
            judge_worst(&worst, &r);
            views++;
        }
    print_message(
        "# area sort, %s: %d views, %lld sort errors, %d with cuts; missing %.4f mm, false %.4f, ends %.2f steps\n",
        name, views, (long long)errors, cuts, worst.missing_mm, worst.false_mm, worst.end_steps);
    solid_scene_free(s);
    return cuts;
}

/* Two brackets, each with one arm over and one arm under the other. */
static void two_overlap_cyclically(void **state) {
    (void)state;
    solid_scene_t s = {0};
    static const double a[][3] = {{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {1, 1, 0},
                                  {1, 3, 0}, {4, 3, 0}, {4, 4, 0}, {0, 4, 0}};
    double b[8][3];
    /* turned round, shifted, and tilted about the middle between the arms */
    for (int k = 0; k < 8; k++) {
        b[k][0] = 6.5 - a[k][0];
        b[k][1] = a[k][1] + 0.3;
        b[k][2] = (b[k][1] - 2) * 0.4;
    }
    polygon(&s.ref, a, 8);
    polygon(&s.ref, b, 8);
    assert_int_equal(judge_around("two brackets", &s, false), 0);
}

static void many_overlap_cyclically(void **state) {
    (void)state;
    for (int n = 3; n <= 13; n += 5) {
        solid_scene_t s = {0};
        for (int k = 0; k < n; k++) {
            double p[2][2], q[4][3];
            for (int i = 0; i < 2; i++) {
                double t = 6.283185307179586 * (k + i) / n, u = 6.283185307179586 * (k + 1 - i) / n;
                p[i][0] = cos(t) + .3 * (cos(t) - cos(u));
                p[i][1] = sin(t) + .3 * (sin(t) - sin(u));
            }
            double dx = p[1][0] - p[0][0], dy = p[1][1] - p[0][1], w = 0.2 / n / hypot(dx, dy);
            for (int i = 0; i < 4; i++) {
                int far = i == 1 || i == 2, sign = i < 2 ? 1 : -1;
                q[i][0] = p[far][0] - sign * dy * w;
                q[i][1] = p[far][1] + sign * dx * w;
                q[i][2] = far;
            }
            polygon(&s.ref, (const double(*)[3])q, 4);
        }
        char name[32];
        snprintf(name, sizeof name, "%d bars in a circle", n);
        assert_int_equal(judge_around(name, &s, false), 0);
    }
}

static void faces_in_one_plane_hide_nothing(void **state) {
    (void)state;
    solid_scene_t s = {0};
    static const double a[][3] = {{0, 0, 1}, {3, 0, 2.5}, {3, 3, 4}, {0, 3, 2.5}},
                        b[][3] = {{1, 1, 2}, {4, 2, 4}, {1, 4, 3.5}}, c[][3] = {{2, -1, 0}, {3, 5, 0}, {-1, 4, 0}};
    polygon(&s.ref, a, 4);
    polygon(&s.ref, b, 3);
    polygon(&s.ref, a, 4);
    polygon(&s.ref, c, 3);
    assert_int_equal(judge_around("one plane", &s, false), 0);
}

static void slivers_are_seen_and_hide(void **state) {
    (void)state;
    solid_scene_t s = {0};
    for (int k = 0; k < 24; k++) {
        double t = 0.26 * k, w = pow(10, -1 - k % 4);
        const double p[3][3] = {{0.1 * cos(t), 0.1 * sin(t), 0.02 * k},
                                {2 * cos(t), 2 * sin(t), 1 + 0.02 * k},
                                {2 * cos(t + w), 2 * sin(t + w), 1.01 + 0.02 * k}};
        polygon(&s.ref, p, 3);
    }
    judge_around("slivers", &s, false);
}

static void flush_walls_leave_no_cracks(void **state) {
    (void)state;
    for (int inside = 0; inside < 2; inside++) {
        solid_scene_t s = {0};
        box(&s.ref, 0, 0, 0, 3, 1, 1);
        box(&s.ref, 1, 0, 1, 1, 1, 1);
        box(&s.ref, 2, 0, 1, 1.5, 1, 0.5);
        box(&s.ref, -2, 0.25, 0, 2, 0.75, 2);
        box(&s.ref, 0, 1, 0, 2.5, 1, 1.5);
        box(&s.ref, 0, 2.5, 0, 3, 0.5, 3);
        assert_int_equal(judge_around(inside ? "flush walls, among them" : "flush walls", &s, inside), 0);
    }
}

static void needles_reach_behind_the_eye(void **state) {
    (void)state;
    solid_scene_t s = {0};
    for (int k = 0; k < 12; k++) {
        double t = 0.52 * k, x = 1.1 * cos(t), y = 1.1 * sin(t), z = 0.3 * (k % 3) - 0.3;
        const double p[3][3] = {{3 * x, 3 * y, z}, {-2 * x, y, z + 0.001}, {-2 * x, y + 0.01, z + 0.02}};
        polygon(&s.ref, p, 3);
    }
    judge_around("needles", &s, true);
}

static void cuts_are_reported(void **state) {
    (void)state;
    solid_scene_t s = {0};
    static const double a[][3] = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}},
                        b[][3] = {{1, 2, -1}, {3, 2, -1}, {3, 2.5, 1}, {1, 2.5, 1}};
    polygon(&s.ref, a, 4);
    polygon(&s.ref, b, 4);
    assert_true(judge_around("a cut", &s, false) > 150);
}

/* Polygons as large as the picture, one behind the other: to halve windows helps nothing. */
static void depth_is_divided_where_memory_is_short(void **state) {
    (void)state;
    int64_t boxes = 0;
    for (size_t kilobytes = 20; kilobytes <= 80; kilobytes += 6)
        for (int flat = 0; flat < 2; flat++) {
            solid_scene_t s = {0};
            uint64_t rng = 7;
            for (int k = 0; k < 60; k++) {
                double t = 0.00628 * scene_below(&rng, 1000), w = 2.5 + 0.001 * scene_below(&rng, 1000), q[4][3];
                for (int i = 0; i < 4; i++) {
                    double x = i == 1 || i == 2 ? w : -w, y = i > 1 ? 3 : -3;
                    q[i][0] = x * cos(t) - y * sin(t) + 0.05 * k;
                    q[i][1] = x * sin(t) + y * cos(t);
                    q[i][2] = flat ? 0.02 * (k / 2) : 0.01 * k + 0.1 * q[i][0];
                }
                polygon(&s.ref, (const double(*)[3])q, 4);
            }
            solid_ref_finish(&s.ref);
            settings_default(&s.set);
            s.set.view.rot_x = num_from_i64(flat ? 0 : 20);
            solid_stage_t t;
            judge_report_t r;
            bool good = false;
            assert_int_equal(solid_stage_make(&t, &s, true), 0);
            t.bytes = kilobytes << 10;
            int err = solid_stage_judge(&t, &s, 0, &r, &good);
            print_message(
                "# area sort, 60 polygons as large as the picture, %zu bytes: %d windows, %d boxes of depth%s\n",
                t.bytes, t.sorted.windows, t.sorted.boxes, err ? ", full" : "");
            assert_true(err == 0 ? good : err == ERR_FULL);
            boxes += err ? 0 : t.sorted.boxes;
            solid_stage_free(&t);
            solid_scene_free(&s);
        }
    assert_true(boxes > 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_overlap_cyclically),
        cmocka_unit_test(many_overlap_cyclically),
        cmocka_unit_test(faces_in_one_plane_hide_nothing),
        cmocka_unit_test(slivers_are_seen_and_hide),
        cmocka_unit_test(flush_walls_leave_no_cracks),
        cmocka_unit_test(needles_reach_behind_the_eye),
        cmocka_unit_test(cuts_are_reported),
        cmocka_unit_test(depth_is_divided_where_memory_is_short),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
