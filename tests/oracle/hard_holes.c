/* hard_holes.c - see hard_holes.h. */
#include "tests/oracle/hard_holes.h"

#include "tests/oracle/hard_bodies.h"

/* A face of contours, the first one outer, over the plane z = slope x: each hole is joined to it by a cut gone along
 * both ways and runs the other way round than the face, as the OBJ reader makes them. */
typedef struct outline {
    int n;
    double xy[12][2];
} outline_t;

static double area(const outline_t *o) {
    double sum = 0;
    for (int k = 0; k < o->n; k++) {
        const double *p = o->xy[k], *q = o->xy[(k + 1) % o->n];
        sum += p[0] * q[1] - p[1] * q[0];
    }
    return sum;
}

static void holed(solid_ref_t *r, const outline_t *contour, int contours, double slope) {
    int v[64], n = 0;
    for (int c = 0; c < contours; c++) {
        if (c > 0) v[n++] = v[0];
        const int first = n;
        const bool turned = c > 0 && area(&contour[0]) * area(&contour[c]) > 0;
        for (int k = 0; k < contour[c].n; k++) {
            const double *p = contour[c].xy[turned ? contour[c].n - 1 - k : k];
            v[n++] = solid_ref_vertex(r, p[0], p[1], slope * p[0]);
        }
        if (c > 0) v[n++] = v[first];
    }
    solid_ref_face(r, v, n);
}

/* What is behind, in front of and in the holes of it. */
static void surroundings(solid_ref_t *r) {
    static const double back[][3] = {{-1, 1, -2.05}, {9, 2, -1.55}, {8, 7, -1.6}, {0, 6, -2}},
                        front[][3] = {{1, -1, 3.9}, {2, -1, 3.9}, {2.5, 9, 4.9}, {1.5, 9, 4.9}};
    hard_polygon(r, back, 4);
    hard_polygon(r, front, 4);
    hard_box(r, 2.4, 2.3, -1, 0.5, 0.5, 4);
}

/* A macro: clang takes no constant object in the initializer of another. */
#define SQUARE                                                                                                         \
    {                                                                                                                  \
        4, {                                                                                                           \
            {0, 0}, {8, 0}, {8, 8}, {                                                                                  \
                0, 8                                                                                                   \
            }                                                                                                          \
        }                                                                                                              \
    }

static const outline_t touching[HARD_HOLES][3] = {
    {SQUARE, {3, {{0, 4}, {5, 2}, {5, 6}}}},                                                /* on an edge */
    {SQUARE, {4, {{2, 4}, {0, 0}, {4, 2}, {4, 4}}}},                                        /* in a corner */
    {SQUARE, {4, {{2, 6}, {0, 0}, {6, 2}, {8, 8}}}},                                        /* in two corners */
    {SQUARE, {4, {{2, 2}, {4, 2}, {4, 4}, {2, 4}}}, {4, {{4, 4}, {6, 4}, {6, 6}, {4, 6}}}}, /* each other */
    {SQUARE, {4, {{0, 4}, {4, 2}, {8, 4}, {4, 6}}}, {4, {{4, 6}, {5, 7}, {4, 8}, {3, 7}}}}, /* all of it */
    {SQUARE, {4, {{1, 1}, {7, 1}, {7, 7}, {1, 7}}}, {4, {{1, 4}, {4, 1}, {7, 4}, {4, 7}}}}, /* one in another */
};

void hard_hole(solid_ref_t *r, int k) {
    holed(r, touching[k], touching[k][2].n ? 3 : 2, 0.2);
    surroundings(r);
}

static const struct {
    int contours;
    outline_t hole[3], notched;
} notches[HARD_NOTCHES] = {
    {2,
     {SQUARE, {4, {{0, 3}, {4, 3}, {4, 5}, {0, 5}}}},
     {8, {{0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 5}, {4, 5}, {4, 3}, {0, 3}}}},
    {2, {SQUARE, {4, {{0, 0}, {3, 0}, {3, 2}, {0, 2}}}}, {6, {{3, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 2}, {3, 2}}}},
    {2, {SQUARE, {4, {{0, 0}, {8, 0}, {8, 2}, {0, 2}}}}, {4, {{0, 2}, {8, 2}, {8, 8}, {0, 8}}}},
    {3,
     {SQUARE, {4, {{0, 2}, {3, 2}, {3, 4}, {0, 4}}}, {4, {{0, 4}, {3, 4}, {3, 6}, {0, 6}}}},
     {8, {{0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 6}, {3, 6}, {3, 2}, {0, 2}}}},
};

void hard_notch(solid_ref_t *r, int k, bool notched) {
    if (notched)
        holed(r, &notches[k].notched, 1, 0.2);
    else
        holed(r, notches[k].hole, notches[k].contours, 0.2);
    surroundings(r);
}
