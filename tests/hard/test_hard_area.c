/* The area sort's hard cases, each from several sides and judged by rays: cyclic overlap of two and of many, faces in
 * one plane, slivers, walls that meet flush, needles near the eye, holes that touch their outer contour or each other.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "error.h"
#include "hidden/area/area_face.h"
#include "tests/oracle/hard_bodies.h"
#include "tests/oracle/hard_holes.h"
#include "tests/oracle/num_of.h"
#include "tests/oracle/page_ink.h"
#include "tests/oracle/run_cases.h"
#include "tests/oracle/solid_scenes.h"

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
    hard_brackets(&s.ref);
    assert_int_equal(judge_around("two brackets", &s, false), 0);
}

static void many_overlap_cyclically(void **state) {
    (void)state;
    for (int n = 3; n <= 13; n += 5) {
        solid_scene_t s = {0};
        hard_circle(&s.ref, n);
        char name[32];
        snprintf(name, sizeof name, "%d bars in a circle", n);
        assert_int_equal(judge_around(name, &s, false), 0);
    }
}

static void faces_in_one_plane_hide_nothing(void **state) {
    (void)state;
    solid_scene_t s = {0};
    hard_one_plane(&s.ref);
    assert_int_equal(judge_around("one plane", &s, false), 0);
}

static void slivers_are_seen_and_hide(void **state) {
    (void)state;
    solid_scene_t s = {0};
    hard_slivers(&s.ref);
    judge_around("slivers", &s, false);
}

static void flush_walls_leave_no_cracks(void **state) {
    (void)state;
    for (int inside = 0; inside < 2; inside++) {
        solid_scene_t s = {0};
        hard_flush(&s.ref);
        assert_int_equal(judge_around(inside ? "flush walls, among them" : "flush walls", &s, inside), 0);
    }
}

static void needles_reach_behind_the_eye(void **state) {
    (void)state;
    solid_scene_t s = {0};
    hard_needles(&s.ref);
    judge_around("needles", &s, true);
}

static void cuts_are_reported(void **state) {
    (void)state;
    solid_scene_t s = {0};
    hard_cut(&s.ref);
    assert_true(judge_around("a cut", &s, false) > 150);
}

/* ---- holes ---- */

static void holes_touch_in_points(void **state) {
    (void)state;
    for (int k = 0; k < HARD_HOLES; k++)
        for (int inside = 0; inside < 2; inside++) {
            solid_scene_t s = {0};
            hard_hole(&s.ref, k);
            char name[40];
            snprintf(name, sizeof name, "holes that touch, %d%s", k, inside ? ", from inside" : "");
            judge_around(name, &s, inside);
        }
}

/* All ink of a scene, from one side. */
static page_ink_t ink_of(solid_scene_t *s, int x, int z) {
    solid_stage_t t;
    settings_default(&s->set);
    s->set.view.rot_x = num_from_i64(x);
    s->set.view.rot_z = num_from_i64(z);
    assert_int_equal(solid_stage_make(&t, s, true), 0);
    page_ink_t ink = {.space = &t.map.lines};
    assert_int_equal(solid_stage_draw(&t, &(ink_sink_t){&ink, page_ink_take}), 0);
    solid_stage_free(&t);
    return ink;
}

/* A hole along an edge is a notch: the same drawing as of the polygon that has one. */
static void a_hole_along_an_edge_is_a_notch(void **state) {
    (void)state;
    const double near_mm = CASES_END_STEPS * JUDGE_STEP_MM;
    double worst = 0, length = 0;
    int views = 0;
    for (int k = 0; k < HARD_NOTCHES; k++) {
        solid_scene_t a = {0}, b = {0};
        hard_notch(&a.ref, k, false);
        hard_notch(&b.ref, k, true);
        for (int x = 0; x <= 180; x += 15)
            for (int z = 0; z < 360; z += 24) {
                page_ink_t p = ink_of(&a, x, z), q = ink_of(&b, x, z);
                double off = fmax(page_lines_uncovered(&p.lines, &q.lines, near_mm),
                                  page_lines_uncovered(&q.lines, &p.lines, near_mm));
                if (off > CASES_RUN_MM) fail_msg("notch %d from %d,%d: %g mm differ", k, x, z, off);
                worst = fmax(worst, off);
                length += page_lines_length(&p.lines);
                views++;
                page_lines_free(&p.lines);
                page_lines_free(&q.lines);
            }
        solid_scene_free(&a);
        judge_around("a notch", &b, false);
    }
    assert_true(length > 0);
    print_message("# area sort, holes along an edge and notches: %d views, %.1f m, runs that differ %.4f mm\n", views,
                  length / 1e3, worst);
}

static void a_needle_seen_from_its_end_fills_the_page(void **state) {
    (void)state;
    solid_scene_t s = {0};
    hard_needle(&s.ref);
    judge_around("a needle from its end", &s, false);
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
                hard_polygon(&s.ref, (const double(*)[3])q, 4);
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
            print_message("# area sort, 60 polygons as large as the picture, %zu bytes (%zu used): %d windows, %d "
                          "boxes of depth%s\n",
                          t.bytes, t.stats.bytes, t.sorted.windows, t.sorted.boxes, err ? ", full" : "");
            assert_true(t.stats.bytes <= t.bytes);
            assert_true(err || t.stats.bytes > 60 * sizeof(area_face_t));
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
        cmocka_unit_test(holes_touch_in_points),
        cmocka_unit_test(a_hole_along_an_edge_is_a_notch),
        cmocka_unit_test(a_needle_seen_from_its_end_fills_the_page),
        cmocka_unit_test(depth_is_divided_where_memory_is_short),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
