/* affine.h - what `translate`, `rotate` and `scale` do to the vertices of an element of splot. */
#ifndef AFFINE_H
#define AFFINE_H

#include "num/num.h"

typedef struct affine {
    num_t m[3][4]; /* x' = m[0][0] x + m[0][1] y + m[0][2] z + m[0][3], ... */
} affine_t;

void affine_identity(affine_t *a);
/* Each comes after what a does already. degrees: about x, then about y, then about z, counter-clockwise seen from the
 * axis' end; quarter turns are exact. */
void affine_translate(affine_t *a, const num_t by[3]);
void affine_scale(affine_t *a, const num_t by[3]);
void affine_rotate(affine_t *a, const num_t degrees[3]);
/* Moves p. */
void affine_apply(const affine_t *a, num_t p[3]);

#endif
