/* Seeded random solids pushed into each other: the lines in which they meet (hidden/solid/seams.h) against every face
 * with every other in long double. RIDGELINE_CASES multiplies the count, RIDGELINE_SEED tries one. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "error.h"
#include "hidden/solid/seams.h"
#include "tests/oracle/hard_bodies.h"
#include "tests/oracle/run_cases.h"
#include "tests/oracle/solid_scenes.h"

typedef long double real;
typedef struct vec {
    real x, y, z;
} vec_t;

static vec_t add(vec_t a, real t, vec_t b) {
    return (vec_t){a.x + t * b.x, a.y + t * b.y, a.z + t * b.z};
}
static vec_t cross(vec_t a, vec_t b) {
    return (vec_t){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
static real dot(vec_t a, vec_t b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
static vec_t unit(vec_t a) {
    const real n = sqrtl(dot(a, a));
    return n > 0 ? (vec_t){a.x / n, a.y / n, a.z / n} : a;
}

static vec_t corner(const solid_ref_t *r, int f, int k) {
    const int n = r->first[f + 1] - r->first[f];
    const exact_point_t p = r->vertex[r->corner[r->first[f] + k % n]];
    return (vec_t){p.x, p.y, p.z};
}

static vec_t normal(const solid_ref_t *r, int f) {
    const vec_t o = corner(r, f, 0);
    vec_t n = {0, 0, 0};
    for (int k = 1; k + 1 < r->first[f + 1] - r->first[f]; k++)
        n = add(n, 1, cross(add(corner(r, f, k), -1, o), add(corner(r, f, k + 1), -1, o)));
    return unit(n);
}

/* Which object a face belongs to: faces with two corners in common are of one. */
static int find(int *parent, int f) {
    while (parent[f] != f) f = parent[f];
    return f;
}
static int shared(const solid_ref_t *r, int f, int g) {
    int n = 0;
    for (int i = r->first[f]; i < r->first[f + 1]; i++)
        for (int k = r->first[g]; k < r->first[g + 1]; k++)
            n += memcmp(&r->vertex[r->corner[i]], &r->vertex[r->corner[k]], sizeof r->vertex[0]) == 0;
    return n;
}

/* Where the line o + t d lies in a polygon of its plane: even-odd, parameters in order. Returns how many. */
static int by_value(const void *a, const void *b) {
    const real x = *(const real *)a, y = *(const real *)b;
    return (x > y) - (x < y);
}
static int stretches(const solid_ref_t *r, int f, vec_t n, vec_t o, vec_t d, real t[64]) {
    const vec_t aside = cross(n, d);
    int count = 0;
    for (int k = 0; k < r->first[f + 1] - r->first[f]; k++) {
        const vec_t p = add(corner(r, f, k), -1, o), q = add(corner(r, f, k + 1), -1, o);
        const real a = dot(aside, p), b = dot(aside, q);
        if ((a < 0) == (b < 0) || count == 64) continue;
        t[count++] = dot(d, add(p, a / (a - b), add(q, -1, p)));
    }
    qsort(t, (size_t)count, sizeof *t, by_value);
    return count;
}

/* The length that two faces have in common on a line. */
static real common(const solid_ref_t *r, int f, int g) {
    const vec_t n = normal(r, f), m = normal(r, g), p = corner(r, f, 0), q = corner(r, g, 0);
    const vec_t along = cross(n, m);
    const real square = dot(along, along), a = dot(n, p), b = dot(m, q), c = dot(n, m);
    real s[64], t[64], sum = 0;
    if (square < 1e-12L) return 0;
    const vec_t o = add(add((vec_t){0, 0, 0}, (a - b * c) / square, n), (b - a * c) / square, m), d = unit(along);
    const int i = stretches(r, f, n, o, d, s), k = stretches(r, g, m, o, d, t);
    for (int x = 0; x + 1 < i; x += 2)
        for (int y = 0; y + 1 < k; y += 2) {
            const real from = fmaxl(s[x], t[y]), to = fminl(s[x + 1], t[y + 1]);
            if (to > from) sum += to - from;
        }
    return sum;
}

static real of_faces(const solid_ref_t *r) {
    int *parent = malloc((size_t)(r->nf + 1) * sizeof *parent);
    real sum = 0;
    for (int f = 0; f < r->nf; f++) parent[f] = f;
    for (int f = 0; f < r->nf; f++)
        for (int g = 0; g < f; g++)
            if (shared(r, f, g) >= 2) parent[find(parent, f)] = find(parent, g);
    for (int f = 0; f < r->nf; f++)
        for (int g = 0; g < f; g++)
            if (find(parent, f) != find(parent, g)) sum += common(r, f, g);
    free(parent);
    return sum;
}

