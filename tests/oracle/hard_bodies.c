/* hard_bodies.c - see hard_bodies.h. */
#include "tests/oracle/hard_bodies.h"

#include <math.h>

#define TURN 6.283185307179586

void hard_polygon(solid_ref_t *r, const double (*p)[3], int n) {
    int v[32];
    for (int k = 0; k < n; k++) v[k] = solid_ref_vertex(r, p[k][0], p[k][1], p[k][2]);
    solid_ref_face(r, v, n);
}

void hard_box(solid_ref_t *r, double x, double y, double z, double a, double b, double c) {
    int v[8];
    for (int k = 0; k < 8; k++) v[k] = solid_ref_vertex(r, k & 1 ? x + a : x, k & 2 ? y + b : y, k & 4 ? z + c : z);
    solid_ref_box(r, v);
}

void hard_cubes(solid_ref_t *r) {
    solid_body_cubes(r, 4);
}
void hard_many_cubes(solid_ref_t *r) {
    solid_body_cubes(r, 14);
}
void hard_one_box(solid_ref_t *r) {
    hard_box(r, -1, -1, -1, 2, 2, 2);
}
void hard_flush(solid_ref_t *r) {
    hard_box(r, 0, 0, 0, 3, 1, 1);
    hard_box(r, 1, 0, 1, 1, 1, 1);
    hard_box(r, 2, 0, 1, 1.5, 1, 0.5);
    hard_box(r, -2, 0.25, 0, 2, 0.75, 2);
    hard_box(r, 0, 1, 0, 2.5, 1, 1.5);
    hard_box(r, 0, 2.5, 0, 3, 0.5, 3);
}
void hard_lattice(solid_ref_t *r) {
    for (int k = 0; k < 27; k++)
        if ((k % 3 + k / 3 % 3 + k / 9) & 1) hard_box(r, k % 3, k / 3 % 3, k / 9, 1, 1, 1);
}
void hard_one_plane(solid_ref_t *r) {
    static const double a[][3] = {{0, 0, 1}, {3, 0, 2.5}, {3, 3, 4}, {0, 3, 2.5}},
                        b[][3] = {{1, 1, 2}, {4, 2, 4}, {1, 4, 3.5}}, c[][3] = {{2, -1, 0}, {3, 5, 0}, {-1, 4, 0}};
    hard_polygon(r, a, 4);
    hard_polygon(r, b, 3);
    hard_polygon(r, a, 4); /* there twice */
    hard_polygon(r, c, 3);
}
void hard_brackets(solid_ref_t *r) {
    static const double a[][3] = {{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {1, 1, 0},
                                  {1, 3, 0}, {4, 3, 0}, {4, 4, 0}, {0, 4, 0}};
    double b[8][3];
    for (int k = 0; k < 8; k++) {
        b[k][0] = 6.5 - a[k][0];
        b[k][1] = a[k][1] + 0.3;
        b[k][2] = (b[k][1] - 2) * 0.4;
    }
    hard_polygon(r, a, 8);
    hard_polygon(r, (const double(*)[3])b, 8);
}
void hard_bars(solid_ref_t *r) {
    enum { N = 9 };
    for (int k = 0; k < N; k++) {
        const double t = TURN * k / N, u = TURN * (k + 1.6) / N, w = .07;
        const double way[2] = {cos(u) - cos(t), sin(u) - sin(t)}, l = hypot(way[0], way[1]);
        const double side[2] = {-w * way[1] / l, w * way[0] / l};
        const double q[4][3] = {{cos(t) - side[0], sin(t) - side[1], 0},
                                {cos(u) - side[0], sin(u) - side[1], .4},
                                {cos(u) + side[0], sin(u) + side[1], .4},
                                {cos(t) + side[0], sin(t) + side[1], 0}};
        hard_polygon(r, q, 4);
    }
}
/* Each bar rises over the next: of n none is the first. */
void hard_circle(solid_ref_t *r, int n) {
    for (int k = 0; k < n; k++) {
        double p[2][2], q[4][3];
        for (int i = 0; i < 2; i++) {
            double t = TURN * (k + i) / n, u = TURN * (k + 1 - i) / n;
            p[i][0] = cos(t) + .3 * (cos(t) - cos(u));
            p[i][1] = sin(t) + .3 * (sin(t) - sin(u));
        }
        double dx = p[1][0] - p[0][0], dy = p[1][1] - p[0][1], w = 0.2 / n / hypot(dx, dy);
        for (int i = 0; i < 4; i++) {
            int far = i == 1 || i == 2, sign = i < 2 ? 1 : -1;
            q[i][0] = p[far][0] - sign * dy * w;
            q[i][1] = p[far][1] + sign * dx * w;
            q[i][2] = far;
        }
        hard_polygon(r, (const double(*)[3])q, 4);
    }
}
void hard_cut(solid_ref_t *r) {
    static const double a[][3] = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}},
                        b[][3] = {{1, 2, -1}, {3, 2, -1}, {3, 2.5, 1}, {1, 2.5, 1}};
    hard_polygon(r, a, 4);
    hard_polygon(r, b, 4);
}
void hard_penetrating(solid_ref_t *r) {
    hard_box(r, -1, -1, -1, 2, 2, 2);
    hard_box(r, -2, -.43, -.37, 4.1, .81, .77);
    hard_box(r, -.31, -.29, -2, .7, .66, 4.3);
}
void hard_slivers(solid_ref_t *r) {
    for (int k = 0; k < 24; k++) {
        const double t = 0.26 * k, w = pow(10, -1 - k % 4);
        const double p[3][3] = {{0.1 * cos(t), 0.1 * sin(t), 0.02 * k},
                                {2 * cos(t), 2 * sin(t), 1 + 0.02 * k},
                                {2 * cos(t + w), 2 * sin(t + w), 1.01 + 0.02 * k}};
        hard_polygon(r, p, 3);
    }
}
void hard_needles(solid_ref_t *r) {
    for (int k = 0; k < 12; k++) {
        const double t = 0.52 * k, x = 1.1 * cos(t), y = 1.1 * sin(t), z = 0.3 * (k % 3) - 0.3;
        const double p[3][3] = {{3 * x, 3 * y, z}, {-2 * x, y, z + 0.001}, {-2 * x, y + 0.01, z + 0.02}};
        hard_polygon(r, p, 3);
    }
}
void hard_needle(solid_ref_t *r) {
    hard_box(r, 0.78130257267132908, -2.3769730647190506, 0.63550474263457746, 0.0017, 0.0017512, 2.69);
}
void hard_plates(solid_ref_t *r) {
    for (int k = 0; k < 10; k++) hard_box(r, .1 * k, .07 * k, 2e-4 * k, 2, 2, 1e-4);
}
void hard_billionth(solid_ref_t *r) {
    static const double a[][3] = {{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}};
    double b[4][3];
    for (int k = 0; k < 4; k++) b[k][0] = a[k][0] + .3, b[k][1] = a[k][1] + .4, b[k][2] = 1 - 1e-9;
    hard_polygon(r, a, 4);
    hard_polygon(r, (const double(*)[3])b, 4);
}
void hard_twisted(solid_ref_t *r) {
    enum { N = 8 };
    for (int k = 0; k < N; k++) {
        double q[4][3];
        for (int i = 0; i < 4; i++) {
            const double t = TURN * (k + (i == 1 || i == 2)) / N;
            q[i][0] = cos(t), q[i][1] = sin(t), q[i][2] = (i > 1) + .25 * ((k + i) & 1);
        }
        hard_polygon(r, (const double(*)[3])q, 4);
    }
}
/* A square with a window, joined to its outline by a cut gone along both ways, before and behind other things. */
void hard_window(solid_ref_t *r) {
    static const double at[][2] = {{0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 0}, {2, 2}, {2, 6}, {6, 6}, {6, 2}, {2, 2}},
                        back[][3] = {{-1, 1, -2}, {9, 2, -1.5}, {8, 7, -1.6}, {0, 6, -2}};
    int v[10];
    for (int k = 0; k < 10; k++)
        v[k] = k == 4 ? v[0] : k == 9 ? v[5] : solid_ref_vertex(r, at[k][0], at[k][1], .2 * at[k][0]);
    solid_ref_face(r, v, 10);
    hard_polygon(r, back, 4);
    hard_box(r, 2.4, 2.3, -1, .5, .5, 4);
}
void hard_angles(solid_ref_t *r) {
    solid_body_angles(r, 3);
}
void hard_large_and_small(solid_ref_t *r) {
    hard_box(r, -5e5, -5e5, -1e6, 1e6, 1e6, 1e6);
    for (int k = 0; k < 5; k++) hard_box(r, 1e5 * k - 2e5, 1e5 * k - 2e5, 0, k < 3 ? 1 : 5e4, 7e4, 4e4);
}
void hard_millionth(solid_ref_t *r) {
    for (int k = 0; k < 4; k++) hard_box(r, 1.5e-6 * (k & 1), 1.5e-6 * (k >> 1), 0, 1e-6, 1e-6, 1e-6);
}
void hard_broken(solid_ref_t *r) {
    static const double line[][3] = {{0, 0, 2}, {1, 1, 2}, {2, 2, 2}},
                        q[][3] = {{0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}};
    hard_polygon(r, line, 3); /* without an area */
    hard_polygon(r, q, 4);
    hard_polygon(r, q, 4);
    hard_box(r, .5, .5, -1, 1, 1, 1);
    const int a = solid_ref_vertex(r, -1, 1, .5), b = solid_ref_vertex(r, 3, 1, .5);
    solid_ref_face(r, (int[]){a, b, b, a}, 4);
    solid_ref_line(r, a, b);
}
void hard_open_sides(solid_ref_t *r) {
    static const double lid[][3] = {{-1, -1, 1}, {1, -1, 1}, {1, .2, 1.8}, {-1, .2, 1.8}},
                        side[][4][3] = {{{-1, -1, -1}, {1, -1, -1}, {1, -1, 1}, {-1, -1, 1}},
                                        {{1, -1, -1}, {1, 1, -1}, {1, 1, 1}, {1, -1, 1}},
                                        {{-1, 1, -1}, {-1, -1, -1}, {-1, -1, 1}, {-1, 1, 1}},
                                        {{-1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {1, -1, -1}}};
    for (int k = 0; k < 4; k++) hard_polygon(r, side[k], 4);
    hard_polygon(r, lid, 4);
}
void hard_fan(solid_ref_t *r) {
    for (int k = 0; k < 12; k++) {
        const double t = 1e-6 * k * k;
        const double p[3][3] = {
            {0, .1 * k, .05 * k}, {3 * cos(t), .1 * k + 3 * sin(t), .05 * k}, {1.5, 1 + .1 * k, 1 + .05 * k}};
        hard_polygon(r, p, 3);
    }
}
void hard_segment(solid_ref_t *r) {
    solid_ref_line(r, solid_ref_vertex(r, 0, 0, 0), solid_ref_vertex(r, 1, 2, 3));
    solid_ref_line(r, solid_ref_vertex(r, 1, 0, 1), solid_ref_vertex(r, 0, 2, 1));
}
