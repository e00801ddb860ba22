/* horizon_ref.h - what of a set of profiles can be seen: the reference for the horizon kernel.
 *
 * Semantics (Greenspun and Little): on each vertical plane through the eye, the nearer profiles leave a highest and a
 * lowest line of sight. A point is hidden strictly below the highest and, on a finite surface, strictly above the
 * lowest as well; where no nearer profile is met it is visible. Method: every segment against every segment of every
 * nearer profile, by the signs of exact_sign.h; no horizon is kept. */
#ifndef HORIZON_REF_H
#define HORIZON_REF_H

#include <stdbool.h>

#include "tests/oracle/exact_sign.h"
#include "tests/oracle/spans.h"

typedef struct horizon_ref {
    int count;                  /* profiles, nearest first */
    const int *first;           /* count + 1 indices: profile k has points first[k] .. first[k + 1] - 1 */
    const exact_point_t *point; /* left to right along each profile, as the viewer sees it */
    const unsigned char *gap;   /* 1 where undefined; NULL if nowhere */
    bool infinite;              /* only the upper side exists */
    exact_eye_t eye;
} horizon_ref_t;

/* Is the segment from point k of the profile to point k + 1 there? */
bool horizon_ref_edge_exists(const horizon_ref_t *r, int profile, int k);
/* Where the segment, taken to be in `profile`, is hidden: intervals of [0, 1]. */
void horizon_ref_segment(const horizon_ref_t *r, int profile, const exact_point_t end[2], spans_t *hidden);
/* Where a nearer segment lies between the two copies of the segment, on the page. */
void horizon_ref_doubled(const horizon_ref_t *r, int profile, const exact_point_t end[2], const exact_point_t moved[2],
                         const exact_point_t other[2], spans_t *out);

#endif
