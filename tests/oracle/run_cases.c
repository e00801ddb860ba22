/* Case keeping for tests that judge drawings. */
#include "tests/oracle/run_cases.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "error.h"

uint64_t cases_scaled(uint64_t n) {
    const char *s = getenv("RIDGELINE_CASES");
    double k = s ? strtod(s, NULL) : 1;
    return k > 0 ? (uint64_t)ceil((double)n * k) : n;
}

uint64_t cases_first(uint64_t first, uint64_t count) {
    const char *s = getenv("RIDGELINE_ROUND");
    return first + (s ? strtoull(s, NULL, 0) : 0) * count;
}

bool cases_only_seed(uint64_t *seed) {
    const char *s = getenv("RIDGELINE_SEED");
    if (s) *seed = strtoull(s, NULL, 0);
    return s != NULL;
}

bool cases_seeds(uint64_t first, uint64_t count, uint64_t *from, uint64_t *to) {
    if (cases_only_seed(from)) {
        *to = *from + 1;
        return *from >= first && *from < first + 1000000000;
    }
    *from = cases_first(first, count);
    *to = *from + count;
    return true;
}

bool cases_good(const judge_report_t *r) {
    return r->missing_mm <= CASES_RUN_MM && r->false_mm <= CASES_RUN_MM && r->twice_mm <= CASES_TWICE_MM &&
           r->end_steps <= CASES_END_STEPS;
}

static int draw_and_judge(const scene_t *s, int every, judge_report_t *rep, hidden_stats_t *stats) {
    run_drawing_t d = {0};
    int err = run_perimeter(s, &d, stats);
    judge_subject_t what = judge_surface(&s->ref);
    what.every = every;
    *rep = (judge_report_t){0};
    if (err == 0) err = judge_pieces(&what, &s->view, d.piece, d.n, rep) ? 1 : 0;
    if (err == ERR_EMPTY) err = 0; /* a scene whose every point is a hole: rightly nothing drawn */
    run_drawing_free(&d);
    return err;
}

static int fails(void *ctx, const scene_t *s) {
    judge_report_t rep;
    hidden_stats_t stats;
    (void)ctx;
    if (draw_and_judge(s, 0, &rep, &stats) != 0) return 1;
    return !cases_good(&rep);
}

static void tell(const char *name, const scene_t *s, int err, const judge_report_t *r) {
    printf("# FAILED %s: %s\n#   error %d, missing %.5f mm (%s %d, %.6f to %.6f), false %.5f mm (%s %d, %.6f to %.6f), "
           "end off %.3f steps (%s %d at %.6f), twice %.5f mm\n",
           name, s->what, err, r->missing_mm, r->missing.family ? "col" : "row", r->missing.line, r->missing.from,
           r->missing.to, r->false_mm, r->falsely.family ? "col" : "row", r->falsely.line, r->falsely.from,
           r->falsely.to, r->end_steps, r->end.family ? "col" : "row", r->end.line, r->end.from, r->twice_mm);
}

bool cases_surface(cases_t *c, const scene_t *s, uint64_t seed, bool shrink) {
    judge_report_t rep;
    hidden_stats_t stats;
    int err = draw_and_judge(s, c->every, &rep, &stats);
    c->run++;
    c->facets += stats.facets;
    c->beside += rep.beside_mm > 0;
    judge_worst(&c->worst, &rep);
    if (err == 0 && cases_good(&rep)) return true;
    tell(c->name, s, err, &rep);
    if (c->program)
        printf("#   repeat: RIDGELINE_SEED=%llu build/tests/property/%s\n", (unsigned long long)seed, c->program);
    if (shrink) {
        scene_t small;
        printf("#   shrunk:\n");
        scene_copy(s, &small);
        scene_shrink(&small, fails, NULL);
        scene_print(&small);
        err = draw_and_judge(&small, 0, &rep, &stats);
        tell("shrunk", &small, err, &rep);
        scene_free(&small);
    }
    return false;
}

int cases_random_surfaces(const char *name, uint64_t first, uint64_t count, int max, bool holes) {
    cases_t c = {.name = name, .program = name};
    int failed = 0;
    uint64_t from, to;
    if (!cases_seeds(first, count, &from, &to)) return 0;
    for (uint64_t seed = from; seed < to && failed < 20; seed++) {
        scene_t s;
        scene_random(&s, seed, max, holes);
        if (!cases_surface(&c, &s, seed, failed < 3)) failed++;
        scene_free(&s);
    }
    cases_summary(&c);
    return failed;
}

void cases_summary(const cases_t *c) {
    const judge_report_t *w = &c->worst;
    printf(
        "# %s: %lld scenes, %lld facets, %.0f m of ink; worst run missing %.2f steps, false %.2f, end off %.2f steps, "
        "twice %.4f mm",
        c->name, (long long)c->run, (long long)c->facets, w->ink_mm / 1000, w->missing_mm / JUDGE_STEP_MM,
        w->false_mm / JUDGE_STEP_MM, w->end_steps, w->twice_mm);
    if (w->moved_steps >= .005) printf("; rounding the vertices moves ends by up to %.2f steps", w->moved_steps);
    if (c->beside > 0)
        printf("; in %lld a neighbour's ink in its place, up to %.1f mm", (long long)c->beside, w->beside_mm);
    printf("\n");
    fflush(stdout);
}
