/* The clipper: milliseconds for the intersection of two stars with holes, beside the peers that are installed
 * (bench.mk). The least CPU time of several runs. */
#include "poly/clip.h"
#include "tests/bench/stars.h"
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static double now_ms(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec * 1e3 + (double)t.tv_nsec * 1e-6;
}

static poly_vertex_t *star(int spiky, int which, int n) {
    poly_vertex_t *v = malloc(2 * (size_t)n * sizeof *v);
    if (!v) abort();
    for (int k = 0; k < 2 * n; k++) {
        star_point(spiky, which, k / n, k % n, n, &v[k].at.x, &v[k].at.y);
        v[k].tag = k;
    }
    return v;
}

static void measure(int spiky, int n) {
    const int32_t end[2] = {n, 2 * n};
    poly_vertex_t *v[2] = {star(spiky, 0, n), star(spiky, 1, n)};
    size_t bytes = CLIP_BYTES(4 * n) * (spiky ? 6 : 1);
    int32_t most = 64 * n + 64;
    void *mem = malloc(bytes);
    clip_out_t out = {.v = malloc((size_t)most * sizeof *out.v), .end = malloc((size_t)most * sizeof *out.end)};
    out.n_max = out.contours_max = most;
    if (!mem || !out.v || !out.end) abort();
    const clip_job_t job = {{v[0], end, 2}, {v[1], end, 2}, CLIP_EVEN_ODD, {CLIP_INSIDE, CLIP_NOTHING}};
    clip_t c;
    double best = 1e9, started = now_ms();
    int err = 0;
    const int at_once = n < 1000 ? 1000 / n : 1; /* reading the clock takes .0004 ms */
    for (int k = 0; k < 5 || (k < 20000 && now_ms() - started < 300); k++) {
        double start = now_ms();
        for (int i = 0; i < at_once && !err; i++) {
            out.n = out.contours = 0;
            err = clip_run(&c, &job, mem, bytes);
            if (!err) err = clip_trace(&c, 0, &out);
        }
        double took = (now_ms() - start) / at_once;
        if (took < best) best = took;
        if (err) break;
    }
    const poly_t result = {out.v, out.end, out.contours};
    printf("ridgeline %s %d %.4f %.0f\n", STARS_NAME[spiky], n, best, err ? -1. : (double)poly_area2(&result) / 2);
    fprintf(stderr, "# bench_clip: %s, n=%d: %.4f ms, %.0f ns a vertex; %d crossings, %d sweeps, %d contours\n",
            STARS_NAME[spiky], n, best, best * 1e6 / (4 * n), (int)c.stats.crossings, (int)c.stats.sweeps,
            (int)out.contours);
    for (int k = 0; k < 2; k++) free(v[k]);
    free(mem);
    free(out.v);
    free(out.end);
}

int main(void) {
    for (int spiky = 0; spiky < 2; spiky++)
        for (int k = 0; k < 4 && STARS_N[spiky][k]; k++) measure(spiky, STARS_N[spiky][k]);
    return 0;
}
