/* Surfaces that repeat themselves or come to nothing on the page, by families and against the reference: shifted copies
 * that fall on each other along the line of sight, sheets seen along their own plane, pinholes in the midst of cliffs,
 * heights stretched a million times, grid lines in clusters, labyrinths of holes. test_awkward_random and
 * test_extreme_random have other families.
 *
 * RIDGELINE_CASES multiplies the count, RIDGELINE_SEED tries one. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "tests/oracle/families.h"

#define NAME "test_folded_random"

/* Even cells, so that what is shifted by whole cells falls on itself. */
static void even(scene_t *s) {
    surface_ref_t *r = &s->ref;
    for (int i = 0; i < r->nx; i++) r->x[i] = i - r->nx / 2;
    for (int j = 0; j < r->ny; j++) r->y[j] = j - r->ny / 2;
}

/* z(i + a, j + b) = z(i, j) + h, looked at along (a, b, h) or against it: every facet falls on its copies. */
static void copies(scene_t *s, uint64_t *rng) {
    surface_ref_t *r = &s->ref;
    const int a = scene_below(rng, 3), b = 1 + scene_below(rng, 2);
    const double h = (scene_below(rng, 9) - 4) / 4.;
    const uint64_t own = *rng;
    even(s);
    for (int j = 0; j < r->ny; j++)
        for (int i = 0; i < r->nx; i++) {
            const int n = j / b, u = i - n * a, v = j % b;
            uint64_t place = own + (uint64_t)(int64_t)(64 * u + v) * 0x9e3779b97f4a7c15u;
            for (int k = 0; k < 3; k++) scene_uniform(&place);
            *family_height(s, i, j) = scene_below(&place, 16) / 8. + n * h;
        }
    const double way = scene_below(rng, 2) ? 1 : -1;
    r->eye = (exact_eye_t){way * a, way * b, way * h, 0};
    if (scene_below(rng, 4) == 0) { /* not quite along it */
        r->eye.x += family_log_uniform(rng, 1e-9, 1e-2);
        r->eye.z -= family_log_uniform(rng, 1e-9, 1e-2);
    }
}

/* A plane, rough by a millionth or so, seen from within its own thickness. */
static void along_itself(scene_t *s, uint64_t *rng) {
    surface_ref_t *r = &s->ref;
    const double gx = 2 * scene_uniform(rng) - 1, gy = 2 * scene_uniform(rng) - 1,
                 rough = family_log_uniform(rng, 1e-9, 1e-2), turn = 6.283185307179586 * scene_uniform(rng);
    for (int j = 0; j < r->ny; j++)
        for (int i = 0; i < r->nx; i++)
            *family_height(s, i, j) = gx * r->x[i] + gy * r->y[j] + rough * scene_uniform(rng);
    const double far = scene_below(rng, 3) ? 4 : 400, x = far * cos(turn), y = far * sin(turn);
    const double off = rough * (3 * scene_uniform(rng) - 1);
    r->eye = scene_below(rng, 2) ? (exact_eye_t){x, y, gx * x + gy * y + off, 1}
                                 : (exact_eye_t){x, y, gx * x + gy * y + .1 * off, 0};
}

/* Cliffs, and an eye among them: a step from one, or right over the foot of another. */
static void among_cliffs(scene_t *s, uint64_t *rng, double highest, double nearest) {
    surface_ref_t *r = &s->ref;
    const double high = family_log_uniform(rng, 1, highest), width = r->x[r->nx - 1] - r->x[0];
    double at[3];
    for (int k = 0; k < r->nx * r->ny; k++) r->z[k] = high * scene_below(rng, 3) + .1 * scene_uniform(rng);
    family_place(s, rng, at);
    const double off = width * family_log_uniform(rng, nearest, 1e-2);
    r->eye = (exact_eye_t){at[0] + (scene_below(rng, 3) - 1) * off, at[1] + (scene_below(rng, 3) - 1) * off,
                           at[2] + (scene_below(rng, 2) ? off : high * scene_uniform(rng)), 1};
}

static void pinhole(scene_t *s, uint64_t *rng) {
    among_cliffs(s, rng, 1e4, 1e-5);
}

/* As `set zrange` of a millionth does it: surface and eye, a thousand to a million times as high. */
static void stretched_up(scene_t *s, uint64_t *rng) {
    surface_ref_t *r = &s->ref;
    const double k = family_log_uniform(rng, 1e3, 1e6);
    for (int i = 0; i < r->nx * r->ny; i++) r->z[i] *= k;
    r->eye.z *= k;
}

