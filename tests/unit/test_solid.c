/* Solids from OBJ text: what is one vertex, one edge, one object, closed, convex; and the convex kernel where
 * everything touches: whole drawings whose ink is known. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "app/picture.h"
#include "error.h"
#include "hidden/solid/convex.h"
#include "hidden/solid/wires.h"
#include "motion/motion.h"
#include "scene/obj_reader.h"
#include "scene/solid_math.h"

#define POOL 200000

static packed_t memory[POOL];
static uint64_t lent[400000], places[20000], kernel[400000];
static solid_t solid;

static int build(const char *text) {
    data_pool_t pool = {memory, 0, POOL};
    obj_reader_t r;
    mesh_t m;
    const mesh_t *list[1] = {&m};
    obj_reader_start(&r, &pool, NULL, false, 0);
    int err = obj_reader_feed(&r, text, strlen(text));
    if (!err) err = obj_reader_finish(&r, &m);
    if (!err) err = solid_build(&solid, list, 1, lent, sizeof lent);
    return err;
}

static size_t add_box(char *out, size_t at, double x, double y, double z, double w, double d, double h,
                      const char *faces) {
    at += (size_t)sprintf(out + at, "o box\n");
    for (int k = 0; k < 8; k++)
        at += (size_t)sprintf(out + at, "v %.17g %.17g %.17g\n", x + (k & 1 ? w : 0), y + (k & 2 ? d : 0),
                              z + (k & 4 ? h : 0));
    static const char *const side[6] = {"-8 -6 -5 -7", "-4 -3 -1 -2", "-8 -7 -3 -4",
                                        "-6 -2 -1 -5", "-8 -4 -2 -6", "-7 -5 -1 -3"};
    for (; *faces; faces++) at += (size_t)sprintf(out + at, "f %s\n", side[*faces - '0']);
    return at;
}

static void a_cube_is_one_convex_object(void **state) {
    (void)state;
    char text[4000];
    add_box(text, 0, 0, 0, 0, 1, 1, 1, "012345");
    assert_int_equal(build(text), 0);
    assert_int_equal(solid.nv, 8);
    assert_int_equal(solid.ne, 12);
    assert_int_equal(solid.no, 1);
    assert_int_equal(solid.object[0].kind, SOLID_CONVEX);
    add_box(text, 0, 0, 0, 0, 1, 1, 1, "01234"); /* a side is missing */
    assert_int_equal(build(text), 0);
    assert_int_equal(solid.ne, 12);
    assert_int_equal(solid.object[0].kind, SOLID_OPEN);
    /* corners of their own, groups, windings as they come: still one */
    assert_int_equal(build("v 0 0 0\nv 1 0 0\nv 0 1 0\ng a\nf 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 0 1\ng b\nf 4 5 6\n"
                           "v 1 0 0\nv 0 1 0\nv 0 0 1\no c\nf 7 8 9\nv 0 0 0\nv 0 1 0\nv 0 0 1\nf 12 10 11\n"),
                     0);
    assert_int_equal(solid.nv, 4);
    assert_int_equal(solid.ne, 6);
    assert_int_equal(solid.no, 1);
    assert_int_equal(solid.object[0].kind, SOLID_CONVEX);
}

static void bodies_that_touch_are_two(void **state) {
    (void)state;
    char text[4000];
    size_t at = add_box(text, 0, 0, 0, 0, 1, 1, 1, "012345");
    add_box(text, at, 1, 0, 0, 1, 1, 1, "012345"); /* a face in common */
    assert_int_equal(build(text), 0);
    assert_int_equal(solid.nv, 12);
    assert_int_equal(solid.no, 2);
    assert_int_equal(solid.ne, 24); /* of 20 places: four are twins */
    int twins = 0;
    for (int e = 0; e < solid.ne; e++) twins += solid.edge[e].first != e;
    assert_int_equal(twins, 4);
    for (int o = 0; o < 2; o++) assert_int_equal(solid.object[o].kind, SOLID_CONVEX);
}

