/* report_needs - what a scene needs, and what a method that models everything would.
 *
 *     report_needs DIR      writes DIR/needs.tsv and the section on stdout
 *
 * The general method: each facet is a convex object with the planes of its shadow (A. Ricci 1971: one front plane, four
 * through the eye), each edge is clipped against every object whose box on the page meets its own. Finding those pairs
 * is not counted, so the ratio flatters it. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "tests/oracle/solid_ink.h"
#include "tests/oracle/solid_scenes.h"
#include "tests/report/create.h"
#include "tests/report/subject.h"

#define N 40
#define OBJECT_BYTES (4 * 12 + 5 * 16) /* four corners, five planes, in 32-bit numbers */
#define PAIR_PRODUCTS (2 * 5 * 3)      /* both ends of a segment in five planes */
#define CROSSING_PRODUCTS 6            /* two orientations and two lengths along a line (hidden/envelope.c) */
#define TEST_PRODUCTS 2
#define POINT_PRODUCTS 2 /* view/chart.h */

typedef struct box {
    float x0, y0, x1, y1;
} box_t;

static box_t box_of(const page_view_t *view, const exact_point_t *p, int n) {
    box_t b = {INFINITY, INFINITY, -INFINITY, -INFINITY};
    for (int i = 0; i < n; i++) {
        double x, y;
        if (!page_view_point(view, p[i], &x, &y)) continue;
        b.x0 = fminf(b.x0, (float)x), b.x1 = fmaxf(b.x1, (float)x);
        b.y0 = fminf(b.y0, (float)y), b.y1 = fmaxf(b.y1, (float)y);
    }
    return b;
}

static bool boxes_meet(const box_t *a, const box_t *b) {
    return a->x0 < b->x1 && a->x1 > b->x0 && a->y0 < b->y1 && a->y1 > b->y0;
}

/* Edge and facet pairs with boxes that overlap; the facets of the edge itself among them. Of profiles, the rows alone
 * are edges. */
static long long pairs(const scene_t *s, bool profiles) {
    const surface_ref_t *r = &s->ref;
    box_t *cell = malloc((size_t)(r->nx * r->ny) * sizeof *cell);
    long long sum = 0;
    int cells = 0;
    if (!cell) abort();
    for (int j = 0; j < r->ny - 1; j++)
        for (int i = 0; i < r->nx - 1; i++) {
            if (!surface_ref_cell_exists(r, i, j)) continue;
            exact_point_t p[4];
            for (int k = 0; k < 4; k++) p[k] = surface_ref_node(r, i + (k & 1), j + (k >> 1));
            cell[cells++] = box_of(&s->view, p, 4);
        }
    for (int family = REF_ROW; family <= (profiles ? REF_ROW : REF_COL); family++)
        for (int line = 0; line < (family == REF_ROW ? r->ny : r->nx); line++)
            for (int k = 0; k < (family == REF_ROW ? r->nx : r->ny) - 1; k++) {
                exact_point_t e[2];
                if (!surface_ref_edge_exists(r, family, line, k)) continue;
                surface_ref_edge_ends(r, family, line, k, e);
                box_t b = box_of(&s->view, e, 2);
                for (int c = 0; c < cells; c++) sum += boxes_meet(&cell[c], &b);
            }
    free(cell);
    return sum;
}

static int drop(void *ctx, const ink_piece_t *p) {
    return (void)ctx, (void)p, 0;
}

/* The same of solids: edges and faces. */
static long long solid_pairs(const solid_ref_t *r, const page_view_t *view) {
    box_t *face = malloc((size_t)r->nf * sizeof *face);
    long long sum = 0;
    if (!face) abort();
    for (int f = 0; f < r->nf; f++) {
        exact_point_t p[64];
        int n = 0;
        for (int k = r->first[f]; k < r->first[f + 1] && n < 64; k++) p[n++] = r->vertex[r->corner[k]];
        face[f] = box_of(view, p, n);
    }
    for (int e = 0; e < r->ne; e++) {
        const exact_point_t p[2] = {r->vertex[r->edge[e][0]], r->vertex[r->edge[e][1]]};
        const box_t b = box_of(view, p, 2);
        for (int f = 0; f < r->nf; f++) sum += boxes_meet(&face[f], &b);
    }
    free(face);
    return sum;
}

static void solid_needs(FILE *out, const char *family, const solid_scene_t *s) {
    for (int area = 0; area < 2; area++) {
        solid_stage_t t;
        page_view_t view;
        exact_eye_t eye;
        const ink_sink_t sink = {NULL, drop};
        if (solid_stage_make(&t, s, area) || solid_stage_draw(&t, &sink)) exit(1);
        solid_view_of(&t.cam, &view, &eye);
        /* The area sort clips faces by faces: each of its pairs stands for as many edges as a face has. */
        const long long ours = area ? t.sorted.clips : t.stats.tests, all = solid_pairs(&s->ref, &view);
        const long long general = area ? all * s->ref.nf / s->ref.ne : all;
        const double bytes = (double)s->ref.nf * OBJECT_BYTES, used = (double)(t.solid.bytes + t.stats.bytes);
        fprintf(out, "%s\t%s\t%d\t%d\t%lld\t%lld\t%lld\t%lld\t%.0f\t%.0f\n", area ? "area" : "convex", family,
                s->ref.nf, s->ref.ne, ours, (long long)t.stats.crossings, (long long)t.stats.pieces, general, used,
                bytes);
        printf("| %s | %s | %d | %d | %lld | %lld | %lld | %.0f | %lld | %.1f x | %.2f x |\n", area ? "area" : "convex",
               family, s->ref.nf, s->ref.ne, ours, (long long)t.stats.crossings, (long long)t.stats.pieces, used,
               general, (double)general / (double)(ours ? ours : 1), bytes / used);
        solid_stage_free(&t);
    }
}

