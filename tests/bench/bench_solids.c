/* bench_solids - solids from meshes in memory to visible ink, counted and dropped: CPU time.
 *
 *     bench_solids K...    k x k unit cubes, pitch 1.5, 25 degrees above the ground (the scene of Franklin & Akman's
 *                          figure 4), then a torus and a ball of some 5,800 triangles, closed and not taken as
 *                          convex; knots of 5,760 triangles and more; thousands of concave prisms
 *
 * build: meshes become vertices, edges, objects (solid_build); view: the camera; map: vertices on the page
 * (solid_map_setup); hide: the kernel; once: what coincides is drawn once. The least of several runs. Growth: the
 * exponent of the time over the number of edges, from the size before. Cubes are hidden by brute_convex.h too, in turn
 * with ours: its map and hide are to be held against ours; it starts from bodies that are built, and does not look for
 * what coincides.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "hidden/solid/convex.h"
#include "hidden/solid/once.h"
#include "tests/bench/brute_convex.h"
#include "tests/oracle/solid_scenes.h"

#define RUNS 15
#define RUNS_MOST 400 /* of small scenes, for which a run is a few microseconds */
#define TRIANGLE_ROWS 54

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return 1e3 * (double)t.tv_sec + 1e-6 * (double)t.tv_nsec;
}

static int drop(void *ctx, const ink_piece_t *p) {
    int64_t *sum = ctx;
    *sum += p->to - p->from;
    return 0;
}

typedef struct brute_times {
    double map, hide; /* ms */
    int32_t pieces;
} brute_times_t;

static double double_of(num_t a) {
    return ldexp((double)a.m, a.e);
}

/* The view of a camera for bodies: right, up, and towards the eye. */
static void view_of(const camera_t *cam, double view[3][3]) {
    for (int k = 0; k < 3; k++) {
        view[0][k] = double_of(cam->m[0][k]);
        view[1][k] = double_of(cam->m[1][k]);
        view[2][k] = double_of(cam->eye[k]);
    }
    for (int r = 0; r < 3; r++) {
        double length = sqrt(view[r][0] * view[r][0] + view[r][1] * view[r][1] + view[r][2] * view[r][2]);
        for (int k = 0; k < 3; k++) view[r][k] /= length;
    }
}

static void run_brute(brute_t *b, const camera_t *cam, brute_times_t *best) {
    double view[3][3], ink;
    view_of(cam, view);
    const double t0 = now();
    brute_view(b, view);
    const double t1 = now();
    best->pieces = brute_hide(b, &ink);
    const double t2 = now();
    best->map = fmin(best->map, t1 - t0);
    best->hide = fmin(best->hide, t2 - t1);
}

static double before_ms, before_edges;
static const char *before_name = "";

static int bench(const char *name, int k, solid_ref_t *body) {
    mesh_t made;
    const mesh_t *mesh = &made;
    solid_scene_mesh(body, &made);
    size_t bytes = solid_bytes(&mesh, 1), more = convex_bytes(mesh->faces, mesh->corners, mesh->segments);
    more += ONCE_BYTES(mesh->corners);
    void *mem = malloc(bytes), *place = malloc(SOLID_MAP_BYTES(mesh->nv)), *kernel = malloc(more);
    double best[5] = {1e9, 1e9, 1e9, 1e9, 1e9};
    int64_t ink = 0;
    solid_t solid = {0};
    hidden_stats_t stats = {0};
    settings_t set;
    settings_default(&set);
    set.view.rot_x = num_from_i64(65);
    int err = 0;
    brute_t *brute = NULL;
    brute_times_t times = {1e9, 1e9, 0};
    const int runs = mesh->faces < 1000 ? RUNS_MOST : RUNS;
    for (int run = 0; run < runs && !err; run++) {
        camera_t cam;
        solid_map_t map;
        const ink_sink_t sink = {&ink, drop};
        once_t once;
        double t[6] = {now()};
        err = solid_build(&solid, &mesh, 1, mem, bytes);
        t[1] = now();
        view_box_t box = {.solid = true};
        memcpy(box.lo, solid.lo, sizeof box.lo);
        memcpy(box.hi, solid.hi, sizeof box.hi);
        if (!err) err = camera_setup(&cam, &set, &box);
        t[2] = now();
        if (!err) err = solid_map_setup(&map, &solid, &cam, place);
        t[3] = now();
        if (!err) err = once_build(&once, &map, false, false, kernel, more);
        t[4] = now();
        const ink_sink_t seen = once_seen(&once, sink);
        const hidden_job_t job = {.mem = (char *)kernel + once.bytes, .bytes = more - once.bytes, .sink = &seen};
        if (!err) err = convex_draw(&map, NULL, &job, &stats);
        if (!err) err = once_finish(&once);
        t[5] = now();
        for (int i = 0; i < 5; i++) best[i] = fmin(best[i], t[i + 1] - t[i]);
        if (run == 0 && strcmp(name, "cubes") == 0) brute = brute_new(&solid);
        if (brute && !err) run_brute(brute, &cam, &times);
    }
    double total = best[0] + best[1] + best[2] + best[3] + best[4], edges = (double)stats.edges;
    if (!err) {
        printf("solids %-6s %5d  faces %6d  edges %7.0f  build %8.4f  view %6.4f  map %7.4f  once %7.4f  hide %8.4f  "
               "total %8.4f ms",
               name, k, (int)mesh->faces, edges, best[0], best[1], best[2], best[3], best[4], total);
        if (strcmp(name, before_name) == 0) printf("  growth %.2f", log(total / before_ms) / log(edges / before_edges));
        printf("  pairs %lld  pieces %lld  bytes %zu + %zu\n", (long long)stats.tests, (long long)stats.pieces,
               solid.bytes, stats.bytes);
        const double theirs = times.map + times.hide, ours = best[2] + best[4];
        if (brute)
            printf("brute  %-6s %5d  map %6.4f  hide %7.4f  map + hide %7.4f ms, ours %7.4f, %.2f of it  pieces %d\n",
                   name, k, times.map, times.hide, theirs, ours, ours / theirs, (int)times.pieces);
    }
    brute_free(brute);
    before_ms = total;
    before_edges = edges;
    before_name = name;
    free(mem);
    free(place);
    free(kernel);
    solid_scene_mesh_free(&made);
    solid_ref_free(body);
    return err;
}

int main(int argc, char **argv) {
    solid_ref_t body = {0};
    int err = 0;
    for (int i = 1; i < argc && !err; i++) {
        solid_body_cubes(&body, atoi(argv[i]));
        err = bench("cubes", atoi(argv[i]), &body);
    }
    solid_body_round(&body, TRIANGLE_ROWS, 2.5);
    if (!err) err = bench("torus", TRIANGLE_ROWS, &body);
    solid_body_round(&body, TRIANGLE_ROWS, 0);
    if (!err) err = bench("ball", TRIANGLE_ROWS, &body);
    for (int k = 1; k <= 4 && !err; k *= 2) {
        solid_body_knot(&body, 240 * k, 12 * k);
        err = bench("knot", 240 * k, &body);
    }
    for (int k = 30; k <= 120 && !err; k *= 2) {
        solid_body_angles(&body, k);
        err = bench("angles", k, &body);
    }
    if (err) fprintf(stderr, "bench_solids: error %d\n", err);
    return err != 0;
}
