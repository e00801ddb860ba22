/* solid_rows.c - see solid_rows.h.
 *
 * Convex kernel and area sort draw the same scenes and are judged against rays (solid_ref.h), haloes against every edge
 * with every other in rationals (halo_ref.h), the clipper against slabs (slab_area.h). Scenes too large for a reference
 * are judged in some of their edges, or not at all. Haloes and clipper work on the lattice they are given: they get
 * coarser ones, too, and are judged against the scene as it was. */
#include "tests/report/solid_rows.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/bench/stars.h"
#include "tests/oracle/halo_run.h"
#include "tests/oracle/halo_scenes.h"
#include "tests/oracle/slab_area.h"
#include "tests/oracle/solid_scenes.h"
#include "tests/report/subject.h"

row_t row[ROWS];
int rows;
static bool quick;

static row_t *add_row(const char *kernel, const char *family, int size, double per_step) {
    if (rows == ROWS) abort();
    if (!quick) fprintf(stderr, "report_solids: %s %s %d\n", kernel, family, size);
    row[rows] = (row_t){.kernel = kernel, .family = family, .size = size, .per_step = per_step, .end = NAN};
    return &row[rows++];
}

/* CPU time of one run: the least of some. */
static double least(int (*run)(void *ctx), void *ctx, double enough) {
    double best = 1e9, spent = 0;
    for (int k = 0; k < 3 || (k < 1000 && spent < (quick ? .001 : enough)); k++) {
        double start = subject_clock();
        if (run(ctx)) return NAN;
        double took = subject_clock() - start;
        best = fmin(best, took);
        spent += took;
    }
    return best;
}

/* --- convex kernel and area sort --- */

static int drop_ink(void *ctx, const ink_piece_t *p) {
    return (void)ctx, (void)p, 0;
}

static int draw_solids(void *ctx) {
    return solid_stage_draw(ctx, &(ink_sink_t){NULL, drop_ink});
}

/* Adds a scene to the row. Scenes that the kernel refuses (nothing to see), and for the area sort those with faces that
 * cut through each other or lie behind the eye, do not count. */
static void solids(row_t *w, const solid_scene_t *s, bool area, int every) {
    solid_stage_t t;
    judge_report_t r;
    bool good = true;
    if (solid_stage_make(&t, s, area) == 0 && solid_stage_judge(&t, s, every, &r, &good) == 0 &&
        !(area && (t.sorted.intersections || t.sorted.behind))) {
        const int64_t work[2][4] = {
            {t.stats.tests, t.stats.crossings, t.stats.pieces, 0},
            {t.sorted.clips, t.sorted.removed, t.sorted.visible, t.sorted.errors},
        };
        w->scenes++;
        w->wrong += !good;
        w->elements += area ? t.sorted.polygons : t.stats.edges;
        w->missing = fmax(w->missing, r.missing_mm / JUDGE_STEP_MM);
        w->falsely = fmax(w->falsely, r.false_mm / JUDGE_STEP_MM);
        w->end = fmax(w->end, fmax(r.end_steps, r.moved_steps));
        for (int k = 0; k < 4; k++) w->work[k] += work[area][k];
        if (t.stats.bytes > w->bytes) w->bytes = t.stats.bytes;
        w->seconds += least(draw_solids, &t, w->scenes > 1 ? .005 : .2);
    }
    solid_stage_free(&t);
}

static void all_solids(bool area) {
    static const int cubes[] = {2, 4, 7, 14, 28}, around[] = {8, 12, 24, 54}, objects[] = {3, 8, 16};
    const char *kernel = area ? "area" : "convex";
    solid_scene_t s;
    for (int k = 0; k < (quick ? 2 : 5); k++) {
        solid_scene_cubes(&s, cubes[k]);
        solids(add_row(kernel, "cubes", cubes[k], NAN), &s, area, cubes[k] > 7 ? 3 * cubes[k] * cubes[k] / 10 : 0);
        solid_scene_free(&s);
    }
    for (int ball = 0; ball < 2; ball++)
        for (int k = 0; k < (quick ? 1 : 4); k++) {
            solid_scene_round(&s, around[k], ball ? 0 : 2.5);
            solids(add_row(kernel, ball ? "ball" : "torus", around[k], NAN), &s, area,
                   around[k] > 12 ? around[k] * around[k] / 10 : 0);
            solid_scene_free(&s);
        }
    for (int k = 0; k < (quick ? 1 : 3); k++) {
        row_t *w = add_row(kernel, "random", objects[k], NAN);
        for (uint64_t seed = 0; seed < (quick ? 10u : 200u / (unsigned)objects[k]); seed++) {
            solid_scene_random(&s, 1971 + seed, objects[k]);
            solids(w, &s, area, 0);
            solid_scene_free(&s);
        }
    }
}

