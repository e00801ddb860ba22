/* Haloed lines: CUT over the paper's table of random edges (Franklin & Akman 1987, section 4) and on to a million, and
 * CUT and DRAW over Figure 4, 28 x 28 cubes (tests/oracle/halo_scenes.h). CPU time, the least of several runs. */
#include "tests/bench/peers/plain_grid.h"
#include "tests/oracle/halo_scenes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#define PAGE HALO_SCENE_PAGE

static double now_ns(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}

static int count_piece(void *ctx, int32_t id, uint32_t from, uint32_t to) {
    int64_t *sum = ctx;
    (void)id;
    sum[0]++;
    sum[1] += to - from;
    return 0;
}

typedef struct times {
    double cut_ns, draw_ns;
    int64_t crossings, tests, pieces;
    size_t bytes;
} times_t;

/* The least of some runs. CUT sorts the edges, so each run begins with the edges as they were given. */
static times_t measure(const halo_edge_t *edge, int32_t n, int32_t width, void *mem, size_t bytes) {
    times_t best = {1e30, 1e30, 0, 0, 0, 0};
    double spent = 0;
    for (int run = 0; run < 200 && (run < 5 || spent < 3e8); run++) {
        halo_t h;
        int64_t sum[2] = {0, 0};
        halo_init(&h, mem, bytes);
        for (int32_t i = 0; i < n; i++) halo_add(&h, edge[i].id, edge[i].p, edge[i].q);
        double start = now_ns();
        if (halo_cut(&h, 0)) exit(1);
        double cut = now_ns();
        halo_draw(&h, width, &(halo_sink_t){sum, count_piece});
        double drawn = now_ns();
        if (cut - start < best.cut_ns) best.cut_ns = cut - start;
        if (drawn - cut < best.draw_ns) best.draw_ns = drawn - cut;
        best.crossings = h.crossings;
        best.tests = h.tests;
        best.bytes = h.used;
        best.pieces = sum[0];
        spent += drawn - start;
    }
    return best;
}

/* The least time of the plain grid. */
static double measure_plain(const halo_edge_t *edge, int n, double length, int64_t *crossings) {
    plain_edge_t *e = malloc((size_t)n * sizeof *e);
    double best = 1e30, spent = 0;
    for (int i = 0; i < n; i++)
        e[i] = (plain_edge_t){(double)edge[i].p.x / PAGE, (double)edge[i].p.y / PAGE, (double)edge[i].q.x / PAGE,
                              (double)edge[i].q.y / PAGE};
    for (int run = 0; run < 100 && (run < 3 || spent < 2e8); run++) {
        const double start = now_ns();
        *crossings = plain_grid(e, n, length);
        const double took = now_ns() - start;
        if (took < best) best = took;
        spent += took;
    }
    free(e);
    return best;
}

static void table(void *mem, size_t bytes, halo_edge_t *edge) {
    static const struct {
        int32_t n;
        double length;
    } row[] = {
        {100, .1},     {300, .1},     {1000, .01},  {1000, .03},    {1000, .1},           {3000, .01},   {3000, .03},
        {3000, .1},    {10000, .003}, {10000, .01}, {10000, .03},   {30000, .001},        {30000, .003}, {30000, .01},
        {50000, .001}, {50000, .003}, {50000, .01}, {200000, .005}, {1000000, .00223607},
    };
    printf("%9s %8s %10s %8s %8s %8s %8s %8s\n", "edges", "length", "crossings", "tests/e", "bytes/e", "CUT ns/e",
           "DRAW", "plain");
    double at_50000[2] = {0, 0};
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        const double l = row[k].length;
        halo_scene_random(edge, row[k].n, l);
        const double n = row[k].n;
        int64_t others;
        times_t t = measure(edge, row[k].n, (int32_t)(.02 * l * PAGE), mem, bytes);
        double plain = measure_plain(edge, row[k].n, l, &others);
        printf("%9d %8.4g %10lld %8.2f %8.1f %8.1f %8.1f %8.1f%s\n", row[k].n, l, (long long)t.crossings,
               (double)t.tests / n, (double)t.bytes / n, t.cut_ns / n, t.draw_ns / n, plain / n,
               llabs(others - t.crossings) > 2 + t.crossings / 1000 ? " differs" : "");
        fflush(stdout);
        if (row[k].n == 50000 && l == .01) at_50000[0] = t.cut_ns, at_50000[1] = plain;
        if (row[k].n == 1000000)
            printf("growth from 50,000/.01 to 1,000,000: %.3f, plain %.3f\n", log(t.cut_ns / at_50000[0]) / log(20),
                   log(plain / at_50000[1]) / log(20));
    }
}

static void cubes(int k, void *mem, size_t bytes, halo_edge_t *edge) {
    const int32_t n = 12 * k * k;
    const double scale = halo_scene_cubes(edge, k);
    times_t t = measure(edge, n, (int32_t)(.05 * scale), mem, bytes);
    printf("%2d x %2d cubes, %d edges, %lld crossings: CUT %.3f ms, DRAW %.3f ms (%lld pieces)\n", k, k, n,
           (long long)t.crossings, t.cut_ns * 1e-6, t.draw_ns * 1e-6, (long long)t.pieces);
}

int main(void) {
    const size_t bytes = HALO_BYTES(1000000, 3000000);
    void *mem = malloc(bytes);
    halo_edge_t *edge = malloc(1000000 * sizeof *edge);
    if (mem == NULL || edge == NULL) return 1;
    cubes(28, mem, bytes, edge);
    table(mem, bytes, edge);
    free(edge);
    free(mem);
    return 0;
}
