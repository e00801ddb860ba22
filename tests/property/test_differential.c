/* Two methods where both apply: the same scene drawn by two kernels, the drawings held against each other. No reference
 * is asked unless they differ by more than a step; then both must be right by it (lines that fall together).
 *
 * What is compared elsewhere: kernels against exact rationals in test_*_random, the host against a Cortex-M0 in
 * tests/emu, the perimeter against the kernel with gaps in test_metamorphic (`add holes behind`).
 *
 * RIDGELINE_CASES multiplies the count, RIDGELINE_SEED tries one. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "error.h"
#include "tests/oracle/compare_ink.h"
#include "tests/oracle/run_cases.h"
#include "tests/oracle/run_horizon.h"

#define NAME "test_differential"
#define MOST 21

/* Draws s in two ways. Only lines of the families that both know are compared. */
typedef int two_ways(const scene_t *s, run_drawing_t *a, run_drawing_t *b);

static void make_along(uint64_t seed, scene_t *s) {
    uint64_t rng = seed;
    scene_init(s, 2 + scene_below(&rng, MOST - 1), 2 + scene_below(&rng, MOST - 1));
    if (!scene_below(&rng, 4)) scene_stretch(s, 50, &rng);
    scene_shape(s, (enum scene_shape)scene_below(&rng, SHAPES), &rng);
    s->ref.eye = (exact_eye_t){0, -1, 1.5 * scene_uniform(&rng) - .5, 0};
    scene_aim(s);
    snprintf(s->what, sizeof s->what, "seed %llu: %dx%d, along y, %.9g", (unsigned long long)seed, s->ref.nx, s->ref.ny,
             s->ref.eye.z);
}

/* In a parallel view along the columns the rows are profiles, and the columns between them hide nothing that the rows
 * do not: the horizon kernel draws the perimeter's rows. */
static int perimeter_and_horizon(const scene_t *s, run_drawing_t *a, run_drawing_t *b) {
    static exact_point_t point[MOST * MOST];
    static int first[MOST + 1];
    const double away[2] = {0, 1};
    hidden_stats_t stats;
    for (int j = 0; j < s->ref.ny; j++) {
        first[j] = j * s->ref.nx;
        for (int i = 0; i < s->ref.nx; i++) point[first[j] + i] = surface_ref_node(&s->ref, i, j);
    }
    first[s->ref.ny] = s->ref.ny * s->ref.nx;
    horizon_ref_t ref = {.count = s->ref.ny, .first = first, .point = point, .eye = s->ref.eye};
    int err = run_perimeter(s, a, &stats);
    if (!err) err = run_horizon(&ref, away, b, &stats);
    for (size_t i = 0; i < b->n; i++) b->piece[i].family = REF_ROW;
    /* The columns are the perimeter's in both. */
    ink_sink_t sink = run_sink(b);
    for (size_t i = 0; i < a->n && !err; i++)
        if (a->piece[i].family == REF_COL)
            err = sink.piece(sink.ctx, &(ink_piece_t){.family = INK_COL,
                                                      .line = a->piece[i].line,
                                                      .from = (int64_t)(a->piece[i].from * 0x1p46),
                                                      .to = (int64_t)(a->piece[i].to * 0x1p46)});
    return err;
}

static void make_any(uint64_t seed, scene_t *s) {
    scene_random(s, seed, 14, 0);
}

/* A surface alone, and as the lower of two whose other is undefined but for one cell of it, which lies in the surface.
 */
