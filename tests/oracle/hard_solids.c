/* The list, and how an entry becomes a scene. */
#include "tests/oracle/hard_solids.h"

#include <stdio.h>

#include "tests/oracle/hard_bodies.h"
#include "tests/oracle/hard_holes.h"
#include "tests/oracle/num_of.h"

static void three_bars(solid_ref_t *r) {
    hard_circle(r, 3);
}
static void thirteen_bars(solid_ref_t *r) {
    hard_circle(r, 13);
}

#define HOLE(k)                                                                                                        \
    static void hole_##k(solid_ref_t *r) {                                                                             \
        hard_hole(r, k);                                                                                               \
    }
HOLE(0)
HOLE(1)
HOLE(2)
HOLE(3)
HOLE(4)
HOLE(5)
static void notches(solid_ref_t *r) {
    hard_notch(r, 3, true);
}

static const struct {
    const char *name;
    void (*make)(solid_ref_t *r);
    bool from; /* the eye; or gnuplot's angles */
    double at[3];
    int every;
} list[] = {
    /* Where the viewer stands. */
    {"4x4 cubes", hard_cubes, false, {65, 30, 0}, 0},
    {"viewer in planes of faces", hard_cubes, true, {2.5, -6, 1}, 0},
    {"viewer on the line of an edge", hard_cubes, true, {-4, 1, 1}, 0},
    {"viewer over a vertex", hard_cubes, true, {1, 1, 4}, 0},
    {"viewer over the middle", hard_cubes, true, {2.75, 2.75, 7}, 0},
    {"viewer below", hard_cubes, true, {4, -5, -3}, 0},
    {"viewer level with the tops", hard_cubes, true, {7.3, -4.9, 1}, 0},
    {"viewer grazing the tops", hard_cubes, true, {-3, 2.6, 1.0005}, 0},
    {"viewer 1e6 away", hard_cubes, true, {6e5, -8e5, 3e5}, 0},
    {"viewer 1e-3 from a face", hard_flush, true, {3.501, .4, 1.2}, 0},
    {"viewer inside of a closed box", hard_one_box, true, {.3, .2, .1}, 0},
    {"viewer among flush walls", hard_flush, true, {1.7, 2.2, .7}, 0},
    {"everything behind or beside the viewer", hard_needles, true, {.8, .1, .2}, 0},
    /* What coincides. */
    {"faces exactly edge-on", hard_cubes, false, {90, 0, 0}, 0},
    {"exactly coincident edges, from above", hard_cubes, false, {0, 0, 0}, 0},
    {"crossings at vertices, isometric lattice", hard_lattice, false, {54.735610317245346, 45, 0}, 0},
    {"faces that touch: flush walls", hard_flush, false, {60, 40, 0}, 0},
    {"faces in one plane, one there twice", hard_one_plane, false, {40, 70, 0}, 0},
    {"planes 1e-9 apart", hard_billionth, false, {50, 20, 0}, 0},
    {"near-parallel edges", hard_fan, false, {55, 15, 0}, 0},
    /* Order. */
    {"two that overlap cyclically", hard_brackets, false, {20, 10, 0}, 0},
    {"nine that overlap cyclically", hard_bars, false, {25, 0, 0}, 0},
    {"three that overlap cyclically", three_bars, false, {25, 0, 0}, 0},
    {"thirteen that overlap cyclically", thirteen_bars, false, {25, 0, 0}, 0},
    {"bodies that penetrate", hard_penetrating, false, {60, 30, 0}, 0},
    /* Shapes. */
    {"a face cut through by another", hard_cut, false, {60, 20, 0}, 0},
    {"slivers below a step", hard_slivers, false, {50, 30, 0}, 0},
    {"a needle from its end", hard_needle, false, {2, 100, 0}, 0},
    {"plates thinner than a step", hard_plates, false, {75, 35, 0}, 0},
    {"twisted quads", hard_twisted, false, {65, 20, 0}, 0},
    {"concave, with a window", hard_window, false, {30, 20, 0}, 0},
    {"a hole that touches an edge", hole_0, false, {40, 25, 0}, 0},
    {"a hole in a corner", hole_1, false, {40, 25, 0}, 0},
    {"a hole in two corners", hole_2, false, {40, 25, 0}, 0},
    {"holes that touch each other", hole_3, false, {40, 25, 0}, 0},
    {"holes that touch all there is", hole_4, false, {40, 25, 0}, 0},
    {"a hole in a hole", hole_5, false, {40, 25, 0}, 0},
    {"holes along an edge, a notch", notches, false, {40, 25, 0}, 0},
    {"concave prisms", hard_angles, false, {60, 30, 0}, 0},
    {"open: a box without walls", hard_open_sides, false, {60, 30, 0}, 0},
    {"broken: no area, there twice, a corner twice", hard_broken, false, {60, 30, 0}, 0},
    /* Sizes. */
    {"1e6 and 1 in one scene", hard_large_and_small, false, {60, 30, 0}, 0},
    {"a world of 1e-6", hard_millionth, false, {60, 30, 0}, 0},
    {"segments alone", hard_segment, false, {60, 30, 0}, 0},
    {"14x14 cubes, some edges judged", hard_many_cubes, false, {65, 30, 0}, 61},
};

int hard_solids_count(void) {
    return (int)(sizeof list / sizeof *list);
}

const char *hard_solids_name(int i) {
    return list[i].name;
}

int hard_solids_build(int i, solid_scene_t *s) {
    const double *at = list[i].at;
    *s = (solid_scene_t){0};
    settings_default(&s->set);
    list[i].make(&s->ref);
    solid_ref_finish(&s->ref);
    s->set.view.from = list[i].from;
    for (int k = 0; k < 3; k++) s->set.view.eye[k] = num_of(at[k]);
    s->set.view.rot_x = num_of(at[0]);
    s->set.view.rot_z = num_of(at[1]);
    if (list[i].from)
        snprintf(s->what, sizeof s->what, "%s (eye %g,%g,%g)", list[i].name, at[0], at[1], at[2]);
    else
        snprintf(s->what, sizeof s->what, "%s (view %g,%g)", list[i].name, at[0], at[1]);
    return list[i].every;
}