void solid_rows_bits(void) {
    solid_scene_t s;
    quick = true;
    for (int area = 0; area < 2; area++) {
        const char *kernel = area ? "area" : "convex";
        solid_scene_cubes(&s, 7);
        solids(add_row(kernel, "cubes", 7, NAN), &s, area, 0);
        solid_scene_free(&s);
        for (int ball = 0; ball < 2; ball++) {
            solid_scene_round(&s, 12, ball ? 0 : 2.5);
            solids(add_row(kernel, ball ? "ball" : "torus", 12, NAN), &s, area, 0);
            solid_scene_free(&s);
        }
        row_t *w = add_row(kernel, "random", 8, NAN);
        for (uint64_t seed = 0; seed < 25; seed++) {
            solid_scene_random(&s, 1971 + seed, 8);
            solids(w, &s, area, 0);
            solid_scene_free(&s);
        }
    }
}

/* --- haloes --- */

typedef struct wires {
    const halo_edge_t *edge;
    int32_t n, width;
    halo_run_t run;
} wires_t;

static int draw_wires(void *ctx) {
    wires_t *w = ctx;
    return halo_run_draw(&w->run, w->edge, w->n, w->width);
}

/* On a lattice whose unit is so many lat. */
static void wires(const char *family, int size, halo_edge_t *edge, int32_t n, int32_t width, double unit) {
    row_t *w = add_row("halo", family, size, LAT_PER_STEP / unit);
    halo_edge_t *coarse = malloc((size_t)n * sizeof *coarse);
    wires_t x = {.edge = coarse, .n = n, .width = (int32_t)lround(width / unit)};
    if (!coarse) abort();
    halo_run_make(&x.run, n, 12 * (size_t)n + 4096);
    for (int32_t i = 0; i < n; i++) {
        halo_point_t *p[2] = {&coarse[i].p, &coarse[i].q};
        coarse[i] = edge[i];
        for (int end = 0; end < 2; end++) {
            p[end]->x = (int32_t)lround(p[end]->x / unit);
            p[end]->y = (int32_t)lround(p[end]->y / unit);
        }
    }
    w->seconds = least(draw_wires, &x, .2);
    w->missing = w->falsely = NAN;
    if (n <= 600) {
        const halo_ref_report_t r = halo_ref_judge(edge, n, width, false, 1, x.run.piece, x.run.n);
        w->missing = r.missing / LAT_PER_STEP;
        w->falsely = r.falsely / LAT_PER_STEP;
        w->wrong = unit <= 1 && r.beyond > 0;
    }
    w->scenes = 1;
    w->elements = n;
    memcpy(w->work, (int64_t[4]){x.run.h.tests, x.run.h.crossings, x.run.n, 0}, sizeof w->work);
    w->bytes = x.run.h.used;
    free(coarse);
    halo_run_free(&x.run);
}

static void all_wires(void) {
    /* The ends of each row of the paper's table, and sizes between, with edges as long as there are cells. */
    static const struct {
        int32_t n;
        double length;
    } random[] = {{100, .1}, {300, .1}, {1000, .03}, {10000, .01}, {50000, .01}, {200000, .005}};
    static const int cubes[] = {2, 4, 7, 14, 28};
    halo_edge_t *edge = malloc(200000 * sizeof *edge);
    if (!edge) abort();
    for (int k = 0; k < (quick ? 2 : 6); k++) {
        halo_scene_random(edge, random[k].n, random[k].length);
        wires("random edges", random[k].n, edge, random[k].n, (int32_t)(.02 * random[k].length * HALO_SCENE_PAGE), 1);
    }
    for (int k = 0; k < (quick ? 2 : 5); k++) {
        double scale = halo_scene_cubes(edge, cubes[k]);
        wires("cubes", cubes[k], edge, 12 * cubes[k] * cubes[k], (int32_t)(.05 * scale), 1);
    }
    free(edge);
}

/* --- the clipper --- */

typedef struct stars {
    poly_vertex_t *v[2];
    int32_t end[2];
    void *mem;
    size_t bytes;
    clip_out_t out;
    clip_t c;
} stars_t;

