/* metamorph.h - changes of a scene after which its drawing must be what it was: laws that need no reference.
 *
 * A law makes another scene from one, and takes what is drawn of that back to the lines of the first. */
#ifndef METAMORPH_H
#define METAMORPH_H

#include "tests/oracle/compare_ink.h"

enum metamorph_law {
    LAW_QUARTER,     /* a quarter turn about the z axis */
    LAW_MIRROR,      /* x becomes -x */
    LAW_TRANSLATE,   /* by numbers that are not of the grid */
    LAW_SCALE,       /* 1024 times as large */
    LAW_UPSIDE_DOWN, /* z becomes -z: the upper and the lower horizon change places */
    LAW_REFINE,      /* every cell, being flat, cut into four */
    LAW_BEHIND,      /* one more row, on the side away from the eye */
    LAW_HOLES,       /* two more rows away from the eye, undefined here and there: another kernel draws the same */
    LAW_FRONT,       /* one more row, on the side of the eye: it can only hide */
    METAMORPH_LAWS
};

const char *metamorph_name(enum metamorph_law law);
enum compare_how metamorph_how(enum metamorph_law law);
/* Makes scene number `seed` for the law: of up to `max` vertices a side. */
void metamorph_scene(enum metamorph_law law, uint64_t seed, int max, scene_t *s);
/* Makes t, to be freed, from s. False, and no t, where the law says nothing of s (the eye on the wrong side, cells that
 * are not flat). t has no camera: scene_aim. */
bool metamorph_apply(enum metamorph_law law, const scene_t *s, scene_t *t);
/* Takes a piece of the drawing of t back to s. False for ink of what was added. */
bool metamorph_back(enum metamorph_law law, const scene_t *s, judge_piece_t *p);

#endif
