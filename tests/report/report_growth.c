/* report_growth - how the work of the polygon area sort grows with polygons, with screen subdivision and without.
 *
 *     report_growth DIR [--quick]      writes DIR/growth.tsv, growth-times.tsv, growth.svg, and the section on stdout
 *
 * K. Weiler and P. Atherton (1977), "Introduction" and "Screen subdivision": the environments that they discuss, and
 * solids. Work is counted, so it is the same everywhere: boxes held against that of a clip polygon, and pairs clipped.
 * Exponents are those of the line through the logarithms, without the smallest size. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/oracle/solid_scenes.h"
#include "tests/report/create.h"
#include "tests/report/figure.h"
#include "tests/report/subject.h"

#define SIZES 4

typedef struct environment {
    const char *name, *expect; /* what the paper expects */
    void (*make)(solid_ref_t *r, int n);
    int size[SIZES];
    int64_t rot_x;
} environment_t;

static void ball(solid_ref_t *r, int n) {
    solid_body_round(r, n, 0);
}

static const environment_t environments[] = {
    {"behind one", "linear", solid_body_covered, {64, 256, 1024, 4096}, 0},
    {"shingles", "square", solid_body_shingles, {64, 256, 1024, 4096}, 0},
    {"woven bars", "more than the square", solid_body_woven, {16, 32, 64, 128}, 0},
    {"cubes", "-", solid_body_cubes, {7, 14, 28, 56}, 65},
    {"ball", "-", ball, {12, 24, 48, 96}, 65},
};
#define ENVIRONMENTS (sizeof environments / sizeof *environments)

static int count(void *ctx, int32_t face, const poly_t *p) {
    (void)face;
    *(int64_t *)ctx += poly_vertices(p);
    return 0;
}
static int no_wire(void *ctx, int32_t edge, int32_t from_q30, int32_t to_q30) {
    (void)ctx, (void)edge, (void)from_q30, (void)to_q30;
    return 0;
}

/* Returns seconds: the least of some runs. */
static double measure(const environment_t *e, int n, bool whole, bool quick, area_stats_t *s, int64_t *vertices) {
    static solid_scene_t scene;
    static solid_stage_t stage;
    solid_ref_t body = {0};
    e->make(&body, n);
    scene.ref = body;
    settings_default(&scene.set);
    scene.set.view.rot_x = num_from_i64(e->rot_x);
    int err = solid_stage_make(&stage, &scene, true);
    const size_t bytes = whole ? 40 * stage.bytes : stage.bytes / 3 * 4 & ~(size_t)7; /* as a picture lends */
    void *mem = malloc(bytes);
    const area_sink_t sink = {
        .ctx = vertices, .polygon = count, .wire = no_wire, .window_faces = whole ? INT32_MAX : 0};
    double best = 1e9, spent = 0;
    if (!mem) abort();
    for (int run = 0; run < (quick ? 1 : 20) && !err && (run < 2 || spent < .3); run++) {
        const double start = subject_clock();
        *vertices = 0;
        err = area_sort(&stage.map, mem, bytes, &sink, NULL, NULL, s);
        best = fmin(best, subject_clock() - start);
        spent += subject_clock() - start;
    }
    free(mem);
    solid_stage_free(&stage);
    solid_ref_free(&body);
    return err ? NAN : best;
}