/* A face twice in a group is one, whichever way round and wherever it begins; in two groups there are two bodies. */
static void faces_that_are_there_twice_are_one(void **state) {
    (void)state;
    char text[8000];
    size_t n = add_box(text, 0, 0, 0, 0, 1, 1, 1, "012345012");
    n += (size_t)sprintf(text + n, "f 3 4 2 1\nf 8 7 5 6\nl 1 2\nl 1 8\nl 8 1\n"); /* once more, the other way */
    assert_int_equal(build(text), 0);
    assert_int_equal(solid.nf, 6);
    assert_int_equal(solid.ne, 13);
    assert_int_equal(solid.no, 1);
    assert_int_equal(solid.object[0].kind, SOLID_CONVEX);
    n = add_box(text, 0, 0, 0, 0, 1, 1, 1, "012345");
    add_box(text, n, 0, 0, 0, 1, 1, 1, "012345");
    assert_int_equal(build(text), 0);
    assert_int_equal(solid.no, 2);
    assert_int_equal(solid.nf, 12);
    /* the same corners in another order are another face */
    assert_int_equal(build("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf 1 3 2 4\nf 1 2 3\nf 1 2 4\nf 2 1 3\n"), 0);
    assert_int_equal(solid.nf, 4);
}

/* What is at an edge of many faces: each in a group of its own, and all in one. */
static void fans_of_many_faces(void **state) {
    (void)state;
    enum { FAN = 1000 };
    char *text = malloc(FAN * 80);
    assert_non_null(text);
    for (int groups = 0; groups < 2; groups++) {
        size_t n = (size_t)sprintf(text, "v 0 0 0\nv 0 0 1\n");
        for (int k = 0; k < FAN; k++)
            n +=
                (size_t)sprintf(text + n, "v %.9f %.9f %d\n%sf 1 2 -1\n", cos(k), sin(k), k & 1, groups ? "o a\n" : "");
        assert_int_equal(build(text), 0);
        assert_int_equal(solid.no, FAN);
        assert_int_equal(solid.ne, 3 * FAN);
        int32_t twins = 0;
        for (int32_t e = 0; e < solid.ne; e++) {
            assert_true(solid.edge[e].face[0] < 0 || solid.edge[e].face[1] < 0);
            if (solid.edge[e].first != e) continue;
            for (int32_t k = e; k >= 0; k = solid.edge[k].twin) twins += k != e;
        }
        assert_int_equal(twins, FAN - 1);
        for (int32_t o = 0; o < solid.no; o++) assert_int_equal(solid.object[o].kind, SOLID_OPEN);
    }
    free(text);
}

/* A cube one side of which is a frame with a window in it, whichever way round that is given, and a pane: its outer
 * side is that of the cube. */
static void what_fills_a_hole_looks_out(void **state) {
    (void)state;
    for (int turned = 0; turned < 4; turned++) {
        char text[4000];
        size_t n = add_box(text, 0, 0, 0, 0, 4, 4, 4, "12345");
        n += (size_t)sprintf(text + n, "v 1 1 0\nv 3 1 0\nv 3 3 0\nv 1 3 0\n");
        n += (size_t)sprintf(text + n, "f 1 2 4 3 h %s\n", turned & 1 ? "9 10 11 12" : "12 11 10 9");
        sprintf(text + n, "f %s\n", turned & 2 ? "9 10 11 12" : "12 11 10 9");
        assert_int_equal(build(text), 0);
        assert_int_equal(solid.no, 1);
        assert_true(solid.object[0].kind != SOLID_OPEN);
        assert_true(solid_face_normal(&solid, 5).n[2] < 0);
        assert_true(solid_face_normal(&solid, 6).n[2] < 0);
    }
}

