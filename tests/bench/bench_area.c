/* bench_area - solids through the polygon area sort: CPU time, and how the work grows.
 *
 * First k x k cubes, a torus and a ball, as bench_solids has them. Then the environments of Weiler and Atherton's
 * introduction: polygons that one covers (they expect linear growth), polygons that are each seen as one piece (the
 * square), polygons that others split (more than that); each with screen subdivision and without. Lateral: boxes
 * compared with that of a clip polygon. Growth: the exponent over the number of polygons, of the lateral comparisons
 * and of the time, from the size before. The least of several runs. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "tests/oracle/solid_scenes.h"

#define RUNS 7

static double now_ms(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return 1e3 * (double)t.tv_sec + 1e-6 * (double)t.tv_nsec;
}

static int count(void *ctx, int32_t face, const poly_t *p) {
    int64_t *vertices = ctx;
    (void)face;
    *vertices += poly_vertices(p);
    return 0;
}
static int no_wire(void *ctx, int32_t edge, int32_t from, int32_t to) {
    (void)ctx, (void)edge, (void)from, (void)to;
    return 0;
}

static struct { double polygons, lateral, ms; } before;

#define WHOLE INT32_MAX
#define ONE_BY_ONE (-1) /* windows as usual, but no bodies as silhouettes */

static void measure(const char *name, const solid_ref_t *body, int64_t rot_x, int32_t window_faces) {
    static solid_scene_t scene;
    static solid_stage_t stage;
    scene.ref = *body;
    settings_default(&scene.set);
    scene.set.view.rot_x = num_from_i64(rot_x);
    int64_t vertices;
    const area_sink_t sink = {.ctx = &vertices,
                              .polygon = count,
                              .wire = no_wire,
                              .window_faces = window_faces == WHOLE ? WHOLE : 0,
                              .one_by_one = window_faces == ONE_BY_ONE};
    area_stats_t s = {0};
    int err = solid_stage_make(&stage, &scene, true);
    size_t bytes = window_faces == WHOLE ? 40 * stage.bytes : stage.bytes;
    void *mem = malloc(bytes);
    double best = 1e9, started = now_ms();
    if (!mem) abort();
    for (int run = 0; run < RUNS && !err && (run < 2 || now_ms() - started < 400); run++) {
        double t = now_ms();
        vertices = 0;
        err = area_sort(&stage.map, mem, bytes, &sink, NULL, NULL, &s);
        best = fmin(best, now_ms() - t);
    }
    printf("area %-20s %-8s polygons %6lld  %9.3f ms  lateral %9lld  clips %8lld  visible %7lld  windows %4d", name,
           window_faces == WHOLE        ? "whole"
           : window_faces == ONE_BY_ONE ? "1 by 1"
                                        : "divided",
           (long long)s.polygons, best, (long long)s.lateral, (long long)s.clips, (long long)s.visible, (int)s.windows);
    if (err) printf("  error %d", err);
    if (before.polygons > 0 && (double)s.polygons > 1.5 * before.polygons) {
        double n = log((double)s.polygons / before.polygons);
        printf("  growth %.2f %.2f", log((double)s.lateral / before.lateral) / n, log(best / before.ms) / n);
    }
    printf("\n");
    before.polygons = (double)s.polygons;
    before.lateral = (double)s.lateral;
    before.ms = best;
    free(mem);
    solid_stage_free(&stage);
}

static void grow(const char *name, void (*make)(solid_ref_t *r, int n), int first, int last) {
    for (int whole = 0; whole < 2; whole++) {
        before.polygons = 0;
        for (int n = first; n <= last; n *= 4) {
            solid_ref_t r = {0};
            make(&r, n);
            measure(name, &r, 0, whole ? INT32_MAX : 0);
            solid_ref_free(&r);
        }
    }
}

int main(void) {
    solid_ref_t body = {0};
    static const int k[] = {7, 14, 28, 56};
    for (size_t i = 0; i < sizeof k / sizeof *k; i++) {
        char name[32];
        snprintf(name, sizeof name, "%d x %d cubes", k[i], k[i]);
        solid_body_cubes(&body, k[i]);
        measure(name, &body, 65, 0);
        solid_ref_free(&body);
    }
    before.polygons = 0;
    solid_body_cubes(&body, 28);
    measure("28 x 28 cubes", &body, 65, ONE_BY_ONE);
    solid_ref_free(&body);
    before.polygons = 0;
    solid_body_round(&body, 54, 2.5);
    measure("torus", &body, 65, 0);
    solid_ref_free(&body);
    solid_body_round(&body, 54, 0);
    measure("ball", &body, 65, 0);
    before.polygons = 0;
    measure("ball", &body, 65, ONE_BY_ONE);
    solid_ref_free(&body);
    grow("behind one", solid_body_covered, 64, 4096);
    grow("shingles", solid_body_shingles, 64, 4096);
    grow("woven bars", solid_body_woven, 16, 256);
    return 0;
}
