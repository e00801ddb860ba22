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

int solid_cases_made(cases_t *c, uint64_t first, uint64_t count, int objects, solid_make_t make, solid_judge_t judge,
                     void *ctx) {
    uint64_t from, to;
    int failed = 0;
    if (!cases_seeds(first, count, &from, &to)) return 0;
    for (uint64_t seed = from; seed < to && failed < 20; seed++) {
        solid_scene_t s;
        judge_report_t r = {0};
        make(&s, seed, objects);
        enum solid_verdict verdict = judge(ctx, &s, &r);
        if (verdict == SOLID_FAILED) {
            failed++;
            tell(c, seed, s.what, &r);
            if (failed <= 3) {
                printf("#   shrunk:\n");
                solid_scene_shrink(&s, fails, &(judging_t){judge, ctx});
                solid_scene_print(&s);
            }
        }
        if (verdict != SOLID_LEFT_OUT) {
            c->run++;
            c->facets += s.ref.nf;
            judge_worst(&c->worst, &r);
        }
        solid_scene_free(&s);
    }
    cases_summary(c);
    return failed;
}
