/* Polygons with a tone on a face (`d ... tone P`), from OBJ text to parts of the visible polygon: at random places of
 * the face, has the part that a place falls into the tone of the last patch around it, and is there one part there? The
 * reference knows nothing of clipping or pages: patches are chosen in the face's own plane, as even-odd contours of
 * whole numbers, and that is where it looks. Faces may reach behind the eye, patches over the border of the face, and
 * the face may be there three times, with patches on each.
 *
 * Places which rounding to the lattice may move over a border are left out. RIDGELINE_CASES tries so many times more,
 * RIDGELINE_SEED=n one. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "error.h"
#include "hidden/area/area_patch.h"
#include "num/num_double.h"
#include "scene/obj_reader.h"
#include "tests/oracle/num_of.h"
#include "tests/oracle/run_cases.h"

#define SIDE 16 /* of the face, in its own plane */
#define PATCHES 5
#define CONTOURS 3
#define CORNERS 7
#define PLACES 60

typedef struct contour {
    int n, at[CORNERS][2];
} contour_t;

typedef struct patch {
    contour_t contour[CONTOURS];
    int contours, percent;
} patch_t;

typedef struct part {
    poly_point_t v[500];
    int32_t end[100], contours, percent;
} part_t;

static struct {
    patch_t patch[PATCHES];
    int patches;
    int origin[3], u[3], v[3];
    char text[8192];
    solid_t solid;
    solid_map_t map;
    camera_t cam;
    area_lattice_t lattice;
    part_t part[40];
    int parts;
} c;

static struct { long long faces, behind, places, patched, left_out, wrong; } tally;

static uint64_t rng;

static int below(int n) {
    return scene_below(&rng, n);
}

/* ---- the scene ---- */

static void write_vertex(const int at[2], char **to) {
    for (int k = 0; k < 3; k++)
        *to += sprintf(*to, "%s%d", k ? " " : "v ", c.origin[k] + at[0] * c.u[k] + at[1] * c.v[k]);
    *to += sprintf(*to, "\n");
}

static void write_patch(const patch_t *p, char **to) {
    for (int k = 0; k < p->contours; k++)
        for (int i = 0; i < p->contour[k].n; i++) write_vertex(p->contour[k].at[i], to);
    int corners = 0;
    for (int k = 0; k < p->contours; k++) corners += p->contour[k].n;
    for (int k = 0; k < p->contours; k++) {
        *to += sprintf(*to, k ? " h" : "d");
        for (int i = 0; i < p->contour[k].n; i++) *to += sprintf(*to, " %d", -corners--);
    }
    *to += sprintf(*to, " tone %d\n", p->percent);
}

static void write_scene(void) {
    static const int face[4][2] = {{0, 0}, {SIDE, 0}, {SIDE, SIDE}, {0, SIDE}};
    char *to = c.text;
    for (int k = 0; k < 4; k++) write_vertex(face[k], &to);
    to += sprintf(to, "f 1 2 3 4\n");
    const bool again = below(3) == 0; /* three times, of which one stays (solid_double.c) */
    if (again) to += sprintf(to, "d 1 2\nf 4 3 2 1\n");
    for (int k = 0; k < c.patches; k++) {
        if (below(3) == 0) to += sprintf(to, "d 1 3\n"); /* lines among them */
        if (again && k == 1) to += sprintf(to, "f 3 4 1 2\n");
        write_patch(&c.patch[k], &to);
    }
    if (again && c.patches < 2) to += sprintf(to, "f 3 4 1 2\n");
}