static void kinds_of_bodies(void **state) {
    (void)state;
    /* an L */
    assert_int_equal(build("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 0 1\nv 2 0 1\nv 2 1 1\nv 1 1 1\n"
                           "v 1 2 1\nv 0 2 1\nf 6 5 4 3 2 1\nf 7 8 9 10 11 12\nf 1 2 8 7\nf 2 3 9 8\nf 3 4 10 9\n"
                           "f 4 5 11 10\nf 5 6 12 11\nf 6 1 7 12\n"),
                     0);
    assert_int_equal(solid.object[0].kind, SOLID_CLOSED);
    /* a strip with a twist */
    assert_int_equal(build("v 1 0 0\nv 1 0 1\nv 0 1 0\nv 0 1 1\nv -1 0 0\nv -1 0 1\nf 1 3 4 2\nf 3 5 6 4\nf 5 2 1 6\n"),
                     0);
    assert_int_equal(solid.object[0].kind, SOLID_OPEN);
    /* the great icosahedron: no edge bends inward, but it goes round twice at its vertices */
    double v[12][3], phi = (1 + sqrt(5)) / 2;
    char text[4000];
    size_t at = 0;
    for (int k = 0; k < 12; k++) {
        double a = k & 1 ? 1 : -1, b = k & 2 ? phi : -phi;
        v[k][k / 4] = 0;
        v[k][(k / 4 + 1) % 3] = a;
        v[k][(k / 4 + 2) % 3] = b;
        at += (size_t)sprintf(text + at, "v %.17g %.17g %.17g\n", v[k][0], v[k][1], v[k][2]);
    }
    for (int far = 0; far < 2; far++) {
        size_t end = at;
        double side = far ? 2 * phi : 2;
        for (int i = 0; i < 12; i++)
            for (int j = 0; j < i; j++)
                for (int k = 0; k < j; k++) {
                    int n = 0, t[3] = {i, j, k};
                    for (int c = 0; c < 3; c++) {
                        double *p = v[t[c]], *q = v[t[(c + 1) % 3]];
                        n += fabs(sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) +
                                       (p[2] - q[2]) * (p[2] - q[2])) -
                                  side) < 1e-9;
                    }
                    if (n == 3) end += (size_t)sprintf(text + end, "f %d %d %d\n", i + 1, j + 1, k + 1);
                }
        assert_int_equal(build(text), 0);
        assert_int_equal(solid.nf, 20);
        assert_int_equal(solid.object[0].kind, far ? SOLID_CLOSED : SOLID_CONVEX);
    }
}

/* ---- drawings ---- */

typedef struct sums {
    double length; /* of edges, in space */
    int pieces;
    int64_t q30;
} sums_t;

static int add(void *ctx, const ink_piece_t *p) {
    sums_t *s = ctx;
    const solid_edge_t *e = &solid.edge[p->line];
    double d = 0;
    for (int k = 0; k < 3; k++) d += pow(solid.vertex[e->v[0]].at[k] - solid.vertex[e->v[1]].at[k], 2);
    s->length += ldexp(sqrt(d), -solid.shift) * (double)(p->to - p->from) / (double)INK_ONE;
    s->q30 += p->to - p->from;
    s->pieces++;
    return 0;
}

static int draw(double rx, double rz, const double *from, size_t bytes, sums_t *visible, sums_t *hidden) {
    settings_t set;
    camera_t cam;
    solid_map_t map;
    hidden_stats_t stats;
    view_box_t box = {.solid = true};
    settings_default(&set);
    set.view.rot_x = num_from_fixed((int64_t)(rx * 1024), 10);
    set.view.rot_z = num_from_fixed((int64_t)(rz * 1024), 10);
    set.view.from = from != NULL;
    for (int k = 0; k < 3 && from; k++) set.view.eye[k] = num_from_fixed((int64_t)(from[k] * 1024), 10);
    memcpy(box.lo, solid.lo, sizeof box.lo);
    memcpy(box.hi, solid.hi, sizeof box.hi);
    *visible = *hidden = (sums_t){0};
    assert_int_equal(camera_setup(&cam, &set, &box), 0);
    assert_int_equal(solid_map_setup(&map, &solid, &cam, places), 0);
    const ink_sink_t sink = {visible, add}, other = {hidden, add};
    const hidden_job_t job = {.mem = kernel, .bytes = bytes, .sink = &sink};
    return convex_draw(&map, &other, &job, &stats);
}

