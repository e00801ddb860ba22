/* report_error - error against the bits of the lattice and the size of the grid.
 *
 *     report_error DIR [--quick]     writes DIR/lattice.tsv, sizes.tsv, their figures, and the section on stdout
 *     report_error --cost KERNEL FAMILY N BITS     draws once, to be counted by callgrind
 *
 * Error is told by tests/oracle/judge.h: longest run missing and false, in steps, forgiving one step across; the same
 * without that (`raw`); the largest displacement of an end. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/report/create.h"
#include "tests/report/figure.h"
#include "tests/report/lattice.h"
#include "tests/report/subject.h"

static const int bits_list[] = {0, 2, 4, 6, 8, 12, LATTICE_SHIPPED};
#define BITS ((int)(sizeof bits_list / sizeof *bits_list))

typedef struct outcome {
    judge_report_t error;
    hidden_stats_t stats;
    double ns;
    size_t lent;
    int failed;
} outcome_t;

static double steps(double mm) {
    return mm / JUDGE_STEP_MM;
}

static outcome_t measure(enum subject_kernel kernel, enum subject_family family, int n, int bits, int every) {
    subject_t u;
    outcome_t o;
    lattice_shift = lattice_shift_for(bits);
    subject_make(&u, kernel, family, n);
    o.failed = subject_judge(&u, every, &o.error, &o.stats);
    o.ns = o.failed ? -1 : subject_ns(&u);
    o.lent = u.bytes;
    subject_free(&u);
    lattice_shift = 0;
    return o;
}

static void row(FILE *out, const char *kernel, const char *family, int n, int bits, const outcome_t *o) {
    const judge_report_t *r = &o->error;
    if (o->failed) {
        fprintf(out, "%s\t%s\t%d\t%d\tfailed\n", kernel, family, n, bits);
        return;
    }
    fprintf(out, "%s\t%s\t%d\t%d\t%.3f\t%.3f\t%.3f\t%.3f\t%.3f\t%zu\n", kernel, family, n, bits, steps(r->missing_mm),
            steps(r->false_mm), steps(r->raw_missing_mm), steps(r->raw_false_mm), r->end_steps, o->stats.bytes);
}

static const char head[] =
    "kernel\tfamily\tn\tbits\tmissing_steps\tfalse_steps\traw_missing_steps\traw_false_steps\tend_steps\tbytes\n";

static double worst_of(const judge_report_t *r) {
    return fmax(fmax(steps(r->missing_mm), steps(r->false_mm)), r->end_steps);
}

/* The longest run of missing or false ink and the largest displacement, over the families, for each kernel and bits. */
static void by_bits(const char *dir, int n, int every) {
    FILE *out = report_create(dir, "lattice.tsv"), *times = report_create(dir, "lattice-times.tsv");
    static figure_t f;
    figure_init(&f, "Error against bits of the lattice", "bits below a step", "worst error (steps)");
    f.y_log = f.joined = true;
    f.y_line = 1;
    fputs(head, out);
    fputs("kernel\tfamily\tn\tbits\tns_per_facet\n", times);
    printf(
        "## Bits of the lattice\n\nThe kernels decide on integers. This is what their bits below a step of the plotter "
        "are worth: surfaces of %d x %d points, the worst of the five families (smooth, random, cliffs, grazing, "
        "far), in steps.\n\n"
        "| kernel | bits | longest missing | longest false | largest end displacement | most bytes | median ns per "
        "facet |\n"
        "|---|--:|--:|--:|--:|--:|--:|\n",
        n, n);
    for (int k = 0; k < KERNELS; k++) {
        int series = figure_series(&f, subject_kernel_name[k]);
        for (int b = 0; b < BITS; b++) {
            judge_report_t all = {0};
            double ns[FAMILIES];
            size_t bytes = 0;
            int bits = bits_list[b], failed = 0;
            for (int m = 0; m < FAMILIES; m++) {
                outcome_t o = measure((enum subject_kernel)k, (enum subject_family)m, n, bits, every);
                row(out, subject_kernel_name[k], subject_family_name[m], n, bits, &o);
                fprintf(times, "%s\t%s\t%d\t%d\t%.1f\n", subject_kernel_name[k], subject_family_name[m], n, bits, o.ns);
                if (o.failed)
                    failed++;
                else
                    judge_worst(&all, &o.error);
                ns[m] = o.ns;
                if (o.stats.bytes > bytes) bytes = o.stats.bytes;
            }
            for (int i = 1; i < FAMILIES; i++)
                for (int j = i; j > 0 && ns[j - 1] > ns[j]; j--) {
                    double t = ns[j];
                    ns[j] = ns[j - 1], ns[j - 1] = t;
                }
            printf("| %s | %d%s | %.2f | %.2f | %.2f | %zu | %.0f%s |\n", subject_kernel_name[k], bits,
                   bits == LATTICE_SHIPPED ? " (shipped)" : "", steps(all.missing_mm), steps(all.false_mm),
                   all.end_steps, bytes, ns[FAMILIES / 2], failed ? "; some drawings failed" : "");
            figure_add(&f, series, bits, worst_of(&all), NULL);
        }
    }
    printf(
        "\n![error against bits](lattice.svg)\n\n"
        "**Shipped: %d bits**, all that 32-bit words with products of 64 hold. Fewer would be no faster, as the times "
        "show: a word is a word; a vertex would be smaller only with 16 bits in all, which leave no bit below a step, "
        "and there ink goes missing by hundreds of steps. With 2 bits ends are still off by up to a step; "
        "from 4 on nothing is wrong by more than a fraction of one. The rest is room for lines that are cut a "
        "thousand times, each time rounded, and for scenes that fill only a part of the lattice.\n",
        LATTICE_SHIPPED);
    fclose(out);
    fclose(times);
    char path[512];
    snprintf(path, sizeof path, "%s/lattice.svg", dir);
    figure_write(&f, path);
}

