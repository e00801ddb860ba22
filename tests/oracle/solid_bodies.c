/* solid_bodies.c - the solids of the benchmark and the report; see solid_scenes.h. */
#include <math.h>
#include <stdlib.h>

#include "tests/oracle/solid_scenes.h"

void solid_body_cubes(solid_ref_t *r, int k) {
    for (int n = 0; n < k * k; n++) {
        int v[8];
        for (int c = 0; c < 8; c++)
            v[c] = solid_ref_vertex(r, 1.5 * (n % k) + (c & 1), 1.5 * (n / k) + (c >> 1 & 1), c >> 2);
        solid_ref_box(r, v);
    }
}

void solid_body_round(solid_ref_t *r, int n, double hole) {
    int *v = malloc((size_t)(n * n) * sizeof *v);
    if (!v) abort();
    for (int k = 0; k < n * n; k++) {
        double a = 6.283185307179586 * (k % n) / n,
               b = hole > 0 ? 6.283185307179586 * (k / n) / n : 3.141592653589793 * (k / n) / (n - 1);
        double far = hole > 0 ? hole + cos(b) : sin(b), z = hole > 0 ? sin(b) : cos(b);
        const bool pole = hole <= 0 && (k / n == 0 || k / n == n - 1); /* n times the same place, without -0 */
        v[k] = solid_ref_vertex(r, pole ? 0 : far * cos(a), pole ? 0 : far * sin(a), z);
    }
    for (int j = 0; j < (hole > 0 ? n : n - 1); j++)
        for (int i = 0; i < n; i++) {
            int p = v[j * n + i], q = v[j * n + (i + 1) % n], s = v[(j + 1) % n * n + (i + 1) % n],
                t = v[(j + 1) % n * n + i];
            solid_ref_face(r, (int[]){p, q, s}, 3);
            solid_ref_face(r, (int[]){p, s, t}, 3);
        }
    free(v);
}

static void rectangle(solid_ref_t *r, double x, double y, double w, double h, double z) {
    const int v[4] = {solid_ref_vertex(r, x, y, z), solid_ref_vertex(r, x + w, y, z),
                      solid_ref_vertex(r, x + w, y + h, z), solid_ref_vertex(r, x, y + h, z)};
    solid_ref_face(r, v, 4);
}

void solid_body_covered(solid_ref_t *r, int n) {
    int k = (int)sqrt(n);
    rectangle(r, -1, -1, k + 1, k + 1, 1);
    for (int i = 0; i < n; i++) rectangle(r, i % k, i / k, 0.7, 0.7, -0.001 * (i * 7919 % n));
}

void solid_body_shingles(solid_ref_t *r, int n) {
    int k = (int)sqrt(n);
    for (int i = 0; i < n; i++) rectangle(r, i % k, i / k, 1.4, 1.3, 0.001 * i);
}

void solid_body_woven(solid_ref_t *r, int n) {
    for (int i = 0; i < n / 2; i++) {
        rectangle(r, -1, i, n / 2 + 1, 0.5, i % 2);
        rectangle(r, i, -1, 0.5, n / 2 + 1, 0.5 + 0.001 * i);
    }
}

/* Rings of m around n places, and rings closed. */
static void tube(solid_ref_t *r, const int *v, int n, int m) {
    for (int j = 0; j < n; j++)
        for (int i = 0; i < m; i++) {
            int p = v[j * m + i], q = v[(j + 1) % n * m + i], s = v[(j + 1) % n * m + (i + 1) % m],
                t = v[j * m + (i + 1) % m];
            solid_ref_face(r, (int[]){p, q, s}, 3);
            solid_ref_face(r, (int[]){p, s, t}, 3);
        }
}

void solid_body_knot(solid_ref_t *r, int n, int m) {
    int *v = malloc((size_t)(n * m) * sizeof *v);
    if (!v) abort();
    for (int k = 0; k < n * m; k++) {
        const double t = 6.283185307179586 * (k / m) / n, u = 6.283185307179586 * (k % m) / m;
        const double far = 2 + cos(3 * t) + 0.4 * cos(u);
        v[k] = solid_ref_vertex(r, far * cos(2 * t), far * sin(2 * t), 0.4 * sin(u) - sin(3 * t));
    }
    tube(r, v, n, m);
    free(v);
}

void solid_body_angles(solid_ref_t *r, int k) {
    static const double at[6][2] = {{0, 0}, {2, 0}, {2, .7}, {.7, .7}, {.7, 2}, {0, 2}};
    for (int n = 0; n < k * k; n++) {
        int v[12], w[6];
        for (int c = 0; c < 12; c++) {
            const double t = 0.3 * n, x = at[c % 6][0], y = at[c % 6][1];
            v[c] = solid_ref_vertex(r, 3 * (n % k) + x * cos(t) - y * sin(t), 3 * (n / k) + x * sin(t) + y * cos(t),
                                    c / 6);
        }
        for (int c = 0; c < 6; c++) w[c] = v[5 - c];
        solid_ref_face(r, w, 6);
        solid_ref_face(r, v + 6, 6);
        for (int c = 0; c < 6; c++) {
            const int d = (c + 1) % 6;
            solid_ref_face(r, (int[]){v[c], v[d], v[6 + d], v[6 + c]}, 4);
        }
    }
}

static void start(solid_scene_t *s) {
    *s = (solid_scene_t){0};
    settings_default(&s->set);
    s->set.view.rot_x = num_from_i64(65);
}

void solid_scene_cubes(solid_scene_t *s, int k) {
    start(s);
    solid_body_cubes(&s->ref, k);
    solid_ref_finish(&s->ref);
}

void solid_scene_round(solid_scene_t *s, int n, double hole) {
    start(s);
    solid_body_round(&s->ref, n, hole);
    solid_ref_finish(&s->ref);
}