#define NEAR(a, b) assert_true(fabs((a) - (b)) < 1e-6)

static void touching_bodies(void **state) {
    (void)state;
    char text[8000];
    sums_t in, out;
    /* A small cube on a large one: its foot lies in the other's face, and is drawn. */
    size_t at = add_box(text, 0, 0, 0, 0, 4, 4, 4, "012345");
    add_box(text, at, 1, 1, 4, 1, 1, 1, "012345");
    assert_int_equal(build(text), 0);
    assert_int_equal(draw(60, 30, NULL, sizeof kernel, &in, &out), 0);
    NEAR(in.length + out.length, 12 * 4 + 12);
    NEAR(out.length, 3 * 4 + 3 + /* nothing of the large one's upper edges is behind the small one */ 0);
    /* Two in a row, a face in common, seen from the front: the seam is drawn once, on top and in front. */
    at = add_box(text, 0, 0, 0, 0, 1, 1, 1, "012345");
    add_box(text, at, 1, 0, 0, 1, 1, 1, "012345");
    assert_int_equal(build(text), 0);
    assert_int_equal(draw(60, 30, NULL, sizeof kernel, &in, &out), 0);
    NEAR(in.length + out.length, 20);
    NEAR(in.length, 9 + 9 - 4 /* two of the seam's twice, and two of the first's that the second covers */);
    /* Along an axis: the front, and nothing of what lies exactly behind it; edges seen end-on are neither. */
    assert_int_equal(draw(90, 0, NULL, sizeof kernel, &in, &out), 0);
    NEAR(in.length, 7);
    NEAR(out.length, 7);
    /* Behind the seam of two faces nothing shows: a wire there. */
    strcat(text, "v 1 5 0.25\nv 1 5 0.75\nv 1 -5 0.25\nv 1 -5 0.75\nl -4 -3\nl -2 -1\n");
    assert_int_equal(build(text), 0);
    assert_int_equal(draw(90, 0, NULL, sizeof kernel, &in, &out), 0);
    NEAR(in.length, 7 + 0.5);
    NEAR(out.length, 7 + 0.5);
}

static void viewer_in_special_places(void **state) {
    (void)state;
    char text[8000];
    sums_t in, out;
    add_box(text, 0, 0, 0, 0, 2, 2, 2, "012345");
    assert_int_equal(build(text), 0);
    /* in the plane of the top, outside: the front face and its edges, the top as a line */
    assert_int_equal(draw(0, 0, (double[]){1, -3, 2}, sizeof kernel, &in, &out), 0);
    NEAR(in.length, 8);
    /* inside: all */
    strcat(text, "v 20 20 20\nv 20 20 21\nl -1 -2\n"); /* so that the box is not the scene's; all hidden */
    assert_int_equal(build(text), 0);
    assert_int_equal(draw(0, 0, (double[]){0.5, 0.25, 1}, sizeof kernel, &in, &out), 0);
    assert_true(in.length > 8);
    /* above the open side of a box: its inner edges */
    add_box(text, 0, 0, 0, 0, 2, 2, 2, "02345");
    assert_int_equal(build(text), 0);
    assert_int_equal(draw(0, 0, NULL, sizeof kernel, &in, &out), 0);
    NEAR(in.length, 16); /* the rim hides nothing: its faces are seen edge-on */
    assert_int_equal(draw(0, 0, (double[]){1, 1, 9}, sizeof kernel, &in, &out), 0);
    NEAR(in.length, 24);
    /* a polygon seen edge-on hides nothing */
    assert_int_equal(build("v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\nv 0 3 -1\nv 0 3 1\nl 5 6\n"), 0);
    assert_int_equal(draw(90, 0, NULL, sizeof kernel, &in, &out), 0);
    NEAR(in.length, 2 + 4); /* its near and its far edge fall together, and neither hides the other */
}

