/* The functions, the list, and how an entry becomes a scene. */
#include "tests/oracle/hard_list.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

typedef double height_fn(double x, double y);

/* Noise that depends on the place only, so that every grid has its own and every run the same. */
static double noise(double x, double y) {
    double v = sin(x * 12.9898 + y * 78.233) * 43758.5453;
    return v - floor(v);
}
static double smooth(double x, double y) {
    return exp(-x * x - y * y);
}
static double sinc(double x, double y) {
    double r = 5 * hypot(x, y);
    return r > 0 ? sin(r) / r : 1;
}
static double cliffs(double x, double y) {
    return 1e6 * floor(1.5 * sin(2 * x) + 1.5 * cos(2 * y));
}
static double spikes(double x, double y) {
    return noise(x, y) > .85 ? 3 * noise(y, x) : 0;
}
static double plateau(double x, double y) {
    return fabs(x) < 1.1 && fabs(y) < 1.3 ? 1 : 0;
}
static double millionths(double x, double y) {
    return 1e-6 * noise(x, y);
}
static double billionths(double x, double y) {
    return 1 + 1e-9 * noise(x, y);
}
static double twisted(double x, double y) {
    return ((int)lround((x + 2) * 2.25) + (int)lround((y + 2) * 2.25)) & 1;
}
static double plane(double x, double y) {
    return .25 * x - .5 * y;
}
static double along_x(double x, double y) {
    return (void)y, .5 * x;
}
static double roof(double x, double y) {
    return (void)y, .5 * fabs(x);
}
static double nearly(double x, double y) {
    return .5 * x + 1e-6 * noise(x, y);
}
static double along_y(double x, double y) {
    return (void)x, sin(3 * y);
}
static double whole(double x, double y) {
    return floor(3 * noise(x, y));
}
static double constant(double x, double y) {
    return (void)x, (void)y, 7;
}
static double huge_range(double x, double y) {
    return 1e12 * sin(2 * x) * cos(y);
}
static double tiny_range(double x, double y) {
    return 1e-12 * sin(2 * x) * cos(y);
}
static double wave(double x, double y) {
    return .3 * sin(3 * x) * cos(3 * y);
}
static double ridges(double x, double y) {
    return .5 * fabs(sin(4 * x)) + .05 * y;
}
static double pole(double x, double y) {
    return 1 / (x * x + y * y);
}
static double tangent(double x, double y) {
    return tan(x) + .1 * y;
}
static double logarithm(double x, double y) {
    return log(x + .3 * y);
}
static double step_int(double x, double y) {
    return trunc(x) * trunc(1.5 * y);
}
static double sign(double x, double y) {
    return (x * y > 0) - (x * y < 0);
}
static double annulus(double x, double y) {
    return hypot(x, y) < .8 || hypot(x, y) > 1.9 ? NAN : wave(x, y) + noise(x, y);
}
static double half_plane(double x, double y) {
    return x + y < .1 ? NAN : smooth(x, y);
}
static double checkerboard(double x, double y) {
    return ((int)floor(x * 1.5 + 9) + (int)floor(y * 1.5 + 9)) & 1 ? NAN : .6 * noise(x, y);
}
static double sieve(double x, double y) {
    return noise(y, x) < .2 ? NAN : noise(x, y);
}
static double nothing(double x, double y) {
    return (void)x, (void)y, NAN;
}
static double saw(double x, double y) {
    return .25 * (int)lround((x + 2) * 4) + .25 * (int)lround((y + 2) * 4);
}
static double valley(double x, double y) {
    return x * x + .2 * y * y;
}

static double growth(double x, double y) {
    return exp(3 * x * y);
}
static double near_pole(double x, double y) {
    return 1 / (x * y + 1e-5);
}
static double ninth(double x, double y) {
    return (void)y, 1e3 * pow(x, 9);
}
static double pits(double x, double y) {
    return 1e4 * floor(1.5 * sin(2 * x) + 1.5 * cos(2 * y));
}

typedef struct hard_case {
    const char *name;
    height_fn *f;
    int nx, ny;
    exact_eye_t eye;
    double ratio; /* of the largest to the smallest cell; 0: uniform */
    double scale; /* of x and y, and of the eye's; 0: 1 */
} hard_case_t;

