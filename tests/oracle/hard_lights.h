/* hard_lights.h - the hard list of lights: at grazing incidence, along edges and faces, from the eye, lamps close by.
 */
#ifndef HARD_LIGHTS_H
#define HARD_LIGHTS_H

#include "hidden/area/area_light.h"
#include "tests/oracle/solid_scenes.h"

int hard_lights_count(void);
const char *hard_lights_name(int i);
/* Makes s, with its view, and puts the lights into light[LIGHTS_MAX]; returns how many. */
int hard_lights_build(int i, solid_scene_t *s, light_t *light);

#endif
