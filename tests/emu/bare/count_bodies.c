/* count_bodies.c - see count_bodies.h. */
#include "tests/emu/bare/count_bodies.h"

#include <math.h>

#include "num/num.h"
#include "tests/bench/stars.h"
#include "tests/emu/bare/integer_scene.h"

#define CUBES 4  /* a side */
#define AROUND 8 /* points of a ring, and rings */
#define BOXES 12

const char *const body_name[BODIES] = {"cubes", "torus", "ball", "random"};

static packed_t vertex[BODY_VERTICES][3];
static int32_t word[BODY_WORDS];
static mesh_t mesh;

static int32_t put(double x, double y, double z) {
    const double at[3] = {x, y, z};
    for (int k = 0; k < 3; k++)
        vertex[mesh.nv][k] = packed_from_num(num_from_fixed((int64_t)floor(at[k] * 1048576 + .5), 20));
    return mesh.nv++;
}

static void face(const int32_t *v, int32_t n) {
    int32_t *w = word + BODY_WORDS - mesh.words;
    *--w = n << 2 | MESH_FACE;
    for (int32_t k = 0; k < n; k++) *--w = v[k];
    mesh.words += n + 1;
    mesh.faces++;
    mesh.corners += n;
}

/* The parallelepiped of three edges at a corner. */
static void box(const double at[3], double edge[3][3]) {
    static const uint8_t side[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                       {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    int32_t v[8], w[4];
    for (int c = 0; c < 8; c++) {
        double p[3];
        for (int k = 0; k < 3; k++)
            p[k] = at[k] + (c & 1) * edge[0][k] + (c >> 1 & 1) * edge[1][k] + (c >> 2) * edge[2][k];
        v[c] = put(p[0], p[1], p[2]);
    }
    for (int f = 0; f < 6; f++) {
        for (int c = 0; c < 4; c++) w[c] = v[side[f][c]];
        face(w, 4);
    }
}

static void cubes(void) {
    double edge[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int n = 0; n < CUBES * CUBES; n++) box((double[]){1.5 * (n % CUBES), 1.5 * (n / CUBES), 0}, edge);
}

/* Rings around the z axis: of a torus, or of a ball, whose first and last are a point. */
static void rings(double hole) {
    const double turn = 6.283185307179586 / AROUND;
    const int n = hole > 0 ? AROUND : AROUND - 1;
    for (int k = 0; k < AROUND * AROUND; k++) {
        const double a = turn * (k % AROUND), b = hole > 0 ? turn * (k / AROUND) : turn / 2 * AROUND / n * (k / AROUND);
        const bool pole = hole <= 0 && (k / AROUND == 0 || k / AROUND == n);
        const double far = pole ? 0 : hole > 0 ? hole + cos(b) : sin(b);
        put(far * cos(a), far * sin(a), hole > 0 ? sin(b) : cos(b));
    }
    for (int j = 0; j < n; j++)
        for (int i = 0; i < AROUND; i++) {
            const int32_t up = (j + 1) % AROUND * AROUND, on = (i + 1) % AROUND;
            const int32_t p = j * AROUND + i, q = j * AROUND + on, r = up + on, s = up + i;
            face((int32_t[]){p, q, r}, 3);
            face((int32_t[]){p, r, s}, 3);
        }
}

/* A box in each cell of a lattice of 3 x 2 x 2, that far from its borders that they do not meet. Binary fractions:
 * their sides are exactly flat. */
static void boxes(void) {
    uint64_t rng = 1971;
    for (int n = 0; n < BOXES; n++) {
        double at[3] = {n % 3, n / 3 % 2, n / 6}, edge[3][3];
        for (int e = 0; e < 3; e++)
            for (int k = 0; k < 3; k++) {
                edge[e][k] = ((double)integer_below(&rng, 2001) - 1000) / 8192 + (e == k ? .5 : 0);
                at[k] -= edge[e][k] / 2;
            }
        box(at, edge);
    }
}

const mesh_t *body_mesh(enum body which) {
    mesh = (mesh_t){.top = word + BODY_WORDS};
    if (which == BODY_CUBES) cubes();
    if (which == BODY_TORUS) rings(2.5);
    if (which == BODY_BALL) rings(0);
    if (which == BODY_RANDOM) boxes();
    mesh.vertex = (const packed_t(*)[3])vertex;
    return &mesh;
}

void body_star(int spiky, int star, double unit, poly_vertex_t v[2 * STAR_RAYS]) {
    for (int k = 0; k < 2 * STAR_RAYS; k++) {
        int32_t x, y;
        star_point(spiky, star, k / STAR_RAYS, k % STAR_RAYS, STAR_RAYS, &x, &y);
        v[k] = (poly_vertex_t){{(int32_t)floor(x / unit + .5), (int32_t)floor(y / unit + .5)}, k};
    }
}
