/* Terrains cut by planes: every profile is one chain from border to border, each of its vertices on an edge of the
 * mesh, and a missing triangle leaves a gap. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "error.h"
#include "scene/profiles_mesh.h"
#include "tests/oracle/num_of.h"
#define DICE_SEED 7
#include "tests/unit/dice.h"

#define N 9

static double value(num_t a) {
    return ldexp((double)a.m, a.e);
}

static packed_t vertex[N * N][3];
static double xyz[N * N][3];
static int32_t face[2 * (N - 1) * (N - 1)][3], words[4 * 2 * (N - 1) * (N - 1)];

/* A jittered grid inside a straight border. */
static mesh_t terrain(int missing) {
    int32_t nf = 0;
    for (int j = 0; j < N; j++) {
        for (int i = 0; i < N; i++) {
            int border = i == 0 || j == 0 || i == N - 1 || j == N - 1;
            double *p = xyz[j * N + i];
            p[0] = i + (border ? 0 : 0.6 * (uniform() - 0.5));
            p[1] = j + (border ? 0 : 0.6 * (uniform() - 0.5));
            p[2] = uniform();
            for (int axis = 0; axis < 3; axis++) vertex[j * N + i][axis] = packed_from_num(num_of(p[axis]));
        }
    }
    for (int32_t j = 0; j + 1 < N; j++) {
        for (int32_t i = 0; i + 1 < N; i++) {
            int32_t a = j * N + i, corner[2][3] = {{a, a + 1, a + N + 1}, {a, a + N + 1, a + N}};
            for (int t = 0; t < 2; t++) {
                if (nf == missing) {
                    missing = -1;
                    continue;
                }
                int turn = (int)(uniform() * 3); /* any vertex may come first */
                for (int k = 0; k < 3; k++) face[nf][k] = corner[t][(k + turn) % 3];
                nf++;
            }
        }
    }
    int32_t *top = words + sizeof words / sizeof words[0], *w = top;
    for (int32_t f = 0; f < nf; f++) {
        *--w = 3 << 2 | MESH_FACE;
        for (int k = 0; k < 3; k++) *--w = face[f][k];
    }
    return (mesh_t){.nv = N * N,
                    .faces = nf,
                    .corners = 3 * nf,
                    .words = 4 * nf,
                    .vertex = (const packed_t(*)[3])vertex,
                    .top = top};
}

/* Is q on an edge of the mesh, at its height? */
static bool on_an_edge(const mesh_t *m, const double q[3]) {
    for (int32_t f = 0; f < m->faces; f++) {
        for (int k = 0; k < 3; k++) {
            const double *a = xyz[face[f][k]], *b = xyz[face[f][(k + 1) % 3]];
            double dx = b[0] - a[0], dy = b[1] - a[1];
            double t = ((q[0] - a[0]) * dx + (q[1] - a[1]) * dy) / (dx * dx + dy * dy);
            if (t < -1e-9 || t > 1 + 1e-9 || fabs((q[0] - a[0]) * dy - (q[1] - a[1]) * dx) > 1e-9) continue;
            if (fabs(a[2] + t * (b[2] - a[2]) - q[2]) < 1e-9) return true;
        }
    }
    return false;
}

static void test_chains(void **state) {
    (void)state;
    static uint64_t memory[4000];
    int vertices = 0;
    for (int round = 0; round < 60; round++) {
        mesh_t m = terrain(-1);
        double angle = round < 8 ? round * 0.78539816339744831 : 6.3 * uniform(), ex = cos(angle), ey = sin(angle);
        camera_t cam = {.perspective = false, .eye = {num_of(ex), num_of(ey), num_of(0.3)}};
        profiles_t p;
        profiles_mesh_t s;
        assert_int_equal(profiles_from_mesh(&p, &s, &m, &cam, 16, memory, sizeof memory), 0);
        double before = -INFINITY;
        for (int32_t k = 0; k < p.count; k++) {
            int32_t n = p.points(p.ctx, k);
            double last = -INFINITY, depth = 0;
            assert_true(n >= 2 && n <= p.max_points);
            for (int32_t v = 0; v < n; v++, vertices++) {
                num_t q[3];
                p.point(p.ctx, k, v, q);
                assert_false(q[2].undef);
                double at[3] = {value(q[0]), value(q[1]), value(q[2])};
                double d = -ex * at[0] - ey * at[1], u = -ey * at[0] + ex * at[1];
                assert_true(on_an_edge(&m, at));
                assert_true(u > last);
                assert_true(v == 0 ? d > before : fabs(d - depth) < 1e-9);
                if (v == 0 || v == n - 1) {
                    assert_true(fmin(fmin(at[0], N - 1 - at[0]), fmin(at[1], N - 1 - at[1])) < 1e-9);
                }
                last = u, depth = d;
            }
            before = depth;
        }
    }
    print_message("# terrain profiles: %d vertices, all on edges of the mesh, in order, no gaps\n", vertices);
}

static void test_gap(void **state) {
    (void)state;
    static uint64_t memory[4000];
    mesh_t m = terrain((N - 1) * (N - 1));
    camera_t cam = {.perspective = false, .eye = {num_from_i64(0), num_from_i64(-1), num_from_i64(1)}};
    profiles_t p;
    profiles_mesh_t s;
    assert_int_equal(profiles_from_mesh(&p, &s, &m, &cam, 40, memory, sizeof memory), 0);
    int gaps = 0;
    for (int32_t k = 0; k < p.count; k++) {
        for (int32_t v = 0; v < p.points(p.ctx, k); v++) {
            num_t q[3];
            p.point(p.ctx, k, v, q);
            gaps += q[2].undef;
        }
    }
    assert_true(gaps >= 3 && gaps <= 9);
}

static void test_refusals(void **state) {
    (void)state;
    uint64_t memory[120];
    mesh_t m = terrain(-1), none = {.nv = 3, .vertex = m.vertex};
    camera_t cam = {.perspective = false, .eye = {num_from_i64(0), num_from_i64(-1), num_from_i64(1)}};
    profiles_t p;
    profiles_mesh_t s;
    assert_int_equal(profiles_from_mesh(&p, &s, &m, &cam, 16, memory, sizeof memory), ERR_FULL);
    assert_int_equal(profiles_from_mesh(&p, &s, &m, &cam, 16, memory, 64), ERR_FULL);
    assert_int_equal(profiles_from_mesh(&p, &s, &m, &cam, 0, memory, sizeof memory), ERR_VALUE);
    assert_int_equal(profiles_from_mesh(&p, &s, &none, &cam, 16, memory, sizeof memory), ERR_EMPTY);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_chains),
        cmocka_unit_test(test_gap),
        cmocka_unit_test(test_refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
