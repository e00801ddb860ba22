/* solid_build.h - what the generators of scenes of solids share: bodies put together from prisms, turned as a whole,
 * and eyes in places where much coincides. One scene at a time. */
#ifndef SOLID_BUILD_H
#define SOLID_BUILD_H

#include "tests/oracle/solid_scenes.h"

#define SOLID_FULL_TURN 6.283185307179586

/* An empty scene, and how what is put into it is turned. */
void solid_build_begin(solid_scene_t *s, uint64_t seed);
double solid_build_uniform(double lo, double hi);
int solid_build_pick(int n); /* 0 .. n - 1 */
int solid_build_put(solid_ref_t *r, double x, double y, double z);
/* A prism from z0 to z1 over a polygon of up to SOLID_CORNERS that turns to the left. */
#define SOLID_CORNERS 64
void solid_build_prism(solid_ref_t *r, const double (*xy)[2], int n, double z0, double z1);
void solid_build_box(solid_ref_t *r, double x, double y, double z, double a, double b, double c);

enum solid_eye_place { FROM_PLANE, FROM_LINE, FROM_ANYWHERE, FROM_NEAR, ALONG_AXES, ALONG_ANY, PLACES, FROM_CLOSE };

/* Chooses the eye, of that kind, and ends the scene. */
void solid_build_end(solid_scene_t *s, const char *what, enum solid_eye_place kind);

#endif
