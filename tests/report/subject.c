/* Scenes from tests/oracle/scenes.h, in the shape each kernel takes. */
#include "tests/report/subject.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "hidden/surface/horizon.h"
#include "hidden/surface/perimeter.h"
#include "tests/report/lattice.h"

const char *const subject_kernel_name[KERNELS] = {"perimeter", "windows", "horizon"};
const char *const subject_family_name[FAMILIES] = {"smooth", "random", "cliffs", "grazing", "far"};

#define RUNS 3
#define SHORTEST_S 0.01

static void *room(size_t bytes) {
    void *p = malloc(bytes ? bytes : 1);
    if (!p) abort();
    return p;
}

static num_t x_of(void *ctx, int32_t i) {
    return ((subject_t *)ctx)->x[i];
}
static num_t y_of(void *ctx, int32_t j) {
    return ((subject_t *)ctx)->y[j];
}
static num_t z_of(void *ctx, int32_t i, int32_t j) {
    const subject_t *u = ctx;
    return u->z[j * u->n + i];
}
static int32_t points(void *ctx, int32_t k) {
    return (void)k, ((subject_t *)ctx)->n;
}
static void point(void *ctx, int32_t k, int32_t v, num_t xyz[3]) {
    const subject_t *u = ctx;
    int i = u->n - 1 - v, j = u->n - 1 - k;
    xyz[0] = u->x[i];
    xyz[1] = u->y[j];
    xyz[2] = u->z[j * u->n + i];
}

static void make_profiles(subject_t *u) {
    int n = u->n;
    u->point = room((size_t)(n * n) * sizeof *u->point);
    u->first = room((size_t)(n + 1) * sizeof *u->first);
    for (int k = 0; k <= n; k++) u->first[k] = k * n;
    for (int k = 0; k < n; k++)
        for (int v = 0; v < n; v++) u->point[k * n + v] = surface_ref_node(&u->scene.ref, n - 1 - v, n - 1 - k);
    u->horizon = (horizon_ref_t){.count = n, .first = u->first, .point = u->point, .eye = u->scene.ref.eye};
    u->profiles = (profiles_t){.count = n, .max_points = n, .ctx = u, .points = points, .point = point};
    for (int i = 0; i < 2; i++) {
        u->profiles.side[i] = num_from_i64(i ? 0 : -1);
        u->profiles.away[i] = num_from_i64(i ? -1 : 0);
    }
}

void subject_make(subject_t *u, enum subject_kernel kernel, enum subject_family family, int n) {
    static const exact_eye_t eye[FAMILIES] = {
        {6, 8, 3, 1}, {6, 8, 3, 1}, {6, 8, 3, 1}, {4, 5, .98, 1}, {6000, 8000, 3000, 1}};
    static const enum scene_shape shape[FAMILIES] = {SHAPE_SMOOTH, SHAPE_RANDOM, SHAPE_CLIFFS, SHAPE_RANDOM,
                                                     SHAPE_RANDOM};
    uint64_t rng = 1982;
    *u = (subject_t){.kernel = kernel, .family = family, .n = n};
    scene_init(&u->scene, n, n);
    scene_shape(&u->scene, shape[family], &rng);
    surface_ref_t *r = &u->scene.ref;
    r->eye = eye[family];
    if (kernel == KERNEL_WINDOWS) {
        r->hole = room((size_t)(n * n));
        for (int k = 0; k < n * n; k++) r->hole[k] = scene_below(&rng, 12) == 0;
    }
    scene_aim(&u->scene);
    snprintf(u->scene.what, sizeof u->scene.what, "%s %s %d", subject_kernel_name[kernel], subject_family_name[family],
             n);
    u->x = room((size_t)n * sizeof *u->x);
    u->y = room((size_t)n * sizeof *u->y);
    u->z = room((size_t)(n * n) * sizeof *u->z);
    u->cache = room((size_t)(n * n) * sizeof *u->cache);
    for (int i = 0; i < n; i++) u->x[i] = run_num(r->x[i]), u->y[i] = run_num(r->y[i]);
    for (int k = 0; k < n * n; k++) u->z[k] = r->hole && r->hole[k] ? num_undef() : run_num(r->z[k]);
    u->cam = run_camera(&r->eye);
    u->bytes = kernel == KERNEL_HORIZON ? horizon_bytes(8 * n * n + 1000)
                                        : perimeter_bytes(n, (kernel == KERNEL_WINDOWS ? 800 : 60) * 2 * n + 1000);
    u->mem = room(u->bytes);
    if (kernel == KERNEL_HORIZON) make_profiles(u);
    u->surface = (surface_t){n, n, u, x_of, y_of, z_of, NULL, NULL};
    if (kernel != KERNEL_HORIZON && grid_measure(&u->grid, &u->surface, NULL, NULL, u->cache, NULL, NULL)) abort();
}

void subject_free(subject_t *u) {
    scene_free(&u->scene);
    free(u->x);
    free(u->y);
    free(u->z);
    free(u->cache);
    free(u->mem);
    free(u->point);
    free(u->first);
    *u = (subject_t){0};
}

int subject_draw(subject_t *u, const ink_sink_t *sink, hidden_stats_t *stats) {
    hidden_job_t job = {.mem = u->mem, .bytes = u->bytes, .sink = sink};
    lattice_profiles = u->kernel == KERNEL_HORIZON;
    if (u->kernel == KERNEL_HORIZON) return horizon_draw(&u->profiles, &u->cam, false, &job, stats);
    return perimeter_draw(&u->grid, &u->cam, &job, stats);
}

int subject_judge(subject_t *u, int every, judge_report_t *rep, hidden_stats_t *stats) {
    run_drawing_t d = {0};
    ink_sink_t sink = run_sink(&d);
    int err = subject_draw(u, &sink, stats);
    if (u->kernel == KERNEL_HORIZON)
        for (size_t i = 0; i < d.n; i++) d.piece[i].family = 0;
    judge_subject_t what = u->kernel == KERNEL_HORIZON ? judge_horizon(&u->horizon) : judge_surface(&u->scene.ref);
    what.every = every;
    *rep = (judge_report_t){0};
    if (!err) err = judge_pieces(&what, &u->scene.view, d.piece, d.n, rep);
    run_drawing_free(&d);
    return err;
}

static int drop(void *ctx, const ink_piece_t *p) {
    *(uint64_t *)ctx += (uint64_t)(p->to - p->from); /* so that nothing is left out; may go round */
    return 0;
}

double subject_clock(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

double subject_ns(subject_t *u) {
    int64_t ink = 0;
    ink_sink_t sink = {&ink, drop};
    hidden_stats_t stats = {0};
    double best = 1e9;
    for (int run = 0; run < RUNS; run++) {
        double start = subject_clock();
        int times = 0;
        do {
            if (subject_draw(u, &sink, &stats)) return -1;
            times++;
        } while (subject_clock() - start < SHORTEST_S);
        double took = (subject_clock() - start) / times;
        if (took < best) best = took;
    }
    return 1e9 * best / (double)(stats.facets ? stats.facets : 1);
}
