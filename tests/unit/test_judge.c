/* The judge of drawings, judged: the reference's own drawing is without fault, and planted faults are measured right.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "tests/oracle/judge_seg.h"
#include "tests/oracle/scenes.h"

typedef struct drawing {
    judge_piece_t *p;
    size_t n;
} run_drawing_t;

static int judge(const scene_t *s, const judge_piece_t *p, size_t n, judge_report_t *rep) {
    judge_subject_t what = judge_surface(&s->ref);
    return judge_pieces(&what, &s->view, p, n, rep);
}

/* Everything that is visible, edge by edge. */
static run_drawing_t perfect(const surface_ref_t *r) {
    run_drawing_t d = {malloc(100000 * sizeof(judge_piece_t)), 0};
    spans_t h = {0}, e = {0}, v = {0};
    for (int family = 0; family < 2; family++)
        for (int line = 0; line < (family ? r->nx : r->ny); line++)
            for (int k = 0; k + 1 < (family ? r->ny : r->nx); k++) {
                if (!surface_ref_edge_exists(r, family, line, k)) continue;
                surface_ref_edge(r, family, line, k, &h, &e);
                spans_complement(&h, 0, 1, &v);
                for (size_t i = 0; i < v.n && d.n < 100000; i++)
                    d.p[d.n++] = (judge_piece_t){family, line, k + (double)v.s[i].a, k + (double)v.s[i].b};
            }
    spans_free(&h);
    spans_free(&e);
    spans_free(&v);
    return d;
}

static void test_perfect(void **state) {
    (void)state;
    double ink = 0;
    for (uint64_t seed = 0; seed < 300; seed++) {
        scene_t s;
        scene_random(&s, seed, 14, seed & 1);
        run_drawing_t d = perfect(&s.ref);
        judge_report_t rep;
        assert_int_equal(judge(&s, d.p, d.n, &rep), 0);
        if (rep.raw_missing_mm > 1e-6 || rep.raw_false_mm > 1e-6 || rep.end_steps > .25 || rep.twice_mm > 0)
            fail_msg("%s: missing %g false %g end %g (%d %d %g) twice %g", s.what, rep.raw_missing_mm, rep.raw_false_mm,
                     rep.end_steps, rep.end.family, rep.end.line, rep.end.from, rep.twice_mm);
        ink += rep.ink_mm;
        free(d.p);
        scene_free(&s);
    }
    print_message("# judge: 300 scenes drawn by the reference itself, %.0f m of ink, no fault found\n", ink / 1000);
    assert_true(ink > 1e5);
}

/* A plain with a wall in front; the row behind it is hidden over its whole length. */
static void test_planted(void **state) {
    (void)state;
    scene_t s;
    scene_init(&s, 5, 5);
    for (int i = 0; i < 5; i++) s.ref.z[3 * 5 + i] = 1;
    s.ref.eye = (exact_eye_t){0.125, 1, .25, 0};
    scene_aim(&s);
    run_drawing_t d = perfect(&s.ref);
    judge_report_t good, rep;
    judge(&s, d.p, d.n, &good);
    assert_true(good.missing_mm == 0 && good.false_mm == 0);
    double edge_mm = 0;
    for (size_t i = 0; i < d.n; i++) { /* leave out one whole visible edge of the wall's crest */
        if (d.p[i].family != REF_ROW || d.p[i].line != 3 || d.p[i].from != 1) continue;
        judge_piece_t kept = d.p[i];
        d.p[i] = d.p[d.n - 1];
        judge(&s, d.p, d.n - 1, &rep);
        edge_mm = rep.missing_mm;
        d.p[i] = kept;
    }
    assert_true(edge_mm > 20 && edge_mm < 80);
    d.p[d.n] = (judge_piece_t){REF_ROW, 1, 1.25, 2.25};
    judge(&s, d.p, d.n + 1, &rep);
    assert_true(rep.missing_mm == 0 && fabs(rep.false_mm - edge_mm) < .1);
    assert_true(rep.falsely.line == 1 && rep.falsely.from == 1.25);
    d.p[d.n] = (judge_piece_t){REF_ROW, 3, 1.25, 1.75};
    judge(&s, d.p, d.n + 1, &rep);
    assert_true(rep.false_mm == 0 && fabs(rep.twice_mm - edge_mm / 2) < .1);
    d.p[d.n] = (judge_piece_t){REF_ROW, 7, 0, 1};
    assert_int_equal(judge(&s, d.p, d.n + 1, &rep), -1);
    free(d.p);
    scene_free(&s);
}

