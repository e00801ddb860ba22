/* report_solids - solids, haloes and polygons: error, work and time over sizes.
 *
 *     report_solids DIR [--quick]      writes DIR/solids.tsv, solids-times.tsv, and the section on stdout
 *
 * What is drawn and how it is judged: solid_rows.c. "-" stands for what is not judged. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/report/create.h"
#include "tests/report/solid_rows.h"

static const char *number(double v, char *text) {
    if (isnan(v)) return "-";
    snprintf(text, 16, "%.3f", v);
    return text;
}

static void write_rows(FILE *out, FILE *times) {
    fputs("kernel\tfamily\tsize\tlattice_per_step\tscenes\twrong\telements\tmissing_steps\tfalse_steps\tend_steps\t"
          "tests\tcrossings\tpieces\tagain\tbytes\n",
          out);
    fputs("kernel\tfamily\tsize\tlattice_per_step\tns_per_element\n", times);
    puts("| kernel | family | size | lattice | scenes (wrong) | elements | missing | false | end | tests | crossings | "
         "pieces | again | bytes | ns per element |\n"
         "|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|");
    for (const row_t *w = row; w < row + rows; w++) {
        char m[16], f[16], e[16], l[16];
        const double steps[] = {w->missing, w->falsely, w->end}, n = (double)(w->elements ? w->elements : 1);
        const char *text[] = {number(steps[0], m), number(steps[1], f), number(steps[2], e), number(w->per_step, l)};
        fprintf(out, "%s\t%s\t%d\t%s\t%" PRId64 "\t%" PRId64 "\t%" PRId64 "\t%s\t%s\t%s", w->kernel, w->family, w->size,
                text[3], w->scenes, w->wrong, w->elements, text[0], text[1], text[2]);
        printf("| %s | %s | %d | %s | %" PRId64 " (%" PRId64 ") | %" PRId64 " | %s | %s | %s", w->kernel, w->family,
               w->size, text[3], w->scenes, w->wrong, w->elements, text[0], text[1], text[2]);
        for (int k = 0; k < 4; k++) {
            fprintf(out, "\t%" PRId64, w->work[k]);
            printf(" | %" PRId64, w->work[k]);
        }
        fprintf(out, "\t%zu\n", w->bytes);
        fprintf(times, "%s\t%s\t%d\t%s\t%.1f\n", w->kernel, w->family, w->size, text[3], 1e9 * w->seconds / n);
        printf(" | %zu | %.0f |\n", w->bytes, 1e9 * w->seconds / n);
    }
}

/* Exponents over the elements, from the second smallest to the largest size of a family of single scenes: those of the
 * smallest are the fixed costs. */
static void write_growth(void) {
    puts("\nGrowth from a family's second size to its last, as exponents over the elements:\n\n"
         "| kernel | family | tests | time |\n|---|---|--:|--:|");
    for (int first = 0, last; first < rows; first = last + 1) {
        for (last = first; last + 1 < rows && !strcmp(row[last + 1].kernel, row[first].kernel) &&
                           !strcmp(row[last + 1].family, row[first].family);)
            last++;
        const row_t *a = &row[first + 1], *b = &row[last];
        if (last < first + 2 || a->scenes > 1 || a->elements == b->elements) continue;
        const double over = log((double)b->elements / (double)a->elements);
        printf("| %s | %s | %.2f | %.2f |\n", a->kernel, a->family, log((double)b->work[0] / (double)a->work[0]) / over,
               log(b->seconds / a->seconds) / over);
    }
}

static const row_t *find(const char *kernel, const char *family, int size) {
    for (const row_t *w = row; w < row + rows; w++)
        if (!strcmp(w->kernel, kernel) && !strcmp(w->family, family) && w->size == size) return w;
    abort();
}

/* Why each of them is there; k: the cubes to compare. */
static void write_verdict(int k) {
    printf("\n**Shipped: all four.** The convex kernel draws edges in 1/%.0f of the area sort's time (%d x %d cubes), "
           "which is there for what only polygons can say: shadows and hatching.\n",
           find("area", "cubes", k)->seconds / find("convex", "cubes", k)->seconds, k, k);
}

int main(int argc, char **argv) {
    if (argc < 2) return 2;
    const bool quick = argc > 2 && strcmp(argv[2], "--quick") == 0;
    FILE *out = report_create(argv[1], "solids.tsv"), *times = report_create(argv[1], "solids-times.tsv");
    solid_rows_measure(quick);
    puts(
        "\n## Solids, haloes, polygons\n\n"
        "Elements: edges (convex, halo), faces that look at the eye (area sort), vertices (clip). Errors are in steps, "
        "the longest of all scenes: of the clipper, the area that is missing or false over the length of the borders. "
        "Lattice: units in a step where it can be chosen. Tests: pairs of edge and object, pairs of polygons clipped, "
        "pairs of edges, edges of the graph. Crossings: found; pieces removed by the area sort. Pieces: given to the "
        "sink, polygons, contours. Again: sort errors, sweeps. Bytes: used; of area sort and clipper, lent. Random: up "
        "to so "
        "many solids, needles, sheets and broken meshes, anywhere and touching; "
        "for the area sort without those whose faces cut through each other. Spiky stars have crossings as the square "
        "of their rays.\n");
    write_rows(out, times);
    write_growth();
    write_verdict(quick ? 4 : 28);
    fclose(out);
    fclose(times);
    return 0;
}
