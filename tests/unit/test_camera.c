/* The camera against gnuplot's own pictures and against a camera in floating point. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "error.h"
#include "view/camera.h"

static double to_double(num_t a) {
    return ldexp((double)a.m, a.e);
}

static num_t from_double(double v) {
    return num_from_fixed((int64_t)(v * 1099511627776.0), 40);
}

static settings_t a4(void) {
    settings_t s = {.paper = {.width_um = 297000, .height_um = 210000, .margin_um = 10000}};
    s.view.rot_x = num_from_i64(60);
    s.view.rot_z = num_from_i64(30);
    s.view.scale = s.view.zscale = num_from_i64(1);
    return s;
}

static view_box_t box_of(double x0, double x1, double y0, double y1, double z0, double z1) {
    view_box_t b = {.lo = {from_double(x0), from_double(y0), from_double(z0)},
                    .hi = {from_double(x1), from_double(y1), from_double(z1)}};
    return b;
}

/* gnuplot 5.4 drew known points with `set terminal svg size 800,600`, ranges [-2:2] [-1:3] [0:5] and the base plane
 * half the range below; least squares gave pixels per unit. Its plot box there is 748.4 x 527.98 pixels, ours is the
 * window. */
static void rotation_overlays_gnuplot(void **state) {
    (void)state;
    static const struct {
        int rot_x, rot_z;
        double scale, zscale, x_x, x_y, y_x, y_y, y_z;
    } SEEN[] = {
        {60, 30, 1, 1, 92.59, 53.46, -18.85, 32.66, 34.84},
        {60, 30, 2, 1, 185.19, 106.92, -37.715, 65.32, 69.67},
        {60, 200, 1, 1, -100.47, -36.57, 12.9, -35.44, 34.84},
    };
    settings_t s = a4();
    view_box_t box = box_of(-2, 2, -1, 3, -2.5, 5);
    for (size_t k = 0; k < sizeof SEEN / sizeof SEEN[0]; k++) {
        s.view.rot_x = num_from_i64(SEEN[k].rot_x);
        s.view.rot_z = num_from_i64(SEEN[k].rot_z);
        s.view.scale = from_double(SEEN[k].scale);
        s.view.zscale = from_double(SEEN[k].zscale);
        camera_t cam;
        assert_int_equal(camera_setup(&cam, &s, &box), 0);
        double wx = (cam.window.x1_lat - cam.window.x0_lat) / 748.396,
               wy = (cam.window.y1_lat - cam.window.y0_lat) / 527.975;
        assert_true(fabs(to_double(cam.m[0][0]) / wx - SEEN[k].x_x) < 0.02);
        assert_true(fabs(to_double(cam.m[0][1]) / wx - SEEN[k].x_y) < 0.02);
        assert_true(fabs(to_double(cam.m[0][2]) / wx) < 1e-9);
        assert_true(fabs(to_double(cam.m[1][0]) / wy - SEEN[k].y_x) < 0.02);
        assert_true(fabs(to_double(cam.m[1][1]) / wy - SEEN[k].y_y) < 0.02);
        assert_true(fabs(to_double(cam.m[1][2]) / wy - SEEN[k].y_z) < 0.02);
    }
}

/* Millimetres to the unit: the same along all axes that `set view equal` means, whatever their ranges are. gnuplot
 * leaves zscale out of xyz, and lets z be as high as it comes. */
static void equal_units_are_equal_on_the_page(void **state) {
    (void)state;
    settings_t s = a4();
    view_box_t box = box_of(0, 4, 0, 10, -5, 25);
    camera_t cam;
    s.view.rot_x = num_from_i64(90); /* from the front: x to the right, z up */
    s.view.rot_z = num_from_i64(0);
    s.view.zscale = num_from_decimal(5, -1);
    for (int axes = 2; axes <= 3; axes++) {
        s.view.equal = (uint8_t)axes;
        assert_int_equal(camera_setup(&cam, &s, &box), 0);
        double high = axes == 3 ? 1 : 10.0 / 30 * 0.5;
        assert_true(fabs(to_double(cam.m[1][2]) / to_double(cam.m[0][0]) - high) < 1e-9);
    }
    s.view.rot_x = num_from_i64(0); /* from above */
    assert_int_equal(camera_setup(&cam, &s, &box), 0);
    assert_true(fabs(to_double(cam.m[1][1]) / to_double(cam.m[0][0]) - 1) < 1e-9);
    assert_true(fabs(to_double(cam.m[1][1]) * 10 * 7 / 4 / (cam.window.y1_lat - cam.window.y0_lat) - 1) < 1e-9);
}

