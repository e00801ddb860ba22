/* solid_composed.c - bodies as people put them together; see solid_scenes.h. */
#include <math.h>

#include "tests/oracle/solid_build.h"

#define uniform solid_build_uniform
#define pick solid_build_pick

/* Rooms: boxes within boxes, some without a wall, the innermost full. */
static void rooms(solid_ref_t *r, int n) {
    double lo = 0, hi = 4;
    for (int k = 0; k < n; k++) {
        int v[8];
        const int missing = pick(9);
        for (int c = 0; c < 8; c++) v[c] = solid_build_put(r, c & 1 ? hi : lo, c & 2 ? hi : lo, c & 4 ? hi : lo);
        static const int side[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                       {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
        for (int f = 0; f < 6; f++) {
            const int *s = side[f];
            if (f != missing) solid_ref_face(r, (int[]){v[s[0]], v[s[1]], v[s[2]], v[s[3]]}, 4);
        }
        const double wall = pick(2) ? .25 : uniform(.01, .4);
        lo += pick(3) ? wall : 0, hi -= wall; /* or in the corner of the room around it */
        if (hi - lo < .2) return;
    }
}

/* Cubes of a lattice, every one a body of its own, which share faces, edges and corners. */
static void cubes(solid_ref_t *r, int n) {
    const double size[3] = {1, pick(2) ? 1 : uniform(.2, 2), pick(2) ? 1 : uniform(.2, 2)};
    for (int k = 0; k < 3 * n; k++)
        solid_build_box(r, pick(3) * size[0], pick(3) * size[1], pick(3) * size[2], size[0], size[1], size[2]);
}

/* Stars and cogwheels: concave, with many sides in few planes. */
static void stars(solid_ref_t *r, int n) {
    for (int k = 0; k < n; k++) {
        double xy[24][2];
        const int m = 2 * (3 + pick(8));
        const double in = uniform(.3, .95), z = pick(2) ? k : uniform(-1, 1), x = pick(3) ? 0 : 1.5 * k;
        for (int i = 0; i < m; i++) {
            const double far = i & 1 ? in : 1, a = SOLID_FULL_TURN * i / m;
            xy[i][0] = x + far * cos(a), xy[i][1] = far * sin(a);
        }
        solid_build_prism(r, xy, m, z, z + (pick(2) ? 1 : uniform(.05, 1)));
    }
}

/* A flight of stairs over an L with many corners, and boxes on its steps. */
static void stairs(solid_ref_t *r, int n) {
    double xy[64][2];
    const int steps = 2 + pick(8);
    int m = 0;
    xy[m][0] = 0, xy[m++][1] = 0;
    xy[m][0] = steps, xy[m++][1] = 0;
    for (int k = steps; k > 0; k--) {
        xy[m][0] = k, xy[m++][1] = steps + 1 - k;
        xy[m][0] = k - 1, xy[m++][1] = steps + 1 - k;
    }
    solid_build_prism(r, xy, m, 0, 1 + pick(3));
    for (int k = 0; k < n; k++) {
        const int at = pick(steps);
        solid_build_box(r, at, steps - at, pick(2) * .5, pick(2) ? 1 : .5, pick(2) ? 1 : uniform(.1, 2), .5);
    }
}

/* Cones of so many sides that each is a sliver, tips that meet, and needles. */
static void slivers(solid_ref_t *r, int n) {
    for (int k = 0; k < n; k++) {
        int ring[40];
        const int m = 8 + pick(28), tip = solid_build_put(r, 0, 0, 0);
        const double far = pick(3) ? 1 : 1e-3, z = (k & 1 ? 1 : -1) * uniform(.2, 3), x = pick(3) ? 0 : uniform(-1, 1);
        for (int i = 0; i < m; i++) {
            const double a = SOLID_FULL_TURN * (z > 0 ? i : -i) / m;
            ring[i] = solid_build_put(r, x + far * cos(a), far * sin(a), z);
        }
        solid_ref_face(r, ring, m);
        for (int i = 0; i < m; i++) solid_ref_face(r, (int[]){ring[(i + 1) % m], ring[i], tip}, 3);
    }
}

/* A body twice, and again by a hair beside itself: nearer than convex.h says bodies are told apart both may be drawn.
 */
static void doubles(solid_ref_t *r, int n) {
    const double by = pick(2) ? 0 : pow(10, uniform(-4, -1));
    const double size[3] = {uniform(.5, 2), uniform(.5, 2), uniform(.5, 2)};
    for (int k = 0; k < n; k++) {
        const double x = k * by * pick(2), y = k * by * pick(2), z = k * by * pick(2);
        solid_build_box(r, x, y, z, size[0], size[1], size[2]);
    }
}

/* Regular bodies, of which every second one stands on the face of another or touches it with a corner. */
static void regular(solid_ref_t *r, int n) {
    static const double g = 1.618033988749895;
    static const int face[20][3] = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    const double at[12][3] = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                              {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    for (int k = 0; k < n; k++) {
        const double x = 2 * g * k;
        if (k % 3 == 2) { /* an octahedron, tip to edge */
            int v[6];
            for (int i = 0; i < 6; i++) {
                const double d = i & 1 ? -1 : 1;
                v[i] = solid_build_put(r, x + (i / 2 == 0 ? g * d : 0), i / 2 == 1 ? d : 0, i / 2 == 2 ? d : 0);
            }
            for (int i = 0; i < 8; i++) {
                const int a = v[i & 1], b = v[2 + (i >> 1 & 1)], c = v[4 + (i >> 2)];
                const bool odd = (i & 1) ^ (i >> 1 & 1) ^ (i >> 2);
                solid_ref_face(r, odd ? (int[]){a, c, b} : (int[]){a, b, c}, 3);
            }
            continue;
        }
        int v[12];
        for (int i = 0; i < 12; i++) v[i] = solid_build_put(r, x + at[i][0], at[i][1], at[i][2]);
        for (int i = 0; i < 20; i++) solid_ref_face(r, (int[]){v[face[i][0]], v[face[i][1]], v[face[i][2]]}, 3);
    }
}

/* A row of boxes, each a third to a thousandth of the one before, in corners and on faces of it. */
static void sizes(solid_ref_t *r, int n) {
    double x = 0, a = 1;
    for (int k = 0; k < n; k++) {
        solid_build_box(r, x, pick(2) ? 0 : a / 3, pick(2) ? 0 : a / 4, a, a, a);
        x += a;
        a *= pow(10, -uniform(.5, 3. / n));
    }
}

/* Boards crosswise in layers, long and thin, flush with each other at their ends. */
static void boards(solid_ref_t *r, int n) {
    const double thin = pow(10, uniform(-3, -.7)), wide = pick(2) ? thin : .1;
    for (int k = 0; k < 3 * n; k++) {
        const int layer = k / 3, beside = k % 3;
        if (layer & 1)
            solid_build_box(r, 0, beside * (1 - wide) / 2, layer * thin, 1, wide, thin);
        else
            solid_build_box(r, beside * (1 - wide) / 2, 0, layer * thin, wide, 1, thin);
    }
}

void solid_scene_composed(solid_scene_t *s, uint64_t seed, int objects) {
    static void (*const kind[])(solid_ref_t * r, int n) = {rooms,   cubes,   stars, stairs, slivers,
                                                           doubles, regular, sizes, boards};
    static const char *const name[] = {"rooms",   "cubes",   "stars", "stairs", "slivers",
                                       "doubles", "regular", "sizes", "boards"};
    solid_build_begin(s, seed);
    const int which = (int)(seed % (sizeof kind / sizeof *kind));
    kind[which](&s->ref, 2 + pick(objects));
    solid_build_end(s, name[which], (enum solid_eye_place)pick(PLACES));
}
