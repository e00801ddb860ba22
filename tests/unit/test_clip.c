/* The clipper on cases worked out by hand: contacts of every kind, tags, holes and their outer contours, capacities. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "error.h"
#include "poly/clip.h"

#define MOST 64

typedef struct shape {
    poly_vertex_t v[MOST];
    int32_t end[MOST], outer[MOST];
    clip_out_t out;
    poly_t poly;
} shape_t;

static uint64_t memory[4096];
static clip_t work;

static void clear(shape_t *s) {
    s->out = (clip_out_t){s->v, s->end, s->outer, 0, MOST, 0, MOST};
    s->poly = (poly_t){s->v, s->end, 0};
}

/* Adds a contour of n corners, given as x, y pairs; edges are tagged by their number in the shape. */
static void contour(shape_t *s, int n, const int32_t *xy) {
    for (int k = 0; k < n; k++, s->out.n++) s->v[s->out.n] = (poly_vertex_t){{xy[2 * k], xy[2 * k + 1]}, s->out.n};
    s->end[s->out.contours++] = s->out.n;
    s->poly.contours = s->out.contours;
}

static void box(shape_t *s, int32_t x0, int32_t y0, int32_t x1, int32_t y1) {
    contour(s, 4, (const int32_t[]){x0, y0, x1, y0, x1, y1, x0, y1});
}

static void run(const shape_t *s, const shape_t *c, enum clip_result what, shape_t *to) {
    const clip_job_t job = {s->poly, c->poly, CLIP_EVEN_ODD, {what, CLIP_NOTHING}};
    assert_int_equal(clip_run(&work, &job, memory, sizeof memory), 0);
    clear(to);
    assert_int_equal(clip_trace(&work, 0, &to->out), 0);
    to->poly.contours = to->out.contours;
}

static void expect(const shape_t *s, int contours, int vertices, int64_t area2) {
    assert_int_equal(s->out.contours, contours);
    assert_int_equal(s->out.n, vertices);
    assert_int_equal(poly_area2(&s->poly), area2);
}

static void test_overlap(void **state) {
    (void)state;
    shape_t s, c, r;
    clear(&s), clear(&c);
    box(&s, 0, 0, 10, 10);
    box(&c, 5, 5, 15, 15);
    run(&s, &c, CLIP_INSIDE, &r);
    expect(&r, 1, 4, 50);
    run(&s, &c, CLIP_OUTSIDE, &r);
    expect(&r, 1, 6, 150);
    run(&s, &c, CLIP_UNION, &r);
    expect(&r, 1, 8, 350);
    run(&s, &c, CLIP_XOR, &r);
    expect(&r, 2, 12, 300);
}

static void test_tags(void **state) {
    (void)state;
    shape_t s, c, r;
    clear(&s), clear(&c);
    box(&s, 0, 0, 10, 10);
    box(&c, 5, -5, 15, 15);
    run(&s, &c, CLIP_INSIDE, &r);
    expect(&r, 1, 4, 100);
    /* from (5,0): bottom, right, top, and the cut */
    const int32_t tags[] = {0, 1, 2, POLY_CUT};
    for (int k = 0; k < 4; k++) assert_int_equal(r.v[k].tag, tags[k]);
    /* Where both have an edge the subject's tag counts. */
    clear(&c);
    box(&c, 0, 0, 10, 5);
    run(&s, &c, CLIP_INSIDE, &r);
    const int32_t shared[] = {0, 1, POLY_CUT, 3};
    for (int k = 0; k < 4; k++) assert_int_equal(r.v[k].tag, shared[k]);
}

static void test_tags_of_both(void **state) {
    (void)state;
    shape_t s, c, r;
    clear(&s), clear(&c);
    box(&s, 0, 0, 10, 10);
    box(&c, 5, 5, 15, 15);
    for (int k = 0; k < 4; k++) c.v[k].tag += 10;
    const clip_job_t job = {s.poly, c.poly, CLIP_EVEN_ODD, {CLIP_INSIDE, CLIP_NOTHING}};
    assert_int_equal(clip_run_tagged(&work, &job, memory, sizeof memory), 0);
    clear(&r);
    assert_int_equal(clip_trace(&work, 0, &r.out), 0);
    r.poly.contours = r.out.contours;
    expect(&r, 1, 4, 50);
    int64_t sum = 0;
    for (int32_t k = 0; k < r.out.n; k++) sum += (int64_t)1 << r.v[k].tag;
    assert_int_equal(sum, 1 << 1 | 1 << 2 | 1 << 10 | 1 << 13);
}

static void test_contacts(void **state) {
    (void)state;
    shape_t s, c, r;
    clear(&s), clear(&c);
    box(&s, 0, 0, 10, 10);
    /* the same polygon */
    run(&s, &s, CLIP_INSIDE, &r);
    expect(&r, 1, 4, 200);
    run(&s, &s, CLIP_OUTSIDE, &r);
    expect(&r, 0, 0, 0);
    /* a neighbour that shares a part of an edge */
    box(&c, 10, 2, 20, 30);
    run(&s, &c, CLIP_INSIDE, &r);
    expect(&r, 0, 0, 0);
    run(&s, &c, CLIP_UNION, &r);
    expect(&r, 1, 8, 200 + 560);
    /* one that touches in a corner: two pieces, not one that crosses itself */
    clear(&c);
    box(&c, 10, 10, 20, 20);
    run(&s, &c, CLIP_UNION, &r);
    expect(&r, 2, 8, 400);
    assert_int_equal(r.outer[0], -1);
    assert_int_equal(r.outer[1], -1);
}

