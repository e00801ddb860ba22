/* families.h - random scenes by families: what the property tests of unusual surfaces share.
 *
 * A family takes one of the plain random scenes and pushes it somewhere: to an end of what is possible, or to where
 * much coincides. */
#ifndef FAMILIES_H
#define FAMILIES_H

#include "tests/oracle/run_cases.h"

typedef struct family {
    const char *name; /* in front of its figures */
    void (*push)(scene_t *s, uint64_t *rng);
    bool holes; /* it may have some */
} family_t;

/* Draws and judges `count` scenes of each of n families, seeds from `first` on, as RIDGELINE_CASES, _ROUND and _SEED
 * say. An eye closer to the surface than 25 millionths of its width is moved away: on it nothing has a right answer.
 * Prints a line for each family. Returns the number of failures, 20 at most. */
int families_run(const char *program, const family_t *family, int n, uint64_t first, uint64_t count);

/* For the families themselves. */
double family_log_uniform(uint64_t *rng, double lo, double hi);
double *family_height(const scene_t *s, int i, int j);
/* Somewhere on the surface: a vertex, a place on a grid line, or any. */
void family_place(const scene_t *s, uint64_t *rng, double at[3]);
/* A hole that is a half-plane, a ring, a checkerboard, or spots; nothing where the scene has none. */
void family_holes(scene_t *s, uint64_t *rng);

#endif
