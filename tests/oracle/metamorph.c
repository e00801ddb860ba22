/* The laws, one by one: there and back. */
#include "tests/oracle/metamorph.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const struct {
    const char *name;
    enum compare_how how;
    int before, after; /* rows added at the low and at the high end of y */
} law_of[METAMORPH_LAWS] = {
    [LAW_QUARTER] = {"quarter turn", COMPARE_SAME, 0, 0},    [LAW_MIRROR] = {"mirror", COMPARE_SAME, 0, 0},
    [LAW_TRANSLATE] = {"translate", COMPARE_SAME, 0, 0},     [LAW_SCALE] = {"scale", COMPARE_SAME, 0, 0},
    [LAW_UPSIDE_DOWN] = {"upside down", COMPARE_SAME, 0, 0}, [LAW_REFINE] = {"refine flat cells", COMPARE_SAME, 0, 0},
    [LAW_BEHIND] = {"add behind", COMPARE_SAME, 0, 1},       [LAW_HOLES] = {"add holes behind", COMPARE_SAME, 0, 2},
    [LAW_FRONT] = {"add in front", COMPARE_WITHIN, 1, 0},
};

const char *metamorph_name(enum metamorph_law law) {
    return law_of[law].name;
}
enum compare_how metamorph_how(enum metamorph_law law) {
    return law_of[law].how;
}

/* Heights f(x) + g(y) are flat in every cell. Few bits, so that midpoints are exact. */
static void fold(scene_t *s, uint64_t *rng) {
    const surface_ref_t *r = &s->ref;
    double *f = calloc((size_t)(r->nx + r->ny), sizeof *f);
    if (!f) abort();
    for (int i = 0; i < r->nx + r->ny; i++) f[i] = scene_below(rng, 64) / 64.0;
    for (int j = 0; j < r->ny; j++)
        for (int i = 0; i < r->nx; i++) r->z[j * r->nx + i] = f[i] + f[r->nx + j];
    for (int i = 0; i < r->nx; i++) r->x[i] = round(r->x[i] * 1024) / 1024;
    for (int j = 0; j < r->ny; j++) r->y[j] = round(r->y[j] * 1024) / 1024;
    free(f);
}

void metamorph_scene(enum metamorph_law law, uint64_t seed, int max, scene_t *s) {
    uint64_t rng = seed ^ 0xabcdef;
    /* With holes a row that is added would make edges of the border exist that did not. */
    bool may_have_holes = law != LAW_REFINE && !law_of[law].before && !law_of[law].after;
    scene_random(s, seed, max, may_have_holes && scene_below(&rng, 4) == 0);
    if (law != LAW_REFINE) return;
    int nx = s->ref.nx, ny = s->ref.ny;
    scene_free(s);
    scene_init(s, nx, ny);
    fold(s, &rng);
    scene_eye(s, (enum scene_eye)scene_below(&rng, EYES), &rng);
    scene_aim(s);
    snprintf(s->what, sizeof s->what, "seed %llu: %dx%d folded, eye (%.9g, %.9g, %.9g)", (unsigned long long)seed, nx,
             ny, s->ref.eye.x, s->ref.eye.y, s->ref.eye.z);
}

static void reverse(double *c, int n) {
    for (int i = 0; i < n - 1 - i; i++) {
        double t = c[i];
        c[i] = c[n - 1 - i];
        c[n - 1 - i] = t;
    }
}

/* An empty scene of that size, with holes if s has some or they are wanted. */
static void like(const scene_t *s, int nx, int ny, bool holes, scene_t *t) {
    scene_init(t, nx, ny);
    t->ref.eye = s->ref.eye;
    memcpy(t->what, s->what, sizeof t->what);
    if (!s->ref.hole && !holes) return;
    t->ref.hole = calloc((size_t)nx * (size_t)ny, 1);
    if (!t->ref.hole) abort();
}

/* Vertex (i, j) of t becomes vertex (ti, tj) of s. */
static void take(const scene_t *s, int ti, int tj, scene_t *t, int i, int j) {
    int to = j * t->ref.nx + i, from = tj * s->ref.nx + ti;
    t->ref.z[to] = s->ref.z[from];
    if (s->ref.hole) t->ref.hole[to] = s->ref.hole[from];
}

static void turn(const scene_t *s, scene_t *t) {
    const surface_ref_t *r = &s->ref;
    like(s, r->ny, r->nx, false, t);
    for (int i = 0; i < r->ny; i++) t->ref.x[i] = -r->y[r->ny - 1 - i];
    for (int j = 0; j < r->nx; j++) t->ref.y[j] = r->x[j];
    for (int j = 0; j < r->nx; j++)
        for (int i = 0; i < r->ny; i++) take(s, j, r->ny - 1 - i, t, i, j);
    t->ref.eye = (exact_eye_t){-r->eye.y, r->eye.x, r->eye.z, r->eye.h};
}

static void mirror(const scene_t *s, scene_t *t) {
    scene_copy(s, t);
    reverse(t->ref.x, t->ref.nx);
    for (int i = 0; i < t->ref.nx; i++) t->ref.x[i] = -t->ref.x[i];
    for (int j = 0; j < t->ref.ny; j++)
        for (int i = 0; i < t->ref.nx; i++) take(s, s->ref.nx - 1 - i, j, t, i, j);
    t->ref.eye.x = -t->ref.eye.x;
}

