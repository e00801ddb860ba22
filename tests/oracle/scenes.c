/* The generator behind the property tests, and its way back: shrinking a scene that fails. */
#include "tests/oracle/scenes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const shape_name[SHAPES] = {"smooth", "random", "cliffs", "plateau", "walk",  "ridges",
                                               "sinc",   "spikes", "tiny",   "plain",   "saddle"};
static const char *const eye_name[EYES] = {"outside", "far",   "near",      "grid-plane", "inside",   "vertex", "edge",
                                           "level",   "below", "direction", "axis",       "diagonal", "steep"};

/* splitmix64 (Steele, Lea, Flood 2014): every seed starts a good sequence. */
static uint64_t next(uint64_t *rng) {
    uint64_t z = *rng += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

double scene_uniform(uint64_t *rng) {
    return (double)(next(rng) >> 11) * 0x1p-53;
}
int scene_below(uint64_t *rng, int n) {
    return (int)(next(rng) % (uint64_t)n);
}

void scene_turn(uint64_t *rng, bool turned, double m[3][3]) {
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) m[i][k] = i == k;
    for (int axis = 0; axis < 3 && turned; axis++) {
        const double a = 6.283185307179586 * scene_uniform(rng), c = cos(a), s = sin(a);
        for (int k = 0; k < 3; k++) {
            double *x = &m[axis][k], *y = &m[(axis + 1) % 3][k];
            const double u = *x, v = *y;
            *x = c * u - s * v, *y = s * u + c * v;
        }
    }
}

void scene_init(scene_t *s, int nx, int ny) {
    *s = (scene_t){.ref = {.nx = nx, .ny = ny, .eye = {6, 8, 3, 1}}};
    s->ref.x = calloc((size_t)nx, sizeof(double));
    s->ref.y = calloc((size_t)ny, sizeof(double));
    s->ref.z = calloc((size_t)nx * (size_t)ny, sizeof(double));
    if (!s->ref.x || !s->ref.y || !s->ref.z) abort();
    for (int i = 0; i < nx; i++) s->ref.x[i] = -2 + 4.0 * i / (nx - 1);
    for (int j = 0; j < ny; j++) s->ref.y[j] = -2 + 4.0 * j / (ny - 1);
}

void scene_free(scene_t *s) {
    free(s->ref.x);
    free(s->ref.y);
    free(s->ref.z);
    free(s->ref.hole);
    *s = (scene_t){0};
}

static double height(const scene_t *s, enum scene_shape shape, int i, int j, uint64_t *rng, double west, double south) {
    double x = s->ref.x[i], y = s->ref.y[j], r = hypot(4 * x, 4 * y);
    switch (shape) {
    case SHAPE_SMOOTH:
        return exp(-x * x - y * y);
    case SHAPE_RANDOM:
        return scene_uniform(rng);
    case SHAPE_CLIFFS:
        return floor(1.3 * sin(2 * x) + 1.7 * cos(1.5 * y + x)) + .01 * scene_uniform(rng);
    case SHAPE_PLATEAU:
        return fabs(x) < 1.2 && fabs(y) < 1.4 ? 1 : 0;
    case SHAPE_WALK:
        return .5 * (west + south) + scene_uniform(rng) - .5;
    case SHAPE_RIDGES:
        return .4 * sin(5 * x) + .1 * y;
    case SHAPE_SINC:
        return r > 0 ? sin(r) / r : 1;
    case SHAPE_SPIKES:
        return scene_below(rng, 7) ? 0 : 2 * scene_uniform(rng);
    case SHAPE_TINY:
        return 1 + 1e-6 * scene_uniform(rng);
    case SHAPE_PLAIN:
        return .25 * x - .5 * y;
    case SHAPE_SADDLE:
        return (i + j) & 1 ? .5 : 0;
    case SHAPES:
        break;
    }
    return 0;
}

