/* hard_lights.c - see hard_lights.h. A yard: a ground, a box on it, a wall with a gate, a board that leans on nothing,
 * a pole. */
#include "tests/oracle/hard_lights.h"

#include <stdio.h>

#include "tests/oracle/hard_bodies.h"
#include "tests/oracle/num_of.h"

typedef struct lamp {
    double at[3];
    bool point;
} lamp_t;

static const struct {
    const char *name;
    int lights;
    lamp_t of[4];
    bool low; /* the eye, too */
} list[] = {
    {"from above, aslant", 1, {{{-2, -3, 4}, false}}, false},
    {"at 1 to 10", 1, {{{-10, -4, 1}, false}}, false},
    {"at 1 to 100", 1, {{{-100, -40, 1}, false}}, false},
    {"at 1 to 1000", 1, {{{-1000, -400, 1}, false}}, false},
    {"at 1 to 7500, the last that counts", 1, {{{-7000, -2690, 1}, false}}, false},
    {"at 1 to 9000, which does not", 1, {{{-9000, 0, 1}, false}}, false},
    {"in the plane of the ground", 1, {{{-1, -.4, 0}, false}}, false},
    {"from below by a hair", 1, {{{-1, -.4, -1e-6}, false}}, false},
    {"from straight above: walls edge-on", 1, {{{0, 0, 1}, false}}, false},
    {"along the wall, and down", 1, {{{1, 0, 1}, false}}, false},
    {"along the wall, a hair before it", 1, {{{1, -1e-4, 1}, false}}, false},
    {"along the edge of a box", 1, {{{-1, 0, 0}, false}}, false},
    {"in the plane of the board", 1, {{{-1, 0, 1}, false}}, false},
    {"where the eye is", 1, {{{4, -11, 6}, true}}, false},
    {"opposite the eye", 1, {{{-4, 11, 6}, true}}, false},
    {"a lamp a hair above the ground", 1, {{{-9, -3, .01}, true}}, false},
    {"a lamp right above the box", 1, {{{-1.5, -1, 11}, true}}, false},
    {"two that graze against each other", 2, {{{-100, 0, 1}, false}, {{100, 0, 1}, false}}, false},
    {"four from all sides",
     4,
     {{{-2, 0, 1}, false}, {{2, 0, 1}, false}, {{0, -2, 1}, false}, {{0, 2, 1}, false}},
     false},
    {"grazing, seen grazing", 1, {{{-100, -40, 1}, false}}, true},
};

int hard_lights_count(void) {
    return (int)(sizeof list / sizeof *list);
}
const char *hard_lights_name(int i) {
    return list[i].name;
}

static void yard(solid_ref_t *r) {
    static const double ground[][3] = {{-6, -4, 0}, {6, -4, 0}, {6, 4, 0}, {-6, 4, 0}},
                        board[][3] = {{1, -2.5, 2.5}, {2.5, -2.5, 1}, {2.5, -.5, 1}, {1, -.5, 2.5}};
    static const double wall[][2] = {{-1, 0}, {5, 0},   {5, 2},   {-1, 2}, {-1, 0},
                                     {1, .4}, {1, 1.6}, {3, 1.6}, {3, .4}, {1, .4}};
    hard_polygon(r, ground, 4);
    hard_box(r, -3, -2, 0, 1.5, 2, 1.5);
    hard_polygon(r, board, 4);
    hard_box(r, -4.5, 1.5, 0, .1, .1, 3);
    int v[10];
    for (int k = 0; k < 10; k++) v[k] = k == 4 ? v[0] : k == 9 ? v[5] : solid_ref_vertex(r, wall[k][0], 2, wall[k][1]);
    solid_ref_face(r, v, 10);
}

int hard_lights_build(int i, solid_scene_t *s, light_t *light) {
    static const double eye[2][3] = {{4, -11, 6}, {4, -11, .4}};
    *s = (solid_scene_t){0};
    settings_default(&s->set);
    yard(&s->ref);
    solid_ref_finish(&s->ref);
    s->set.view.from = true;
    for (int k = 0; k < 3; k++) s->set.view.eye[k] = num_of(eye[list[i].low][k]);
    snprintf(s->what, sizeof s->what, "%s", list[i].name);
    for (int l = 0; l < list[i].lights; l++) {
        light[l] = (light_t){.point = list[i].of[l].point};
        for (int k = 0; k < 3; k++) light[l].at[k] = num_of(list[i].of[l].at[k]);
    }
    return list[i].lights;
}
