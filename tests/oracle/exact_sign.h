/* exact_sign.h - the determinants behind every decision of the oracle, with signs that are never wrong.
 *
 * Arguments are doubles taken at their word. A determinant is computed in long double together with a bound on
 * its error; where the bound does not settle the sign, it is computed again with GMP rationals. So the sign of
 * the result is exact, zero means exactly zero, and the value is good to about 2^-58 of its largest term.
 *
 * `eye` is a point (h = 1) or a direction from the scene to the eye (h = 0), the eye at infinity. */
#ifndef EXACT_SIGN_H
#define EXACT_SIGN_H

typedef struct exact_point {
    double x, y, z;
} exact_point_t;

typedef struct exact_eye {
    double x, y, z;
    int h; /* 1 perspective, 0 parallel */
} exact_eye_t;

/* Positive when q is to the left of the ground line from the eye through p. */
long double exact_side(const exact_eye_t *e, const exact_point_t *p, const exact_point_t *q);
/* Positive when r is to the left of the ground line from p to q. */
long double exact_left(const exact_point_t *p, const exact_point_t *q, const exact_point_t *r);
/* Positive when p and q lie in the same direction from the eye on the ground (scalar product); 1 for a parallel view.
 */
long double exact_ahead(const exact_eye_t *e, const exact_point_t *p, const exact_point_t *q);
/* Determinant of (p - eye, q - eye, r - eye): which side of the plane eye-p-q is r. */
long double exact_plane(const exact_eye_t *e, const exact_point_t *p, const exact_point_t *q, const exact_point_t *r);
/* Positive when r is above the plane through a, b, c (counter-clockwise on the ground). */
long double exact_above(const exact_point_t *a, const exact_point_t *b, const exact_point_t *c, const exact_point_t *r);

#endif
