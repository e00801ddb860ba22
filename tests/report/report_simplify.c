/* report_simplify - error against speed as the horizons are simplified.
 *
 *     report_simplify DIR      writes DIR/simplify.tsv, simplify-times.tsv, simplify.svg, and the section on stdout
 *
 * A vertex that lies within a tolerance of the line between its neighbours is taken out as soon as the clip that made
 * it is over (lattice.c). What is shipped never does that: a vertex goes when something rises above it, and not before.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "tests/report/create.h"
#include "tests/report/figure.h"
#include "tests/report/lattice.h"
#include "tests/report/subject.h"

#define N 60
#define EVERY 4

static const double tolerance[] = {0, 1 / 256., 1 / 64., 1 / 16., 1 / 4., 1, 4}; /* steps */
#define TOLERANCES ((int)(sizeof tolerance / sizeof *tolerance))

typedef struct total {
    judge_report_t error;
    double vertices, windows, tests, facets, ns[FAMILIES];
    size_t bytes; /* the most of a family */
} total_t;

static int by_size(const void *a, const void *b) {
    const double *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

static void measure(enum subject_kernel kernel, double steps, total_t *t) {
    for (int m = 0; m < FAMILIES; m++) {
        subject_t u;
        judge_report_t r;
        hidden_stats_t st;
        lattice_simplify = (int)(steps * (1 << LATTICE_SHIPPED));
        subject_make(&u, kernel, (enum subject_family)m, N);
        if (subject_judge(&u, EVERY, &r, &st)) abort();
        judge_worst(&t->error, &r);
        t->vertices += st.peak_upper + st.peak_lower;
        t->windows += st.windows;
        if (st.bytes > t->bytes) t->bytes = st.bytes;
        t->tests += (double)st.tests;
        t->facets += (double)st.facets;
        t->ns[m] = subject_ns(&u);
        subject_free(&u);
        lattice_simplify = 0;
    }
    qsort(t->ns, FAMILIES, sizeof *t->ns, by_size);
}

int main(int argc, char **argv) {
    static figure_t f;
    static char label[TOLERANCES][16];
    char path[512];
    total_t shipped = {0}, at_step = {0};
    if (argc < 2) return 2;
    FILE *out = report_create(argv[1], "simplify.tsv"), *times = report_create(argv[1], "simplify-times.tsv");
    figure_init(&f, "Simpler horizons: error against time (tolerance in steps)", "CPU time per facet (ns)",
                "worst error (steps)");
    f.x_log = f.y_log = true;
    f.y_line = 1;
    fputs("kernel\tn\ttolerance_steps\tmissing_steps\tfalse_steps\tend_steps\tpeak_vertices\tpeak_windows\ttests_per_"
          "facet\tbytes\n",
          out);
    fputs("kernel\tn\ttolerance_steps\tns_per_facet\n", times);
    printf("\n## Simpler horizons\n\nA vertex nearer than a tolerance to the line of its neighbours leaves the "
           "horizon; what is "
           "left of a window that a facet cuts is closed if it is no higher than that. %d x %d points, the worst of "
           "the five "
           "families, vertices and windows at peak on average, the most bytes.\n\n"
           "| kernel | tolerance (steps) | longest missing | longest false | largest end displacement | vertices | "
           "windows | tests per facet | bytes | median ns per facet |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n",
           N, N);
    for (int k = 0; k < KERNELS; k++) {
        const char *name = subject_kernel_name[(enum subject_kernel)k];
        int series = figure_series(&f, name);
        for (int i = 0; i < TOLERANCES; i++) {
            total_t t = {0};
            measure((enum subject_kernel)k, tolerance[i], &t);
            if (k == 0 && i == 0) shipped = t;
            if (k == 0 && tolerance[i] == 1) at_step = t;
            double missing = t.error.missing_mm / JUDGE_STEP_MM, falsely = t.error.false_mm / JUDGE_STEP_MM;
            double vertices = t.vertices / FAMILIES, tests = t.tests / t.facets, ns = t.ns[FAMILIES / 2];
            fprintf(out, "%s\t%d\t%g\t%.3f\t%.3f\t%.3f\t%.0f\t%.0f\t%.3f\t%zu\n", name, N, tolerance[i], missing,
                    falsely, t.error.end_steps, vertices, t.windows / FAMILIES, tests, t.bytes);
            fprintf(times, "%s\t%d\t%g\t%.1f\n", name, N, tolerance[i], ns);
            printf("| %s | %.3g%s | %.2f | %.2f | %.2f | %.0f | %.0f | %.2f | %zu | %.0f |\n", name, tolerance[i],
                   tolerance[i] > 0 ? "" : " (shipped)", missing, falsely, t.error.end_steps, vertices,
                   t.windows / FAMILIES, tests, t.bytes, ns);
            snprintf(label[i], sizeof label[i], "%.3g", tolerance[i]);
            figure_add(&f, series, ns, fmax(fmax(missing, falsely), t.error.end_steps), label[i]);
        }
    }
    printf(
        "\n![error against time](simplify.svg)\n\n**Shipped: none of it.** Nearly all vertices are corners that hide "
        "something: a tolerance of a whole step would take away %.1f %% of the perimeter's, and brings errors of up to "
        "%.2f steps with it. Looking for them takes more time than it saves. Solids, haloes and polygons have no "
        "horizon that could be "
        "simplified.\n",
        100 * (1 - at_step.vertices / shipped.vertices),
        fmax(fmax(at_step.error.missing_mm, at_step.error.false_mm) / JUDGE_STEP_MM, at_step.error.end_steps));
    fclose(out);
    fclose(times);
    snprintf(path, sizeof path, "%s/simplify.svg", argv[1]);
    figure_write(&f, path);
    return 0;
}
