/* report_hard_solids - the hard lists of tests/oracle/hard_solids.h: ours beside naive drawings, pictures and errors.
 *
 *     report_hard_solids DIR      writes DIR/hard-solids.md, .tsv, hard-convex-1.png, hard-area-1.png, hard-halo-1.png,
 *                                 and the section on stdout */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/oracle/hard_solids.h"
#include "tests/oracle/run_cases.h"
#include "tests/oracle/solid_ink.h"
#include "tests/report/asked.h"
#include "tests/report/create.h"
#include "tests/report/naive_solids.h"
#include "tests/report/needles.h"
#include "tests/report/sheet.h"
#include "view/page.h"

#define NAIVE_JUDGED 800 /* about so many pieces of a naive drawing are judged */

#define CASES_MOST 64

typedef struct account {
    FILE *md, *tsv;
    judge_report_t ours; /* the worst of a kernel */
    double naive;        /* mm */
    int cases, naive_wrong;
} account_t;

static asked_row_t row[3 * CASES_MOST];
static int rows;

static double steps(double mm) {
    return mm / JUDGE_STEP_MM;
}

static strokes_t strokes_of(const solid_ref_t *r, const page_view_t *v, const judge_piece_t *piece, size_t n) {
    strokes_t all = {0};
    for (size_t k = 0; k < n; k++) {
        const exact_point_t end[2] = {r->vertex[r->edge[piece[k].line][0]], r->vertex[r->edge[piece[k].line][1]]};
        page_part_t part;
        if (page_view_part(v, end, piece[k].from, piece[k].to, &part))
            strokes_add(&all, part.at.x0, part.at.y0, part.at.x1, part.at.y1);
    }
    return all;
}

static judge_report_t judged(const solid_ref_t *r, const page_view_t *v, const judge_piece_t *p, size_t n, int every) {
    judge_report_t out = {0};
    judge_subject_t what = judge_solid(r);
    what.every = every;
    if (judge_pieces(&what, v, p, n, &out)) abort();
    return out;
}

/* Row i of a kernel: `name` of the list, `what` with its figures. */
static void enter(account_t *all, const char *kernel, int i, const char *name, const char *what,
                  const judge_report_t *a, const judge_report_t *b, const char *note) {
    const double naive = fmax(b->missing_mm, b->false_mm);
    asked_row_t *r = &row[rows++];
    *r = (asked_row_t){
        .name = name, .off = steps(fmax(a->missing_mm, a->false_mm)), .end = a->end_steps, .naive = steps(naive)};
    snprintf(r->label, sizeof r->label, "%s %d", kernel, i);
    fprintf(all->md, "| %s %d | %s | %.2f | %.2f | %.2f | %.0f | %.0f | %s |\n", kernel, i, what, steps(a->missing_mm),
            steps(a->false_mm), a->end_steps, steps(b->missing_mm), steps(b->false_mm), note);
    fprintf(all->tsv, "%s\t%d\t%s\t%.3f\t%.3f\t%.3f\t%.1f\t%.1f\n", kernel, i, what, steps(a->missing_mm),
            steps(a->false_mm), a->end_steps, steps(b->missing_mm), steps(b->false_mm));
    judge_worst(&all->ours, a);
    all->naive = fmax(all->naive, naive);
    all->naive_wrong += naive > JUDGE_STEP_MM;
    all->cases++;
}

static void naive_caption(char text[64], const judge_report_t *b) {
    snprintf(text, 64, "naive: %.0f steps missing, %.0f false", steps(b->missing_mm), steps(b->false_mm));
}

/* Of dashes by the thousand a part tells as much. */
static judge_report_t naive_report(const solid_ref_t *r, const page_view_t *v, const judge_piece_t *piece, size_t n,
                                   double unit, int every) {
    solid_ink_t ink = {.ref = r, .unit = unit, .piece = malloc((n + 1) * sizeof *piece), .n = n};
    const int some = n > 2 * NAIVE_JUDGED ? (int)(n / NAIVE_JUDGED) : 0;
    if (!ink.piece) abort();
    memcpy(ink.piece, piece, n * sizeof *piece);
    if (n <= 2 * NAIVE_JUDGED) solid_ink_share(&ink);
    judge_report_t out = judged(r, v, ink.piece, ink.n, some > every ? some : every);
    free(ink.piece);
    return out;
}

static judge_report_t naive_judged[CASES_MOST]; /* by the first kernel of the two: the same scenes */

