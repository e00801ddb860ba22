/* judge_seg - judges a drawing of the whole program (.seg) against the exact reference.
 *
 *     judge_seg DRAWING.seg -f 'exp(-x**2-y**2)' -n 60,60 -x -2:2 -y -2:2 [options]
 *     judge_seg DRAWING.seg -g DATA [options]
 *
 *   -H COUNT,SAMPLES  of -f: the profiles of `set hidden3d horizon` instead of a grid (cut_profiles.h)
 *   -I              they are infinite
 *   -f, -n, -x, -y  a function of x and y sampled NX by NY times on a rectangle
 *   -g FILE         gnuplot's grid blocks, `x y z` a line, blank line after each row of one y (or x); `set table`
 * output too -e X,Y,Z        the eye, if the matrix' 17 digits are not exact enough for it -d X,Y,Z        the
 * direction from the scene to the eye of a parallel view -p X0,Y0,X1,Y1  part of the page that is drawn on (mm);
 * default 0,0,297,210 -z LO:HI        points outside are undefined -q              say nothing, only exit
 *
 * Prints one `name value` a line, lengths in mm; exit status 0 when nothing is missing or false beyond one step (0.0125
 * mm) and ends are within a quarter step, 1 when not, 2 when it cannot judge. */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/oracle/judge_seg.h"
#include "tests/oracle/tools/cut_profiles.h"
#include "tests/oracle/tools/formula.h"

#define MAX_SIDE 4000

static int complain(const char *what, const char *arg) {
    fprintf(stderr, "judge_seg: %s%s%s\n", what, arg ? ": " : "", arg ? arg : "");
    return 2;
}

static void *must(void *p) {
    if (!p) exit(complain("out of memory", NULL));
    return p;
}

static void allocate(surface_ref_t *r, int nx, int ny) {
    r->nx = nx;
    r->ny = ny;
    r->x = must(calloc((size_t)nx, sizeof(double)));
    r->y = must(calloc((size_t)ny, sizeof(double)));
    r->z = must(calloc((size_t)nx * (size_t)ny, sizeof(double)));
    r->hole = must(calloc((size_t)nx * (size_t)ny, 1));
}

static void set(surface_ref_t *r, int i, int j, double z, const double limit[2]) {
    bool ok = isfinite(z) && z >= limit[0] && z <= limit[1];
    r->z[j * r->nx + i] = ok ? z : 0;
    r->hole[j * r->nx + i] = !ok;
}

static int from_formula(surface_ref_t *r, const char *text, const int n[2], const double x[2], const double y[2],
                        const double limit[2]) {
    const char *bad = NULL;
    allocate(r, n[0], n[1]);
    /* Rounded as gnuplot does, so that a singular point is met or missed alike. */
    for (int i = 0; i < n[0]; i++) r->x[i] = x[0] + i * ((x[1] - x[0]) / (n[0] - 1));
    for (int j = 0; j < n[1]; j++) r->y[j] = y[0] + j * ((y[1] - y[0]) / (n[1] - 1));
    for (int j = 0; j < n[1]; j++)
        for (int i = 0; i < n[0]; i++) {
            set(r, i, j, formula(text, r->x[i], r->y[j], &bad), limit);
            if (bad) return complain("not understood", bad);
        }
    return 0;
}

typedef struct points {
    double *v; /* x, y, z of each */
    size_t n;  /* numbers */
    int block; /* points of the first block */
    int blocks;
} points_t;

/* Reads points; blocks are divided by blank lines. */
static int read_points(points_t *p, const char *name) {
    FILE *f = fopen(name, "r");
    if (!f) return complain("cannot open", name);
    char line[4096];
    size_t cap = 0;
    int here = 0;
    *p = (points_t){0};
    while (fgets(line, sizeof line, f)) {
        char *s = line;
        while (isspace((unsigned char)*s)) s++;
        if (*s == '#') continue;
        if (!*s) {
            if (here && !p->blocks++) p->block = here;
            here = 0;
            continue;
        }
        if (p->n + 3 > cap) {
            cap = cap ? 2 * cap : 3072;
            p->v = must(realloc(p->v, cap * sizeof *p->v));
        }
        for (int k = 0; k < 3; k++) {
            char *end;
            p->v[p->n++] = strtod(s, &end);
            if (end == s) p->v[p->n - 1] = NAN;
            s = end;
        }
        while (isspace((unsigned char)*s)) s++;
        if (*s == 'u') p->v[p->n - 1] = NAN; /* `set table` marks undefined points so */
        here++;
    }
    fclose(f);
    if (here && !p->blocks++) p->block = here;
    return 0;
}

static int from_file(surface_ref_t *r, const char *name, const double limit[2]) {
    points_t p = {0};
    int err = read_points(&p, name);
    if (err) return err;
    if (p.block < 2 || p.blocks < 2 || (size_t)p.block * (size_t)p.blocks * 3 != p.n)
        return complain("not a grid", name);
    bool rows = p.v[1] == p.v[4]; /* y stays within a block */
    allocate(r, rows ? p.block : p.blocks, rows ? p.blocks : p.block);
    bool flip_x = p.v[0] > p.v[p.n - 3], flip_y = p.v[1] > p.v[p.n - 2];
    for (int b = 0; b < p.blocks; b++)
        for (int k = 0; k < p.block; k++) {
            const double *v = p.v + 3 * (b * p.block + k);
            int i = rows ? k : b, j = rows ? b : k;
            if (flip_x) i = r->nx - 1 - i;
            if (flip_y) j = r->ny - 1 - j;
            r->x[i] = v[0];
            r->y[j] = v[1];
            set(r, i, j, v[2], limit);
        }
    free(p.v);
    return 0;
}

