/* scenes.h - surfaces and viewpoints to try the kernels on: seeded, named, shrinkable.
 *
 * A scene owns its arrays. Coordinates are doubles with few bits where degeneracy is meant (eyes in grid planes, over
 * vertices, level with a plateau), so that what should coincide does. */
#ifndef SCENES_H
#define SCENES_H

#include <stdint.h>

#include "tests/oracle/judge.h"

typedef struct scene {
    char what[240];
    surface_ref_t ref;
    page_view_t view;
    double to[3];
} scene_t;

/* Shapes of the heights and places of the eye; scene_random draws both. */
enum scene_shape {
    SHAPE_SMOOTH,
    SHAPE_RANDOM,
    SHAPE_CLIFFS,
    SHAPE_PLATEAU,
    SHAPE_WALK,
    SHAPE_RIDGES,
    SHAPE_SINC,
    SHAPE_SPIKES,
    SHAPE_TINY,   /* differences of 1e-6 on a plain */
    SHAPE_PLAIN,  /* a plane */
    SHAPE_SADDLE, /* every cell twisted */
    SHAPES
};
enum scene_eye {
    EYE_OUTSIDE,
    EYE_FAR,
    EYE_NEAR,
    EYE_GRID_PLANE, /* outside, in the plane of a grid line */
    EYE_INSIDE,     /* over the rectangle, above everything */
    EYE_OVER_VERTEX,
    EYE_OVER_EDGE,
    EYE_LEVEL, /* at the height of some vertex */
    EYE_BELOW,
    EYE_DIRECTION,
    EYE_DIRECTION_AXIS,
    EYE_DIRECTION_DIAGONAL,
    EYE_DIRECTION_STEEP, /* straight down included */
    EYES
};

/* A scene of nx by ny vertices on [-2,2]^2, heights 0, looked at from (6,8,3): to be filled in by hand. */
void scene_init(scene_t *s, int nx, int ny);
void scene_free(scene_t *s);
/* A copy that owns its arrays; out is not freed first. */
void scene_copy(const scene_t *s, scene_t *out);
void scene_shape(scene_t *s, enum scene_shape shape, uint64_t *rng);
/* Puts the eye; scene_aim must follow. */
void scene_eye(scene_t *s, enum scene_eye eye, uint64_t *rng);
/* Non-uniform coordinates: cells from 1 to `ratio` times the smallest. */
void scene_stretch(scene_t *s, double ratio, uint64_t *rng);
/* Recomputes the camera after the surface or the eye have changed. */
void scene_aim(scene_t *s);
/* Makes scene number `seed`. `max` bounds nx and ny; with_holes lets points be undefined. */
void scene_random(scene_t *s, uint64_t seed, int max, int with_holes);
/* Writes the scene as C, to be pasted into a test. */
void scene_print(const scene_t *s);
/* Makes s smaller and simpler as long as fails(ctx, s) stays true. */
void scene_shrink(scene_t *s, int (*fails)(void *ctx, const scene_t *s), void *ctx);

double scene_uniform(uint64_t *rng);   /* [0, 1) */
int scene_below(uint64_t *rng, int n); /* 0 .. n - 1 */
/* The unit matrix, or turned by any angles. */
void scene_turn(uint64_t *rng, bool turned, double m[3][3]);

#endif