void scene_shape(scene_t *s, enum scene_shape shape, uint64_t *rng) {
    int nx = s->ref.nx;
    for (int j = 0; j < s->ref.ny; j++)
        for (int i = 0; i < nx; i++) {
            double west = i ? s->ref.z[j * nx + i - 1] : 0, south = j ? s->ref.z[(j - 1) * nx + i] : 0;
            s->ref.z[j * nx + i] = height(s, shape, i, j, rng, west, south);
        }
}

void scene_stretch(scene_t *s, double ratio, uint64_t *rng) {
    for (int axis = 0; axis < 2; axis++) {
        int n = axis ? s->ref.ny : s->ref.nx;
        double *c = axis ? s->ref.y : s->ref.x, at = 0;
        for (int i = 0; i < n; i++) {
            c[i] = at;
            at += pow(ratio, scene_uniform(rng));
        }
        double scale = 4 / c[n - 1];
        for (int i = 0; i < n; i++) c[i] = -2 + scale * c[i];
    }
}

static void bounds(const scene_t *s, double *lo, double *hi) {
    *lo = INFINITY;
    *hi = -INFINITY;
    for (int i = 0; i < s->ref.nx * s->ref.ny; i++) {
        *lo = fmin(*lo, s->ref.z[i]);
        *hi = fmax(*hi, s->ref.z[i]);
    }
}

static double in(uint64_t *rng, double lo, double hi) {
    return lo + (hi - lo) * scene_uniform(rng);
}

void scene_eye(scene_t *s, enum scene_eye eye, uint64_t *rng) {
    surface_ref_t *r = &s->ref;
    double lo, hi, turn = in(rng, 0, 6.283185307179586), far = in(rng, 3, 12);
    bounds(s, &lo, &hi);
    double tall = fmax(hi - lo, .1);
    int i = scene_below(rng, r->nx), j = scene_below(rng, r->ny);
    exact_eye_t e = {far * cos(turn), far * sin(turn), in(rng, lo - tall, hi + 3 * tall), 1};
    switch (eye) {
    case EYE_OUTSIDE:
        break;
    case EYE_FAR:
        e.x *= 1000, e.y *= 1000, e.z *= 1000;
        break;
    case EYE_NEAR:
        e.x = 2.05 * (scene_below(rng, 2) ? 1 : -1), e.y = in(rng, -2, 2);
        break;
    case EYE_GRID_PLANE:
        if (scene_below(rng, 2))
            e.x = r->x[i], e.y = far * (scene_below(rng, 2) ? 1 : -1);
        else
            e.y = r->y[j], e.x = far * (scene_below(rng, 2) ? 1 : -1);
        break;
    case EYE_INSIDE:
        e.x = in(rng, -2, 2), e.y = in(rng, -2, 2), e.z = hi + in(rng, .01, 2) * tall;
        break;
    case EYE_OVER_VERTEX:
        e.x = r->x[i], e.y = r->y[j], e.z = hi + in(rng, .01, 2) * tall;
        break;
    case EYE_OVER_EDGE:
        e.x = r->x[i], e.y = in(rng, -2, 2), e.z = hi + in(rng, .01, 2) * tall;
        if (scene_below(rng, 2)) e.y = r->y[j], e.x = in(rng, -2, 2);
        break;
    case EYE_LEVEL:
        e.z = r->z[j * r->nx + i];
        break;
    case EYE_BELOW:
        e.x = in(rng, -3, 3), e.y = in(rng, -3, 3), e.z = lo - in(rng, .01, 2) * tall;
        if (!scene_below(rng, 3)) e.x = r->x[i], e.y = r->y[j];
        break;
    case EYE_DIRECTION:
        e = (exact_eye_t){cos(turn), sin(turn), in(rng, -1, 2), 0};
        break;
    case EYE_DIRECTION_AXIS: {
        double sign = scene_below(rng, 2) ? 1 : -1;
        e = (exact_eye_t){0, sign, scene_below(rng, 3) * .5, 0};
        if (scene_below(rng, 2)) e.x = sign, e.y = 0;
        break;
    }
    case EYE_DIRECTION_DIAGONAL:
        e = (exact_eye_t){scene_below(rng, 2) ? 1 : -1, scene_below(rng, 2) ? 1 : -1, scene_below(rng, 5) * .5 - .5, 0};
        break;
    case EYE_DIRECTION_STEEP:
        e = (exact_eye_t){.1 * scene_below(rng, 3), .05 * scene_below(rng, 2), 1, 0};
        break;
    case EYES:
        break;
    }
    r->eye = e;
}

