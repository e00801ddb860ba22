/* What falls together is drawn once: random scenes of solids and wires, bodies that stand flush among them, with the
 * stage of hidden/solid/once.h and without. Judged on the page, where every line of the one drawing has to be covered
 * by the other, and nothing lies along anything else. RIDGELINE_CASES and RIDGELINE_SEED as everywhere. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "hidden/solid/convex.h"
#include "hidden/solid/once.h"
#include "hidden/solid/wires.h"
#include "tests/oracle/page_ink.h"
#include "tests/oracle/run_cases.h"
#include "tests/oracle/solid_scenes.h"
#include "view/cut.h"

#define LAT_MM (1.0 / LAT_PER_MM)
#define NEAR_MM (3 * ONCE_FLAT_LAT * LAT_MM)    /* a line of the group may stand for the edge */
#define TWICE_MM (0.5 * ONCE_FLAT_LAT * LAT_MM) /* so near is surely the same */
#define LEAST_MM (1.5 * ONCE_LEAST_LAT * LAT_MM)
#define END_MM (6 * ONCE_FLAT_LAT * LAT_MM) /* slivers */

typedef struct account {
    int64_t scenes, grouped;
    double bare, invented, twice, before_mm, after_mm, twice_before;
} account_t;

enum { SEEN, HIDDEN };
enum kernel { DASHED, PLAIN, WIRES };

/* With once (or NULL for without) into ink[SEEN] and ink[HIDDEN]. */
static int draw(solid_stage_t *t, enum kernel kernel, once_t *once, page_ink_t ink[2]) {
    for (int k = 0; k < 2; k++) ink[k] = (page_ink_t){.space = &t->map.lines};
    cut_t cut[2] = {{&t->map.lines, {&ink[SEEN], page_ink_take}}, {&t->map.lines, {&ink[HIDDEN], page_ink_take}}};
    const ink_sink_t seen = cut_sink(&cut[SEEN]), hidden = cut_sink(&cut[HIDDEN]);
    uint8_t *mem = t->mem[2];
    size_t bytes = t->bytes, kept = 0;
    int err = 0;
    if (once) {
        err = once_build(once, &t->map, kernel != PLAIN, false, mem, bytes);
        cut[SEEN].next = once_seen(once, cut[SEEN].next);
        cut[HIDDEN].next = once_dashed(once, cut[HIDDEN].next);
        kept = once->bytes;
    }
    const hidden_job_t job = {.mem = mem + kept, .bytes = bytes - kept, .sink = &seen};
    const ink_sink_t *dashes = kernel == DASHED ? &hidden : NULL;
    if (!err && kernel == WIRES) err = wires_draw(&t->map, &job, &t->stats);
    if (!err && kernel != WIRES) err = convex_draw(&t->map, dashes, &job, &t->stats);
    if (!err && once) err = once_finish(once);
    return err;
}

static bool judge(solid_stage_t *t, enum kernel kernel, account_t *a) {
    page_ink_t raw[2], ink[2];
    page_lines_t both = {0};
    once_t once;
    if (draw(t, kernel, NULL, raw) || draw(t, kernel, &once, ink)) return false;
    for (int k = 0; k < 2; k++)
        for (size_t i = 0; i < raw[k].lines.n; i++) page_lines_add(&both, raw[k].lines.line[i]);
    const page_lines_t *seen = &ink[SEEN].lines, *dashed = &ink[HIDDEN].lines;
    double bare = page_lines_uncovered(&raw[SEEN].lines, seen, NEAR_MM);
    double invented = fmax(page_lines_uncovered(seen, &raw[SEEN].lines, NEAR_MM),
                           page_lines_uncovered(dashed, &raw[HIDDEN].lines, NEAR_MM));
    page_lines_t drawn = {0};
    for (size_t i = 0; i < seen->n; i++) page_lines_add(&drawn, seen->line[i]);
    for (size_t i = 0; i < dashed->n; i++) page_lines_add(&drawn, dashed->line[i]);
    bare = fmax(bare, page_lines_uncovered(&both, &drawn, NEAR_MM));
    double twice = page_lines_twice(&drawn, &drawn, TWICE_MM, LEAST_MM);
    a->twice_before = fmax(a->twice_before, page_lines_twice(&both, &both, TWICE_MM, LEAST_MM));
    a->bare = fmax(a->bare, bare);
    a->invented = fmax(a->invented, invented);
    a->twice = fmax(a->twice, twice);
    a->before_mm += page_lines_length(&both);
    a->after_mm += page_lines_length(&drawn);
    a->grouped += once.group != NULL;
    a->scenes++;
    for (int k = 0; k < 2; k++) page_lines_free(&raw[k].lines), page_lines_free(&ink[k].lines);
    page_lines_free(&both);
    page_lines_free(&drawn);
    return bare <= END_MM && invented <= END_MM && twice == 0;
}

static int run(const char *name, uint64_t first, uint64_t count, int objects, enum kernel kernel) {
    uint64_t from, to;
    account_t a = {0};
    int failed = 0;
    if (!cases_seeds(first, count, &from, &to)) return 0;
    for (uint64_t seed = from; seed < to && failed < 20; seed++) {
        solid_scene_t s;
        solid_stage_t t;
        account_t one = {0};
        solid_scene_flush(&s, seed, objects);
        bool good = solid_stage_make(&t, &s, false) != 0 || judge(&t, kernel, &one);
        if (!good)
            print_message("# FAILED RIDGELINE_SEED=%llu build/tests/property/test_once_random: %s\n"
                          "#   %s: not covered %g mm, invented %g mm, twice %g mm\n",
                          (unsigned long long)seed, s.what, name, one.bare, one.invented, one.twice);
        failed += !good;
        a = (account_t){a.scenes + one.scenes,     a.grouped + one.grouped,
                        fmax(a.bare, one.bare),    fmax(a.invented, one.invented),
                        fmax(a.twice, one.twice),  a.before_mm + one.before_mm,
                        a.after_mm + one.after_mm, fmax(a.twice_before, one.twice_before)};
        solid_stage_free(&t);
        solid_scene_free(&s);
    }
    print_message(
        "# once, %s: %lld scenes, something coincides in %lld; %.0f m of ink are %.0f m; worst run not covered "
        "%.4f mm, invented %.4f mm, still twice %.4f mm (without %.1f mm)\n",
        name, (long long)a.scenes, (long long)a.grouped, a.before_mm / 1e3, a.after_mm / 1e3, a.bare, a.invented,
        a.twice, a.twice_before);
    return failed;
}

static void solids(void **state) {
    (void)state;
    assert_int_equal(run("solids, dashed", 0, cases_scaled(1500), 6, DASHED), 0);
}
/* Edges between faces that are turned away are not looked at. */
static void solids_plain(void **state) {
    (void)state;
    assert_int_equal(run("solids", 2000000000, cases_scaled(1000), 6, PLAIN), 0);
}
static void wire_frames(void **state) {
    (void)state;
    assert_int_equal(run("wires", 1000000000, cases_scaled(1500), 6, WIRES), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(solids),
        cmocka_unit_test(solids_plain),
        cmocka_unit_test(wire_frames),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
