/* solid_laws.c - see solid_laws.h. */
#include "tests/oracle/solid_laws.h"

#include <math.h>
#include <stdlib.h>

#include "tests/oracle/num_of.h"
#include "tests/oracle/scenes.h"
#include "tests/oracle/solid_ink.h"

static const char *const name_of[SOLID_LAWS] = {
    [SOLID_LAW_QUARTER] = "quarter turn", [SOLID_LAW_MIRROR] = "mirror",           [SOLID_LAW_TRANSLATE] = "translate",
    [SOLID_LAW_SCALE] = "scale",          [SOLID_LAW_UPSIDE_DOWN] = "upside down", [SOLID_LAW_REFINE] = "refine faces",
    [SOLID_LAW_ORDER] = "order",          [SOLID_LAW_BEHIND] = "add behind",       [SOLID_LAW_FRONT] = "add in front",
};

const char *solid_law_name(enum solid_law law) {
    return name_of[law];
}

static exact_point_t changed(enum solid_law law, exact_point_t p) {
    switch (law) {
    case SOLID_LAW_QUARTER:
        return (exact_point_t){-p.y, p.x, p.z};
    case SOLID_LAW_MIRROR:
        return (exact_point_t){-p.x, p.y, p.z};
    case SOLID_LAW_TRANSLATE:
        return (exact_point_t){p.x + 3.3, p.y - 1.7, p.z + 0.9};
    case SOLID_LAW_SCALE:
        return (exact_point_t){1024 * p.x, 1024 * p.y, 1024 * p.z};
    case SOLID_LAW_UPSIDE_DOWN:
        return (exact_point_t){p.x, p.y, -p.z};
    default:
        return p;
    }
}

static void change_place(enum solid_law law, num_t at[3]) {
    exact_point_t p = changed(law, (exact_point_t){num_value(at[0]), num_value(at[1]), num_value(at[2])});
    at[0] = num_of(p.x), at[1] = num_of(p.y), at[2] = num_of(p.z);
}

static void change_view(enum solid_law law, settings_t *set) {
    double rx = num_value(set->view.rot_x), rz = num_value(set->view.rot_z);
    if (law == SOLID_LAW_QUARTER) rz = fmod(rz + 90, 360);
    if (law == SOLID_LAW_MIRROR) rz = fmod(360 - rz, 360);
    if (law == SOLID_LAW_UPSIDE_DOWN) rx = 180 - rx;
    set->view.rot_x = num_of(rx);
    set->view.rot_z = num_of(rz);
    change_place(law, set->view.eye);
    change_place(law, set->view.to);
}

static void shuffle(int *v, int n, uint64_t *rng) {
    for (int i = 0; i < n; i++) v[i] = i;
    for (int k = n - 1; k > 0; k--) {
        const int j = scene_below(rng, k + 1), swap = v[k];
        v[k] = v[j];
        v[j] = swap;
    }
}