/* The length of the seams the program finds, in the scene's units; below 0: an error. */
static real of_seams(const solid_ref_t *r, int *count) {
    mesh_t made;
    const mesh_t *mesh = &made;
    solid_t s;
    real sum = 0;
    size_t kept;
    solid_scene_mesh(r, &made);
    const size_t bytes = solid_bytes(&mesh, 1), more = 65536 + 400 * (size_t)r->nc;
    uint8_t *mem = malloc(bytes + more);
    int err = solid_build(&s, &mesh, 1, mem, bytes);
    const int32_t before = s.ne;
    uint8_t *rest = mem + ((bytes + 7) & ~(size_t)7);
    if (!err) err = seams_add(&s, rest, more - 8, &kept);
    for (int32_t e = before; e < s.ne && !err; e++) {
        const solid_vertex_t *a = &s.vertex[s.edge[e].v[0]], *b = &s.vertex[s.edge[e].v[1]];
        const real x = a->at[0] - b->at[0], y = a->at[1] - b->at[1], z = a->at[2] - b->at[2];
        sum += ldexpl(sqrtl(x * x + y * y + z * z), -s.shift);
        if (s.edge[e].face[0] != -1 || s.edge[e].face[1] != -1 || s.edge[e].first != e) err = ERR_DATA;
    }
    *count = s.ne - before;
    if (!err && *count > 0 && (kept == 0 || kept > more || (const uint8_t *)s.edge < rest)) err = ERR_DATA;
    solid_scene_mesh_free(&made);
    free(mem);
    return err == ERR_EMPTY ? 0 : err ? -1 : sum;
}

static void seams_are_where_faces_meet(void **state) {
    (void)state;
    uint64_t from, to;
    int failed = 0, seams = 0, scenes = 0;
    real worst = 0, length = 0;
    if (!cases_seeds(0, cases_scaled(1500), &from, &to)) return;
    for (uint64_t seed = from; seed < to && failed < 10; seed++) {
        solid_scene_t s;
        int count = 0;
        solid_scene_random(&s, seed, 7);
        if (!s.lattice) {
            const real want = of_faces(&s.ref), have = of_seams(&s.ref, &count), off = fabsl(want - have) / s.ref.size;
            scenes++;
            seams += count;
            length += want / s.ref.size;
            if (off > worst) worst = off;
            if (have < 0 || off > 1e-6L * (1 + count)) {
                failed++;
                print_message(
                    "# FAILED RIDGELINE_SEED=%llu build/tests/property/test_seams_random: %.9Lg instead of %.9Lg\n",
                    (unsigned long long)seed, have, want);
            }
        }
        solid_scene_free(&s);
    }
    print_message("# seams: %d scenes, %d seams, %.1Lf times the size of a scene; worst difference %.1Lg of it\n",
                  scenes, seams, length, worst);
    assert_int_equal(failed, 0);
}

/* A beam through a cube: two squares. The same flush with its top: without the lines on top, which are edges. Bodies
 * that only touch: nothing. */
static void boxes_by_hand(void **state) {
    (void)state;
    static const struct {
        double at[3], size[3], length;
        int seams;
    } list[] = {
        {{-1, .25, .25}, {3, .5, .5}, 4, 8},   {{-1, .25, .5}, {3, .5, .5}, 3, 6}, {{.25, .25, .5}, {.5, .5, 2}, 2, 4},
        {{1, 0, 0}, {1, 1, 1}, 0, 0},          {{0, 0, 1}, {1, 1, 1}, 0, 0},       {{1, 1, 1}, {1, 1, 1}, 0, 0},
        {{.25, .25, .25}, {.5, .5, .5}, 0, 0}, {{.5, .5, .5}, {1, 1, 1}, 3, 6},    {{5, 5, 5}, {1, 1, 1}, 0, 0},
    };
    for (size_t k = 0; k < sizeof list / sizeof list[0]; k++) {
        solid_ref_t r = {0};
        int count = 0;
        hard_box(&r, 0, 0, 0, 1, 1, 1);
        hard_box(&r, list[k].at[0], list[k].at[1], list[k].at[2], list[k].size[0], list[k].size[1], list[k].size[2]);
        const real length = of_seams(&r, &count);
        assert_int_equal(count, list[k].seams);
        assert_true(fabsl(length - list[k].length) < 1e-7L);
        solid_ref_free(&r);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(boxes_by_hand),
        cmocka_unit_test(seams_are_where_faces_meet),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
