/* solid_laws.h - changes of a scene of solids after which the ink of its edges must be what it was (metamorph.h for
 * solids), and scenes made small. */
#ifndef SOLID_LAWS_H
#define SOLID_LAWS_H

#include "tests/oracle/solid_scenes.h"

enum solid_law {
    SOLID_LAW_QUARTER,     /* a quarter turn about the z axis */
    SOLID_LAW_MIRROR,      /* x becomes -x */
    SOLID_LAW_TRANSLATE,   /* by numbers that are not of any lattice */
    SOLID_LAW_SCALE,       /* 1024 times as large */
    SOLID_LAW_UPSIDE_DOWN, /* z becomes -z */
    SOLID_LAW_REFINE,      /* every face of more than three corners cut into triangles */
    SOLID_LAW_ORDER,       /* vertices, faces and lines in another order, faces turned round */
    SOLID_LAW_BEHIND,      /* a triangle beyond everything */
    SOLID_LAW_FRONT,       /* a triangle somewhere, in half of the scenes before everything: it can only hide */
    SOLID_LAWS
};

const char *solid_law_name(enum solid_law law);
/* Makes t, to be freed, from s; *back, to be freed, says of each of its vertices which of s it is, -1 for what was
 * added. */
void solid_law_apply(enum solid_law law, uint64_t seed, const solid_scene_t *s, solid_scene_t *t, int **back);

/* Makes s smaller as long as fails(ctx, s) stays true: faces and lines are left out, then coordinates rounded. */
void solid_scene_shrink(solid_scene_t *s, bool (*fails)(void *ctx, const solid_scene_t *s), void *ctx);
/* Writes the scene as the program reads it: the view's command and an OBJ file. */
void solid_scene_print(const solid_scene_t *s);

#endif
