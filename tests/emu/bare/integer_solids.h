/* integer_solids.h - solids, free segments and views made in integers alone (as integer_scene.h has surfaces). */
#ifndef INTEGER_SOLIDS_H
#define INTEGER_SOLIDS_H

#include "lang/settings.h"
#include "scene/mesh.h"

#define INTEGER_SOLIDS_OBJECTS 5
#define INTEGER_SOLIDS_VERTICES (12 * INTEGER_SOLIDS_OBJECTS)
#define INTEGER_SOLIDS_WORDS (48 * INTEGER_SOLIDS_OBJECTS)

typedef struct integer_solids {
    mesh_t mesh;
    settings_t set; /* its view */
    packed_t vertex[INTEGER_SOLIDS_VERTICES][3];
    int32_t word[INTEGER_SOLIDS_WORDS];
} integer_solids_t;

/* Scene number `seed`: up to so many boxes (on a lattice, or slanting), tetrahedra, L-shaped prisms, open ones, sheets
 * and segments, but for those whose bits are set in drop; seen from anywhere, from along the axes and from planes of
 * faces. s must not move. */
void integer_solids_random(integer_solids_t *s, uint64_t seed, uint32_t drop);

#endif
