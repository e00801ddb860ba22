/* Haloed lines: cases worked out by hand. What thousands of frames say is in tests/property/test_halo_random.c. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "error.h"
#include "hidden/halo/halo.h"

#define MM 32768
#define MOST 256

typedef struct ink {
    int n, id[MOST];
    double from[MOST], to[MOST];
} ink_t;

static uint64_t memory[8192];
static halo_t halo;

static int take(void *ctx, int32_t id, uint32_t from, uint32_t to) {
    ink_t *k = ctx;
    if (k->n == MOST) return ERR_FULL;
    k->id[k->n] = id;
    k->from[k->n] = from * 0x1p-30;
    k->to[k->n++] = to * 0x1p-30;
    return 0;
}

static void start(void) {
    halo_init(&halo, memory, sizeof memory);
}

/* In mm on the page; z in units. */
static void line(double x0, double y0, int32_t z0, double x1, double y1, int32_t z1) {
    const halo_point_t p = {(int32_t)lround(x0 * MM), (int32_t)lround(y0 * MM), z0};
    const halo_point_t q = {(int32_t)lround(x1 * MM), (int32_t)lround(y1 * MM), z1};
    assert_int_equal(halo_add(&halo, halo.edges, p, q), 0);
}

static void drawn(ink_t *ink, double width_mm) {
    ink->n = 0;
    assert_int_equal(halo_draw(&halo, (int32_t)lround(width_mm * MM), &(halo_sink_t){ink, take}), 0);
}

/* The pieces of one edge, as fractions. */
static void check(const ink_t *ink, int id, int pieces, ...) {
    va_list list;
    int n = 0;
    va_start(list, pieces);
    for (int k = 0; k < ink->n; k++) {
        if (ink->id[k] != id) continue;
        n++;
        if (n > pieces) break;
        const double from = va_arg(list, double), to = va_arg(list, double);
        if (fabs(ink->from[k] - from) > 1e-5 || fabs(ink->to[k] - to) > 1e-5)
            fail_msg("edge %d: %.9f to %.9f, not %.9f to %.9f", id, ink->from[k], ink->to[k], from, to);
    }
    va_end(list);
    assert_int_equal(n, pieces);
}

static void test_gap(void **state) {
    (void)state;
    ink_t ink;
    start();
    line(0, 0, 10, 100, 0, 10);
    line(50, -10, 1000, 50, 10, 1000);
    line(20, -10, 0, 20, 10, 0);
    assert_int_equal(halo_cut(&halo, 0), 0);
    assert_int_equal(halo.crossings, 2);
    drawn(&ink, 1);
    check(&ink, 0, 2, 0., .49, .51, 1.);
    check(&ink, 1, 1, 0., 1.);
    check(&ink, 2, 2, 0., .45, .55, 1.);
    /* DRAW alone for another width, and none */
    drawn(&ink, 2.5);
    check(&ink, 0, 2, 0., .475, .525, 1.);
    drawn(&ink, 0);
    check(&ink, 0, 1, 0., 1.);
    check(&ink, 2, 1, 0., 1.);
}

/* At 30 degrees the gap is twice as long; at 5.7 degrees it ends W beyond the end of the nearer edge. */
static void test_angle(void **state) {
    (void)state;
    ink_t ink;
    start();
    line(0, 0, 0, 100, 0, 0);
    line(50 - 20 * sqrt(3), -20, 1000, 50 + 20 * sqrt(3), 20, 1000);
    assert_int_equal(halo_cut(&halo, 0), 0);
    drawn(&ink, 1);
    check(&ink, 0, 2, 0., .48, .52, 1.);

    start();
    line(0, 0, 0, 100, 0, 0);
    line(40, -1, 1000, 60, 1, 1000);
    assert_int_equal(halo_cut(&halo, 0), 0);
    drawn(&ink, .5); /* .5 / sin = 5.02: within the nearer edge */
    check(&ink, 0, 2, 0., .5 - .0502493781, .5 + .0502493781, 1.);
    drawn(&ink, 2); /* 20.1 for a strip without end; half of 20.1 plus 2 is 12.05 along the strip, / cos 12.11 */
    check(&ink, 0, 2, 0., .5 - .1211, .5 + .1211, 1.);
}