/* Two crests in one place on the page: ink of either will do. A step apart on the page it will not. */
static void test_one_line(void **state) {
    (void)state;
    for (int apart = 0; apart < 2; apart++) {
        scene_t s;
        scene_init(&s, 5, 6);
        for (int i = 0; i < 5; i++) s.ref.z[3 * 5 + i] = s.ref.z[4 * 5 + i] = 1;
        for (int j = 4; j < 6; j++) s.ref.y[j] = s.ref.y[3] + (apart ? 2e-3 : 1e-6) * (j == 4) + (j == 5);
        s.ref.eye = (exact_eye_t){0.125, 1, -.25, 0};
        scene_aim(&s);
        run_drawing_t d = perfect(&s.ref);
        judge_report_t rep;
        judge(&s, d.p, d.n, &rep);
        assert_true(rep.missing_mm == 0 && rep.false_mm == 0);
        int moved = 0;
        for (size_t i = 0; i < d.n; i++) { /* the one crest's ink is given to the other */
            if (d.p[i].family != REF_ROW || (d.p[i].line != 3 && d.p[i].line != 4) || d.p[i].from != 1) continue;
            d.p[i].line = 7 - d.p[i].line;
            moved++;
        }
        assert_int_equal(moved, 1);
        judge(&s, d.p, d.n, &rep);
        if (apart ? rep.missing_mm < 20 || rep.false_mm < 20 : rep.missing_mm > 0 || rep.false_mm > 0)
            fail_msg("%d: missing %g, false %g", apart, rep.missing_mm, rep.false_mm);
        assert_true(rep.raw_missing_mm > 20 && rep.raw_false_mm > 20);
        assert_true(apart || rep.end_steps <= .25);
        free(d.p);
        scene_free(&s);
    }
}

/* Ends moved by a fraction of a step and by several steps are reported as such. */
static void test_moved_ends(void **state) {
    (void)state;
    scene_t s;
    scene_init(&s, 9, 9);
    uint64_t rng = 3;
    scene_shape(&s, SHAPE_RANDOM, &rng);
    scene_aim(&s);
    run_drawing_t d = perfect(&s.ref);
    for (int steps = 0; steps < 2; steps++) {
        double by = steps ? 4 : .125;
        for (size_t i = 0; i < d.n; i++) {
            exact_point_t e[2];
            double x0, y0, x1, y1;
            if (fmod(d.p[i].to, 1) == 0) continue;
            surface_ref_edge_ends(&s.ref, d.p[i].family, d.p[i].line, (int)d.p[i].to, e);
            page_view_point(&s.view, e[0], &x0, &y0);
            page_view_point(&s.view, e[1], &x1, &y1);
            d.p[i].to += by * JUDGE_STEP_MM / hypot(x1 - x0, y1 - y0);
        }
        judge_report_t rep;
        judge(&s, d.p, d.n, &rep);
        if (steps)
            assert_true(rep.end_steps > 2 && rep.end_steps < 5.5 && rep.raw_false_mm > 3.9 * JUDGE_STEP_MM);
        else
            assert_true(rep.end_steps < .25 && rep.false_mm < .2 * JUDGE_STEP_MM);
    }
    free(d.p);
    scene_free(&s);
}

/* The same drawings as page segments: matched back to their lines, nothing is missing or false; a foreign line is. */
static void test_segments(void **state) {
    (void)state;
    double foreign = 0;
    for (uint64_t seed = 5000; seed < 5060; seed++) {
        scene_t s;
        scene_random(&s, seed, 12, 0);
        run_drawing_t d = perfect(&s.ref);
        judge_subject_t what = judge_surface(&s.ref);
        page_seg_t *seg = malloc((d.n + 1) * sizeof *seg);
        size_t n = 0;
        for (size_t i = 0; i < d.n; i++) {
            exact_point_t e[2];
            page_part_t part;
            const int k = (int)d.p[i].from;
            surface_ref_edge_ends(&s.ref, d.p[i].family, d.p[i].line, k, e);
            if (page_view_part(&s.view, e, d.p[i].from - k, d.p[i].to - k, &part))
                seg[n++] = (page_seg_t){part.at.x0, part.at.y0, part.at.x1, part.at.y1};
        }
        judge_seg_report_t rep;
        judge_segments(&what, &s.view, seg, n, &rep);
        if (rep.pieces.missing_mm > 1e-6 || rep.false_mm > 1e-6 || rep.pieces.end_steps > .25)
            fail_msg("%s: missing %g false %g end %g", s.what, rep.pieces.missing_mm, rep.false_mm,
                     rep.pieces.end_steps);
        seg[n] = (page_seg_t){20, 20, 30, 31};
        judge_segments(&what, &s.view, seg, n + 1, &rep);
        foreign += rep.false_mm;
        free(seg);
        free(d.p);
        scene_free(&s);
    }
    assert_true(foreign > 59 * hypot(10, 11));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_perfect),    cmocka_unit_test(test_planted),  cmocka_unit_test(test_one_line),
        cmocka_unit_test(test_moved_ends), cmocka_unit_test(test_segments),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
