/* profiles.h - lines cut out of a surface by parallel vertical planes, front to back: the scene of horizon.h.
 *
 * Each profile is a polyline in its plane; along it the lateral coordinate strictly increases (to the right as the
 * viewer sees it), the depth is constant. A point may be asked for in any order and again; it is a pure function of
 * (k, v). The source outlives the drawing. */
#ifndef PROFILES_H
#define PROFILES_H

#include "num/num.h"
#include "view/camera.h"

typedef struct profiles {
    int32_t count;      /* profiles; 0 is the nearest to the viewer */
    int32_t max_points; /* no profile has more vertices */
    void *ctx;          /* the source's own */
    /* The frame of the planes in plan: to the right as the viewer sees it, and away from the viewer; square to each
     * other and of equal length. Along a profile side . (x, y) increases and away . (x, y) is constant. */
    num_t side[2], away[2];
    /* Vertices of profile k, 0 <= k < count; 0 or 1 means there is nothing to draw. */
    int32_t (*points)(void *ctx, int32_t k);
    /* Vertex v of profile k in world coordinates: xyz[0] and xyz[1] always, xyz[2] undefined in a gap. */
    void (*point)(void *ctx, int32_t k, int32_t v, num_t xyz[3]);
} profiles_t;

/* A function sampled along the cutting planes themselves. */
typedef struct profiles_sampled {
    void *fn_ctx;
    num_t (*z_of)(void *fn_ctx, num_t x, num_t y); /* undefined where the function is, or beyond zrange */
    num_t x0, x1, y0, y1;                          /* the rectangle */
    int32_t samples;
    /* The rest is the source's own. */
    num_t away[2], depth0, depth_step; /* profile k lies where away . (x, y) = depth0 + k * depth_step */
    int32_t at;                        /* the profile whose ends are at hand, or -1 */
    bool crosses;                      /* does it cross the rectangle */
    num_t end[2][2];                   /* its left and right end in plan */
} profiles_sampled_t;

/* Sets the frame for a view of the rectangle [x0, x1] x [y0, y1]: away points from the eye to its middle (parallel
 * views: along the view). Straight down it is +y. */
void profiles_frame(profiles_t *p, const camera_t *cam, const num_t x[2], const num_t y[2]);

/* Makes p a source of `count` profiles of `samples` vertices each, square to the view, from border to border of the
 * rectangle; the first and the last touch it, the rest are evenly spaced. Fields fn_ctx, z_of, x0..y1 and samples
 * are set by the caller; s must outlive p. Returns 0, or ERR_VALUE for an empty rectangle, count < 2 or samples < 2. */
int profiles_from_function(profiles_t *p, profiles_sampled_t *s, const camera_t *cam, int32_t count);

#endif
