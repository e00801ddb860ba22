/* Hatching of surfaces against rays: at seeded random places of seeded random surfaces, is the hatch line there drawn
 * exactly if the facet that the eye sees there has a tone with that line?
 *
 * The ray knows nothing of horizons, charts or sweeps: of all facets whose picture contains the place, the nearest is
 * seen (doubles; a facet is its two triangles for depth, its four sides on the page for extent), and its light is
 * worked out again from its corners. Places next to the picture of a facet's side, and tones next to a threshold, are
 * nobody's fault. Rotated and perspective views, eyes beside, above and over the surface, holes, one to three surfaces
 * that may cut through each other. RIDGELINE_CASES tries so many times more, RIDGELINE_SEED=n one. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "hidden/surface/perimeter.h"
#include "hidden/surface/shaded.h"
#include "tests/oracle/num_of.h"
#include "tests/oracle/run_cases.h"
#include "view/page_map.h"

#define MOST 24
#define SHEETS 3

typedef struct sheet {
    double x[MOST], y[MOST], z[MOST][MOST]; /* [j][i]; NAN: a hole */
    int nx, ny;
} sheet_t;

static struct {
    sheet_t sheet[SHEETS];
    surface_t surface[SHEETS];
    grid_t grid[SHEETS];
    page_map_t map[SHEETS];
    line_space_t lines[SHEETS + 1];
    int n;
    settings_t set;
    camera_t cam;
    hatch_t hatch;
    light_t light[LIGHTS_MAX];
    int lights;
    double middle[3];
    ink_piece_t piece[400000];
    int pieces;
    double page[SHEETS][MOST][MOST][3]; /* mm and depth E */
} c;

static uint64_t state64;
static double random_unit(void) {
    state64 = state64 * 6364136223846793005u + 1442695040888963407u;
    return (double)(state64 >> 11) / 9007199254740992.0;
}
static double between(double a, double b) {
    return a + (b - a) * random_unit();
}

static num_t x_of(void *ctx, int32_t i) {
    return num_of(((sheet_t *)ctx)->x[i]);
}
static num_t y_of(void *ctx, int32_t j) {
    return num_of(((sheet_t *)ctx)->y[j]);
}
static num_t z_of(void *ctx, int32_t i, int32_t j) {
    double z = ((sheet_t *)ctx)->z[j][i];
    return isnan(z) ? num_undef() : num_of(z);
}

static int take(void *ctx, const ink_piece_t *p) {
    (void)ctx;
    if (p->family != INK_CURVE) return 0;
    assert_true(c.pieces < 400000);
    c.piece[c.pieces++] = *p;
    return 0;
}

static void choose_surfaces(uint64_t seed) {
    const int nx = 3 + (int)(random_unit() * (MOST - 3)), ny = 3 + (int)(random_unit() * (MOST - 3));
    c.n = seed % 4 == 3 ? 2 + (int)(seed / 4 % 2) : 1;
    for (int m = 0; m < c.n; m++) {
        sheet_t *s = &c.sheet[m];
        double a = between(.5, 3), b = between(.5, 3), d = between(0, 6), high = between(.1, 1.5),
               rough = seed % 3 ? 0 : .4;
        s->nx = nx;
        s->ny = ny;
        for (int i = 0; i < nx; i++) s->x[i] = m ? c.sheet[0].x[i] : (i ? s->x[i - 1] + between(.2, .4) : -2);
        for (int j = 0; j < ny; j++) s->y[j] = m ? c.sheet[0].y[j] : (j ? s->y[j - 1] + between(.2, .4) : -2);
        for (int j = 0; j < ny; j++)
            for (int i = 0; i < nx; i++) {
                s->z[j][i] = high * sin(a * s->x[i] + d) * cos(b * s->y[j]) + rough * random_unit() + .3 * m;
                if (seed % 5 == 4 && random_unit() < .05) s->z[j][i] = NAN;
            }
        c.surface[m] = (surface_t){.nx = nx, .ny = ny, .ctx = s, .x_of = x_of, .y_of = y_of, .z_of = z_of};
    }
}

static void choose_view(uint64_t seed) {
    settings_default(&c.set);
    if (seed % 2) {
        c.set.view.from = true;
        double a = between(0, 6.283), far = seed % 8 == 7 ? between(0, 1.5) : between(5, 12);
        c.set.view.eye[0] = num_of(far * cos(a) + 1);
        c.set.view.eye[1] = num_of(far * sin(a) + 1);
        c.set.view.eye[2] = num_of(seed % 8 == 7 ? between(2.5, 5) : between(-3, 8));
    } else {
        c.set.view.rot_x = num_of(between(5, 175));
        c.set.view.rot_z = num_of(between(0, 360));
    }
    c.lights = 1 + (int)(seed % 3);
    for (int l = 0; l < c.lights; l++) {
        double d[3] = {between(-1, 1), between(-1, 1), between(.2, 1)};
        c.light[l].point = random_unit() < .3;
        for (int k = 0; k < 3; k++) c.light[l].at[k] = num_of(c.light[l].point ? 9 * d[k] : d[k]);
    }
}