static double turns(const exact_point_t *p, const exact_point_t *q, const exact_point_t *r, double n[3]) {
    const double a[3] = {q->x - p->x, q->y - p->y, q->z - p->z}, b[3] = {r->x - p->x, r->y - p->y, r->z - p->z};
    const double c[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    const double along = c[0] * n[0] + c[1] * n[1] + c[2] * n[2];
    for (int k = 0; k < 3; k++) n[k] += c[k];
    return along;
}

/* The corner from which all triangles of a fan turn the same way, -1 if there is none. */
static int fan_from(const solid_ref_t *r, const int *c, int n) {
    for (int from = 0; from < n; from++) {
        double normal[3] = {0, 0, 0};
        bool good = true;
        for (int k = 1; k + 1 < n; k++)
            good &= turns(&r->vertex[c[from]], &r->vertex[c[(from + k) % n]], &r->vertex[c[(from + k + 1) % n]],
                          normal) > 0 ||
                    k == 1;
        if (good) return from;
    }
    return -1;
}

static bool has_corner(const solid_ref_t *r, int face, int v) {
    for (int k = r->first[face]; k < r->first[face + 1]; k++)
        if (r->corner[k] == v) return true;
    return false;
}

/* The same of a face; of the other side of one that came before, the same corner: diagonals of a body without thickness
 * are then on both of its sides. */
static int fan_of(const solid_ref_t *r, int face) {
    const int n = r->first[face + 1] - r->first[face], *c = r->corner + r->first[face];
    for (int other = 0; other < face; other++) {
        int common = 0;
        if (r->first[other + 1] - r->first[other] != n) continue;
        for (int k = 0; k < n; k++) common += has_corner(r, other, c[k]);
        const int from = common == n ? fan_from(r, r->corner + r->first[other], n) : -1;
        for (int k = 0; from >= 0 && k < n; k++)
            if (c[k] == r->corner[r->first[other] + from]) return k;
    }
    return fan_from(r, c, n);
}

static void put_face(enum solid_law law, const solid_ref_t *r, int face, const int *to, solid_ref_t *out,
                     uint64_t *rng) {
    const int n = r->first[face + 1] - r->first[face], *c = r->corner + r->first[face];
    int w[64], from = law == SOLID_LAW_REFINE && n > 3 ? fan_of(r, face) : -1;
    for (int k = 1; from >= 0 && k + 1 < n; k++)
        solid_ref_face(out, (int[]){to[c[from]], to[c[(from + k) % n]], to[c[(from + k + 1) % n]]}, 3);
    if (from >= 0) return;
    const int start = law == SOLID_LAW_ORDER ? scene_below(rng, n) : 0;
    const bool turned = law == SOLID_LAW_ORDER && scene_below(rng, 2);
    for (int k = 0; k < n; k++) w[k] = to[c[(turned ? start + n - k : start + k) % n]];
    solid_ref_face(out, w, n);
}

/* A triangle across the line of sight through the middle of the scene, `off` times its radius towards the eye. */
static void put_triangle(const solid_scene_t *s, solid_ref_t *out, double off, double size, uint64_t *rng) {
    const solid_ref_t *r = &s->ref;
    solid_stage_t stage;
    page_view_t view;
    exact_eye_t eye;
    exact_point_t lo = r->vertex[0], hi = lo;
    for (int v = 0; v < r->nv; v++) {
        lo = (exact_point_t){fmin(lo.x, r->vertex[v].x), fmin(lo.y, r->vertex[v].y), fmin(lo.z, r->vertex[v].z)};
        hi = (exact_point_t){fmax(hi.x, r->vertex[v].x), fmax(hi.y, r->vertex[v].y), fmax(hi.z, r->vertex[v].z)};
    }
    const double mid[3] = {(lo.x + hi.x) / 2, (lo.y + hi.y) / 2, (lo.z + hi.z) / 2};
    const double radius = .5 * hypot(hypot(hi.x - lo.x, hi.y - lo.y), hi.z - lo.z);
    double way[3] = {0, 0, 1}, length = 1;
    if (!solid_stage_make(&stage, s, false)) {
        solid_view_of(&stage.cam, &view, &eye);
        way[0] = eye.x - eye.h * mid[0], way[1] = eye.y - eye.h * mid[1], way[2] = eye.z - eye.h * mid[2];
        length = hypot(hypot(way[0], way[1]), way[2]);
        if (eye.h && off > 0 && length > 1.5 * radius) off = fmin(off, (length / radius + 1) / 2);
    }
    solid_stage_free(&stage);
    int v[3];
    for (int k = 0; k < 3; k++) {
        double at[3], side[3] = {scene_uniform(rng) - .5, scene_uniform(rng) - .5, scene_uniform(rng) - .5}, dot = 0;
        for (int i = 0; i < 3; i++) dot += side[i] * way[i] / length;
        for (int i = 0; i < 3; i++)
            at[i] = mid[i] + radius * (off * way[i] / length + size * (side[i] - dot * way[i] / length));
        v[k] = solid_ref_vertex(out, at[0], at[1], at[2]);
    }
    solid_ref_face(out, v, 3);
}

void solid_law_apply(enum solid_law law, uint64_t seed, const solid_scene_t *s, solid_scene_t *t, int **back) {
    const solid_ref_t *r = &s->ref;
    uint64_t rng = seed * 0x9e3779b97f4a7c15u + 99;
    const int most = r->nv > r->nf ? r->nv : r->nf;
    int *order = malloc((size_t)(most + r->nl + 1) * sizeof *order), *to = malloc((size_t)r->nv * sizeof *to);
    *back = malloc((size_t)(r->nv + 3) * sizeof **back);
    if (!order || !to || !*back) abort();
    *t = (solid_scene_t){.set = s->set, .lattice = s->lattice};
    change_view(law, &t->set);
    for (int k = 0; k < most; k++) order[k] = k;
    if (law == SOLID_LAW_ORDER) shuffle(order, r->nv, &rng);
    for (int k = 0; k < r->nv; k++) {
        const exact_point_t p = changed(law, r->vertex[order[k]]);
        to[order[k]] = solid_ref_vertex(&t->ref, p.x, p.y, p.z);
        (*back)[k] = order[k];
    }
    for (int k = 0; k < 3; k++) (*back)[r->nv + k] = -1;
    for (int k = 0; k < most; k++) order[k] = k;
    if (law == SOLID_LAW_ORDER) shuffle(order, r->nf, &rng);
    for (int k = 0; k < r->nf; k++) put_face(law, r, order[k], to, &t->ref, &rng);
    for (int k = 0; k < r->nl; k++) {
        const int *line = r->line[law == SOLID_LAW_ORDER ? r->nl - 1 - k : k];
        solid_ref_line(&t->ref, to[line[0]], to[line[1]]);
    }
    if (law == SOLID_LAW_BEHIND) put_triangle(s, &t->ref, -1.1 - scene_uniform(&rng), 3, &rng);
    if (law == SOLID_LAW_FRONT)
        put_triangle(s, &t->ref, scene_below(&rng, 2) ? 1.1 : 2 * scene_uniform(&rng) - 1, 1.5, &rng);
    solid_ref_finish(&t->ref);
    free(order);
    free(to);
}
