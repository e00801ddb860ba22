/* hard_pairs.h - the hard list of pairs of polygons: what touches, coincides, degenerates, and is rounded into each
 * other. */
#ifndef HARD_PAIRS_H
#define HARD_PAIRS_H

#include "tests/oracle/clip_judge.h"

int hard_pairs_count(void);
const char *hard_pairs_name(int i);
void hard_pairs_build(int i, clip_shape_t *subject, clip_shape_t *clip, enum clip_fill *fill);

#endif
