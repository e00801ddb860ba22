/* The laws of metamorph.h, and the order of objects: a changed scene is drawn, taken back and held against the drawing
 * of the first. Nothing but the kernels is asked, so there can be many cases. Where the two differ by more than a step
 * the reference decides: a line that falls together with another may be drawn or not, and then both are right.
 *
 * RIDGELINE_CASES multiplies the count; RIDGELINE_SEED tries one, and says by itself which law. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "error.h"
#include "tests/oracle/metamorph.h"
#include "tests/oracle/run_cases.h"

#define NAME "test_metamorphic"
#define FIRST 9000000000 /* of the seeds, and so many for each law */
#define SEEDS 100000000
#define CASES 8000
#define MOST 12

typedef struct outcome {
    int err, facets;
    bool drawn, tie, good;
    double mm; /* what differs */
    judge_spot_t where;
    judge_report_t judged[2];
} outcome_t;

static judge_report_t judge(const scene_t *s, const run_drawing_t *d) {
    judge_report_t r = {0};
    judge_subject_t what = judge_surface(&s->ref);
    if (judge_pieces(&what, &s->view, d->piece, d->n, &r)) r.missing_mm = 1e9;
    return r;
}

/* Nothing missing, false or displaced by more than a step. A quarter step for ends, as elsewhere, is not to be had
 * where a law puts cliffs beside differences of 1e-6: the lattice is the cliffs'. */
static bool is_right(const judge_report_t *r) {
    return r->missing_mm <= CASES_RUN_MM && r->false_mm <= CASES_RUN_MM && r->end_steps <= 1;
}

static int draw(const scene_t *s, run_drawing_t *d, outcome_t *o) {
    hidden_stats_t stats;
    int err = run_perimeter(s, d, &stats);
    o->facets += (int)stats.facets;
    return err == ERR_EMPTY ? 0 : err;
}

/* Both drawings, whatever differs, and what the reference says if it is more than a step. */
static outcome_t try_law(enum metamorph_law law, const scene_t *s) {
    outcome_t o = {0};
    scene_t t;
    run_drawing_t a = {0}, b = {0}, back = {0};
    if (!metamorph_apply(law, s, &t)) return (outcome_t){.good = true};
    o.drawn = true;
    o.err = draw(s, &a, &o);
    if (!o.err) o.err = draw(&t, &b, &o);
    back.piece = malloc((b.n + 1) * sizeof *back.piece);
    if (!back.piece) abort();
    for (size_t i = 0; i < b.n; i++) {
        back.piece[back.n] = b.piece[i];
        if (metamorph_back(law, s, &back.piece[back.n])) back.n++;
    }
    o.mm = compare_ink(s, &a, &back, metamorph_how(law), &o.where);
    o.good = !o.err && o.mm <= JUDGE_STEP_MM;
    if (!o.err && !o.good) {
        scene_aim(&t);
        o.judged[0] = judge(s, &a);
        o.judged[1] = judge(&t, &b);
        o.tie = o.good = is_right(&o.judged[0]) && is_right(&o.judged[1]);
    }
    run_drawing_free(&a);
    run_drawing_free(&b);
    run_drawing_free(&back);
    scene_free(&t);
    return o;
}

static int fails(void *ctx, const scene_t *s) {
    return !try_law(*(enum metamorph_law *)ctx, s).good;
}

static void tell(enum metamorph_law law, uint64_t seed, const scene_t *s) {
    scene_t small;
    for (int shrunk = 0; shrunk < 2; shrunk++) {
        if (shrunk) {
            scene_copy(s, &small);
            scene_shrink(&small, fails, &law);
            scene_print(&small);
        }
        outcome_t o = try_law(law, shrunk ? &small : s);
        print_message(
            "# %s law `%s`, %s: error %d; %g mm differ on %s %d, %.6f to %.6f; by the reference %g and %g mm are "
            "missing, %g and %g false, ends off by %.2f and %.2f steps, %g and %g mm twice\n",
            shrunk ? "shrunk" : "FAILED", metamorph_name(law), s->what, o.err, o.mm, o.where.family ? "col" : "row",
            o.where.line, o.where.from, o.where.to, o.judged[0].missing_mm, o.judged[1].missing_mm,
            o.judged[0].false_mm, o.judged[1].false_mm, o.judged[0].end_steps, o.judged[1].end_steps,
            o.judged[0].twice_mm, o.judged[1].twice_mm);
    }
    print_message("#   repeat: RIDGELINE_SEED=%llu build/tests/property/" NAME "\n", (unsigned long long)seed);
    scene_free(&small);
}

