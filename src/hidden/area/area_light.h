/* area_light.h - lights of a scene of solids, and what of each face they reach.
 *
 * Shadows as Weiler and Atherton make them (section "Shadowing"): the scene is sorted once more, seen from the light;
 * polygons visible from there are lit, and come back as detail of the faces they belong to. A parallel light sees the
 * scene in a parallel view, a point light in perspective, as far as the whole scene is in front of it. Lit polygons are
 * mapped from one view to the other over three corners of their face: affine in space, so right in perspective. */
#ifndef AREA_LIGHT_H
#define AREA_LIGHT_H

#include "config.h"
#include "hidden/area/area.h"
#include "hidden/area/area_face.h"

typedef struct light {
    num_t at[3]; /* the direction to the light, in the scene's coordinates; a point light's place */
    bool point;
} light_t;

/* As seen in the map's view (camera_t.unit): the cosine between a light and the side of a face that the eye sees, q30;
 * negative where that looks away from it; LIGHT_GRAZING_Q30 and less count as nothing in tones. A point light is seen
 * from the middle of the face's corners. */
#define LIGHT_GRAZING_Q30                                                                                              \
    (INK_ONE / 8192) /* a face that gets less is dark: rounding would decide where the light ends */
int64_t light_slope(const light_t *l, const solid_map_t *m, int32_t face);

/* Lit polygons of all faces and lights, on the eye's lattice: blocks of words, a list for each light and face. */
typedef struct lit {
    const solid_map_t *m;
    area_lattice_t eye_lattice;
    int32_t lights;
    int32_t *head; /* lights times faces */
    int32_t *word;
    int32_t words, words_max;
    int64_t intersections; /* the most pairs of faces that a light saw cut through each other */
    /* while a light looks at the scene: */
    int32_t which;
    camera_t camera;
    solid_map_t map;
    area_lattice_t lattice;
} lit_t;

/* What the lists take beside the polygons themselves. */
size_t lit_bytes(const solid_map_t *m, int32_t lights);
/* Sorts the scene from each light. mem (aligned to 8) is kept, sort_mem lent. Returns 0; ERR_FULL; ERR_VALUE for a
 * direction that is none; ERR_LIGHT for a point light within the scene, or nearly. Cost: a sort for each light. */
int lit_make(lit_t *s, const solid_map_t *m, const light_t *light, int32_t lights, void *mem, size_t bytes,
             void *sort_mem, size_t sort_bytes);
/* Gives back what it did not take of mem; returns what it keeps. */
size_t lit_shrink(lit_t *s);
/* Copies all that light `which` reaches of a face into out, whose arrays have room for n_max vertices and as many
 * contours: together they are that (clip.h's nonzero rule); with a window, as far as it lies within (area_limit.h).
 * Returns 0 or ERR_FULL. */
int lit_polygons(const lit_t *s, int32_t which, int32_t face, const area_box_t *window, clip_out_t *out);

#endif
