/* needs_solids.c - see needs.h: solids by both kernels, and wire frames with haloes. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "tests/oracle/halo_run.h"
#include "tests/oracle/halo_scenes.h"
#include "tests/oracle/solid_ink.h"
#include "tests/report/create.h"
#include "tests/report/needs.h"

needs_box_t needs_box(const page_view_t *view, const exact_point_t *p, int n) {
    needs_box_t b = {INFINITY, INFINITY, -INFINITY, -INFINITY};
    for (int i = 0; i < n; i++) {
        double x, y;
        if (!page_view_point(view, p[i], &x, &y)) continue;
        b.x0 = fminf(b.x0, (float)x), b.x1 = fmaxf(b.x1, (float)x);
        b.y0 = fminf(b.y0, (float)y), b.y1 = fmaxf(b.y1, (float)y);
    }
    return b;
}

bool needs_boxes_meet(const needs_box_t *a, const needs_box_t *b) {
    return a->x0 < b->x1 && a->x1 > b->x0 && a->y0 < b->y1 && a->y1 > b->y0;
}

/* --- solids --- */

/* Edges and faces whose boxes meet. */
static long long solid_pairs(const solid_ref_t *r, const page_view_t *view) {
    needs_box_t *face = malloc((size_t)r->nf * sizeof *face);
    long long sum = 0;
    if (!face) abort();
    for (int f = 0; f < r->nf; f++) {
        exact_point_t p[64];
        int n = 0;
        for (int k = r->first[f]; k < r->first[f + 1] && n < 64; k++) p[n++] = r->vertex[r->corner[k]];
        face[f] = needs_box(view, p, n);
    }
    for (int e = 0; e < r->ne; e++) {
        const exact_point_t p[2] = {r->vertex[r->edge[e][0]], r->vertex[r->edge[e][1]]};
        const needs_box_t b = needs_box(view, p, 2);
        for (int f = 0; f < r->nf; f++) sum += needs_boxes_meet(&face[f], &b);
    }
    free(face);
    return sum;
}

/* Counts how many visible pieces the line at hand has, and the most of all lines. */
typedef struct tally {
    int32_t line, here, most;
} tally_t;

static void count(tally_t *t, int32_t line) {
    t->here = line == t->line ? t->here + 1 : 1;
    t->line = line;
    if (t->here > t->most) t->most = t->here;
}

static int count_piece(void *ctx, const ink_piece_t *p) {
    count(ctx, p->line);
    return 0;
}

static void solid_needs(FILE *out, const char *family, const solid_scene_t *s) {
    for (int area = 0; area < 2; area++) {
        solid_stage_t t;
        page_view_t view;
        exact_eye_t eye;
        tally_t tally = {.line = -1};
        const ink_sink_t sink = {&tally, count_piece};
        if (solid_stage_make(&t, s, area) || solid_stage_draw(&t, &sink)) exit(1);
        solid_view_of(&t.cam, &view, &eye);
        /* The area sort clips faces by faces: each of its pairs stands for as many edges as a face has. */
        const long long all = solid_pairs(&s->ref, &view), general = area ? all * s->ref.nf / s->ref.ne : all;
        const double bytes = (double)s->ref.nf * NEEDS_OBJECT_BYTES, used = (double)(t.solid.bytes + t.stats.bytes);
        const long long ours = area ? t.sorted.clips : t.stats.tests,
                        found = area ? t.sorted.removed : t.stats.crossings;
        const int peak = area ? t.sorted.pieces : tally.most;
        const char *kernel = area ? "area" : "convex";
        fprintf(out, "%s\t%s\t%d\t%d\t%d\t%d\t%lld\t%lld\t%lld\t%lld\t%.0f\t%.0f\n", kernel, family, s->ref.nf,
                s->ref.ne, s->ref.nv, peak, ours, found, (long long)t.stats.pieces, general, used, bytes);
        printf("| %s | %s | all %d | %d | %d | %d | %lld | %lld | %lld | %.0f | %lld | %.1f x | %.2f x |\n", kernel,
               family, s->ref.nf, s->ref.nv, s->ref.ne, peak, ours, found, (long long)t.stats.pieces, used, general,
               (double)general / (double)(ours ? ours : 1), bytes / used);
        solid_stage_free(&t);
    }
}