static bool numbers(const char *s, double *v, int n) {
    for (int i = 0; i < n; i++) {
        char *end;
        v[i] = strtod(s, &end);
        if (end == s || (i + 1 < n && *end != ',' && *end != ':')) return false;
        s = end + 1;
    }
    return true;
}

typedef struct options {
    const char *seg, *text, *grid;
    double n[2], x[2], y[2], limit[2], eye[3], window[4];
    int eye_h; /* -1: from the matrix */
    bool quiet, horizon, infinite;
} options_t;

static int read_options(options_t *o, int argc, char **argv) {
    *o = (options_t){
        .x = {-10, 10}, .y = {-10, 10}, .limit = {-INFINITY, INFINITY}, .window = {0, 0, 297, 210}, .eye_h = -1};
    for (int i = 1; i < argc; i++) {
        const char *a = argv[i], *v = i + 1 < argc ? argv[i + 1] : "";
        if (a[0] != '-') {
            o->seg = a;
            continue;
        }
        if (!strcmp(a, "-q")) {
            o->quiet = true;
            continue;
        }
        if (!strcmp(a, "-I")) {
            o->infinite = true;
            continue;
        }
        bool ok = true;
        switch (a[1]) {
        case 'f':
            o->text = v;
            break;
        case 'g':
            o->grid = v;
            break;
        case 'H':
            ok = numbers(v, o->n, 2);
            o->horizon = true;
            break;
        case 'n':
            ok = numbers(v, o->n, 2);
            break;
        case 'x':
            ok = numbers(v, o->x, 2);
            break;
        case 'y':
            ok = numbers(v, o->y, 2);
            break;
        case 'z':
            ok = numbers(v, o->limit, 2);
            break;
        case 'e':
            ok = numbers(v, o->eye, 3), o->eye_h = 1;
            break;
        case 'd':
            ok = numbers(v, o->eye, 3), o->eye_h = 0;
            break;
        case 'p':
            ok = numbers(v, o->window, 4);
            break;
        default:
            ok = false;
        }
        if (!ok) return complain("bad option", a);
        i++;
    }
    if (!o->seg || !(o->text || o->grid)) return complain("need a .seg file and -f or -g", NULL);
    if (o->text && (o->n[0] < 2 || o->n[1] < 2 || o->n[0] > MAX_SIDE || o->n[1] > MAX_SIDE))
        return complain("need -n NX,NY", NULL);
    return 0;
}

static void report(const judge_seg_report_t *r, size_t segments) {
    const judge_report_t *p = &r->pieces;
    printf("segments %zu\ndrawn_mm %.3f\nvisible_mm %.3f\n", segments, r->drawn_mm, p->visible_mm);
    printf("missing_mm %.6f  # %s %d from %.6f to %.6f; raw %.6f\n", p->missing_mm,
           p->missing.family ? "column" : "row", p->missing.line, p->missing.from, p->missing.to, p->raw_missing_mm);
    printf("false_mm %.6f  # on %.6f %.6f %.6f %.6f; %.6f in all\n", r->false_mm, r->false_seg.x0, r->false_seg.y0,
           r->false_seg.x1, r->false_seg.y1, r->false_total_mm);
    printf("end_steps %.4f  # %s %d at %.6f\n", p->end_steps, p->end.family ? "column" : "row", p->end.line,
           p->end.from);
    printf("twice_mm %.6f\n", p->twice_mm);
}

int main(int argc, char **argv) {
    options_t o;
    surface_ref_t r = {0};
    page_view_t v;
    size_t n;
    int err = read_options(&o, argc, argv);
    if (err) return err;
    page_seg_t *seg = judge_seg_read(o.seg, &v, &n);
    if (!seg) return complain("cannot read, or has no camera", o.seg);
    if (o.eye_h >= 0) v.eye = (exact_eye_t){o.eye[0], o.eye[1], o.eye[2], o.eye_h};
    v.x0 = o.window[0], v.y0 = o.window[1], v.x1 = o.window[2], v.y1 = o.window[3];
    judge_subject_t what;
    horizon_ref_t profiles = {.infinite = o.infinite, .eye = v.eye};
    if (o.horizon && o.text) {
        cut_scene_t cut = {o.text,      {o.x[0], o.x[1]}, {o.y[0], o.y[1]}, {o.limit[0], o.limit[1]},
                           (int)o.n[0], (int)o.n[1]};
        const char *bad = cut_profiles(&cut, &profiles);
        if (bad) return complain("not understood", bad);
        what = judge_horizon(&profiles);
    } else {
        err = o.text ? from_formula(&r, o.text, (int[2]){(int)o.n[0], (int)o.n[1]}, o.x, o.y, o.limit)
                     : from_file(&r, o.grid, o.limit);
        if (err) return err;
        r.eye = v.eye;
        what = judge_surface(&r);
    }
    judge_seg_report_t rep;
    judge_segments(&what, &v, seg, n, &rep);
    if (!o.quiet) report(&rep, n);
    bool good = rep.pieces.missing_mm <= JUDGE_STEP_MM && rep.false_mm <= JUDGE_STEP_MM && rep.pieces.end_steps <= .25;
    free(seg);
    free(r.x);
    free(r.y);
    free(r.z);
    free(r.hole);
    free((void *)profiles.first);
    free((void *)profiles.point);
    free((void *)profiles.gap);
    return good ? 0 : 1;
}
