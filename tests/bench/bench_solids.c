/* bench_solids - solids from meshes in memory to visible ink, counted and dropped: CPU time.
 *
 *     bench_solids K...    k x k unit cubes, pitch 1.5, 25 degrees above the ground (the scene of Franklin & Akman's
 *                          figure 4), then a torus and a ball of some 5,800 triangles, closed and not taken as convex
 *
 * build: meshes become vertices, edges, objects (solid_build); map: the view (camera, solid_map_setup); hide: the
 * kernel. The least of several runs. Growth: the exponent of the time over the number of edges, from the size before.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "hidden/convex.h"

#define RUNS 15
#define TRIANGLE_ROWS 54

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return 1e3 * (double)t.tv_sec + 1e-6 * (double)t.tv_nsec;
}

static packed_t packed(double v) {
    packed_t p;
    memcpy(&p, &v, sizeof p); /* packed.h: binary64 */
    return p;
}

typedef struct scene {
    mesh_t mesh;
    packed_t (*vertex)[3];
    int32_t *words, *at;
} scene_t;

static void scene_start(scene_t *s, int vertices, int words) {
    *s = (scene_t){.vertex = malloc((size_t)vertices * sizeof *s->vertex),
                   .words = malloc((size_t)words * sizeof *s->words)};
    if (!s->vertex || !s->words) abort();
    s->at = s->words + words;
    s->mesh.top = s->at;
    s->mesh.vertex = (const packed_t(*)[3])s->vertex;
}

static int vertex(scene_t *s, double x, double y, double z) {
    packed_t *v = s->vertex[s->mesh.nv];
    v[0] = packed(x);
    v[1] = packed(y);
    v[2] = packed(z);
    return s->mesh.nv++;
}

static void face(scene_t *s, const int *v, int n) {
    *--s->at = n << 2 | MESH_FACE;
    for (int k = 0; k < n; k++) *--s->at = v[k];
    s->mesh.faces++;
    s->mesh.corners += n;
    s->mesh.words += n + 1;
}

static void cubes(scene_t *s, int k) {
    static const int side[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    scene_start(s, 8 * k * k, 30 * k * k);
    for (int n = 0; n < k * k; n++) {
        int v[8];
        for (int c = 0; c < 8; c++) v[c] = vertex(s, 1.5 * (n % k) + (c & 1), 1.5 * (n / k) + (c >> 1 & 1), c >> 2);
        for (int f = 0; f < 6; f++) {
            int w[4];
            for (int c = 0; c < 4; c++) w[c] = v[side[f][c]];
            face(s, w, 4);
        }
    }
}

/* n x n quadrilaterals of two triangles round a torus; hole 0: a ball. */
static void round_body(scene_t *s, int n, double hole) {
    int *v = malloc((size_t)(n * n) * sizeof *v);
    if (!v) abort();
    scene_start(s, n * n, 8 * n * n);
    for (int k = 0; k < n * n; k++) {
        double a = 6.283185307179586 * (k % n) / n,
               b = hole > 0 ? 6.283185307179586 * (k / n) / n : 3.141592653589793 * (k / n) / (n - 1);
        double r = hole > 0 ? hole + cos(b) : sin(b), z = hole > 0 ? sin(b) : cos(b);
        v[k] = vertex(s, r * cos(a), r * sin(a), z);
    }
    for (int j = 0; j < (hole > 0 ? n : n - 1); j++)
        for (int i = 0; i < n; i++) {
            int p = v[j * n + i], q = v[j * n + (i + 1) % n], r = v[(j + 1) % n * n + (i + 1) % n],
                t = v[(j + 1) % n * n + i];
            face(s, (int[]){p, q, r}, 3);
            face(s, (int[]){p, r, t}, 3);
        }
    free(v);
}

static int drop(void *ctx, const ink_piece_t *p) {
    int64_t *sum = ctx;
    *sum += p->to_q30 - p->from_q30;
    return 0;
}

static double before_ms, before_edges;

static int bench(const char *name, int k, scene_t *s) {
    const mesh_t *mesh = &s->mesh;
    size_t bytes = solid_bytes(&mesh, 1), more = convex_bytes(mesh->faces, mesh->corners, mesh->segments);
    void *mem = malloc(bytes), *place = malloc(SOLID_MAP_BYTES(mesh->nv)), *kernel = malloc(more);
    double best[3] = {1e9, 1e9, 1e9};
    int64_t ink = 0;
    solid_t solid = {0};
    hidden_stats_t stats = {0};
    settings_t set;
    settings_default(&set);
    set.view.rot_x = num_from_i64(65);
    int err = 0;
    for (int run = 0; run < RUNS && !err; run++) {
        camera_t cam;
        solid_map_t map;
        const ink_sink_t sink = {&ink, drop};
        const hidden_job_t job = {.mem = kernel, .bytes = more, .sink = &sink};
        double t[4] = {now()};
        err = solid_build(&solid, &mesh, 1, mem, bytes);
        t[1] = now();
        view_box_t box = {.solid = true};
        memcpy(box.lo, solid.lo, sizeof box.lo);
        memcpy(box.hi, solid.hi, sizeof box.hi);
        if (!err) err = camera_setup(&cam, &set, &box);
        if (!err) err = solid_map_setup(&map, &solid, &cam, place);
        t[2] = now();
        if (!err) err = convex_draw(&map, NULL, &job, &stats);
        t[3] = now();
        for (int i = 0; i < 3; i++) best[i] = fmin(best[i], t[i + 1] - t[i]);
    }
    double total = best[0] + best[1] + best[2], edges = (double)stats.edges;
    if (!err) {
        printf("solids %-6s %5d  faces %6d  edges %7.0f  build %7.3f  map %6.3f  hide %7.3f  total %7.3f ms", name, k,
               (int)mesh->faces, edges, best[0], best[1], best[2], total);
        if (strcmp(name, "cubes") == 0 && before_edges > 0)
            printf("  growth %.2f", log(total / before_ms) / log(edges / before_edges));
        printf("  pairs %lld  pieces %lld  bytes %zu + %zu\n", (long long)stats.tests, (long long)stats.pieces,
               solid.bytes, stats.bytes);
    }
    before_ms = total;
    before_edges = edges;
    free(mem);
    free(place);
    free(kernel);
    free(s->vertex);
    free(s->words);
    return err;
}

int main(int argc, char **argv) {
    scene_t s;
    int err = 0;
    for (int i = 1; i < argc && !err; i++) {
        cubes(&s, atoi(argv[i]));
        err = bench("cubes", atoi(argv[i]), &s);
    }
    round_body(&s, TRIANGLE_ROWS, 2.5);
    if (!err) err = bench("torus", TRIANGLE_ROWS, &s);
    round_body(&s, TRIANGLE_ROWS, 0);
    if (!err) err = bench("ball", TRIANGLE_ROWS, &s);
    if (err) fprintf(stderr, "bench_solids: error %d\n", err);
    return err != 0;
}