static void solid_case(account_t *all, sheets_t *sheets, int i, bool area) {
    solid_scene_t s;
    solid_stage_t t;
    page_view_t view;
    char text[64], note[80] = "";
    size_t n = 0;
    const int every = hard_solids_build(i, &s);
    fprintf(stderr, "report_hard_solids: %s %d %s\n", area ? "area" : "convex", i, s.what);
    int err = solid_stage_make(&t, &s, area);
    if (err) fprintf(stderr, "report_hard_solids: %s: error %d\n", s.what, err), exit(1);
    solid_ref_t ref = s.ref; /* shares the memory; the eye is its own */
    solid_view_of(&t.cam, &view, &ref.eye);
    solid_ink_t ink = {.ref = &ref, .solid = &t.solid, .view = &view, .unit = ldexp(1, -t.solid.shift)};
    err = solid_stage_draw(&t, &(ink_sink_t){&ink, solid_ink_take});
    if (err) fprintf(stderr, "report_hard_solids: %s: error %d\n", s.what, err), exit(1);
    strokes_t shown[2] = {strokes_of(&ref, &view, ink.piece, ink.n), {0}};
    if (!every) solid_ink_share(&ink);
    judge_report_t a = judged(&ref, &view, ink.piece, ink.n, every);
    judge_piece_t *naive = naive_solids(&ref, &view, &n);
    shown[1] = strokes_of(&ref, &view, naive, n);
    judge_report_t b = area ? naive_judged[i] : naive_report(&ref, &view, naive, n, ink.unit, every);
    naive_judged[i] = b;
    if (area && t.sorted.intersections)
        snprintf(note, sizeof note, "%lld cuts told", (long long)t.sorted.intersections);
    enter(all, area ? "area" : "convex", i, hard_solids_name(i), s.what, &a, &b, note);
    naive_caption(text, &b);
    sheets_enter(sheets, hard_solids_name(i), text, &shown[0], &shown[1], NULL);
    for (int k = 0; k < 2; k++) strokes_free(&shown[k]);
    free(ink.piece);
    free(naive);
    solid_stage_free(&t);
    solid_scene_free(&s);
}

static strokes_t wires_of(const halo_edge_t *edge, const halo_run_t *t) {
    strokes_t all = {0};
    for (int k = 0; k < t->n; k++) {
        const halo_edge_t *e = &edge[t->piece[k].edge];
        const double x = e->p.x, y = e->p.y, dx = e->q.x - x, dy = e->q.y - y, a = t->piece[k].from, b = t->piece[k].to;
        strokes_add(&all, (x + a * dx) / LAT_PER_MM, (y + a * dy) / LAT_PER_MM, (x + b * dx) / LAT_PER_MM,
                    (y + b * dy) / LAT_PER_MM);
    }
    return all;
}

static judge_report_t wires_judged(const halo_edge_t *edge, int n, int32_t width, const halo_run_t *t, double *beyond) {
    const halo_ref_report_t r = halo_ref_judge(edge, n, width, false, 1, t->piece, t->n);
    *beyond = r.beyond;
    return (judge_report_t){.missing_mm = r.missing / LAT_PER_MM, .false_mm = r.falsely / LAT_PER_MM};
}

static void wire_case(account_t *all, sheets_t *sheets, int i) {
    halo_edge_t edge[HARD_WIRES_EDGES];
    int32_t width;
    const int n = hard_wires_build(i, edge, &width);
    halo_run_t ours = {0}, naive = {0};
    double beyond[2];
    char text[64], what[96];
    halo_run_make(&ours, n, 40 * (size_t)n);
    const int err = halo_run_draw(&ours, edge, n, width);
    if (err) fprintf(stderr, "report_hard_solids: %s: error %d\n", hard_wires_name(i), err), exit(1);
    naive_halo(&naive, edge, n, width);
    judge_report_t a = wires_judged(edge, n, width, &ours, &beyond[0]),
                   b = wires_judged(edge, n, width, &naive, &beyond[1]);
    snprintf(what, sizeof what, "%s (%d edges, halo %.3g mm)", hard_wires_name(i), n, (double)width / LAT_PER_MM);
    enter(all, "halo", i, hard_wires_name(i), what, &a, &b, beyond[0] > 0 ? "beyond its bound" : "");
    strokes_t shown[2] = {wires_of(edge, &ours), wires_of(edge, &naive)};
    naive_caption(text, &b);
    sheets_enter(sheets, hard_wires_name(i), text, &shown[0], &shown[1], NULL);
    for (int k = 0; k < 2; k++) strokes_free(&shown[k]);
    halo_run_free(&ours);
    halo_run_free(&naive);
}

