/* bench_surfaces - the perimeter kernel alone: CPU time per facet over grid size, heights in memory, ink counted and
 * dropped.
 *
 *     bench_surfaces N...        one line for each size and shape: `kernel SHAPE N NS_PER_FACET PIECES BYTES`
 *
 * The scenes of Anderson's Table 1: exp(-x*x-y*y) and uniform random heights on [-2,2]^2, seen from (6,8,3). The median
 * of several runs, each long enough for the clock. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "hidden/surface/perimeter.h"
#include "scene/grid.h"
#include "tests/bench/table1.h"

#define RUNS 5
#define SHORTEST_S 0.02

typedef struct source {
    int n;
    const double *z;
} source_t;

static num_t number(double v) {
    int e;
    double f = frexp(v, &e);
    return num_ldexp(num_from_i64((int64_t)ldexp(f, 53)), e - 53);
}
static num_t at(void *ctx, int32_t i) {
    return number(table1_coordinate(((const source_t *)ctx)->n, i));
}
static num_t z_of(void *ctx, int32_t i, int32_t j) {
    const source_t *s = ctx;
    return number(s->z[(size_t)j * (size_t)s->n + (size_t)i]);
}

static int drop(void *ctx, const ink_piece_t *p) {
    int64_t *sum = ctx;
    *sum += (p->to - p->from) >> 16; /* far from overflow */
    return 0;
}

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int by_value(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static int bench(int n, const char *shape) {
    size_t points = (size_t)n * (size_t)n, bytes = perimeter_bytes(n, 60 * n + 1000);
    double *z = malloc(points * sizeof *z);
    int32_t *cache = malloc(points * sizeof *cache);
    void *mem = malloc(bytes);
    if (!z || !cache || !mem) return 1;
    table1_heights(shape, n, z);
    source_t source = {n, z};
    surface_t surface = {n, n, &source, at, at, z_of, NULL, NULL};
    camera_t cam = {.perspective = true, .eye = {number(6), number(8), number(3)}};
    grid_t g;
    int64_t ink = 0;
    ink_sink_t sink = {&ink, drop};
    hidden_job_t job = {.mem = mem, .bytes = bytes, .sink = &sink};
    hidden_stats_t stats = {0};
    double took[RUNS];
    int err = grid_measure(&g, &surface, NULL, NULL, cache, NULL, NULL);
    for (int run = 0; run < RUNS && !err; run++) {
        double start = now();
        int times = 0;
        do {
            err = perimeter_draw(&g, &cam, &job, &stats);
            times++;
        } while (!err && now() - start < SHORTEST_S);
        took[run] = (now() - start) / times;
    }
    if (!err) {
        qsort(took, RUNS, sizeof *took, by_value);
        printf("kernel %s %d %.1f %lld %zu\n", shape, n, 1e9 * took[RUNS / 2] / ((n - 1.) * (n - 1.)),
               (long long)stats.pieces, stats.bytes);
        fflush(stdout);
    }
    free(z);
    free(cache);
    free(mem);
    return err;
}

int main(int argc, char **argv) {
    int bad = 0;
    for (int i = 1; i < argc; i++) {
        int n = atoi(argv[i]);
        for (int shape = 0; shape < 2; shape++)
            if (n < 2 || bench(n, shape ? "random" : "smooth"))
                bad = fprintf(stderr, "bench_surfaces: n = %d failed\n", n);
    }
    return bad != 0;
}
