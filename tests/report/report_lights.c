/* report_lights - the hard list of tests/oracle/hard_lights.h: drawings with shadows beside what rays say, and errors.
 *
 *     report_lights DIR      writes DIR/hard-lights.md, .tsv, hard-lights-1.png, and the section on stdout; draws by
 * the program that was built beside it */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/oracle/hard_lights.h"
#include "tests/oracle/light_ref.h"
#include "tests/oracle/num_of.h"
#include "tests/report/create.h"
#include "tests/report/sheet.h"

#define SEEDS 12
#define PITCH_MM 2.

static void write_obj(const char *path, const solid_ref_t *r) {
    FILE *f = fopen(path, "w");
    if (!f) perror(path), exit(1);
    for (int k = 0; k < r->nv; k++) fprintf(f, "v %.17g %.17g %.17g\n", r->vertex[k].x, r->vertex[k].y, r->vertex[k].z);
    for (int k = 0; k < r->nf; k++) {
        fputs("f", f);
        for (int i = r->first[k]; i < r->first[k + 1]; i++) fprintf(f, " %d", r->corner[i] + 1);
        fputs("\n", f);
    }
    fclose(f);
}

/* As a user would have it drawn. */
static strokes_t drawn(const char *program, const char *dir, const solid_scene_t *s, const light_t *light, int lights) {
    char path[3][512], command[2048], line[256];
    static const char *const name[3] = {"lights.obj", "lights.gp", "lights.seg"};
    strokes_t all = {0};
    for (int k = 0; k < 3; k++) snprintf(path[k], sizeof path[k], "%s/%s", dir, name[k]);
    write_obj(path[0], &s->ref);
    FILE *f = fopen(path[1], "w");
    if (!f) perror(path[1]), exit(1);
    fprintf(f, "set hidden3d area\nset hatch 30,1.5\nset shadow outline\nset view from %.17g,%.17g,%.17g\n",
            num_value(s->set.view.eye[0]), num_value(s->set.view.eye[1]), num_value(s->set.view.eye[2]));
    for (int l = 0; l < lights; l++)
        fprintf(f, "set light %d %s %.17g,%.17g,%.17g\n", l + 1, light[l].point ? "from" : "",
                num_value(light[l].at[0]), num_value(light[l].at[1]), num_value(light[l].at[2]));
    fprintf(f, "splot '%s'\n", path[0]);
    fclose(f);
    snprintf(command, sizeof command, "'%s' plot '%s' -o '%s'", program, path[1], path[2]);
    if (system(command) != 0) fprintf(stderr, "report_lights: %s\n", command), exit(1);
    f = fopen(path[2], "r");
    if (!f) perror(path[2]), exit(1);
    while (fgets(line, sizeof line, f)) {
        double at[4];
        if (line[0] != '#' && sscanf(line, "%lf %lf %lf %lf", &at[0], &at[1], &at[2], &at[3]) == 4)
            strokes_add(&all, at[0], at[1], at[2], at[3]);
    }
    fclose(f);
    for (int k = 0; k < 3; k++) remove(path[k]);
    return all;
}

/* A dash where no light falls, a dot where it does. */
static void place(void *ctx, double x, double y, int reached) {
    const double half = reached == 0 ? .4 * PITCH_MM : .03 * PITCH_MM;
    if (reached >= 0) strokes_add(ctx, x - half, y, x + half, y);
}

int main(int argc, char **argv) {
    if (argc < 2) return 2;
    char program[512];
    const char *slash = strrchr(argv[0], '/');
    snprintf(program, sizeof program, "%.*s../host/ridgeline", slash ? (int)(slash - argv[0] + 1) : 0, argv[0]);
    FILE *md = report_create(argv[1], "hard-lights.md"), *tsv = report_create(argv[1], "hard-lights.tsv");
    const int count = hard_lights_count();
    sheets_t sheets = {.dir = argv[1], .name = "hard-lights", .cases = count, .apart = true};
    light_tally_t all = {0};
    fputs(
        "# Hard lights\n\nLeft the drawing, with borders of shadows, right what rays say: dashes where no light falls, "
        "dots where some does. A face that one strokes at less than 1:8192 gets none of it, which is its tone and no "
        "shadow.\n\n",
        md);
    for (int k = 1; k <= sheets_count(count); k++) fprintf(md, "![sheet](hard-lights-%d.png)\n", k);
    fputs("\n| | light | places, wrong | borders, where nothing changes | changes, without a border |\n"
          "|--:|---|--:|--:|--:|\n",
          md);
    fputs("light\tplaces\tplaces_wrong\tborders\tborders_wrong\tchanges\tchanges_missed\n", tsv);
    for (int i = 0; i < count; i++) {
        light_tally_t n = {0};
        light_t light[LIGHTS_MAX];
        solid_scene_t s;
        char text[80];
        const int lights = hard_lights_build(i, &s, light);
        fprintf(stderr, "report_lights: %d %s\n", i, s.what);
        for (uint64_t seed = 0; seed < SEEDS; seed++) light_ref_judge(&s, seed, light, lights, &n);
        strokes_t shown[2] = {drawn(program, argv[1], &s, light, lights), {0}};
        if (!light_ref_picture(&s, light, lights, PITCH_MM, place, &shown[1])) return 1;
        snprintf(text, sizeof text, "by rays: %lld of %lld places wrong", n.places_wrong, n.places);
        sheets_enter(&sheets, hard_lights_name(i), text, &shown[0], &shown[1], NULL);
        fprintf(md, "| %d | %s | %lld, %lld | %lld, %lld | %lld, %lld |\n", i, hard_lights_name(i), n.places,
                n.places_wrong, n.borders, n.borders_wrong, n.changes, n.changes_missed);
        fprintf(tsv, "%s\t%lld\t%lld\t%lld\t%lld\t%lld\t%lld\n", hard_lights_name(i), n.places, n.places_wrong,
                n.borders, n.borders_wrong, n.changes, n.changes_missed);
        light_tally_add(&all, &n);
        for (int k = 0; k < 2; k++) strokes_free(&shown[k]);
        solid_scene_free(&s);
    }
    printf(
        "\n## Hard lights\n\n%d lights that graze faces, lie in their planes, come from the eye, or stand close by: "
        "[the sheet and the table](hard-lights.md), each drawing beside what rays say. Of %lld places %lld are wrong, "
        "of %lld borders of shadows %lld lie where nothing changes, of %lld changes %lld have no border.\n\n"
        "![drawings and rays](hard-lights-1.png)\n",
        count, all.places, all.places_wrong, all.borders, all.borders_wrong, all.changes, all.changes_missed);
    fclose(md);
    fclose(tsv);
    return 0;
}