static void choose(void) {
    do
        for (int k = 0; k < 3; k++) c.origin[k] = below(41) - 20, c.u[k] = below(9) - 4, c.v[k] = below(9) - 4;
    while (c.u[0] * c.v[1] == c.u[1] * c.v[0] && c.u[1] * c.v[2] == c.u[2] * c.v[1] &&
           c.u[2] * c.v[0] == c.u[0] * c.v[2]);
    c.patches = below(PATCHES + 1);
    for (int p = 0; p < c.patches; p++) {
        patch_t *to = &c.patch[p];
        *to = (patch_t){.contours = 1 + below(CONTOURS), .percent = below(100)};
        for (int k = 0; k < to->contours; k++) {
            to->contour[k].n = 3 + below(CORNERS - 2);
            for (int i = 0; i < to->contour[k].n; i++)
                for (int a = 0; a < 2; a++) to->contour[k].at[i][a] = below(SIDE + 5) - 2;
        }
    }
    write_scene();
}

static int take_part(void *ctx, const poly_t *p, int32_t percent) {
    (void)ctx;
    part_t *to = &c.part[c.parts++];
    assert_true(c.parts <= 40 && poly_vertices(p) <= 500 && p->contours <= 100);
    to->percent = percent;
    to->contours = p->contours;
    for (int32_t k = 0; k < poly_vertices(p); k++) to->v[k] = p->v[k].at;
    memcpy(to->end, p->end, (size_t)p->contours * sizeof *p->end);
    return 0;
}

/* From text to parts. False: nothing can be seen of the face. */
static bool make(void) {
    static packed_t memory[4096];
    static uint64_t lent[60000], place[4096], work[60000], clip[60000];
    obj_reader_t r;
    mesh_t mesh;
    const mesh_t *list[1] = {&mesh};
    data_pool_t pool = {memory, 0, 4096};
    settings_t set;
    obj_reader_start(&r, &pool, NULL, false, 0);
    int err = obj_reader_feed(&r, c.text, strlen(c.text));
    if (!err) err = obj_reader_finish(&r, &mesh);
    if (!err) err = solid_build(&c.solid, list, 1, lent, sizeof lent);
    assert_int_equal(err, 0);
    settings_default(&set);
    view_box_t box = {.solid = true};
    set.view.rot_x = num_from_i64(below(180));
    set.view.rot_z = num_from_i64(below(360));
    set.view.from = below(3) != 0;
    for (int k = 0; k < 3; k++) {
        set.view.eye[k] = num_from_i64(below(161) - 80);
        box.lo[k] = c.solid.lo[k];
        box.hi[k] = c.solid.hi[k];
    }
    if (camera_setup(&c.cam, &set, &box) || solid_map_setup(&c.map, &c.solid, &c.cam, place)) return false;
    c.lattice = area_lattice(&c.map);
    area_patches_t patches;
    area_patches_init(&patches, &c.lattice, work, sizeof work);
    poly_vertex_t v[AREA_CORNERS(true, 4)];
    area_corner_t scratch[2 * AREA_CORNERS(true, 4)];
    const int32_t n = area_face_place(&c.lattice, &c.solid.face[0], NULL, v, scratch, AREA_CORNERS(c.lattice.clips, 4));
    c.parts = 0;
    tally.behind += c.map.any_behind;
    if (n < 3) return false;
    const area_patch_sink_t sink = {NULL, take_part};
    assert_int_equal(area_patches_cut(&patches, 0, &(poly_t){v, &n, 1}, clip, sizeof clip, &sink), 0);
    return true;
}

/* ---- judging ---- */

/* What the face is at a place of its plane: percent, -1 outside. */
static int expected(double x, double y) {
    int percent = x > 0 && y > 0 && x < SIDE && y < SIDE ? 100 : -1;
    for (int p = 0; p < c.patches && percent >= 0; p++) {
        bool inside = false;
        for (int k = 0; k < c.patch[p].contours; k++) {
            const contour_t *q = &c.patch[p].contour[k];
            for (int i = 0; i < q->n; i++) {
                const int *a = q->at[i], *b = q->at[(i + 1) % q->n];
                if ((a[1] > y) != (b[1] > y) && a[0] + (double)(b[0] - a[0]) * (y - a[1]) / (b[1] - a[1]) > x)
                    inside = !inside;
            }
        }
        if (inside) percent = c.patch[p].percent;
    }
    return percent;
}

