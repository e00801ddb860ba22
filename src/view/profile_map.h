/* profile_map.h - the line space of profiles: each point is asked of its source and sent through the camera.
 *
 * A profile's vertex costs one evaluation and a dozen products of num_t; a drawing has few of them compared with a
 * grid. profiles_t is all it needs, so functions, data and terrains look the same here. */
#ifndef PROFILE_MAP_H
#define PROFILE_MAP_H

#include "scene/profiles.h"
#include "view/camera.h"

typedef struct profile_map {
    const profiles_t *src;
    const camera_t *cam;
    num_t lo[3], hi[3]; /* box of all defined points */
    line_space_t lines;
} profile_map_t;

/* Measures the box of the defined points. Returns 0 or ERR_EMPTY. src outlives m. tick (may be NULL) is called once a
 * profile, for progress. */
int profile_map_measure(profile_map_t *m, const profiles_t *src, void (*tick)(void *ctx, int32_t done, int32_t of),
                        void *tick_ctx);
/* Prepares m->lines for a camera, which outlives m. Returns 0 or ERR_VALUE. */
int profile_map_setup(profile_map_t *m, const camera_t *cam);

#endif
