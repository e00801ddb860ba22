/* light_ref.h - shadows against rays to the lights: is what lit polygons say of a place what a ray says, does the
 * border of a shadow lie where the answer changes, and is there one wherever it does?
 *
 * The rays know nothing of sorting, clipping or views: a place on a face is in shadow if the way to the light passes
 * through another face (doubles, even-odd in its plane). Places whose answer changes when they move a little are
 * nobody's fault, and a face that the eye sees edge-on has none. Scenes whose faces cut through each other are none for
 * the area sort and are left out. */
#ifndef LIGHT_REF_H
#define LIGHT_REF_H

#include "hidden/area/area_light.h"
#include "tests/oracle/solid_scenes.h"

typedef struct light_tally {
    long long scenes, behind, left_out, errors, edge_on;
    long long places, places_wrong, borders, borders_wrong, changes, changes_missed;
} light_tally_t;
void light_tally_add(light_tally_t *to, const light_tally_t *n);
/* What is wrong, as part of a line. */
void light_tally_tell(const light_tally_t *n);

/* Draws the scene with shadows and adds to n what it finds at random places (seed). light NULL: up to four that the
 * seed chooses, grazing ones and lamps among them. Returns whether all was right. */
bool light_ref_judge(const solid_scene_t *s, uint64_t seed, const light_t *light, int lights, light_tally_t *n);

/* What rays say of a grid of places on the page, `pitch_mm` apart: gives those where a face is seen, with the lights
 * that reach it, a bit each, or -1 where that is not sure. False if the scene has no picture. */
typedef void light_ref_place_t(void *ctx, double x_mm, double y_mm, int reached);
bool light_ref_picture(const solid_scene_t *s, const light_t *light, int lights, double pitch_mm,
                       light_ref_place_t *place, void *ctx);

#endif
