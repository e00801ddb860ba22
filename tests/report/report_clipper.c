/* report_clipper - the hard list of tests/oracle/hard_pairs.h: what each operation gives, with pictures and errors.
 *
 *     report_clipper DIR      writes DIR/hard-clipper.md, .tsv, hard-clipper-1.png ..., and the section on stdout */
#include <cairo.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "tests/oracle/hard_pairs.h"
#include "tests/oracle/slab_area.h"
#include "tests/report/create.h"
#include "tests/report/sheet.h"

#define CELL 120
#define TEXT 16
#define ROWS 9 /* of a sheet */
#define RESULTS 5

static const char *const result_name[RESULTS] = {"inside", "outside", "rest", "union", "xor"};

static void stretch(sheet_box_t *b, const poly_t *p) {
    for (int32_t k = 0; k < poly_vertices(p); k++) {
        b->x0 = fmin(b->x0, p->v[k].at.x), b->x1 = fmax(b->x1, p->v[k].at.x);
        b->y0 = fmin(b->y0, p->v[k].at.y), b->y1 = fmax(b->y1, p->v[k].at.y);
    }
}

/* The polygon filled and drawn, its corners as dots. */
static void draw(cairo_t *cr, double x, double y, const sheet_box_t *b, const poly_t *p, enum clip_fill fill,
                 const double rgb[3]) {
    const double k = (CELL - 16) / fmax(fmax(b->x1 - b->x0, b->y1 - b->y0), 1);
    cairo_save(cr);
    cairo_translate(cr, x + CELL / 2., y + CELL / 2.);
    cairo_scale(cr, k, -k);
    cairo_translate(cr, -(b->x0 + b->x1) / 2, -(b->y0 + b->y1) / 2);
    for (int32_t c = 0, i = 0; c < p->contours; c++) {
        for (bool first = true; i < p->end[c]; i++, first = false)
            (first ? cairo_move_to : cairo_line_to)(cr, p->v[i].at.x, p->v[i].at.y);
        cairo_close_path(cr);
    }
    cairo_set_fill_rule(cr, fill == CLIP_NONZERO ? CAIRO_FILL_RULE_WINDING : CAIRO_FILL_RULE_EVEN_ODD);
    cairo_set_source_rgba(cr, rgb[0], rgb[1], rgb[2], .3);
    cairo_fill_preserve(cr);
    cairo_set_source_rgb(cr, rgb[0], rgb[1], rgb[2]);
    cairo_set_line_width(cr, 1 / k);
    cairo_stroke(cr);
    for (int32_t i = 0; i < poly_vertices(p); i++) {
        cairo_arc(cr, p->v[i].at.x, p->v[i].at.y, 1.6 / k, 0, 6.29);
        cairo_fill(cr);
    }
    cairo_restore(cr);
}

static cairo_t *sheet(int rows) {
    cairo_t *cr = sheet_begin(1, (1 + RESULTS) * CELL, rows * (CELL + TEXT) + TEXT);
    sheet_text(cr, 4, 11, "subject, clip", 0);
    for (int k = 0; k < RESULTS; k++) sheet_text(cr, (k + 1) * CELL + 4, 11, result_name[k], 0);
    return cr;
}

