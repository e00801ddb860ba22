/* report_pareto - for every kernel error against time as its bits are varied, a front for each family of scenes, and
 * what of it is shipped and why.
 *
 *     report_pareto DIR      reads the rows that report_error, solid_bits and boards.sh left in DIR (lattice.tsv,
 * lattice-times.tsv, solids-bits.tsv, solids-bits-times.tsv, boards.tsv), writes DIR/pareto.svg, DIR/pareto-boards.svg
 * and the section on stdout */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/report/figure.h"

#define POINTS 256
#define FLOOR 1e-3  /* steps: what is drawn as 0 */
#define RIGHT .2501 /* steps: errors up to here are right */

typedef struct point {
    char kernel[24], family[24], label[12];
    double bits, error, ns, bytes;
    double cycles; /* of an RP2040; 0: not counted */
} point_t;

static point_t point[POINTS];
static int points;

static const struct {
    const char *name;
    double shipped; /* bits below a step */
    const char *element, *why;
} kernels[] = {
    {"perimeter", 15, "facet",
     "It is the default for surfaces. 15 bits are all that vertices of two 32-bit words and products of 64 hold; with "
     "fewer the same words would be compared, so nothing is gained, and a word of 16 has no bit left below a step."},
    {"windows", 15, "facet",
     "The perimeter's bits, since they share horizons; it is taken where a surface has holes, or there are several, "
     "and "
     "only there."},
    {"horizon", 15, "segment",
     "The perimeter's bits again. It is there for profiles that are no grid's (terrains of triangles, `set hidden3d "
     "horizon`): it holds no rows of heights."},
    {"convex", 14, "edge",
     "It is the default for solids: edges against bodies, no polygon is clipped. 14 bits are what differences of 29, "
     "normals of 58 and determinants of 126 bits leave."},
    {"area", 14, "face",
     "Slower by an order of magnitude and right on the same lattice, for what needs visible polygons: hatching, "
     "shadows, "
     "translucency. Nobody gets it who does not ask for it."},
    {"halo", 8.68, "edge",
     "The lattice of the page, since the paper's method decides on the page: no map to another one, and 32-bit words "
     "with products of 64."},
    {"clip", 8.68, "vertex",
     "The lattice of the page for the same reason. Its error is an area, that which is missing or false over the "
     "length "
     "of the border, so even a lattice of steps is a tenth of a step off; crossings are rounded to it."},
};
#define KERNELS ((int)(sizeof kernels / sizeof *kernels))

/* The number in the column that the header calls so; NAN where there is none. */
static double field(char *head, char *line, const char *name, char text[24]) {
    char *at = NULL, *to = NULL;
    int column = -1, k = 0;
    double v = NAN;
    char copy[2][512];
    snprintf(copy[0], sizeof copy[0], "%s", head);
    snprintf(copy[1], sizeof copy[1], "%s", line);
    for (char *t = strtok_r(copy[0], "\t\n", &at); t; t = strtok_r(NULL, "\t\n", &at), k++)
        if (!strcmp(t, name)) column = k;
    k = 0;
    for (char *t = strtok_r(copy[1], "\t\n", &to); t; t = strtok_r(NULL, "\t\n", &to), k++)
        if (k == column) {
            if (text) snprintf(text, 24, "%s", t);
            v = strcmp(t, "-") ? strtod(t, NULL) : NAN;
        }
    return v;
}

static FILE *open_table(const char *dir, const char *name, char head[512]) {
    char path[512];
    snprintf(path, sizeof path, "%s/%s", dir, name);
    FILE *f = fopen(path, "r");
    if (f && fgets(head, 512, f)) return f;
    fprintf(stderr, "report_pareto: %s is missing: `make report` writes it\n", path);
    exit(1);
}

static void load(const char *dir, const char *errors, const char *times) {
    char head[2][512], line[2][512];
    FILE *f[2] = {open_table(dir, errors, head[0]), open_table(dir, times, head[1])};
    /* Both have the same rows in the same order. */
    while (fgets(line[0], sizeof line[0], f[0]) && fgets(line[1], sizeof line[1], f[1])) {
        point_t *p = &point[points];
        char other[24];
        if (points == POINTS) abort();
        field(head[0], line[0], "kernel", p->kernel);
        field(head[0], line[0], "family", p->family);
        p->bits = field(head[0], line[0], "bits", NULL);
        p->error =
            fmax(fmax(field(head[0], line[0], "missing_steps", NULL), field(head[0], line[0], "false_steps", NULL)),
                 field(head[0], line[0], "end_steps", NULL));
        p->bytes = field(head[0], line[0], "bytes", NULL);
        p->ns = field(head[1], line[1], errors[0] == 'l' ? "ns_per_facet" : "ns_per_element", NULL);
        field(head[1], line[1], "family", other);
        if (strcmp(p->family, other) || p->bits != field(head[1], line[1], "bits", NULL)) {
            fprintf(stderr, "report_pareto: rows of %s and %s do not belong together\n", errors, times);
            exit(1);
        }
        snprintf(p->label, sizeof p->label, "%.3g", p->bits);
        points++;
    }
    fclose(f[0]);
    fclose(f[1]);
}

