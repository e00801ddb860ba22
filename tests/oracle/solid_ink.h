/* solid_ink.h - what a kernel draws of solids, on its way to the judge. */
#ifndef SOLID_INK_H
#define SOLID_INK_H

#include "tests/oracle/solid_scenes.h"

/* What the kernel draws, as pieces of the reference's edges. */
typedef struct solid_ink {
    const solid_ref_t *ref;
    const solid_t *solid;
    const page_view_t *view;
    double unit; /* of the scene's lattice */
    judge_piece_t *piece;
    size_t n;
    int lost;     /* pieces on edges that the reference does not know */
    double moved; /* steps that the lattice has moved an end on the page, at most */
} solid_ink_t;

/* An ink_sink_t's: edges only. */
int solid_ink_take(void *ctx, const ink_piece_t *p);
/* Where edges of bodies that touch lie on top of one another, ink on one of them is ink on the others. */
void solid_ink_share(solid_ink_t *ink);
void solid_view_of(const camera_t *cam, page_view_t *v, exact_eye_t *eye);

#endif
