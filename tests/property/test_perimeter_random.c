/* Seeded random scenes, drawn by the perimeter kernel and judged against the reference; and the laws that a drawing
 * must obey whatever the surface. RIDGELINE_CASES=100 tries a hundred times as many; RIDGELINE_SEED=n tries one. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "tests/oracle/run_cases.h"

#define NAME "test_perimeter_random"

static void test_small(void **state) {
    (void)state;
    assert_int_equal(cases_random_surfaces(NAME, 0, cases_scaled(2500), 12, false), 0);
}
static void test_larger(void **state) {
    (void)state;
    assert_int_equal(cases_random_surfaces(NAME, 1000000000, cases_scaled(60), 48, false), 0);
}

/* A change of the scene that must not change the drawing. */
enum law { LAW_QUARTER, LAW_MIRROR, LAW_TRANSLATE, LAW_SCALE, LAW_UPSIDE_DOWN, LAW_BEHIND, LAWS };
static const char *const law_name[LAWS] = {"quarter turn", "mirror", "translate", "scale", "upside down", "behind"};

static void reverse(double *c, int n, double sign) {
    for (int i = 0; i < n - 1 - i; i++) {
        double t = c[i];
        c[i] = c[n - 1 - i];
        c[n - 1 - i] = t;
    }
    for (int i = 0; i < n; i++) c[i] *= sign;
}

/* (x, y) becomes (-x, y). */
static void mirror(scene_t *s) {
    reverse(s->ref.x, s->ref.nx, -1);
    for (int j = 0; j < s->ref.ny; j++) reverse(s->ref.z + j * s->ref.nx, s->ref.nx, 1);
    s->ref.eye.x = -s->ref.eye.x;
}

/* (x, y) becomes (-y, x). */
static void quarter(scene_t *s) {
    scene_t t;
    int nx = s->ref.ny, ny = s->ref.nx;
    scene_init(&t, nx, ny);
    for (int i = 0; i < nx; i++) t.ref.x[i] = -s->ref.y[nx - 1 - i];
    for (int j = 0; j < ny; j++) t.ref.y[j] = s->ref.x[j];
    for (int j = 0; j < ny; j++)
        for (int i = 0; i < nx; i++) t.ref.z[j * nx + i] = s->ref.z[(nx - 1 - i) * ny + j];
    t.ref.eye = (exact_eye_t){-s->ref.eye.y, s->ref.eye.x, s->ref.eye.z, s->ref.eye.h};
    scene_free(s);
    *s = t;
}

/* One more row on the side away from the eye, as tall as it likes. */
static void behind(scene_t *s) {
    scene_t t;
    int nx = s->ref.nx, ny = s->ref.ny;
    scene_init(&t, nx, ny + 1);
    double depth = s->ref.y[ny - 1] - s->ref.y[0];
    for (int i = 0; i < nx; i++) t.ref.x[i] = s->ref.x[i];
    for (int j = 0; j <= ny; j++) t.ref.y[j] = j < ny ? s->ref.y[j] : s->ref.y[ny - 1] + depth / ny;
    for (int j = 0; j <= ny; j++)
        for (int i = 0; i < nx; i++) t.ref.z[j * nx + i] = j < ny ? s->ref.z[j * nx + i] : 3.0 * ((i * 7) % 5) - 6;
    t.ref.eye = s->ref.eye;
    scene_free(s);
    *s = t;
}

static void apply(scene_t *s, enum law law) {
    surface_ref_t *r = &s->ref;
    double by[3] = {law == LAW_TRANSLATE ? 37.25 : 0, law == LAW_TRANSLATE ? -11.5 : 0,
                    law == LAW_TRANSLATE ? 100.0 : 0};
    double k = law == LAW_SCALE ? 1024.0 : 1, kz = law == LAW_UPSIDE_DOWN ? -1 : k;
    if (law == LAW_MIRROR) mirror(s);
    if (law == LAW_QUARTER) quarter(s);
    if (law == LAW_BEHIND) behind(s);
    for (int i = 0; i < r->nx; i++) r->x[i] = k * r->x[i] + by[0];
    for (int j = 0; j < r->ny; j++) r->y[j] = k * r->y[j] + by[1];
    for (int i = 0; i < r->nx * r->ny; i++) r->z[i] = kz * r->z[i] + by[2];
    double move = r->eye.h ? 1 : 0;
    r->eye =
        (exact_eye_t){k * r->eye.x + move * by[0], k * r->eye.y + move * by[1], kz * r->eye.z + move * by[2], r->eye.h};
}

/* Takes a piece of the changed scene back to the original one; false for ink that the change added. */
static bool back(const scene_t *original, enum law law, judge_piece_t *p) {
    int nx = original->ref.nx, ny = original->ref.ny;
    if (law == LAW_BEHIND) {
        if (p->family == REF_ROW) return p->line < ny;
        if (p->to > ny - 1) p->to = ny - 1;
        return p->from < p->to;
    }
    if ((law == LAW_MIRROR || law == LAW_QUARTER) && p->family == REF_ROW) {
        double from = p->from, n = law == LAW_MIRROR ? nx - 1 : ny - 1;
        p->from = n - p->to;
        p->to = n - from;
    } else if (law == LAW_MIRROR) {
        p->line = nx - 1 - p->line;
    } else if (law == LAW_QUARTER) {
        p->line = ny - 1 - p->line;
    }
    if (law == LAW_QUARTER) p->family = !p->family;
    return true;
}

static void test_laws(void **state) {
    (void)state;
    int all = 0;
    for (enum law law = 0; law < LAWS; law++) {
        int failed = 0;
        cases_t c = {.name = law_name[law]};
        const uint64_t from = cases_first(3000000000, cases_scaled(120));
        for (uint64_t seed = from; seed < from + cases_scaled(120) && failed < 5; seed++) {
            scene_t s, t;
            run_drawing_t d = {0};
            hidden_stats_t stats;
            judge_report_t rep = {0};
            scene_random(&s, seed, 12, 0);
            if (law == LAW_BEHIND && (s.ref.eye.h ? s.ref.eye.y >= s.ref.y[s.ref.ny - 1] : s.ref.eye.y >= 0)) {
                scene_free(&s);
                continue;
            }
            scene_copy(&s, &t);
            apply(&t, law);
            judge_subject_t what = judge_surface(&s.ref);
            int err = run_perimeter(&t, &d, &stats);
            size_t n = 0;
            for (size_t i = 0; i < d.n; i++)
                if (back(&s, law, &d.piece[i])) d.piece[n++] = d.piece[i];
            if (err == 0) err = judge_pieces(&what, &s.view, d.piece, n, &rep);
            c.run++;
            c.facets += stats.facets;
            if (err || !cases_good(&rep)) {
                failed++;
                print_message(
                    "# FAILED law `%s`, %s: error %d, missing %g mm, false %g mm, end %g steps, twice %g mm\n",
                    law_name[law], s.what, err, rep.missing_mm, rep.false_mm, rep.end_steps, rep.twice_mm);
            } else {
                judge_worst(&c.worst, &rep);
            }
            run_drawing_free(&d);
            scene_free(&s);
            scene_free(&t);
        }
        cases_summary(&c);
        all += failed;
    }
    assert_int_equal(all, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_small),
        cmocka_unit_test(test_larger),
        cmocka_unit_test(test_laws),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