/* The seeds of a law, or none if RIDGELINE_SEED is another's. */
static bool seeds_of(int law, uint64_t *from, uint64_t *count) {
    uint64_t first = FIRST + (uint64_t)law * SEEDS;
    *count = cases_scaled(CASES);
    *from = cases_first(first, *count);
    if (!cases_only_seed(from)) return true;
    *count = 1;
    return *from >= first && *from - first < SEEDS;
}

static void test_laws(void **state) {
    (void)state;
    int all = 0;
    for (enum metamorph_law law = 0; law < METAMORPH_LAWS; law++) {
        int failed = 0;
        uint64_t from, count;
        long long drawn = 0, ties = 0, facets = 0;
        double worst = 0;
        if (!seeds_of((int)law, &from, &count)) continue;
        for (uint64_t seed = from; seed < from + count && failed < 5; seed++) {
            scene_t s;
            metamorph_scene(law, seed, MOST, &s);
            outcome_t o = try_law(law, &s);
            drawn += o.drawn;
            ties += o.tie;
            facets += o.facets;
            if (!o.tie && o.mm > worst) worst = o.mm;
            if (!o.good) {
                failed++;
                tell(law, seed, &s);
            }
            scene_free(&s);
        }
        print_message("# law `%s`: %lld scenes, %lld facets, %lld with other choices among lines that fall together; "
                      "largest difference of the rest %.2f steps\n",
                      metamorph_name(law), drawn, facets, ties, worst / JUDGE_STEP_MM);
        all += failed;
    }
    assert_int_equal(all, 0);
}

enum { SHEETS = 3 };

/* Is what was drawn of sheet k right by the reference? */
static bool sheet_is_right(const scene_t *s, const surface_ref_t *sheet, int k, const run_drawing_t *d) {
    double *other[SHEETS];
    scene_t one = *s;
    one.ref = sheet[k];
    for (int i = 0; i < SHEETS; i++)
        if (i != k) other[one.ref.sheets++] = sheet[i].z;
    one.ref.sheet_z = other;
    judge_report_t r = judge(&one, d);
    return is_right(&r);
}

/* How far one sheet lies above the one below it: of the place alone, so that it stays when a scene is made small. */
static double lift(uint64_t seed, int sheet, double x, double y) {
    uint64_t rng = seed * SHEETS + (uint64_t)sheet, bits[2];
    memcpy(&bits[0], &x, sizeof x);
    memcpy(&bits[1], &y, sizeof y);
    for (int k = 0; k < 2; k++) rng = rng * 0x9e3779b97f4a7c15u + bits[k];
    return .05 + scene_uniform(&rng);
}

/* Three sheets over the grid of s, the lowest of its heights. They share its memory but for z, to be freed. */
static double *make_sheets(uint64_t seed, const scene_t *s, surface_ref_t sheet[SHEETS]) {
    const surface_ref_t *r = &s->ref;
    const int points = r->nx * r->ny;
    double *z = malloc(sizeof(double) * SHEETS * (size_t)points);
    if (!z) abort();
    for (int k = 0; k < SHEETS; k++) {
        for (int i = 0; i < points; i++)
            z[k * points + i] = k ? z[(k - 1) * points + i] + lift(seed, k, r->x[i % r->nx], r->y[i / r->nx]) : r->z[i];
        sheet[k] = *r;
        sheet[k].z = z + k * points;
    }
    return z;
}

typedef struct order_outcome {
    int err, ties, sheet;
    bool good;
    double mm, worst; /* what differs where it matters; what differs else */
    judge_spot_t where;
} order_outcome_t;

