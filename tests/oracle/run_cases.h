/* run_cases.h - what the property and hard tests share: limits, the account of the worst, and how a failure is told. */
#ifndef RUN_CASES_H
#define RUN_CASES_H

#include <stdint.h>

#include "tests/oracle/run_kernel.h"

/* The limits of every test: no run of missing or false ink longer than one step, ends within a quarter step, nothing
 * drawn twice (but for the rounding of a crossing to the nearest unit). */
#define CASES_RUN_MM JUDGE_STEP_MM
#define CASES_END_STEPS 0.25
#define CASES_TWICE_MM 1e-3

typedef struct cases {
    const char *name;
    const char *program; /* the property test to repeat it with, if RIDGELINE_SEED does */
    int every;           /* judge every so-manieth line only; 0: all */
    judge_report_t worst;
    int64_t run, facets;
    int64_t beside; /* scenes in which the page had to tell that ink is another line's */
} cases_t;

/* RIDGELINE_CASES multiplies how many cases are tried (default 1, may be a fraction). */
uint64_t cases_scaled(uint64_t n);
/* The seed to begin with: `first`, or after RIDGELINE_ROUND (default 0) times `count` others, for `make soak`. */
uint64_t cases_first(uint64_t first, uint64_t count);
/* RIDGELINE_SEED, if set, is the one seed to try: returns true and puts it into *seed. */
bool cases_only_seed(uint64_t *seed);
/* The seeds from <= seed < to of a group of `count` that begins at `first`, as the three above say. Returns false if
 * RIDGELINE_SEED belongs to another group: seeds of groups are 10^9 apart. */
bool cases_seeds(uint64_t first, uint64_t count, uint64_t *from, uint64_t *to);
/* Is the drawing within the limits? */
bool cases_good(const judge_report_t *r);
/* Draws and judges a surface scene. On failure prints the figures; with shrink, a smaller scene and the command that
 * repeats the failure as well. Returns false on failure. */
bool cases_surface(cases_t *c, const scene_t *s, uint64_t seed, bool shrink);
/* `count` scenes from seed `first` on, with up to `max` vertices a side; or the one of RIDGELINE_SEED if it lies in
 * the 10^9 seeds from `first` on, so that a seed says which test it belongs to. Shrinks the first three failures.
 * Returns the number of failures, at most 20. */
int cases_random_surfaces(const char *name, uint64_t first, uint64_t count, int max, bool holes);
/* One `# ` line with the worst figures. */
void cases_summary(const cases_t *c);

#endif