static void by_size(const char *dir, bool quick) {
    static const int size[] = {10, 20, 50, 100, 200};
    FILE *out = report_create(dir, "sizes.tsv"), *times = report_create(dir, "sizes-times.tsv");
    static figure_t f;
    int sizes = quick ? 1 : (int)(sizeof size / sizeof *size);
    char path[512];
    figure_init(&f, "CPU time per facet as shipped", "points along a side", "ns per facet");
    f.x_log = f.y_log = f.joined = true;
    fputs(head, out);
    fputs("kernel\tfamily\tn\tns_per_facet\n", times);
    printf("\n## Sizes, as shipped\n\n"
           "| kernel | family | n | missing | false | end | ns per facet | bytes lent and used |\n"
           "|---|---|--:|--:|--:|--:|--:|--:|\n");
    judge_report_t all = {0};
    for (int k = 0; k < KERNELS; k++)
        for (int m = 0; m < FAMILIES; m++) {
            static char name[KERNELS * FAMILIES][32];
            char *s = name[k * FAMILIES + m];
            snprintf(s, sizeof name[0], "%s, %s", subject_kernel_name[k], subject_family_name[m]);
            int series = figure_series(&f, s);
            for (int i = 0; i < sizes; i++) {
                int n = size[i], every = n >= 200 ? 40 : n >= 100 ? 10 : 0;
                if (k == KERNEL_HORIZON && n >= 100) every *= 2;
                outcome_t o = measure((enum subject_kernel)k, (enum subject_family)m, n, LATTICE_SHIPPED, every);
                row(out, subject_kernel_name[k], subject_family_name[m], n, LATTICE_SHIPPED, &o);
                if (!o.failed)
                    fprintf(times, "%s\t%s\t%d\t%.1f\n", subject_kernel_name[k], subject_family_name[m], n, o.ns);
                if (o.failed) {
                    printf("| %s | %s | %d | does not fit into %zu bytes | | | | |\n", subject_kernel_name[k],
                           subject_family_name[m], n, o.lent);
                    continue;
                }
                figure_add(&f, series, n, o.ns, NULL);
                judge_worst(&all, &o.error);
                printf("| %s | %s | %d | %.2f | %.2f | %.2f | %.0f | %zu |\n", subject_kernel_name[k],
                       subject_family_name[m], n, steps(o.error.missing_mm), steps(o.error.false_mm), o.error.end_steps,
                       o.ns, o.stats.bytes);
            }
        }
    printf(
        "\nWorst of all: %.2f steps missing, %.2f false, an end displaced by %.2f. Of surfaces with 100 points a side "
        "and more some lines are judged, of smaller ones all.\n\n**Shipped as it is**, because the time per facet of "
        "the perimeter and of the "
        "horizon does not grow with the grid, and errors do not either. Holes leave windows between the horizons, a "
        "few "
        "for each vertex of their rims: time and memory go with the rims.\n\n![time against size](sizes.svg)\n",
        steps(all.missing_mm), steps(all.false_mm), all.end_steps);
    fclose(out);
    fclose(times);
    snprintf(path, sizeof path, "%s/sizes.svg", dir);
    figure_write(&f, path);
}

static int cost(char **arg) {
    subject_t u;
    hidden_stats_t stats;
    run_drawing_t d = {0};
    ink_sink_t sink = run_sink(&d);
    int k = 0, m = 0;
    while (k < KERNELS - 1 && strcmp(arg[0], subject_kernel_name[k])) k++;
    while (m < FAMILIES - 1 && strcmp(arg[1], subject_family_name[m])) m++;
    lattice_shift = lattice_shift_for(atoi(arg[3]));
    subject_make(&u, (enum subject_kernel)k, (enum subject_family)m, atoi(arg[2]));
    int err = subject_draw(&u, &sink, &stats);
    printf("%lld\n", (long long)stats.facets);
    run_drawing_free(&d);
    subject_free(&u);
    return err != 0;
}

int main(int argc, char **argv) {
    if (argc == 6 && !strcmp(argv[1], "--cost")) return cost(argv + 2);
    if (argc < 2) return 2;
    bool quick = argc > 2 && !strcmp(argv[2], "--quick");
    by_bits(argv[1], quick ? 8 : 40, quick ? 0 : 4);
    by_size(argv[1], quick);
    return 0;
}
