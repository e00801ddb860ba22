/* clip_families.h - families of pairs of polygons that break clippers, by the way in which they do. */
#ifndef CLIP_FAMILIES_H
#define CLIP_FAMILIES_H

#include "tests/oracle/clip_judge.h"

int clip_family_count(void);
const char *clip_family_name(int family);
/* The pair of a seed; rule: how it is to be filled. */
void clip_family_make(int family, uint64_t seed, clip_shape_t *subject, clip_shape_t *clip, enum clip_fill *rule);

#endif
