/* solid_cases.c - see solid_cases.h. */
#include "tests/oracle/solid_cases.h"

#include <stdio.h>

#include "tests/oracle/solid_laws.h"

static void tell(const cases_t *c, uint64_t seed, const char *what, const judge_report_t *r) {
    printf("# FAILED RIDGELINE_SEED=%llu build/tests/property/%s: %s\n"
           "#   missing %g mm (edge %d, %g to %g), false %g mm (edge %d, %g to %g), end %g steps, twice %g mm\n",
           (unsigned long long)seed, c->program, what, r->missing_mm, r->missing.line, r->missing.from, r->missing.to,
           r->false_mm, r->falsely.line, r->falsely.from, r->falsely.to, r->end_steps, r->twice_mm);
}

typedef struct judging {
    solid_judge_t judge;
    void *ctx;
} judging_t;

static bool fails(void *ctx, const solid_scene_t *s) {
    const judging_t *j = ctx;
    judge_report_t r = {0};
    return j->judge(j->ctx, s, &r) == SOLID_FAILED;
}

int solid_cases_random(cases_t *c, uint64_t first, uint64_t count, int objects, solid_judge_t judge, void *ctx) {
    return solid_cases_made(c, first, count, objects, solid_scene_random, judge, ctx);
}

enum solid_verdict solid_cases_area(void *cut, const solid_scene_t *s, judge_report_t *r) {
    int *count = cut;
    area_stats_t area = {0};
    const bool good = solid_scene_judge_area(s, r, &area);
    if (count) *count += area.intersections > 0;
    if (good || !area.intersections) return good ? SOLID_GOOD : SOLID_FAILED;
    r->missing_mm = r->end_steps = 0;
    return r->false_mm <= CASES_RUN_MM && r->twice_mm <= CASES_TWICE_MM ? SOLID_GOOD : SOLID_FAILED;
}

/* False if it failed. */
static bool try_scene(cases_t *c, uint64_t seed, solid_scene_t *s, judging_t *by, bool shrink) {
    judge_report_t r = {0};
    const enum solid_verdict verdict = by->judge(by->ctx, s, &r);
    if (verdict == SOLID_FAILED) tell(c, seed, s->what, &r);
    if (verdict == SOLID_FAILED && shrink) {
        printf("#   shrunk:\n");
        solid_scene_shrink(s, fails, by);
        solid_scene_print(s);
    }
    if (verdict != SOLID_LEFT_OUT) {
        c->run++;
        c->facets += s->ref.nf;
        judge_worst(&c->worst, &r);
    }
    return verdict != SOLID_FAILED;
}

int solid_cases_made(cases_t *c, uint64_t first, uint64_t count, int objects, solid_make_t make, solid_judge_t judge,
                     void *ctx) {
    judging_t by = {judge, ctx};
    uint64_t from, to;
    int failed = 0;
    if (!cases_seeds(first, count, &from, &to)) return 0;
    for (uint64_t seed = from; seed < to && failed < 20; seed++) {
        solid_scene_t s;
        make(&s, seed, objects);
        failed += !try_scene(c, seed, &s, &by, failed < 3);
        solid_scene_free(&s);
    }
    cases_summary(c);
    return failed;
}

int solid_cases_once_wrong(cases_t *c, const uint64_t *seed, size_t seeds, int objects, solid_make_t make,
                           solid_judge_t judge, void *ctx) {
    judging_t by = {judge, ctx};
    uint64_t only;
    int failed = 0;
    if (cases_only_seed(&only)) return 0;
    for (size_t k = 0; k < seeds; k++) {
        solid_scene_t s;
        make(&s, seed[k], objects);
        failed += !try_scene(c, seed[k], &s, &by, failed < 3);
        solid_scene_free(&s);
    }
    cases_summary(c);
    return failed;
}
