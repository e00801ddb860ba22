/* profiles_cache.h - profiles evaluated once and kept, where memory allows.
 *
 * A drawing asks for each point several times: for the range of heights, for the scale, to hide, and to draw. The cache
 * is a profiles source like the one behind it, with the same answers. */
#ifndef PROFILES_CACHE_H
#define PROFILES_CACHE_H

#include "scene/profiles.h"
#include <stddef.h>

#define PROFILES_CACHE_BYTES(count, max_points) ((size_t)(count) * (size_t)(max_points)*3 * sizeof(num_t))

typedef struct profiles_cache {
    profiles_t src;
    num_t *xyz; /* 3 for each vertex, max_points vertices for each profile */
} profiles_cache_t;

/* Evaluates all of *p into mem (PROFILES_CACHE_BYTES, aligned to 16; the caller's, as c is, until the drawing is done)
 * and makes *p the cache. */
void profiles_cache_fill(profiles_cache_t *c, profiles_t *p, void *mem);

#endif