static void test_holes(void **state) {
    (void)state;
    shape_t s, c, r;
    clear(&s), clear(&c);
    box(&s, 0, 0, 20, 20);
    box(&s, 5, 5, 15, 15);
    box(&c, 8, 8, 12, 12);
    /* an island in the hole */
    run(&s, &c, CLIP_UNION, &r);
    expect(&r, 3, 12, 800 - 200 + 32);
    const int32_t outer[] = {-1, 0, -1};
    for (int k = 0; k < 3; k++) assert_int_equal(r.outer[k], outer[k]);
    /* a clip polygon inside cuts a hole */
    clear(&s);
    box(&s, 0, 0, 20, 20);
    run(&s, &c, CLIP_OUTSIDE, &r);
    expect(&r, 2, 8, 800 - 32);
    assert_int_equal(r.outer[1], 0);
    /* a hole that touches its outer contour in a vertex is one contour with it */
    clear(&c);
    contour(&c, 3, (const int32_t[]){0, 10, 5, 5, 5, 15});
    run(&s, &c, CLIP_OUTSIDE, &r);
    expect(&r, 1, 8, 800 - 50);
    /* two holes, each with its own outer contour */
    clear(&s), clear(&c);
    box(&s, 0, 0, 10, 10);
    box(&s, 20, 0, 30, 10);
    box(&c, 2, 2, 8, 8);
    box(&c, 22, 2, 28, 8);
    run(&s, &c, CLIP_OUTSIDE, &r);
    expect(&r, 4, 16, 2 * (200 - 72));
    for (int k = 0; k < 4; k++)
        if (r.outer[k] >= 0) assert_int_equal(r.v[r.end[k] - 1].at.x / 20, r.v[r.end[r.outer[k]] - 1].at.x / 20);
}

static void test_rounding(void **state) {
    (void)state;
    shape_t s, c, r;
    clear(&s), clear(&c);
    /* cross at (1 1/3, 2/3): to the nearest, (1, 1) */
    contour(&s, 3, (const int32_t[]){0, 0, 10, 5, 0, 5});
    contour(&c, 3, (const int32_t[]){0, 2, 3, -1, 3, 2});
    run(&s, &c, CLIP_INSIDE, &r);
    bool found = false;
    for (int k = 0; k < r.out.n; k++) found = found || (r.v[k].at.x == 1 && r.v[k].at.y == 1);
    assert_true(found);
}

static void test_nonzero(void **state) {
    (void)state;
    shape_t s, c, r;
    clear(&s), clear(&c), clear(&r);
    box(&s, 0, 0, 10, 10);
    box(&s, 5, 0, 15, 10);
    box(&s, 2, 2, 4, 4);
    const clip_job_t job = {s.poly, c.poly, CLIP_NONZERO, {CLIP_SUBJECT, CLIP_NOTHING}};
    assert_int_equal(clip_run(&work, &job, memory, sizeof memory), 0);
    assert_int_equal(clip_trace(&work, 0, &r.out), 0);
    r.poly.contours = r.out.contours;
    /* the outline of all, its long sides of two tagged edges each */
    assert_int_equal(r.out.contours, 1);
    assert_int_equal(poly_area2(&r.poly), 300);
}

static void test_capacities(void **state) {
    (void)state;
    shape_t s, c, r;
    clear(&s), clear(&c);
    box(&s, 0, 0, 10, 10);
    box(&c, 5, 5, 15, 15);
    const clip_job_t job = {s.poly, c.poly, CLIP_EVEN_ODD, {CLIP_INSIDE, CLIP_OUTSIDE}};
    /* Any amount of memory works or is too little, and CLIP_BYTES works. */
    bool fits = false;
    for (size_t bytes = 0; bytes <= CLIP_BYTES(8); bytes += 8) {
        memset(memory, 0xa5, sizeof memory);
        int err = clip_run(&work, &job, memory, bytes);
        assert_true(err == 0 || (err == ERR_FULL && !fits));
        fits = err == 0;
        for (size_t k = bytes; k < bytes + 64; k++) assert_int_equal(((uint8_t *)memory)[k], 0xa5);
    }
    assert_true(fits);
    clear(&r);
    r.out.n_max = 3;
    assert_int_equal(clip_trace(&work, 0, &r.out), ERR_FULL);
    s.v[2].at.x = POLY_LIMIT + 1;
    assert_int_equal(clip_run(&work, &job, memory, sizeof memory), ERR_VALUE);
}

static void test_limits(void **state) {
    (void)state;
    shape_t s, c, r;
    clear(&s), clear(&c);
    box(&s, -POLY_LIMIT, -POLY_LIMIT, POLY_LIMIT, POLY_LIMIT);
    contour(&c, 4, (const int32_t[]){0, -POLY_LIMIT, POLY_LIMIT, 0, 0, POLY_LIMIT, -POLY_LIMIT, 0});
    run(&s, &c, CLIP_INSIDE, &r);
    expect(&r, 1, 4, INT64_C(4) * POLY_LIMIT * POLY_LIMIT);
    run(&s, &c, CLIP_OUTSIDE, &r);
    expect(&r, 4, 12, INT64_C(4) * POLY_LIMIT * POLY_LIMIT);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_overlap),    cmocka_unit_test(test_tags),     cmocka_unit_test(test_contacts),
        cmocka_unit_test(test_holes),      cmocka_unit_test(test_rounding), cmocka_unit_test(test_nonzero),
        cmocka_unit_test(test_capacities), cmocka_unit_test(test_limits),   cmocka_unit_test(test_tags_of_both),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