static int clip_stars(void *ctx) {
    stars_t *s = ctx;
    const clip_job_t job = {{s->v[0], s->end, 2}, {s->v[1], s->end, 2}, CLIP_EVEN_ODD, {CLIP_INSIDE, CLIP_NOTHING}};
    s->out.n = s->out.contours = 0;
    int err = clip_run(&s->c, &job, s->mem, s->bytes);
    return err ? err : clip_trace(&s->c, 0, &s->out);
}

static bool is_missing(unsigned in, const void *ctx) {
    return (void)ctx, in == 3;
}
static bool is_false(unsigned in, const void *ctx) {
    return (void)ctx, in >= 4 && in < 7;
}

/* The intersection of two stars with holes on a lattice whose unit is so many lat. */
static void clip(int spiky, int n, double unit) {
    row_t *w = add_row("clip", STARS_NAME[spiky], n, LAT_PER_STEP / unit);
    const int32_t most = 64 * n + 64;
    poly_vertex_t *fine[2];
    stars_t s = {.end = {n, 2 * n}, .bytes = CLIP_BYTES(4 * n) * (spiky ? 6 : 1)};
    s.out = (clip_out_t){.v = malloc((size_t)most * sizeof *s.out.v), .end = malloc((size_t)most * sizeof *s.out.end)};
    s.out.n_max = s.out.contours_max = most;
    s.mem = malloc(s.bytes);
    for (int star = 0; star < 2; star++) {
        fine[star] = malloc(2 * (size_t)n * sizeof *fine[star]);
        s.v[star] = malloc(2 * (size_t)n * sizeof *s.v[star]);
        if (!fine[star] || !s.v[star] || !s.mem || !s.out.v || !s.out.end) abort();
        for (int k = 0; k < 2 * n; k++) {
            poly_vertex_t *f = &fine[star][k];
            star_point(spiky, star, k / n, k % n, n, &f->at.x, &f->at.y);
            f->tag = k;
            s.v[star][k] = *f;
            s.v[star][k].at = (poly_point_t){(int32_t)lround(f->at.x / unit), (int32_t)lround(f->at.y / unit)};
        }
    }
    w->seconds = least(clip_stars, &s, .2);
    w->missing = w->falsely = NAN;
    if (n <= 100) {
        for (int k = 0; k < s.out.n; k++) {
            poly_point_t *p = &s.out.v[k].at;
            *p = (poly_point_t){(int32_t)lround(p->x * unit), (int32_t)lround(p->y * unit)};
        }
        const poly_t a = {fine[0], s.end, 2}, b = {fine[1], s.end, 2}, r = {s.out.v, s.out.end, s.out.contours};
        const slab_scene_t scene = {.poly = {&a, &b, &r}, .polys = 3};
        const double length = LAT_PER_STEP * slab_border(&r);
        w->missing = slab_area(&scene, is_missing, NULL) / length;
        w->falsely = slab_area(&scene, is_false, NULL) / length;
    }
    w->scenes = 1;
    w->elements = 4 * n;
    memcpy(w->work, (int64_t[4]){s.c.stats.most_edges, s.c.stats.crossings, s.out.contours, s.c.stats.sweeps},
           sizeof w->work);
    w->bytes = s.bytes;
    for (int star = 0; star < 2; star++) {
        free(fine[star]);
        free(s.v[star]);
    }
    free(s.mem);
    free(s.out.v);
    free(s.out.end);
}

static void all_clips(void) {
    for (int spiky = 0; spiky < 2; spiky++)
        for (int k = 0; k < (quick ? 2 : 4) && STARS_N[spiky][k]; k++) clip(spiky, STARS_N[spiky][k], 1);
}

void solid_rows_page_bits(void) {
    static const double bits[] = {8, 4, 2, 0};
    halo_edge_t *edge = malloc(1000 * sizeof *edge);
    if (!edge) abort();
    quick = true;
    for (int k = -1; k < 4; k++) {
        const double unit = k < 0 ? 1 : LAT_PER_STEP / exp2(bits[k]);
        halo_scene_random(edge, 300, .1);
        wires("random edges", 300, edge, 300, (int32_t)(.002 * HALO_SCENE_PAGE), unit);
        const double scale = halo_scene_cubes(edge, 4);
        wires("cubes", 4, edge, 12 * 4 * 4, (int32_t)(.05 * scale), unit);
        clip(0, 100, unit);
        clip(1, 100, unit);
    }
    free(edge);
}

void solid_rows_measure(bool small) {
    quick = small;
    all_solids(false);
    all_solids(true);
    all_wires();
    all_clips();
}