int main(int argc, char **argv) {
    static const double red[3] = {.75, 0, 0}, blue[3] = {0, .2, .75}, black[3] = {0, 0, 0};
    static clip_shape_t subject, clip;
    if (argc < 2) return 2;
    const int count = hard_pairs_count(), sheets = (count + ROWS - 1) / ROWS;
    FILE *md = report_create(argv[1], "hard-clipper.md"), *tsv = report_create(argv[1], "hard-clipper.tsv");
    cairo_t *cr = NULL;
    clip_account_t all = {0};
    double worst = 0;
    fputs(
        "# Hard pairs for the clipper\n\nLeft the subject (red) and the clip polygon (blue), then what each operation "
        "gives, with its corners. Errors in units of the lattice: the area by which a result differs from the exact "
        "one, in rationals, over the length of all borders.\n\n",
        md);
    for (int k = 1; k <= sheets; k++) fprintf(md, "![sheet %d](hard-clipper-%d.png)\n", k, k);
    fputs("\n| | pair | corners | crossings | sweeps |", md);
    fputs("pair\tcorners\trounded\tsweeps", tsv);
    for (int r = 0; r < RESULTS; r++) fprintf(md, " %s: contours, error |", result_name[r]);
    for (int r = 0; r < RESULTS; r++) fprintf(tsv, "\t%s_contours\t%s_error", result_name[r], result_name[r]);
    fputs("\n|--:|---|--:|--:|--:|--:|--:|--:|--:|--:|\n", md);
    fputs("\n", tsv);
    for (int i = 0; i < count; i++) {
        enum clip_fill fill;
        clip_account_t one = {0};
        hard_pairs_build(i, &subject, &clip, &fill);
        const char *wrong = clip_judge(&subject, &clip, fill, true, &one);
        if (wrong) fprintf(stderr, "report_clipper: %s: %s\n", hard_pairs_name(i), wrong), exit(1);
        const double borders = slab_border(&subject.poly) + slab_border(&clip.poly);
        const double y = TEXT + i % ROWS * (CELL + TEXT);
        char name[80];
        sheet_box_t box = {INFINITY, INFINITY, -INFINITY, -INFINITY};
        stretch(&box, &subject.poly), stretch(&box, &clip.poly);
        if (i % ROWS == 0) cr = sheet(count - i < ROWS ? count - i : ROWS);
        draw(cr, 0, y, &box, &subject.poly, fill, red);
        draw(cr, 0, y, &box, &clip.poly, fill, blue);
        snprintf(name, sizeof name, "%d %s", i, hard_pairs_name(i));
        sheet_text(cr, 4, y + CELL + 11, name, 0);
        fprintf(md, "| %d | %s | %d | %" PRId64 " | %d |", i, hard_pairs_name(i), (int)(subject.out.n + clip.out.n),
                one.rounded, one.most_sweeps);
        fprintf(tsv, "%s\t%d\t%" PRId64 "\t%d", hard_pairs_name(i), (int)(subject.out.n + clip.out.n), one.rounded,
                one.most_sweeps);
        for (int r = 0; r < RESULTS; r++) {
            const double off = borders > 0 ? clip_judge_off(&subject, &clip, fill, r, true) / borders : 0;
            draw(cr, (r + 1) * CELL, y, &box, &clip_judge_result[r].poly, CLIP_EVEN_ODD, black);
            fprintf(md, " %d, %.3f |", (int)clip_judge_result[r].out.contours, off);
            fprintf(tsv, "\t%d\t%.4f", (int)clip_judge_result[r].out.contours, off);
            worst = fmax(worst, off);
        }
        fputs("\n", md), fputs("\n", tsv);
        if (i % ROWS == ROWS - 1 || i == count - 1) sheet_end(cr, argv[1], "hard-clipper", i / ROWS + 1);
        all.rounded += one.rounded;
        if (one.most_sweeps > all.most_sweeps) all.most_sweeps = one.most_sweeps;
    }
    printf(
        "\n## Hard pairs for the clipper\n\n%d pairs of polygons that touch, coincide, degenerate, and are rounded "
        "into "
        "each other, with what each operation gives of them: [pictures and table](hard-clipper.md). The worst result "
        "is off by %.3f units over the length of the borders, where a rounded crossing moves them by up to 0.71; where "
        "no crossing is rounded, by nothing. At most %d sweeps; areas add up exactly; no two edges of a result cross "
        "or overlap; each clipped again stays itself.\n\n![pairs and results](hard-clipper-1.png)\n",
        count, worst, all.most_sweeps);
    fclose(md);
    fclose(tsv);
    return 0;
}
