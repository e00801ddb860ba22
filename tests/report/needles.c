/* needles.c - see needles.h. */
#include "tests/report/needles.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "tests/oracle/num_of.h"
#include "tests/oracle/solid_ink.h"
#include "tests/report/create.h"

static double steps_of(double mm) {
    return mm / JUDGE_STEP_MM;
}

/* Was the area sort's limit: a needle that begins behind a plate and comes out through it, its edge shared with a wall.
 */
static void needle(solid_scene_t *s, double k) {
    static const double v[][3] = {{-2.0145, -2.3882, .6855}, {-1.7544, -3.1343, 3.1984}, {-1.7544, -3.1343, 3.1984},
                                  {-1.9727, -.8808, 1.8303}, {-2.0581, -2.5028, .7347},  {-.5395, -2.5028, .802},
                                  {-.5395, -.9842, .7058},   {3.4701, -.1477, .8432},    {-.0528, -.1479, .8432},
                                  {-2.878, -.1474, .8432}};
    static const int face[][3] = {{0, 1, 2}, {1, 0, 3}, {4, 5, 6}, {7, 8, 9}};
    static const double eye[] = {3.85373, -2.93983, 2.48107}, to[] = {-.03932, -.44547, .79605};
    *s = (solid_scene_t){0};
    settings_default(&s->set);
    for (int i = 0; i < 10; i++)
        solid_ref_vertex(&s->ref, v[i][0] - (i == 2 ? .0006 * k : 0), v[i][1], v[i][2] + (i == 2 ? .0001 * k : 0));
    for (int f = 0; f < 4; f++) solid_ref_face(&s->ref, face[f], 3);
    solid_ref_finish(&s->ref);
    s->set.view.from = s->set.view.has_to = true;
    for (int i = 0; i < 3; i++) s->set.view.eye[i] = num_of(eye[i]), s->set.view.to[i] = num_of(to[i]);
}

void needles_write(const char *dir) {
    FILE *out = report_create(dir, "needles.tsv");
    fputs("width_steps\tconvex_wrong_steps\tarea_wrong_steps\n", out);
    puts("\nWhat is narrow: a needle that shares an edge with a wall and comes out through a plate, thinner and "
         "thinner. "
         "Width on the page where it is widest; the longest run that the page has wrong. A unit of the area sort's "
         "lattice is 1/12,800 of "
         "a step, and what is narrower than 16 may be closed by rounding: edges of what is seen in so narrow a strip "
         "are "
         "held against the faces as lines.\n\n"
         "| width (steps) | convex: wrong | area: wrong |\n|--:|--:|--:|");
    for (double k = 300; k > .02; k /= sqrt(10)) {
        solid_scene_t s;
        solid_stage_t t;
        judge_report_t r[2];
        area_stats_t area;
        page_view_t view;
        exact_eye_t eye;
        double x[2], y[2];
        needle(&s, k);
        solid_scene_judge(&s, &r[0]);
        solid_scene_judge_area(&s, &r[1], &area);
        if (solid_stage_make(&t, &s, false)) exit(1);
        solid_view_of(&t.cam, &view, &eye);
        for (int i = 0; i < 2; i++) page_view_point(&view, s.ref.vertex[1 + i], &x[i], &y[i]);
        const double width = steps_of(hypot(x[1] - x[0], y[1] - y[0]));
        double wrong[2];
        for (int i = 0; i < 2; i++) wrong[i] = steps_of(fmax(r[i].missing_mm, r[i].false_mm));
        printf("| %.2g | %.2f | %.2f |\n", width, wrong[0], wrong[1]);
        fprintf(out, "%.3g\t%.3f\t%.3f\n", width, wrong[0], wrong[1]);
        solid_stage_free(&t);
        solid_scene_free(&s);
    }
    fclose(out);
}