static bool make(void) {
    static uint64_t kernel[1 << 19], shading[1 << 16];
    view_box_t box = {0};
    num_t zero = num_from_i64(0);
    grid_t *grid[SHEETS];
    for (int m = 0; m < c.n; m++) {
        if (grid_measure(&c.grid[m], &c.surface[m], NULL, NULL, NULL, NULL, NULL)) return false;
        grid[m] = &c.grid[m];
        const num_t lo[3] = {x_of(&c.sheet[m], 0), y_of(&c.sheet[m], 0), c.grid[m].z_min};
        const num_t hi[3] = {x_of(&c.sheet[m], c.sheet[m].nx - 1), y_of(&c.sheet[m], c.sheet[m].ny - 1),
                             c.grid[m].z_max};
        for (int k = 0; k < 3; k++) {
            if (!m || num_cmp(lo[k], box.lo[k]) < 0) box.lo[k] = lo[k];
            if (!m || num_cmp(hi[k], box.hi[k]) > 0) box.hi[k] = hi[k];
        }
    }
    if (num_cmp(num_sub(box.hi[2], box.lo[2]), zero) <= 0 || camera_setup(&c.cam, &c.set, &box)) return false;
    for (int m = 0; m < c.n; m++) {
        if (page_map_setup(&c.map[m], grid[m], &c.cam, NULL)) return false;
        c.lines[m] = c.map[m].lines;
    }
    hatch_setup(&c.hatch, &c.cam.window, num_of(between(-90, 90)), LAT_PER_MM * 3 / 2);
    c.hatch.bits = SHADED_BITS;
    const ink_sink_t sink = {NULL, take};
    shaded_t s = {.hatch = &c.hatch,
                  .lines = c.lines,
                  .cam = &c.cam,
                  .light = c.light,
                  .lights = c.lights,
                  .sink = &sink,
                  .space = SHEETS};
    for (int k = 0; k < 3; k++) {
        s.middle[k] = num_ldexp(num_add(box.lo[k], box.hi[k]), -1);
        c.middle[k] = num_value(s.middle[k]);
    }
    assert_int_equal(shaded_init(&s, c.sheet[0].nx, c.n, shading, sizeof shading), 0);
    const hidden_job_t job = {.mem = kernel, .bytes = sizeof kernel, .sink = &sink};
    hidden_stats_t stats;
    c.pieces = 0;
    assert_int_equal(perimeter_draw_shaded(grid, c.n, &c.cam, &job, &s, &stats), 0);
    return true;
}

static double value(num_t a) {
    return num_value(a);
}

static void project(void) {
    for (int m = 0; m < c.n; m++)
        for (int j = 0; j < c.sheet[m].ny; j++)
            for (int i = 0; i < c.sheet[m].nx; i++) {
                const double p[4] = {c.sheet[m].x[i], c.sheet[m].y[j], c.sheet[m].z[j][i], 1};
                double h[3] = {0, 0, 0};
                for (int r = 0; r < 3; r++)
                    for (int k = 0; k < 4; k++) h[r] += value(c.cam.m[r][k]) * p[k];
                c.page[m][j][i][0] = h[0] / h[2] / LAT_PER_MM;
                c.page[m][j][i][1] = h[1] / h[2] / LAT_PER_MM;
                /* depth: along the direction to the eye, or by E */
                double depth = 0;
                for (int k = 0; k < 3; k++) {
                    double u = value(c.cam.unit[k]), e = value(c.cam.eye[k]);
                    depth -= c.cam.perspective ? 0 : u * p[k] * (u * e);
                }
                c.page[m][j][i][2] = c.cam.perspective ? h[2] : depth;
            }
}

static double cross2(const double a[2], const double b[2], const double p[2]) {
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

/* Depth in a triangle, or NAN. In perspective 1 / E is linear on the page. */
static double depth_in(const double *a, const double *b, const double *d, const double p[2]) {
    double whole = cross2(a, b, d), wa = cross2(b, d, p) / whole, wb = cross2(d, a, p) / whole,
           wd = cross2(a, b, p) / whole;
    if (!(fabs(whole) > 1e-9) || wa < -1e-9 || wb < -1e-9 || wd < -1e-9) return NAN;
    if (c.cam.perspective) return 1 / (wa / a[2] + wb / b[2] + wd / d[2]);
    return wa * a[2] + wb * b[2] + wd * d[2];
}

static double away_from(const double a[2], const double b[2], const double p[2]) {
    double dx = b[0] - a[0], dy = b[1] - a[1], l2 = dx * dx + dy * dy,
           t = l2 > 0 ? ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / l2 : 0;
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    return hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy);
}