/* Three sheets one above the other, drawn in one order and in another: each sheet's ink is the same. */
static order_outcome_t try_order(uint64_t seed, const scene_t *s) {
    static const int other[SHEETS] = {2, 0, 1};
    surface_ref_t sheet[SHEETS], permuted[SHEETS];
    run_drawing_t a[SHEETS] = {{0}}, b[SHEETS] = {{0}};
    hidden_stats_t stats;
    order_outcome_t o = {.good = true};
    double *z = make_sheets(seed, s, sheet);
    for (int k = 0; k < SHEETS; k++) permuted[k] = sheet[other[k]];
    o.err = run_several(sheet, SHEETS, a, &stats);
    if (!o.err) o.err = run_several(permuted, SHEETS, b, &stats);
    o.good = !o.err || o.err == ERR_EMPTY;
    const bool plan = s->ref.eye.h == 0 && s->ref.eye.x == 0 && s->ref.eye.y == 0; /* one draws the lines of all */
    for (int k = 0; k < SHEETS && !o.err && !plan; k++) {
        scene_t one = *s;
        judge_spot_t where;
        one.ref = permuted[k];
        const double mm = compare_ink(&one, &a[other[k]], &b[k], COMPARE_SAME, &where);
        if (mm <= JUDGE_STEP_MM) {
            o.worst = fmax(o.worst, mm);
        } else if (sheet_is_right(s, sheet, other[k], &a[other[k]]) && sheet_is_right(s, permuted, k, &b[k])) {
            o.ties++;
        } else if (mm > o.mm) {
            o.good = false;
            o.mm = mm, o.sheet = other[k], o.where = where;
        }
    }
    for (int k = 0; k < SHEETS; k++) {
        run_drawing_free(&a[k]);
        run_drawing_free(&b[k]);
    }
    free(z);
    return o;
}

static int order_fails(void *ctx, const scene_t *s) {
    return !try_order(*(uint64_t *)ctx, s).good;
}

static void tell_order(uint64_t seed, const scene_t *s) {
    scene_t small;
    surface_ref_t sheet[SHEETS];
    scene_copy(s, &small);
    for (int shrunk = 0; shrunk < 2; shrunk++) {
        if (shrunk) scene_shrink(&small, order_fails, &seed);
        const order_outcome_t o = try_order(seed, &small);
        print_message("# %s order of surfaces, %s: error %d; %g mm differ on sheet %d, %s %d, %.6f to %.6f\n",
                      shrunk ? "shrunk" : "FAILED", s->what, o.err, o.mm, o.sheet, o.where.family ? "col" : "row",
                      o.where.line, o.where.from, o.where.to);
    }
    scene_print(&small);
    double *z = make_sheets(seed, &small, sheet);
    for (int k = 1; k < SHEETS; k++) {
        print_message("#   z of sheet %d:", k);
        for (int i = 0; i < small.ref.nx * small.ref.ny; i++) print_message(" %.17g", sheet[k].z[i]);
        print_message("\n");
    }
    print_message("#   repeat: RIDGELINE_SEED=%llu build/tests/property/" NAME "\n", (unsigned long long)seed);
    free(z);
    scene_free(&small);
}

static void test_order_of_surfaces(void **state) {
    (void)state;
    uint64_t from, count;
    long long drawn = 0, ties = 0;
    double worst = 0;
    int failed = 0;
    if (!seeds_of(METAMORPH_LAWS, &from, &count)) return;
    for (uint64_t seed = from; seed < from + count && failed < 5; seed++) {
        scene_t s;
        scene_random(&s, seed, 10, false);
        const order_outcome_t o = try_order(seed, &s);
        drawn++;
        ties += o.ties;
        worst = fmax(worst, o.worst);
        if (!o.good) {
            failed++;
            tell_order(seed, &s);
        }
        scene_free(&s);
    }
    print_message("# order of surfaces: %lld scenes of three sheets, %lld sheets with other choices among lines that "
                  "fall together; largest difference of the rest %.2f steps\n",
                  drawn, ties, worst / JUDGE_STEP_MM);
    assert_int_equal(failed, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_laws),
        cmocka_unit_test(test_order_of_surfaces),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
