/* integer_scene.h - surfaces and viewpoints made in integers alone, so that every machine makes the same ones. */
#ifndef INTEGER_SCENE_H
#define INTEGER_SCENE_H

#include "hidden/hidden.h"
#include "scene/grid.h"
#include "view/camera.h"

#ifndef INTEGER_SCENE_SIDE
#define INTEGER_SCENE_SIDE 9 /* most points a side */
#endif
#ifndef INTEGER_SCENE_BYTES
#define INTEGER_SCENE_BYTES 9216 /* lent to the kernels */
#endif

enum integer_family { FAMILY_SMOOTH, FAMILY_RANDOM, FAMILY_CLIFFS, FAMILY_GRAZING, FAMILY_FAR, FAMILY_ANY };
enum integer_kernel { KERNEL_PERIMETER, KERNEL_WINDOWS, KERNEL_HORIZON };

typedef struct integer_scene {
    int nx, ny;
    camera_t cam;
    num_t x[INTEGER_SCENE_SIDE], y[INTEGER_SCENE_SIDE], z[INTEGER_SCENE_SIDE * INTEGER_SCENE_SIDE];
    int32_t cache[INTEGER_SCENE_SIDE * INTEGER_SCENE_SIDE];
    surface_t surface;
    grid_t grid;
    uint64_t mem[INTEGER_SCENE_BYTES / 8];
} integer_scene_t;

uint64_t integer_next(uint64_t *rng);
uint32_t integer_below(uint64_t *rng, uint32_t n);

/* The scenes of the report (tests/report/subject.h) with n points a side: smooth, random, cliffs, grazing, far. With
 * holes, every twelfth point is undefined. */
void integer_scene_family(integer_scene_t *s, enum integer_family family, int n, bool holes);
/* Scene number `seed`: up to INTEGER_SCENE_SIDE points a side, all kinds of heights and places of the eye. */
void integer_scene_random(integer_scene_t *s, uint64_t seed);
/* Draws it. The horizon takes the rows as profiles. Measuring the grid is not part of it, but for the scene's first
 * time. */
int integer_scene_measure(integer_scene_t *s);
int integer_scene_draw(integer_scene_t *s, enum integer_kernel kernel, const ink_sink_t *sink, hidden_stats_t *stats);

#endif