/* What the eye sees at p; false if that is a matter of rounding. *m < 0: nothing. */
static bool look(const double p[2], int *m_out, int *i_out, int *j_out) {
    double nearest = HUGE_VAL, second = HUGE_VAL, spread = 0, spread2 = 0;
    *m_out = -1;
    for (int m = 0; m < c.n; m++)
        for (int j = 0; j + 1 < c.sheet[m].ny; j++)
            for (int i = 0; i + 1 < c.sheet[m].nx; i++) {
                const double *v[4] = {c.page[m][j][i], c.page[m][j][i + 1], c.page[m][j + 1][i + 1],
                                      c.page[m][j + 1][i]};
                bool in = false, good = true;
                for (int k = 0; k < 4; k++) good &= !isnan(v[k][0]) && (!c.cam.perspective || v[k][2] > 0);
                if (!good) {
                    for (int k = 0; k < 4; k++)
                        if (!isnan(v[k][0])) return false; /* close to a hole, or behind the eye: leave it */
                    continue;
                }
                for (int k = 0; k < 4; k++) {
                    const double *a = v[k], *b = v[(k + 1) % 4];
                    if (away_from(a, b, p) < .04) return false;
                    if ((a[1] > p[1]) != (b[1] > p[1]) && a[0] + (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1]) > p[0])
                        in = !in;
                }
                if (!in) continue;
                double z[4] = {depth_in(v[0], v[1], v[2], p), depth_in(v[0], v[2], v[3], p),
                               depth_in(v[0], v[1], v[3], p), depth_in(v[1], v[2], v[3], p)};
                double lo = HUGE_VAL, hi = -HUGE_VAL;
                for (int k = 0; k < 4; k++)
                    if (!isnan(z[k])) lo = fmin(lo, z[k]), hi = fmax(hi, z[k]);
                if (!(lo <= hi)) return false;
                if (lo < nearest) {
                    second = nearest;
                    spread2 = spread;
                    nearest = lo;
                    spread = hi - lo;
                    *m_out = m, *i_out = i, *j_out = j;
                } else if (lo < second) {
                    second = lo;
                    spread2 = hi - lo;
                }
            }
    return second - nearest > 2 * (spread + spread2) + 1e-6;
}

/* The tone of a facet; false next to a threshold. */
static bool tone_of(int m, int i, int j, enum hatch_tone *tone) {
    const sheet_t *s = &c.sheet[m];
    double u[3], d1[3], d2[3], n[3], len = 0, sum = 0, all[3] = {0, 0, 0}, full = 0;
    for (int k = 0; k < 3; k++) u[k] = value(c.cam.unit[k]);
    const double p[4][3] = {{s->x[i] * u[0], s->y[j] * u[1], s->z[j][i] * u[2]},
                            {s->x[i + 1] * u[0], s->y[j] * u[1], s->z[j][i + 1] * u[2]},
                            {s->x[i + 1] * u[0], s->y[j + 1] * u[1], s->z[j + 1][i + 1] * u[2]},
                            {s->x[i] * u[0], s->y[j + 1] * u[1], s->z[j + 1][i] * u[2]}};
    for (int k = 0; k < 3; k++) d1[k] = p[2][k] - p[0][k], d2[k] = p[3][k] - p[1][k];
    for (int k = 0; k < 3; k++) n[k] = d1[(k + 1) % 3] * d2[(k + 2) % 3] - d1[(k + 2) % 3] * d2[(k + 1) % 3];
    for (int k = 0; k < 3; k++) len += n[k] * n[k];
    double area = cross2(c.page[m][j][i], c.page[m][j][i + 1], c.page[m][j + 1][i + 1]) +
                  cross2(c.page[m][j][i], c.page[m][j + 1][i + 1], c.page[m][j + 1][i]);
    if (fabs(area) < 1e-3) return false;
    for (int l = 0; l < c.lights; l++) {
        double to[3], at[3], t2 = 0, a2 = 0, dot = 0;
        for (int k = 0; k < 3; k++) {
            at[k] = value(c.light[l].at[k]);
            to[k] = c.light[l].point ? at[k] * u[k] - p[0][k] : at[k];
            if (c.light[l].point) at[k] = (at[k] - c.middle[k]) * u[k];
            t2 += to[k] * to[k], a2 += at[k] * at[k], dot += to[k] * n[k];
        }
        for (int k = 0; k < 3; k++) all[k] += at[k] / sqrt(a2);
        sum += fmax(0, (area > 0 ? dot : -dot) / sqrt(t2 * len));
        if (fabs(dot) / sqrt(t2 * len) < 1e-6) return false;
    }
    for (int k = 0; k < 3; k++) full += all[k] * all[k];
    full = fmax(1, sqrt(full));
    static const double border[] = {.85, .65, .45, .25};
    for (int k = 0; k < 4; k++)
        if (fabs(sum / full - border[k]) < 1e-6) return false;
    *tone = sum / full >= .85   ? HATCH_NONE
            : sum / full >= .65 ? HATCH_FAINT
            : sum / full >= .45 ? HATCH_LIGHT
            : sum / full >= .25 ? HATCH_MIDDLE
            : sum > 0           ? HATCH_DEEP
                                : HATCH_DARK;
    return true;
}