#define FROM_P                                                                                                         \
    { 6, 8, 3, 1 }
static const hard_case_t list[] = {
    /* Where the viewer stands. */
    {"smooth from (6,8,3)", smooth, 40, 40, FROM_P, 0, 0},
    {"random from (6,8,3)", noise, 40, 40, FROM_P, 0, 0},
    {"random from -(6,8), level", noise, 30, 30, {-6, -8, .5, 1}, 0, 0},
    {"in a grid plane x", noise, 17, 17, {.5, 7, 2, 1}, 0, 0},
    {"in a grid plane y, level", noise, 17, 17, {-9, -1, .5, 1}, 0, 0},
    {"in the border plane", noise, 17, 17, {2, 7, 2, 1}, 0, 0},
    {"in the plane of the middle, sinc", sinc, 21, 21, {0, 6, .4, 1}, 0, 0},
    {"on the line of a grid edge", along_y, 17, 17, {.5, 8, 0, 1}, 0, 0},
    {"over a vertex", noise, 17, 17, {.5, -.25, 2.5, 1}, 0, 0},
    {"over a border vertex", noise, 17, 17, {2, -.25, 2.5, 1}, 0, 0},
    {"over a corner", noise, 17, 17, {-2, -2, 1.5, 1}, 0, 0},
    {"over an edge", noise, 17, 17, {.5, .1, 1.5, 1}, 0, 0},
    {"over a border edge", noise, 17, 17, {.1, 2, 1.5, 1}, 0, 0},
    {"over the middle, high", noise, 20, 20, {0, 0, 40, 1}, 0, 0},
    {"over the middle, at 1.2", noise, 20, 20, {0, 0, 1.2, 1}, 0, 0},
    {"over the middle vertex, at 1.05", noise, 21, 21, {0, 0, 1.05, 1}, 0, 0},
    {"in the pit", valley, 20, 20, {.1, .2, .5, 1}, 0, 0},
    {"in the pit, over a vertex", valley, 17, 17, {.25, .5, .5, 1}, 0, 0},
    {"below", noise, 20, 20, {6, 5, -4, 1}, 0, 0},
    {"below, inside", noise, 20, 20, {.3, .2, -1, 1}, 0, 0},
    {"below, under a vertex", noise, 17, 17, {.5, .5, -.5, 1}, 0, 0},
    {"below, in a grid plane", noise, 17, 17, {.5, 7, -3, 1}, 0, 0},
    {"level with the plateau", plateau, 20, 20, {5, 7, 1, 1}, 0, 0},
    {"level with the plateau, in a grid plane", plateau, 17, 17, {.5, 7, 1, 1}, 0, 0},
    {"level with the ground of the plateau", plateau, 20, 20, {5, 7, 0, 1}, 0, 0},
    {"grazing random", noise, 40, 40, {4, 5, .98, 1}, 0, 0},
    {"grazing random, parallel", noise, 40, 40, {.3, 1, .01, 0}, 0, 0},
    {"grazing smooth", smooth, 40, 40, {6, 8, .02, 1}, 0, 0},
    {"1e4 away", noise, 30, 30, {6000, 8000, 3000, 1}, 0, 0},
    {"1e6 away", noise, 30, 30, {6e5, 8e5, 3e5, 1}, 0, 0},
    {"1e6 away, in a grid plane", noise, 17, 17, {.5, 1e6, 3e5, 1}, 0, 0},
    {"very near the border", noise, 20, 20, {2.001, .3, .6, 1}, 0, 0},
    {"1e-3 over the surface", smooth, 21, 21, {.4, .4, .728, 1}, 0, 0},
    {"1e-3 over the top vertex", smooth, 21, 21, {0, 0, 1.001, 1}, 0, 0},
    {"1e-3 beside the border, level", smooth, 20, 20, {2.001, 0, 0, 1}, 0, 0},
    /* Parallel views. */
    {"parallel along x", noise, 20, 20, {1, 0, .3, 0}, 0, 0},
    {"parallel along -y, level", noise, 20, 20, {0, -1, 0, 0}, 0, 0},
    {"parallel diagonal", noise, 20, 20, {1, 1, 1, 0}, 0, 0},
    {"parallel -diagonal, from below", noise, 20, 20, {-1, 1, -.5, 0}, 0, 0},
    {"parallel straight down", noise, 20, 20, {0, 0, 1, 0}, 0, 0},
    {"parallel almost straight down", noise, 20, 20, {1e-5, 1e-6, 1, 0}, 0, 0},
    {"isometric with whole heights", whole, 16, 16, {1, 1, 1, 0}, 0, 0},
    {"sinc, parallel", sinc, 40, 40, {.5, -.866, .577, 0}, 0, 0},
    /* What coincides. */
    {"facets exactly edge-on", plane, 17, 17, {8, -2, 3, 1}, 0, 0},
    {"facets exactly edge-on, parallel", plane, 17, 17, {2, 1, 0, 0}, 0, 0},
    {"facets exactly edge-on before others", roof, 17, 17, {8, -2, 4, 1}, 0, 0},
    {"exactly coincident edges", along_x, 17, 17, {0, -1, 0, 0}, 0, 0},
    {"twisted quads", twisted, 10, 10, FROM_P, 0, 0},
    {"twisted quads, diagonal", twisted, 10, 10, {1, 1, .3, 0}, 0, 0},
    {"crossings at vertices", saw, 17, 17, {1, 1, -1, 0}, 0, 0},
    {"near-parallel edges", along_x, 17, 17, {.001, -1, .0001, 0}, 0, 0},
    {"near-parallel edges, rough by 1e-6", nearly, 17, 17, {.001, -1, .0001, 0}, 0, 0},
    {"slivers below a step", noise, 30, 30, FROM_P, 1e6, 0},
    {"slivers below a step, parallel", wave, 30, 30, {1, -.02, .3, 0}, 1e6, 0},
    {"constant", constant, 20, 20, {6, 8, 9, 1}, 0, 0},
    {"constant, level", constant, 20, 20, {6, 8, 7, 1}, 0, 0},
    /* Sizes. */
    {"2x2", noise, 2, 2, FROM_P, 0, 0},
    {"2x2 twisted", twisted, 2, 2, {0, 3, .5, 1}, 0, 0},
    {"2x2 from over its middle", noise, 2, 2, {0, 0, 3, 1}, 0, 0},
    {"2x60", noise, 2, 60, FROM_P, 0, 0},
    {"2x2000", noise, 2, 2000, {6, -1, 3, 1}, 0, 0},
    {"60x2 in its plane", noise, 60, 2, {9, 2, .7, 1}, 0, 0},
    {"cells from 1e-4 to 1", noise, 30, 30, FROM_P, 1e4, 0},
    {"cells from 1e-4 to 1, level", smooth, 30, 30, {3, 2.5, .3, 1}, 1e4, 0},
    {"cells from 1e-4 to 1, parallel", wave, 30, 30, {.2, -1, .4, 0}, 1e4, 0},
    {"a world of 1e6", wave, 20, 20, {6, 8, 3, 1}, 0, 1e6},
    {"a world of 1e-6", wave, 20, 20, {6, 8, 3, 1}, 0, 1e-6},
    /* Heights. */
    {"cliffs of 1e6", cliffs, 20, 20, {6, 8, 3e6, 1}, 0, 0},
    {"cliffs of 1e6, level", cliffs, 20, 20, {6, 8, .5, 1}, 0, 0},
    {"spikes", spikes, 30, 30, FROM_P, 0, 0},
    {"spikes, level", spikes, 30, 30, {7, -5, 1, 1}, 0, 0},
    {"differences of 1e-6", millionths, 20, 20, FROM_P, 0, 0},
    {"differences of 1e-6, level", millionths, 20, 20, {6, 8, 5e-7, 1}, 0, 0},
    {"differences of 1e-9, level", billionths, 20, 20, {6, 8, 1, 1}, 0, 0},
    {"huge range", huge_range, 20, 20, {6, 8, 3e12, 1}, 0, 0},
    {"tiny range", tiny_range, 20, 20, {6, 8, 3, 1}, 0, 0},
    {"ridges end-on", ridges, 33, 17, {0, 9, .4, 1}, 0, 0},
    {"heights of 1e5 from the foot", growth, 25, 25, {2.1, 2.1, .5, 1}, 0, 0},
    {"heights of 1e5 from inside, below", growth, 25, 25, {.1, .2, -3, 1}, 0, 0},
    {"heights of 1e5 from inside, over a vertex", growth, 25, 25, {1, 1, 30, 1}, 0, 0},
    {"heights of 5e5 from the foot", ninth, 25, 25, {2.1, 2.1, .5, 1}, 0, 0},
    {"heights of 1e5 both ways, level", near_pole, 25, 25, {3, 3, 1, 1}, 0, 0},
    {"cliffs of 1e4 from inside", pits, 25, 25, {.3, .2, 1, 1}, 0, 0},
    /* Singular, discontinuous and undefined. */
    {"1/(x*x+y*y)", pole, 20, 20, {6, 8, 30, 1}, 0, 0},
    {"1/(x*x+y*y) with its pole", pole, 21, 21, {6, 8, 30, 1}, 0, 0},
    {"tan", tangent, 25, 25, {6, 8, 30, 1}, 0, 0},
    {"log", logarithm, 25, 25, {6, -8, 3, 1}, 0, 0},
    {"int", step_int, 25, 25, FROM_P, 0, 0},
    {"sgn", sign, 25, 25, FROM_P, 0, 0},
    {"annulus", annulus, 30, 30, FROM_P, 0, 0},
    {"annulus, from its middle", annulus, 21, 21, {0, 0, 1.2, 1}, 0, 0},
    {"annulus, level", annulus, 30, 30, {6, 3, .2, 1}, 0, 0},
    {"half-plane", half_plane, 25, 25, {6, 8, .5, 1}, 0, 0},
    {"checkerboard", checkerboard, 25, 25, {6, 8, 1, 1}, 0, 0},
    {"checkerboard, parallel", checkerboard, 25, 25, {1, -1, .2, 0}, 0, 0},
    {"every fifth point undefined", sieve, 25, 25, FROM_P, 0, 0},
    {"every fifth point undefined, in a grid plane", sieve, 17, 17, {.5, -6, 1, 1}, 0, 0},
    {"all undefined", nothing, 10, 10, FROM_P, 0, 0},
};

