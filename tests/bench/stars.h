/* stars.h - the polygons of the clipping benchmark, two kinds. Ours and the peers' programs draw them from here.
 *
 * Round: a star of seven round rays, n vertices on its outline and n more on that of a hole; few crossings, so the time
 * is that of reading and sweeping vertices. Spiky: a star of n / 2 narrow rays with such a hole; each ray of one
 * crosses many of the other. The second star is turned and moved by a tenth of its size. */
#ifndef STARS_H
#define STARS_H

#include <math.h>
#include <stdint.h>

#define STARS_R 10000000.0 /* 300 mm in lat */

/* Vertex i of n on contour 0 (outer) or 1 (hole) of star 0 or 1. */
static inline void star_point(int spiky, int star, int contour, int i, int n, int32_t *x, int32_t *y) {
    double turn = 2 * 3.14159265358979323846 * (i + star * 2. / 3) / n;
    double r = STARS_R * (contour ? .3 : 1);
    r *= spiky ? (i & 1 ? .7 : 1) : .8 + .2 * cos(7 * turn + star);
    *x = (int32_t)lrint(r * cos(turn) + star * STARS_R / 10);
    *y = (int32_t)lrint(r * sin(turn) + star * STARS_R / 17);
}

/* Programs print `name round|spiky n ms area`. */
static const int STARS_N[2][4] = {{10, 100, 1000, 10000}, {10, 100, 1000, 0}};
static const char *const STARS_NAME[2] = {"round", "spiky"};

#endif