typedef struct tally {
    long long places, drawn, wrong, scenes, hidden;
} tally_t;

static void try_places(tally_t *n) {
    const int32_t each = 2 * c.hatch.half + 1;
    for (int k = 0; k < 400; k++) {
        const int32_t number = (int32_t)(random_unit() * 2 * each), line = number % each - c.hatch.half;
        const bool second = number >= each;
        const int32_t t = (int32_t)(between(.2, .8) * (double)INK_ONE);
        page_h_t h;
        c.hatch.lines.at(c.hatch.lines.ctx, INK_CURVE, number, t, &h);
        const double p[2] = {(double)h.x / (double)h.e / LAT_PER_MM, (double)h.y / (double)h.e / LAT_PER_MM};
        int m, i, j;
        enum hatch_tone tone;
        if (!look(p, &m, &i, &j)) continue;
        bool want = false;
        if (m >= 0) {
            if (!tone_of(m, i, j, &tone)) continue;
            static const int step[2][6] = {{0, 4, 2, 1, 1, 1}, {0, 0, 0, 0, 2, 1}};
            int every = step[second][tone];
            want = every && abs(line) % every == 0;
        }
        bool drawn = false, near = false;
        const double bit =
            .12 * LAT_PER_MM / (2. * c.hatch.reach_lat) * (double)INK_ONE; /* of what is left out as dots */
        for (int q = 0; q < c.pieces; q++) {
            if (c.piece[q].line != number) continue;
            drawn |= c.piece[q].from <= t && t <= c.piece[q].to;
            near |= fabs((double)c.piece[q].from - t) < bit || fabs((double)c.piece[q].to - t) < bit;
        }
        n->places++;
        n->drawn += drawn;
        if (drawn == want) continue;
        /* crumbs of a tenth of a millimetre are closed and dropped: does the answer last that long? */
        double along[2] = {second ? -(double)c.hatch.sin_q30 : (double)c.hatch.cos_q30,
                           second ? (double)c.hatch.cos_q30 : (double)c.hatch.sin_q30};
        bool lasts = true;
        for (int d = -6; d <= 6 && lasts; d++) {
            const double q[2] = {p[0] + along[0] / (double)INK_ONE * .03 * d,
                                 p[1] + along[1] / (double)INK_ONE * .03 * d};
            int m2, i2, j2;
            lasts = look(q, &m2, &i2, &j2) && m2 == m && (m < 0 || (i2 == i && j2 == j));
        }
        if (lasts) n->wrong++;
        (void)near;
    }
}

static bool try_scene(uint64_t seed, tally_t *n) {
    state64 = seed * 2654435761u + 977;
    const long long before = n->wrong, places = n->places;
    choose_surfaces(seed);
    choose_view(seed);
    if (!make()) return true;
    project();
    n->scenes++;
    try_places(n);
    if (n->wrong != before)
        print_message("# FAILED RIDGELINE_SEED=%llu build/tests/property/test_shaded_random: %lld of %lld places (%d "
                      "surfaces, %s)\n",
                      (unsigned long long)seed, n->wrong - before, n->places - places, c.n,
                      c.cam.perspective ? "perspective" : "rotated");
    return n->wrong == before;
}

static void hatching_is_where_rays_end(void **state) {
    (void)state;
    tally_t n = {0};
    uint64_t first, to;
    int wrong = 0;
    assert_true(cases_seeds(0, cases_scaled(400), &first, &to));
    for (uint64_t seed = first; seed < to; seed++) wrong += !try_scene(seed, &n);
    print_message("# shaded: %lld scenes, %lld places, %lld hatched, %lld wrong in %d scenes\n", n.scenes, n.places,
                  n.drawn, n.wrong, wrong);
    assert_int_equal(wrong, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(hatching_is_where_rays_end)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