void scene_aim(scene_t *s) {
    const surface_ref_t *r = &s->ref;
    double lo, hi;
    bounds(s, &lo, &hi);
    for (int k = 0; k < 2; k++) {
        const double *c = k ? r->y : r->x;
        int n = k ? r->ny : r->nx;
        double eye = k ? r->eye.y : r->eye.x;
        s->to[k] = .5 * (c[0] + c[n - 1]);
        /* An eye over the middle would look straight down at little more than its own feet. */
        if (r->eye.h && fabs(eye - s->to[k]) < .2 * (c[n - 1] - c[0]))
            s->to[k] = k ? c[n - 1] : .3 * c[0] + .7 * c[n - 1];
    }
    s->to[2] = .5 * (lo + hi);
    page_view_aim(&s->view, r, s->to);
}

void scene_random(scene_t *s, uint64_t seed, int max, int with_holes) {
    uint64_t rng = seed;
    int nx = 2 + scene_below(&rng, max - 1), ny = 2 + scene_below(&rng, max - 1);
    if (!scene_below(&rng, 8)) nx = 2;
    if (!scene_below(&rng, 8)) ny = 2;
    scene_init(s, nx, ny);
    int stretched = scene_below(&rng, 4) == 0;
    if (stretched) scene_stretch(s, pow(10, 3 * scene_uniform(&rng)), &rng);
    enum scene_shape shape = (enum scene_shape)scene_below(&rng, SHAPES);
    enum scene_eye eye = (enum scene_eye)scene_below(&rng, EYES);
    scene_shape(s, shape, &rng);
    if (with_holes) {
        s->ref.hole = calloc((size_t)nx * (size_t)ny, 1);
        if (!s->ref.hole) abort();
        double share = .3 * scene_uniform(&rng);
        for (int i = 0; i < nx * ny; i++) s->ref.hole[i] = scene_uniform(&rng) < share;
    }
    scene_eye(s, eye, &rng);
    scene_aim(s);
    snprintf(s->what, sizeof s->what, "seed %llu: %dx%d %s%s%s, eye %s (%.9g, %.9g, %.9g)", (unsigned long long)seed,
             nx, ny, shape_name[shape], stretched ? " stretched" : "", with_holes ? " holes" : "", eye_name[eye],
             s->ref.eye.x, s->ref.eye.y, s->ref.eye.z);
}

static void print_list(const char *name, const double *v, int n) {
    printf("double %s[] = {", name);
    for (int i = 0; i < n; i++) printf("%s%.17g", i ? ", " : "", v[i]);
    printf("};\n");
}

void scene_print(const scene_t *s) {
    const surface_ref_t *r = &s->ref;
    printf("/* %s */\n", s->what);
    print_list("x", r->x, r->nx);
    print_list("y", r->y, r->ny);
    print_list("z", r->z, r->nx * r->ny);
    if (r->hole) {
        printf("unsigned char hole[] = {");
        for (int i = 0; i < r->nx * r->ny; i++) printf("%s%d", i ? ", " : "", r->hole[i]);
        printf("};\n");
    }
    printf("exact_eye_t eye = {%.17g, %.17g, %.17g, %d};\n", r->eye.x, r->eye.y, r->eye.z, r->eye.h);
    printf("double camera[3][4] = {"); /* view.m: shrinking keeps it, scene_aim would choose another */
    for (int k = 0; k < 3; k++) {
        const double *m = s->view.m[k];
        printf("%s{%.17g, %.17g, %.17g, %.17g}", k ? ", " : "", m[0], m[1], m[2], m[3]);
    }
    printf("};\n");
    fflush(stdout);
}