/* The boards' rows have the same families, in scenes that they have room for. */
static void load_boards(const char *dir) {
    char head[512], line[512], kernel[24], family[24];
    FILE *f = open_table(dir, "boards.tsv", head);
    while (fgets(line, sizeof line, f)) {
        field(head, line, "what", kernel);
        field(head, line, "of", family);
        const double bits = field(head, line, "bits", NULL), elements = field(head, line, "elements", NULL);
        for (point_t *p = point; p < point + points && elements > 0; p++)
            if (!strcmp(p->kernel, kernel) && !strcmp(p->family, family) && fabs(p->bits - bits) < .01)
                p->cycles = field(head, line, "rp2040_cycles", NULL) / elements;
    }
    fclose(f);
}

static bool is_of(const point_t *p, int k, double bits) {
    return !strcmp(p->kernel, kernels[k].name) && fabs(p->bits - bits) < .01;
}

/* Over all families: the largest error and the mean time. */
typedef struct summary {
    double error, ns, bytes;
    int families;
} summary_t;

static summary_t sum(int k, double bits) {
    summary_t s = {0};
    for (const point_t *p = point; p < point + points; p++)
        if (is_of(p, k, bits)) {
            s.error = fmax(s.error, p->error);
            s.bytes = fmax(s.bytes, p->bytes);
            s.ns += p->ns;
            s.families++;
        }
    if (s.families) s.ns /= s.families;
    return s;
}

static void draw(figure_t *f, int k, bool board) {
    static char title[2][KERNELS][72], x_title[2][KERNELS][48];
    const char *family = "";
    int series = 0;
    snprintf(title[board][k], sizeof title[board][k], "%s: error against %s (bits below a step; ring: shipped)",
             kernels[k].name, board ? "cycles" : "time");
    snprintf(x_title[board][k], sizeof x_title[board][k], board ? "RP2040 cycles per %s" : "CPU time per %s (ns)",
             kernels[k].element);
    figure_init(f, title[board][k], x_title[board][k], "worst error (steps)");
    f->y_log = f->front = true;
    f->y_line = 1;
    f->y_floor = FLOOR;
    for (int at = 0; at < points; at++) {
        point_t *p = &point[at];
        if (strcmp(p->kernel, kernels[k].name) || (board && p->cycles <= 0)) continue;
        /* The rows of a family need not follow one another. */
        if (strcmp(family, p->family)) {
            for (series = 0; series < f->series && strcmp(f->name[series], p->family);) series++;
            if (series == f->series) figure_series(f, p->family);
            family = p->family;
        }
        figure_add(f, series, board ? p->cycles : p->ns, p->error, p->label);
        if (is_of(p, k, kernels[k].shipped)) figure_mark(f);
    }
}

/* Height errors (formats.tsv) over what a point costs on a Cortex-M0 (boards.tsv), where both have the expression. */
static void draw_formats(const char *dir, figure_t *f) {
    static char name[8][24], label[64][24];
    char head[2][512], line[2][512], of[24], what[24];
    int labels = 0;
    FILE *boards = open_table(dir, "boards.tsv", head[0]);
    figure_init(f, "expressions: height error against cost of a point (ring: shipped)",
                "Cortex-M0 instructions per point", "largest height error (steps)");
    f->y_log = f->x_log = f->front = true;
    f->y_line = 1;
    f->y_floor = 1e-13;
    while (fgets(line[0], sizeof line[0], boards)) {
        const double cost =
            field(head[0], line[0], "m0_instructions", what) / field(head[0], line[0], "elements", NULL);
        field(head[0], line[0], "what", what);
        field(head[0], line[0], "of", of);
        FILE *formats = open_table(dir, "formats.tsv", head[1]);
        while (fgets(line[1], sizeof line[1], formats)) {
            char expression[24], format[24];
            field(head[1], line[1], "expression", expression);
            field(head[1], line[1], "format", format);
            const bool shipped = !strncmp(format, "shipped", 7);
            if (strcmp(of, expression) || strcmp(shipped ? "num_t" : format, what)) continue;
            int series = 0;
            while (series < f->series && strcmp(f->name[series], of)) series++;
            if (series == f->series) {
                if (series == 8) abort();
                snprintf(name[series], sizeof name[series], "%s", of);
                figure_series(f, name[series]);
            }
            if (labels == 64) abort();
            snprintf(label[labels], sizeof label[labels], "%s", what);
            figure_add(f, series, cost, field(head[1], line[1], "height_error_steps", NULL), label[labels++]);
            if (shipped) figure_mark(f);
        }
        fclose(formats);
    }
    fclose(boards);
}