int hard_list_count(void) {
    return (int)(sizeof list / sizeof *list);
}

const char *hard_list_name(int i) {
    return list[i].name;
}

void hard_list_build(int number, scene_t *s) {
    const hard_case_t *h = &list[number];
    uint64_t rng = 1;
    double k = h->scale > 0 ? h->scale : 1;
    scene_init(s, h->nx, h->ny);
    if (h->ratio > 0) scene_stretch(s, h->ratio, &rng);
    bool any = false;
    surface_ref_t *r = &s->ref;
    r->hole = calloc((size_t)(r->nx * r->ny), 1);
    if (!r->hole) abort();
    for (int j = 0; j < r->ny; j++)
        for (int i = 0; i < r->nx; i++) {
            double z = k * h->f(r->x[i], r->y[j]);
            any |= !isfinite(z);
            r->hole[j * r->nx + i] = (unsigned char)(isfinite(z) ? 0 : 1);
            r->z[j * r->nx + i] = isfinite(z) ? z : 0;
        }
    if (!any) {
        free(r->hole);
        r->hole = NULL;
    }
    for (int i = 0; i < r->nx; i++) r->x[i] *= k;
    for (int j = 0; j < r->ny; j++) r->y[j] *= k;
    r->eye = (exact_eye_t){k * h->eye.x, k * h->eye.y, k * h->eye.z, h->eye.h};
    scene_aim(s);
    snprintf(s->what, sizeof s->what, "%s (%dx%d, eye %g,%g,%g%s)", h->name, h->nx, h->ny, r->eye.x, r->eye.y, r->eye.z,
             h->eye.h ? "" : " parallel");
}
