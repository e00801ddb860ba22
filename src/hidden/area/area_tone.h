/* area_tone.h - tones of visible polygons: how many lights reach them, and how steeply.
 *
 * With shadows a visible polygon is clipped by what each light in turn reaches of its face (area_light.h), so it falls
 * into parts with one answer from every light; without, slopes alone count. The brightness of a part is the sum of the
 * cosines of the lights that reach it, as a share of what a face gets that is turned squarely to all of them; hatch.h
 * makes tones of it. What no light reaches has the darkest.
 *
 * Where the memory is too small for a polygon and what the light reaches of it at once, it is done window by window
 * (area_limit.h), like the sort: hatch lines and borders are joined again where windows cut them.
 *
 * Borders of shadows, if they are wanted, are the edges that the clipper finds between a part that a light reaches and
 * one that it does not (area_border.h), each once. */
#ifndef AREA_TONE_H
#define AREA_TONE_H

#include "config.h"
#include "hidden/area/area.h"
#include "hidden/area/area_border.h"
#include "hidden/area/area_light.h"
#include "hidden/hatch.h"

typedef struct area_tone {
    hatch_t *hatch; /* NULL: borders only */
    light_t light[LIGHTS_MAX];
    int32_t lights;
    bool shadow;        /* cast shadows; otherwise slopes alone count */
    borders_t *borders; /* NULL: not wanted */
} area_tone_t;

typedef struct area_toner area_toner_t;

/* What the toner takes when there are no shadows; with them it takes what there is. */
size_t area_toner_bytes(const solid_map_t *m);
/* With shadows: what it takes before anything is toned, about. */
size_t area_toner_fixed(const solid_map_t *m, const area_tone_t *tone);
/* Sorts the scene from the lights. mem (aligned to 8) is kept, sort_mem only lent. Returns 0; ERR_FULL; ERR_VALUE or
 * ERR_LIGHT for a light that cannot be used (area_light.h). */
int area_toner_make(area_toner_t **toner, const area_tone_t *tone, const solid_map_t *m, void *mem, size_t bytes,
                    void *sort_mem, size_t sort_bytes);
/* Pairs of faces that cut through each other, as the lights see them (area_stats_t). */
int64_t area_toner_intersections(const area_toner_t *toner);
/* Of its memory, what was in use at most. */
size_t area_toner_used(const area_toner_t *toner);
/* Hatches one visible polygon; line numbers count from first_line. Adds borders. Returns 0 or ERR_FULL. */
int area_toner_polygon(area_toner_t *toner, int32_t face, const poly_t *p, int32_t first_line, intervals_t *to);

#endif