void needs_solids(const char *dir) {
    FILE *out = report_create(dir, "needs-solids.tsv");
    solid_scene_t s;
    fputs("kernel\tfamily\tfaces\tedges\tpoints\tpeak\tpairs\tfound\tpieces\tgeneral_pairs\tbytes\tgeneral_bytes\n",
          out);
    puts(
        "\nSolids. They come in any order, so all faces are held, where a surface has two rows; each vertex is mapped "
        "once. At peak: parts that one edge is cut into (convex), polygons that there are at once (area sort). Pairs "
        "that are compared: edges with bodies, faces with faces; found: of those, how many hide a part (convex), "
        "pieces taken away (area sort). The general method makes each face an object, and compares each edge (face) "
        "with those whose boxes on the page meet its own: ours looks at a body as one object and passes edges that "
        "look away. Bytes: the solid and the lent memory that is used; objects alone on the other side.\n\n"
        "| kernel | family | faces held | points | edges | at peak | pairs | found | pieces | bytes | general: pairs | "
        "of ours | its bytes, of ours |\n|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|");
    for (int k = 7; k <= 14; k += 7) {
        solid_scene_cubes(&s, k);
        solid_needs(out, k == 7 ? "7 x 7 cubes" : "14 x 14 cubes", &s);
        solid_scene_free(&s);
    }
    for (int ball = 0; ball < 2; ball++) {
        solid_scene_round(&s, 24, ball ? 0 : 2.5);
        solid_needs(out, ball ? "ball, 24" : "torus, 24", &s);
        solid_scene_free(&s);
    }
    fclose(out);
}

/* --- haloes --- */

static bool apart(int32_t a, int32_t b, int32_t c, int32_t d) {
    return (a < b ? b : a) < (c < d ? c : d) || (c < d ? d : c) < (a < b ? a : b);
}

/* Pairs whose boxes have a point in common: an edge along an axis has a box without width. */
static long long wire_pairs(const halo_edge_t *e, int32_t n) {
    long long sum = 0;
    for (int32_t i = 0; i < n; i++)
        for (int32_t j = i + 1; j < n; j++)
            sum += !apart(e[i].p.x, e[i].q.x, e[j].p.x, e[j].q.x) && !apart(e[i].p.y, e[i].q.y, e[j].p.y, e[j].q.y);
    return sum;
}

static void halo_needs(FILE *out, const char *family, const halo_edge_t *edge, int32_t n, int32_t width) {
    halo_run_t run = {0};
    tally_t tally = {.line = -1};
    halo_run_make(&run, n, 12 * (size_t)n + 4096);
    if (halo_run_draw(&run, edge, n, width)) exit(1);
    for (int k = 0; k < run.n; k++) count(&tally, run.piece[k].edge);
    const long long all = (long long)n * (n - 1) / 2, tests = run.h.tests, found = run.h.crossings,
                    meet = wire_pairs(edge, n);
    fprintf(out, "%s\t%d\t%d\t%d\t%lld\t%lld\t%d\t%lld\t%lld\t%zu\n", family, n, 2 * n, tally.most, tests, found, run.n,
            all, meet, run.h.used);
    printf("| %s | all %d | %d | %d | %lld | %lld | %d | %zu | %lld | %.0f x | %lld | %.2f x |\n", family, n, 2 * n,
           tally.most, tests, found, run.n, run.h.used, all, (double)all / (double)tests, meet,
           (double)meet / (double)tests);
    halo_run_free(&run);
}

void needs_haloes(const char *dir) {
    FILE *out = report_create(dir, "needs-haloes.tsv");
    static const struct {
        int32_t n;
        double length;
    } random[] = {{1000, .1}, {1000, .03}, {10000, .01}};
    halo_edge_t *edge = malloc(10000 * sizeof *edge);
    if (!edge) abort();
    fputs("family\tedges\tpoints\tpeak\ttests\tcrossings\tpieces\tall_pairs\tpairs_of_boxes\tbytes\n", out);
    puts("\nHaloed lines. Any edge can cross any other, so all are held; both ends of each are given once. At peak: "
         "pieces of one edge. Tests: pairs whose crossing is computed. A general method computes it for all pairs; one "
         "that knows their boxes for those that meet, if something finds these for nothing.\n\n"
         "| family | edges held | points | at peak | tests | crossings | pieces | bytes | all pairs | of ours | boxes "
         "that meet | of ours |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|");
    for (int k = 0; k < 3; k++) {
        char name[48];
        halo_scene_random(edge, random[k].n, random[k].length);
        snprintf(name, sizeof name, "%d random edges of %g", random[k].n, random[k].length);
        halo_needs(out, name, edge, random[k].n, (int32_t)(.02 * random[k].length * HALO_SCENE_PAGE));
    }
    for (int k = 4; k <= 14; k += 10) {
        const double size = halo_scene_cubes(edge, k);
        halo_needs(out, k == 4 ? "4 x 4 cubes" : "14 x 14 cubes", edge, 12 * k * k, (int32_t)(.05 * size));
    }
    fclose(out);
    free(edge);
}
