/* compare_ink.h - do two drawings of one scene show the same ink? No reference is asked, so it costs little more than
 * the drawings themselves. */
#ifndef COMPARE_INK_H
#define COMPARE_INK_H

#include "tests/oracle/run_kernel.h"

enum compare_how {
    COMPARE_SAME,   /* what one has the other has */
    COMPARE_WITHIN, /* what b has a has: something that was added hides and shows nothing new */
};

/* The longest run along a grid line of s, in mm on its page, that contradicts. `where` gets its place; may be NULL. */
double compare_ink(const scene_t *s, const run_drawing_t *a, const run_drawing_t *b, enum compare_how how,
                   judge_spot_t *where);

#endif