static void move(scene_t *t, double k, double kz, double dx, double dy, double dz) {
    surface_ref_t *r = &t->ref;
    double by = r->eye.h ? 1 : 0;
    for (int i = 0; i < r->nx; i++) r->x[i] = k * r->x[i] + dx;
    for (int j = 0; j < r->ny; j++) r->y[j] = k * r->y[j] + dy;
    for (int i = 0; i < r->nx * r->ny; i++) r->z[i] = kz * r->z[i] + dz;
    r->eye = (exact_eye_t){k * r->eye.x + by * dx, k * r->eye.y + by * dy, kz * r->eye.z + by * dz, r->eye.h};
}

static bool is_flat(const surface_ref_t *r) {
    for (int j = 0; j + 1 < r->ny; j++)
        for (int i = 0; i + 1 < r->nx; i++) {
            const double *z = r->z + j * r->nx + i;
            if (z[0] + z[r->nx + 1] != z[1] + z[r->nx]) return false;
        }
    return !r->hole;
}

static bool refine(const scene_t *s, scene_t *t) {
    const surface_ref_t *r = &s->ref;
    if (!is_flat(r)) return false;
    like(s, 2 * r->nx - 1, 2 * r->ny - 1, false, t);
    for (int i = 0; i < t->ref.nx; i++) t->ref.x[i] = .5 * (r->x[i / 2] + r->x[(i + 1) / 2]);
    for (int j = 0; j < t->ref.ny; j++) t->ref.y[j] = .5 * (r->y[j / 2] + r->y[(j + 1) / 2]);
    for (int j = 0; j < t->ref.ny; j++)
        for (int i = 0; i < t->ref.nx; i++) {
            const double *lo = r->z + j / 2 * r->nx, *hi = r->z + (j + 1) / 2 * r->nx;
            t->ref.z[j * t->ref.nx + i] = .25 * (lo[i / 2] + lo[(i + 1) / 2] + hi[i / 2] + hi[(i + 1) / 2]);
        }
    return true;
}

/* More rows before or after: high and low as it happens, of cells like the others. */
static bool extend(enum metamorph_law law, const scene_t *s, scene_t *t) {
    const surface_ref_t *r = &s->ref;
    int before = law_of[law].before, after = law_of[law].after, nx = r->nx;
    double depth = (r->y[r->ny - 1] - r->y[0]) / r->ny;
    /* No line of sight to a point of s may meet what is behind; in front, the row must be before the eye. */
    if (after && (r->eye.h ? r->eye.y >= r->y[r->ny - 1] : r->eye.y >= 0)) return false;
    if (before && (r->eye.h ? r->eye.y >= r->y[0] - 1e-3 : r->eye.y >= 0)) return false;
    if (before && r->eye.h) depth = fmin(depth, .5 * (r->y[0] - r->eye.y));
    like(s, nx, r->ny + before + after, law == LAW_HOLES, t);
    memcpy(t->ref.x, r->x, (size_t)nx * sizeof(double));
    for (int j = 0; j < t->ref.ny; j++) {
        int from = j - before;
        bool old = from >= 0 && from < r->ny;
        t->ref.y[j] = old ? r->y[from] : from < 0 ? r->y[0] - depth : r->y[r->ny - 1] + depth * (from - r->ny + 1);
        for (int i = 0; i < nx; i++) {
            if (old) take(s, i, from, t, i, j);
            if (!old) t->ref.z[j * nx + i] = 3.0 * ((i * 7) % 5) - 6;
            if (!old && law == LAW_HOLES) t->ref.hole[j * nx + i] = from == r->ny + 1 || i % 3 == 0;
        }
    }
    return true;
}

bool metamorph_apply(enum metamorph_law law, const scene_t *s, scene_t *t) {
    switch (law) {
    case LAW_QUARTER:
        turn(s, t);
        return true;
    case LAW_MIRROR:
        mirror(s, t);
        return true;
    case LAW_REFINE:
        return refine(s, t);
    case LAW_BEHIND:
    case LAW_HOLES:
    case LAW_FRONT:
        return extend(law, s, t);
    case LAW_TRANSLATE:
    case LAW_SCALE:
    case LAW_UPSIDE_DOWN:
    case METAMORPH_LAWS:
        break;
    }
    scene_copy(s, t);
    if (law == LAW_TRANSLATE) move(t, 1, 1, 37.25, -11.5, 100);
    if (law == LAW_SCALE) move(t, 1024, 1024, 0, 0, 0);
    if (law == LAW_UPSIDE_DOWN) move(t, 1, -1, 0, 0, 0);
    return true;
}

static void turned_round(judge_piece_t *p, int last) {
    double from = p->from;
    p->from = last - p->to;
    p->to = last - from;
}

bool metamorph_back(enum metamorph_law law, const scene_t *s, judge_piece_t *p) {
    int nx = s->ref.nx, ny = s->ref.ny, before = law_of[law].before, after = law_of[law].after;
    if (law == LAW_MIRROR || law == LAW_QUARTER) {
        int last = law == LAW_MIRROR ? nx - 1 : ny - 1;
        if (p->family == REF_ROW)
            turned_round(p, last);
        else
            p->line = last - p->line;
        if (law == LAW_QUARTER) p->family = !p->family;
    }
    if (law == LAW_REFINE) {
        p->from /= 2;
        p->to /= 2;
        p->line /= p->line % 2 ? -1 : 2;
        return p->line >= 0;
    }
    if (before || after) {
        if (p->family == REF_ROW) {
            p->line -= before;
            return p->line >= 0 && p->line < ny;
        }
        p->from = fmax(p->from - before, 0);
        p->to = fmin(p->to - before, ny - 1);
        return p->from < p->to;
    }
    return true;
}
