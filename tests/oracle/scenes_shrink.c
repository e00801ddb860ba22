/* Shrinking: drop grid lines, then flatten and round heights, while the failure stays. Greedy, a few hundred trials. */
#include "tests/oracle/scenes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void scene_copy(const scene_t *s, scene_t *out) {
    scene_init(out, s->ref.nx, s->ref.ny);
    size_t n = (size_t)s->ref.nx * (size_t)s->ref.ny;
    memcpy(out->ref.x, s->ref.x, (size_t)s->ref.nx * sizeof(double));
    memcpy(out->ref.y, s->ref.y, (size_t)s->ref.ny * sizeof(double));
    memcpy(out->ref.z, s->ref.z, n * sizeof(double));
    if (s->ref.hole) {
        out->ref.hole = malloc(n);
        if (!out->ref.hole) abort();
        memcpy(out->ref.hole, s->ref.hole, n);
    }
    out->ref.eye = s->ref.eye;
    out->view = s->view;
    memcpy(out->what, s->what, sizeof out->what);
    memcpy(out->to, s->to, sizeof out->to);
}

static scene_t copy_of(const scene_t *s) {
    scene_t c;
    scene_copy(s, &c);
    return c;
}

/* s without grid line `at` of the axis (0: a column, 1: a row). The camera stays, so lengths stay comparable. */
static scene_t without(const scene_t *s, int axis, int at) {
    scene_t c = copy_of(s);
    int nx = s->ref.nx, ny = s->ref.ny, k = 0;
    for (int j = 0; j < ny; j++)
        for (int i = 0; i < nx; i++) {
            if ((axis ? j : i) == at) continue;
            c.ref.z[k] = s->ref.z[j * nx + i];
            if (c.ref.hole) c.ref.hole[k] = s->ref.hole[j * nx + i];
            k++;
        }
    double *line = axis ? c.ref.y : c.ref.x;
    int n = axis ? ny : nx;
    memmove(line + at, line + at + 1, (size_t)(n - at - 1) * sizeof(double));
    if (axis)
        c.ref.ny--;
    else
        c.ref.nx--;
    return c;
}

static bool keep(scene_t *s, scene_t *trial, int (*fails)(void *ctx, const scene_t *s), void *ctx) {
    bool yes = fails(ctx, trial) != 0;
    if (yes) {
        scene_free(s);
        *s = *trial;
    } else {
        scene_free(trial);
    }
    return yes;
}

void scene_shrink(scene_t *s, int (*fails)(void *ctx, const scene_t *s), void *ctx) {
    for (bool again = true; again;) {
        again = false;
        for (int axis = 0; axis < 2; axis++)
            for (int at = (axis ? s->ref.ny : s->ref.nx) - 1; at >= 0; at--) {
                if ((axis ? s->ref.ny : s->ref.nx) <= 2) break;
                scene_t trial = without(s, axis, at);
                again |= keep(s, &trial, fails, ctx);
            }
    }
    for (int grain = 0; grain < 2; grain++)
        for (int i = 0; i < s->ref.nx * s->ref.ny && s->ref.nx * s->ref.ny < 200; i++) {
            scene_t trial = copy_of(s);
            trial.ref.z[i] = grain ? round(s->ref.z[i] * 64) / 64 : 0;
            if (trial.ref.z[i] == s->ref.z[i])
                scene_free(&trial);
            else
                keep(s, &trial, fails, ctx);
        }
}
