/* bridges.h - the corners of a face with holes as one chain that does not cross itself.
 *
 * A face is one chain of corners, in which each hole is joined to the outline by a cut that is gone along both ways
 * (the OBJ reader makes it so, from the first corner of the one to the first of the other). What is inside of it by
 * even and odd does not care where the cuts run, but what is cut into triangles does: they must not cross anything. */
#ifndef BRIDGES_H
#define BRIDGES_H

#include "scene/solid_math.h"

/* The plane of the two axes that a face's normal leans on least. */
typedef struct flat {
    const solid_t *s;
    int u, v;      /* in the order that makes the polygon run counter-clockwise */
    int32_t slack; /* what is so near to a line, in units along each axis, is on it */
} flat_t;

/* Twice what rounding moves a corner off an edge that it touches. */
#define FLAT_SLACK 2

flat_t flat_of(const solid_t *s, const solid_normal_t *normal);
/* Does the way from a over b to c turn left, 1, or right, -1? Exact but for the slack. ctx: a flat_t. */
int flat_turn(void *ctx, int32_t a, int32_t b, int32_t c);
/* The product of the ways from b to a and to c: < 0 if b is between them, > 0 if the way from a over b to c turns back,
 * where all are on a line. */
int64_t flat_dot(const flat_t *f, int32_t a, int32_t b, int32_t c);

/* Writes the face's corners to c, as many as it has, with cuts to holes that cross nothing. Holes run the other way
 * round than the outline, and may touch it and each other. Returns how many are of one chain with the outline: behind
 * it are holes that no corner of it sees, since they are islands in others. Cost: linear without holes; for each hole
 * the corners times how many pairs were tried, seldom more than a few. */
int32_t bridges_lay(flat_t *f, int32_t face, int32_t *c);
/* Turns the island that begins at `from` into a polygon of its own, c[from + 1] to c[end - 2]; returns end. */
int32_t bridges_island(int32_t *c, int32_t from, int32_t n);

#endif
