/* solid_cases.h - the frame of property tests over random scenes of solids: seeds, verdicts, how a failure is told. */
#ifndef SOLID_CASES_H
#define SOLID_CASES_H

#include "tests/oracle/run_cases.h"
#include "tests/oracle/solid_scenes.h"

enum solid_verdict { SOLID_GOOD, SOLID_FAILED, SOLID_LEFT_OUT };

/* Judges one scene; r is 0 before. */
typedef enum solid_verdict (*solid_judge_t)(void *ctx, const solid_scene_t *s, judge_report_t *r);

/* `count` scenes of up to so many objects from seed `first` on, or as RIDGELINE_SEED and its kin say. Prints failures,
 * with the command of c->program that repeats each, the first three made small, and a summary. Returns how many failed,
 * at most 20. */
typedef void (*solid_make_t)(solid_scene_t *s, uint64_t seed, int objects);
int solid_cases_made(cases_t *c, uint64_t first, uint64_t count, int objects, solid_make_t make, solid_judge_t judge,
                     void *ctx);
/* The same of seeds that were wrong once, in every round; of none if RIDGELINE_SEED tries one. */
int solid_cases_once_wrong(cases_t *c, const uint64_t *seed, size_t seeds, int objects, solid_make_t make,
                           solid_judge_t judge, void *ctx);
/* Judges by the area sort. Where faces cut through each other, edges may lie in the very lines of the cuts, which are
 * not drawn: there it is judged that nothing hidden is. cut: an int, counts such scenes; or NULL. */
enum solid_verdict solid_cases_area(void *cut, const solid_scene_t *s, judge_report_t *r);
/* Of solid_scene_random. */
int solid_cases_random(cases_t *c, uint64_t first, uint64_t count, int objects, solid_judge_t judge, void *ctx);

#endif