static void all_solid_needs(const char *dir) {
    FILE *out = report_create(dir, "needs-solids.tsv");
    solid_scene_t s;
    fputs("kernel\tfamily\tfaces\tedges\tpairs\tcrossings\tpieces\tgeneral_pairs\tbytes\tgeneral_bytes\n", out);
    puts(
        "\nSolids. Pairs that are compared: edges with bodies (convex), faces with faces (area sort). The general "
        "method makes "
        "each face an object, and compares each edge (face) with those whose boxes on the page meet its own: ours "
        "looks at "
        "a body as one object and passes edges that look away. Bytes: the solid and the lent memory that is used; "
        "objects "
        "alone on the other side. Haloes have no general method to be held against: every edge with every other is the "
        "square, their tests are above under solids, haloes, polygons.\n\n| kernel | family | faces | edges | pairs | "
        "crossings | pieces | bytes | general: pairs | of ours | its bytes, of ours |\n"
        "|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|");
    solid_scene_cubes(&s, 7);
    solid_needs(out, "7 x 7 cubes", &s);
    solid_scene_free(&s);
    solid_scene_cubes(&s, 14);
    solid_needs(out, "14 x 14 cubes", &s);
    solid_scene_free(&s);
    for (int ball = 0; ball < 2; ball++) {
        solid_scene_round(&s, 24, ball ? 0 : 2.5);
        solid_needs(out, ball ? "ball, 24" : "torus, 24", &s);
        solid_scene_free(&s);
    }
    fclose(out);
}

int main(int argc, char **argv) {
    char path[512];
    if (argc < 2) return 2;
    snprintf(path, sizeof path, "%s/needs.tsv", argv[1]);
    FILE *out = fopen(path, "w");
    if (!out) return 1;
    fputs("kernel\tfamily\tfacets\trows_held\tpoints\tevaluations\tpeak_"
          "vertices\tpeak_windows\tedges\ttests\tcrossings\tpieces\tbytes\t"
          "general_pairs\tproducts\tgeneral_products\tgeneral_bytes\n",
          out);
    printf(
        "\n## Only what a scene needs\n\nSurfaces of %d x %d points without a cache of heights. Evaluations: all "
        "points "
        "once to find the scale, and again as their row is drawn; the horizon asks for its profiles the same way. "
        "A general method makes each facet a convex object (%d bytes) and clips each edge against every object whose "
        "box on the page meets its own.\n\n| kernel | family | rows held | evaluations per point | vertices at peak | "
        "windows at peak | edges clipped | tests | crossings | pieces | bytes | general: clips | its products, of ours "
        "| its bytes, of "
        "ours |\n|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n",
        N, N, OBJECT_BYTES);
    double least = INFINITY, most = 0;
    for (int k = 0; k < KERNELS; k++)
        for (int m = 0; m < FAMILIES; m++) {
            subject_t u;
            hidden_stats_t st;
            ink_sink_t sink = {NULL, drop};
            subject_make(&u, (enum subject_kernel)k, (enum subject_family)m, N);
            double evaluations = 2;
            if (k != KERNEL_HORIZON && grid_measure(&u.grid, &u.surface, NULL, NULL, NULL, NULL, NULL)) return 1;
            if (subject_draw(&u, &sink, &st)) return 1;
            if (k != KERNEL_HORIZON) evaluations = (double)u.grid.evaluated / (N * N);
            int rows = k == KERNEL_HORIZON ? 0 : 2, peak = st.peak_upper + st.peak_lower;
            double points = N * N;
            double ours =
                TEST_PRODUCTS * (double)st.tests + CROSSING_PRODUCTS * (double)st.crossings + POINT_PRODUCTS * points;
            fprintf(out, "%s\t%s\t%lld\t%d\t%d\t%.3f\t%d\t%d\t%lld\t%lld\t%lld\t%lld\t%zu", subject_kernel_name[k],
                    subject_family_name[m], (long long)st.facets, rows, N * N, evaluations, peak, st.windows,
                    (long long)st.edges, (long long)st.tests, (long long)st.crossings, (long long)st.pieces, st.bytes);
            printf("| %s | %s | %d | %.2f | ", subject_kernel_name[k], subject_family_name[m], rows, evaluations);
            printf("%d | %d | ", peak, st.windows);
            printf("%lld | %lld | %lld | %lld | %zu | ", (long long)st.edges, (long long)st.tests,
                   (long long)st.crossings, (long long)st.pieces, st.bytes);
            /* Profiles bound no facets: the general method must model what lies between them. */
            long long all = pairs(&u.scene, k == KERNEL_HORIZON);
            double general = (double)all * PAIR_PRODUCTS + 4 * points;
            double bytes = (double)(k == KERNEL_HORIZON ? (N - 1) * (N - 1) : st.facets) * OBJECT_BYTES;
            fprintf(out, "\t%lld\t%.0f\t%.0f\t%.0f\n", all, ours, general, bytes);
            printf("%lld | %.0f x | %.0f x |\n", all, general / ours, bytes / (double)st.bytes);
            if (k == KERNEL_PERIMETER) least = fmin(least, general / ours), most = fmax(most, general / ours);
            subject_free(&u);
        }
    fclose(out);
    printf("\nA scene without holes needs two rows and its horizons: %.0f to %.0f times fewer products than modelling "
           "every facet, and the ratio grows with the grid, as the pairs do. Holes need windows, which is the "
           "only case that takes it.\n",
           least, most);
    all_solid_needs(argv[1]);
    return 0;
}