/* In units of the lattice. False: not in front of the eye, or off the page. */
static bool project(double x, double y, double at[2]) {
    double h[3];
    for (int r = 0; r < 3; r++) {
        h[r] = num_value(c.cam.m[r][3]);
        for (int k = 0; k < 3; k++) h[r] += num_value(c.cam.m[r][k]) * (c.origin[k] + x * c.u[k] + y * c.v[k]);
    }
    const page_window_t *w = &c.cam.window;
    for (int r = 0; r < 2; r++) at[r] = ldexp(h[r] / h[2], c.lattice.bits);
    return h[2] > 0 && at[0] > ldexp(w->x0_lat, c.lattice.bits) && at[0] < ldexp(w->x1_lat, c.lattice.bits) &&
           at[1] > ldexp(w->y0_lat, c.lattice.bits) && at[1] < ldexp(w->y1_lat, c.lattice.bits);
}

/* How far a few units of the page may be along the face; huge where it is seen edge-on. */
static double few_units(double x, double y, const double at[2]) {
    const double h = 1e-4;
    double u[2], v[2];
    if (!project(x + h, y, u) || !project(x, y + h, v)) return INFINITY;
    const double a = (u[0] - at[0]) / h, b = (v[0] - at[0]) / h, d = (u[1] - at[1]) / h, e = (v[1] - at[1]) / h;
    const double det = fabs(a * e - b * d), size = sqrt(a * a + b * b + d * d + e * e);
    return det > 0 ? 4 * size / det : INFINITY; /* at least 4 / the lesser singular value */
}

static bool is_in(const part_t *p, const double at[2]) {
    bool inside = false;
    for (int32_t k = 0, first = 0; k < p->contours; first = p->end[k++])
        for (int32_t i = first; i < p->end[k]; i++) {
            const poly_point_t a = p->v[i], b = p->v[i + 1 < p->end[k] ? i + 1 : first];
            if ((a.y > at[1]) != (b.y > at[1]) &&
                a.x + ((double)b.x - a.x) * (at[1] - a.y) / ((double)b.y - a.y) > at[0])
                inside = !inside;
        }
    return inside;
}

static bool judge_place(void) {
    const double x = SIDE * scene_uniform(&rng), y = SIDE * scene_uniform(&rng);
    const int want = expected(x, y);
    double at[2], margin;
    if (!project(x, y, at)) return true;
    margin = few_units(x, y, at);
    bool sure = margin < 1;
    for (int k = 0; k < 8 && sure; k++)
        sure = expected(x + margin * cos(k * .785398), y + margin * sin(k * .785398)) == want;
    tally.places += sure;
    tally.left_out += !sure;
    if (!sure) return true;
    int found = 0, percent = -1;
    for (int k = 0; k < c.parts; k++)
        if (is_in(&c.part[k], at)) found++, percent = c.part[k].percent;
    tally.patched += want < 100;
    if (found == 1 && percent == want) return true;
    tally.wrong++;
    print_message("# (%g, %g): %d parts, %d %% instead of %d\n", x, y, found, percent, want);
    return false;
}

static void tones_are_where_patches_are(void **state) {
    uint64_t first, to;
    int wrong = 0;
    (void)state;
    assert_true(cases_seeds(0, cases_scaled(4000), &first, &to));
    for (uint64_t seed = first; seed < to && wrong < 3; seed++) {
        rng = seed;
        choose();
        if (!make()) continue;
        tally.faces++;
        bool good = true;
        for (int k = 0; k < PLACES && good; k++) good = judge_place();
        if (good) continue;
        wrong++;
        print_message("# FAILED RIDGELINE_SEED=%llu build/tests/property/test_patch_random\n%s",
                      (unsigned long long)seed, c.text);
    }
    print_message("# patches: %lld faces (something is behind the eye of %lld), %lld places, %lld on a patch, %lld too "
                  "near to a border; %lld wrong\n",
                  tally.faces, tally.behind, tally.places, tally.patched, tally.left_out, tally.wrong);
    assert_int_equal(wrong, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(tones_are_where_patches_are)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