/* The slope of the line through the points, without the first. */
static double slope(int n, const double *x, const double *y) {
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (int k = 1; k < n; k++) {
        const double a = log(x[k]), b = log(y[k]);
        sx += a, sy += b, sxx += a * a, sxy += a * b;
    }
    n--;
    return n < 2 ? NAN : (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

int main(int argc, char **argv) {
    if (argc < 2) return 2;
    const bool quick = argc > 2 && strcmp(argv[2], "--quick") == 0;
    FILE *out = report_create(argv[1], "growth.tsv"), *times = report_create(argv[1], "growth-times.tsv");
    static figure_t f;
    static char name[ENVIRONMENTS][2][40];
    double growth[ENVIRONMENTS][2][3], per[ENVIRONMENTS][2];
    char path[512];
    figure_init(&f, "Area sort: boxes held against each other and pairs clipped", "polygons", "operations");
    f.x_log = f.y_log = f.joined = true;
    fputs("environment\tsubdivision\tpolygons\tboxes\tclips\tremoved\tvisible\tvertices\twindows\tdepth_boxes\tat_"
          "once\tbytes\n",
          out);
    fputs("environment\tsubdivision\tpolygons\tms\n", times);
    puts("\n## How the work of the area sort grows\n\n"
         "Weiler and Atherton discuss three environments. Polygons behind one that covers all others go with the first "
         "clip, so the work is linear. Where each is seen as one piece, each has to clip, and holds its box against "
         "all that are left: the square. Where they divide each other there are more pieces than polygons: more than "
         "that. Subdividing the screen halves windows until few polygons are left in each, so boxes are held only "
         "against near ones. Without it the whole page is one window, and gets 40 times the memory. Boxes: held "
         "against that of a clip polygon. Clips: pairs clipped, those that a glance tells apart not counted. At once: "
         "pieces there were at a time, at most. Bytes: the high-water mark of the memory, over the polygons.\n\n"
         "| environment | subdivision | polygons | boxes | clips | removed | visible | windows | at once | bytes | ms "
         "|\n"
         "|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|");
    for (size_t k = 0; k < ENVIRONMENTS; k++)
        for (int whole = 0; whole < 2; whole++) {
            const environment_t *e = &environments[k];
            const char *how = whole ? "without" : "with";
            double n[SIZES], boxes[SIZES], work[SIZES], seconds[SIZES];
            snprintf(name[k][whole], sizeof name[k][whole], "%s, %s", e->name, how);
            const int series = figure_series(&f, name[k][whole]), sizes = quick ? 2 : SIZES;
            for (int i = 0; i < sizes; i++) {
                area_stats_t s = {0};
                int64_t vertices = 0;
                seconds[i] = measure(e, e->size[i], whole, quick, &s, &vertices);
                n[i] = (double)s.polygons;
                boxes[i] = (double)s.lateral;
                work[i] = (double)(s.lateral + s.clips);
                fprintf(out, "%s\t%s\t%" PRId64 "\t%" PRId64 "\t%" PRId64 "\t%" PRId64, e->name, how, s.polygons,
                        s.lateral, s.clips, s.removed);
                fprintf(out, "\t%" PRId64 "\t%" PRId64 "\t%d\t%d\t%d\t%zu\n", s.visible, vertices, s.windows, s.boxes,
                        s.pieces, s.bytes);
                fprintf(times, "%s\t%s\t%" PRId64 "\t%.3f\n", e->name, how, s.polygons, 1e3 * seconds[i]);
                printf("| %s | %s | %" PRId64 " | %" PRId64 " | %" PRId64 " | %" PRId64, e->name, how, s.polygons,
                       s.lateral, s.clips, s.removed);
                printf(" | %" PRId64 " | %d | %d | %.0f | %.2f |\n", s.visible, s.windows, s.pieces,
                       (double)s.bytes / (double)s.polygons, 1e3 * seconds[i]);
                per[k][whole] = (double)s.bytes / (double)s.polygons;
                figure_add(&f, series, n[i], work[i], NULL);
            }
            growth[k][whole][0] = slope(sizes, n, boxes);
            growth[k][whole][1] = slope(sizes, n, work);
            growth[k][whole][2] = slope(sizes, n, seconds);
        }
    fclose(out);
    fclose(times);
    puts("\nGrowth, as the power of the number of polygons; of the time as measured:\n\n"
         "| environment | the paper expects, without | boxes and clips: without | with | time: without | with |\n"
         "|---|---|--:|--:|--:|--:|");
    for (size_t k = 0; k < ENVIRONMENTS; k++)
        printf("| %s | %s | %.2f | %.2f | %.2f | %.2f |\n", environments[k].name, environments[k].expect,
               growth[k][1][1], growth[k][0][1], growth[k][1][2], growth[k][0][2]);
    printf("\nSubdivision takes the square out of what is seen in pieces of bounded size: shingles go from %.2f to "
           "%.2f, cubes from %.2f to %.2f. Woven bars cross the whole page, and their visible pieces alone are the "
           "square of the bars: no subdivision can do better than 2. Memory: of the most shingles %.0f bytes a polygon "
           "with "
           "subdivision, %.0f without; of the most bars %.0f and %.0f.\n\n![work over polygons](growth.svg)\n",
           growth[1][1][1], growth[1][0][1], growth[3][1][1], growth[3][0][1], per[1][0], per[1][1], per[2][0],
           per[2][1]);
    snprintf(path, sizeof path, "%s/growth.svg", argv[1]);
    figure_write(&f, path);
    return 0;
}
