/* light_ref.c - see light_ref.h. */
#include "tests/oracle/light_ref.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "error.h"
#include "hidden/area/area_tone.h"
#include "num/num_double.h"
#include "tests/oracle/num_of.h"

typedef struct vec {
    double x, y, z;
} vec_t;

static vec_t sub(vec_t a, vec_t b) {
    return (vec_t){a.x - b.x, a.y - b.y, a.z - b.z};
}
static vec_t add_scaled(vec_t a, vec_t b, double s) {
    return (vec_t){a.x + b.x * s, a.y + b.y * s, a.z + b.z * s};
}
static double dot(vec_t a, vec_t b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
static vec_t cross(vec_t a, vec_t b) {
    return (vec_t){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
static vec_t unit(vec_t a) {
    double l = sqrt(dot(a, a));
    return (vec_t){a.x / l, a.y / l, a.z / l};
}

static uint64_t state64;
static double random_unit(void) {
    state64 = state64 * 6364136223846793005u + 1442695040888963407u;
    return (double)(state64 >> 11) / 9007199254740992.0;
}

typedef struct lit_scene {
    solid_stage_t t;
    double size;
    light_t light[LIGHTS_MAX];
    vec_t lamp[LIGHTS_MAX];
    int lights;
    lit_t lit;
    borders_t borders;
    void *mem[3];
} lit_scene_t;

static vec_t vertex(const solid_t *s, int32_t v) {
    double at[3];
    for (int k = 0; k < 3; k++) at[k] = num_value(s->origin[k]) + ldexp(s->vertex[v].at[k], -s->shift);
    return (vec_t){at[0], at[1], at[2]};
}

static vec_t corner(const solid_t *s, int32_t f, int32_t k) {
    return vertex(s, s->corner[s->face[f].corner + k % s->face[f].n]);
}

static vec_t normal(const solid_t *s, int32_t f) {
    vec_t n = {0, 0, 0}, a = corner(s, f, 0);
    for (int32_t k = 1; k + 1 < s->face[f].n; k++)
        n = add_scaled(n, cross(sub(corner(s, f, k), a), sub(corner(s, f, k + 1), a)), 1);
    return unit(n);
}

/* Is p, in the plane of f, inside of it? Even-odd, seen along the normal's longest axis. */
static bool is_inside(const solid_t *s, int32_t f, vec_t p) {
    vec_t n = normal(s, f);
    int axis = fabs(n.x) > fabs(n.y) && fabs(n.x) > fabs(n.z) ? 0 : fabs(n.y) > fabs(n.z) ? 1 : 2;
    bool in = false;
    for (int32_t k = 0; k < s->face[f].n; k++) {
        vec_t a = sub(corner(s, f, k), p), b = sub(corner(s, f, k + 1), p);
        double ax = axis == 0 ? a.y : a.x, ay = axis == 2 ? a.y : a.z, bx = axis == 0 ? b.y : b.x,
               by = axis == 2 ? b.y : b.z;
        if ((ay > 0) != (by > 0) && ax + (bx - ax) * (-ay) / (by - ay) > 0) in = !in;
    }
    return in;
}

/* Does the way from p (on face own) towards the light pass through a face? */
static bool is_dark(const lit_scene_t *c, int32_t own, vec_t p, int l) {
    const solid_t *s = &c->t.solid;
    vec_t to = c->light[l].point ? sub(c->lamp[l], p) : unit(c->lamp[l]);
    for (int32_t f = 0; f < s->nf; f++) {
        vec_t n = normal(s, f);
        double speed = dot(n, to), away = dot(n, sub(corner(s, f, 0), p));
        if (f == own || speed == 0) continue;
        double t = away / speed;
        if (t * sqrt(dot(to, to)) < 1e-7 * c->size || (c->light[l].point && t > 1)) continue;
        if (is_inside(s, f, add_scaled(p, to, t))) return true;
    }
    return false;
}

/* How far p is in front of the eye. */
static double before_eye(const lit_scene_t *c, vec_t p) {
    const camera_t *cam = &c->t.cam;
    const vec_t ahead = {num_value(cam->m[2][0]), num_value(cam->m[2][1]), num_value(cam->m[2][2])};
    return cam->perspective ? (dot(ahead, p) + num_value(cam->m[2][3])) / sqrt(dot(ahead, ahead)) : HUGE_VAL;
}

/* The face that the eye sees along the line of sight through p; -1: none. *at: where. */
static int32_t seen(const lit_scene_t *c, vec_t p, vec_t to_eye, vec_t *at) {
    const solid_t *s = &c->t.solid;
    int32_t best = -1;
    double nearest = -HUGE_VAL;
    for (int32_t f = 0; f < s->nf; f++) {
        vec_t n = normal(s, f);
        double speed = dot(n, to_eye);
        if (fabs(speed) < 1e-9) continue;
        double t = dot(n, sub(corner(s, f, 0), p)) / speed;
        vec_t q = add_scaled(p, to_eye, t);
        if (t > nearest && before_eye(c, q) > 0 && is_inside(s, f, q)) nearest = t, best = f, *at = q;
    }
    return best;
}

static vec_t to_eye(const lit_scene_t *c, vec_t p) {
    const camera_t *cam = &c->t.cam;
    vec_t e = {num_value(cam->eye[0]), num_value(cam->eye[1]), num_value(cam->eye[2])};
    return unit(cam->perspective ? sub(e, p) : e);
}

/* On the page, in units of the eye's lattice. */
static void project(const lit_scene_t *c, vec_t p, double out[2]) {
    const camera_t *cam = &c->t.cam;
    double h[3];
    for (int r = 0; r < 3; r++)
        h[r] = num_value(cam->m[r][0]) * p.x + num_value(cam->m[r][1]) * p.y + num_value(cam->m[r][2]) * p.z +
               num_value(cam->m[r][3]);
    for (int k = 0; k < 2; k++) out[k] = ldexp(h[k] / h[2], c->lit.eye_lattice.bits);
}

static bool is_on_paper(const lit_scene_t *c, const double at[2]) {
    const page_window_t *w = &c->t.cam.window;
    double unit_lat = ldexp(1, c->lit.eye_lattice.bits);
    return at[0] >= w->x0_lat * unit_lat && at[0] <= w->x1_lat * unit_lat && at[1] >= w->y0_lat * unit_lat &&
           at[1] <= w->y1_lat * unit_lat;
}

/* Is the picture of a circle of `margin` around p so narrow that rounding to the lattice decides what is inside? So it
 * is where the eye sees a face edge-on: then there is nothing to shade. */
static bool is_edge_on(const lit_scene_t *c, int32_t f, vec_t p, double margin) {
    const solid_t *s = &c->t.solid;
    vec_t n = normal(s, f), u = unit(sub(corner(s, f, 1), corner(s, f, 0))), w = cross(n, u);
    double at[2], a[2], b[2];
    project(c, p, at);
    project(c, add_scaled(p, u, margin), a);
    project(c, add_scaled(p, w, margin), b);
    double ax = a[0] - at[0], ay = a[1] - at[1], bx = b[0] - at[0], by = b[1] - at[1];
    return fabs(ax * by - ay * bx) < 8 * sqrt(ax * ax + ay * ay + bx * bx + by * by);
}

static bool lit_says(const lit_scene_t *c, int32_t f, int l, const double at[2]) {
    static poly_vertex_t v[100000];
    static int32_t end[100000];
    clip_out_t out = {.v = v, .end = end, .n_max = 100000, .contours_max = 100000};
    if (lit_polygons(&c->lit, l, f, NULL, &out)) abort();
    int winding = 0;
    for (int32_t k = 0, first = 0; k < out.contours; first = out.end[k++])
        for (int32_t i = first; i < out.end[k]; i++) {
            poly_point_t a = v[i].at, b = v[i + 1 < out.end[k] ? i + 1 : first].at;
            if ((a.y > at[1]) == (b.y > at[1])) continue;
            if (a.x + ((double)b.x - a.x) * (at[1] - a.y) / ((double)b.y - a.y) > at[0]) winding += b.y > a.y ? 1 : -1;
        }
    return winding != 0;
}

/* Lights that reach p, a bit each; -1 if that changes when it moves by `margin` along the face. */
static int reached(const lit_scene_t *c, int32_t f, vec_t p, double margin, int64_t least_q30) {
    const solid_t *s = &c->t.solid;
    vec_t n = normal(s, f), u = unit(sub(corner(s, f, 1), corner(s, f, 0))), w = cross(n, u);
    int all = -1;
    for (int k = 0; k < 9; k++) {
        vec_t q = k < 8 ? add_scaled(add_scaled(p, u, margin * cos(k * .785398)), w, margin * sin(k * .785398)) : p;
        int mask = 0;
        for (int l = 0; l < c->lights; l++)
            if (light_slope(&c->light[l], &c->t.map, f) > least_q30 && !is_dark(c, f, q, l)) mask |= 1 << l;
        if (!is_inside(s, f, q) || (all >= 0 && mask != all)) return -1;
        all = mask;
    }
    return all;
}

/* Another face that touches this place makes any answer right. */
static bool is_touched(const lit_scene_t *c, int32_t own, vec_t p, double margin) {
    const solid_t *s = &c->t.solid;
    for (int32_t f = 0; f < s->nf; f++) {
        if (f == own) continue;
        vec_t n = normal(s, f);
        double away = dot(n, sub(p, corner(s, f, 0)));
        if (fabs(away) > margin) continue;
        vec_t foot = add_scaled(p, n, -away);
        for (int k = 0; k < 9; k++) {
            vec_t u = unit(sub(corner(s, f, 1), corner(s, f, 0))), w = cross(n, u);
            vec_t q =
                k < 8 ? add_scaled(add_scaled(foot, u, margin * cos(k * .785398)), w, margin * sin(k * .785398)) : foot;
            if (is_inside(s, f, q)) return true;
        }
    }
    return false;
}

static int no_ink(void *ctx, const ink_piece_t *p) {
    (void)ctx, (void)p;
    return 0;
}

/* A direction near d in the plane of a face, or out of it by ever so little. */
static vec_t grazing(const solid_t *s, vec_t d) {
    static const double by[] = {0, 1e-9, 1e-6, 1e-4, 1.3e-4, 3e-4, 1e-3, 1e-2};
    const vec_t n = normal(s, (int32_t)(random_unit() * s->nf));
    if (!(dot(n, n) > .5)) return d; /* a face without an area */
    return unit(add_scaled(unit(add_scaled(d, n, -dot(d, n))), n, by[(int)(random_unit() * 8)]));
}

/* The direction to the eye: of parallel ones nothing that is seen is in the shadow then. */
static vec_t at_eye(const lit_scene_t *c, vec_t d, vec_t middle) {
    const vec_t to = to_eye(c, middle);
    return dot(to, to) > .5 ? to : d;
}

/* Half of the scene's box, from its middle. */
static vec_t middle_of(lit_scene_t *c) {
    const solid_t *s = &c->t.solid;
    double lo[3], hi[3];
    for (int k = 0; k < 3; k++) lo[k] = num_value(s->lo[k]), hi[k] = num_value(s->hi[k]);
    const vec_t middle = {(lo[0] + hi[0]) / 2, (lo[1] + hi[1]) / 2, (lo[2] + hi[2]) / 2};
    const vec_t half = sub((vec_t){hi[0], hi[1], hi[2]}, middle);
    c->size = sqrt(dot(half, half));
    return middle;
}

static void take_lights(lit_scene_t *c, const light_t *light) {
    middle_of(c);
    for (int l = 0; l < c->lights; l++) {
        c->light[l] = light[l];
        c->lamp[l] = (vec_t){num_value(light[l].at[0]), num_value(light[l].at[1]), num_value(light[l].at[2])};
    }
}

static void choose_lights(lit_scene_t *c, uint64_t seed) {
    const solid_t *s = &c->t.solid;
    const vec_t middle = middle_of(c);
    c->lights = 1 + (int)(seed % LIGHTS_MAX);
    for (int l = 0; l < c->lights; l++) {
        vec_t d = unit((vec_t){random_unit() - .5, random_unit() - .5, random_unit() - .5});
        if (seed % 16 == 0 && l == 0) d = (vec_t){0, 0, 1};
        if (seed % 16 == 1 && l == 0) d = (vec_t){1, 0, 0};
        if (seed % 4 == 3) d = grazing(s, d);
        if (seed % 16 == 5 && l == 0) d = at_eye(c, d, middle);
        c->light[l].point = random_unit() < .4;
        if (c->light[l].point) d = add_scaled(middle, d, c->size * (1.2 + 4 * random_unit()));
        c->lamp[l] = d;
        c->light[l].at[0] = num_of(d.x);
        c->light[l].at[1] = num_of(d.y);
        c->light[l].at[2] = num_of(d.z);
    }
}

static bool crosses(const border_t *b, const double p[2], const double q[2]) {
    double ax = b->end[0].x, ay = b->end[0].y, bx = b->end[1].x, by = b->end[1].y;
    double s0 = (bx - ax) * (p[1] - ay) - (by - ay) * (p[0] - ax),
           s1 = (bx - ax) * (q[1] - ay) - (by - ay) * (q[0] - ax);
    double t0 = (q[0] - p[0]) * (ay - p[1]) - (q[1] - p[1]) * (ax - p[0]),
           t1 = (q[0] - p[0]) * (by - p[1]) - (q[1] - p[1]) * (bx - p[0]);
    return (s0 > 0) != (s1 > 0) && (t0 > 0) != (t1 > 0);
}

static vec_t random_on(const solid_t *s, int32_t f) {
    vec_t a = corner(s, f, (int32_t)(random_unit() * s->face[f].n)),
          b = corner(s, f, (int32_t)(random_unit() * s->face[f].n)),
          d = corner(s, f, (int32_t)(random_unit() * s->face[f].n));
    double u = random_unit(), w = random_unit() * (1 - u);
    return add_scaled(add_scaled(a, sub(b, a), u), sub(d, a), w);
}

/* Is p on f seen, and what is `near` to it too? A line of sight alone may slip through where two faces meet. */
static bool is_seen(const lit_scene_t *c, int32_t f, vec_t p, double near) {
    const solid_t *s = &c->t.solid;
    vec_t u = unit(sub(corner(s, f, 1), corner(s, f, 0))), w = cross(normal(s, f), u), at;
    for (int k = 0; k < 5; k++) {
        vec_t q = k == 0 ? p : add_scaled(p, k & 1 ? u : w, k < 3 ? near : -near);
        if (seen(c, q, to_eye(c, q), &at) != f) return false;
    }
    return true;
}

/* Between two places of a face with different answers there is a border. */
static void check_change(const lit_scene_t *c, int32_t f, vec_t p, vec_t q, int at_p, int at_q, double margin,
                         light_tally_t *n) {
    for (int k = 0; k < 40 && dot(sub(p, q), sub(p, q)) > 16 * margin * margin; k++) {
        vec_t m = add_scaled(p, sub(q, p), .5);
        int at_m = reached(c, f, m, margin / 64, LIGHT_GRAZING_Q30);
        if (at_m < 0) m = add_scaled(p, sub(q, p), .45), at_m = reached(c, f, m, margin / 64, LIGHT_GRAZING_Q30);
        if (at_m < 0) break;
        if (at_m == at_p)
            p = m;
        else
            q = m, at_q = at_m;
    }
    if (at_p == at_q || reached(c, f, p, margin / 64, LIGHT_GRAZING_Q30) != at_p ||
        reached(c, f, q, margin / 64, LIGHT_GRAZING_Q30) != at_q)
        return;
    if (dot(sub(p, q), sub(p, q)) > 64 * margin * margin) return;
    for (int k = 0; k <= 8; k++) {
        vec_t m = add_scaled(p, sub(q, p), k / 8.);
        if (!is_seen(c, f, m, margin / 64) || is_touched(c, f, m, 4 * margin)) return;
    }
    double a[2], b[2];
    vec_t d = sub(q, p);
    project(c, add_scaled(p, d, -.2), a);
    project(c, add_scaled(q, d, .2), b);
    if (!is_on_paper(c, a) || !is_on_paper(c, b)) return;
    n->changes++;
    for (int32_t k = 0; k < c->borders.n; k++)
        if (crosses(&c->borders.list[k], a, b)) return;
    n->changes_missed++;
}

static void check_places(const lit_scene_t *c, light_tally_t *n) {
    const solid_t *s = &c->t.solid;
    const double margin = 1e-3 * c->size;
    for (int32_t f = 0; f < s->nf; f++) {
        bool away =
            s->object[s->face[f].object].kind != SOLID_OPEN && !c->t.map.any_behind && !area_looks_at_eye(&c->t.map, f);
        if (away) continue;
        vec_t last = {0, 0, 0};
        int at_last = -1;
        for (int k = 0; k < 24; k++) {
            vec_t p = random_on(s, f);
            int mask = is_inside(s, f, p) ? reached(c, f, p, margin, LIGHT_GRAZING_Q30) : -1;
            if (mask < 0 || before_eye(c, p) <= margin || is_touched(c, f, p, 2 * margin)) continue;
            double at[2];
            project(c, p, at);
            if (!is_on_paper(c, at)) continue;
            if (is_edge_on(c, f, p, margin)) {
                n->edge_on++;
                continue;
            }
            n->places++;
            for (int l = 0; l < c->lights; l++) {
                if (light_slope(&c->light[l], &c->t.map, f) <= LIGHT_GRAZING_Q30) continue;
                n->places_wrong += lit_says(c, f, l, at) != (mask >> l & 1);
            }
            if (at_last >= 0 && mask != at_last) check_change(c, f, last, p, at_last, mask, margin, n);
            last = p;
            at_last = mask;
        }
    }
}

static vec_t row(const camera_t *cam, int r) {
    return (vec_t){num_value(cam->m[r][0]), num_value(cam->m[r][1]), num_value(cam->m[r][2])};
}

/* Some point of the line of sight through a place of the page, which is where the planes meet that show as the line
 * across and the line upright through it. */
static vec_t sighted(const lit_scene_t *c, const double page[2]) {
    const camera_t *cam = &c->t.cam;
    vec_t n[2];
    double d[2];
    for (int r = 0; r < 2; r++) {
        const double at = ldexp(page[r], -c->lit.eye_lattice.bits);
        n[r] = add_scaled(row(cam, r), row(cam, 2), -at);
        d[r] = at * num_value(cam->m[2][3]) - num_value(cam->m[r][3]);
    }
    if (cam->perspective) {
        const vec_t eye = {num_value(cam->eye[0]), num_value(cam->eye[1]), num_value(cam->eye[2])};
        const vec_t along = unit(cross(n[0], n[1]));
        return add_scaled(eye, along, dot(along, row(cam, 2)) > 0 ? c->size : -c->size);
    }
    const double g00 = dot(n[0], n[0]), g01 = dot(n[0], n[1]), g11 = dot(n[1], n[1]), det = g00 * g11 - g01 * g01;
    const double u = (d[0] * g11 - d[1] * g01) / det, w = (d[1] * g00 - d[0] * g01) / det;
    return add_scaled(add_scaled((vec_t){0, 0, 0}, n[0], u), n[1], w);
}

/* The lights that reach what the eye sees at a place of the page; -1 if none is sure. */
static int reached_at(const lit_scene_t *c, const double page[2], double margin, double near, int32_t *face) {
    const vec_t p = sighted(c, page);
    vec_t q = p;
    *face = seen(c, p, to_eye(c, p), &q);
    return *face < 0 || is_touched(c, *face, q, margin) ? -1 : reached(c, *face, q, near, LIGHT_GRAZING_Q30);
}

/* To both sides of a border other lights reach the face: close to it if not farther off, since the shadow of a needle
 * is narrow, and that of a face at which the light grazes. Shadows narrower than a hundredth of a step have no borders
 * (hidden/area_border.c), so the closest places are half of that apart. */
static void check_borders(const lit_scene_t *c, light_tally_t *n) {
    const double margin = 1e-3 * c->size;
    const double most = ldexp(LAT_PER_MM, c->lit.eye_lattice.bits) * JUDGE_STEP_MM;
    for (int32_t k = 0; k < c->borders.n; k++) {
        const border_t *b = &c->borders.list[k];
        double dx = (double)b->end[1].x - b->end[0].x, dy = (double)b->end[1].y - b->end[0].y, l = hypot(dx, dy);
        if (l < 10 * most) continue;
        bool sure = false, differs = false;
        for (int closer = 1; closer <= 256 && !differs; closer *= 4) {
            int mask[2];
            int32_t face[2];
            for (int side = 0; side < 2; side++) {
                double t = (side ? most : -most) / closer / l,
                       at[2] = {(b->end[0].x + dx / 2 - dy * t), (b->end[0].y + dy / 2 + dx * t)};
                mask[side] = reached_at(c, at, margin, margin / 16 / closer, &face[side]);
            }
            sure = mask[0] >= 0 && mask[1] >= 0 && face[0] == face[1];
            differs = sure && mask[0] != mask[1];
        }
        n->borders += sure;
        n->borders_wrong += sure && !differs;
    }
}

void light_tally_add(light_tally_t *to, const light_tally_t *n) {
    to->scenes += n->scenes, to->behind += n->behind, to->left_out += n->left_out;
    to->errors += n->errors, to->edge_on += n->edge_on;
    to->places += n->places, to->places_wrong += n->places_wrong;
    to->borders += n->borders, to->borders_wrong += n->borders_wrong;
    to->changes += n->changes, to->changes_missed += n->changes_missed;
}

void light_tally_tell(const light_tally_t *n) {
    printf("%lld of %lld places, %lld of %lld borders, %lld of %lld changes, %lld errors", n->places_wrong, n->places,
           n->borders_wrong, n->borders, n->changes_missed, n->changes, n->errors);
}

bool light_ref_judge(const solid_scene_t *s, uint64_t seed, const light_t *light, int lights, light_tally_t *n) {
    static lit_scene_t c;
    const light_tally_t before = *n;
    c = (lit_scene_t){.lights = lights};
    state64 = seed * 2654435761u + 12345;
    int err = solid_stage_make(&c.t, s, true);
    const size_t bytes = (size_t)1 << 24;
    for (int k = 0; k < 3; k++) c.mem[k] = malloc(bytes);
    if (!err) {
        if (light)
            take_lights(&c, light);
        else
            choose_lights(&c, seed);
        err = lit_make(&c.lit, &c.t.map, c.light, c.lights, c.mem[0], bytes, c.mem[1], bytes);
    }
    if (!err) {
        borders_init(&c.borders, c.mem[2], bytes, &c.t.cam.window);
        area_tone_t tone = {.lights = c.lights, .shadow = true, .borders = &c.borders};
        for (int l = 0; l < c.lights; l++) tone.light[l] = c.light[l];
        const ink_sink_t sink = {NULL, no_ink};
        const hidden_job_t job = {.mem = c.mem[1], .bytes = bytes, .sink = &sink};
        err = area_draw(&c.t.map, &tone, NULL, &job, &c.t.stats, &c.t.sorted);
    }
    const bool fits = !err && !c.t.sorted.intersections;
    n->behind += fits && c.t.sorted.behind;
    if (fits) {
        n->scenes++;
        check_places(&c, n);
        check_borders(&c, n);
    } else {
        n->left_out++;
        n->errors += err && err != ERR_VALUE && err != ERR_EMPTY;
    }
    for (int k = 0; k < 3; k++) free(c.mem[k]);
    solid_stage_free(&c.t);
    return n->places_wrong == before.places_wrong && n->borders_wrong == before.borders_wrong &&
           n->changes_missed == before.changes_missed && n->errors == before.errors;
}

bool light_ref_picture(const solid_scene_t *s, const light_t *light, int lights, double pitch_mm,
                       light_ref_place_t *place, void *ctx) {
    static lit_scene_t c;
    c = (lit_scene_t){.lights = lights};
    const int err = solid_stage_make(&c.t, s, true);
    if (!err) {
        take_lights(&c, light);
        c.lit.eye_lattice = area_lattice(&c.t.map);
        const page_window_t *w = &c.t.cam.window;
        const double unit_lat = ldexp(1, c.lit.eye_lattice.bits), margin = 1e-3 * c.size;
        for (double y = w->y0_lat / LAT_PER_MM; y < w->y1_lat / LAT_PER_MM; y += pitch_mm)
            for (double x = w->x0_lat / LAT_PER_MM; x < w->x1_lat / LAT_PER_MM; x += pitch_mm) {
                const double at[2] = {x * LAT_PER_MM * unit_lat, y * LAT_PER_MM * unit_lat};
                int32_t face;
                const int mask = reached_at(&c, at, margin, margin / 16, &face);
                if (face >= 0) place(ctx, x, y, mask);
            }
    }
    solid_stage_free(&c.t);
    return !err;
}