/* And as much flatter. */
static void pressed_flat(scene_t *s, uint64_t *rng) {
    surface_ref_t *r = &s->ref;
    const double k = family_log_uniform(rng, 1e-6, 1e-3);
    for (int i = 0; i < r->nx * r->ny; i++) r->z[i] *= k;
    r->eye.z *= k;
}

/* Lines in clusters, down to a millionth of the rest, both ways: there facets are thinner than the lattice tells apart,
 * and what one line lacks its neighbour has. */
static void clusters(scene_t *s, uint64_t *rng) {
    surface_ref_t *r = &s->ref;
    for (int both = 0; both < 2; both++) {
        double *c = both ? r->y : r->x, at = 0;
        const int n = both ? r->ny : r->nx;
        const double least = family_log_uniform(rng, 1e-6, .1);
        for (int i = 0; i < n; i++) {
            c[i] = at;
            at += scene_below(rng, 3) ? least : 1;
        }
        for (int i = 0; i < n; i++) c[i] = 4 * c[i] / at - 2;
    }
    scene_eye(s, (enum scene_eye)scene_below(rng, EYES), rng);
}

/* Ridges exactly along the line of sight, or across it: facets edge-on by the row. */
static void ploughed(scene_t *s, uint64_t *rng) {
    surface_ref_t *r = &s->ref;
    const int across = scene_below(rng, 3), period = 2 + scene_below(rng, 3);
    const double deep = scene_below(rng, 8) / 4., slope = (scene_below(rng, 9) - 4) / 8.;
    even(s);
    for (int j = 0; j < r->ny; j++)
        for (int i = 0; i < r->nx; i++) {
            const int at = across == 0 ? i : across == 1 ? j : i + j;
            *family_height(s, i, j) = deep * (at % period) + slope * r->y[j];
        }
    if (scene_below(rng, 2)) {
        r->eye = (exact_eye_t){across ? 0 : scene_below(rng, 2), -1, scene_below(rng, 2) ? -slope : deep, 0};
    } else {
        const double far = 3 + 2 * r->ny;
        r->eye = (exact_eye_t){r->x[scene_below(rng, r->nx)], -far, -slope * far + deep * scene_below(rng, 3), 1};
    }
}

/* A corridor that winds inwards, a comb, or single cells that stand alone. */
static void labyrinth(scene_t *s, uint64_t *rng) {
    surface_ref_t *r = &s->ref;
    const int kind = scene_below(rng, 3), wide = 2 + scene_below(rng, 2);
    if (!r->hole) return;
    for (int j = 0; j < r->ny; j++)
        for (int i = 0; i < r->nx; i++) {
            const int ring = (int)fmin(fmin(i, j), fmin(r->nx - 1 - i, r->ny - 1 - j));
            bool hole = kind == 0   ? ring % (wide + 1) == wide && i != j
                        : kind == 1 ? i % (wide + 1) == wide && j != (i & 1 ? 0 : r->ny - 1)
                                    : i % 3 == 2 || j % 3 == 2;
            r->hole[j * r->nx + i] = hole;
        }
}
static void labyrinth_of_copies(scene_t *s, uint64_t *rng) {
    copies(s, rng);
    labyrinth(s, rng);
}
static void labyrinth_inside(scene_t *s, uint64_t *rng) {
    /* as close as pinhole's eyes, one in 12,000 had ink 0.07 steps beside its place */
    among_cliffs(s, rng, 1e3, 25e-5);
    labyrinth(s, rng);
}
static void labyrinth_stretched(scene_t *s, uint64_t *rng) {
    clusters(s, rng);
    if (scene_below(rng, 2)) stretched_up(s, rng);
    labyrinth(s, rng);
}

static const family_t family[] = {
    {"copies", copies, false},
    {"along itself", along_itself, false},
    {"pinhole", pinhole, false},
    {"stretched up", stretched_up, false},
    {"pressed flat", pressed_flat, false},
    {"clusters", clusters, false},
    {"ploughed", ploughed, false},
    {"labyrinth", labyrinth, true},
    {"labyrinth of copies", labyrinth_of_copies, true},
    {"labyrinth, eye inside", labyrinth_inside, true},
    {"labyrinth, stretched", labyrinth_stretched, true},
};

static void random_families(void **state) {
    (void)state;
    assert_int_equal(families_run(NAME, family, sizeof family / sizeof *family, 21000000000, 250), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(random_families)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