static void test_overlap(void **state) {
    (void)state;
    ink_t ink;
    start();
    line(0, 0, 0, 100, 0, 0);
    line(50, -10, 1000, 50, 10, 1000);
    line(51, 10, 1000, 51, -10, 1000);
    line(99.5, 5, 500, 99.5, -5, 500);
    assert_int_equal(halo_cut(&halo, 0), 0);
    drawn(&ink, 1);
    check(&ink, 0, 2, 0., .49, .52, .985);
}

/* Where edges meet in space none is cut: a vertex, a beam's end on another, bars in one plane. Where they only seem to
 * meet, the farther one is. */
static void test_contact(void **state) {
    (void)state;
    ink_t ink;
    start();
    line(0, 0, 5000, 50, 50, 1000);
    line(50, 50, 1000, 100, 0, 9000);
    line(25, 25, 3000, 80, 25, 70000);
    line(0, 50, 3000, 50, 0, 3000); /* through (25, 25) as well */
    assert_int_equal(halo_cut(&halo, 0), 0);
    drawn(&ink, 1);
    assert_int_equal(halo.crossings, 1); /* only 1 by 2: at (75, 25) */
    check(&ink, 0, 1, 0., 1.);
    check(&ink, 2, 1, 0., 1.);
    check(&ink, 3, 1, 0., 1.);

    start();
    line(0, 0, 100000, 50, 50, 100000); /* in front, its end over the other's end */
    line(50, 50, 0, 100, 0, 0);
    assert_int_equal(halo_cut(&halo, 0), 0);
    drawn(&ink, 1);
    check(&ink, 0, 1, 0., 1.);
    check(&ink, 1, 1, sqrt(2) / 100, 1.);
}

/* Crossing edges of which each is in front somewhere: what counts is the crossing, to the unit. */
static void test_order(void **state) {
    (void)state;
    ink_t ink;
    start();
    line(0, 0, 0, 100, 0, 100000000);
    line(75, -10, 74999000, 75, 10, 74999000);
    line(25, -10, 25001000, 25, 10, 25001000);
    assert_int_equal(halo_cut(&halo, 0), 0);
    drawn(&ink, 1);
    check(&ink, 0, 2, 0., .24, .26, 1.);
    check(&ink, 1, 2, 0., .45, .55, 1.);
}

static void test_dots_and_parallels(void **state) {
    (void)state;
    ink_t ink;
    start();
    line(0, 0, 0, 100, 0, 0);
    line(30, 0, 500, 30, 0, 90000);   /* seen end-on, in front of it */
    line(20, 0, 70000, 60, 0, 70000); /* on the same line of the page */
    line(0, 1, 1000, 100, 1, 1000);
    assert_int_equal(halo_cut(&halo, 0), 0);
    drawn(&ink, 2);
    for (int k = 0; k < 4; k++) check(&ink, k, 1, 0., 1.);
}

/* With a reach: lines that end just before another, or run beside it, take from it too; a chain does not from itself.
 */
