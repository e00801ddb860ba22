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

#include "tests/report/needs.h"
#include "tests/report/subject.h"

#define N 40
#define PAIR_PRODUCTS (2 * 5 * 3) /* both ends of a segment in five planes */
#define CROSSING_PRODUCTS 6       /* two orientations and two lengths along a line (hidden/surface/envelope.c) */
#define TEST_PRODUCTS 2
#define POINT_PRODUCTS 2 /* view/chart.h */

/* Edge and facet pairs with boxes that overlap; the facets of the edge itself among them. Of profiles, the rows alone
 * are edges. */
static long long pairs(const scene_t *s, bool profiles) {
    const surface_ref_t *r = &s->ref;
    needs_box_t *cell = malloc((size_t)(r->nx * r->ny) * sizeof *cell);
    long long sum = 0;
    int cells = 0;
    if (!cell) abort();
    for (int j = 0; j < r->ny - 1; j++)
        for (int i = 0; i < r->nx - 1; i++) {
            if (!surface_ref_cell_exists(r, i, j)) continue;
            exact_point_t p[4];
            for (int k = 0; k < 4; k++) p[k] = surface_ref_node(r, i + (k & 1), j + (k >> 1));
            cell[cells++] = needs_box(&s->view, p, 4);
        }
    for (int family = REF_ROW; family <= (profiles ? REF_ROW : REF_COL); family++)
        for (int line = 0; line < (family == REF_ROW ? r->ny : r->nx); line++)
            for (int k = 0; k < (family == REF_ROW ? r->nx : r->ny) - 1; k++) {
                exact_point_t e[2];
                if (!surface_ref_edge_exists(r, family, line, k)) continue;
                surface_ref_edge_ends(r, family, line, k, e);
                needs_box_t b = needs_box(&s->view, e, 2);
                for (int c = 0; c < cells; c++) sum += needs_boxes_meet(&cell[c], &b);
            }
    free(cell);
    return sum;
}

static int drop(void *ctx, const ink_piece_t *p) {
    return (void)ctx, (void)p, 0;
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
        N, N, NEEDS_OBJECT_BYTES);
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
            double bytes = (double)(k == KERNEL_HORIZON ? (N - 1) * (N - 1) : st.facets) * NEEDS_OBJECT_BYTES;
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
    needs_solids(argv[1]);
    needs_haloes(argv[1]);
    return 0;
}
