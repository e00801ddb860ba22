/* families.c - see families.h. */
#include "tests/oracle/families.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

double family_log_uniform(uint64_t *rng, double lo, double hi) {
    return lo * pow(hi / lo, scene_uniform(rng));
}

double *family_height(const scene_t *s, int i, int j) {
    return &s->ref.z[j * s->ref.nx + i];
}

void family_place(const scene_t *s, uint64_t *rng, double at[3]) {
    const surface_ref_t *r = &s->ref;
    int i = scene_below(rng, r->nx - 1), j = scene_below(rng, r->ny - 1), kind = scene_below(rng, 3);
    double u = kind > 0 ? scene_uniform(rng) : 0, v = kind > 1 ? scene_uniform(rng) : 0;
    at[0] = r->x[i] + u * (r->x[i + 1] - r->x[i]);
    at[1] = r->y[j] + v * (r->y[j + 1] - r->y[j]);
    at[2] = (1 - v) * ((1 - u) * *family_height(s, i, j) + u * *family_height(s, i + 1, j)) +
            v * ((1 - u) * *family_height(s, i, j + 1) + u * *family_height(s, i + 1, j + 1));
}

void family_holes(scene_t *s, uint64_t *rng) {
    const int kind = scene_below(rng, 4), cut = scene_below(rng, 5);
    const surface_ref_t *r = &s->ref;
    if (r->hole == NULL) return;
    for (int j = 0; j < r->ny; j++)
        for (int i = 0; i < r->nx; i++) {
            int d = (int)hypot(i - r->nx / 2, j - r->ny / 2);
            r->hole[j * r->nx + i] = (unsigned char)(kind == 0   ? i + j < cut + 1
                                                     : kind == 1 ? d < 1 || d > 1 + cut
                                                     : kind == 2 ? ((i / 2 + j / 2) & 1) != 0
                                                                 : scene_below(rng, 6) == 0);
        }
}

/* How far the eye is from the surface over or under it, measured across. On the surface nothing has a right answer. */
static double clearance(const scene_t *s) {
    const surface_ref_t *r = &s->ref;
    const exact_eye_t *e = &r->eye;
    if (!e->h) return INFINITY;
    double least = INFINITY;
    for (int j = 0; j + 1 < r->ny; j++)
        for (int i = 0; i + 1 < r->nx; i++) {
            const double dx = r->x[i + 1] - r->x[i], dy = r->y[j + 1] - r->y[j];
            const double u = fmin(fmax((e->x - r->x[i]) / dx, 0), 1), v = fmin(fmax((e->y - r->y[j]) / dy, 0), 1);
            const double z00 = *family_height(s, i, j), z10 = *family_height(s, i + 1, j),
                         z01 = *family_height(s, i, j + 1), z11 = *family_height(s, i + 1, j + 1);
            const double slope_x = ((1 - v) * (z10 - z00) + v * (z11 - z01)) / dx;
            const double slope_y = ((1 - u) * (z01 - z00) + u * (z11 - z10)) / dy;
            const double z = (1 - v) * ((1 - u) * z00 + u * z10) + v * ((1 - u) * z01 + u * z11);
            const double across = fabs(e->z - z) / hypot(1, hypot(slope_x, slope_y));
            least = fmin(least, hypot(across, hypot(e->x - r->x[i] - u * dx, e->y - r->y[j] - v * dy)));
        }
    return least;
}

static void push(scene_t *s, const family_t *f, uint64_t *rng) {
    f->push(s, rng);
    const double width = s->ref.x[s->ref.nx - 1] - s->ref.x[0];
    for (int k = 0; k < 40 && clearance(s) < 25e-6 * width; k++) s->ref.eye.z += width * ldexp(25e-5, k);
    scene_aim(s);
    strncat(s->what, ", ", sizeof s->what - strlen(s->what) - 1);
    strncat(s->what, f->name, sizeof s->what - strlen(s->what) - 1);
}

int families_run(const char *program, const family_t *family, int n, uint64_t first, uint64_t count) {
    int failed = 0;
    uint64_t from, to;
    cases_t *c = calloc((size_t)n, sizeof *c);
    if (!c) abort();
    for (int f = 0; f < n; f++) c[f] = (cases_t){.name = family[f].name, .program = program};
    if (!cases_seeds(first, cases_scaled(count) * (uint64_t)n, &from, &to)) from = to = 0;
    for (uint64_t seed = from; seed < to && failed < 20; seed++) {
        const int f = (int)(seed % (uint64_t)n);
        scene_t s;
        uint64_t rng = seed ^ 0xe7;
        scene_random(&s, seed, 10, family[f].holes);
        push(&s, &family[f], &rng);
        if (!cases_surface(&c[f], &s, seed, failed < 3)) failed++;
        scene_free(&s);
    }
    for (int f = 0; f < n; f++) {
        if (c[f].run > 0) cases_summary(&c[f]);
    }
    free(c);
    return failed;
}
