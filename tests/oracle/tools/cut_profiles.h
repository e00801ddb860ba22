/* cut_profiles.h - a formula cut by vertical planes square to the view, in floating point: what `set hidden3d horizon`
 * draws.
 *
 * COUNT planes evenly spaced in depth, the first and the last touching the rectangle; along each, SAMPLES points from
 * border to border, left to right. Depth is away from the eye through the rectangle's middle, for a parallel view along
 * the view. Planes behind the eye or within a 64th of the farthest one's distance are left out. */
#ifndef CUT_PROFILES_H
#define CUT_PROFILES_H

#include "tests/oracle/horizon_ref.h"

typedef struct cut_scene {
    const char *text;
    double x[2], y[2], limit[2]; /* heights beyond the limits are undefined */
    int count, samples;
} cut_scene_t;

/* Fills r (arrays from malloc) for its eye. Returns NULL, or what is wrong with the formula. */
const char *cut_profiles(const cut_scene_t *s, horizon_ref_t *r);

#endif