/* The least bits with which every family is right, and the fastest ones. */
static void tell(int k) {
    const summary_t ours = sum(k, kernels[k].shipped), none = sum(k, 0);
    double least = kernels[k].shipped, fastest = least, ns = ours.ns;
    for (const point_t *p = point; p < point + points; p++) {
        if (strcmp(p->kernel, kernels[k].name)) continue;
        const summary_t s = sum(k, p->bits);
        if (s.error > RIGHT) continue;
        least = fmin(least, p->bits);
        if (s.ns < ns) ns = s.ns, fastest = p->bits;
    }
    printf(
        "- **%s: %.3g bits shipped**, worst error %.2f steps in %d families, %.0f bytes at most. With none it is %.*f "
        "steps, and from %.3g on right (a quarter step or less). ",
        kernels[k].name, kernels[k].shipped, ours.error, ours.families, ours.bytes, none.error < 10 ? 2 : 0, none.error,
        least);
    printf("%s\n", kernels[k].why);
    double from = INFINITY, to = 0;
    for (const point_t *p = point; p < point + points; p++) {
        if (!is_of(p, k, kernels[k].shipped) || p->cycles <= 0) continue;
        for (const point_t *q = point; q < point + points; q++) {
            if (q == p || q->cycles <= 0 || strcmp(q->kernel, p->kernel) || strcmp(q->family, p->family)) continue;
            from = fmin(from, 100 * q->cycles / p->cycles);
            to = fmax(to, 100 * q->cycles / p->cycles);
        }
    }
    if (to > 0)
        printf("  With 0 to 8 bits a Pico would need %.0f to %.0f %% of the cycles per %s that it needs as shipped.\n",
               from, to, kernels[k].element);
    printf("  (Times: %.0f ns per %s as shipped; the fastest that is right takes %.0f, with %.3g.)\n", ours.ns,
           kernels[k].element, ns, fastest);
}

int main(int argc, char **argv) {
    static figure_t f[KERNELS + 1], on_board[KERNELS];
    char path[512];
    if (argc < 2) return 2;
    load(argv[1], "lattice.tsv", "lattice-times.tsv");
    load(argv[1], "solids-bits.tsv", "solids-bits-times.tsv");
    load_boards(argv[1]);
    printf(
        "\n## What is shipped, and why\n\nError against time as the bits below a step are varied, for each kernel and "
        "family of scenes. A line goes through what nothing of the same family beats in both; what has no error is at "
        "the bottom. Tolerances of horizons: above, under simpler horizons; formats of expressions and sizes of "
        "grids: in their sections.\n\n![error against time](pareto.svg)\n\nThe same "
        "against the cycles of an RP2040; all rows, with the Cortex-M0 and M3, are in [boards.md](boards.md).\n\n"
        "![error against cycles](pareto-boards.svg)\n\n");
    for (int k = 0; k < KERNELS; k++) {
        draw(&f[k], k, false);
        draw(&on_board[k], k, true);
        tell(k);
    }
    printf(
        "\nTimes of a kernel differ between numbers of bits only by what else is then drawn, and by the noise of the "
        "machine: nothing is bought with bits that are left out. A Cortex-M0 has no divider and multiplies 32 bits in "
        "software where they become 64: shorter numbers help it a little where windows are cut, which is no reason "
        "for a lattice of their own, since they share their horizons.\n");
    draw_formats(argv[1], &f[KERNELS]);
    snprintf(path, sizeof path, "%s/pareto.svg", argv[1]);
    figure_write_panels(f, KERNELS + 1, 2, path);
    snprintf(path, sizeof path, "%s/pareto-boards.svg", argv[1]);
    figure_write_panels(on_board, KERNELS, 2, path);
    return 0;
}
