/* profiles_cache.h - profiles evaluated once and kept, where memory allows.
 *
 * A drawing asks for each point several times: for the range of heights, for the scale, to hide, and to draw. The cache
 * is a profiles source like the one behind it, with the same answers. */
#ifndef PROFILES_CACHE_H
#define PROFILES_CACHE_H

#include "scene/profiles.h"
#include <stddef.h>

typedef struct profiles_cache {
    num_t *xyz;     /* 3 for each vertex, profile after profile */
    int32_t *first; /* of each profile, and the end: the number of its first vertex */
} profiles_cache_t;

/* Evaluates all of *p into mem (aligned to 16; the caller's, as c is, until the drawing is done) and makes *p the
 * cache. Returns the bytes used: 48 for each vertex and 4 for each profile; or 0 if they do not fit, and *p is what it
 * was. tick (may be NULL) is called once a profile, for progress. */
size_t profiles_cache_fill(profiles_cache_t *c, profiles_t *p, void *mem, size_t bytes,
                           void (*tick)(void *ctx, int32_t done, int32_t of), void *tick_ctx);

#endif
