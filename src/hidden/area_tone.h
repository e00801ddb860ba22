/* area_tone.h - light, shadow and hatching for the area sort.
 *
 * Shadows as Weiler and Atherton make them (section "Shadowing"): the scene is sorted once more, seen from the light;
 * the polygons visible from there are lit, and come back as detail of the faces they belong to. A visible polygon is
 * clipped by what is lit of its face: inside it has the tone of its slope to the light, outside that of shadow. The
 * light is parallel. Lit polygons are mapped from one view to the other over three corners of the face: affine in
 * space, so also right in perspective.
 *
 * Tones by the cosine between the face and the light: >= 0.8 none, >= 0.5 every second hatch line, >= 0.2 every line,
 * less and in shadow both families. */
#ifndef AREA_TONE_H
#define AREA_TONE_H

#include "hidden/area.h"
#include "hidden/hatch.h"

typedef struct area_tone {
    hatch_t *hatch;
    num_t light[3]; /* direction to the light, in the scene's coordinates */
    bool shadow;    /* cast shadows; otherwise slopes alone count */
} area_tone_t;

typedef struct area_toner area_toner_t;

/* What the toner takes when there are no shadows; with them it takes what there is. */
size_t area_toner_bytes(const solid_map_t *m);
/* Sorts the scene from the light. mem (aligned to 8) is kept, sort_mem only lent. Returns 0; ERR_FULL; ERR_VALUE for a
 * light that cannot be used. */
int area_toner_make(area_toner_t **toner, const area_tone_t *tone, const solid_map_t *m, void *mem, size_t bytes,
                    void *sort_mem, size_t sort_bytes);
/* Hatches one visible polygon; line numbers count from first_line. Returns 0 or ERR_FULL. */
int area_toner_polygon(area_toner_t *toner, int32_t face, const poly_t *p, int32_t first_line, intervals_t *to);

#endif
