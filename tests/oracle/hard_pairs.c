/* hard_pairs.c - see hard_pairs.h. Coordinates are written out, a contour as x, y, x, y ... END, a polygon up to a
 * second END; where crossings are rounded, so small that it can be seen. */
#include "tests/oracle/hard_pairs.h"

#include <stddef.h>

#include "tests/oracle/clip_families.h"

#define END INT32_MIN
#define SQUARE 0, 0, 12, 0, 12, 12, 0, 12, END

typedef struct pair {
    const char *name;
    bool nonzero;
    int32_t at[2][80];
    int family; /* > 0: that one, the number less one, of seed at[0][0] */
} pair_t;

static const pair_t list[] = {
    {"one polygon twice", false, {{SQUARE, END}, {SQUARE, END}}, 0},
    {"the same, the other way round", false, {{SQUARE, END}, {0, 0, 0, 12, 12, 12, 12, 0, END, END}}, 0},
    {"a unit apart", false, {{SQUARE, END}, {1, 1, 13, 1, 13, 13, 1, 13, END, END}}, 0},
    {"side by side: an edge in common", false, {{SQUARE, END}, {12, 0, 20, 0, 20, 12, 12, 12, END, END}}, 0},
    {"parts of edges in common", false, {{SQUARE, END}, {12, 4, 18, 4, 18, 8, 8, 8, 8, 12, 4, 12, 4, 4, END, END}}, 0},
    {"a corner in common", false, {{SQUARE, END}, {12, 12, 20, 12, 20, 20, 12, 20, END, END}}, 0},
    {"a corner on an edge", false, {{SQUARE, END}, {6, 12, 12, 18, 0, 18, END, END}}, 0},
    {"an edge through a corner", false, {{SQUARE, END}, {6, 18, 18, 6, 18, 18, END, END}}, 0},
    {"a hole that is the clip polygon",
     false,
     {{SQUARE, 3, 3, 9, 3, 9, 9, 3, 9, END, END}, {3, 3, 9, 3, 9, 9, 3, 9, END, END}},
     0},
    {"a hole that touches its contour",
     false,
     {{SQUARE, 0, 6, 6, 3, 6, 9, END, END}, {2, -2, 8, -2, 8, 14, 2, 14, END, END}},
     0},
    {"a hole in two corners",
     false,
     {{SQUARE, 0, 0, 9, 3, 12, 12, 3, 9, END, END}, {0, 12, 12, 0, 14, 2, 2, 14, END, END}},
     0},
    {"holes that touch each other",
     false,
     {{SQUARE, 2, 2, 6, 2, 6, 6, 2, 6, END, 6, 6, 10, 6, 10, 10, 6, 10, END, END}, {4, 4, 8, 4, 8, 8, 4, 8, END, END}},
     0},
    {"holes that leave nothing between",
     false,
     {{SQUARE, 2, 2, 6, 2, 6, 10, 2, 10, END, 6, 2, 10, 2, 10, 10, 6, 10, END, END},
      {5, -1, 7, -1, 7, 13, 5, 13, END, END}},
     0},
    {"rings that touch, four deep",
     false,
     {{-16, -16, 16, -16, 16, 16, -16, 16,  END, -16, 0, 0,  -16, 16, 0, 0, 16,  END, -8,
       -8,  8,   -8, 8,   8,  -8, 8,   END, -8,  0,   0, -8, 8,   0,  0, 8, END, END},
      {0, -18, 18, 0, 0, 18, -18, 0, END, END}},
     0},
    {"bow ties", false, {{0, 0, 12, 12, 12, 0, 0, 12, END, END}, {0, 0, 12, 12, 0, 12, 12, 0, END, END}}, 0},
    {"a star with five points, twice around",
     true,
     {{10, 0, 16, 19, 0, 7, 20, 7, 4, 19, END, END}, {2, 2, 18, 2, 18, 18, 2, 18, END, END}},
     0},
    {"the same by even and odd",
     false,
     {{10, 0, 16, 19, 0, 7, 20, 7, 4, 19, END, END}, {2, 2, 18, 2, 18, 18, 2, 18, END, END}},
     0},
    {"spikes, corners twice, no area",
     false,
     {{0, 0, 12, 0, 18, 0, 12, 0, 12, 12, 12, 12, 0, 12, 0, 18, 0, 12, END, 3, 3, 9, 9, END, 5, 1, END, END},
      {6, -3, 6, 15, 15, 6, 6, 6, 15, 6, END, END}},
     0},
    {"combs that interlock",
     false,
     {{0, 0, 20, 0, 20, 10, 18, 10, 18, 2, 14, 2, 14, 10, 10, 10, 10, 2, 6, 2, 6, 10, 2, 10, 2, 2, 0, 2, END, END},
      {0, 12, 20, 12, 20, 10, 18, 10, 18, 2, 14, 2, 14, 10, 10, 10, 10, 2, 6, 2, 6, 10, 2, 10, 2, 2, 0, 2, END, END}},
     0},
    {"near-parallel edges", false, {{0, 0, 40, 1, 40, 3, 0, 2, END, END}, {0, 1, 40, 0, 40, 2, 0, 3, END, END}}, 0},
    {"needles through one place", false, {{76, 0}, {0}}, 6},
    {"fans round one corner", false, {{20, 0}, {0}}, 5},
    {"checkerboards", false, {{83, 0}, {0}}, 3},
    {"terraces", false, {{482, 0}, {0}}, 2},
    {"walks that cross themselves", false, {{165, 0}, {0}}, 7},
    {"spirals", false, {{46, 0}, {0}}, 9},
};

int hard_pairs_count(void) {
    return (int)(sizeof list / sizeof *list);
}
const char *hard_pairs_name(int i) {
    return list[i].name;
}

static void shape(clip_shape_t *s, const int32_t *at) {
    clip_shape_clear(s);
    while (*at != END) {
        for (; *at != END; at += 2) clip_shape_add(s, at[0], at[1]);
        clip_shape_close(s);
        at++;
    }
}

void hard_pairs_build(int i, clip_shape_t *subject, clip_shape_t *clip, enum clip_fill *fill) {
    const pair_t *p = &list[i];
    *fill = p->nonzero ? CLIP_NONZERO : CLIP_EVEN_ODD;
    if (p->family) {
        clip_family_make(p->family - 1, (uint64_t)p->at[0][0], subject, clip, fill);
        return;
    }
    shape(subject, p->at[0]);
    shape(clip, p->at[1]);
}