/* The middle of the box lands in the middle of the window, and a step towards the eye moves nothing on the page. */
static void rotation_looks_along_the_eye(void **state) {
    (void)state;
    settings_t s = a4();
    for (int deg = 0; deg < 360; deg += 15) {
        s.view.rot_x = num_from_i64(deg);
        s.view.rot_z = num_from_i64(3 * deg % 360);
        view_box_t box = box_of(-2, 7, 100, 103, -1e-3, 1e-3);
        box.reverse[0] = deg % 2;
        camera_t cam;
        assert_int_equal(camera_setup(&cam, &s, &box), 0);
        double p[3] = {2.5, 101.5, 0};
        for (int r = 0; r < 2; r++) {
            double at = to_double(cam.m[r][3]), drift = 0, size = 0;
            for (int k = 0; k < 3; k++) {
                at += to_double(cam.m[r][k]) * p[k];
                drift += to_double(cam.m[r][k]) * to_double(cam.eye[k]);
                size += fabs(to_double(cam.m[r][k]) * to_double(cam.eye[k]));
            }
            double middle =
                r == 0 ? (cam.window.x0_lat + cam.window.x1_lat) / 2.0 : (cam.window.y0_lat + cam.window.y1_lat) / 2.0;
            assert_true(fabs(at - middle) < 1e-3);
            assert_true(fabs(drift) <= 1e-9 * size);
        }
    }
}

/* Anderson's view: all corners inside the window, two sides touched, no perspective distortion lost. */
static void perspective_fits_the_window(void **state) {
    (void)state;
    settings_t s = a4();
    s.view.from = true;
    static const double EYES[][3] = {{6, 8, 3}, {-6, 1, 0.5}, {3e4, 4e4, 1e4}, {0, -9, 0}, {0, 0, 9}, {0, 0, -9}};
    for (size_t e = 0; e < sizeof EYES / sizeof EYES[0]; e++) {
        for (int k = 0; k < 3; k++) s.view.eye[k] = from_double(EYES[e][k]);
        view_box_t box = box_of(-2, 2, -2, 2, 0, 1);
        camera_t cam;
        assert_int_equal(camera_setup(&cam, &s, &box), 0);
        double lo[2] = {1e30, 1e30}, hi[2] = {-1e30, -1e30};
        for (int c = 0; c < 8; c++) {
            double p[3] = {c & 1 ? 2 : -2, c & 2 ? 2 : -2, c & 4 ? 1 : 0}, h[3];
            for (int r = 0; r < 3; r++) {
                h[r] = to_double(cam.m[r][3]);
                for (int k = 0; k < 3; k++) h[r] += to_double(cam.m[r][k]) * p[k];
            }
            double depth = 0, toward = 0; /* E is the depth along the view axis */
            for (int k = 0; k < 3; k++) {
                double axis = (k == 2 ? 0.5 : 0) - EYES[e][k];
                depth += axis * (p[k] - EYES[e][k]);
                toward += axis * axis;
            }
            assert_true(fabs(h[2] - depth / sqrt(toward)) < 1e-6 * fabs(h[2]));
            for (int r = 0; r < 2; r++) {
                lo[r] = fmin(lo[r], h[r] / h[2]);
                hi[r] = fmax(hi[r], h[r] / h[2]);
            }
        }
        double spare_x = fmin(lo[0] - cam.window.x0_lat, cam.window.x1_lat - hi[0]);
        double spare_y = fmin(lo[1] - cam.window.y0_lat, cam.window.y1_lat - hi[1]);
        /* inside by more than rounding, or an edge on the border would be cut off */
        assert_true(spare_x > 3 && spare_y > 3);
        assert_true(fmin(spare_x, spare_y) < 5);
    }
}

static void refuses_what_cannot_be_seen(void **state) {
    (void)state;
    settings_t s = a4();
    view_box_t box = box_of(-1, 1, -1, 1, -1, 1);
    camera_t cam;
    s.paper.margin_um = 105000;
    assert_int_equal(camera_setup(&cam, &s, &box), ERR_VALUE);
    s = a4();
    s.view.zscale = num_from_i64(0);
    assert_int_equal(camera_setup(&cam, &s, &box), ERR_VALUE);
    s = a4();
    s.view.from = true; /* from the middle to the middle */
    assert_int_equal(camera_setup(&cam, &s, &box), ERR_VALUE);
    s.view.eye[0] = num_from_i64(5);
    s.view.has_to = true;
    s.view.to[0] = num_from_i64(9); /* looking away */
    assert_int_equal(camera_setup(&cam, &s, &box), ERR_VALUE);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rotation_overlays_gnuplot),    cmocka_unit_test(equal_units_are_equal_on_the_page),
        cmocka_unit_test(rotation_looks_along_the_eye), cmocka_unit_test(perspective_fits_the_window),
        cmocka_unit_test(refuses_what_cannot_be_seen),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