static void test_ends(void **state) {
    (void)state;
    ink_t ink;
    for (int reach = 0; reach < 2; reach++) {
        start();
        line(0, 0, 0, 100, 0, 0);
        line(50, 0.5, 100000, 50, 20, 100000); /* ends half a millimetre before it */
        line(10, -1, 100000, 20, -1, 100000);  /* runs beside it */
        line(80, 9, -50000, 80, .2, -50000);   /* is behind it, and ends close to it */
        assert_int_equal(halo_cut(&halo, reach * 2 * MM), 0);
        drawn(&ink, 2);
        check(&ink, 1, 1, 0., 1.);
        check(&ink, 2, 1, 0., 1.);
        if (reach) {
            check(&ink, 0, 3, 0., .08, .22, .48, .52, 1.);
            check(&ink, 3, 1, 0., 7. / 8.8);
            drawn(&ink, .75); /* any width up to the reach */
            check(&ink, 0, 2, 0., .4925, .5075, 1.);
        } else {
            check(&ink, 0, 1, 0., 1.);
            check(&ink, 3, 1, 0., 1.);
        }
    }
    start(); /* in one plane, z = 40000 y: the end before the other line is no nearer than it */
    line(0, 0, 0, 100, 0, 0);
    line(50, 0.5, 20000, 60, 20, 800000);
    assert_int_equal(halo_cut(&halo, 2 * MM), 0);
    drawn(&ink, 2);
    assert_int_equal(ink.n, 2);
    start();
    for (int k = 0; k < 30; k++) line(k, k * k * .02, 4000 * k, k + 1, (k + 1) * (k + 1) * .02, 4000 * (k + 1));
    assert_int_equal(halo_cut(&halo, 3 * MM), 0);
    drawn(&ink, 3);
    assert_int_equal(ink.n, 30);
}

static void test_limits(void **state) {
    (void)state;
    ink_t ink;
    const halo_point_t ok = {HALO_XY_MAX, -HALO_XY_MAX, HALO_Z_MAX}, far = {HALO_XY_MAX + 1, 0, 0},
                       deep = {0, 0, -HALO_Z_MAX - 1};
    start();
    assert_int_equal(halo_cut(&halo, 0), 0); /* nothing at all */
    drawn(&ink, 1);
    assert_int_equal(ink.n, 0);
    assert_int_equal(halo_add(&halo, 0, ok, ok), 0);
    assert_int_equal(halo_add(&halo, 0, ok, far), ERR_VALUE);
    assert_int_equal(halo_add(&halo, 0, deep, ok), ERR_VALUE);
    halo_init(&halo, memory, 100);
    for (int k = 0; k < 3; k++) assert_int_equal(halo_add(&halo, k, ok, ok), 0);
    assert_int_equal(halo_add(&halo, 3, ok, ok), ERR_FULL);
    assert_int_equal(halo_cut(&halo, 0), ERR_FULL);
    assert_int_equal(halo.crossings, -1);
    /* room for the edges, but not for 10 x 10 crossings: it says how many there are */
    halo_init(&halo, memory, HALO_BYTES(20, 20));
    for (int k = 0; k < 10; k++) line(k, -1, k, k, 11, k), line(-1, k, 1000 + k, 11, k, 1000 + k);
    assert_int_equal(halo_cut(&halo, 0), ERR_FULL);
    assert_int_equal(halo.crossings, 100);
    halo_init(&halo, memory, HALO_BYTES(20, 100));
    for (int k = 0; k < 10; k++) line(k, -1, k, k, 11, k), line(-1, k, 1000 + k, 11, k, 1000 + k);
    assert_int_equal(halo_cut(&halo, 0), 0);
    assert_int_equal(halo.crossings, 100);
    drawn(&ink, .1);
}

/* The sink's error ends DRAW. */
static void test_sink(void **state) {
    (void)state;
    ink_t ink = {.n = MOST - 1};
    start();
    line(0, 0, 0, 100, 0, 0);
    line(50, -10, 1000, 50, 10, 1000);
    assert_int_equal(halo_cut(&halo, 0), 0);
    assert_int_equal(halo_draw(&halo, MM, &(halo_sink_t){&ink, take}), ERR_FULL);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_gap),     cmocka_unit_test(test_angle),  cmocka_unit_test(test_overlap),
        cmocka_unit_test(test_contact), cmocka_unit_test(test_order),  cmocka_unit_test(test_dots_and_parallels),
        cmocka_unit_test(test_ends),    cmocka_unit_test(test_limits), cmocka_unit_test(test_sink),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
