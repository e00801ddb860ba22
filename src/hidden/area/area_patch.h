/* area_patch.h - surface detail with a tone of its own: polygons on a face that give back less of the light than it
 * does (Weiler & Atherton 1977, "surface detail").
 *
 * Detail hides nothing, so it takes no part in the sort: a visible polygon of the face is cut by the patches on it,
 * the last one, which lies on top, first. What is left belongs to the face. */
#ifndef AREA_PATCH_H
#define AREA_PATCH_H

#include "hidden/area/area_face.h"
#include "poly/clip.h"

typedef struct area_patches {
    const area_lattice_t *lattice;
    clip_out_t patch, inside, rest[2]; /* with room for n_max vertices and as many contours */
    uint8_t *scratch;
    size_t scratch_bytes;
} area_patches_t;

/* Does the scene have any? */
bool area_patch_any(const solid_t *s);
/* Lays them out in mem, aligned to 8, which is kept as long as a. The lattice outlives it, too. */
void area_patches_init(area_patches_t *a, const area_lattice_t *l, void *mem, size_t bytes);

/* Takes a part of a visible polygon; percent: of its light that it gives back. Edges have any tag. */
typedef struct area_patch_sink {
    void *ctx;
    int (*part)(void *ctx, const poly_t *p, int32_t percent);
} area_patch_sink_t;

/* Gives the parts of a visible polygon of a face to sink; clip_mem is lent, and free for the sink. Returns 0, ERR_FULL
 * or the sink's error. Cost: a clip for each patch of the face. */
int area_patches_cut(area_patches_t *a, int32_t face, const poly_t *p, void *clip_mem, size_t clip_bytes,
                     const area_patch_sink_t *sink);

#endif