static int one_and_several(const scene_t *s, run_drawing_t *a, run_drawing_t *b) {
    hidden_stats_t stats;
    surface_ref_t sheet[2] = {s->ref, s->ref};
    run_drawing_t d[2] = {{0}};
    int points = s->ref.nx * s->ref.ny;
    sheet[1].hole = malloc((size_t)points);
    if (!sheet[1].hole) abort();
    memset(sheet[1].hole, 1, (size_t)points);
    int at = (s->ref.ny - 2) * s->ref.nx + s->ref.nx - 2;
    const int corner[4] = {at, at + 1, at + s->ref.nx, at + s->ref.nx + 1};
    for (int i = 0; i < 4; i++) sheet[1].hole[corner[i]] = 0;
    int err = run_perimeter(s, a, &stats);
    if (!err) err = run_several(sheet, 2, d, &stats);
    ink_sink_t sink = run_sink(b); /* either sheet may draw what both have */
    for (int k = 0; k < 2; k++)
        for (size_t i = 0; i < d[k].n && !err; i++)
            err = sink.piece(sink.ctx, &(ink_piece_t){.family = d[k].piece[i].family == REF_ROW ? INK_ROW : INK_COL,
                                                      .line = d[k].piece[i].line,
                                                      .from = (int64_t)(d[k].piece[i].from * 0x1p46),
                                                      .to = (int64_t)(d[k].piece[i].to * 0x1p46)});
    free(sheet[1].hole);
    for (int k = 0; k < 2; k++) run_drawing_free(&d[k]);
    return err;
}

typedef struct outcome {
    int err;
    bool tie, good;
    double mm;
    judge_spot_t where;
} outcome_t;

static bool is_right(const scene_t *s, const run_drawing_t *d) {
    judge_report_t r = {0};
    judge_subject_t what = judge_surface(&s->ref);
    return judge_pieces(&what, &s->view, d->piece, d->n, &r) == 0 && r.missing_mm <= CASES_RUN_MM &&
           r.false_mm <= CASES_RUN_MM && r.end_steps <= 1;
}

static outcome_t try_both(const scene_t *s, two_ways *both) {
    outcome_t o = {0};
    run_drawing_t a = {0}, b = {0};
    o.err = both(s, &a, &b);
    if (o.err == ERR_EMPTY) o.err = 0;
    o.mm = compare_ink(s, &a, &b, COMPARE_SAME, &o.where);
    o.good = !o.err && o.mm <= JUDGE_STEP_MM;
    if (!o.err && !o.good) o.tie = o.good = is_right(s, &a) && is_right(s, &b);
    run_drawing_free(&a);
    run_drawing_free(&b);
    return o;
}

static int fails(void *ctx, const scene_t *s) {
    return !try_both(s, *(two_ways **)ctx).good;
}

static void tell(const char *name, uint64_t seed, const scene_t *s, two_ways *both) {
    scene_t small;
    outcome_t o = try_both(s, both);
    print_message("# FAILED %s, %s: error %d; %g mm differ on %s %d, %.6f to %.6f\n"
                  "#   repeat: RIDGELINE_SEED=%llu build/tests/property/" NAME "\n#   shrunk:\n",
                  name, s->what, o.err, o.mm, o.where.family ? "col" : "row", o.where.line, o.where.from, o.where.to,
                  (unsigned long long)seed);
    scene_copy(s, &small);
    scene_shrink(&small, fails, &both);
    scene_print(&small);
    scene_free(&small);
}

static int compare(const char *name, uint64_t first, uint64_t count, void (*make)(uint64_t, scene_t *),
                   two_ways *both) {
    uint64_t from = first;
    long long drawn = 0, ties = 0;
    double worst = 0;
    int failed = 0;
    if (cases_only_seed(&from)) {
        if (from < first || from - first >= 1000000000) return 0;
        count = 1;
    } else {
        from = cases_first(first, count);
    }
    for (uint64_t seed = from; seed < from + count && failed < 5; seed++) {
        scene_t s;
        make(seed, &s);
        outcome_t o = try_both(&s, both);
        drawn++;
        ties += o.tie;
        if (!o.tie && o.mm > worst) worst = o.mm;
        if (!o.good) {
            failed++;
            tell(name, seed, &s, both);
        }
        scene_free(&s);
    }
    print_message(
        "# %s: %lld scenes, %lld with other choices among lines that fall together; largest difference of the "
        "rest %.2f steps\n",
        name, drawn, ties, worst / JUDGE_STEP_MM);
    return failed;
}

static void test_perimeter_and_horizon(void **state) {
    (void)state;
    assert_int_equal(
        compare("perimeter and horizon", 11000000000, cases_scaled(20000), make_along, perimeter_and_horizon), 0);
}

static void test_one_and_several(void **state) {
    (void)state;
    assert_int_equal(compare("one surface and several", 12000000000, cases_scaled(3000), make_any, one_and_several), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_perimeter_and_horizon),
        cmocka_unit_test(test_one_and_several),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