/* Cubes at random, also into each other. */
static void random_boxes(char *text, int n, const int *order, unsigned seed) {
    size_t at = 0;
    for (int k = 0; k < n; k++) {
        srand(seed + (unsigned)order[k]);
        double v[6];
        for (int i = 0; i < 6; i++) v[i] = (i < 3 ? rand() % 4000 : rand() % 800 + 100) / 1000.0;
        at = add_box(text, at, v[0], v[1], v[2], v[3], v[4], v[5], "012345");
    }
}

static int by_value(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

typedef struct list {
    double v[4000];
    size_t n;
} list_t;

/* Where a piece begins and ends, in the world: the same whatever edges are called. */
static int collect(void *ctx, const ink_piece_t *p) {
    list_t *l = ctx;
    const solid_edge_t *e = &solid.edge[p->line];
    const int32_t *a = solid.vertex[e->v[0]].at, *b = solid.vertex[e->v[1]].at;
    double key = 0, t[2] = {(double)p->from, (double)p->to};
    for (int s = 0; s < 2; s++)
        for (int k = 0; k < 3; k++) key += (k + 2.7) * (a[k] + (b[k] - a[k]) * t[s] / (double)INK_ONE);
    assert_true(l->n < 4000);
    l->v[l->n++] = key;
    return 0;
}

static void order_and_memory_do_not_matter(void **state) {
    (void)state;
    enum { N = 24 };
    static char text[N * 600];
    static list_t list[2];
    int order[N], compared = 0;
    for (unsigned seed = 1; seed < 40; seed++) {
        for (int turn = 0; turn < 2; turn++) {
            for (int k = 0; k < N; k++) order[k] = turn ? N - 1 - k : k;
            random_boxes(text, N, order, 1000 * seed);
            assert_int_equal(build(text), 0);
            settings_t set;
            camera_t cam;
            solid_map_t map;
            hidden_stats_t stats;
            view_box_t box = {.solid = true};
            settings_default(&set);
            set.view.from = seed & 1;
            for (int k = 0; k < 3; k++) set.view.eye[k] = num_from_i64(8 - 3 * k);
            memcpy(box.lo, solid.lo, sizeof box.lo);
            memcpy(box.hi, solid.hi, sizeof box.hi);
            assert_int_equal(camera_setup(&cam, &set, &box), 0);
            assert_int_equal(solid_map_setup(&map, &solid, &cam, places), 0);
            list[turn].n = 0;
            const ink_sink_t sink = {&list[turn], collect};
            hidden_job_t job = {.mem = kernel, .bytes = sizeof kernel, .sink = &sink};
            /* the second time with the least memory that does */
            for (size_t bytes = 1024; turn; bytes += 512) {
                job.bytes = bytes;
                list[turn].n = 0;
                int err = convex_draw(&map, NULL, &job, &stats);
                if (!err) break;
                assert_int_equal(err, ERR_FULL);
            }
            if (!turn) assert_int_equal(convex_draw(&map, NULL, &job, &stats), 0);
            qsort(list[turn].v, list[turn].n, sizeof list[turn].v[0], by_value);
        }
        assert_int_equal(list[0].n, list[1].n);
        for (size_t k = 0; k < list[0].n; k++, compared++) assert_true(fabs(list[0].v[k] - list[1].v[k]) < 16);
    }
    print_message("# solids in another order, with the least memory: %d pieces of ink, all the same\n", compared);
}

static void visible_and_hidden_are_the_whole(void **state) {
    (void)state;
    enum { N = 24 };
    static char text[N * 600];
    int order[N];
    for (int k = 0; k < N; k++) order[k] = k;
    for (unsigned seed = 1; seed < 40; seed++) {
        sums_t in, out, all = {0};
        random_boxes(text, N, order, 777 * seed);
        assert_int_equal(build(text), 0);
        assert_int_equal(draw(60, seed * 9, NULL, sizeof kernel, &in, &out), 0);
        for (int32_t e = 0; e < solid.ne; e++)
            if (solid.edge[e].first == e) all.q30 += INK_ONE;
        assert_true(in.q30 + out.q30 == all.q30);
    }
}

static void memory_that_is_too_small_is_an_error(void **state) {
    (void)state;
    char text[4000];
    sums_t in, out;
    add_box(text, 0, 0, 0, 0, 1, 1, 1, "012345");
    assert_int_equal(build(text), 0);
    for (size_t bytes = 0; bytes < 2048; bytes += 8) {
        int err = draw(60, 30, NULL, bytes, &in, &out);
        assert_true(err == 0 || err == ERR_FULL);
        if (!err) NEAR(in.length, 9);
    }
    NEAR(in.length, 9);
}

/* How many cubes a board's memory holds: text typed, data and picture in one block as the console divides it. */
static int most_cubes(size_t bytes) {
    static char text[400000];
    static picture_t picture;
    int most = 0;
    for (int step = 256; step > 0; step /= 2) {
        int n = most + step;
        size_t at = 0;
        for (int k = 0; k < n; k++) at = add_box(text, at, 1.5 * (k % 16), 1.5 * (k / 16), 0, 1, 1, 1, "012345");
        data_pool_t pool = {memory, 0, bytes / 8};
        obj_reader_t r;
        settings_t set;
        plot_item_t item = {.solid = true};
        settings_default(&set);
        obj_reader_start(&r, &pool, NULL, false, 0);
        if (obj_reader_feed(&r, text, at) || obj_reader_finish(&r, &item.mesh)) continue;
        const plot_t plot = {PLOT_SOLIDS, 1, &item, &set};
        picture_hooks_t hooks = {.share = PICTURE_SHARE_HIDING};
        if (picture_try(&picture, &plot, pool.base + pool.low, (pool.high - pool.low) * 8, &hooks) == 0) most = n;
    }
    return most;
}

static void capacity_of_the_boards(void **state) {
    (void)state;
    int m3 = most_cubes(36864 - MOTION_BYTES(128, 32)), pico = most_cubes(212992 - MOTION_BYTES(512, 64));
    print_message("# most cubes, each %d characters of OBJ: Cortex-M3 %d, Pico %d\n", 250, m3, pico);
    assert_true(m3 >= 8 && pico >= 80);
}

static int count_notice;
static void count(void *ctx, int32_t line, const char *text, int32_t len) {
    (void)ctx;
    (void)line;
    (void)text;
    count_notice += len > 0;
}

static void files_of_other_programs(void **state) {
    (void)state;
    assert_int_equal(build("\xef\xbb\xbfv 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nf -3 -2 \\\r\n-1"), 0); /* the mark of UTF-8 */
    assert_int_equal(solid.nv, 3);
    assert_int_equal(build("v 1e12 0 0\nv 1e12 1 0\nv 1e12 1 1\nf 1 2 3"), 0);
    assert_int_equal(solid.nv, 3);
    assert_int_equal(build("v 1e20 0 0\nv 1e20 1 0\nv 1e20 1 1\nf 1 2 3"), ERR_VALUE); /* too far for its size */
    data_pool_t pool = {memory, 0, POOL};
    obj_reader_t r;
    static const char words[] = "face 1\np 1\nvertex 2\nface 3\np 2\nvn 1\n";
    obj_reader_start(&r, &pool, NULL, false, 0);
    r.notice = count;
    assert_int_equal(obj_reader_feed(&r, words, sizeof words - 1), 0);
    assert_int_equal(count_notice, 3); /* each once, though two are none of OBJ's */
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(files_of_other_programs),
        cmocka_unit_test(a_cube_is_one_convex_object),
        cmocka_unit_test(bodies_that_touch_are_two),
        cmocka_unit_test(faces_that_are_there_twice_are_one),
        cmocka_unit_test(fans_of_many_faces),
        cmocka_unit_test(what_fills_a_hole_looks_out),
        cmocka_unit_test(kinds_of_bodies),
        cmocka_unit_test(touching_bodies),
        cmocka_unit_test(viewer_in_special_places),
        cmocka_unit_test(order_and_memory_do_not_matter),
        cmocka_unit_test(visible_and_hidden_are_the_whole),
        cmocka_unit_test(memory_that_is_too_small_is_an_error),
        cmocka_unit_test(capacity_of_the_boards),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
