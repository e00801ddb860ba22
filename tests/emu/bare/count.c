/* count.c - what drawings and expressions cost on a core: bare_mark() before and after each, one line of what it was.
 *
 *     kernel family bits facets        then the marks: the drawing, heights at hand, ink dropped
 *     format expression points         then the marks: so many evaluations
 *
 * Every family at every number of bits below a step (tests/report/lattice.h), the shipped one first.
 * tests/report/boards.sh puts lines and marks together. */
#include "tests/emu/bare/bare.h"
#include "tests/emu/bare/formats.h"
#include "tests/emu/bare/integer_scene.h"
#include "tests/report/lattice.h"

#include <stddef.h>

#ifndef COUNT_POINTS
#define COUNT_POINTS 40 /* a side */
#endif

static const char *const kernel_name[] = {"perimeter", "windows", "horizon"};
static const char *const family_name[] = {"smooth", "random", "cliffs", "grazing", "far"};
static integer_scene_t scene;

static int drop(void *ctx, const ink_piece_t *p) {
    *(int64_t *)ctx += (p->to - p->from) >> 16; /* far from overflow */
    return 0;
}

static void line(const char *a, const char *b, int64_t c, int64_t d) {
    bare_text(a);
    bare_text("\t");
    bare_text(b);
    bare_text("\t");
    bare_number(c);
    bare_text("\t");
    bare_number(d);
    bare_text("\n");
}

static void draw(enum integer_kernel kernel, enum integer_family family, int bits) {
    int64_t ink = 0;
    ink_sink_t sink = {&ink, drop};
    hidden_stats_t stats = {0};
    lattice_shift = lattice_shift_for(bits);
    lattice_profiles = kernel == KERNEL_HORIZON;
    bare_mark();
    int err = integer_scene_draw(&scene, kernel, &sink, &stats);
    bare_mark();
    line(kernel_name[kernel], family_name[family], bits, err ? err : stats.facets);
    lattice_shift = 0;
}

static void kernels(void) {
    static const int bits[] = {0, 2, 4, 8};
    for (enum integer_kernel kernel = KERNEL_PERIMETER; kernel <= KERNEL_HORIZON; kernel++)
        for (enum integer_family family = FAMILY_SMOOTH; family <= FAMILY_FAR; family++) {
            integer_scene_family(&scene, family, COUNT_POINTS, kernel == KERNEL_WINDOWS);
            if (integer_scene_measure(&scene)) return;
            draw(kernel, family, LATTICE_SHIPPED);
            for (size_t i = 0; i < sizeof bits / sizeof *bits; i++)
                draw(kernel, family, bits[i]);
        }
}

static void expressions(void) {
    for (int format = 0; format < FORMATS; format++)
        for (int formula = 0; formula < FORMULAS; formula++) {
            bare_mark();
            int points = formats_run((enum formats_format)format, (enum formats_formula)formula);
            bare_mark();
            line(formats_name[format], formats_formula_name[formula], 0, points);
        }
}

int bare_main(int argc, char **argv) {
    (void)argc, (void)argv;
    kernels();
    expressions();
    return 0;
}
