/* corner.c - see corner.h. */
#include "hidden/surface/corner.h"

enum facet_kind corner_judge(sweep_t *s, const corner_t *q) {
    return corner_judge_here(s, q);
}
