/* solid_shrink.c - scenes of solids made smaller while they fail, greedily; see solid_laws.h. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/oracle/num_of.h"
#include "tests/oracle/solid_laws.h"

/* A copy without elements [from, to) of faces and lines, and without the vertices that only they had; coordinates
 * rounded to 1/grain, if grain is not 0. */
static bool part(const solid_scene_t *s, int from, int to, double grain, solid_scene_t *t) {
    const solid_ref_t *r = &s->ref;
    int *at = malloc((size_t)r->nv * sizeof *at), left = 0;
    if (!at) abort();
    *t = *s;
    t->ref = (solid_ref_t){0};
    for (int v = 0; v < r->nv; v++) at[v] = -1;
    for (int pass = 0; pass < 2; pass++)
        for (int e = 0; e < r->nf + r->nl; e++) {
            const bool face = e < r->nf;
            const int n = face ? r->first[e + 1] - r->first[e] : 2,
                      *c = face ? r->corner + r->first[e] : r->line[e - r->nf];
            int w[64];
            if (e >= from && e < to) continue;
            left += pass == 0;
            for (int k = 0; k < n; k++) {
                const exact_point_t *p = &r->vertex[c[k]];
                if (pass == 0 && at[c[k]] < 0)
                    at[c[k]] = grain > 0 ? solid_ref_vertex(&t->ref, round(p->x * grain) / grain,
                                                            round(p->y * grain) / grain, round(p->z * grain) / grain)
                                         : solid_ref_vertex(&t->ref, p->x, p->y, p->z);
                w[k] = at[c[k]];
            }
            if (pass && face) solid_ref_face(&t->ref, w, n);
            if (pass && !face) solid_ref_line(&t->ref, w[0], w[1]);
        }
    free(at);
    if (left == 0) return false;
    solid_ref_finish(&t->ref);
    return true;
}

/* Are all faces as flat as the lattice of a scene makes them? What a bent one hides is nobody's fault. */
static bool is_flat(const solid_ref_t *r) {
    for (int f = 0; f < r->nf; f++) {
        const int n = r->first[f + 1] - r->first[f], *c = r->corner + r->first[f];
        const exact_point_t *o = &r->vertex[c[0]];
        double normal[3] = {0, 0, 0}, size = 0, off = 0;
        for (int k = 0; k < n; k++) {
            const exact_point_t *p = &r->vertex[c[k]], *q = &r->vertex[c[(k + 1) % n]];
            normal[0] += (p->y - o->y) * (q->z - o->z) - (p->z - o->z) * (q->y - o->y);
            normal[1] += (p->z - o->z) * (q->x - o->x) - (p->x - o->x) * (q->z - o->z);
            normal[2] += (p->x - o->x) * (q->y - o->y) - (p->y - o->y) * (q->x - o->x);
        }
        for (int k = 0; k < n; k++) {
            const exact_point_t *p = &r->vertex[c[k]];
            const double d[3] = {p->x - o->x, p->y - o->y, p->z - o->z};
            off = fmax(off, fabs(normal[0] * d[0] + normal[1] * d[1] + normal[2] * d[2]));
            size = fmax(size, fmax(fabs(d[0]), fmax(fabs(d[1]), fabs(d[2]))));
        }
        if (off > 1e-8 * size * (fabs(normal[0]) + fabs(normal[1]) + fabs(normal[2]))) return false;
    }
    return true;
}

static bool keep(solid_scene_t *s, solid_scene_t *trial, bool (*fails)(void *, const solid_scene_t *), void *ctx) {
    const bool yes = (is_flat(&trial->ref) || !is_flat(&s->ref)) && fails(ctx, trial);
    solid_scene_free(yes ? s : trial);
    if (yes) *s = *trial;
    return yes;
}

void solid_scene_shrink(solid_scene_t *s, bool (*fails)(void *ctx, const solid_scene_t *s), void *ctx) {
    solid_scene_t trial;
    for (int size = (s->ref.nf + s->ref.nl) / 2; size > 0; size /= 2)
        for (int from = 0; from + size <= s->ref.nf + s->ref.nl;)
            if (!part(s, from, from + size, 0, &trial) || !keep(s, &trial, fails, ctx)) from += size;
    for (double grain = 1; grain < 1e5; grain *= 10)
        if (part(s, 0, 0, grain, &trial) && keep(s, &trial, fails, ctx)) break;
}

void solid_scene_print(const solid_scene_t *s) {
    const solid_ref_t *r = &s->ref;
    const settings_t *set = &s->set;
    printf("#   set view ");
    if (set->view.from)
        for (int k = 0; k < 3; k++) printf("%s%.17g", k ? "," : "from ", num_value(set->view.eye[k]));
    for (int k = 0; k < 3 && set->view.from && set->view.has_to; k++)
        printf("%s%.17g", k ? "," : " to ", num_value(set->view.to[k]));
    if (!set->view.from) printf("%.17g,%.17g", num_value(set->view.rot_x), num_value(set->view.rot_z));
    printf("\n#   OBJ:\n");
    for (int v = 0; v < r->nv; v++) printf("v %.17g %.17g %.17g\n", r->vertex[v].x, r->vertex[v].y, r->vertex[v].z);
    for (int f = 0; f < r->nf; f++)
        for (int k = r->first[f]; k < r->first[f + 1]; k++)
            printf("%s%d%s", k == r->first[f] ? "f " : " ", r->corner[k] + 1, k + 1 == r->first[f + 1] ? "\n" : "");
    for (int k = 0; k < r->nl; k++) printf("l %d %d\n", r->line[k][0] + 1, r->line[k][1] + 1);
}
