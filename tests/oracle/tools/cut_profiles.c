/* Each plane is clipped to the rectangle by its two slabs; the rest is evaluation. */
#include "tests/oracle/tools/cut_profiles.h"

#include <math.h>
#include <stdlib.h>

#include "tests/oracle/tools/formula.h"

/* Narrows [*t0, *t1], for which from + t * step lies within lo .. hi. */
static void clip(double from, double step, double lo, double hi, double *t0, double *t1) {
    if (step == 0) return;
    double a = (lo - from) / step, b = (hi - from) / step;
    *t0 = fmax(*t0, fmin(a, b));
    *t1 = fmin(*t1, fmax(a, b));
}

const char *cut_profiles(const cut_scene_t *s, horizon_ref_t *r) {
    const exact_eye_t *e = &r->eye;
    double away[2] = {-e->x, -e->y};
    if (e->h) away[0] += .5 * (s->x[0] + s->x[1]), away[1] += .5 * (s->y[0] + s->y[1]);
    double size = hypot(away[0], away[1]);
    if (size == 0) away[1] = size = 1;
    away[0] /= size;
    away[1] /= size;
    double near = away[0] * s->x[away[0] < 0] + away[1] * s->y[away[1] < 0];
    double far = away[0] * s->x[away[0] > 0] + away[1] * s->y[away[1] > 0];
    double eye = e->h ? away[0] * e->x + away[1] * e->y : -INFINITY;
    size_t most = (size_t)s->count * (size_t)s->samples;
    int *first = malloc(((size_t)s->count + 1) * sizeof *first), at = 0;
    exact_point_t *point = malloc(most * sizeof *point);
    unsigned char *gap = malloc(most);
    if (!first || !point || !gap) abort();
    const char *bad = NULL;
    for (int k = 0; k < s->count; k++) {
        double depth = near + k * ((far - near) / (s->count - 1)), t0 = -INFINITY, t1 = INFINITY;
        double foot[2] = {depth * away[0], depth * away[1]}, side[2] = {away[1], -away[0]};
        first[k] = at;
        clip(foot[0], side[0], s->x[0], s->x[1], &t0, &t1);
        clip(foot[1], side[1], s->y[0], s->y[1], &t0, &t1);
        bool out = e->h && depth - eye < (far - eye) / 64;
        for (int v = 0; v < s->samples && !bad; v++) {
            double t = t0 + (t1 - t0) * v / (s->samples - 1);
            double x = fmin(fmax(foot[0] + t * side[0], s->x[0]), s->x[1]);
            double y = fmin(fmax(foot[1] + t * side[1], s->y[0]), s->y[1]);
            double z = formula(s->text, x, y, &bad);
            bool ok = t1 > t0 && !out && isfinite(z) && z >= s->limit[0] && z <= s->limit[1];
            point[at] = (exact_point_t){x, y, ok ? z : 0};
            gap[at++] = !ok;
        }
    }
    first[s->count] = at;
    r->count = s->count;
    r->first = first;
    r->point = point;
    r->gap = gap;
    return bad;
}
