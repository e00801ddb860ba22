/* solid_ref.h - the reference for solids: what of a segment is hidden, by rays.
 *
 * Not the kernel's method: no convexity, no closed bodies, no front and back, no outlines, no lattice. A segment's
 * visibility can change only where its picture crosses that of a face's border or where it passes through a face's
 * plane; between those places a ray from the middle towards the eye is tested against every face (its plane, and
 * even-odd in the polygon). Long double; O(faces^2) a segment. */
#ifndef SOLID_REF_H
#define SOLID_REF_H

#include "tests/oracle/judge.h"

typedef struct solid_ref {
    exact_point_t *vertex;
    int nv;
    int *corner, nc;      /* of all faces, one after another */
    int *first, nf;       /* of each face, in corner; and one more */
    int (*line)[2], nl;   /* free segments */
    int (*edge)[2], ne;   /* solid_ref_finish(): all different pairs of places */
    bool *clear;          /* is a face translucent? NULL: none is */
    int (*detail)[3], nd; /* lines on a face: its number, in order, and two vertices */
    double size;          /* of the scene */
    exact_eye_t eye;
} solid_ref_t;

void solid_ref_free(solid_ref_t *r);
int solid_ref_vertex(solid_ref_t *r, double x, double y, double z); /* its number */
void solid_ref_face(solid_ref_t *r, const int *v, int n);
void solid_ref_line(solid_ref_t *r, int a, int b);
/* The faces of a box: bit k of a corner's number tells its side along axis k. */
void solid_ref_box(solid_ref_t *r, const int v[8]);
/* Finds the edges. */
void solid_ref_finish(solid_ref_t *r);
/* The edge between two places that are at most so far from its own; -1 if there is none. *turned: it runs from b to a.
 */
int solid_ref_find(const solid_ref_t *r, const double a[3], const double b[3], double within, bool *turned);
/* What of the segment is hidden. Faces in whose plane both points of `own` lie do not count. either: where a line of
 * sight only touches a face's border; may be NULL. */
void solid_ref_hidden(const solid_ref_t *r, const exact_point_t at[2], const exact_point_t own[2], spans_t *hidden,
                      spans_t *either);
/* What of the segment has a picture that is not on that of the face. either: where it is on its border, or the face is
 * seen edge-on. */
void solid_ref_beside(const solid_ref_t *r, int face, const exact_point_t at[2], spans_t *beside, spans_t *either);
/* Does the eye lie in a face? What it sees is then a matter of taste. */
bool solid_ref_eye_touches(const solid_ref_t *r);
judge_subject_t judge_solid(const solid_ref_t *r);

#endif