/* What was asked for of surfaces, where solids and lines have it, and what is their own. */
static const asked_t asked[] = {
    {"viewer in the plane of faces", {"viewer in planes of faces"}},
    {"viewer over a vertex", {"viewer over a vertex"}},
    {"viewer on the line of an edge", {"viewer on the line of an edge"}},
    {"viewer over the middle", {"viewer over the middle"}},
    {"viewer below", {"viewer below"}},
    {"viewer level with the tops, and grazing them", {"viewer level with", "viewer grazing"}},
    {"viewer 1e6 away", {"viewer 1e6 away"}},
    {"viewer 1e-3 from a face", {"viewer 1e-3 from a face"}},
    {"viewer inside, with things behind the eye", {"viewer inside", "viewer among", "everything behind"}},
    {"seen exactly edge-on or end-on", {"faces exactly edge-on", "edges seen end-on", "a needle from its end"}},
    {"twisted quads", {"twisted quads"}},
    {"near-parallel edges", {"near-parallel edges"}},
    {"exactly coincident edges", {"exactly coincident edges", "faces that touch", "faces in one plane"}},
    {"crossings at vertices", {"crossings at vertices", "crossings at ends", "edges that meet", "24 lines"}},
    {"slivers below a step", {"slivers below a step", "plates thinner", "edges below a step"}},
    {"sizes from 1 to 1e6", {"1e6 and 1 in one scene"}},
    {"depths differing by 1e-9, or by a unit", {"planes 1e-9 apart", "in contact"}},
    {"tiny ranges", {"a world of 1e-6"}},
    {"many", {"14x14 cubes", "random edges"}},
    {"holes, concave and open shapes", {"concave", "open"}},
    {"a hole that touches its outer contour, or another", {"a hole", "holes that touch", "holes along"}},
    {"cyclic overlap", {"two that overlap", "three that overlap", "nine that overlap", "thirteen that", "order turns"}},
    {"bodies that penetrate", {"bodies that penetrate", "a face cut"}},
    {"degenerate: no area, there twice; lines alone", {"broken", "segments alone"}},
    {"haloes wider than edges", {"haloes wider"}},
};

int main(int argc, char **argv) {
    static const char *const kernel[] = {"convex", "area", "halo"};
    static const char *const sheet[] = {"hard-convex", "hard-area", "hard-halo"};
    account_t all[3] = {{0}};
    if (argc < 2) return 2;
    FILE *md = report_create(argv[1], "hard-solids.md"), *tsv = report_create(argv[1], "hard-solids.tsv");
    fputs("# Hard cases of solids and haloes\n\nLeft ours, right a naive drawing: of solids by a depth buffer of 1024 "
          "columns in single precision, of haloes by which edge's middle is nearer; red is what it draws and should "
          "not, blue what it does not draw. Errors in steps of 0.0125 mm, the longest run each.\n\n",
          md);
    fputs("kernel\tnumber\tscene\tmissing_steps\tfalse_steps\tend_steps\tnaive_missing_steps\tnaive_false_steps\n",
          tsv);
    const int cases[] = {hard_solids_count(), hard_solids_count(), hard_wires_count()};
    for (int k = 0; k < 3; k++)
        for (int i = 1; i <= sheets_count(cases[k]); i++) fprintf(md, "![%s](%s-%d.png)\n", kernel[k], sheet[k], i);
    fputs("\n| | scene | missing | false | end off | naive: missing | false | |\n|--:|---|--:|--:|--:|--:|--:|---|\n",
          md);
    printf(
        "\n## Hard cases of solids and haloes\n\n%d scenes of solids by the convex kernel and by the area sort, and %d "
        "wire frames with haloes, each with its picture and beside it what is usually done: "
        "[the sheets and the table](hard-solids.md).\n\n| kernel | cases | missing | false | end off | naive wrong in "
        "| "
        "at worst |\n|---|--:|--:|--:|--:|--:|--:|\n",
        cases[0], cases[2]);
    for (int k = 0; k < 3; k++) {
        sheets_t sheets = {.dir = argv[1], .name = sheet[k], .cases = cases[k]};
        all[k].md = md, all[k].tsv = tsv;
        for (int i = 0; i < cases[k]; i++) {
            if (k == 2)
                wire_case(&all[k], &sheets, i);
            else
                solid_case(&all[k], &sheets, i, k == 1);
        }
        printf("| %s | %d | %.2f | %.2f | %.2f | %d | %.0f |\n", kernel[k], all[k].cases, steps(all[k].ours.missing_mm),
               steps(all[k].ours.false_mm), all[k].ours.end_steps, all[k].naive_wrong, steps(all[k].naive));
    }
    printf(
        "\nNot exact, and with what bound: vertices are rounded to the scene's lattice, 2^-27 of its longest side; "
        "what is nearer to a plane than %d units of it is in that plane; a crossing is rounded once, to 2^-30 of its "
        "edge (convex), or to a lattice of 1/12,800 of a step each time an area is cut (area sort). A halo's gap is "
        "right to 1 lat (1/%.0f of a step) and 2^-36 of the edge for each lat of its width; edges that would change "
        "their order if an end moved by one unit are in contact and do not cut each other. With the eye .005 of a "
        "body's size from a vertex ends were off by up to .6 steps in 3 of 12,000 scenes (area sort; convex: .5 in "
        "one).\n",
        SOLID_FLAT, LAT_PER_MM * JUDGE_STEP_MM);
    needles_write(argv[1]);
    asked_write(md, asked, (int)(sizeof asked / sizeof *asked), row, rows);
    puts("\n![a sheet](hard-area-1.png)");
    fclose(md);
    fclose(tsv);
    return 0;
}
