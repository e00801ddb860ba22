/* bench_kernel - what hiding a surface costs, kernel alone: heights are in a cache, ink goes to a counter.
 *
 * Anderson's two surfaces (his Table 1) on [-2,2]^2 seen from (6,8,3): S exp(-x^2-y^2), R uniform random heights.
 * Prints the median of CPU time per facet, what each facet took, and the horizons' peaks. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "hidden/perimeter.h"

typedef struct heights {
    int32_t n;
    double *z;
} heights_t;

static num_t num_of(double v) {
    int e;
    double f = frexp(v, &e);
    return num_from_fixed((int64_t)ldexp(f, 53), 53 - e);
}

static double coordinate(const heights_t *h, int32_t k) {
    return -2 + 4.0 * k / (h->n - 1);
}

static num_t axis_of(void *ctx, int32_t k) {
    return num_of(coordinate(ctx, k));
}

static num_t height_of(void *ctx, int32_t i, int32_t j) {
    heights_t *h = ctx;
    return num_of(h->z[(size_t)j * (size_t)h->n + (size_t)i]);
}

static int count_piece(void *ctx, const ink_piece_t *p) {
    (void)p;
    ++*(int64_t *)ctx;
    return 0;
}

static double seconds(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int ascending(const void *p, const void *q) {
    double a = *(const double *)p, b = *(const double *)q;
    return (a > b) - (a < b);
}

static void bench(int32_t n, int random) {
    heights_t h = {n, malloc((size_t)n * (size_t)n * sizeof(double))};
    int32_t *cache = malloc((size_t)n * (size_t)n * sizeof(int32_t));
    uint64_t rng = 88172645463325252u;
    for (int32_t j = 0; j < n; j++) {
        for (int32_t i = 0; i < n; i++) {
            double x = coordinate(&h, i), y = coordinate(&h, j);
            rng ^= rng << 13, rng ^= rng >> 7, rng ^= rng << 17;
            h.z[(size_t)j * (size_t)n + (size_t)i] = random ? (double)(rng >> 11) * 0x1p-53 : exp(-x * x - y * y);
        }
    }
    surface_t src = {n, n, &h, axis_of, axis_of, height_of};
    grid_t g;
    grid_measure(&g, &src, NULL, NULL, cache, NULL, NULL);
    camera_t cam = {.perspective = true, .eye = {num_from_i64(6), num_from_i64(8), num_from_i64(3)}};
    size_t bytes = perimeter_bytes(n, 40 * n + 2000);
    void *mem = malloc(bytes);
    int64_t pieces = 0;
    ink_sink_t sink = {&pieces, count_piece};
    hidden_job_t job = {mem, bytes, &sink, NULL, NULL};
    hidden_stats_t st = {0};
    double t[101];
    int runs = 0;
    for (double until = seconds() + 0.4; runs < 3 || (runs < 101 && seconds() < until); runs++) {
        double start = seconds();
        int err = perimeter_draw(&g, &cam, &job, &st);
        t[runs] = seconds() - start;
        if (err != 0) printf("error %d\n", err);
    }
    qsort(t, (size_t)runs, sizeof(double), ascending);
    double facets = (double)(n - 1) * (n - 1);
    printf("%5d %s %9.1f ns/facet %9.3f ms  tests %5.2f crossings %5.3f pieces %7lld  peaks %6d %6d  %8zu bytes\n", n,
           random ? "R" : "S", t[runs / 2] * 1e9 / facets, t[runs / 2] * 1e3, (double)st.tests / facets,
           (double)st.crossings / facets, (long long)st.pieces, st.peak_upper, st.peak_lower, st.bytes);
    free(mem);
    free(cache);
    free(h.z);
}

int main(int argc, char **argv) {
    static const int32_t sizes[] = {10, 20, 30, 40, 50, 60, 100, 200, 400, 1000, 2000};
    int32_t most = argc > 1 ? atoi(argv[1]) : 2000;
    for (int random = 0; random < 2; random++) {
        for (size_t k = 0; k < sizeof sizes / sizeof *sizes && sizes[k] <= most; k++) bench(sizes[k], random);
    }
    return 0;
}
