/* plmesh - PLplot's surface call alone, on its null device: `plmesh SHAPE N NS_PER_FACET` a line.
 *
 *     plmesh N...
 *
 * A parallel view along the direction of (6,8,3), since PLplot has no perspective. */
#include <plplot.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "tests/bench/table1.h"

#define RUNS 3

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int bench(int n, const char *shape) {
    double *x = malloc((size_t)n * sizeof *x), *y = malloc((size_t)n * sizeof *y);
    double *z = malloc((size_t)n * (size_t)n * sizeof *z);
    PLFLT **rows = malloc((size_t)n * sizeof *rows);
    if (!x || !y || !z || !rows) return 1;
    table1_heights(shape, n, z);
    for (int i = 0; i < n; i++) x[i] = y[i] = table1_coordinate(n, i), rows[i] = z + (size_t)i * (size_t)n;
    double best = 1e30;
    for (int run = 0; run < RUNS; run++) {
        int times = 0;
        double took = 0;
        do {
            pladv(0);
            plvpor(0, 1, 0, 1);
            plwind(-1, 1, -.9, 1.1);
            plw3d(1, 1, 1, -2, 2, -2, 2, 0, 1, 16.7, 37);
            double start = now();
            plmesh(x, y, (const PLFLT *const *)rows, n, n, DRAW_LINEXY);
            took += now() - start;
            times++;
        } while (took < .02);
        if (took / times < best) best = took / times;
    }
    printf("plmesh %s %d %.1f\n", shape, n, 1e9 * best / ((n - 1.) * (n - 1.)));
    fflush(stdout);
    free(x);
    free(y);
    free(z);
    free(rows);
    return 0;
}

int main(int argc, char **argv) {
    int bad = 0;
    plsdev("null");
    plinit();
    for (int i = 1; i < argc; i++) bad |= bench(atoi(argv[i]), "smooth") | bench(atoi(argv[i]), "random");
    plend();
    return bad;
}
